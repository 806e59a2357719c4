#!/usr/bin/env bash
# Deposits: frozen ones stay put under gravity and drag whatever the order of the fixes, and move with a
# moving wall; deleted ones are counted and gone; off means that none stick. No particle is lost otherwise.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
deck() { # wall options, fixes before, fixes after, run
  head_of si
  echo 'read_data grains.data
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all'
  sed 's/ 0\.8/ 20/g' <<< "$(materials)" # sticky: most grains stay
  echo "fix plate all mesh/surface file plate.stl type 2
$2
fix wall all wall/rebound mesh n_meshes 1 meshes plate surface rq 5e-6 lambda_c 90e-6 $1 ledger 500 file out.csv
$3
timestep 1e-8
thermo_style custom step atoms f_wall f_wall[1] f_wall[2] f_wall[3] f_wall[6]
thermo 500
thermo_modify lost ${5:-error} format float %.12g
dump d all custom 250 pos.*.txt id x y z vx vy vz
dump_modify d format \"%d %.15g %.15g %.15g %.15g %.15g %.15g\" sort id
run 500
${4:-}"
}
last_thermo() { grep -E '^ +500 ' "$1.screen" | tail -n 1; }
stuck_ids() { rows out.csv | awk -F, -v before="$1" '$19 == 1 && $3 < before { print $1 }'; }
body='fix g all gravity 1e6 vector 0.3 0 1
fix drag all viscous 1e-7'
grains 400 > grains.data
plate 6 1 3.9e-3 > plate.stl

# Freeze, with a body force far above nature that would carry every grain off in a step.
again='unfix wall'
[ $simulator = liggghts ] || again='write_data kept.data
fix wall all wall/rebound primitive type 2 zplane -1.0 rebound constant 1 1 deposit off'
deck 'deposit freeze' "$body" 'fix move all nve/sphere' "$again" > before.in
deck 'deposit freeze' 'fix move all nve/sphere' "$body" 'unfix wall' > after.in
for order in before after; do
  engine 2 $order.in
  set -- $(last_thermo $order.in)
  [ "$2" = 400 ] || die "$order: $2 grains of 400 are left"
  [ "$5" -gt 200 ] || die "$order: only $5 deposits"
  [ "$(rows out.csv | awk -F, '$19 == 1' | wc -l)" = "$5" ] || die "$order: deposits in ledger and vector differ"
  stuck_ids 2.5e-6 | sort > stuck
  [ "$(wc -l < stuck)" -gt 100 ] || die "$order: too few stuck by half time"
  for step in 250 500; do grep -E '^[0-9]+ -?[0-9.]+(e|\.)?' pos.$step.txt | awk 'NF == 7' | sort | join stuck - > held.$step; done
  same held.250 held.500 "frozen grains moved"
  awk '$5 != 0 || $6 != 0 || $7 != 0 { bad = 1 } END { exit bad || !NR }' held.500 || die "$order: a frozen grain has a speed"
  # A wall in its place, or `unfix`, sets them free, and says so.
  grep -q "WARNING.* $5 particles that are stuck to this wall are free" $order.in.screen || die "$order: no warning that grains are free"
done

# A data file keeps nothing of it, and says so.
if [ $simulator = lammps ]; then
  set -- $(last_thermo before.in)
  grep -q "WARNING.* $5 particles are stuck to this wall, which a data file does not keep" before.in.screen || die "no warning of write_data"
fi

# Each sits with its surface on the wall: z = d/2.
rows out.csv | awk -F, '$19 == 1 { d = $8 - $9 / 2; if (d < 0) d = -d; if (!(d < 1e-8 * $9)) bad = 1 } END { exit bad }' || die "a deposit is not on the wall"

# On a wall that moves along x at 5 m/s and turns, they go along.
deck 'deposit freeze' 'fix move all nve/sphere' "$body
fix push all move/mesh mesh plate linear 5 0 0" 'write_restart slide.restart' > slide.in
engine 2 slide.in
! grep 'WARNING.* are free' slide.in.screen || die "a warning at the end of the script"
stuck_ids 2.49e-6 | sort > stuck
for step in 250 500; do awk 'NF == 7' pos.$step.txt | grep -v ITEM | sort | join stuck - > held.$step; done
paste held.250 held.500 | awk '{ dx = $9 - $2 - 5 * 250e-8; dy = $10 - $3; dz = $11 - $4; if (dx * dx + dy * dy + dz * dz > 1e-24 || $12 < 4.999 || $12 > 5.001) { print; bad = 1 } } END { exit bad || !NR }' ||
  die "deposits do not move with the wall"
# ... after a restart too.
sed 's/^read_data .*/read_restart slide.restart/; s/^run 500/run 250/; /^write_restart/d' slide.in > slid.in
engine 2 slid.in
awk 'NF == 7' pos.750.txt | grep -v ITEM | sort | join stuck - > held.750
paste held.500 held.750 | awk '{ dx = $9 - $2 - 5 * 250e-8; dy = $10 - $3; dz = $11 - $4; if (dx * dx + dy * dy + dz * dz > 1e-24 || $12 < 4.999 || $12 > 5.001) { print; bad = 1 } } END { exit bad || !NR }' ||
  die "deposits do not move with the wall after a restart"

# Delete: counted, in number and mass.
# LIGGGHTS itself takes every particle that goes for lost.
lost=error
[ $simulator = lammps ] || lost=ignore
deck 'deposit delete' 'fix move all nve/sphere' '' 'run 10' $lost > delete.in
for ranks in 1 2; do
  engine $ranks delete.in
  set -- $(last_thermo delete.in)
  [ "$5" -gt 100 ] && [ "$5" -lt 400 ] || die "delete: $5 deposits"
  left=$(grep -E '^ +510 ' delete.in.screen | awk '{ print $2 }')
  [ $((400 - $5)) = "$left" ] || die "delete: $left grains are left after $5 of 400 were deleted"
  rows out.csv | awk -F, -v mass="$6" '$19 == 2 { m += 2650 * 3.14159265358979 / 6 * $9 ^ 3 } $19 == 1 { bad = 1 }
    END { d = m / mass - 1; exit bad || d > 1e-9 || d < -1e-9 }' || die "delete: the deposited mass is wrong"
done

# Off: no adhesion, none stick, none are lost.
deck 'deposit off' 'fix move all nve/sphere' '' > off.in
engine 2 off.in
set -- $(last_thermo off.in)
[ "$2" = 400 ] && [ "$5" = 0 ] && [ "$4" -ge 400 ] || die "off: $*"
