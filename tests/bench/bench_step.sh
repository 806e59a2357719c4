#!/usr/bin/env bash
# What a time step that need not resolve the contact is worth: 5000 grains of quartz of 20 um that hit a plane of
# Hastelloy X at 100 m/s once, 240 us, at the real modulus, whole runs. With the engine's own wall/gran the step is a tenth
# of the Rayleigh time; with this wall a grain moves by its diameter in a step, and by a fifth of that.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "${BASH_SOURCE[0]}")/engine.sh"
diameter=20e-6 speed=100 time=240e-6 n=5000
awk -v n=$n -v d=$diameter -v v=$speed 'BEGIN {
  print "g\n\n" n " atoms\n2 atom types\n\n0 0.006 xlo xhi\n0 0.006 ylo yhi\n-0.0005 0.03 zlo zhi\n\nAtoms\n"
  for (i = 1; i <= n; i++) printf "%d 1 %g 2650 %.12g %.12g %.12g\n", i, d, 8e-5 * (i % 71), 8e-5 * int(i / 71), d + 0.02 * (i % 997) / 997
  print "\nVelocities\n"; for (i = 1; i <= n; i++) print i, "0 0", -v, "0 0 0" }' > grains.data
# pi r sqrt(rho/G)/(0.163 nu + 0.877) of quartz: 70 GPa, 0.17
tenth=$(calc "0.1 * 3.14159265 * $diameter / 2 * sqrt(2650 / (70e9 / 2 / 1.17)) / (0.1631 * 0.17 + 0.8766)")
flight=$(calc "$diameter / $speed")
gran='wall/gran model hertz tangential history primitive type 2 zplane 0.0'
rebound='wall/rebound primitive type 2 zplane 0.0 surface rq 5e-6 lambda_c 40e-6'
TIMEFORMAT=%U
for which in liggghts lammps; do
  [ -x "$bin/$which-asperity" ] || continue
  run_of() { # NAME WALL STEP
    deck "$2" "$3" "$(calc "int($time / $3 + 0.5)")" | sed "/^modify_timing/d; s/^boundary .*/boundary p p f/; $([[ $2 = *gran* ]] && echo 's/ f_wall$//')" > "$1.liggghts"
    if [ $which = lammps ]; then awk -v into=constants -f "$home/tests/engine/to_lammps.awk" "$1.liggghts"; else cat "$1.liggghts"; fi > "$1.in"
    { time "$bin/$which-asperity" -in "$1.in" -log none < /dev/null > "$1.screen" 2>&1; } 2>> "$which.$1.user" || { tail -n 5 "$1.screen" >&2; exit 1; }
  }
  run_of gran "$gran" "$tenth"
  for round in 1 2 3; do run_of flight "$rebound" "$flight"; run_of fifth "$rebound" "$(calc "$flight / 5")"; done
  row "$which, wall/gran at $tenth s, user CPU" "$(least < $which.gran.user)" s
  row "... over wall/rebound at $flight s, a grain's diameter" "$(calc "$(least < $which.gran.user) / $(least < $which.flight.user)")" x ">=" 20
  row "... over wall/rebound at a fifth of that" "$(calc "$(least < $which.gran.user) / $(least < $which.fifth.user)")" x
done
