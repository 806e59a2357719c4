#!/usr/bin/env bash
# Bad scripts: one clear message that names the thing, its value and what it must be, on one rank, each eighth on
# two, and a non-zero exit; with `every N` behind the engine only each Nth of them; for a step that is too large a warning with the largest safe one. The words of a description are
# tested in unit/test_description.c.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
every=1
[ "${1:-}" != every ] || every=$2
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

# bad COMMAND LINES WORD...: it ends with an error whose one line has every word. Two at a time.
bad() {
  local command=$1 lines=$2; shift 2
  number=$((number + 1))
  [ $((number % every)) = 0 ] || return 0
  [ $((number / every)) -le 2 ] || wait -n || true
  (mkdir bad.$number; cd bad.$number; ln -s ../plate.stl ../materials.in .
   export OMPI_MCA_orte_tmpdir_base=$PWD # see engine.sh
   deck "$command" "$lines" | sed -e "$edit" > bad.in
   refuses $((number % 8 ? 1 : 2)) bad.in "$@") > bad.$number.log 2>&1 || { echo "$command $lines"; cat bad.$number.log; touch failed; } &
}
number=0
# bad_rows SECTION: each row of it in bad_input.txt: the command, the lines, where \n begins another, and words, parted by @.
bad_rows() {
  local row fields
  while read -r row; do
    row=${row//PLANE/$plane} row=${row/MESH/$mesh} row=${row/WALL/$wall}
    readarray -t fields < <(sed 's/ *@ */\n/g' <<< "${row//\\n/\\}")
    bad "${fields[@]//\\/$'\n'}"
  done < <(sed -n "/^\[$1\]/,/^$/p" "$here/bad_input.txt" | sed '/^\[/d; /^$/d')
}
printf 'name,youngs_modulus_pa,poissons_ratio,density_kg_m3\nbrass,1e11,0.35,8500\n' > brass.csv
wall='all wall/rebound'
bad_rows both
bad_rows $simulator
if [ $simulator = lammps ]; then
# Files that are no STL: a line that is none, one that is cut short, and binary ones.
bad_stl() { bad "$wall stl ../$1" "" "$@"; }
sed '4s/.*/vertex 1 2/' plate.stl > corner.stl;            bad_stl corner.stl "line 4" "'vertex 1 2'" "'vertex X Y Z'"
sed '4s/.*/vertex 1 2 here/' plate.stl > word.stl;         bad_stl word.stl "line 4" "'vertex 1 2 here'" "finite numbers"
sed '4s/.*/vertex 1 2 nan/' plate.stl > nan.stl;           bad_stl nan.stl "line 4" "finite numbers"
sed '5d' plate.stl > two.stl;                              bad_stl two.stl "line 6" "vertex 3 of 3"
sed '5s/.*/&\n&/' plate.stl > four.stl;                    bad_stl four.stl "line 7" "must be 'endloop'"
head -n 6 plate.stl > cut.stl;                             bad_stl cut.stl "line 6" "endsolid"
printf 'solid s\nendsolid s\n' > none.stl;                 bad_stl none.stl "no triangles"
printf 'sphere 1 2 3\n' > other.stl;                       bad_stl other.stl "line 1" "'sphere 1 2 3'" "'solid NAME'"
{ head -c 80 /dev/zero; printf '\002\000\000\000'; head -c 50 /dev/zero; } > short.stl; bad_stl short.stl "134 bytes" "184"
{ head -c 80 /dev/zero; printf '\001\000\000\000'; head -c 12 /dev/zero; printf '\000\000\300\177'; head -c 34 /dev/zero; } > not.stl
bad_stl not.stl "triangle 1" "finite"
units=lj edit='/^include/d' bad "$plane" "" "units are 'lj'" "si, cgs, micro or nano" "rebound constant"
units=lj bad "$plane" "" "'materials' is in SI units" "'units lj'" "si, cgs, micro or nano"
units=real bad "$plane rebound constant 1 1" "" "units are 'real'" "si, cgs, micro or nano"
edit='/^set group/d; /^fix move/d; s/atom_style granular/atom_style  ellipsoid/' bad "$plane" "" "atom style is 'ellipsoid'" "atom_style sphere"
edit='s/^region box.*/region box prism -0.002 0.002 -0.002 0.002 -0.001 0.002 0.001 0 0 units box/; s/boundary.*/boundary p p f/' \
  bad "$plane" "" "triclinic and periodic" "orthogonal"
edit='s/^create_atoms.*/&\ncreate_atoms 1 single 0 0 1.1e-3 units box/; s/^fix move.*/fix move all rigid\/nvt single temp 1 1 1/' bad "$plane rebound constant 1 1" "" "fix rigid/nvt"
else
for name in youngsModulus:m1 poissonsRatio:m2 yieldStress:m3 surfaceEnergy:m4; do
  # the pair style has its own word on the two that it needs too
  bad "$plane" "unfix ${name#*:}" "${name%:*}"
done
units=real bad "$plane materials quartz hastelloy-x" "" "'units real'" "si, cgs or micro"
units=real bad "$plane rebound table nowhere.csv" "" "'units real'" "si, cgs or micro"
fi
wait
[ ! -e failed ] || die "some bad scripts were not refused as they should be"

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
