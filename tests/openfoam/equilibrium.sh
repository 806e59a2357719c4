#!/usr/bin/env bash
# Elastic parcels in a closed rough box, without a gas: none is lost, their energy stays, and the walls leave them in
# equilibrium: the same mean square of the velocity in each direction, the same density everywhere. Usage: equilibrium.sh
# [PARCELS [SECONDS]]
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/case.sh"
parcels=${1:-1000} seconds=${2:-60}
box box 'walls { ".*" "surface rq 5um lambda_c 40um rebound constant 1 1"; }' parcels=$parcels end=$seconds dt=0.25 write=20 cells='3 3 3'
mesh box; run box
cd box
log=log.icoUncoupledKinematicParcelFoam
awk '/Current number of parcels/ { n[++steps] = $NF } /Linear kinetic energy/ { e[steps] = $NF }
  END { print "parcels " n[1] " and " n[steps] ", energy " e[1] " and " e[steps]; d = e[steps] / e[1] - 1
    exit !(n[1] == n[steps] && d * d < 1e-20) }' $log || die "parcels or energy are lost"
for time in [0-9]*; do # the first third is on the way to equilibrium
  awk -v t="$time" -v end=$seconds 'BEGIN { exit !(t > end / 3) }' || continue
  paste -d' ' <(sed -n '/^(/p' "$time/lagrangian/kinematicCloud/positions" | tr -d '()') <(sed -n '/^(/p' "$time/lagrangian/kinematicCloud/U" | tr -d '()')
done | awk 'NF > 5 { n++; near = 0
    for (k = 1; k <= 3; k++) { v2[k] += $(NF - 3 + k) ^ 2; near += $k < 0.05 || $k > 0.95 } at += near }
  END { sum = v2[1] + v2[2] + v2[3]; for (k = 1; k <= 3; k++) { share = v2[k] / sum; printf "share of v%d^2 %.4f\n", k, share; bad = bad || (share * 3 - 1) ^ 2 > 0.03 ^ 2 }
    density = at / n / 0.3; printf "density at the walls %.4f, %d samples\n", density, n; exit bad || (density - 1) ^ 2 > 0.03 ^ 2 || n < 1000 }' || die "no equilibrium"
awk '/^Time/ { s = 0 } /- rebound/ { s += $4 } END { print s + 0, "impacts" }' $log
