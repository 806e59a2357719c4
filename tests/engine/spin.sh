#!/usr/bin/env bash
# Spin is read and written: grains that fly and turn meet a plane that moves; their velocities and spins afterwards are
# those of the hard sphere. The law of Bons leaves spins alone by default. A flow takes some of the deposits away, the same
# in a run that goes on, on two ranks, as after a restart on one.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
deck() { # DATA WALL LINES
  flying $1 | sed "s/ 0\.8/ ${gamma:-0.8}/g"
  echo "timestep 1e-8
fix wall all wall/rebound primitive type 2 zplane 0.0 $2
$(pictures 400 spins.txt "vx vy vz omegax omegay omegaz diameter")"
  printf '%b\n' "${3:-run 400}"
}

# Grains with spins of their own, over all regimes: e, mu, beta0 of the script, wall speed 3.
grains 200 | awk '/^Velocities/ { on = 1; print; next } on && NF == 7 { k++; print $1, $2, $3, $4, (k * 7919 % 200 - 100) * 6e4, (k * 104729 % 200 - 100) * 6e4, (k * 31 % 200 - 100) * 6e4; next } { print }' > grains.data
deck grains.data 'shear x 3.0 rebound walton 0.9 0.25 0.3 deposit off ledger 400 file out.csv' > run.in
engine 2 run.in
[ "$(count_rows out.csv)" = 200 ] || die "$(count_rows out.csv) impacts of 200 grains"
table a=spins.txt 'stuck = 0
for row, now in zip(at(a, 0), at(a, 400)):
    r, vx, vy, n1 = row.diameter / 2, row.vx - 3, row.vy, -row.vz
    ux, uy = vx - r * row.omegay, vy + r * row.omegax
    slide, stick, u = 0.25 * 1.9 * n1, 2 / 7 * 1.3 * hypot(ux, uy), hypot(ux, uy)
    jx, jy = -min(slide, stick) * ux / u, -min(slide, stick) * uy / u
    stuck += stick < slide
    want = vx + jx + 3, vy + jy, 0.9 * n1, row.omegax + 2.5 / r * jy, row.omegay - 2.5 / r * jx, row.omegaz
    scale = 100, 100, 100, 100 / r, 100 / r, 1e6
    assert all(abs(x - y) < 2e-5 * s for x, y, s in zip(now[1:7], want, scale)), (row, now, want)
assert len(a) == 400 and 10 <= stuck <= 190' || die "velocities and spins are not those of the hard sphere"
for spin in off on; do
  deck grains.data "rebound bons spin $spin deposit off" > run.in
  engine 1 run.in
  table a=spins.txt "assert all((x[4:7] == y[4:7]) == ('$spin' == 'off') for x, y in zip(at(a, 0), at(a, 400)))" || die "bons, spin $spin"
done

gamma=20 # sticky: most grains stay
pull='fix pull all gravity 1e6 vector 1 0 0\nrun 400'
for flow in "" "remove u_tau 25 gas_density 1.2 gas_viscosity 1.5e-5"; do
  deck grains.data "deposit freeze $flow" "run 400\nwrite_restart stuck.restart\n$pull" > run.in
  engine 2 run.in
  table a=spins.txt "stuck = [y for x, y in zip(at(a, 400), at(a, 800)) if not any(x[1:4])]
moves = sum(y.vx != 0 for y in stuck)
assert len(stuck) > 50 and (5 <= moves < len(stuck) if '$flow' else moves == 0), (len(stuck), moves)" || die "what moves with flow '$flow'"
  tail -n 200 spins.txt > whole
  deck stuck.restart "deposit freeze $flow" "$pull" > run.in
  engine 1 run.in
  same whole <(tail -n 200 spins.txt) "a run and its restart with flow '$flow'"
done
