#!/usr/bin/env bash
# Meshes that measure get the momentum of each impact: force and torque of a jet, per triangle too, the weight of grains at
# rest, and a servo that reaches its force.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
stl << END > plate.stl
-0.05 -0.05 0  0.01 -0.05 0  0.01 0.05 0  -0.05 0.05 0
0.01 -0.05 0  0.05 -0.05 0  0.05 0.05 0  0.01 0.05 0
END
# A jet of equal grains in planes of equal y, half of them from each side, each of which hits once; some stick.
jet=$(awk -v state=99 'function uniform() { state = (16807 * state) % 2147483647; return state / 2147483647 }
  BEGIN { for (i = 1; i <= 60; i++) {
    a = (10 + 75 * uniform()) * atan2(0, -1) / 180; v = 1 + 9 * uniform(); t = (0.1 + 1.7 * uniform()) * 1e-3; vx = (i % 2 ? 1 : -1) * v * cos(a); vz = -v * sin(a)
    printf "%d %.12g %.12g %.12g %.12g 0 %.12g\n", i, (i % 10 - 4.5) * 8e-3 - vx * t, (int(i / 10) - 3) * 8e-3, 1e-3 - vz * t, vx, vz } }')
scene() { # GRAINS MESH LAW STEPS [LINES]
  soft "-0.06 0.06 -0.06 0.06 -0.01 0.06" | sed 's/^neighbor .*/neighbor 0.01 bin/'
  echo "fix m5 all property/global yieldStress peratomtype 1e5
fix m6 all property/global surfaceEnergy peratomtypepair 1 10
neigh_modify exclude group all all"
  put 0.002 <<< "$1"
  echo "fix plate all mesh/surface$2
fix wall all wall/rebound mesh n_meshes 1 meshes plate $3
fix move all nve/sphere
timestep 1e-5
${5:-}
thermo_style custom step $([[ $2 != /stress* ]] || echo f_plate[1] f_plate[2] f_plate[3] f_plate[4] f_plate[5] f_plate[6])
thermo_modify format float %.17g
thermo 1
run $4"
}
law='surface rq 1e-4 lambda_c 1e-3 spread weibull rebound bons ledger 100 file jet.csv columns full'
scene "$jet" "/stress file plate.stl type 1 reference_point 0.003 -0.002 0.001" "$law" 200 "$(pictures 200 at.txt "vx vy vz")
dump map all mesh/vtk 1 map.*.vtk output face plate stress stresscomponents id" > jet.in
common='m = 2500 * 4 * pi / 3 * 1e-9
def given(log):
    return [fsum(row[k] * 1e-5 for row in log) for k in range(1, 7)]'
for ranks in 1 2; do
  rm -f map.*
  engine $ranks jet.in
  # the force on each triangle, which is its stress times its area
  cat map.*.vtk | awk '/^stress/ { getline a; getline b; split(a " " b, s, " ") }
    /^meshid/ { getline; for (k = 1; k <= 4; k++) p[$k] += s[3 * k] * ($k < 2 ? 3e-3 : 2e-3) * 1e-5 } END { print p[0], p[1], p[2], p[3] }' > stress
  table log=jet.in.screen a=at.txt rows=jet.csv stress=stress "$common
got, lost = given(log), [m * fsum(x[k] - y[k] for x, y in zip(at(a, 0), at(a, 200))) for k in (1, 2, 3)]
assert len(rows) == 60 and sum(row.outcome == 1 for row in rows) > 5
assert all(abs(x - y) < 1e-12 * abs(got[2]) for x, y in zip(got, lost)), (got, lost)
rowed, pressed = [0] * 6, [0] * 4
for r in rows: # about the reference point; these grains do not spin
    x, y, z, (px, py, pz) = r.x - 0.003, r.y + 0.002, r.z - 0.001, (r.impulse_x, r.impulse_y, r.impulse_z)
    for k, value in enumerate((px, py, pz, y * pz - z * py, z * px - x * pz, x * py - y * px)):
        rowed[k] += value
    pressed[int(r.triangle)] += pz
assert all(abs(x - y) < 1e-9 * abs(got[2 if k < 3 else 4]) for k, (x, y) in enumerate(zip(got, rowed))), (got, rowed)
assert all(x < 0 and near(x, y, 1e-4) for x, y in zip(stress[0], pressed)), (stress, pressed)" || die "what the mesh gets on $ranks ranks"
done

# Grains that stay on a wall press with their weight, at each step, and with 2/7 of what pulls them along it, since they roll.
scene "1 0.02 0.02 0.001 0 0 0
2 -0.02 0.01 0.001 0 0 0" "/stress file plate.stl type 1" "rebound constant 0.5 0.5 deposit off" 100 "fix fall all gravity 9.81 vector 0.1 0 -1" > weight.in
for ranks in 1 2; do
  engine $ranks weight.in
  table log=weight.in.screen "$common
w = 2 * m * 9.81 / sqrt(1.01)
assert len(log) == 101 and all(near(row[3], -w, 1e-9) and abs(row[1] - 0.1 * 2 / 7 * w) < 1e-9 * w for row in log[2:])" || die "the weight of grains at rest"
done

# A servo gets the same momentum as the plate above, later.
scene "$jet" "/stress/servo file plate.stl type 1 com 0. 0. 0. ctrlPV force axis 0. 0. -1. target_val 5. vel_max 1e-30 kp 1." "${law/jet.csv/servo.csv}" 3000 > servo.in
engine 1 servo.in
table log=servo.in.screen jet=jet.in.screen "$common
assert all(abs(x - y) < 1e-6 * abs(given(jet)[2]) for x, y in zip(given(log)[:3], given(jet)))" || die "momentum that a servo gets"

# A piston that must press a bed with 5 N, at a gain of 0.2 m/s per N.
stl <<< "-0.0305 -0.0305 0.036  0.0305 -0.0305 0.036  0.0305 0.0305 0.036  -0.0305 0.0305 0.036" > piston.stl
{ soft "-0.031 0.031 -0.031 0.031 -0.001 0.2" 0.3 0.5
  stack 6 6 6 0.0095 0.3 | put
  k=0
  for plane in "zplane 0.0" "xplane -0.03" "xplane 0.03" "yplane -0.03" "yplane 0.03"; do
    k=$((k + 1)); echo "fix w$k all wall/rebound primitive type 1 $plane rebound constant 0.5 0.9 deposit off"
  done
  echo "timestep 5e-5
fix fall all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
thermo 100000
run 10000
fix piston all mesh/surface/stress/servo file piston.stl type 1 com 0. 0. 0.036 ctrlPV force axis 0. 0. -1. target_val 5. vel_max 0.2 kp 5
fix press all wall/rebound mesh n_meshes 1 meshes piston rebound constant 0.5 0.9 deposit off
thermo_style custom step f_piston[3] f_piston[9]
thermo 7
run 20000"; } > piston.in
engine 1 piston.in
table log=piston.in.screen 'log = [row for row in log if row[0] > 20000]
assert len(log) > 1000 and abs(mean(row[1] for row in log) - 5) < 0.05 and log[-1][2] > 0.02 and log[0][2] - log[-1][2] < 1e-3' || die "the piston's force or height"

# The fix names the loads that it cannot give.
scene "1 0 0 0.01 0 0 0" " file plate.stl type 1 temperature 300." "rebound constant 0.5 0.5 deposit off" 1 > heat.in
engine 1 heat.in
grep -q "WARNING.*mesh 'plate' has a temperature.*no heat" heat.in.screen || die "no word on a mesh with a temperature"
