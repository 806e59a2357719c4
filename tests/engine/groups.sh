#!/usr/bin/env bash
# The wall is for its group: sizes of other particles do not count, what left the group is free, and grains that rest or stick
# and become a body are held as that alone. Fixes that would carry the group's particles through a wall are refused.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"

# A ball that is larger than the size law of the dust's wall reaches.
{ soft "-1 1 -1 1 -1 1" | sed 's/create_box 1/create_box 1/; s/^neighbor .*/neighbor 1e-3 bin/'
  echo "create_atoms 1 single 0 0 0.1 units box
create_atoms 1 single 0.5 0.5 0.5 units box
set group all diameter 5e-5 density 2650
group ball id 2
group dust id 1
set group ball diameter 0.1 density 2650
velocity dust set 0 0 -1 units box
fix move all nve/sphere
fix low dust wall/rebound primitive type 1 zplane 0 surface rq 5e-6 lambda_c 40e-6 rebound walton 0.5 0.3 0 deposit off
fix high ball wall/rebound primitive type 1 zplane 0.8 rebound walton 0.5 0.3 0 deposit off
timestep 1e-4
thermo_style custom step f_low f_high
thermo 2000
run 2000"; } > sizes.in
engine 1 sizes.in
table a=sizes.in.screen 'assert a[-1][1] >= 1' || die "no impact of dust beside a ball"

# At rest, two leave the group: one of them falls, one is with another wall by then.
{ soft "-1 1 -1 1 -1 1" | sed 's/^neigh_modify .*/neigh_modify delay 0 exclude group all all/'
  put 0.01 << END
1 0 0 0.005 0 0 0
2 0.3 0 0.005 0 0 0
3 0.6 0 0.005 0 0 0
END
  echo "group held id 1 2 3
group other id 3
group gone id 2 3
fix move all nve/sphere
fix g all gravity 9.81 vector 0 0 -1
fix low held wall/rebound primitive type 1 zplane 0 rebound walton 0.5 0.3 0 deposit off
fix next other wall/rebound primitive type 1 zplane -1e-3 rebound walton 0.5 0.3 0 deposit off
timestep 1e-4
variable z2 equal z[2]
variable z3 equal z[3]
thermo 300
thermo_style custom step f_low[9] v_z2 v_z3 f_next[9]
run 300
group held subtract all gone
run 3000"; } > leave.in
engine 1 leave.in
table a=leave.in.screen 'weight = 2500 * 9.81 * pi / 6 * 1e-6
assert near(a[1][1], -3 * weight, 1e-6) and near(a[-1][1], -weight, 1e-6)
assert a[-1][2] < -0.4 and near(a[-1][3], 0.004, 1e-6) and near(a[-1][4], -weight, 1e-6)' || die "what left the group is held"

# bad FIX WORD...: a fix that the wall refuses.
bad() {
  { soft "-1 1 -1 1 -1 1" | sed 's/boundary f f f/boundary p p p/'
    put 0.01 <<< "1 0 0 0.1 0 0 0"
    echo "region low block -1 1 -1 1 -1 0 units box
fix g all gravity 9.81 vector 0 0 -1
fix wall all wall/rebound mesh n_meshes 1 meshes m rebound walton 0.5 0.3 0 deposit off
$1
timestep 1e-4
run 10"; } | sed 's/^region low.*/fix m all mesh\/surface file plate.stl type 1/' > bad.in
  shift
  refuses 1 bad.in "$@"
}
stl <<< "-0.9 -0.9 0  0.9 -0.9 0  0.9 0.9 0  -0.9 0.9 0" > plate.stl
bad 'fix push all move linear 0 0 -1' "fix move (id push) moves particles of this wall's group"
bad 'fix move all nve/sphere
fix squeeze all deform 1 z scale 0.5 remap x' "fix deform (id squeeze) changes the box" "'remap v'"

[ $simulator = lammps ] || exit 0
for state in rest stick; do
  [ $state = rest ] && law='rebound walton 0.5 0.3 0 deposit off' || law='rebound constant 0 0.5 deposit freeze'
  cat > body.in << END
units si
atom_style sphere
atom_modify map array
boundary f f f
region box block -1 1 -1 1 -1 1
create_box 1 box
create_atoms 1 single 0 0 0.0050001
create_atoms 1 single 0.01 0 0.0050001
set group all diameter 0.01 density 2500
fix mol all property/atom mol
set group all mol 1
comm_modify cutoff 0.1
fix g all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
fix low all wall/rebound zplane 0 $law
timestep 1e-4
thermo 100
thermo_style custom step f_low[9]
run 300
unfix move
fix move all rigid/nve/small molecule
run 300
write_restart body.restart
clear
read_restart body.restart
fix mol all property/atom mol
comm_modify cutoff 0.1
fix g all gravity 9.81 vector 0 0 -1
fix move all rigid/nve/small molecule
fix low all wall/rebound stl plate.stl $law
variable x equal x[1]
variable z equal z[1]
timestep 1e-4
thermo_style custom step v_x v_z
run 3
END
  timeout 60 "$bin/lammps-asperity" -in body.in -log none > body.screen 2>&1 < /dev/null || die "$(tail -n 3 body.screen)"
  table a=body.screen 'weight = 2 * 2500 * 9.81 * pi / 6 * 1e-6
loads = [row[1] for row in a if len(row) == 2 and row[0] > 0]
assert len(loads) == 7 and all(near(load, -weight, 1e-6) for load in loads), (loads, weight)
assert all(abs(row[1]) < 1e-6 and near(row[2], 0.005, 1e-4) for row in a if len(row) == 3), a' || die "grains that $state, as a body"
done
