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

bad "$plane surfaces smooth" "" "'surfaces'" "surface" "ledger"
bad "$plane surface rq 1e-5 lambda_c 1e-4 1e-3 lay axial" "" "lay is an angle" "X Y Z"
bad "all wall/rebound primitive type 2 zcylinder 1e-3 0 0 surface rq 1e-5 lambda_c 1e-4 1e-3 lay 1 0 0" "" "lay is a vector" "axial"
bad "$plane ledger 0" "" "ledger is 0" "1 to"
bad "$plane ledger 10 rows.csv" "" "behind 'ledger', 'file rows.csv' is expected"
bad "$plane ledger 10 file /nowhere/at/all.csv" "" "/nowhere/at/all.csv" "No such file"
bad "$plane ledger 20 file rows.npy" "" "'rows.npy'; ledgers are CSV, such as rows.csv"
bad "$plane ledger 20 file rows.csv on_error maybe" "" "on_error is 'maybe'; it must be stop or go_on"
bad "$plane ledger 20 on_error stop" "" "on_error" "file FILE"
bad "$mesh" "run_style respa 2 2" "respa"
bad "$plane
minimize 0 0 1 1" "" "minimize"
printf 'name,youngs_modulus_pa,poissons_ratio,density_kg_m3\nbrass,1e11,0.35,8500\n' > brass.csv
bad "$plane materials" "" "materials has 0 names" "2 atom types"
bad "$plane materials quartz surface smooth" "" "materials has 1 names" "2 atom types"
bad "$plane columns full ledger 10" "" "'columns' belongs behind 'ledger'"
bad "$plane materials quartz quartz hastelloy-x file ../brass.csv" "" "materials has 3 names" "2 atom types"
bad "$plane deposit freeze remove gas_density 1.2 gas_viscosity 1.5e-5" "" "'u_tau U' is expected"
bad "$plane materials quartz kryptonite file ../brass.csv" "" "'kryptonite'" "hastelloy-x" "brass"
bad "$plane materials hastelloy-x quartz" "" "'hastelloy-x'" "type 1" "no yield stress" "yield_rate"
if [ $simulator = lammps ]; then # its walls, its units, and what it has and the wall does not take
wall='all wall/rebound'
bad "$wall" "" "the wall is missing" "zplane" "region stl"
bad "$wall box" "" "'box'" "xplane yplane zplane" "region stl"
bad "$wall granular hertz/material 1e9 0.9 0.3 zplane 0 NULL" "" "takes no model" "'granular'" "wall/gran"
bad "$wall zplane 0 materials quartz hastelloy-x map 10 map.vtk" "" "'map'" "stl FILE"
bad "$wall zplane" "" "the plane's place" "missing"
bad "$wall zplane low" "" "the plane's place is 'low'" "number"
bad "$wall zcylinder -1 0 0" "" "the cylinder's radius is -1" "> 0"
bad "$wall zplane 0 type 3" "" "the wall's type is 3" "1 to 2"
bad "$wall zplane 0 map 10 map.vtp" "" "'map'" "stl FILE"
bad "$wall region" "" "the ID of a region" "missing"
bad "$wall region moon" "" "region 'moon' does not exist" "region moon STYLE"
bad "$wall region ball" "variable r equal 1e-3
region ball sphere 0 0 0 v_r units box" "region 'ball' changes its size" "keep its form"
bad "$wall region ball rebound constant 1 1
run 1
region ball delete" "region ball sphere 0 0 0 1e-3 units box" "region 'ball' does not exist"
bad "$wall stl" "" "the file of 'stl'" "missing"
bad "$wall stl nowhere.stl" "" "'nowhere.stl'" "No such file"
bad "$wall stl .." "" "'..' cannot be read: Is a directory"
bad "$wall stl plate.stl type 3" "" "the wall's type is 3" "1 to 2"
bad "$wall stl plate.stl type 2 scale 0" "" "scale is 0" "> 0"
bad "$wall stl plate.stl scale big" "" "scale is 'big'" "number"
bad "$wall stl plate.stl move" "" "the value of 'move'" "missing"
bad "$wall stl plate.stl move jump 1 2 3" "" "'jump'" "linear, wiggle, rotate or variable"
bad "$wall stl plate.stl move linear 1 2" "" "'move linear'" "missing"
bad "$wall stl plate.stl move linear 1 2 inf" "" "'move linear' is inf" "finite"
bad "$wall stl plate.stl move wiggle 0 0 1 0" "" "the period of 'move wiggle' is 0" "> 0"
bad "$wall stl plate.stl move rotate 0 0 0 0 0 0 1" "" "the axis of 'move rotate' is 0 0 0" "direction"
bad "$wall stl plate.stl shift 1 2" "" "a number of 'shift'" "missing"
bad "$wall stl plate.stl shift 1 nan 2" "" "a number of 'shift' is nan" "finite"
bad "$wall stl plate.stl turn 0 0 0 90" "" "the axis of 'turn' is 0 0 0" "direction"
bad "$wall stl plate.stl move variable dz" "" "'dz'" "v_NAME" "NULL"
bad "$wall stl plate.stl move variable v_dx NULL NULL NULL NULL NULL" "" "along x alone" "both"
bad "$wall stl plate.stl move variable v_dx NULL NULL v_vx NULL NULL rebound constant 1 1 deposit off" "" "variable 'dx' of 'move variable' does not exist"
bad "$wall stl plate.stl move variable v_dx NULL NULL v_dx NULL NULL rebound constant 1 1 deposit off" "variable dx atom x" "'dx'" "equal style"
bad "$wall stl plate.stl move variable v_dx NULL NULL v_dx NULL NULL rebound constant 1 1 deposit off" "variable dx equal 1e308*1e308" "'dx'" "finite"
bad "$wall zplane 0 wiggle z 1e-3 0.1" "" "'wiggle'" "region of style block or plane with 'move'" "'stl FILE'"
bad "$wall zplane v_z" "variable z equal 0" "'zplane' is 'v_z'" "number" "'stl FILE'"
bad "$wall zcylinder 1e-3 rebound constant 1 1" "" "'zcylinder R x y' is 'rebound'" "number"
bad "$wall stl plate.stl map 0 map.vtp" "" "map is 0" "1 to"
bad "$wall stl plate.stl map 10 map.vtk" "" "'map.vtk'" ".vtp"
bad "$wall stl plate.stl rebound constant 1 1 map 1 /nowhere/map.vtp" "" "/nowhere/map.vtp" "No such file"
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
bad "$plane rebound constant 1 1
fix back all recenter 0 0 0" "" "fix recenter (id back)" "past the wall"
bad "$plane rebound constant 1 1
dump d all custom 1 all.dump id type x y z vx vy vz
run 1
rerun all.dump dump x y z" "" "rerun is not supported"
else # meshes, constants, templates
bad "all wall/rebound" "" "mesh n_meshes N" "primitive type T"
bad "all wall/rebound box" "" "'box'" "'mesh' or 'primitive'"
bad "all wall/rebound primitive type 2" "" "type T style args"
bad "all wall/rebound primitive type 2 wplane 0.0" "" "'wplane'" "zplane"
bad "all wall/rebound mesh n_meshes 2 meshes plate" "" "n_meshes is '2'"
bad "all wall/rebound mesh n_meshes 1 meshes moon" "" "'moon' does not exist" "mesh/surface"
bad "all wall/rebound primitive type 2 zplane 0.0 surface smooth map 10 map.vtk" "" "'map'" "dump mesh/vtk"
bad "all wall/rebound model hertz primitive type 2 zplane 0.0" "" "takes no model" "wall/gran"
bad "all wall/rebound primitive type 2 zplane 0.0 model hertz tangential history" "" "takes no model"
for name in youngsModulus:m1 poissonsRatio:m2 yieldStress:m3 surfaceEnergy:m4; do
  # the pair style has its own word on the two that it needs too
  bad "$plane" "unfix ${name#*:}" "${name%:*}"
done
bad "$plane" "unfix m3" "yieldStress" "materials quartz hastelloy-x" "fix yieldStress all property/global yieldStress peratomtype 2e8 2e8"
bad "$plane" "unfix m4" "surfaceEnergy" "property/global surfaceEnergy peratomtypepair 2 0.8 0.8 0.8 0.8"
bad "$plane" "unfix m3
fix m3 all property/global yieldStress peratomtype -5 2e8" "yield_stress of 'type 1' is -5" ">= 0"
bad "$plane" "unfix m1
fix m1 all property/global youngsModulus peratomtype -7e10 2e11" "youngsModulus"
bad "$plane" "unfix m2
fix m2 all property/global poissonsRatio peratomtype 0.17 0.7" "poissonsRatio"
bad "all wall/rebound mesh n_meshes 2 meshes plate plate" "" "'plate' is named twice"
bad "$mesh" "fix other all wall/rebound mesh n_meshes 1 meshes plate" "'plate' is already used by fix 'other'" "one wall for each mesh"
bad "$mesh" "fix other all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate" "'plate' is already used by fix 'other'"
bad "all wall/rebound mesh n_meshes 1 meshes worn" "fix worn all mesh/surface/stress file plate.stl type 2 wear finnie" "mesh 'worn' has 'wear finnie'" "erosion finnie FLOW_STRESS"
bad "$plane" "fix wall $plane" "a wall with this ID exists" "'unfix'"
# orders that come after the wall: behind a line break, where the deck goes on
bad "$mesh
unfix plate" "" "plate" "unfix"
bad "$plane materials quartz hastelloy-x" "fix grain all particletemplate/sphere 10007 atom_type 2 volume_limit 1e-20 density constant 2650 radius constant 5e-6" "'hastelloy-x'" "type 2" "no yield stress"
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
