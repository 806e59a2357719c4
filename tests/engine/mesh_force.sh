#!/usr/bin/env bash
# Meshes that measure get the momentum of each impact: force and torque of a jet, per triangle too, the weight of grains at rest, and a servo that reaches its force.
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
mass=$(awk 'BEGIN { printf "%.17g", 2500 * 4 * atan2(0, -1) / 3 * 1e-9 }')
scene() { # lines
  soft "-0.06 0.06 -0.06 0.06 -0.01 0.06" | sed 's/^neighbor .*/neighbor 0.01 bin/'
  echo "fix m5 all property/global yieldStress peratomtype 1e5
fix m6 all property/global surfaceEnergy peratomtypepair 1 10
neigh_modify exclude group all all"
  put 0.002 <<< "$jet"
  echo "$1"
}
scene "fix plate all mesh/surface/stress file plate.stl type 1 reference_point 0.003 -0.002 0.001
fix wall all wall/rebound mesh n_meshes 1 meshes plate surface rq 1e-4 lambda_c 1e-3 spread weibull rebound bons ledger 100 file jet.csv
fix move all nve/sphere
timestep 1e-5
dump at all custom 200 at.txt id vx vy vz
dump_modify at sort id format \"%d %.17g %.17g %.17g\"
dump map all mesh/vtk 1 map.*.vtk output face plate stress stresscomponents id
thermo_style custom step f_plate[1] f_plate[2] f_plate[3] f_plate[4] f_plate[5] f_plate[6]
thermo_modify format float %.17g
thermo 1
run 200" > jet.in
numbers() { grep -E '^ +[0-9]+( +[-+.0-9e]+){6} *$' "$1"; }
for ranks in 1 2; do
  rm -f jet.csv map.*
  engine $ranks jet.in
  [ "$(count_rows jet.csv)" = 60 ] && [ "$(rows jet.csv | awk -F, '$19 == 1' | wc -l)" -gt 5 ] || die "the jet is not what it must be: $(count_rows jet.csv) impacts"
  # the momentum and its moment that the mesh has got
  numbers jet.in.screen | awk '{ for (k = 2; k <= 7; k++) sum[k] += $k * 1e-5 } END { for (k = 2; k <= 7; k++) printf "%.17g ", sum[k] }' > got
  # what the grains have lost
  awk -v m="$mass" 'NF == 4 && $1 ~ /^[0-9]+$/ { n[$1]++
      for (k = 2; k <= 4; k++) p[k] += (n[$1] == 1 ? m : -m) * $k }
    END { printf "%.17g %.17g %.17g\n", p[2], p[3], p[4] }' at.txt > lost
  paste -d' ' got lost | awk '{ for (k = 1; k <= 3; k++) { d = $k - $(k + 6); if (!(d * d < 1e-24 * $3 * $3)) exit 1 } }' ||
    die "on $ranks ranks the mesh gets the momentum $(cat got), the grains lose $(cat lost)"
  # the same by the ledger, with its ten digits
  awk -v m="$mass" 'FNR == NR { if (NF == 7 && $1 ~ /^[0-9]+$/) sense[$1] = $5 > 0 ? 1 : -1; next }
    FNR > 2 { split($0, c, ","); a1 = c[11] * atan2(0, -1) / 180; a2 = c[16] * atan2(0, -1) / 180
      px = m * (c[10] * cos(a1) - c[15] * cos(a2)) * sense[c[1]]; pz = -m * (c[10] * sin(a1) + c[15] * sin(a2))
      x = c[6] - 0.003; y = c[7] + 0.002; z = c[8] - 0.001 # grains that do not spin
      sum[1] += px; sum[3] += pz; sum[4] += y * pz; sum[5] += z * px - x * pz; sum[6] -= y * px
      pressed[c[5]] += pz }
    END { for (k = 1; k <= 6; k++) printf "%.17g ", sum[k]
      print pressed[0], pressed[1], pressed[2], pressed[3] > "pressed" }' <(put <<< "$jet" | awk '/^set atom/ { print $3, 0, 0, 0, $5, $7, $9 }') jet.csv > told
  paste -d' ' got told | awk '{ for (k = 1; k <= 6; k++) { d = $k - $(k + 6); of = k < 4 ? $3 : $5; if (!(d * d < 1e-18 * of * of)) exit 1 } }' ||
    die "on $ranks ranks the mesh gets $(cat got), the ledger tells of $(cat told)"
  # the force on each triangle, which is its stress times its area
  cat map.*.vtk | awk '/^stress/ { getline a; getline b; split(a " " b, s, " ") }
    /^meshid/ { getline; for (k = 1; k <= 4; k++) p[$k] += s[3 * k] * ($k < 2 ? 3e-3 : 2e-3) * 1e-5 } END { print p[0], p[1], p[2], p[3] }' > stress
  paste -d' ' stress pressed | awk '{ for (k = 1; k <= 4; k++) { d = $k / $(k + 4) - 1; if (!($k < 0 && d * d < 1e-8)) exit 1 } }' ||
    die "on $ranks ranks the triangles get the momenta $(cat stress), by the ledger $(cat pressed)"
done

# Grains that stay on a wall press with their weight, at each step, and with 2/7 of what pulls them along it, since they
# roll.
jet="1 0.02 0.02 0.001 0 0 0
2 -0.02 0.01 0.001 0 0 0"
scene "fix plate all mesh/surface/stress file plate.stl type 1
fix wall all wall/rebound mesh n_meshes 1 meshes plate rebound constant 0.5 0.5 deposit off
fix fall all gravity 9.81 vector 0.1 0 -1
fix move all nve/sphere
timestep 1e-5
thermo_style custom step f_plate[1] f_plate[2] f_plate[3] f_plate[4] f_plate[5] f_plate[6]
thermo_modify format float %.17g
thermo 1
run 100" > weight.in
for ranks in 1 2; do
  engine $ranks weight.in
  numbers weight.in.screen | awk -v m="$mass" '$1 > 1 { n++; w = 2 * m * 9.81 / sqrt(1.01); d = $4 / -w - 1; e = $2 / w - 0.1 * 2 / 7
      if (!(d * d < 1e-18 && e * e < 1e-18)) { print; bad = 1 } } END { exit bad || n != 99 }' || die "the weight of grains at rest"
done

# A servo gets the same momentum as the plate above, later.
jet_of_servo() {
  sed -e 's/mesh\/surface\/stress file plate.stl type 1 reference_point.*/mesh\/surface\/stress\/servo file plate.stl type 1 com 0. 0. 0. ctrlPV force axis 0. 0. -1. target_val 5. vel_max 1e-30 kp 1./' \
    -e '/mesh\/vtk/d; /^dump/d; s/^run 200$/run 3000/; s/jet.csv/servo.csv/' jet.in
}
jet_of_servo > jet_servo.in
engine 1 jet_servo.in
numbers jet_servo.in.screen | awk '{ for (k = 2; k <= 4; k++) sum[k] += $k * 1e-5 } END { printf "%.17g %.17g %.17g\n", sum[2], sum[3], sum[4] }' | paste -d' ' - got |
  awk '{ print "the servo gets " $3 ", the plate " $6; exit !(($3 / $6 - 1) ^ 2 < 1e-12 && ($1 - $4) ^ 2 < 1e-12 * $6 * $6) }' || die "momentum that a servo gets"

# A piston that must press a bed with 5 N, at a gain of 0.2 m/s per N.
stl <<< "-0.0305 -0.0305 0.036  0.0305 -0.0305 0.036  0.0305 0.0305 0.036  -0.0305 0.0305 0.036" > piston.stl
servo() {
  soft "-0.031 0.031 -0.031 0.031 -0.001 0.2" 0.3 0.5
  stack 6 6 6 0.0095 0.3 | put
  for plane in "zplane 0.0" "xplane -0.03" "xplane 0.03" "yplane -0.03" "yplane 0.03"; do
    echo "fix ${plane// /_} all wall/rebound primitive type 1 $plane rebound constant 0.5 0.9 deposit off" | sed 's/_-/_m/; s/^fix \([^ ]*\)\./fix \1/'
  done
  echo "timestep 5e-5
fix fall all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
thermo 100000
run 10000
fix piston all mesh/surface/stress/servo file piston.stl type 1 com 0. 0. 0.036 ctrlPV force axis 0. 0. -1. target_val 5. vel_max 0.2 kp 5
fix press all wall/rebound mesh n_meshes 1 meshes piston rebound constant 0.5 0.9 deposit off
thermo_style custom step f_piston[1] f_piston[2] f_piston[3] f_piston[7] f_piston[8] f_piston[9]
thermo 7
run 20000"
}
servo > servo.in
engine 1 servo.in
numbers servo.in.screen | awk '$1 > 20000 { n++; f += $4; if (n == 1) first = $7 } END { print f / n, first, $7, n }' > servo.now
echo "piston: mean force, first and last height: $(cat servo.now)"
awk '{ exit !($1 > 4.95 && $1 < 5.05 && $4 > 1000 && $3 > 0.02 && $2 - $3 < 1e-3) }' servo.now || die "the piston's force or height"

# The fix names the loads that it cannot give.
jet="1 0 0 0.01 0 0 0"
scene "fix plate all mesh/surface file plate.stl type 1 temperature 300.
fix wall all wall/rebound mesh n_meshes 1 meshes plate rebound constant 0.5 0.5 deposit off
fix move all nve/sphere
timestep 1e-5
run 1" > heat.in
engine 1 heat.in
grep -q "WARNING.*mesh 'plate' has a temperature.*no heat" heat.in.screen || die "no word on a mesh with a temperature"
