#!/usr/bin/env bash
# Bodies that stick: one sphere does, and the body is held as a whole, moves and turns with its wall, weighs on it, or is
# deleted with all its spheres; on any number of ranks, and over a restart.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
source "$here/body_scene.sh"

show="compute out all reduce max vx
compute state all reduce sum f_floor[1] f_floor[2]
thermo_style custom step atoms c_ke c_re f_floor[2] f_floor[3] f_floor[7] f_floor[9] c_out c_state[1] c_state[2]
thermo 1000000"
# Each body sticks once; at rest the floor carries their weight, rm of all spheres by their bodies.
poured 200 made.bin
fall() { # DEPOSIT RANKS
  { from_restart made.bin
    echo "fix floor all wall/rebound primitive type 1 zplane -0.02 rebound constant 0 0 deposit $1 ledger 1 file $1.csv columns full
fix g all gravity 9.81 vector 0.2 0 -1
$show
timestep 2e-5
run 2400"; } > "$1.in"
  engine "$2" "$1.in"
  rows "$1.csv" > "$1.$2"
}
for ranks in 1 2 4; do
  fall freeze $ranks
  read -r _ atoms ke re deposits mass fx fz v impacts stuck < <(last freeze.in.screen)
  [ "$atoms" = 400 ] && [ "$deposits" = 200 ] && [ "$ke" = 0 ] && [ "$re" = 0 ] && [ "$v" = 0 ] || die "freeze on $ranks ranks: $(last freeze.in.screen)"
  [ "$stuck" = 400 ] && [ "$impacts" -ge 400 ] || die "spheres do not show the state of their bodies on $ranks ranks: $stuck stuck, $impacts impacts"
  table "w = $mass * 9.81 / sqrt(1.04)
assert abs($fx - 0.2 * w) < 1e-6 * w and abs($fz + w) < 1e-6 * w" || die "weight on $ranks ranks: $fx $fz of $mass"
  [ -z "$(cut -d, -f 40 "freeze.$ranks" | sort | uniq -d)" ] || die "a body sticks twice on $ranks ranks"
  fall delete $ranks
  read -r _ atoms _ _ deposits other _ < <(last delete.in.screen)
  [ "$atoms" = 0 ] && [ "$deposits" = 200 ] && [ "$other" = "$mass" ] || die "delete on $ranks ranks: $(last delete.in.screen)"
done
same freeze.1 freeze.2 "2 ranks"; same freeze.1 freeze.4 "4 ranks"
cut -d, -f 1-18,20- freeze.1 > freeze.rows; cut -d, -f 1-18,20- delete.1 > delete.rows
same freeze.rows delete.rows "held or deleted"

# Over a restart: what is held stays so, in its place, and the rest sticks as without it; `deposit off` frees them.
for part in whole again; do
  { if [ $part = whole ]; then from_restart made.bin; else from_restart half.bin; fi
    echo "fix floor all wall/rebound primitive type 1 zplane -0.02 rebound constant 0 0 deposit freeze ledger 1 file $part.csv columns full
fix g all gravity 9.81 vector 0.2 0 -1
$show
timestep 2e-5"
    [ $part = again ] || echo "run 700
write_restart half.bin"
    echo "run 1200
write_dump all custom end.$part id x y z modify sort id format \"%d %.13g %.13g %.13g\""; } > $part.in
  engine $([ $part = whole ] && echo 1 || echo 2) $part.in
done
held=$(rows whole.csv | awk -F, '$3 < 701 * 2e-5' | wc -l)
[ "$held" -gt 20 ] && [ "$held" -lt 180 ] || die "restart: $held are held"
[ "$(last whole.in.screen)" = "$(last again.in.screen)" ] || die "restart: $(last whole.in.screen) and $(last again.in.screen)"
same end.whole end.again "over a restart"
{ from_restart half.bin; echo "fix floor all wall/rebound primitive type 1 zplane -0.02 rebound constant 0 0 deposit off
$show
fix g all gravity 9.81 vector 1 0 1
timestep 2e-5
run 500"; } > off.in
engine 1 off.in
read -r _ _ ke _ < <(last off.in.screen)
awk -v k="$ke" 'BEGIN { exit !(k > 0) }' || die "deposit off holds bodies: $(last off.in.screen)"

# Held bodies move and turn with their walls: after a whole turn all spheres are where they were, after half of one on
# the other side of the axis.
stl <<< "-0.04 -0.04 -0.02  0.04 -0.04 -0.02  0.04 0.04 -0.02  -0.04 0.04 -0.02" > plate.stl
wide=0.012 heights="-0.011 0.012" poured 100 inner.bin
turns() { # NAME GEOMETRY SIGNS of each place about (0, 0, Z) half a turn later, and Z
  { from_restart inner.bin
    echo "fix plate all mesh/surface file plate.stl type 1
fix turn all move/mesh mesh plate rotate origin 0 0 -0.02 axis 0 0 1 period 0.01
fix floor all wall/rebound $2 rebound constant 0 0 deposit freeze
timestep 2e-5
run 2000
thermo_style custom step f_floor[2]
$(pictures 250 $1.txt "x y z")
run 750"; } > $1.in
  engine 2 $1.in
  table a=$1.txt log=$1.in.screen "assert log[-1][1] == 100
begin, half, end = (at(a, step) for step in sorted({row.step for row in a})[-3:])
assert len(end) == 200
for x, y, z in zip(begin, half, end):
    assert dist(x[1:4], z[1:4]) < 1e-11 and dist([s * p for s, p in zip(($3), x[1:4])], y[1:4]) < 1e-11, (x, y, z)" || die "$1: held bodies do not turn with the wall"
}
turns mesh "mesh n_meshes 1 meshes plate" "-1, -1, 1"
turns drum "primitive type 1 ycylinder 0.0195 0 0 shear x 628.31853071795865" "-1, 1, -1"
