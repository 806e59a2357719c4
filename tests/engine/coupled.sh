#!/usr/bin/env bash
# LIGGGHTS as a library of a program that calls `run` for each exchange with a flow, as CFDEMcoupling's: 1000 times `run 10` with
# the same force is one run of 10 000 steps, ledger and places to the byte. Where the force changes with each exchange,
# grains at rest load the wall with it and stay where they are. Usage: coupled.sh PROGRAM
# SPDX-License-Identifier: GPL-3.0-or-later
coupled=$1
source "$(dirname "$0")/engine.sh"
awk 'BEGIN {
  print "grains\n\n40 atoms\n2 atom types\n\n-5e-3 5e-3 xlo xhi\n-5e-3 5e-3 ylo yhi\n-1e-3 5e-3 zlo zhi\n\nAtoms\n"
  for (i = 0; i < 40; i++) printf "%d 1 %g 2500 %.6g %.6g %.6g\n", i + 1, 1e-4, -4e-3 + 8e-4 * (i % 10), -2e-3 + 1e-3 * int(i / 10), 5e-5 + (i % 4) * 2e-4
  print "\nVelocities\n"
  for (i = 0; i < 40; i++) printf "%d %g 0 %g 0 0 0\n", i + 1, 0.01 * (i % 4), -0.1 * (i % 4) }' > grains.data
# script NAME: grains that lie, roll, bounce and fly over a wall, with a force from outside.
script() {
  flying grains.data | sed 's/^newton.*/&\natom_modify map array/'
  echo "fix fall all gravity 9.81 vector 0 0 -1
fix flow all couple/cfd couple_every 10 mpi
fix drag all couple/cfd/force
fix wall all wall/rebound primitive type 2 zplane 0 surface rq 2e-6 lambda_c 3e-5 rebound walton 0.5 0.3 0 deposit off ledger 100 file $1.csv columns full
timestep 2e-6
thermo 10
thermo_style custom step f_wall[9] f_wall[1]
thermo_modify format float %.15g
dump at all custom 1000 $1.txt id x y z vx vy vz
dump_modify at sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g\"
run 0"
}
weight=1.2841259971e-8 # of a grain
# drive NAME EXCHANGES STEPS SWING: with a force of 0.02 weights along the wall and 0.5 against the weight.
drive() {
  script "$1" > "$1.in"
  timeout 300 "$coupled" "$1.in" "$2" "$3" "$(mul $weight 0.02)" "$(mul $weight 0.5)" "$4" > "$1.screen" 2>&1 || { tail "$1.screen"; die "$1"; }
}
drive whole 1 10000 0
drive parts 1000 10 0
same <(rows whole.csv) <(rows parts.csv) "ledgers"
same <(tail -n 40 whole.txt) <(tail -n 40 parts.txt) "places"

# Ten grains lie on the wall. It bears what the force of the exchange leaves of their weight, in its last step.
drive swings 200 10 0.4
awk -v w=$weight '$1 % 10 == 0 && NF == 3 && $1 > 0 && $1 <= 2000 && !seen[$1]++ { n++; left = -10 * w * (1 - 0.5 * ($1 / 10 % 2 ? 1.4 : 0.6)); good += ($2 / left - 1) ^ 2 < 1e-12 }
  END { print good " of " n " loads"; exit n != 200 || good < 190 }' swings.screen || die "the load on the wall is not the weight less the flow's force"
tail -n 40 swings.txt | awk '$1 % 4 == 1 && ($4 - 5e-5) ^ 2 > 1e-24 { exit 1 }' || die "a grain at rest has left the wall"
