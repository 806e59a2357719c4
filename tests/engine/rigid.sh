#!/usr/bin/env bash
# Bodies of LAMMPS's fixes rigid/small and rigid/nve/small at walls: ranks, periodic edges, a restart, energy with each fix,
# deposits and what holds them, a wall that comes later, rods longer than half a period, and what is refused. (What bodies
# do at walls: unit_body and unit_movers.)
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
source "$here/rigid_scene.sh"

# dumbbells N LOW [AXIS]: a data file of dumbbells of 1 mm spheres on a grid of 3.6 mm, in layers from a height on, in a
# box of 42 mm; their axes at random, or the same.
dumbbells() {
  awk -v n="$1" -v low="$2" -v axis="${3:-}" 'function uniform() { state = (16807 * state) % 2147483647; return state / 2147483647 }
    BEGIN { state = 4711
      printf "dumbbells\n\n%d atoms\n1 atom types\n-0.021 0.021 xlo xhi\n-0.021 0.021 ylo yhi\n-0.021 0.021 zlo zhi\n\nAtoms # sphere\n\n", 2 * n
      for (i = 0; i < n; i++) {
        if (axis != "") split(axis, e, " ")
        else do { for (k = 1; k <= 3; k++) e[k] = 2 * uniform() - 1; r = sqrt(e[1] ^ 2 + e[2] ^ 2 + e[3] ^ 2); for (k = 1; k <= 3; k++) if (r > 0) e[k] /= r } while (r > 1 || r < 0.1)
        for (s = 0; s < 2; s++) { h = 5e-4 * (1 - 2 * s)
          printf "%d 1 1e-3 2500 %.17g %.17g %.17g\n", 2 * i + s + 1, (i % 10 - 4.5) * 3.6e-3 + h * e[1], (int(i / 10) % 10 - 4.5) * 3.6e-3 + h * e[2], low + int(i / 100) * 2.5e-3 + h * e[3] } }
      printf "\nMols\n\n"
      for (i = 0; i < 2 * n; i++) print i + 1, int(i / 2) + 1 }' > data
}
closed() { # WORDS: six walls
  for plane in x y z; do for at in lo hi; do
    echo "fix $plane$at all wall/rebound ${plane}plane $([ $at = lo ] && echo -)0.02 $* ledger 1 file $plane$at.csv columns full"
  done; done
}
impacts() { for plane in xlo xhi ylo yhi zlo zhi; do [ ! -f $plane.csv ] || { rows $plane.csv || true; rm $plane.csv; }; done; }
script() { # BOUNDARY FIX VELOCITY WALLS RUNS
  start "$1"; go_on $2; echo "velocity all set $3
timestep 2e-5
$4"
  printf '%b\n' "$5"
}

# The same rows on 1, 2 and 4 ranks, of rough walls with friction, with periodic edges, and where bodies stick.
dumbbells 200 -0.017
rough=$(closed surface sigma 10 rebound walton 0.9 0.3 0)
sticky=$(echo "$rough" | sed '/zplane -/s/walton 0.9 0.3 0/constant 0 0/')
script "f f f" rigid/small "0.5 -0.8 -1.2" "$rough" 'run 400' > box.in
script "p p f" rigid/small "0.5 -0.8 -1.2" "$(echo "$rough" | grep zplane)" 'run 400' > periodic.in
script "f f f" rigid/small "0.5 -0.8 -1.2" "$sticky" 'run 400' > sticky.in
for name in box periodic sticky; do
  for ranks in 1 2 4; do engine $ranks $name.in; impacts > $name.$ranks; done
  [ "$(wc -l < $name.1)" -gt 150 ] || die "$name: $(wc -l < $name.1) impacts"
  same $name.1 $name.2 "2 ranks"; same $name.1 $name.4 "4 ranks"
done

# Over a restart, where the fix computes its bodies anew: stuck ones are where they stuck, and the others meet the walls as
# they would have. Deleted ones are gone.
ended="write_dump all custom NAME id x y z vx vy vz modify sort id format float %.9f"
{ sed 's/^run .*/run 50/' sticky.in; echo "write_restart sticky.bin
run 350
${ended/NAME/whole.txt}"; } > whole.in
engine 2 whole.in; impacts > whole.rows
{ start | sed 's/^read_data.*/read_restart sticky.bin/; /^boundary/d; /^fix mol/d'; echo "fix mol all property/atom mol ghost yes"; go_on rigid/small; echo "$sticky
timestep 2e-5
run 350
${ended/NAME/part.txt}"; } > part.in
engine 1 part.in; impacts > part.rows
awk -F, '$3 > 0.0010001' whole.rows | cut -d, -f1,2,4-9 > whole.late
[ "$(wc -l < part.rows)" -gt 50 ] && [ "$(wc -l < part.rows)" = "$(wc -l < whole.late)" ] || die "a restart: $(wc -l < part.rows) impacts, $(wc -l < whole.late) without"
table a=whole.txt b=part.txt 'stuck = [row for row in a if row.z < -0.0184 and hypot(*row[4:7]) < 1e-10]
assert len(stuck) > 100 and len(a) == len(b) == 400
assert all(dist(x[1:4], y[1:4]) < 2e-7 for x, y in zip(a, b))' || die "positions after a restart"
sed '/fix zlo /s/ ledger/ deposit delete ledger/; $ a variable n equal atoms\nprint "left: $n"' sticky.in > delete.in
for ranks in 1 4; do
  engine $ranks delete.in; impacts > delete.$ranks
  left=$(awk '/^left:/ { print $2 }' delete.in.screen)
  [ "$left" -lt 350 ] && [ $((left % 2)) = 0 ] || die "$left particles are left of 400, on $ranks ranks"
done
same delete.1 delete.4 "deletes on 4 ranks"

# An elastic gas keeps its energy with each fix: to ten digits by Richardson's rule, which a free dumbbell turns as it
# should; nearly with the other.
dumbbells 100 -0.017
for style in rigid/small rigid/nve/small; do
  script "f f f" $style "0.5 -0.8 -1.2" "$(closed surface sigma 10 rebound constant 1 1)" 'timestep 1e-4\nthermo 50\nrun 500' > gas.in
  engine 2 gas.in
  table a=gas.in.screen "e = [row[2] + row[3] for row in a]
assert len(a) >= 11 and all(near(x, e[0], 1e-2 if 'nve' in '$style' else 1e-9) for x in e) and a[-1][3] > 0.5 * a[-1][2]" || die "the energy of a gas with $style"
done

# A stuck body lets the others fall as they should, and its weight is on the wall: in one run or several, wherever gravity
# stands. The fix of bodies misses half a kick where a run begins and gravity stands behind it.
dumbbells 2 -0.0185 "1 0 0"; awk 'NF == 7 && $1 > 2 { $7 += 0.03 } { print }' data > moved; mv moved data
fall="fix g all gravity 9.81 vector 0 0 -1"
for runs in 'run 200' 'run 100\nrun 100'; do for order in before behind; do
  { start; [ $order = behind ] || echo "$fall"; go_on rigid/small; [ $order = before ] || echo "$fall"; echo "group low id 1 2
group high id 3 4
velocity low set 0 0 -1.5
fix floor all wall/rebound zplane -0.02 rebound constant 0 0
timestep 2e-5
variable u equal vcm(high,z)
thermo_style custom step v_u f_floor[2] f_floor[9]
thermo 20"; printf '%b\n' "$runs"; } > weight.in
  engine 1 weight.in
  table a=weight.in.screen 'assert len(a) >= 11
for step, u, deposits, force in a:
    lag = u / 9.81 + 2e-5 * step
    assert -1e-9 <= lag <= 2.0001e-5, (step, lag)
    assert step < 60 or deposits == 1 and (near(force, -2.568252e-5, 1e-4) or step == 100 and force == 0), (step, deposits, force)' ||
    die "a stuck body, gravity $order its fix: $runs"
done; done

# A body that is stuck to a region turns with it.
dumbbells 1 -0.0175 "1 0 0"; awk 'NF == 7 { $5 += 0.0162; $6 += 0.0162 } { print }' data > moved; mv moved data
script "f f f" rigid/small "0 0 -1.5" 'variable th equal 2*PI*step*dt/0.02
region r block -0.021 0.021 -0.021 0.021 -0.019 0.019 units box rotate v_th 0 0 0 0 0 1
fix wall all wall/rebound region r rebound constant 0 0
variable a equal v_th*180/PI
variable b equal atan2(y[1]-y[2],x[1]-x[2])*180/PI
thermo_style custom step v_a v_b f_wall[2]' 'thermo 50\nrun 300' > turning.in
engine 1 turning.in
table a=turning.in.screen 'off = [row[1] - row[2] for row in a if row[3] > 0]
assert len(off) >= 5 and all(abs(x - off[0]) < 1e-4 for x in off)' || die "a body on a turning region"

# A wall that is defined between two runs is there for bodies that were far from all others; rods may be longer than half
# a period.
dumbbells 100 -0.012
script "f f f" rigid/small "0 0 -1.5" "fix lead all wall/rebound zplane 0.02 rebound constant 1 1
run 20
fix floor all wall/rebound zplane -0.02 rebound constant 1 1
compute low all reduce min z
thermo_style custom step f_floor c_low" 'run 300' > later.in
engine 1 later.in
table a=later.in.screen 'assert a[-1][0] == 320 and a[-1][1] > 100 and a[-1][2] > -0.0195001' || die "a wall between two runs"
awk 'BEGIN { printf "rods\n\n30 atoms\n1 atom types\n-0.021 0.021 xlo xhi\n-0.00125 0.00125 ylo yhi\n-0.021 0.021 zlo zhi\n\nAtoms # sphere\n\n"
  for (i = 0; i < 30; i++) { k = i % 3 - 1; printf "%d 1 1e-3 2500 %.17g %.17g %.17g\n", i + 1, 3.6e-3 * (int(i / 3) - 4.5) + 1e-4 * k, 0.99e-3 * k, -0.012 + 1e-4 * k }
  printf "\nMols\n\n"; for (i = 0; i < 30; i++) print i + 1, int(i / 3) + 1 }' > data
script "f p f" rigid/small "0 0 -1.5" "fix lo all wall/rebound zplane -0.02 rebound constant 1 1" 'thermo 100\nrun 600' > rods.in
engine 2 rods.in
table a=rods.in.screen 'assert all(near(row[2] + row[3], a[0][2] + a[0][3], 1e-9) for row in a) and a[-1][3] > 1e-7' || die "rods of more than half a period"

# What is refused: a law that bodies do not have, and fixes that walls cannot follow.
dumbbells 10 -0.012
while IFS='|' read -r style words beta message; do
  { start; go_on "$style" | sed "s|^fix bodies .*|&$words|; /^compute/d; /^thermo/d"; echo "thermo_style custom step atoms
fix floor all wall/rebound zplane -0.02 rebound walton 0.9 0.3 $beta
timestep 2e-5
run 100"; } > bad.in
  refuses 2 bad.in "$message"
done << END
rigid/small||0.4|BETA0 0
rigid/nvt| temp 1 1 1|0|fix rigid/nvt (id bodies)
rigid||0|it must be rigid/small
rigid/nve||0|it must be rigid/nve/small
END
