#!/usr/bin/env bash
# What an impact is and what it leaves: rows of the ledger as the core makes them of their keys, the same motion as OpenFOAM's
# own model, sums in the log and on the patches, parcels that stand for many, deposits, walls that move, cyclic patches.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/case.sh"
rough='surface rq 5um lambda_c 40um'

# Rows of all impacts, on walls of many kinds. OpenFOAM traps floating-point exceptions: no wall may raise one.
grains='materials quartz hastelloy-x'
"$bin/asperity" surface surface rq 5um lambda_c 40um seed 3 --points 16384 --dp 10um --save measured.csv -o /dev/null
while IFS=';' read -r floor roof sides; do
  rm -rf keys
  box keys "walls { floor \"$floor\"; roof \"$roof\"; sides \"$sides\"; } dMin 1e-6; dMax 1e-4; ledger 100; fullLedger yes;" parcels=1000 speed="30 9 -21" dt=0.002 end=0.1
  mesh keys; run keys
  for entry in floor roof sides; do
    rows=$("$bin/../tests/openfoam_rows" "$(ledger keys $entry)" "kinematicCloud:$entry" 1e-5 2650) || die "rows of $floor; $roof; $sides: $entry: $rows"
    [ "$rows" -gt 100 ] || die "only $rows impacts on $entry of $floor; $roof; $sides"
  done
done << END
$rough $grains seed 7;rebound constant 1 1;surface sigma 8deg spread weibull plane collisions single rebound walton 0.9 0.3 0.4 erosion dnv density 8000kg/m3
$rough spread normal $grains deposit off erosion finnie 1GPa;$rough spread rejection collisions single rebound thornton_ning $grains;$rough spread effective rebound grant_tabakoff
$rough spread truncated collisions single rebound constant 0.8 0.9;$rough spread rejection rebound walton 0.9 0.3 0;$rough 80um lay 1 0 0 rebound constant 0.8 0.9 erosion oka 3GPa density 8000kg/m3 face tilted
surface profile $PWD/measured.csv dp_bins 2 rebound constant 0.9 0.8;$rough spread profile rebound constant 1 0.9;surface sigma 5deg rebound constant 0.9 0.9
END

# Hot parcels without adhesion stick by their viscosity: min(1, 10^(8.5 - 9000/950)) of the first impacts at 1450 K.
box hot 'walls { ".*" "rebound constant 1 1 temperature 1450 deposit freeze viscosity critical 1e4 vft -4.5 9000 500 seed 3"; } ledger 100; fullLedger yes;' parcels=2000 end=0.5
mesh hot; run hot
table a="$(ledger hot __)" "
p, first = 10 ** (8.5 - 9000 / 950), {}
for r in a:
    first.setdefault(r.tag, r)
stuck = sum(r.outcome == 1 for r in first.values())
print(stuck, 'of', len(first), 'stick;', p * len(first))
assert len(first) > 500 and all(r.temperature == 1450 for r in a)
assert abs(stuck - p * len(first)) < 4 * (len(first) * p * (1 - p)) ** 0.5" || die "the share of hot parcels that sticks"

# OpenFOAM's own model, with the same coefficients.
box theirs "type rebound; e 0.8; mu 0.1;" model=standardWallInteraction end=2 write=40
box ours 'walls { ".*" "rebound constant 0.8 0.9"; }' end=2 write=40
for dir in theirs ours; do mesh $dir; run $dir; done
for field in U coordinates; do
  for dir in theirs ours; do sed -n '/^(/p' "$dir/2/lagrangian/kinematicCloud/$field" | tr -d '()' | tr ' ' ',' > $dir.$field; done
  near theirs.$field ours.$field "1 2 3" 1e-9
done

# A parcel stands for 3 particles. What sticks leaves the cloud, or stays; walls are worn.
for deposit in freeze delete; do
  box $deposit "walls { \".*\" \"rebound constant 1 0.9\"; floor \"$rough materials quartz hastelloy-x surface_energy 4 deposit $deposit erosion finnie 1GPa\"; } ledger 20; fullLedger yes; writeToFile yes; writePrecision 8; useUserTime yes;" number=3 end=0.02 dt=0.0005 parcels=400 speed="100 30 -70"
  mesh $deposit; run $deposit
done
same <(rows "$(ledger freeze __)") <(rows "$(ledger delete __)") "deposits"
[ "$(awk '/Current number of parcels/ { n = $NF } END { print n }' freeze/log.ico*)" = 400 ] || die "frozen parcels are gone"
left=$(awk '/Current number of parcels/ { n = $NF } END { print n }' delete/log.ico*)
read -r rebounds mass < <(numbers delete rebound floor)
read -r stuck stuck_mass < <(numbers delete stick floor)
[ $((left + stuck)) = 400 ] && [ "$stuck" -gt 50 ] && [ "$rebounds" -gt 20 ] || die "$left parcels are left, $stuck stuck, $rebounds rebounded"
# OpenFOAM's file of fates, which writeToFile makes, has the log's last numbers in named columns.
fates=delete/postProcessing/lagrangian/kinematicCloud/patchInteractionModel/0/asperityWall.dat
awk '/^# Time/ { for (k = 2; k <= NF; k++) if ($k ~ /^floor_(n|mass)(Rebound|Stick)$/) at[++n] = k - 1 }
  END { for (k = 1; k <= n; k++) print $at[k] }' $fates > of_fates
near of_fates <(printf '%s\n' "$rebounds" "$mass" "$stuck" "$stuck_mass") 1 1e-7
rows "$(ledger delete floor)" | awk -F, '{ n += 3; m += $20; if ($19 == 2) s += $20; e += $20 * ($24^2 + $25^2 + $26^2) / 2; w += $39 }
  END { printf "%.12g\n%.12g\n%.12g\n%.12g\n%.12g\n", n, m, s, e, w }' > of_rows
{ sum_of delete/0.02/kinematicCloud:impacts
  awk "BEGIN { printf \"%.12g\n\", $mass + $stuck_mass }"; sum_of delete/0.02/kinematicCloud:depositedMass
  awk -v e="$(sum_of delete/0.02/kinematicCloud:energy)" 'BEGIN { print e }'
  awk '/eroded from/ { m[++n] = $NF } END { print m[n - 2] }' delete/log.ico*; } > of_fields
rows "$(ledger delete __)" | awk -F, '{ n += 3; e += $20 * ($24^2 + $25^2 + $26^2) / 2 } END { printf "%.12g %.12g\n", n, e }' > of_others
awk 'NR == FNR { n = $1; e = $2; next } FNR == 1 { $1 += n } FNR == 4 { $1 += e } { printf "%.12g\n", $1 }' of_others of_rows > all_rows
near all_rows of_fields 1 1e-5
depth=$(sum_of delete/0.02/kinematicCloud:erodedDepth) # 16 faces of 1/16 m2, 8220 kg/m3
awk -v d="$depth" -v m="$(sed -n 5p of_rows)" -v rho="$("$bin/asperity" materials | awk -F, '$1 == "hastelloy-x" { print $5 }')" 'BEGIN { exit !(d > 0 && (d * rho / 16 / m - 1) ^ 2 < 1e-10) }' || die "eroded depth $depth"

# A wall that slides (a boundary condition), and one that moves with the mesh.
box slides 'walls { ".*" "rebound constant 1 1"; floor "rebound constant 0.5 0.5"; } ledger 1; fullLedger yes;' speed='1 0 -1' end=1.5
sed -i 's/".\*" { type noSlip; }/& floor { type fixedValue; value uniform (1 0 0); }/' slides/0/U
mesh slides; run slides
check_rows "$(ledger slides floor)" 'abs(r.v1x) < 1e-10 or r.v1x < -1' "a sliding wall"
rows "$(ledger slides floor)" | awk -F, '$24^2 < 1e-20 && ($29 - 0.5)^2 > 1e-20 { exit 1 }' || die "the rebound from a sliding wall"
box moves 'walls { ".*" "rebound constant 1 1"; } ledger 1; fullLedger yes;' end=0.3 dt=0.01
object dictionary dynamicMeshDict << 'END' > moves/constant/dynamicMeshDict
dynamicFvMesh dynamicMotionSolverFvMesh; motionSolver solidBody; motionSolverLibs ("libfvMotionSolvers.so");
solidBodyMotionFunction linearMotion; velocity (0 0 0.5);
END
sed -i 's/noSlip/movingWallVelocity; value uniform (0 0 0)/' moves/0/U
mesh moves; foam moves icoUncoupledKinematicParcelDyMFoam
check_rows "$(ledger moves __)" 'r.mesh != 1 or abs(r.v1z + 1.2) < 1e-6' "a wall that moves with the mesh"
rows "$(ledger moves __)" | awk -F, '$4 == 1 { n++ } END { exit !n }' || die "nothing hit the floor that moves"

# Through cyclic patches. OpenFOAM moves a parcel twice in the step of its injection: 10.1 s in all.
sides='{ type empty; faces (); } left { type cyclic; neighbourPatch right; faces ((0 4 7 3)); }
 right { type cyclic; neighbourPatch left; faces ((2 6 5 1)); } front { type cyclic; neighbourPatch back; faces ((1 5 4 0)); }
 back { type cyclic; neighbourPatch front; faces ((3 7 6 2)); }'
box cyclic 'walls { ".*" "rebound constant 1 1"; }' sides="$sides" end=10 dt=0.1 write=100 parcels=100
sed -i 's/ sides { type empty; faces (); }//' cyclic/system/blockMeshDict
sed -i 's/".\*" { type noSlip; }/"left|right|front|back" { type cyclic; } "floor|roof" { type noSlip; }/' cyclic/0/U
mesh cyclic; run cyclic
read -r floor _ < <(numbers cyclic rebound floor); read -r roof _ < <(numbers cyclic rebound roof)
expected=$(awk '/^\([0-9]/ { sub(")", ""); n += int(7.07 - $3) + 1 } END { print n }' cyclic/constant/parcels)
[ $((floor + roof)) = "$expected" ] || die "$floor and $roof impacts between cyclic patches, not $expected"
