#!/usr/bin/env bash
# Bodies of LAMMPS's fixes rigid/small and rigid/nve/small at walls: a dumbbell's first hit, a rod that lands flat,
# ranks, a restart, periodic edges, energy with each fix, deposits and what holds them, a wall that comes later, rods
# longer than half a period, long steps, and what is refused.
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
      for (i = 0; i < 2 * n; i++) print i + 1, int(i / 2) + 1 }'
}
closed() { # WORDS: six walls
  for plane in x y z; do for at in lo hi; do
    echo "fix $plane$at all wall/rebound ${plane}plane $([ $at = lo ] && echo -)0.02 $* ledger 1 file $plane$at.csv columns full"
  done; done
}
impacts() { for plane in xlo xhi ylo yhi zlo zhi; do [ ! -f $plane.csv ] || { rows $plane.csv || true; rm $plane.csv; }; done; }
energies() { grep -E '^ +[0-9]+ +[0-9]+ +[0-9.e+-]+ +[0-9.e+-]+ *$' "$1"; }

# The first hit: CoR_N of the center is 1 - 2 q/(1 + q), q = (5/7) cos^2 theta, by the lever in the row.
dumbbells 600 -0.017 > data
{ start; go_on rigid/small; echo "velocity all set 0 0 -1.5
fix floor all wall/rebound zplane -0.02 rebound walton 1 0 0 ledger 1 file first.csv columns full
timestep 2e-5
run 600"; } > first.in
engine 1 first.in
rows first.csv | awk -F, '$26 == -1.5 && $30 == 0 && $31 == 0 && !($40 in seen) { seen[$40] = 1; n++
    q = 5 / 7 * ($41 ^ 2 + $42 ^ 2) / 0.25e-6; d = $17 - (1 - 2 * q / (1 + q)); if (d < 0) d = -d
    if (d > 1e-8) bad = 1; s += $17; t += $17 ^ 2 }
  END { m = s / n; sd = sqrt(t / n - m * m); print "first hits: " n ", mean CoR_N " m " (0.3872), sd " sd " (0.2268)"
    exit bad || n < 300 || m < 0.33 || m > 0.44 || sd < 0.2 || sd > 0.25 }' || die "the first hit of a dumbbell"

# A rod that lands flat: both ends at once, V -> -e V without spin.
dumbbells 20 -0.012 "1 0 0" > data
{ start; go_on rigid/small; echo "velocity all set 0 0 -1.5
fix floor all wall/rebound zplane -0.02 rebound walton 0.8 0.3 0 ledger 1 file flat.csv columns full
timestep 2e-5
run 500"; } > flat.in
engine 1 flat.in
check_rows flat.csv 'abs(r.v2z - 1.2) < 1e-8 and hypot(r.omega2x, r.omega2y, r.omega2z) < 1e-3 and abs(r.v2y) < 1e-8' "a rod lands flat"

# The same ledgers on 1, 2 and 4 ranks, of rough walls with friction, with periodic edges, and where bodies stick; and
# near to them over a restart, where the fix computes its bodies anew.
dumbbells 200 -0.017 > data
scene() { # BOUNDARY STEPS WALLS
  start "$1"; go_on rigid/small; echo "velocity all set 0.5 -0.8 -1.2"; echo "$3"; echo "timestep 2e-5
run $2"
}
rough=$(closed surface sigma 10 rebound walton 0.9 0.3 0)
scene "f f f" 400 "$rough" > box.in
scene "p p f" 400 "$(echo "$rough" | grep "zplane")" > periodic.in
sticky=$(echo "$rough" | sed '/zplane -/s/walton 0.9 0.3 0/constant 0 0/')
scene "f f f" 400 "$sticky" > sticky.in
for script in box periodic sticky; do
  for ranks in 1 2 4; do engine $ranks $script.in; impacts > $script.$ranks; done
  [ "$(wc -l < $script.1)" -gt 150 ] || die "$script: $(wc -l < $script.1) impacts"
  same $script.1 $script.2 "2 ranks"; same $script.1 $script.4 "4 ranks"
done

# Stuck bodies are where they stuck: at the end and after a restart on another number of ranks, and the others meet the
# walls as they would have, as far as the fix makes the same bodies of their particles. Deleted ones are gone.
ended="write_dump all custom NAME id x y z vx vy vz modify sort id format float %.9f"
{ sed 's/^run .*/run 50/' sticky.in; echo "write_restart sticky.bin
run 350
${ended/NAME/whole.txt}"; } > whole.in
engine 2 whole.in; impacts > whole.rows
{ echo "units si
atom_style sphere
atom_modify map array
newton off
comm_modify vel yes cutoff 3e-3
read_restart sticky.bin
fix mol all property/atom mol ghost yes"; go_on rigid/small; echo "${sticky//file /file part.}"; echo "timestep 2e-5
run 350
${ended/NAME/part.txt}"; } > part.in
engine 1 part.in; for plane in xlo xhi ylo yhi zlo zhi; do mv part.$plane.csv $plane.csv; done; impacts > part.rows
stuck() { awk 'NF == 7 && $4 < -0.0184 && $5 ^ 2 + $6 ^ 2 + $7 ^ 2 < 1e-20 { n++ } END { print n + 0 }' "$1"; }
[ "$(stuck whole.txt)" -gt 100 ] || die "$(stuck whole.txt) particles of stuck bodies"
awk -F, '$3 > 0.0010001' whole.rows | cut -d, -f1,2,4-9 > whole.late; cut -d, -f1,2,4-9 part.rows > part.late
[ "$(wc -l < part.late)" -gt 50 ] && [ "$(wc -l < part.late)" = "$(wc -l < whole.late)" ] || die "a restart: $(wc -l < part.late) impacts, $(wc -l < whole.late) without"
paste -d' ' whole.txt part.txt | awk 'NF == 14 { for (k = 2; k <= 4; k++) { d = $k - $(k + 7); if (d * d > 1e-14) bad = 1 } n++ } END { exit bad || n != 400 }' || die "positions after a restart"
sed '/fix zlo /s/ ledger/ deposit delete ledger/; $ a variable n equal atoms\nprint "left: $n"' sticky.in > delete.in
for ranks in 1 4; do
  engine $ranks delete.in; impacts > delete.$ranks
  held=$(stuck whole.txt); left=$(awk '/^left:/ { print $2 }' delete.in.screen)
  [ "$left" -lt 350 ] && [ $((left % 2)) = 0 ] || die "$left particles are left of 400, on $ranks ranks, where $held would be stuck"
done
same delete.1 delete.4 "deletes on 4 ranks"

# An elastic gas keeps its energy with each fix: to ten digits by Richardson's rule, which a free dumbbell turns as it
# should; nearly with the other.
dumbbells 100 -0.017 > data
for style in rigid/small rigid/nve/small; do
  { start; go_on $style; echo "velocity all set 0.5 -0.8 -1.2"; closed surface sigma 10 rebound constant 1 1; echo "timestep 1e-4
thermo 50
run 500"; } > gas.in
  engine 2 gas.in
  energies gas.in.screen | awk -v style=$style '{ e = $3 + $4; if (NR == 1) first = e; d = e / first - 1; if (d < 0) d = -d; if (d > worst) worst = d }
    END { print style ": energy off by " worst ", E_rot/E_trans " $4 / $3; exit NR < 11 || worst > (style ~ /nve/ ? 1e-2 : 1e-9) || $4 / $3 < 0.5 }' || die "the energy of a gas with $style"
done

# A stuck body lets the others fall as they should, and its weight is on the wall: in one run or several, wherever gravity
# stands. The fix of bodies misses half a kick where a run begins and gravity stands behind it.
dumbbells 2 -0.0185 "1 0 0" | awk 'NF == 7 && $1 > 2 { $7 += 0.03 } { print }' > data
fall="fix g all gravity 9.81 vector 0 0 -1"
for runs in "run 200" "run 100
run 100"; do for order in before behind; do
  { start; [ $order = behind ] || echo "$fall"; go_on rigid/small; [ $order = before ] || echo "$fall"; echo "group low id 1 2
group high id 3 4
velocity low set 0 0 -1.5
fix floor all wall/rebound zplane -0.02 rebound constant 0 0
timestep 2e-5
variable u equal vcm(high,z)
thermo_style custom step v_u f_floor[2] f_floor[9]
thermo 20
$runs"; } > weight.in
  engine 1 weight.in
  grep -E '^ +[0-9]+( +[-+.0-9e]+){3} *$' weight.in.screen | awk '{ n++; lag = $2 / 9.81 + 2e-5 * $1; weight = $4 / -2.568252e-5
    if (lag < -1e-9 || lag > 2.0001e-5 || ($1 >= 60 && ($3 != 1 || (weight - 1) ^ 2 > 1e-8) && !($1 == 100 && weight == 0))) { bad = 1; print } } END { exit bad || n < 11 }' ||
    die "a stuck body, gravity $order its fix: $runs"
done; done

# A body that is stuck to a region turns with it.
dumbbells 1 -0.0175 "1 0 0" | awk 'NF == 7 { $5 += 0.0162; $6 += 0.0162 } { print }' > data
{ start; go_on rigid/small; echo "variable th equal 2*PI*step*dt/0.02
region r block -0.021 0.021 -0.021 0.021 -0.019 0.019 units box rotate v_th 0 0 0 0 0 1
fix wall all wall/rebound region r rebound constant 0 0
velocity all set 0 0 -1.5
timestep 2e-5
variable a equal v_th*180/PI
variable b equal atan2(y[1]-y[2],x[1]-x[2])*180/PI
thermo_style custom step v_a v_b f_wall[2]
thermo 50
run 300"; } > turning.in
engine 1 turning.in
grep -E '^ +[0-9]+( +[-+.0-9e]+){3} *$' turning.in.screen | awk '$4 > 0 { if (!n++) first = $2 - $3; if (($2 - $3 - first) ^ 2 > 1e-8) { bad = 1; print } } END { exit bad || n < 5 }' || die "a body on a turning region"

# A wall that is defined between two runs is there for bodies that were far from all others; rods may be longer than half
# a period.
dumbbells 100 -0.012 > data
{ start; go_on rigid/small; echo "velocity all set 0 0 -1.5
fix lead all wall/rebound zplane 0.02 rebound constant 1 1
timestep 2e-5
run 20
fix floor all wall/rebound zplane -0.02 rebound constant 1 1
compute low all reduce min z
thermo_style custom step f_floor c_low
run 300"; } > later.in
engine 1 later.in
grep -E '^ +320 ' later.in.screen | awk '{ n = $2 > 100 && $3 > -0.0195001 } END { exit !n }' || die "a wall between two runs"
awk 'BEGIN { printf "rods\n\n30 atoms\n1 atom types\n-0.021 0.021 xlo xhi\n-0.00125 0.00125 ylo yhi\n-0.021 0.021 zlo zhi\n\nAtoms # sphere\n\n"
  for (i = 0; i < 30; i++) { k = i % 3 - 1; printf "%d 1 1e-3 2500 %.17g %.17g %.17g\n", i + 1, 3.6e-3 * (int(i / 3) - 4.5) + 1e-4 * k, 0.99e-3 * k, -0.012 + 1e-4 * k }
  printf "\nMols\n\n"; for (i = 0; i < 30; i++) print i + 1, int(i / 3) + 1 }' > data
{ start "f p f"; go_on rigid/small; echo "velocity all set 0 0 -1.5
fix lo all wall/rebound zplane -0.02 rebound constant 1 1
timestep 2e-5
thermo 100
run 600"; } > rods.in
engine 2 rods.in
energies rods.in.screen | awk '{ e = $3 + $4; if (NR == 1) first = e; if ((e / first - 1) ^ 2 > 1e-18) bad = 1; if ($4 > 1e-7) turns = 1 } END { exit bad || !turns }' || die "rods of more than half a period"

# Rods that turn far in a step: a warning where their fix adds to their energy.
rigid_data 5 "-2e-3 0 0 5e-4 -1e-3 0 0 5e-4 0 0 0 5e-4 1e-3 0 0 5e-4 2e-3 0 0 5e-4" > data
for style in rigid/small rigid/nve/small; do
  { start; go_on $style; echo "set group all omega 1000 2000 -1500
fix floor all wall/rebound zplane -0.02 rebound constant 1 1
timestep 2e-5
run 1"; } > turn.in
  engine 2 turn.in
  warnings=$(grep -c "bodies turn so far in a step .* use fix rigid/nve/small, or a time step" turn.in.screen || true)
  [ "$warnings" = "$([ $style = rigid/small ] && echo 1 || echo 0)" ] || die "$style: $warnings warnings of far turns"
done

# Nothing crosses a wall in steps of 100 diameters.
dumbbells 40 -0.012 > data
{ start; go_on rigid/small; echo "velocity all set 0.5 -0.8 -1.2"; closed surface sigma 10 rebound walton 0.9 0.3 0; echo "timestep 0.06
thermo 1
compute r all reduce max x y z
compute l all reduce min x y z
thermo_style custom step c_r[1] c_r[2] c_r[3] c_l[1] c_l[2] c_l[3]
run 20"; } > long.in
engine 1 long.in
grep -E '^ +[0-9]+( +[-+.0-9e]+){6} *$' long.in.screen | awk '{ n++; for (k = 2; k <= 7; k++) if ($k * $k > 0.0195001 ^ 2) bad = 1 } END { exit bad || n < 20 }' || die "a body has crossed a wall"

# What is refused: a law that bodies do not have, and fixes that walls cannot follow.
refuses() { # FIX, words of the wall, words of the fix, part of the message
  { start; go_on "$1" | sed "s/^fix bodies .*/&$3/; /^compute/d; /^thermo/d"; echo "thermo_style custom step atoms"; echo "fix floor all wall/rebound zplane -0.02 $2
timestep 2e-5
run 100"; } > bad.in
  ! timeout 60 mpirun -np 2 "$program" -in bad.in -log none -screen bad.screen > bad.beside 2>&1 || die "runs with: $1 $2"
  grep -q "$4" bad.screen bad.beside || die "$1 $2: $(tail -n 3 bad.screen)"
}
dumbbells 10 -0.012 > data
refuses rigid/small "rebound walton 0.9 0.3 0.4" "" "BETA0 0"
refuses rigid/nvt "rebound walton 0.9 0.3 0" " temp 1 1 1" "fix rigid/nvt (id bodies) .* rigid/small and rigid/nve/small can"
refuses rigid "rebound walton 0.9 0.3 0" "" "it must be rigid/small"
refuses rigid/nve "rebound walton 0.9 0.3 0" "" "it must be rigid/nve/small"
