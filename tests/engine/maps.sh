#!/usr/bin/env bash
# Per triangle: impacts, deposited mass, impact energy and eroded mass in `dump mesh/vtk` are those of the ledger, on 1,
# 2 and 4 ranks, with triangles that lie across ranks, and after a restart; per mesh in the global array. The command
# `erosion` gets the same mass from the ledger's column, and by the law from its other columns.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
grains 400 > grains.data
plate 15 1 3.9e-3 > low.stl
sed 's/vertex \(.*\) 0$/vertex \1 -2e-4/' low.stl > lower.stl
walls='fix low all mesh/surface file low.stl type 2
fix lower all mesh/surface file lower.stl type 2
fix wall all wall/rebound mesh n_meshes 2 meshes lower low surface rq 10e-6 lambda_c 90e-6 seed 4 erosion dnv density 7800 ledger 100 file ${out} columns full
fix move all nve/sphere
timestep 1e-8
dump low all mesh/vtk 400 low.vtk output face low id impacts deposited_mass impact_energy eroded_mass erosion_depth
dump lower all mesh/vtk 400 lower.vtk output face lower id impacts
thermo_style custom step f_wall[1][1] f_wall[2][1] f_wall[2][2] f_wall[2][3] f_wall[2][4] f_wall[1] f_wall[3] f_wall[14]
thermo_modify format float %.12g
thermo 400'
script() { { head_of si; echo "$1
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all"; materials; echo "$walls
$2"; }; }
script 'read_data grains.data' 'run 170
write_restart half.restart
run 230' > whole.in
script 'read_restart half.restart' 'run 230' > rest.in

# The cells' values, a row each: id, then the properties in the dump's order.
cells() {
  awk 'NF == 4 && $2 == 1 && $4 ~ /^[a-z]/ { name = $1; row = 0; next } name { for (i = 1; i <= NF; i++) value[name, ++row] = $i }
    END { for (r = 1; r <= row; r++) print value["meshid", r] + 0, value["impacts", r] + 0, value["deposited_mass", r] + 0, value["impact_energy", r] + 0, value["eroded_mass", r] + 0, value["erosion_depth", r] + 0 }' "$1" | sort -n
}
erosion() { "$bin/asperity" erosion "$@" > eroded.csv || die "erosion $*"; rows eroded.csv; }
check() { # ledger, what
  rows "$1" | awk -F, '$4 == 2 { m = 2650 * 3.14159265358979 / 6 * $9 ^ 3; n[$5]++; e[$5] += 0.5 * m * $10 ^ 2; if ($19 == 1) d[$5] += m }
    END { for (t in n) print t, n[t], d[t] + 0, e[t] }' | sort -n > sums
  erosion "$1" | awk -F, '$1 == 2 && $2 != "all" { print $4, $4 / 7800 / (0.5 * (5.8e-3 / 15) ^ 2) }' | paste -d' ' sums - > expected
  cells low.vtk | awk '$2 > 0' > found
  [ "$(wc -l < found)" -gt 30 ] || die "$2: only $(wc -l < found) triangles were hit"
  paste -d' ' expected found | awk 'NF != 12 { bad = 1 } { for (i = 1; i <= 6; i++) { d = $i - $(i + 6); if (d < 0) d = -d; if (d > 2e-5 * ($i < 0 ? -$i : $i)) { print; bad = 1 } } } END { exit bad }' ||
    { head -3 expected found; die "$2: the map and the ledger differ"; }
  cells lower.vtk | awk '$2 > 0 { bad = 1 } END { exit bad || !NR }' || die "$2: a wall that nothing reached has impacts"
}
for ranks in 1 2 4; do engine $ranks whole.in -var out $ranks.csv; check $ranks.csv "$ranks ranks"; done
# Totals: mesh 1 nothing; mesh 2 everything, as vector and ledger have it.
grep -E '^ +400 ' whole.in.screen | tail -n 1 | awk '{ exit !($2 == 0 && $3 == $7 && $4 > 0 && $5 == $8 && $6 > 0) }' || die "the array of totals: $(grep -E '^ +400 ' whole.in.screen)"
totals=$(grep -E '^ +400 ' whole.in.screen | tail -n 1)
# What is worn off, by the fix and by the command: of its column, of the law, and of a ledger without the mass.
grep -v '^#' 1.csv | cut -d, -f1-19 > default.csv
for of in 1.csv "1.csv erosion dnv density 7800" "default.csv erosion dnv density 7800 --density 2650" "default.csv erosion dnv density 7800 materials ard steel"; do
  erosion $of | tail -n 1 | paste -d, - <(awk '{ print $9 }' <<< "$totals") | awk -F, '{ exit !($2 == "all" && $4 > 0 && ($4 / $5 - 1) ^ 2 < 1e-10) }' ||
    die "erosion $of: $(tail -n 1 eroded.csv), by the fix $totals"
done
sed -i '$d' whole.in
engine 2 whole.in -var out part.csv
engine 4 rest.in -var out part.csv
check part.csv "a restart"
same 1.csv part.csv "a restart"
[ "$(grep -E '^ +400 ' rest.in.screen | tail -n 1 | awk '{ print $3, $4, $7, $9 }')" = "$(awk '{ print $3, $4, $7, $9 }' <<< "$totals")" ] || die "totals after a restart"
