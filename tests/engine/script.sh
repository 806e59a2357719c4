#!/usr/bin/env bash
# What scripts of a user's own do: they set the step's number anew, in mid-run and after a restart; empty a group; and
# read in the log, and in messages, what the wall has taken and what it lacks.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
grains 300 > grains.data
plate 4 1 3.9e-3 > plate.stl
wall='fix wall all wall/rebound mesh n_meshes 1 meshes plate surface rq 10e-6 lambda_c 90e-6 rebound bons deposit freeze seed 4 ledger 70 file rows.csv'
script() { # beginning, end
  head_of si | sed 's/boundary.*/boundary m m f/'; echo "$1
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all"; materials; echo "fix plate all mesh/surface file plate.stl type 2
$wall
fix high all wall/rebound primitive type 2 zplane 3.8e-4 surface rq 10e-6 lambda_c 90e-6 rebound constant 0.9 0.9 seed 4
fix move all nve/sphere
timestep 2e-8
thermo_style custom step f_wall[1] f_wall[2] f_high[1]
thermo 100000
$2"
}
begin='read_data grains.data' places='dump end all custom 1000000 end.txt id x y z vx vy vz
dump_modify end sort id format "%d %.17g %.17g %.17g %.17g %.17g %.17g"'
counts() { grep -E '^ +[0-9]+ +[0-9]+ +[0-9]+ +[0-9]+ *$' "$1.screen" | tail -n 1 | awk '{ print $2, $3, $4 }'; }
script "$begin" "run 300
$places
run 0" > whole.in
engine 1 whole.in
mv rows.csv whole.csv; tail -n 300 end.txt > whole.end
[ "$(count_rows whole.csv)" -gt 200 ] || die "too few impacts for this test"
# continues NAME: the ledger, the places and the counters of the run that nothing disturbed.
continues() {
  tail -n 300 end.txt > now.end
  same whole.csv rows.csv "the ledger, $1"
  same whole.end now.end "places, $1"
  [ "$(counts whole.in)" = "$(counts "$2")" ] || die "counters, $1: $(counts "$2"), and they must be $(counts whole.in)"
}

# The step's number set to another one: back to 0, forward, and after a restart.
for now in 0 35 1000000000; do
  script "$begin" "run 100
reset_timestep $now
run 55
reset_timestep 7
run 145
$places
run 0" > reset.in
  for ranks in 1 2; do
    rm -f rows.csv
    engine $ranks reset.in
    continues "reset_timestep $now on $ranks ranks" reset.in
  done
done
script "$begin" "run 100
write_restart a.restart
run 30" > first.in
script 'read_restart a.restart' "reset_timestep 0
run 90
write_restart b.restart
run 10" > second.in
script 'read_restart b.restart' "reset_timestep 12345
run 110
$places
run 0" > third.in
for ranks in 1 2; do
  rm -f rows.csv
  for part in first second third; do engine $ranks $part.in; done
  continues "reset_timestep after restarts on $ranks ranks" third.in
done

# A group that loses its last grain in mid-run, and the same with none left at all (of which LIGGGHTS wants to know the
# type, as for those that are inserted).
for all in "group some id 1:50" "group some union all"; do
  script "$begin" "" | sed "s/^fix wall all/$all\nfix wall some/
    s/^fix move.*/&\nfix later all particletemplate\/sphere 10007 atom_type 1 volume_limit 1e-20 density constant 2650 radius constant 5e-6\nfix sizes all particledistribution\/discrete 10009 1 later 1.0/" > empty.in
  [ $simulator = liggghts ] || sed -i '/^fix .* particle/d' empty.in
  echo "run 60
delete_atoms group some compress no
run 60
run 60" >> empty.in
  for ranks in 1 2; do
    rm -f rows.csv
    engine $ranks empty.in
    grep -qE '^ +180 ' empty.in.screen || die "a run with an empty group, $all, ends early"
  done
done

# One type, and three: the advice names `materials` first, with a name for each.
for types in 1 3; do
  names=$(awk -v n=$types 'BEGIN { s = "quartz"; while (--n) s = s " hastelloy-x"; print s }')
  values=$(awk -v n=$types 'BEGIN { s = "7e10"; while (--n) s = s " 2.05e11"; print s }')
  { head_of si; echo "region box block 0 1e-3 0 1e-3 0 1e-3 units box
create_box $types box
neighbor 1e-4 bin
create_atoms 1 single 5e-4 5e-4 5e-4 units box
set group all diameter 1e-5 density 2650
fix move all nve/sphere
fix wall all wall/rebound primitive type $types zplane 0.0
run 1"; } > advice.in
  if "$program" -in advice.in -log none > advice.screen 2>&1; then die "no constants, and accepted"; fi
  grep -a '^ERROR' advice.screen > advice || die "no error message"
  line=", or add a line such as 'fix youngsModulus all property/global youngsModulus peratomtype $values'"
  [ $simulator = liggghts ] || line=''
  grep -aqE "youngsModulus; name a material for each atom type, as 'materials $names' .*$line" advice ||
    { cat advice; die "the advice for $types types"; }
done

# The speed above which grains yield, in the log: sigma_y/sqrt(rho E_c), 1/E_c = (1 - nu_p^2)/E_p + (1 - nu_w^2)/E_w; and
# a warning where a soft modulus keeps them from yielding.
one() { # Young's modulus, Poisson's ratio, yield stress of both types
  head_of si
  echo "region box block 0 1e-3 0 1e-3 0 1e-3 units box
create_box 2 box
neighbor 1e-4 bin
create_atoms 1 single 5e-4 5e-4 5e-4 units box
set group all diameter 1e-5 density 2650
$(materials | sed "s/\(^fix m1.*peratomtype\).*/\1 $1/; s/\(^fix m2.*peratomtype\).*/\1 $2/; s/\(^fix m3.*peratomtype\).*/\1 $3/")
fix move all nve/sphere
timestep 1e-8
fix wall all wall/rebound primitive type 2 zplane 0.0 ${4:-}
run 1
run 1"
}
yields() { sed -n 's/.*type 1 on a wall of type 2: yields above \([^ ]*\) along the normal.*/\1/p' "$1.screen"; }
v_y() { awk -v ep="$1" -v ew="$2" -v np="$3" -v nw="$4" -v s="$5" 'BEGIN { e = 1 / ((1 - np * np) / ep + (1 - nw * nw) / ew); printf "%.4g", s / sqrt(2650 * e) }'; }
one "70e9 205e9" "0.17 0.32" "2e8 3e8" > hard.in
one "5e6 5e6" "0.3 0.3" "2e8 2e8" > soft.in
one "5e6 5e6" "0.3 0.3" "2e8 2e8" "materials quartz hastelloy-x" > named.in
for name in hard soft named; do engine 1 $name.in; done
[ "$(yields hard.in)" = "$(v_y 70e9 205e9 0.17 0.32 2e8)" ] || die "yields above '$(yields hard.in)', and it must be $(v_y 70e9 205e9 0.17 0.32 2e8)"
[ "$(yields soft.in)" = "$(v_y 5e6 5e6 0.3 0.3 2e8)" ] || die "soft: yields above '$(yields soft.in)'"
[ "$(yields named.in)" = "$(yields hard.in)" ] || die "named: yields above '$(yields named.in)'"
one "70e9 205e9" "0.17 0.32" "2e8 3e8" "rebound bons temperature 1700" > hot.in
engine 1 hot.in
[ "$(yields hot.in)" = "$(v_y 70e9 205e9 0.17 0.32 0.425e8)" ] || die "hot: yields above '$(yields hot.in)'"
grep -aq "1700 K the yield stress is 0.2125" hot.in.screen || die "hot: no softened yield stress in the log"
warned() { grep -ac 'WARNING.*id wall.*nothing yields' "$1.screen" || true; }
[ "$(warned soft.in)" = 1 ] || die "soft: $(warned soft.in) warnings that nothing yields"
for word in "type 1 on a wall of type 2" "2e+08" "'materials'"; do
  grep -a 'nothing yields' soft.in.screen | grep -qF -- "$word" || { grep -a 'nothing yields' soft.in.screen; die "'$word' is not in the warning"; }
done
[ "$(warned hard.in) $(warned named.in)" = "0 0" ] || die "a warning of moduli that are not soft"

# What is printed is out at once, also into a pipe: mpirun ends a rank soon after another has ended with an error.
printf 'print "this is out"\nshell "kill -9 $PPID"\nprint "never"\n' > killed.in
"$program" -in killed.in -log none < /dev/null 2>&1 | cat > killed.screen || true
grep -q '^this is out' killed.screen && ! grep -q '^never' killed.screen || { cat killed.screen; die "a line that was printed is lost"; }
