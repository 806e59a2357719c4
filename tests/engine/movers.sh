#!/usr/bin/env bash
# Commands that move or grow particles. LAMMPS: bodies that come while it runs rebound, wherever their fix stands, and
# particles that come into the group of fix move are refused at the step where they show up; a box that only remaps velocities
# runs. Both engines: a grain that grows meets the wall in the step in which it reaches it, and one that was moved by a command.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
program=$bin/lammps-asperity
head='units si
atom_style sphere 1
atom_modify map array
comm_modify vel yes cutoff 1e-4
neigh_modify delay 0 exclude group all all
timestep 1e-6'
box='region box block -1e-3 1e-3 -1e-3 1e-3 -1e-3 1e-3 units box
create_box 1 box
neighbor 5e-5 bin'
wall='fix wall all wall/rebound zplane 0 rebound constant 0.5 1 deposit off ledger 1 file rows.csv columns full'
grain='create_atoms 1 single 0 0 3e-5 units box
set group all diameter 1e-5 density 2650
velocity all set 0 0 -0.1 units box'
printf '# pair\n\n2 atoms\n\nCoords\n\n1 0 0 0\n2 8e-6 0 0\n\nTypes\n\n1 1\n2 1\n\nDiameters\n\n1 1e-5\n2 1e-5\n\nMasses\n\n1 1.3875e-12\n2 1.3875e-12\n' > pair.txt
for first in rigid wall; do # whichever comes first
  rigid='fix bodies all rigid/small molecule mol pair'
  { echo "$head
boundary p p f
$box
fix tags all property/atom mol ghost yes
neigh_modify exclude molecule/intra all
molecule pair pair.txt
region source block -8e-4 8e-4 -8e-4 8e-4 1e-4 8e-4 side in units box"
    [ $first = rigid ] && echo "$rigid" && echo "$wall" || { echo "$wall"; echo "$rigid"; }
    echo "fix weight all gravity 9.81 vector 0 0 -1
fix in all pour 5 0 4711 region source mol pair rigid bodies
thermo_style custom step atoms
run 12000"; } > rigid.in
  for ranks in 1 2; do
    engine $ranks rigid.in
    rows rows.csv > $first.$ranks; rm rows.csv
  done
  same $first.1 $first.2 "poured bodies on 2 ranks"
done
same rigid.1 wall.1 "poured bodies by the order of their fix and the wall"
awk -F, '$40 > 0 && $17 > 0 { n++ } END { print "poured bodies: " n " impacts"; exit n < 3 }' rigid.1 || die "poured bodies"

{ echo "$head
boundary f f f
$box
$grain
group guided empty
fix guide guided move linear 0 0 -0.1
$wall
thermo 1
run 1
group guided id 1
run 10"; } > move.in
refuses 1 move.in "fix move (id guide)"
grep -q '^ *0 ' move.in.screen || die "move.in was refused before its first step"

{ echo "$head
boundary p p f
$box
$grain
$wall
fix move all nve/sphere
fix strain all deform 1 x erate 1 remap v
run 10"; } > stretch.in
engine 1 stretch.in
sed 's/remap v/remap x/' stretch.in > carry.in
refuses 2 carry.in "fix deform (id strain)"

# Both engines, in the language of LIGGGHTS.
scene() { # words of `create_atoms`, each a grain
  head_of si
  echo "region box block -1e-3 1e-3 -1e-3 1e-3 -1e-3 1e-3 units box
create_box 2 box
neighbor 1e-4 bin
neigh_modify delay 0 exclude group all all"
  for at in "$@"; do echo "create_atoms 1 single $at units box"; done
  materials
  echo "set group all diameter 1e-5 density 2650
velocity all set 0 0 -0.1 units box
fix move all nve/sphere
timestep 1e-6
group walled id 1 2"
}
wall='wall/rebound primitive type 2 zplane 0.0 rebound constant 0.5 1 deposit off ledger 1 file rows.csv columns full'
for simulator in liggghts lammps; do
  use $simulator
  # z = 3e-5 - 0.1 t meets the radius 5e-6 + 2.5e-2 t at t = 2e-4 s.
  for every in 1 10; do
    { scene "0 0 3e-5"
      echo "variable d equal 1e-5+5e-8*step
fix wall all $wall
fix grow all adapt $every atom diameter v_d
run 300"; } > grow.in
    [ $simulator = liggghts ] || sed -i 's/^atom_style.*/atom_style sphere 1/' grow.in # radii that change
    rm -f rows.csv
    engine 1 grow.in
    check_rows rows.csv "r is not a[0] or 1.99e-4 <= r.time <= 1.99e-4 + $every * 1e-6 + 1e-6" "$simulator: a grain that grows, each $every steps: $(rows rows.csv | head -n 1)"
  done

  # What commands do to grains between two runs counts also where the second one has no set-up.
  { scene "0 0 8e-4" "5e-4 0 8e-4" "-5e-4 0 2e-5"
    echo "group moved id 1
fix wall walled $wall
run 10
displace_atoms moved move 0 0 -7.8e-4 units box
set atom 2 z 2e-5
group walled id 3
run 1000 pre no"; } > pre.in
  for ranks in 1 2; do
    rm -f rows.csv
    engine $ranks pre.in
    [ "$(rows rows.csv | cut -d, -f 1 | sort | xargs)" = "1 2 3" ] || die "$simulator on $ranks ranks: $(count_rows rows.csv) of 3 grains hit the wall after 'run pre no'"
  done
  ! grep -q 'property/atom larger than 20' pre.in.screen || die "$simulator warns of the wall's own rows"
done
