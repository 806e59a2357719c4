#!/usr/bin/env bash
# Parcels that are known before the ranks part keep who they are: the same impacts, with the same draws, on 1, 2 and 4
# ranks, and where a run stops and goes on, on another number of them. The last digits of OpenFOAM's places differ.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/case.sh"
walls='walls { ".*" "surface rq 5um lambda_c 40um rebound constant 1 1"; floor "materials quartz hastelloy-x surface sigma 5deg"; }'
box start "$walls ledger 7;" parcels=300 end=0.05 write=1
mesh start
run start
go() { # DIR END RANKS: goes on
  sed -i "s/endTime [0-9.]*;/endTime $2;/; s/writeInterval [0-9]*;/writeInterval 20;/" "$1/system/controlDict"
  [ "$3" = 1 ] || object dictionary decomposeParDict <<< "numberOfSubdomains $3; method simple; simpleCoeffs { n ($3 1 1); delta 0.001; }" > "$1/system/decomposeParDict"
  [ "$3" = 1 ] || (cd "$1" && decomposePar -latestTime -force > log.decomposePar 2>&1) || die "decomposePar $1"
  run "$1" "$3"
}
for ranks in 1 2 4; do cp -r start whole.$ranks; go whole.$ranks 3 $ranks; done
[ "$(count_rows "$(ledger whole.1 __)")" -gt 300 ] || die "too few impacts for this test"
cp -r start parted
go parted 1 1
echo "a row that no file counts" >> "$(ledger parted floor)"
go parted 3 2
for other in whole.2 whole.4 parted; do
  for entry in __ floor; do
    near "$(ledger whole.1 $entry)" "$(ledger $other $entry)" "1 2 4 14 19" 0
    near "$(ledger whole.1 $entry)" "$(ledger $other $entry)" "3 6 7 8 10 11 12 13 15" 1e-7
  done
  for patch in floor roof sides; do
    [ "$(numbers whole.1 rebound $patch | cut -c 1-10)" = "$(numbers $other rebound $patch | cut -c 1-10)" ] || die "rebounds on $patch: $other"
    [ "$(numbers whole.1 stick $patch | cut -c 1-10)" = "$(numbers $other stick $patch | cut -c 1-10)" ] || die "deposits on $patch: $other"
  done
done
for dir in whole.1 whole.2 parted; do
  [ $dir = whole.1 ] || (cd $dir && reconstructPar -latestTime -noLagrangian > log.reconstructPar 2>&1) || die "reconstructPar $dir"
  for field in impacts depositedMass energy; do
    near <(sum_of "whole.1/3/kinematicCloud:$field") <(sum_of "$dir/3/kinematicCloud:$field") 1 1e-9
  done
done
