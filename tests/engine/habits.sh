#!/usr/bin/env bash
# Habits of users of LAMMPS's walls: numbers of each atom for dumps and other fixes; planes in the words of fix wall/gran.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
use lammps
program=$bin/lammps-asperity
plate 2 1 2e-3 > plate.stl
scene="units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
region box block -0.003 0.003 -0.003 0.003 -0.003 0.003 units box
create_box 2 box
neighbor 2e-5 bin
pair_style none
create_atoms 1 single 1e-3 1e-3 1.05e-4 units box
create_atoms 1 single 5e-4 5e-4 2e-3 units box
set group all diameter 1e-5 density 2650
fix move all nve/sphere
timestep 1e-6"

# Impacts and whether it is stuck, of each atom, also as a variable's and a compute's input.
cat > atoms.in << END
$scene
velocity all set 0 0 -1 units box
fix wall all wall/rebound stl plate.stl type 2 materials quartz hastelloy-x surface_energy 1e4
fix fly all wall/rebound zplane -1e-3 rebound constant 0.5 0.5 deposit off
compute most all reduce max f_wall[1] f_wall[2]
fix state all store/state 1 f_wall[2]
variable stuck atom f_state==1
variable stuck_now equal count(stuck)
group stuck dynamic all var stuck every 1
thermo_style custom step c_most[1] c_most[2] f_wall f_wall[2] v_stuck_now
dump rows all custom 150 rows.txt id f_wall[1] f_wall[2] f_fly[1]
dump_modify rows sort id
run 150
END
for ranks in 1 2; do
  engine $ranks atoms.in
  [ "$(tail -n 2 rows.txt | tr -s ' \n' ' ;')" = "1 1 1 0;2 0 0 0;" ] || { tail -n 2 rows.txt; die "numbers of each atom"; }
  grep -Eq '^ +150 +1 +1 +1 +1 +1 *$' atoms.in.screen || die "their maxima and the counters: $(grep -E '^ +150 ' atoms.in.screen)"
done

# Planes in the words of fix wall/gran.
for second in NULL 100; do
  printf '%s\n' "$scene" "fix wall all wall/rebound zplane 0 $second rebound constant 1 1" "run 1" > refused.in
  refuses 1 refused.in "'$second' stands behind 'zplane 0 type 2'" "a fix of its own"
done
