#!/usr/bin/env bash
# The engine applies the law: the smooth wall against `asperity cor`; and the odd cases: `timing
# overlap`, a center exactly on the wall, a step that takes the center across it, a resting contact.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
deck() { # file, wall options, step, steps
  head_of si
  echo "read_data $1
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all"
  materials
  echo "fix move all nve/sphere
timestep $3
fix wall all wall/rebound primitive type 2 zplane 0.0 $2 ledger $4 file out.csv
thermo_style custom step atoms f_wall f_wall[2] f_wall[6]
thermo $4
thermo_modify lost error
run $4"
}
last() { grep -E "^ +$1 " run.in.screen | tail -n 1; }

# The Bons law, against the command, for 60 grains of their own size, speed and angle.
grains 60 > grains.data
deck grains.data 'surface smooth' 1e-8 400 > run.in
engine 2 run.in
rows out.csv | while IFS=, read -r -a f; do
  "$bin/asperity" cor --dp "${f[8]}" --speed "${f[9]}" --angles "${f[10]}" --samples 1 | tail -n 1
done | awk -F, '{ print ($10 == "deposit") "," $8 "," $9 }' > command.csv
rows out.csv | awk -F, '{ print ($19 == 1) "," $17 "," $18 }' > ledger.csv
near ledger.csv command.csv "1 2 3" 2e-5

# Steps far too large: every grain crosses the wall within one, some by many diameters; none is lost, and
# none was in the wall before.
deck grains.data "surface smooth rebound constant 1 1 deposit off" 2e-7 20 > run.in
engine 2 run.in
[ "$(count_rows out.csv)" = 60 ] || die "$(count_rows out.csv) impacts of 60 grains"
set -- $(last 20)
[ "$5" = 0 ] || die "$5 guarded contacts"

# A center exactly on the wall, moving on: it came from above, goes back there, and is a number all the way.
cat > one.data << 'END'
one

1 atoms
2 atom types

-0.001 0.001 xlo xhi
-0.001 0.001 ylo yhi
-0.001 0.001 zlo zhi

Atoms

1 1 1e-5 2650 0 0 1e-6

Velocities

1 0 0 -100 0 0 0
END
sed -i 's/ 1e-6$/ 0/' one.data
deck one.data "surface smooth rebound constant 1 1 deposit off" 1e-8 100 > run.in
engine 1 run.in
check_rows out.csv '$17 > 0.999 && $17 < 1.001 && $8 >= -1e-12' "center on the wall"
set -- $(last 100)
[ "$3" = 1 ] && [ "$5" = 1 ] || die "center on the wall: impacts $3, guarded $5"

# Gravity presses a grain on a wall that takes no deposits: it bounces lower and lower and stays above.
deck one.data 'surface smooth rebound constant 0.2 1 deposit off' 1e-7 3000 | sed 's/^fix move/fix g all gravity 1e5 vector 0 0 -1\nfix move/' > run.in
sed -i 's/2650 0 0 0$/2650 0 0 1e-5/; s/ -100 0 0 0/ -1 0 0 0/' one.data
engine 1 run.in
check_rows out.csv '$8 > 0.999 * $9 / 2 && $11 > 0 && $17 >= 0' "the grain sinks into the wall"
