#!/usr/bin/env bash
# The same case in LIGGGHTS and in LAMMPS: equal to the byte, in free flight, are ledgers, counters, and where particles
# are at the end; from a restart on another number of ranks too.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
grains 900 > grains.data
plate 5 1 3.9e-3 > plate.stl
rough='surface rq 10e-6 lambda_c 90e-6 spread weibull isotropic collisions multiple'
physics="materials quartz hastelloy-x $rough"
primitive='all wall/rebound primitive type 2'
# All that a description has for such a wall, word for word in both, over LIGGGHTS's own constants.
description='surface sigma 6deg spread truncated plane collisions single rebound bons contact_area 0.1 0.15 0.4
 temperature 800C soften 1000 0.001/K soften_modulus exp 3e20Pa 0.02365/K wall_temperature 700C friction 0.4 surface_energy 100mJ/m2 adhesion 0.5 adhesion_spread 2 yield_stress 150MPa scatter 0.3
 materials quartz hastelloy-x deposit freeze viscosity critical 1e5P watt 60 20 8 8 4 remove u_tau 2cm/s gas_density 1.2kg/m3 gas_viscosity 15mm2/s seed 6'
declare -A walls=(
  [freeze]="fix low $primitive zplane 0.0 $physics deposit freeze seed 5 ledger 100 file low.csv"
  [words]="fix low $primitive zplane 0.0 ${description//$'\n'/} ledger 70 file low.csv"
  [two]="fix low $primitive zplane 0.0 shear x 3. $rough deposit off seed 7 rebound constant 0.95 0.9 ledger 50 file low.csv
fix high $primitive zplane 2e-4 $physics deposit off seed 7 ledger 50 file high.csv"
  [pipe]="fix low $primitive xcylinder 2e-3 1.5e-3 1.99e-3 shear x 11. $physics deposit freeze seed 8 ledger 100 file low.csv"
  [flat]="fix plate all mesh/surface file ../plate.stl type 2
fix low all wall/rebound mesh n_meshes 1 meshes plate $physics deposit freeze seed 9 ledger 100 file low.csv")
scene() { # WALLS DATA RUNS
  boundary='m m m' flying $2
  echo "timestep 1e-8
${walls[$1]}
thermo_style custom step f_low[1] f_low[2] f_low[3] f_low[4] f_low[6]
thermo 1000
thermo_modify format float %.15g lost ignore
$(pictures 400 end.txt)"
  printf '%b\n' "$3"
}
# both NAME RANKS [CLEAN]: in each engine, in its folder, what both leave is the same.
both() {
  local each file
  for each in liggghts lammps; do
    mkdir -p $each
    (use $each; cd $each; cp "../$1.in" .; engine "$2" "$1.in"
     tail -n 900 end.txt | sed 's/ *$//' > end; grep -haE '^ +400 ' $1.in.screen | tail -n 1 | tr -s " " | sed 's/ $//' > counters || true)
  done
  for file in $(cd liggghts; ls ./*.csv) $([ "${3:-}" ] || echo end counters); do same liggghts/$file lammps/$file "LIGGGHTS and LAMMPS, $1 on $2 ranks"; done
}
for case in freeze words two pipe flat; do
  scene $case ../grains.data 'run 150\nrun 250' > $case.in
  both $case 2
  [ "$(count_rows lammps/low.csv)" -ge 100 ] || die "$case: only $(count_rows lammps/low.csv) impacts"
  rm -r liggghts lammps
done

# From two ranks to one, and the other way round.
for case in two flat; do
  scene $case ../grains.data 'run 400' > $case.in
  scene $case ../grains.data 'run 150\nwrite_restart half.restart' > half.in
  scene $case half.restart 'run 250' > rest.in
  both $case 1
  mv lammps whole; rm -r liggghts
  [ $case = two ] && ranks=1 || ranks=2
  both half $((3 - ranks)) part
  both rest $ranks
  for file in $(cd whole; ls ./*.csv) end; do same whole/$file lammps/$file "$case in one run, and a restart on $ranks ranks"; done
  rm -r whole liggghts lammps
done
