#!/usr/bin/env bash
# What is wrong in a dictionary ends the run at its beginning, and the message names the entry.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/case.sh"
box case ''
mesh case
refuses() { # COEFFS, then what the message has
  local coeffs=$1; shift
  box case "$coeffs"
  ! (cd case && icoUncoupledKinematicParcelFoam > log 2>&1) || die "'$coeffs' was taken"
  for word; do
    sed -n '/FATAL/,$p' case/log | grep -qF -- "$word" || { cat case/log; die "the message on '$coeffs' has no '$word'"; }
  done
}
smooth='rebound constant 1 1'
refuses "" walls
refuses "walls { floor \"$smooth\"; }" "no entry for 'roof'"
refuses "walls { \".*\" \"$smooth\"; flor \"$smooth\"; }" "entry flor" "no patch of type wall"
refuses "walls { \".*\" \"$smooth\"; floor rebound; }" "entry floor" "string"
refuses "walls { \".*\" { e 1; } }" 'entry .*:' "string"
refuses 'walls { ".*" "rebound constnat 1 1"; }' 'entry .*:' "constnat" "constant"
refuses 'walls { ".*" "surface rq 5um lambda_c 40um rebound walton 0.9 0.3 0 friction 1"; }' 'entry .*:' "no effect"
refuses 'walls { ".*" ""; }' "materials needs two names" "got 0"
refuses 'walls { ".*" "materials hastelloy-x quartz"; }' "yield_stress"
refuses "walls { \".*\" \"surface profile $here/../data/none.csv $smooth\"; }" "dMin" "dMax"
refuses "walls { \".*\" \"surface profile none.csv $smooth\"; } dMin 1e-5; dMax 1e-5;" "none.csv"
refuses "walls { \".*\" \"surface rq 5um lambda_c 40um 80um lay axial $smooth\"; }" "lay" "vector"
refuses 'walls { ".*" "materials quartz hastelloy-x deposit delete remove gas_density 1 gas_viscosity 1"; }' 'entry .*:' "no effect"
refuses 'walls { ".*" "rebound constant 1 1 erosion dnv"; }' 'entry .*:' "density"
refuses "walls { \".*\" \"$smooth\"; } ledger often;" "ledger"
refuses "walls { \".*\" \"$smooth\"; } ledgr 100;" "'ledgr'" "ledger"
refuses "walls { \".*\" \"$smooth\"; } UrMax 1e-4;" "'UrMax' has no effect"
refuses "walls { \".*\" \"materials quartz hastelloy-x ledger 100 file x\"; }" "material 'ledger' is unknown"
refuses "walls { \".*\" \"$smooth\"; } ledger 1; fullLedger perhaps;" "fullLedger"

# With collisions parcels turn at their radius, before the center that hits.
box collide "walls { \".*\" \"$smooth\"; }"
sed -i 's/collisionModel none/collisionModel pairCollision/' collide/constant/kinematicCloudProperties
mesh collide
! (cd collide && icoUncoupledKinematicParcelFoam > log 2>&1) || die "a wall that collisions keep parcels from was taken"
grep -q "collisionModel is 'pairCollision'.* it must be none" collide/log || die "no word of collisionModel"

# The Foundation's OpenFOAM of another version.
mkdir -p foundation/src/lagrangian/parcel foundation/etc
echo 'export WM_PROJECT_VERSION=10' > foundation/etc/bashrc
! "$here/../../cmake/openfoam_headers" headers foundation 2> said || die "a tree of the Foundation's 10 was taken"
grep -q "OpenFOAM 10 of the Foundation, whose version must be 13" said || die "no word of the Foundation: $(cat said)"

# Two dimensions.
box flat "walls { \".*\" \"surface rq 5um lambda_c 40um $smooth\"; }" "sides={ type empty; faces ((0 4 7 3) (2 6 5 1)); } ends { type wall; faces ((1 5 4 0) (3 7 6 2)); }" cells='1 4 4' speed='0 0.3 -0.7'
sed -i 's/".\*" { type noSlip; }/sides { type empty; } &/' flat/0/U
mesh flat
! (cd flat && icoUncoupledKinematicParcelFoam > log 2>&1) || die "a wall that tilts out of the plane was taken"
grep -q "two dimensions" flat/log || die "no word of two dimensions"
sed -i 's/lambda_c 40um/& spread visible plane/' flat/constant/kinematicCloudProperties
run flat

# A wedge has three dimensions to solve in, of which two are of the geometry.
tilts="surface rq 5um lambda_c 40um $smooth"
box wedge "walls { \".*\" \"$tilts\"; }" speed='1 0.4 0' end=0.5
object dictionary blockMeshDict << 'END' > wedge/system/blockMeshDict
vertices ((0 0 0) (1 0 0) (1 0.5 0.02182) (0 0.5 0.02182) (1 0.5 -0.02182) (0 0.5 -0.02182));
blocks (hex (0 1 4 5 0 1 2 3) (4 4 1) simpleGrading (1 1 1));
boundary (pipe { type wall; faces ((3 2 4 5)); } front { type wedge; faces ((0 1 2 3)); } back { type wedge; faces ((0 5 4 1)); }
  ends { type wall; faces ((0 3 5 0) (1 4 2 1)); } axis { type empty; faces ((0 1 1 0)); });
END
object volVectorField U <<< 'dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);
boundaryField { "(pipe|ends)" { type noSlip; } "(front|back)" { type wedge; } axis { type empty; } }' > wedge/0/U
object vectorField parcels < <(awk 'BEGIN { srand(1); print "("; for (i = 0; i < 20; i++) printf "(%.6f %.6f 0)\n", 0.1 + 0.8 * rand(), 0.35 + 0.1 * rand(); print ")" }') > wedge/constant/parcels
mesh wedge
! (cd wedge && icoUncoupledKinematicParcelFoam > log 2>&1) || die "a wall that tilts out of a wedge was taken"
grep -q "two dimensions" wedge/log || die "no word of two dimensions in a wedge"
sed -i 's/lambda_c 40um/& spread visible plane/' wedge/constant/kinematicCloudProperties
run wedge

# What looks like a mistake is said, without the diameters of the parcels.
box doubt 'walls { ".*" "surface rq 5 lambda_c 40 materials quartz hastelloy-x erosion oka 1.8"; }'
mesh doubt
run doubt
for doubt in "rq is 5, which is 5 m" "hardness is 1.8, which is 1.8 Pa"; do
  grep -qF "warning: $doubt" doubt/log.icoUncoupledKinematicParcelFoam || die "no '$doubt'"
done
# Doubts about parcels are said when these are there, once: grains that stick, and such as are large for the mesh.
log=log.icoUncoupledKinematicParcelFoam
for d in 2e-3 0.2; do
  box sizes$d 'walls { ".*" "materials quartz hastelloy-x"; }'
  sed -i "s/value 1e-5/value $d/" sizes$d/constant/kinematicCloudProperties
  mesh sizes$d
  run sizes$d
  [ "$(grep -c "the adhesion of 'bons' is for particles of 0.5 to 200 um" sizes$d/$log)" = 1 ] || die "$d: no doubt, or more than one, of the law's sizes"
  large=$(grep -c "parcels of ${d/2e-3/0.002} m in diameter, and the mesh is 1 m across" sizes$d/$log) || true
  case $d in 0.2) [ "$large" = 1 ] ;; *) [ "$large" = 0 ] ;; esac || die "$d: $large warnings of parcels large for the mesh"
done
! grep -q 'asperityWall warning\|warning: the adhesion' doubt/$log || die "a doubt about parcels of 10 um"
