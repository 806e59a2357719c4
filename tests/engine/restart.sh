#!/usr/bin/env bash
# A restart in the middle changes nothing: impacts, their numbers and draws, stuck particles, counters; on
# another number of ranks too. And `dump local` prints each impact once, as the file has it.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
wall='fix plate all mesh/surface file plate.stl type 2
fix low all wall/rebound mesh n_meshes 1 meshes plate surface rq 10e-6 lambda_c 90e-6 rebound bons deposit freeze seed 4 ledger 60 file ${out}
fix high all wall/rebound primitive type 2 zplane 3.8e-4 surface rq 10e-6 lambda_c 90e-6 rebound constant 0.9 0.9 seed 4
fix move all nve/sphere
thermo_style custom step f_low[1] f_low[2] f_low[3] f_low[4] f_high[1]
thermo 1000
thermo_modify format float %.15g
timestep 2e-8'
grains 400 > grains.data
plate 6 1 3.9e-3 > plate.stl
{ head_of si | sed 's/boundary.*/boundary m m f/'; echo 'read_data grains.data
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all'; materials; echo "$wall
dump rows all local 60 rows.*.txt f_low[1] f_low[2] f_low[3] f_low[11] f_low[17] f_low[19]
dump_modify rows format \"%.0f %.0f %.10g %.10g %.10g %.0f\"
dump other all local 120 other.*.txt f_low[1]
dump end all custom 1000 end.txt id x y z vx vy vz
dump_modify end format \"%d %.17g %.17g %.17g %.17g %.17g %.17g\" sort id
run \${first}
write_restart half.restart
run \${second}"; } > whole.in
{ head_of si | sed 's/boundary.*/boundary m m f/'; echo 'read_restart half.restart
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all'; materials; echo "$wall
dump end all custom 1000 end.txt id x y z vx vy vz
dump_modify end format \"%d %.17g %.17g %.17g %.17g %.17g %.17g\" sort id
run 900"; } > rest.in

engine 2 whole.in -var out whole.csv -var first 100 -var second 900
cp end.txt whole.end; cp whole.in.screen whole.screen
set -- $(grep -E '^ +1000 ' whole.screen | tail -n 1)
[ "$6" -gt 20 ] || die "too few impacts on the second wall for this test: $6"

[ "$(rows whole.csv | awk -F, '$3 > 200e-8' | wc -l)" -gt 50 ] || die "too few impacts after the restart for this test"

# dump local, each row once; a second dump does not disturb it.
cat rows.*.txt | awk 'NF == 6 && !/ITEM/ { sub("nan", "", $5); print $1 "," $2 "," $3 "," $4 "," $5 "," $6 }' | sort > dumped
rows whole.csv | awk -F, -v OFS=, '$3 <= 1920e-8 { print $1, $2, $3, $11, $17, $19 }' | sort > written
same dumped written "dump local and file"

for ranks in 1 2; do
  rm -f part.csv
  engine 2 whole.in -var out part.csv -var first 100 -var second 0
  engine $ranks rest.in -var out part.csv
  same whole.csv part.csv "one run and a restart on $ranks ranks"
  tail -n 400 whole.end > a; tail -n 400 end.txt > b
  same a b "final positions"
  [ "$(grep -E '^ +1000 ' whole.screen | tail -n 1)" = "$(grep -E '^ +1000 ' rest.in.screen | tail -n 1)" ] ||
    die "counters: $(grep -hE '^ +1000 ' whole.screen rest.in.screen)"
done

# A script that differs from the restart file is taken, and a warning says in what; so does a wall that the
# file knows nothing of.
sed 's/surface rq 10e-6 lambda_c 90e-6 rebound bons deposit freeze seed 4/surface rq 12e-6 lambda_c 90e-6 spread truncated isotropic rebound bons yield_rate 3e6 deposit delete seed 5 materials quartz hastelloy-x/; s/zplane 3.8e-4/zplane 3.9e-4/; s/constant 0.9 0.9/constant 0.9 0.8/; s/^run 900/run 1/; s/^thermo 1000/&\nthermo_modify lost ignore/' rest.in > other.in
engine 2 other.in -var out other.csv
differs() { # WALL WORD...
  local wall=$1; shift
  grep -a "WARNING.*id $wall" other.in.screen > warning || die "no warning of a changed script"
  for word in "the script is taken" "$@"; do
    grep -qF -- "$word" warning || { cat warning; die "'$word' is not in the warning"; }
  done
}
differs low "seed 5, was 4" "rq 1.2e-05 lambda_c 9e-05, was rq 1e-05" "materials quartz hastelloy-x, was $([ $simulator = liggghts ] && echo none || echo own1)" \
  "spread truncated isotropic collisions multiple, was visible isotropic collisions multiple" "deposit delete, was freeze" \
  "rebound bons yield_rate 3000000, was bons"
differs high "geometry " "zplane 0.00039" ", was " "zplane 0.00038" \
  "rebound constant 0.9 0.8, was constant 0.9 0.9"
! grep -aE 'WARNING.*script differs' rest.in.screen || die "a warning about a script that is the same"
sed 's/^fix high all/fix new all/; s/f_high/f_new/; s/^run 900/run 1/' rest.in > unknown.in
engine 2 unknown.in -var out other.csv
grep -a 'WARNING.*id new' unknown.in.screen | grep -q 'no data of this wall' || die "no warning of a wall without data"
