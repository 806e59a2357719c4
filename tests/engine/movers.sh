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

# A plate in z = 0, put elsewhere, and a grain of radius 5e-6 that flies along x from the origin. Words act in their order.
plate 2 1 1.9e-3 > plate.stl
placed() { # WORDS, the place of the wall on the x axis, its angle to it
  { echo "$head
boundary f f f
region box block -2e-3 2e-3 -2e-3 2e-3 -2e-3 2e-3 units box
create_box 1 box
neighbor 5e-5 bin
create_atoms 1 single 0 0 0 units box
set group all diameter 1e-5 density 2650
velocity all set 10 0 0 units box
fix move all nve/sphere
fix wall all wall/rebound stl plate.stl $1 rebound constant 0.5 1 deposit off ledger 1 file rows.csv columns full
run 50"; } > placed.in
  rm -f rows.csv
  engine 1 placed.in
  check_rows rows.csv "len(a) == 1 and abs(r.alpha1_deg - $3) < 1e-5 and abs(r.time / (($2 - 5e-6 / math.sin(math.radians($3))) / 10) - 1) < 1e-6" "stl $1: $(rows rows.csv)"
}
placed 'turn 0 1 0 90 shift 4e-4 0 0' 4e-4 90
placed 'shift 0 0 4e-4 turn 0 2 0 90' 4e-4 90
placed 'shift 0 0 1e-4 scale 4 turn 0 1 0 90' 4e-4 90
placed 'scale 4 turn 0 0 1 45 turn 0 1 0 60 shift 3e-4 0 0' 3e-4 60

# A plate that variables move up, at V and as a wiggle, under a grain at rest at z = 4e-5: it has (1 + 0.5) V after the
# impact at t = 3.5e-5/V, and the wiggle is that of `move wiggle`. In pieces and over a restart it is the same.
moved() { # NAME, MOTION, what runs, the restart that it begins from
  { if [ -n "${4:-}" ]; then echo "read_restart $4"; else echo "$head
boundary f f f
$box
create_atoms 1 single 0 0 4e-5 units box
create_atoms 1 single 5e-4 1e-4 3e-5 units box
create_atoms 1 single -5e-4 1e-4 3.2e-4 units box
set group all diameter 1e-5 density 2650
group late id 3
velocity late set 0 0 -8 units box"; fi
    echo "$( [ -n "${4:-}" ] && echo "$head" | grep -v atom_ | grep -v units)
variable up equal 10*step*dt
variable rate equal 10
variable dz equal 4e-5*sin(2*PI*step*dt/2e-5)
variable vz equal 4e-5*2*PI/2e-5*cos(2*PI*step*dt/2e-5)
fix move all nve/sphere
fix wall all wall/rebound stl plate.stl shift 0 0 -1e-5 shift 0 0 1e-5 move $2 rebound constant 0.5 1 deposit off ledger 1 file $1.csv columns full
thermo 1
variable v equal vz[1]
thermo_style custom step v_v
$3"; } > $1.in
  engine 1 $1.in
}
moved up 'variable NULL NULL v_up NULL NULL v_rate' 'run 20'
check_rows up.csv "abs(a[0].time / 2.5e-6 - 1) < 1e-9 and abs(a[1].time / 3.5e-6 - 1) < 1e-9 and all(abs(k.v1z + 10) < 1e-9 and abs(k.v2z - 5) < 1e-9 for k in a[:2])" "a plate at 10 m/s: $(rows up.csv)"
grep -Eq '^ *20 +15 *$' up.in.screen || die "a grain at rest is not at 15 m/s: $(tail -n 3 up.in.screen)"
moved wiggle 'wiggle 0 0 4e-5 2e-5' 'run 60'
variables='variable NULL NULL v_dz NULL NULL v_vz'
moved whole "$variables" 'run 60'
near wiggle.csv whole.csv 'time v1z v2z' 1e-9
[ "$(count_rows whole.csv)" -ge 3 ] || die "the wiggle has $(count_rows whole.csv) impacts"
moved pieces "$variables" 'run 7
run 23
write_restart half.restart
run 30'
same whole.csv pieces.csv "a mesh moved by variables, in pieces"
cp pieces.csv rest.csv # which is cut to what the restart file counts
moved rest "$variables" 'run 30' half.restart
same whole.csv rest.csv "a mesh moved by variables, over a restart"

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
done
