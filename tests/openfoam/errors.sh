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
refuses 'walls { ".*" ""; }' "materials has 0 names" "two"
refuses 'walls { ".*" "materials hastelloy-x quartz"; }' "yield_stress"
refuses "walls { \".*\" \"surface profile $here/../data/none.csv $smooth\"; }" "dMin" "dMax"
refuses "walls { \".*\" \"surface profile none.csv $smooth\"; } dMin 1e-5; dMax 1e-5;" "none.csv"
refuses "walls { \".*\" \"surface rq 5um lambda_c 40um 80um lay axial $smooth\"; }" "lay" "vector"
refuses 'walls { ".*" "materials quartz hastelloy-x deposit delete remove gas_density 1 gas_viscosity 1"; }' 'entry .*:' "no effect"
refuses 'walls { ".*" "rebound constant 1 1 erosion dnv"; }' 'entry .*:' "density"
refuses "walls { \".*\" \"$smooth\"; } ledger often;" "ledger"
refuses "walls { \".*\" \"$smooth\"; } ledgr 100;" "'ledgr'" "ledger"
refuses "walls { \".*\" \"materials quartz hastelloy-x ledger 100 file x\"; }" "material 'ledger' is unknown"
refuses "walls { \".*\" \"$smooth\"; } ledger 1; fullLedger perhaps;" "fullLedger"

# Two dimensions.
box flat "walls { \".*\" \"surface rq 5um lambda_c 40um $smooth\"; }" "sides={ type empty; faces ((0 4 7 3) (2 6 5 1)); } ends { type wall; faces ((1 5 4 0) (3 7 6 2)); }" cells='1 4 4' speed='0 0.3 -0.7'
sed -i 's/".\*" { type noSlip; }/sides { type empty; } &/' flat/0/U
mesh flat
! (cd flat && icoUncoupledKinematicParcelFoam > log 2>&1) || die "a wall that tilts out of the plane was taken"
grep -q "two dimensions" flat/log || die "no word of two dimensions"
sed -i 's/lambda_c 40um/& spread visible plane/' flat/constant/kinematicCloudProperties
run flat

# What looks like a mistake is said, without the diameters of the parcels.
box doubt 'walls { ".*" "surface rq 5 lambda_c 40 materials quartz hastelloy-x erosion oka 1.8"; }'
mesh doubt
run doubt
for doubt in "rq is 5, which is 5 m" "hardness is 1.8, which is 1.8 Pa"; do
  grep -qF "warning: $doubt" doubt/log.icoUncoupledKinematicParcelFoam || die "no '$doubt'"
done
