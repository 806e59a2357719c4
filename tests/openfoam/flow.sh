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
hard='materials quartz hastelloy-x'
# A droplet of 350 K flies against a wall at some 100 m/s. What it keeps is v_y, which softening halves; by its viscosity
# it sticks at once, if it is its own temperature that counts (not from 335 K down).
melts='rebound constant 1 1 deposit freeze viscosity critical 1e4 vft -4.5 2000 100'
for words in "300:rebound bons soften 300 0.01 $hard deposit off" "5000:rebound bons soften 5000 0.01 $hard deposit off" "melts:$melts"; do
  name=${words%%:*}
  with reactingParcelFoam/parcelInBox hot.$name "walls { \".*\" \"${words#*:}\"; } ledger 1; fullLedger yes;"
  sed -i 's/U0 .*;/U0 (150 0 0);/' hot.$name/constant/reactingCloud1Properties
  sed -i 's/^endTime .*/endTime 0.002;/' hot.$name/system/controlDict
  mesh hot.$name; foam hot.$name reactingParcelFoam
  rows "$(echo hot.$name/postProcessing/lagrangian/*/asperityWall/__.csv)" | sed -n 1p > first.$name
done
paste -d, first.300 first.5000 | awk -F, '{ ratio = $15 / $59; print "v2 hot and cold: " $15, $59 } END { exit !(ratio > 0.4 && ratio < 0.8) }' || die "softening"
awk -F, '{ print "outcome " $19 " at " $44 " K" } END { exit !($19 == 1 && $44 > 335 && $44 < 360) }' first.melts || die "a hot droplet does not stick: $(cat first.melts)"

# The mixer, 40 steps, without collisions.
with icoUncoupledKinematicParcelDyMFoam/mixerVesselAMI2D mixer 'walls { ".*" "rebound constant 0.97 0.91"; }'
sed -i 's/^endTime .*/endTime 8e-4;/; s/^writeInterval .*/writeInterval 8e-4;/' mixer/system/controlDict
sed -i 's/collisionModel .*/collisionModel none;/' mixer/constant/kinematicCloudProperties
(cd mixer && m4 system/blockMeshDict.m4 > system/blockMeshDict)
mesh mixer; foam mixer icoUncoupledKinematicParcelDyMFoam
grep -q 'Parcel fate: patch rotor' mixer/log.ico* || die "no sums of the mixer's walls"
