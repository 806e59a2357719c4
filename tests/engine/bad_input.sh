#!/usr/bin/env bash
# Bad scripts: one clear message that names the thing, its value and what it must be, on one rank or on two in turn,
# and a non-zero exit; for a step that is too large a warning with the largest safe one. The words of a description are
# tested in unit/test_description.c.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
plate 2 1 1.9e-3 > plate.stl
materials > materials.in
deck() { # fix command behind "fix wall", lines before it
  head_of ${units:-si}
  echo "region box block -0.002 0.002 -0.002 0.002 -0.001 0.002 units box
create_box 2 box
neighbor 1e-4 bin
create_atoms 1 single 0 0 1e-3 units box
set group all diameter 1e-5 density 2650
velocity all set 10 0 ${speed:--10} units box
group nobody id 77
fix plate all mesh/surface file plate.stl type 2
fix move all nve/sphere
timestep ${step:-1e-7}
include materials.in
${2:-}
fix wall ${1}
run 1
run 1"
}
edit=''  # what sed makes of a script
plane='all wall/rebound primitive type 2 zplane 0.0'
mesh='all wall/rebound mesh n_meshes 1 meshes plate'

# refuses COMMAND LINES WORD...: it ends with an error whose one line has every word. Two at a time.
refuses() {
  local command=$1 lines=$2; shift 2
  number=$((number + 1))
  while [ "$(jobs -rp | wc -l)" -ge 2 ]; do wait -n || true; done
  (mkdir bad.$number; cd bad.$number; ln -s ../plate.stl ../materials.in .
   export OMPI_MCA_orte_tmpdir_base=$PWD # see engine.sh
   deck "$command" "$lines" | sed -e "$edit" > bad.in
   refused "$command $lines" $((number % 2 + 1)) "$@") > bad.$number.log 2>&1 || touch bad.$number.failed &
}
refused() {
  local what=$1 ranks=$2 launch=(); shift 2
  [ $ranks = 1 ] || launch=(mpirun -np $ranks)
  if "${launch[@]}" "$program" -in bad.in -log none > bad.screen 2>&1; then die "accepted: $what"; fi
  grep -a '^ERROR' bad.screen > bad.error || { tail bad.screen; die "no error message for: $what"; }
  [ "$(wc -l < bad.error)" = 1 ] || { cat bad.error; die "more than one message on $ranks ranks: $what"; }
  for word in "$@"; do grep -aqF -- "$word" bad.error || { cat bad.error; die "'$word' is not in the message for: $what"; }; done
  ! grep -aqi -e 'segmentation' -e 'signal 11' bad.screen || die "crash: $what"
}
all_refused() {
  wait
  ! ls bad.*.failed > /dev/null 2>&1 || { for f in bad.*.failed; do cat "${f%failed}log"; done; die "some bad scripts were not refused as they should be"; }
}
number=0

refuses "$plane surfaces smooth" "" "'surfaces'" "surface" "ledger"
refuses "$plane surface rq 1e-5 lambda_c 1e-4 1e-3 lay axial" "" "lay is an angle" "X Y Z"
refuses "all wall/rebound primitive type 2 zcylinder 1e-3 0 0 surface rq 1e-5 lambda_c 1e-4 1e-3 lay 1 0 0" "" "lay is a vector" "axial"
refuses "$plane ledger 0" "" "ledger is 0" "1 to"
refuses "$plane ledger 10 rows.csv" "" "behind 'ledger', 'file rows.csv' is expected"
refuses "$plane ledger 10 file /nowhere/at/all.csv" "" "/nowhere/at/all.csv" "No such file"
refuses "$mesh" "run_style respa 2 2" "respa"
refuses "$plane
minimize 0 0 1 1" "" "minimize"
printf 'name,youngs_modulus_pa,poissons_ratio,density_kg_m3\nbrass,1e11,0.35,8500\n' > brass.csv
refuses "$plane materials" "" "materials has 0 names" "2 atom types"
refuses "$plane materials quartz surface smooth" "" "materials has 1 names" "2 atom types"
refuses "$plane columns full ledger 10" "" "'columns' belongs behind 'ledger'"
refuses "$plane materials quartz quartz hastelloy-x file ../brass.csv" "" "materials has 3 names" "2 atom types"
refuses "$plane deposit freeze remove gas_density 1.2 gas_viscosity 1.5e-5" "" "'u_tau U' is expected"
refuses "$plane materials quartz kryptonite file ../brass.csv" "" "'kryptonite'" "hastelloy-x" "brass"
refuses "$plane materials hastelloy-x quartz" "" "'hastelloy-x'" "type 1" "no yield stress" "yield_rate"
. "$here/bad_input_$simulator.sh"
all_refused

# Not needed, not asked for: a law without materials, a wall without deposits, a rate instead of a stress.
accepts() {
  deck "$1" "$2" > good.in
  engine 2 good.in
}
accepts "$plane rebound constant 1 1" "unfix m3
unfix m4"
accepts "$plane deposit off" "unfix m4"
accepts "$plane rebound bons yield_rate 3e6" "unfix m3"
accepts "$plane materials hastelloy-x hastelloy-x rebound bons yield_rate 3e6" "unfix m3
unfix m4"
accepts "$mesh ledger 10 file rows.csv" ""
accepts "nobody wall/rebound primitive type 2 zplane 0.0" ""

# Steps in which the grain moves more than its radius, 5 um: a warning, once, with the largest safe step.
speed=-100 step=1e-7
for wall in "$plane" "$mesh"; do
  accepts "$wall" ""
  [ "$(grep -ac 'the largest safe step is' good.in.screen)" = 1 ] || die "no warning, or more than one"
  awk '/largest safe step/ { sub(/.*largest safe step is /, ""); d = $1 / (5e-6 / sqrt(10100)) - 1; exit d > 1e-4 || d < -1e-4 }' good.in.screen ||
    die "the largest safe step is wrong: $(grep -a 'largest safe' good.in.screen)"
done
step=1e-8
accepts "$plane" ""
grep -aq 'largest safe' good.in.screen && die "a warning for a safe step"
# A grain that is slow at first, and fast at the end: the warning comes with the next output.
deck "$plane
fix g all gravity 1e9 vector 0 0 -1" "" | sed '$ s/run 1/run 60/' > good.in
engine 2 good.in
[ "$(grep -ac 'the largest safe step is' good.in.screen)" = 1 ] || die "no warning of a grain that became fast"
exit 0
