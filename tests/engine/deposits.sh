#!/usr/bin/env bash
# Deposits: frozen ones stay put under gravity and drag whatever the order of the fixes, and move with a
# moving wall, over a restart too; deleted ones are counted and gone; off means that none stick. No particle is lost.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
deck() { # DATA DEPOSIT BEFORE AFTER RUNS: fixes before and after the wall
  flying $1 | sed 's/ 0\.8/ 20/g; /^fix move/d' # sticky: most grains stay
  echo "fix plate all mesh/surface file plate.stl type 2
$3
fix wall all wall/rebound mesh n_meshes 1 meshes plate surface rq 5e-6 lambda_c 90e-6 deposit $2 ledger 500 file out.csv
$4
timestep 1e-8
thermo_style custom step atoms f_wall f_wall[1] f_wall[2] f_wall[3] f_wall[6]
thermo 500
thermo_modify lost ${lost:-error} format float %.12g
$(pictures 250 pos.txt)"
  printf '%b\n' "$5"
}
move='fix move all nve/sphere'
body='fix g all gravity 1e6 vector 0.3 0 1
fix drag all viscous 1e-7'
grains 400 > grains.data
plate 6 1 3.9e-3 > plate.stl

# Freeze, with a body force far above nature that would carry every grain off in a step. A wall in its place, or `unfix`,
# sets them free, and a data file keeps nothing of it: both are said.
again='unfix wall'
[ $simulator = liggghts ] || again='write_data kept.data\nfix wall all wall/rebound primitive type 2 zplane -1.0 rebound constant 1 1 deposit off'
deck grains.data freeze "$body" "$move" "run 500\n$again" > before.in
deck grains.data freeze "$move" "$body" 'run 500\nunfix wall' > after.in
for order in before after; do
  engine 2 $order.in
  table a=pos.txt out=out.csv log=$order.in.screen '[end] = [row for row in log if row[0] == 500]
stuck = [row for row in out if row.outcome == 1]
assert end[1] == 400 and len(stuck) == end[4] > 200
assert all(near(row.z, row.d_p / 2, 1e-8) for row in stuck)
early = {row.tag for row in stuck if row.time < 2.5e-6}
assert len(early) > 100
for row, then in zip(at(a, 250), at(a, 500)):
    assert row.id not in early or row == then and not any(row[4:7]), (row, then)
print(int(end[4]))' > stuck || { cat stuck; die "$order: frozen grains"; }
  grep -q "WARNING.* $(cat stuck) particles that are stuck to this wall are free" $order.in.screen || die "$order: no warning that grains are free"
  [ "$simulator $order" != "lammps before" ] || grep -q "WARNING.* $(cat stuck) particles are stuck to this wall, which a data file does not keep" before.in.screen || die "no warning of write_data"
done

# On a wall that moves along x at 5 m/s they go along, after a restart too.
push='fix push all move/mesh mesh plate linear 5 0 0'
deck grains.data freeze "$move" "$body
$push" 'run 500\nwrite_restart slide.restart' > slide.in
deck slide.restart freeze "$move" "$body
$push" 'run 250' > slid.in
engine 2 slide.in
! grep 'WARNING.* are free' slide.in.screen || die "a warning at the end of the script"
mv pos.txt first.txt
engine 2 slid.in
table a=first.txt b=pos.txt '
places = {step: {row.id: row for row in at(a + b, step)} for step in (250, 500, 750)}
stuck = [row for row in at(a, 250) if near(row.vx, 5, 1e-9) and row.vy == row.vz == 0]
assert len(stuck) > 100
for row in stuck:
    for step in 500, 750:
        now, way = places[step][row.id], 5 * (step - 250) * 1e-8
        assert dist(now[1:4], (row.x + way, row.y, row.z)) < 2e-12 and near(now.vx, 5, 2e-4), (row, now)' || die "deposits do not move with the wall"

# Delete: counted, in number and mass. (LIGGGHTS itself takes every particle that goes for lost.) Off: none stick.
lost=$([ $simulator = lammps ] && echo error || echo ignore) deck grains.data delete "$move" '' 'run 500\nrun 10' > delete.in
for ranks in 1 2; do
  engine $ranks delete.in
  table out=out.csv log=delete.in.screen 'end, last = next(row for row in log if row[0] == 500), log[-1]
mass = sum(2650 * pi / 6 * row.d_p ** 3 for row in out if row.outcome == 2)
assert 100 < end[4] < 400 and last[0] == 510 and last[1] == 400 - end[4] and near(mass, end[5], 1e-9)
assert not any(row.outcome == 1 for row in out)' || die "deleted grains on $ranks ranks"
done
deck grains.data off "$move" '' 'run 500' > off.in
engine 2 off.in
table log=off.in.screen 'end = log[-1]
assert end[1] == 400 and end[3] >= 400 and end[4] == 0' || die "deposit off"
