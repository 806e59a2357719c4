#!/usr/bin/env bash
# What scripts of a user's own do: they set the step's number anew, in mid-run and after a restart; empty a group; and
# read in the log, and in messages, what the wall has taken and what it lacks.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
grains 300 > grains.data
plate 4 1 3.9e-3 > plate.stl
script() { # DATA LINES
  boundary='m m f' flying $1
  echo "fix plate all mesh/surface file plate.stl type 2
fix wall all wall/rebound mesh n_meshes 1 meshes plate surface rq 10e-6 lambda_c 90e-6 rebound bons deposit freeze seed 4 ledger 70 file rows.csv
fix high all wall/rebound primitive type 2 zplane 3.8e-4 surface rq 10e-6 lambda_c 90e-6 rebound constant 0.9 0.9 seed 4
timestep 2e-8
thermo_style custom step f_wall[1] f_wall[2] f_high[1]
thermo 100000"
  printf '%b\n' "$2"
}
end="\n$(pictures 1000000 end.txt)\nrun 0"
counts() { grep -E '^ +[0-9]+ +[0-9]+ +[0-9]+ +[0-9]+ *$' "$1.screen" | tail -n 1 | awk '{ print $2, $3, $4 }'; }
script grains.data "run 300$end" > whole.in
engine 1 whole.in
mv rows.csv whole.csv; tail -n 300 end.txt > whole.end
[ "$(count_rows whole.csv)" -gt 200 ] || die "too few impacts for this test"

# The step's number set to another one, back to 0, forward, and after a restart: the ledger, the places and the counters of
# the run that nothing disturbed.
continues() { # RANKS SCRIPT...
  local part ranks=$1; shift
  rm -f rows.csv
  for part; do engine $ranks $part.in; done
  same whole.csv rows.csv "the ledger of $part on $ranks ranks"
  same whole.end <(tail -n 300 end.txt) "places of $part"
  [ "$(counts whole.in)" = "$(counts $part.in)" ] || die "counters of $part: $(counts $part.in), and they must be $(counts whole.in)"
}
for now in 0 35 1000000000; do script grains.data "run 100\nreset_timestep $now\nrun 55\nreset_timestep 7\nrun 145$end" > reset.$now.in; done
script grains.data 'run 100\nwrite_restart a.restart\nrun 30' > first.in
script a.restart 'reset_timestep 0\nrun 90\nwrite_restart b.restart\nrun 10' > second.in
script b.restart "reset_timestep 12345\nrun 110$end" > third.in
continues 1 reset.0; continues 2 reset.35; continues 1 reset.1000000000
for ranks in 1 2; do continues $ranks first second third; done

# A group that loses its last grain in mid-run, and the same with none left at all (of which LIGGGHTS wants to know the
# type, as for those that are inserted).
for all in "group some id 1:50" "group some union all"; do
  script grains.data 'run 60\ndelete_atoms group some compress no\nrun 60\nrun 60' | sed "s/^fix wall all/$all\nfix wall some/
    s/^fix move.*/&\nfix later all particletemplate\/sphere 10007 atom_type 1 volume_limit 1e-20 density constant 2650 radius constant 5e-6\nfix sizes all particledistribution\/discrete 10009 1 later 1.0/" > empty.in
  [ $simulator = liggghts ] || sed -i '/^fix .* particle/d' empty.in
  engine 2 empty.in
  grep -qE '^ +180 ' empty.in.screen || die "a run with an empty group, $all, ends early"
done

# One type, and three: the advice names `materials` first, with a name for each.
one() { # TYPES CONSTANTS WALL
  head_of si
  echo "region box block 0 1e-3 0 1e-3 0 1e-3 units box
create_box $1 box
neighbor 1e-4 bin
create_atoms 1 single 5e-4 5e-4 5e-4 units box
set group all diameter 1e-5 density 2650
$2
fix move all nve/sphere
timestep 1e-8
fix wall all wall/rebound primitive type $1 zplane 0.0 $3
run 1
run 1"
}
for types in 1 3; do
  names=quartz values=7e10
  for ((k = 1; k < types; k++)); do names+=' hastelloy-x' values+=' 2.05e11'; done
  one $types '' '' > advice.in
  refuses 1 advice.in "youngsModulus; name a material for each atom type, as 'materials $names" \
    "$([ $simulator = lammps ] || echo ", or add a line such as 'fix youngsModulus all property/global youngsModulus peratomtype $values'")"
done

# The speed below which grains stick, in the log: by the wall's law, and by the other one with adhesion.
for law in bons thornton_ning; do
  one 2 "$(materials)" "rebound $law" > $law.in
  engine 1 $law.in
  grep -oE 'sticks below [^ ]+|\(by [a-z_]+ below [^ ]+' $law.in.screen | awk '{ print $NF }' | paste -sd' ' > $law.speeds
done
[ "$(awk '{ print $2, $1 }' bons.speeds)" = "$(cat thornton_ning.speeds)" ] && awk '{ exit !(NF == 2 && $1 > 0 && $2 > 0 && $1 != $2) }' bons.speeds ||
  die "speeds of sticking: bons $(cat bons.speeds), thornton_ning $(cat thornton_ning.speeds)"

# The speed above which grains yield, in the log: sigma_y/sqrt(rho E_c), 1/E_c = (1 - nu_p^2)/E_p + (1 - nu_w^2)/E_w; and
# a warning where a soft modulus keeps them from yielding.
while IFS='|' read -r name young poisson yield words at warnings; do
  one 2 "$(materials | sed "s/\(^fix m1.*peratomtype\).*/\1 $young/; s/\(^fix m2.*peratomtype\).*/\1 $poisson/; s/\(^fix m3.*peratomtype\).*/\1 $yield 3e8/")" "$words" > $name.in
  engine 1 $name.in
  grep -q "type 1 on a wall of type 2: yields above $at .*along the normal" $name.in.screen || die "$name: not 'yields above $at': $(grep yields $name.in.screen)"
  [ "$(grep -acE "WARNING.*id wall.*nothing yields" $name.in.screen || true)" = $warnings ] || die "$name: not $warnings warnings that nothing yields"
done << END
hard|70e9 205e9|0.17 0.32|2e8||$(awk 'BEGIN { printf "%.4g", 2e8 / sqrt(2650 / ((1 - 0.17 ^ 2) / 70e9 + (1 - 0.32 ^ 2) / 205e9)) }')|0
soft|5e6 5e6|0.3 0.3|2e8||$(awk 'BEGIN { printf "%.4g", 2e8 / sqrt(2650 / (2 * (1 - 0.3 ^ 2) / 5e6)) }')|1
named|5e6 5e6|0.3 0.3|2e8|materials quartz hastelloy-x|$(awk 'BEGIN { printf "%.4g", 2e8 / sqrt(2650 / ((1 - 0.17 ^ 2) / 70e9 + (1 - 0.32 ^ 2) / 205e9)) }')|0
hot|70e9 205e9|0.17 0.32|2e8|rebound bons temperature 1700|$(awk 'BEGIN { printf "%.4g", 0.425e8 / sqrt(2650 / ((1 - 0.17 ^ 2) / 70e9 + (1 - 0.32 ^ 2) / 205e9)) }')|0
END
grep -a 'nothing yields' soft.in.screen | grep -q "type 1 on a wall of type 2.*2e+08.*'materials'" || die "the warning of a soft modulus"
grep -aq "1700 K the yield stress is 0.2125" hot.in.screen || die "hot: no softened yield stress in the log"

# What is printed is out at once, also into a pipe: mpirun ends a rank soon after another has ended with an error.
printf 'print "this is out"\nshell "kill -9 $PPID"\nprint "never"\n' > killed.in
"$program" -in killed.in -log none < /dev/null 2>&1 | cat > killed.screen || true
grep -q '^this is out' killed.screen && ! grep -q '^never' killed.screen || { cat killed.screen; die "a line that was printed is lost"; }
