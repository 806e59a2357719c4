# The part of bad_input.sh that is of LAMMPS only: its walls, its units, and what it has and the wall does not take.
# Sourced by bad_input.sh.
# SPDX-License-Identifier: GPL-3.0-or-later
wall='all wall/rebound'
refuses "$wall" "" "the wall is missing" "zplane" "region stl"
refuses "$wall box" "" "'box'" "xplane yplane zplane" "region stl"
refuses "$wall granular hertz/material 1e9 0.9 0.3 zplane 0 NULL" "" "takes no model" "'granular'" "wall/gran"
refuses "$wall zplane 0 materials quartz hastelloy-x map 10 map.vtk" "" "'map'" "stl FILE"
refuses "$wall zplane" "" "the plane's place" "missing"
refuses "$wall zplane low" "" "the plane's place is 'low'" "number"
refuses "$wall zcylinder -1 0 0" "" "the cylinder's radius is -1" "> 0"
refuses "$wall zplane 0 type 3" "" "the wall's type is 3" "1 to 2"
refuses "$wall zplane 0 map 10 map.vtp" "" "'map'" "stl FILE"

refuses "$wall region" "" "the ID of a region" "missing"
refuses "$wall region moon" "" "region 'moon' does not exist" "region moon STYLE"
refuses "$wall region ball" "variable r equal 1e-3
region ball sphere 0 0 0 v_r units box" "region 'ball' changes its size" "keep its form"
refuses "$wall region ball rebound constant 1 1
run 1
region ball delete" "region ball sphere 0 0 0 1e-3 units box" "region 'ball' does not exist"

refuses "$wall stl" "" "the file of 'stl'" "missing"
refuses "$wall stl nowhere.stl" "" "'nowhere.stl'" "No such file"
refuses "$wall stl .." "" "'..' cannot be read: Is a directory"
refuses "$wall stl plate.stl type 3" "" "the wall's type is 3" "1 to 2"
refuses "$wall stl plate.stl type 2 scale 0" "" "scale is 0" "> 0"
refuses "$wall stl plate.stl scale big" "" "scale is 'big'" "number"
refuses "$wall stl plate.stl move" "" "the value of 'move'" "missing"
refuses "$wall stl plate.stl move jump 1 2 3" "" "'jump'" "linear, wiggle or rotate"
refuses "$wall stl plate.stl move linear 1 2" "" "'move linear'" "missing"
refuses "$wall stl plate.stl move linear 1 2 inf" "" "'move linear' is inf" "finite"
refuses "$wall stl plate.stl move wiggle 0 0 1 0" "" "the period of 'move wiggle' is 0" "> 0"
refuses "$wall stl plate.stl move rotate 0 0 0 0 0 0 1" "" "the axis of 'move rotate' is 0 0 0" "direction"
refuses "$wall stl plate.stl map 0 map.vtp" "" "map is 0" "1 to"
refuses "$wall stl plate.stl map 10 map.vtk" "" "'map.vtk'" ".vtp"
refuses "$wall stl plate.stl rebound constant 1 1 map 1 /nowhere/map.vtp" "" "/nowhere/map.vtp" "No such file"

# Files that are no STL: a line that is none, one that is cut short, and binary ones.
bad_stl() { # NAME WORD...
  local name=$1; shift
  refuses "$wall stl ../$name" "" "$name" "$@"
}
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

units=lj edit='/^include/d' refuses "$plane" "" "units are 'lj'" "si, cgs, micro or nano" "rebound constant"
units=lj refuses "$plane" "" "'materials' is in SI units" "'units lj'" "si, cgs, micro or nano"
units=real refuses "$plane rebound constant 1 1" "" "units are 'real'" "si, cgs, micro or nano"
edit='/^set group/d; /^fix move/d; s/atom_style granular/atom_style  ellipsoid/' refuses "$plane" "" "atom style is 'ellipsoid'" "atom_style sphere"
edit='s/^region box.*/region box prism -0.002 0.002 -0.002 0.002 -0.001 0.002 0.001 0 0 units box/; s/boundary.*/boundary p p f/' \
  refuses "$plane" "" "triclinic and periodic" "orthogonal"
edit='s/^create_atoms.*/&\ncreate_atoms 1 single 0 0 1.1e-3 units box/; s/^fix move.*/fix move all rigid\/nvt single temp 1 1 1/' refuses "$plane rebound constant 1 1" "" "fix rigid/nvt"
refuses "$plane rebound constant 1 1
fix back all recenter 0 0 0" "" "fix recenter (id back)" "past the wall"
edit="s/^boundary.*/boundary f f p/; s/^units.*/&\ndimension 2/; s/^region box.*/region box block -0.002 0.002 -0.002 0.002 -0.001 0.001 units box/
  s/^create_atoms.*/create_atoms 1 single 0 1e-3 0 units box/; s/^velocity.*/velocity all set 10 -10 0 units box/; s/nve.sphere/& disc/" \
  refuses "all wall/rebound yplane 0 rebound constant 1 1" "" "fix nve/sphere (id move)" "discs"
refuses "$plane rebound constant 1 1
dump d all custom 1 all.dump id type x y z vx vy vz
run 1
rerun all.dump dump x y z" "" "rerun is not supported"
