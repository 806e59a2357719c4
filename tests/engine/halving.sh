#!/usr/bin/env bash
# Meshes that turn and those that oscillate are of second order in the step: against the exact instants and speeds of
# impacts on a plate under fix move/mesh, the errors become a quarter at each of five halvings of the step.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
stl <<< "-0.04 -0.04 0  0.04 -0.04 0  0.04 0.04 0  -0.04 0.04 0" > plate.stl
# Grains of 0.2 mm above a plate in the plane z = 0, which meet it once each, at no time together, within 20 ms.
fly() { # lowest place, spread of places, speed
  echo "r = 1e-4; for (i = 1; i <= 400; i++) { x[i] = 0.005 + 0.00004 * i; y[i] = -0.02 + 0.0001 * i
    z[i] = $1 + $2 * (i * 7 % 400); u[i] = 0.1 * (i % 3 - 1); w[i] = -$3 - 0.004 * (i % 11) }"
}
# The exact impacts, by bisection: of each grain its number, the instant, and its speeds after it. gap(t): between
# grain and plate; hit(t): what it leaves with.
exact() { # functions, grains, step
  awk -v dt="$3" "$1"' BEGIN { '"$2"' for (i = 1; i <= 400; i++) {
      for (end = 0; gap(end) > 0; ) end += 5e-5 # none of them meets it and parts within so short a time
      begin = end - 5e-5
      for (k = 0; k < 60; k++) { t = 0.5 * (begin + end); if (gap(t) > 0) begin = t; else end = t }
      hit(t); printf "%d %.17g %.17g %.17g\n", i, t, after[1], after[3] } }'
}
# Turning about the y axis, 20 rad/s, so that the plate comes up where x > 0.
turning='function gap(t) { a = 20 * t; return (z[i] + w[i] * t) * cos(a) - (x[i] + u[i] * t) * sin(a) - r }
  function hit(t) { a = 20 * t; arm = (x[i] + u[i] * t) * cos(a) + (z[i] + w[i] * t) * sin(a)
    off = 2 * (-u[i] * sin(a) + w[i] * cos(a) - 20 * arm); after[1] = u[i] + off * sin(a); after[3] = w[i] - off * cos(a) }'
# LIGGGHTS sums up what oscillates, x(t + dt) = x(t) + v(t + dt) dt, so that the mesh itself is on its way half a step
# ahead: at h sin(W (t + dt/2)) less that of t = 0, with h = a (W dt/2)/sin(W dt/2). That is what the wall must follow.
summed='function place(t) { return h * (sin(W * (t + dt / 2)) - sin(W * dt / 2)) }
  function speed(t) { return h * W * cos(W * (t + dt / 2)) }
  BEGIN { W = 2 * atan2(0, -1) / 0.02; h = size * W * dt / 2 / sin(W * dt / 2) }'
# LAMMPS's walls are where the formula has them.
[ $simulator = liggghts ] || summed='function place(t) { return size * sin(W * t) }
  function speed(t) { return size * W * cos(W * t) }
  BEGIN { W = 2 * atan2(0, -1) / 0.02 }'
# Up and down by 1 mm, and to and fro by 5 degrees, with a period of 20 ms.
wiggling='BEGIN { size = 0.001 }'$summed'
  function gap(t) { return z[i] + w[i] * t - place(t) - r }
  function hit(t) { after[1] = u[i]; after[3] = 2 * speed(t) - w[i] }'
riggling='BEGIN { size = 5 * atan2(0, -1) / 180 }'$summed'
  function gap(t) { a = place(t); return (z[i] + w[i] * t) * cos(a) - (x[i] + u[i] * t) * sin(a) - r }
  function hit(t) { a = place(t); arm = (x[i] + u[i] * t) * cos(a) + (z[i] + w[i] * t) * sin(a)
    off = 2 * (-u[i] * sin(a) + w[i] * cos(a) - speed(t) * arm); after[1] = u[i] + off * sin(a); after[3] = w[i] - off * cos(a) }'
for motion in "rotate origin 0. 0. 0. axis 0. -1. 0. period $(awk 'BEGIN { printf "%.17g", 2 * atan2(0, -1) / 20 }')" \
  "wiggle amplitude 0. 0. 0.001 period 0.02" "riggle origin 0. 0. 0. axis 0. -1. 0. period 0.02 amplitude 5."; do
  case $motion in
    riggle*) [ $simulator = liggghts ] || continue ;; # LAMMPS has none
  esac
  case $motion in
    rotate*) grains=$(fly 0.001 5e-6 0.15) plate=$turning ;;
    wiggle*) grains=$(fly 0.004 3e-5 1) plate=$wiggling ;;
    *) grains=$(fly 0.008 6e-5 2) plate=$riggling ;;
  esac
  awk "BEGIN { $grains for (i = 1; i <= 400; i++) printf \"%d %.17g %.17g %.17g %.17g 0 %.17g\n\", i, x[i], y[i], z[i], u[i], w[i] }" > grains
  rm -f errors
  for halvings in 0 1 2 3 4 5; do
    step=$(awk -v k=$halvings 'BEGIN { printf "%.17g", 5e-4 / 2 ^ k }')
    exact "$plate" "$grains" "$step" > exact
    awk '$2 > 0.0195 { exit 1 }' exact || die "a grain that meets the plate late"
    { soft "-0.05 0.05 -0.05 0.05 -0.1 0.1" | sed 's/^neighbor .*/neighbor 0.01 bin/'
      put 2e-4 < grains
      echo "neigh_modify exclude group all all
fix plate all mesh/surface file plate.stl type 1
fix push all move/mesh mesh plate $motion
fix wall all wall/rebound mesh n_meshes 1 meshes plate rebound constant 1 1 deposit off ledger 100000 file rows.csv
fix move all nve/sphere
timestep $step
thermo 100000
$(pictures $((40 << halvings)) at.txt "vx vz")
run $((40 << halvings))"; } > halving.in
    engine $((1 + halvings % 2)) halving.in
    table exact=exact rows=rows.csv a=at.txt 'rows = sorted(rows, key=lambda row: row.tag)
last = a[-400:]
assert len(rows) == len(exact) == 400 and all(x[0] == y.tag == z.id for x, y, z in zip(exact, rows, last))
print(sqrt(mean((x[1] - y.time) ** 2 for x, y in zip(exact, rows))), sqrt(mean(dist(x[2:4], z[1:3]) ** 2 for x, z in zip(exact, last))))' > error ||
      { cat error; die "$motion: impacts at a step of $step"; }
    cat error >> errors
  done
  table a=errors 'for coarse, fine in zip(a, a[1:]): # a quarter at each halving
    assert all(3.5 < x / y < 4.5 for x, y in zip(coarse, fine)), (coarse, fine)
assert len(a) == 6' || die "$motion: not of second order in the step"
done
