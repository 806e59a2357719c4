#!/usr/bin/env bash
# Walls as scenes have them: a concave edge met in one step, a thin wall from both sides, moving and turning
# meshes (rebound in the wall's frame), several walls beside a resolved one, particles that come and go.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
mirror='surface smooth rebound constant 1 1 deposit off'
scene() { # particles (x y z vx vy vz, ...), step, steps, lines
  head_of si
  echo "region box block -0.01 0.01 -0.01 0.01 -0.01 0.01 units box
create_box 2 box
neighbor 1e-3 bin
neigh_modify delay 0 exclude group all all"
  materials
  local i=0
  while read -r x y z vx vy vz; do
    i=$((i + 1))
    echo "create_atoms 1 single $x $y $z units box"
  done <<< "$1"
  echo "set group all diameter 1e-4 density 2650"
  i=0
  while read -r x y z vx vy vz; do
    i=$((i + 1))
    echo "group p$i id $i
velocity p$i set $vx $vy $vz units box"
  done <<< "$1"
  echo "fix move all nve/sphere
timestep $2
$4
dump at all custom $3 at.txt id x y z vx vy vz
dump_modify at sort id format \"%d %.15g %.15g %.15g %.15g %.15g %.15g\"
run $3"
}
rectangle() { # four corners, x y z each
  set -- $1
  printf 'solid s\nfacet normal 0 0 0\nouter loop\nvertex %s %s %s\nvertex %s %s %s\nvertex %s %s %s\nendloop\nendfacet\nfacet normal 0 0 0\nouter loop\nvertex %s %s %s\nvertex %s %s %s\nvertex %s %s %s\nendloop\nendfacet\nendsolid s\n' \
    "$1" "$2" "$3" "$4" "$5" "$6" "$7" "$8" "$9" "$1" "$2" "$3" "$7" "$8" "$9" "${10}" "${11}" "${12}"
}
arrives() { # name, "id x y z vx vy vz" lines, tolerance of positions, of speeds, numbers of ranks
  for ranks in ${5:-1}; do
    engine $ranks "$1.in"
    tail -n "$(wc -l <<< "$2")" at.txt | paste -d' ' - <(echo "$2") | awk -v tx="$3" -v tv="$4" '
      { for (i = 1; i <= 7; i++) { d = $i - $(i + 7); if (d < 0) d = -d; if (!(d <= (i == 1 ? 0 : i > 4 ? tv : tx))) { print "is and want: " $0; bad = 1 } } } END { exit bad || !NR }' || die "$1 on $ranks ranks"
  done
}

# A concave right angle, floor z = 0 and wall x = 0 in one mesh: both are met within one step, in either order.
{ rectangle "0 -0.005 0  0.005 -0.005 0  0.005 0.005 0  0 0.005 0"; } > floor.stl
{ rectangle "0 -0.005 0  0 0.005 0  0 0.005 0.005  0 -0.005 0.005"; } > side.stl
{ sed '$d' floor.stl; sed '1d' side.stl; } > corner.stl
scene "2e-4 0 1.5e-4 -50 0 -40
1.2e-4 1e-3 3e-4 -50 0 -40" 1e-5 1 "fix c all mesh/surface file corner.stl type 2
fix w all wall/rebound mesh n_meshes 1 meshes c $mirror" > corner.in
# x: reaches 50 um after 3 us, z: after 2.5 us; then back with 50 and 40 m/s. Second: 1.4 us and 6.25 us.
arrives corner "1 $(awk 'BEGIN { print 5e-5 + 50 * 7e-6, 0, 5e-5 + 40 * 7.5e-6 }') 50 0 40
2 $(awk 'BEGIN { print 5e-5 + 50 * 8.6e-6, 0.001, 5e-5 + 40 * 3.75e-6 }') 50 0 40" 1e-12 1e-9 "1 2"

# A thin wall, hit from both sides.
{ rectangle "-0.005 -0.005 0  0.005 -0.005 0  0.005 0.005 0  -0.005 0.005 0"; } > thin.stl
scene "1e-4 1e-4 2e-4 0 0 -30
3e-4 -2e-4 -2e-4 0 0 30" 1e-6 10 "fix c all mesh/surface file thin.stl type 2
fix w all wall/rebound mesh n_meshes 1 meshes c $mirror" > thin.in
arrives thin "1 1e-4 1e-4 2e-4 0 0 30
2 3e-4 -2e-4 -2e-4 0 0 -30" 1e-12 1e-9

# A belt that runs at 4 m/s drags a particle that lands on it into the wall at its end, within the same step: of
# 10 us, of which the particle flies down for a half, and then with the belt for a quarter and back for a quarter.
{ rectangle "6e-5 -0.005 0  6e-5 0.005 0  6e-5 0.005 0.005  6e-5 -0.005 0.005"; } > end.stl
belt() { # what it is made of
  echo "fix b all mesh/surface file thin.stl type 2 surface_vel 4. 0. 0.
fix e all mesh/surface file end.stl type 2
fix onb all wall/rebound $1 surface smooth rebound constant 1 0 deposit off
fix one all wall/rebound mesh n_meshes 1 meshes e $mirror"; }
mesh_belt=$(belt 'mesh n_meshes 1 meshes b') plane_belt=$(belt 'primitive type 2 zplane 0.0 shear x 4.')
[ $simulator = liggghts ] || mesh_belt=$plane_belt # LAMMPS's meshes are no belts
for belt in "$mesh_belt" "$plane_belt"; do
  scene "0 1e-4 5.125e-5 0 0 -0.25" 1e-5 1 "$belt" > belt.in
  arrives belt "1 0 1e-4 5.125e-5 -4 0 0.25" 1e-12 1e-9
done
# The same where a step before it has 10 ns, which `dt/reset` makes 10 us when another particle has lost its speed.
{ rectangle "-0.005 -0.005 2e-3  0.005 -0.005 2e-3  0.005 0.005 2e-3  -0.005 0.005 2e-3"; } > stop.stl
scene "0 1e-4 5.12525e-5 0 0 -0.25
0 1e-3 1.94999e-3 0 0 100" 1e-8 2 "$mesh_belt
fix s all mesh/surface file stop.stl type 2
fix ons all wall/rebound mesh n_meshes 1 meshes s surface smooth rebound constant 1e-6 1 deposit off
fix dt p2 dt/reset 1 1e-8 1e-5 1e-9" > reset.in
arrives reset "1 0 1e-4 5.125e-5 -4 0 0.25
2 0 1e-3 1.95e-3 0 0 -1e-4" 2e-9 1e-9

# The ridge of a roof, which is an edge of two triangles: all impacts on it are of the first one.
{ rectangle "0 0.005 0  0 -0.005 0  0.005 -0.005 -0.003  0.005 0.005 -0.003"; } > east.stl
{ rectangle "0 -0.005 0  0 0.005 0  -0.005 0.005 -0.003  -0.005 -0.005 -0.003"; } > west.stl
for first in east west; do
  { sed '$d' $first.stl; [ $first = east ] && sed '1d' west.stl || sed '1d' east.stl; } > roof.stl
  scene "$(awk 'BEGIN { for (i = -19; i <= 19; i += 2) printf "%.9g %.9g %.9g 0 %.9g -30\n", i * 1e-6, i * 1.7e-4, 1e-4 + 3.3e-6 * (i + 20), i * 1.3 }')" 1e-6 10 "fix c all mesh/surface file roof.stl type 2
fix w all wall/rebound mesh n_meshes 1 meshes c $mirror ledger 10 file roof.csv" > roof.in
  engine 2 roof.in
  [ "$(rows roof.csv | cut -d, -f5 | sort | uniq -c | awk '{ printf "%s of %s;", $1, $2 }')" = "20 of 0;" ] || { rows roof.csv | cut -d, -f5 | sort | uniq -c; die "roof, $first first"; }
done

# Between two walls: a particle that begins in the floor is lifted out of it, and meets the ceiling so much sooner.
{ rectangle "-0.005 -0.005 2.2e-4  0.005 -0.005 2.2e-4  0.005 0.005 2.2e-4  -0.005 0.005 2.2e-4"; } > ceiling.stl
{ sed '$d' thin.stl; sed '1d' ceiling.stl; } > gap.stl
scene "1e-4 1e-4 2e-5 0 0 -10" 1e-7 150 "fix c all mesh/surface file gap.stl type 2
fix w all wall/rebound mesh n_meshes 1 meshes c $mirror" > gap.in
arrives gap "1 1e-4 1e-4 1.4e-4 0 0 -10" 1e-12 1e-9

# A wall that rises at 10 m/s meets a particle at rest: it leaves at 20 m/s; one that falls at 30 m/s, at 50.
scene "1e-3 1e-3 1.5e-4 0 0 0
-1e-3 1e-3 4.5e-4 0 0 -30" 1e-6 20 "fix c all mesh/surface file thin.stl type 2
fix up all move/mesh mesh c linear 0 0 10
fix w all wall/rebound mesh n_meshes 1 meshes c $mirror" > rise.in
arrives rise "1 0.001 0.001 $(awk 'BEGIN { print 1.5e-4 + 20 * 10e-6 }') 0 0 20
2 -0.001 0.001 $(awk 'BEGIN { print 4.5e-4 - 30 * 10e-6 + 50 * 10e-6 }') 0 0 50" 1e-10 1e-6 "1 2"

# A plate that turns about the y axis, 1000 rad/s: at x = 2 mm it comes up at 2 m/s; at -2 mm it goes down.
scene "2e-3 0 6e-5 0 0 0
-2e-3 0 6e-5 0 0 0" 1e-7 100 "fix c all mesh/surface file thin.stl type 2
fix turn all move/mesh mesh c rotate origin 0. 0. 0. axis 0. -1. 0. period 6.283185307179586e-3
fix w all wall/rebound mesh n_meshes 1 meshes c $mirror ledger 100 file turn.csv" > turn.in
engine 2 turn.in
awk '/^1 / { up = $7 } /^2 / { down = $7 } END { exit !(up > 3.95 && up < 4.05 && down == 0) }' at.txt || { tail -n 2 at.txt; die "turn"; }
check_rows turn.csv '$1 == 1 && $10 > 1.98 && $10 < 2.02 && $11 > 89 && $17 > 0.9999 && $17 < 1.0001' "turn: speeds in the frame of the wall"

# Every primitive wall, from inside and outside: one specular impact at the distance of a radius.
primitive() { # style and arguments, particle
  scene "$2" 1e-6 10 "fix w all wall/rebound primitive type 2 $1 $mirror ledger 10 file primitive.csv" > primitive.in
  engine 1 primitive.in
  [ "$(count_rows primitive.csv)" = 1 ] || die "primitive $1: $(count_rows primitive.csv) impacts"
  check_rows primitive.csv '$4 == 0 && $17 > 1 - 1e-9 && $17 < 1 + 1e-9 && $15 > 49.999 && $15 < 50.001 && $11 > 89' "primitive $1"
}
primitive "xplane 0.0" "3e-4 0 0 -50 0 0"
primitive "yplane 0.0" "0 -3e-4 0 0 50 0"
primitive "zplane 0.0" "0 0 3e-4 0 0 -50"
primitive "xcylinder 2e-3 0 0" "0 1.7e-3 0 0 50 0"
primitive "xcylinder 2e-3 0 0" "0 2.3e-3 0 0 -50 0"
primitive "ycylinder 2e-3 0 0" "0 0 1.7e-3 0 0 50"
primitive "zcylinder 2e-3 0 0" "-1.7e-3 0 0 -50 0 0"

# A cylinder, its axis beside the origin, that turns about it with 1000 rad/s, and lets go of a particle that
# flies straight out with the speed along it that it has itself. Arms in order of the axes that follow its own.
turning() { # style, axis of `shear`, particle, its speeds after the impact
  scene "$3" 1e-6 10 "fix w all wall/rebound primitive type 2 $1 2e-3 1e-3 -2e-3 shear $2 1000 surface smooth rebound constant 1 0 deposit off" > turning.in
  engine 1 turning.in
  tail -n 1 at.txt | awk -v want="$4" '{ split(want, w, " "); for (i = 1; i <= 3; i++) { d = $(i + 4) - w[i]; if (!(d * d < 1e-16)) exit 1 } }' || { tail -n 1 at.txt; die "$1 that turns: wanted $4"; }
}
read -r first second < <(awk 'BEGIN { a = 1.95e-3 * 30 / sqrt(30 ^ 2 + 35 ^ 2); printf "%.12g %.12g\n", -30 - 1000 * a * 35 / 30, -35 + 1000 * a }')
turning xcylinder y "0 2.2e-3 -6e-4 0 30 35" "0 $first $second"
turning ycylinder x "-6e-4 0 2.2e-3 35 0 30" "$second 0 $first"
turning zcylinder x "2.2e-3 -6e-4 0 30 35 0" "$first $second 0"

# Rough walls of two kinds, a smooth one, and LIGGGHTS's resolved contact, in one run: each does its part.
grains 400 > grains.data
plate 6 1 3.9e-3 > plate.stl
{ head_of si | sed 's/boundary.*/boundary m m f/'; echo 'read_data grains.data
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all'; materials; echo "fix low all mesh/surface file plate.stl type 2
fix rough all wall/rebound mesh n_meshes 1 meshes low surface rq 15e-6 lambda_c 90e-6 deposit off ledger 1000 file rough.csv
fix fine all wall/rebound primitive type 2 zplane 5e-4 surface rq 2e-6 lambda_c 90e-6 deposit off ledger 1000 file fine.csv
fix gran all wall/gran model hertz tangential history primitive type 2 zplane 7e-4
fix move all nve/sphere
timestep 1e-8
thermo_style custom step atoms f_rough f_fine ke
thermo_modify lost error
run 2000"; } > many.in
for ranks in 1 3; do engine $ranks many.in; cp rough.csv rough.$ranks.csv; cp fine.csv fine.$ranks.csv; done
same rough.1.csv rough.3.csv "1 and 3 ranks"; same fine.1.csv fine.3.csv "1 and 3 ranks"
sd() { rows "$1" | awk -F, '{ n++; s += $12; q += $12 ^ 2 } END { print n, sqrt(q / n - (s / n) ^ 2) }'; }
read -r n_rough sd_rough < <(sd rough.csv); read -r n_fine sd_fine < <(sd fine.csv)
awk -v a="$n_rough" -v b="$n_fine" -v r="$sd_rough" -v f="$sd_fine" 'BEGIN { exit !(a >= 400 && b > 30 && r > 8 && r < 13.5 && f > 1.2 && f < 1.9) }' ||
  die "two roughnesses: $n_rough impacts with sd $sd_rough, $n_fine with sd $sd_fine"

[ $simulator = liggghts ] || exit 0 # features.sh has what LAMMPS inserts

# Particles that are inserted, deleted and lost while it runs: each counts its own impacts from 1. (Without
# `compress no`, delete_atoms would give the rest new tags, and with them new draws.)
{ head_of si; echo "region box block 0 2e-3 0 2e-3 -1e-4 1e-3 units box
create_box 2 box
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all"; materials; echo "fix t all particletemplate/sphere 15485863 atom_type 1 volume_limit 1e-20 density constant 2650 radius constant 5e-6
fix d all particledistribution/discrete 32452843 1 t 1.0
region source block 2e-4 12e-4 2e-4 18e-4 1e-4 3e-4 units box
fix in all insert/rate/region seed 49979687 distributiontemplate d nparticles 600 particlerate 5e7 insert_every 100 overlapcheck yes vel constant 20 0 -40 region source
fix low all wall/rebound primitive type 2 zplane 0.0 surface rq 1e-5 lambda_c 9e-5 deposit off rebound constant 0.9 0.9 ledger 100 file low.csv
fix high all wall/rebound primitive type 2 zplane 4e-4 surface smooth deposit off rebound constant 1 1 ledger 100 file high.csv
fix move all nve/sphere
timestep 2e-8
thermo_modify lost ignore
run 700
region hole cylinder z 1e-3 1e-3 3e-4 INF INF units box
delete_atoms region hole compress no
run 1300"; } > flow.in
engine 2 flow.in
for wall in low high; do
  rows $wall.csv | awk -F, '{ if ($2 != last[$1] + 1) bad = 1; last[$1] = $2; n++ } END { exit bad || n < 300 }' || die "flow: impact numbers at the $wall wall"
done
[ "$(rows low.csv | awk -F, '$2 > 1' | wc -l)" -gt 30 ] || die "flow: too few second impacts"
