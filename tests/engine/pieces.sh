#!/usr/bin/env bash
# A run in pieces is the run in one: `run N` twice, `run N pre no`, `run 2N every`, and a restart, on 1, 2 and 4 ranks, have the same
# ledgers to the byte, the same places, and the same loads: of grains that fly, rest, slide and stick, on walls at rest, that move and
# that turn. Bodies at rest load their wall with their weight in each step of each piece, wherever the wall stands in the script.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
tile() { # X: a square of 2 mm at a height of 0
  stl <<< "$1e-3 -1e-3 0  $(($1 + 2))e-3 -1e-3 0  $(($1 + 2))e-3 1e-3 0  $1e-3 1e-3 0"
}
for tile in -4 -2 0 2; do tile $tile > tile$tile.stl; done
awk 'BEGIN {
  print "grains\n\n200 atoms\n2 atom types\n\n-5e-3 5e-3 xlo xhi\n-5e-3 5e-3 ylo yhi\n-5e-3 5e-3 zlo zhi\n\nAtoms\n"
  for (i = 0; i < 200; i++) printf "%d 1 %g 2500 %.6g %.6g %.6g\n", i + 1, 1e-4 + i * 5e-7, -3.9e-3 + 4e-4 * (i % 20), -8e-4 + 1.7e-4 * int(i / 20), 1.2e-4 + 1e-5 * (i * 37 % 23)
  print "\nVelocities\n"
  for (i = 0; i < 200; i++) printf "%d %g 0 %g 0 0 0\n", i + 1, 0.02 * (i % 7) - 0.06, -0.1
}' > grains.data

# script DATA RUNS: tiles that lie still, move up and down, turn about their edge, and move while grains stick to them, and
# a rough floor below.
script() {
  flying $1 | sed 's/^neighbor .*/neighbor 1e-4 bin/'
  local name tile law=' surface rq 2e-6 lambda_c 3e-5 rebound walton 0.5 0.3 0 deposit off' n=0
  for name in still moves turns sticks; do
    tile=$((2 * n - 4)); n=$((n + 1))
    echo "fix m$name all mesh/surface file tile$tile.stl type 2"
  done
  echo "fix go1 all move/mesh mesh mmoves wiggle amplitude 0. 0. 2e-5 period 8e-3
fix go2 all move/mesh mesh mturns rotate origin 0. 0. 0. axis 0. 1. 0. period 2.
fix go3 all move/mesh mesh msticks linear 0. 0.01 0.01
fix still all wall/rebound mesh n_meshes 1 meshes mstill rebound walton 0.5 0.3 0 deposit off ledger 20 file still.csv columns full
fix moves all wall/rebound mesh n_meshes 1 meshes mmoves $law ledger 20 file moves.csv columns full
fix turns all wall/rebound mesh n_meshes 1 meshes mturns $law ledger 20 file turns.csv columns full
fix fall all gravity 9.81 vector 0.1 0 -1
fix sticks all wall/rebound mesh n_meshes 1 meshes msticks rebound constant 0 0.5 deposit freeze ledger 20 file sticks.csv columns full
fix floor all wall/rebound primitive type 2 zplane -3e-4 $law ledger 20 file floor.csv columns full
timestep 2e-5
thermo 400
thermo_style custom step f_still[9] f_still[17] f_moves[17] f_turns[17] f_turns[19] f_sticks[17] f_floor[15] f_floor[17]
thermo_modify format float %.15g
$(pictures 800 end.txt)
$2"
}
all() { cat still.csv moves.csv turns.csv sticks.csv floor.csv; }
script grains.data 'run 800' > whole.in
script grains.data 'run 400
run 400' > two.in
script grains.data 'run 400
run 400 pre no' > pre.in
script grains.data 'run 800 every 100 NULL' > every.in
script grains.data 'run 400
write_restart half.restart' > half.in
script half.restart 'run 400' > rest.in
engine 2 whole.in
all > whole.csv; mv end.txt whole.end
table still=still.csv moves=moves.csv turns=turns.csv sticks=sticks.csv log=whole.in.screen '
for rows in (still, moves, turns, sticks):
    assert len(rows) > 30 and rows[-1].time > 8e-3
assert log[-1][1] < -1e-8, (log[-1], "grains rest")' || die "too little happens in this test"
same_as_whole() { # NAME RANKS
  same whole.csv <(all) "ledgers of $1 on $2 ranks"
  same <(tail -n 200 whole.end) <(tail -n 200 end.txt) "places of $1 on $2 ranks"
  table a=whole.in.screen b=$1.in.screen '
for x, y in zip(a[-1], b[-1]):
    assert near(x, y, 1e-12, 1e-22), (x, y)' || die "loads of $1 on $2 ranks"
}
while read -r name ranks; do
  [ $name != rest ] || engine 1 half.in # its ledgers
  engine $ranks $name.in
  same_as_whole $name $ranks
done << END
two 1
two 4
pre 1
every 1
rest 2
END

if [ $simulator = liggghts ]; then
  source "$here/body_scene.sh"
  { bodies 12 random -0.016 0.016
    closed rebound walton 0.3 0.5 0 deposit off
    echo 'fix fall all gravity 9.81 vector 0 0 -1
timestep 2e-5
thermo 1
thermo_style custom step f_zlo[9] f_zlo[17]
thermo_modify format float %.15g
run 20000'
    for run in 1 2 3; do echo 'run 20'; done; } > bodies.in
else # one body at rest, the wall before and behind its fix; LAMMPS leaves out of a set-up what stands behind fix rigid
  for order in before behind; do
    wall='fix low all wall/rebound zplane 0 rebound walton 0.5 0.3 0 deposit off'
    move='fix move all rigid/nve/small molecule'
    [ $order = before ] && both="$wall
$move" || both="$move
$wall"
    printf 'units si\natom_style sphere\natom_modify map array\nboundary f f f\nregion box block -1 1 -1 1 -1 1\ncreate_box 1 box
create_atoms 1 single 0.3 0.2 0.00501\ncreate_atoms 1 single 0.309 0.2 0.00501\nset group all diameter 0.01 density 2500
fix mol all property/atom mol\nset group all mol 1\ncomm_modify cutoff 0.05\nfix fall all gravity 9.81 vector 0 0 -1\n%s\ntimestep 1e-4
thermo 1\nthermo_style custom step f_low[9] f_low[17]\nthermo_modify format float %%.15g\nrun 400\nrun 20\nrun 20\nrun 20 pre no\n' "$both" > bodies.$order.in
  done
fi
for script in bodies*.in; do
  cp "$script" script
  timeout 100 "$bin/$simulator-asperity" -in script -log none > $script.screen 2>&1 < /dev/null || die "$script: $(tail -n 3 $script.screen)"
  table a=$script.screen '
weight, pieces = a[-64][1], a[-63:] # of the first run, and the others, each with its set-up
assert weight < 0 and all(row[1] == 0 or near(row[1], weight, 2e-2) for row in pieces), (weight, pieces)
rate = (a[-64][2] - a[-74][2]) / 10
assert near(a[-1][2] - a[-64][2], rate * (a[-1][0] - a[-64][0]), 2e-2)' || die "$script: bodies do not load the wall with their weight"
done
