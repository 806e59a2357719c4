#!/usr/bin/env bash
# Bodies of LIGGGHTS's fix multisphere at walls: a dumbbell's first hit, the same rows on any number of ranks, the weight of
# rods that lie in valleys which hold them, and what is refused. (What bodies do at walls: unit_body and unit_movers.)
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
source "$here/body_scene.sh"

# The first hit: CoR_N of the center is 1 - 2 q/(1 + q), q = (5/7) cos^2 theta, by the lever in the row. The engine's
# inertia is a sum over random points.
{ bodies 1500 random -0.012 0.019
  echo "fix floor all wall/rebound primitive type 1 zplane -0.02 rebound walton 1 0 0 deposit off ledger 1 file first.csv columns full
timestep 2e-5
run 1200"; } > first.in
engine 1 first.in
table a=first.csv 'first = {}
for row in a:
    if row.v1z == -1.5 and row.omega1x == row.omega1y == 0:
        first.setdefault(row.body, row)
for row in first.values():
    q = 5 / 7 * (row.lever_x ** 2 + row.lever_y ** 2) / 0.25e-6
    assert abs(row.cor_n - (1 - 2 * q / (1 + q))) < 0.003, row
cor = [row.cor_n for row in first.values()]
assert len(cor) >= 1000 and 0.36 <= mean(cor) <= 0.414 and 0.215 <= sd(cor) <= 0.238, (len(cor), mean(cor), sd(cor))' || die "the first hit of a dumbbell"

# The same rows on 1, 2 and 4 ranks, of rough walls with friction; the engine inserts by rank, so that the bodies come
# from a restart file.
poured 300 ranks.bin
{ from_restart ranks.bin
  closed surface sigma 10 rebound walton 0.9 0.3 0 deposit off ledger 1 file LEDGER.csv columns full | sed 's/^fix \([^ ]*\) \(.*\)LEDGER/fix \1 \2\1/'
  echo "timestep 2e-5
run 1000"; } > ranks.in
for ranks in 1 2 4; do
  engine $ranks ranks.in
  for plane in xlo xhi ylo yhi zlo zhi; do rows $plane.csv || true; rm $plane.csv; done > ranks.$ranks
done
[ "$(wc -l < ranks.1)" -gt 250 ] || die "ranks: $(wc -l < ranks.1) impacts"
same ranks.1 ranks.2 "2 ranks"; same ranks.1 ranks.4 "4 ranks"

# Without friction: dumbbells slide down a smooth slope, and most lie still on a rough one. The walls carry the same.
for surface in smooth "rq 20e-6 lambda_c 200e-6"; do
  { velocity="0 0 0"; right=0; bodies 20 "constant 1 0 0 0" -0.0199 -0.0170
    echo "fix floor all wall/rebound primitive type 1 zplane -0.02 surface $surface rebound walton 0.3 0 0 deposit off
fix g all gravity 9.81 vector 0.035 0 -1
variable still atom (vx*vx+vy*vy)<1e-8
compute v all reduce ave vx
compute still all reduce sum v_still
thermo_style custom step atoms c_v f_floor[9] c_still
thermo 4000
timestep 2e-5
run 4000"; } > slide.${surface%% *}.in
  engine 1 slide.${surface%% *}.in
done
table smooth=slide.smooth.in.screen rough=slide.rq.in.screen 'smooth, rough, v = smooth[-1], rough[-1], 9.81 * 0.035 * 0.08
weight = 40 * 2500 * pi / 6 * 1e-9 * 9.81
assert smooth[1] == 40 and near(smooth[2], v, 0.02) and near(smooth[3], -weight, 0.02) and rough[4] > 16 and near(rough[3], smooth[3], 0.2), (smooth, rough)' ||
  die "rods on a slope"

{ bodies 5 random -0.012 0.019; echo "fix floor all wall/rebound primitive type 1 zplane -0.02 rebound walton 0.9 0.3 0.4 deposit off
timestep 2e-5
run 1"; } > bad.in
refuses 1 bad.in "BETA0 0"
