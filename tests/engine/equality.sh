#!/usr/bin/env bash
# The same case in LIGGGHTS and in LAMMPS: equal to the byte, in free flight, are ledgers, counters, and where particles
# are at the end; from a restart on another number of ranks too.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
grains 900 > grains.data
rough='surface rq 10e-6 lambda_c 90e-6 spread weibull isotropic collisions multiple'
physics="materials quartz hastelloy-x $rough"

# All that a description has for such a wall, word for word in both, over LIGGGHTS's own constants.
description='surface sigma 6deg spread truncated plane collisions single rebound bons contact_area 0.1 0.15 0.4
 temperature 800C soften 1000 0.001/K friction 0.4 surface_energy 100mJ/m2 yield_stress 150MPa
 materials quartz hastelloy-x deposit freeze remove u_tau 2cm/s gas_density 1.2kg/m3 gas_viscosity 15mm2/s seed 6'

plane() { # ID, primitive with its numbers, keywords: a wall of type 2
  echo "fix $1 all wall/rebound primitive type 2 $2 $physics $3"
}
deck() { # where particles come from, walls, runs
  head_of si | sed 's/boundary.*/boundary m m m/'
  echo "$1
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all"
  materials
  echo "fix move all nve/sphere
timestep 1e-8
$2
thermo_style custom step f_low[1] f_low[2] f_low[3] f_low[4] f_low[6]
thermo 1000
thermo_modify format float %.15g lost ignore
dump end all custom 400 end.*.txt id x y z vx vy vz
dump_modify end format \"%d %.17g %.17g %.17g %.17g %.17g %.17g\" sort id
$3"
}
# both NAME RANKS: runs NAME.in in each engine, in its folder.
both() {
  local each
  for each in liggghts lammps; do
    mkdir -p $each
    (use $each; cd $each; cp "../$1.in" .; engine "$2" "$1.in")
  done
}
equal() { # TEXT: what both have left is the same
  local simulator
  for simulator in liggghts lammps; do
    sed -n 's/ *$//; 10,$p' $simulator/end.400.txt > $simulator/end
    grep -haE '^ +400 ' $simulator/*.screen | tail -n 1 > $simulator/counters
  done
  local file
  for file in $(cd liggghts; ls ./*.csv) end; do same liggghts/$file lammps/$file "LIGGGHTS and LAMMPS, $1"; done
  paste -d' ' liggghts/counters lammps/counters | awk '{ half = NF / 2; for (i = 1; i <= half; i++) if ($i != $(i + half)) exit 1 } END { exit half != 6 || NR != 1 }' ||
    die "counters, $1: $(cat liggghts/counters lammps/counters)"
  rm -rf liggghts lammps
}
scene() { # NAME, walls, runs, where particles come from
  deck "${4:-read_data ../grains.data}" "$($2)" "$3" > "$1.in"
}
freeze() { plane low 'zplane 0.0' 'deposit freeze seed 5 ledger 100 file low.csv'; }
delete() { echo "fix low all wall/rebound primitive type 2 zplane 0.0" $description "ledger 70 file low.csv"; }
two() {
  echo "fix low all wall/rebound primitive type 2 zplane 0.0 shear x 3. $rough deposit off seed 7 rebound constant 0.95 0.9 ledger 50 file low.csv"
  plane high 'zplane 2e-4' 'deposit off seed 7 ledger 50 file high.csv'
}
mesh() { # KEYWORDS: a wall of triangles of type 2
  echo "fix plate all mesh/surface file ../plate.stl type 2
fix low all wall/rebound mesh n_meshes 1 meshes plate $physics $1"
}
flat() { mesh 'deposit freeze seed 9 ledger 100 file low.csv'; }
pipe() { plane low 'xcylinder 2e-3 1.5e-3 1.99e-3 shear x 11.' 'deposit freeze seed 8 ledger 100 file low.csv'; }

plate 5 1 3.9e-3 > plate.stl

for case in freeze delete two pipe flat; do
  scene $case $case 'run 150
run 250'
  for ranks in 2 4; do
    [ $ranks != 4 ] || [ $case = flat ] || continue
    both $case $ranks
    [ "$(count_rows lammps/low.csv)" -ge 100 ] || die "$case: only $(count_rows lammps/low.csv) impacts"
    equal "$case on $ranks ranks"
  done
done

# From two ranks to one, and the other way round.
for case in two flat; do
  scene whole $case 'run 150
write_restart half.restart'
  scene rest $case 'run 250' 'read_restart half.restart'
  scene $case $case 'run 400'
  for ranks in 1 2; do
    both whole $((3 - ranks))
    both rest $ranks
    cp -r lammps restarted.$ranks
    equal "$case, restarted on $ranks ranks"
  done
  both $case 1
  for ranks in 1 2; do
    for file in lammps/*.csv; do same "$file" restarted.$ranks/"$(basename "$file")" "one run and a restart on $ranks ranks"; done
  done
  equal "$case in one run"
  rm -r restarted.*
done
