#!/usr/bin/env bash
# Other commands of LAMMPS scripts, each with a wall of this fix: the borders between ranks move, atoms are sorted, lists
# are built anew at will, particles come by `fix deposit` and `fix pour`, walls have groups, steps get other numbers,
# partitions run at once. Nothing of it changes an impact of a grain that flies alone. Maps of triangles can be read.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
use lammps
grains 400 > grains.data
plate 6 1 3.9e-3 > plate.stl
wall='fix wall all wall/rebound stl plate.stl type 2 materials quartz hastelloy-x surface rq 10e-6 lambda_c 90e-6 deposit freeze seed 4 ledger 100 file rows.csv'
script() { # NAME, lines before the wall, lines before the run, runs
  { boundary='m m m' flying grains.data | sed '/^fix m[0-9]/d; /^pair_/d'
    echo "$2
$wall
timestep 1e-8
thermo 1000
$3
thermo_style custom step atoms f_wall f_wall[2]
${4:-run 400}"; } > "$1.in"
}
counts() { grep -E '^ +[0-9]+ +[0-9]+ +[0-9]+ +[0-9]+ *$' "$1.in.screen" | tail -n 1 | awk '{ print $2, $3, $4 }'; }
script plain '' ''
engine 1 plain.in
cp rows.csv plain.csv
[ "$(count_rows plain.csv)" -ge 400 ] || die "too few impacts"
# unchanged NAME RANKS [TOLERANCE]: the impacts of the plain run, to the byte where no tolerance is given.
unchanged() {
  rm -f rows.csv
  engine "$2" "$1.in"
  if [ $# = 2 ]; then same plain.csv rows.csv "$1 on $2 ranks"
  else near plain.csv rows.csv 'tag impact time x y z d_p v1 alpha1_deg delta_alpha_deg tilt_out_deg hits v2 alpha2_deg cor_n outcome' "$3"; fi
  [ "$(counts "$1")" = "$(counts plain)" ] || die "$1 on $2 ranks: $(counts "$1"), and it must be $(counts plain)"
}
# (LAMMPS takes places into the box's own lengths and back where it moves borders, which rounds them.)
script balance '' 'fix share all balance 20 1.0 shift xy 5 1.01
fix tell all print 400 "imbalance $(f_share[2])"'
unchanged balance 4 1e-9
grep -qE '^imbalance [1-9]' balance.in.screen || die "fix balance did nothing"
script tiled '' 'comm_style tiled
fix share all balance 20 1.0 rcb'
unchanged tiled 4 1e-9
script sorted '' 'atom_modify sort 7 2e-4'
script lists 'neigh_modify every 3 delay 6 check no' ''
script check 'neigh_modify once no every 1 check yes' ''
for name in sorted lists check; do unchanged $name 2; done
script runs '' '' 'run 100
reset_timestep 5000
run 150 pre no post no
reset_timestep 0
run 150'
rm -f rows.csv; engine 2 runs.in
same <(rows plain.csv) <(rows rows.csv) "reset_timestep"

# A wall that is drawn in other units of length, in large letters: the log says how far it reaches, and whether it
# misses the box.
awk '$1 == "vertex" { printf "vertex %.17g %.17g %.17g\n", 1000 * $2, 1000 * $3, 1000 * $4; next } { print }' plate.stl |
  tr a-z A-Z > mm.stl
awk '$1 == "vertex" { $4 = "0.05" } { print }' plate.stl > far.stl
in_metres=$wall
# reports NAME FILE WARNING: one line of what the mesh is; the warning, or none where it is empty.
reports() {
  wall=${in_metres/plate.stl/$2}
  script "$1" '' '' "${4:-run 1}"
  wall=$in_metres
  [ "${4:-}" ] || { sed -i 's/boundary m m m/boundary f f f/' "$1.in"; engine 1 "$1.in"; }
  [ -z "${4:-}" ] || unchanged "$1" 2 1e-9
  [ "$(grep -c "^fix wall wall/rebound: stl .*: 72 triangles, x -*[0-9.e-]* to " "$1.in.screen")" = 1 ] || die "$1: the log does not say what the mesh is"
  if [ "$3" ]; then [ "$(grep -c "WARNING: .*$3" "$1.in.screen")" = 1 ] || die "$1: $(grep WARNING "$1.in.screen")"
  else ! grep WARNING "$1.in.screen" | grep -q stl || die "$1: $(grep WARNING "$1.in.screen")"; fi
}
reports scale 'mm.stl scale 1e-3' '' 'run 400'
grep -q '72 triangles, x -0.0019 to 0.0039, y -0.0019 to 0.0039, z 0 to 0 (scale 0.001)' scale.in.screen || die "the mesh's extent"
reports far far.stl "'stl far.stl scale 1 type 2' lies outside of the box, x .* in another unit of length"
reports coming 'far.stl move linear 0 0 -1' ''

# Groups, and walls beside each other: each grain is its own group's wall's.
script groups 'group odd id 1:400:2
group even subtract all odd' "unfix wall
fix low odd wall/rebound zplane 0 type 2 rebound constant 1 1 deposit off ledger 100 file odd.csv
fix high even wall/rebound zplane -1e-4 type 2 rebound constant 1 1 deposit off ledger 100 file even.csv
fix wall all wall/rebound zplane 5e-4 rebound constant 1 1 deposit off"
engine 2 groups.in
check_rows odd.csv 'r.tag % 2 == 1 and r.z > 0' "the wall of the odd ones"
check_rows even.csv 'r.tag % 2 == 0 and r.z < 0' "the wall of the even ones"

# Partitions, each with its own ledger.
script parts '' ''
sed -i 's/file rows.csv/file rows.${part}.csv/; 1i variable part world a b' parts.in
timeout 60 mpirun -np 3 "$program" -in parts.in -partition 2 1 -log none -plog none -pscreen none > parts.screen 2>&1 || { tail parts.screen; die "partitions"; }
for part in a b; do same plain.csv rows.$part.csv "partition $part"; done

# Particles that come while it runs, and go: each has its own impacts from 1, and all stay above the wall.
coming() { # NAME LINES
  { echo "units si
atom_style sphere
boundary p p f
region box block 0 2e-3 0 2e-3 -1e-4 2e-3 units box
create_box 2 box
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all
comm_modify cutoff 1e-4
region source block 2e-4 18e-4 2e-4 18e-4 1e-3 18e-4 units box
$2
fix low all wall/rebound zplane 0.0 type 2 surface rq 1e-5 lambda_c 9e-5 deposit off rebound constant 0.9 0.9 ledger 100 file rows.csv
fix high all wall/rebound zplane 19.5e-4 rebound constant 1 1 deposit off
fix move all nve/sphere
timestep 2e-7
thermo_style custom step atoms f_low f_low[2]
run 1000
region hole cylinder z 1e-3 1e-3 3e-4 INF INF units box
delete_atoms region hole compress no
run 1000"; } > "$1.in"
  for ranks in 1 2; do
    rm -f rows.csv
    engine $ranks "$1.in"
    table a=rows.csv 'last = {}
for row in a:
    assert row.impact == last.get(row.tag, 0) + 1 and row.z > 0, row
    last[row.tag] = row.impact
assert len(a) >= 100 and sum(row.impact > 1 for row in a) >= 10' || die "$1 on $ranks ranks: impact numbers, or a grain below the wall"
  done
}
printf '# grain\n\n1 atoms\n\nCoords\n\n1 0 0 0\n\nTypes\n\n1 1\n\nDiameters\n\n1 1e-5\n\nMasses\n\n1 1.3875e-12\n' > grain.txt
coming deposit 'molecule grain grain.txt
fix in all deposit 200 0 4 4711 mol grain region source near 1e-5 vx 20 20 vy 0 0 vz -60 -40'
coming pour 'fix weight all gravity 9.81 vector 0 0 -1
fix in all pour 200 1 4711 region source diam one 1e-5 dens 2650 2650 vol 0.1 50 vel -20 20 -20 20 -50'

# Maps: the time, and every triangle with its sums, those of the wall.
script maps '' '' 'run 400'
sed -i 's/^fix wall.*/& columns full erosion dnv density 7800 face tilted map 200 map.*.vtp/' maps.in
echo 'print "worn $(f_wall[14]:%.17g) $(time:%.17g)"' >> maps.in
column() { # NAME: of the map at step 400
  awk -v name="Name=\"$1\"" '/^<\/DataArray/ { on = 0 } on; /^<DataArray/ { on = index($0, name) }' map.400.vtp
}
for ranks in 1 2; do
  engine $ranks maps.in
  [ -s map.200.vtp ] || die "no map of step 200"
  grep -q 'NumberOfPoints="216" NumberOfPolys="72"' map.400.vtp || die "the map has other triangles"
  [ "$(column TimeValue)" = "$(awk '$1 == "worn" { print $3 }' maps.in.screen)" ] || die "time of the map: $(column TimeValue)"
  [ "$(column impacts | awk '{ n += $1 } END { print n }')" = "$(counts maps | awk '{ print $2 }')" ] ||
    die "impacts on the map, of the wall: $(counts maps)"
  rows rows.csv | awk -F, '{ n[$5]++ } END { for (t = 0; t < 72; t++) print n[t] + 0 }' > of_rows
  column impacts > of_map
  same of_rows of_map "impacts of each triangle"
  # What is worn off each triangle, and how deep: the command has the same by the rows, the fix in all.
  "$bin/asperity" erosion rows.csv | awk -F, '$2 ~ /^[0-9]+$/ { m[$2] = $4 } END { for (t = 0; t < 72; t++) printf "%.10g\n", m[t] }' > of_rows
  paste -d' ' <(column eroded_mass) <(column erosion_depth) of_rows |
    awk -v all="$(awk '$1 == "worn" { print $2 }' maps.in.screen)" '{ sum += $1; if (($1 - $3) ^ 2 > 1e-14 * $3 ^ 2 || ($2 * 7800 * 0.5 * (5.8e-3 / 6) ^ 2 - $1) ^ 2 > 1e-14 * $1 ^ 2) { print; exit 1 } } END { exit !(NR == 72 && sum > 0 && (sum / all - 1) ^ 2 < 1e-10) }' ||
    die "eroded mass and depth of each triangle"
done
