#!/usr/bin/env bash
# What the case says of gas and parcels: the friction velocity at each face, the temperature of the parcels; and two of
# OpenFOAM's tutorials with our model in place of theirs, one of them in two dimensions with moving walls.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/case.sh"
tutorials=/usr/share/doc/openfoam-examples/examples/lagrangian
[ -d "$tutorials" ] || die "no tutorials; Debian: apt-get install openfoam-examples"

# A gas at 200 m/s, 1/8 m off walls with a viscosity of 0 and of 0.01 m2/s: u_tau is 0.1 and 4 m/s. What sticks to the
# floor stays there, and most of what sticks to the roof leaves it, after a restart, too.
grains='materials quartz hastelloy-x surface_energy 0.4 deposit freeze remove gas_density 1.2 gas_viscosity 1.5e-5'
for side in floor roof; do
  box flow "walls { \".*\" \"$grains\"; sides \"rebound constant 1 1\"; }" speed="0.01 0.3 $([ $side = roof ] || echo -)0.7" end=3 write=30
  sed -i 's/laminar/RAS; RAS { RASModel kEpsilon; turbulence on; printCoeffs off; }/' flow/constant/turbulenceProperties
  sed -i 's/internalField uniform (0 0 0)/internalField uniform (200 0 0)/' flow/0/U
  for field in 'nut 2 -1' 'k 2 -2' 'epsilon 2 -3'; do
    read -r name m s <<< "$field"
    object volScalarField "$name" <<< "dimensions [0 $m $s 0 0 0 0]; internalField uniform 1;
boundaryField { \".*\" { type calculated; value uniform 0; } roof { type calculated; value uniform 0.01; } }" > "flow/0/$name"
  done
  mesh flow; run flow
  read -r stick mass < <(numbers flow stick $side); read -r removed gone < <(numbers flow removed $side)
  [ "$stick" = 50 ] && [ "$removed" -le $([ $side = roof ] && echo 50 || echo 0) ] && [ "$removed" -ge $([ $side = roof ] && echo 30 || echo 0) ] ||
    die "$side: $removed of $stick are removed"
  awk -v is="$(sum_of flow/3/kinematicCloud:depositedMass)" -v want="$mass" -v gone="$gone" 'BEGIN { d = is - (want - gone); exit !(d * d < 1e-10 * want * want) }' ||
    die "$side: the deposited mass is not what stuck less what left"
  rm -r flow/3; run flow
  [ "$(numbers flow removed $side)" = "$removed $gone" ] || die "$side: a restart removes $(numbers flow removed $side), not $removed $gone"
  rm -r flow
done
# with TUTORIAL DIR COEFFS: our model in a tutorial.
with() {
  cp -rL "$tutorials/$1" "$2"
  find "$2" -name '*.gz' -exec gunzip {} +
  shift
  sed -i "s|libs .*||; 0,/^application/s||libs (\"$bin/libasperityWall.so\"); application|" "$1/system/controlDict"
  sed -i "s|patchInteractionModel .*|patchInteractionModel asperityWall; asperityWallCoeffs { $2 }|" "$1"/constant/*Cloud*Properties
}
# A droplet of 350 K flies against a wall at some 100 m/s. What it keeps is v_y, which softening halves.
for from in 300 5000; do
  with reactingParcelFoam/parcelInBox hot.$from "walls { \".*\" \"rebound bons soften $from 0.01 materials quartz hastelloy-x deposit off\"; } ledger 1;"
  sed -i 's/U0 .*;/U0 (150 0 0);/' hot.$from/constant/reactingCloud1Properties
  sed -i 's/^endTime .*/endTime 0.002;/' hot.$from/system/controlDict
  mesh hot.$from; foam hot.$from reactingParcelFoam
  rows "$(echo hot.$from/postProcessing/lagrangian/*/asperityWall/__.csv)" | sed -n 1p > first.$from
done
paste -d, first.300 first.5000 | awk -F, '{ ratio = $15 / $34; print "v2 hot and cold: " $15, $34 } END { exit !(ratio > 0.4 && ratio < 0.8) }' || die "softening"

# The mixer, 40 steps, without collisions.
with icoUncoupledKinematicParcelDyMFoam/mixerVesselAMI2D mixer 'walls { ".*" "rebound constant 0.97 0.91"; }'
sed -i 's/^endTime .*/endTime 8e-4;/; s/^writeInterval .*/writeInterval 8e-4;/' mixer/system/controlDict
sed -i 's/collisionModel .*/collisionModel none;/' mixer/constant/kinematicCloudProperties
(cd mixer && m4 system/blockMeshDict.m4 > system/blockMeshDict)
mesh mixer; foam mixer icoUncoupledKinematicParcelDyMFoam
grep -q 'Parcel fate: patch rotor' mixer/log.ico* || die "no sums of the mixer's walls"
