#!/usr/bin/env bash
# Spin is read and written: grains that fly and turn meet a plane that moves; their velocities and spins afterwards are
# those of the hard sphere. A flow takes deposits away.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"

plane() { # keywords: a wall of type 2
  echo "fix wall all wall/rebound primitive type 2 zplane 0.0 $shear $1"
}
deck() { # wall, what follows, where particles come from
  head_of si
  echo "${3:-read_data grains.data}
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all"
  materials | sed "s/ 0\.8/ ${gamma:-0.8}/g"
  echo "fix move all nve/sphere
timestep 1e-8
$(plane "$1")
thermo_style custom step f_wall[1] f_wall[2]
thermo 400
dump all all custom 400 spins.*.txt id diameter vx vy vz omegax omegay omegaz
dump_modify all format \"%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g\" sort id
$2"
}
spins() { sed '1,9d' "spins.$1.txt"; }

# Of grains with spins of their own, over all regimes: e, mu, beta0 of the script, wall speed 3.
grains 200 | awk '/^Velocities/ { on = 1; print; next } on && NF == 7 { k++; print $1, $2, $3, $4, (k * 7919 % 200 - 100) * 6e4, (k * 104729 % 200 - 100) * 6e4, (k * 31 % 200 - 100) * 6e4; next } { print }' > grains.data
shear='shear x 3.0'
deck 'rebound walton 0.9 0.25 0.3 deposit off ledger 400 file out.csv' 'run 400' > run.in
engine 2 run.in
[ "$(count_rows out.csv)" = 200 ] || die "$(count_rows out.csv) impacts of 200 grains"
spins 0 > before; spins 400 > after
paste -d' ' before after | awk '
  function off(a, b, scale) { a -= b; if (a < 0) a = -a; return a > 2e-5 * scale }
  { r = $2 / 2; vx = $3 - 3; vy = $4; n1 = -$5; wx = $6; wy = $7; wz = $8
    ux = vx - r * wy; uy = vy + r * wx; u = sqrt(ux * ux + uy * uy)
    slide = 0.25 * 1.9 * n1; stick = 2 / 7 * 1.3 * u; j = slide < stick ? slide : stick; stuck += stick < slide
    jx = -j * ux / u; jy = -j * uy / u
    if (off($11, vx + jx + 3, 100) || off($12, vy + jy, 100) || off($13, 0.9 * n1, 100)) bad = 1
    if (off(r * $14, r * (wx + 2.5 / r * jy), 100) || off(r * $15, r * (wy - 2.5 / r * jx), 100) || off($16, wz, 1e6)) bad = 1
    if (bad) { print; exit 1 } }
  END { exit bad || NR != 200 || stuck < 10 || stuck > 190 }' || die "velocities and spins are not those of the hard sphere"

shear=''
# The law of Bons leaves spins alone by default.
for spin in off on; do
  deck "rebound bons spin $spin deposit off" 'run 400' > run.in
  engine 1 run.in
  spins 0 > before; spins 400 > after
  same=$(paste -d' ' before after | awk '{ n += $6 == $14 && $7 == $15 && $8 == $16 } END { print n }')
  [ "$same" = $([ $spin = off ] && echo 200 || echo 0) ] || die "bons, spin $spin: $same grains kept theirs"
done

# A flow takes deposits away: some of those that a run without it left, and in a run that goes on, on two ranks, the same as
# after a restart on one. They go where they are pulled.
gamma=20 # sticky: most grains stay
flow='remove u_tau 25 gas_density 1.2 gas_viscosity 1.5e-5'
pull='fix pull all gravity 1e6 vector 1 0 0
run 400'
pulled() { # of those at rest at step 400, how many move at 800
  spins 400 > before; spins 800 > after
  paste -d' ' before after | awk '$3 == 0 && $4 == 0 && $5 == 0 { moves += $11 != 0; n++ } END { print n + 0, moves + 0 }'
}
for with in "" " $flow"; do
  deck "deposit freeze$with" "run 400
write_restart stuck.restart
$pull" > run.in
  engine 2 run.in
  read -r stuck moves <<< "$(pulled)"
  sort -n after > whole
  deck "deposit freeze$with" "$pull" 'read_restart stuck.restart' > run.in
  engine 1 run.in
  spins 800 | sort -n > part
  same whole part "a run and its restart with flow '$with'"
  [ "$stuck" -gt 50 ] && [ "$moves" -ge $([ "$with" ] && echo 5 || echo 0) ] && [ "$moves" -lt $([ "$with" ] && echo "$stuck" || echo 1) ] ||
    die "$moves of $stuck move with flow '$with'"
done
