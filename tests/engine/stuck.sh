#!/usr/bin/env bash
# What sticks stays on its wall in LIGGGHTS: when a mesh stops, on belts to their end, on discs and cylinders that turn, at
# a step of 0. (Over periodic edges and restarts: matrix.sh and restart.sh.)
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
stl <<< "-0.1 -0.1 0  0.1 -0.1 0  0.1 0.1 0  -0.1 0.1 0" > plate.stl
stl <<< "0 -0.1 0  0.3 -0.1 0  0.3 0.1 0  0 0.1 0" > belt.stl
# holds NAME DIAMETER EVERY GRAINS LINES CHECK: of grains that stick, on 1 and 2 ranks. CHECK knows the pictures `a`, each a
# list of `rows` at a `step`.
holds() {
  local ranks
  { soft "-0.5 0.5 -0.2 0.2 -0.2 0.2" | sed 's/^neighbor .*/neighbor 0.01 bin/'
    echo "fix m5 all property/global yieldStress peratomtype 1e6
fix m6 all property/global surfaceEnergy peratomtypepair 1 1e9"
    put "$2" <<< "$4"
    echo "neigh_modify exclude group all all
timestep 1e-5
thermo 100000
$(pictures $3)
fix fall all gravity 9.81 vector 0.3 0 1
$5"; } > $1.in
  for ranks in 1 2; do
    engine $ranks $1.in
    table a=at.txt "def apart(x, y):
    return sum(abs(p - q) for p, q in zip(x, y))
$6" || die "$1 on $ranks ranks"
  done
}
wall='rebound bons deposit freeze
fix move all nve/sphere'

# A plate that moves, and is stopped by `unfix`.
for motion in "linear 0.1 0 0.02" "rotate origin 0. 0. 0. axis 0. 0. 1. period 2." "wiggle amplitude 0.01 0. 0. period 0.2"; do
  holds stop 0.002 1000 "1 0.02 0.01 0.005 0 0 -1
2 -0.03 0.04 0.004 0 0 -1
3 0.05 -0.02 -0.005 0 0 1" "fix plate all mesh/surface file plate.stl type 1
fix push all move/mesh mesh plate $motion
fix wall all wall/rebound mesh n_meshes 1 meshes plate $wall
run 7000
unfix push
run 7000" 'stop = at(a, 7000)
assert len(stop) == 3 and a[-1].step == 14000 and all(hypot(*row[4:6]) > 1e-3 for row in stop), "it goes along"
for row in a:
    if row.step > 7000:
        assert not any(row[4:7]) and row[1:4] == stop[int(row.id) - 1][1:4], "it is at rest"'
done

# A belt takes it to its end, and no farther; one on the underside too.
holds belt 0.01 1000 "1 0.2 0.013 0.02 0 0 -1
2 0.25 -0.03 -0.02 0 0 1" "fix belt all mesh/surface file belt.stl type 1 surface_vel -1.5 0.5 0.
fix wall all wall/rebound mesh n_meshes 1 meshes belt $wall
run 30000" 'for row in a:
    assert row.step < 3000 or abs(row.z - (0.005 if row.id == 1 else -0.005)) < 1e-12, "it is on the belt"
    assert row.x > -1e-12 and row.y < 0.1 + 1e-12, "it is not beyond the end"
    assert row.step != 5000 or apart(row[4:6], (-1.5, 0.5)) < 1e-9, "it goes along"
    assert row.step != 30000 or (row.x < 1e-3 or row.y > 0.099) and not any(row[4:6]), "it is at rest at the end"
assert a[-1].step == 30000'

# With a surface that turns, of a disc and of cylinders, their axes beside the origin: turns of 50 rad/s, to a share.
round='def goes_round(row, first, p, q, off, along, share):
    u, v = row[p] - off[0], row[q] - off[1]
    a, b = first[p] - off[0], first[q] - off[1]
    sense = copysign(1, a * first[q + 3] - b * first[p + 3])
    turn = (atan2(v, u) - atan2(b, a)) / (2 * pi) - sense * 50 * (row.step - 5000) * 1e-5 / (2 * pi)
    return (near(hypot(u, v), hypot(a, b), share) and near(hypot(row[p + 3], row[q + 3]), 50 * hypot(u, v), 10 * share)
            and abs(turn - round(turn)) < 20 * share and abs(row[along] - first[along]) < 1e-12 + share * 1e-3)
first = at(a, 5000)'
holds disc 0.01 5000 "1 0.05 0 0.02 0 0 -1
2 -0.02 0.03 -0.02 0 0 1" "fix disc all mesh/surface file plate.stl type 1 surface_ang_vel origin 0. 0. 0. axis 0. 0. 1. omega 50.
fix wall all wall/rebound mesh n_meshes 1 meshes disc $wall
run 20000" "$round
assert a[-1].step == 20000 and all(goes_round(row, first[int(row.id) - 1], 1, 2, (0, 0), 3, 1e-3) for row in a if row.step > 5000)"
while read -r axis about along p q grain; do # columns of the grain's lines along the axis, and of both arms
  holds drum 0.002 5000 "1 $grain" "fix wall all wall/rebound primitive type 1 ${axis}cylinder 0.05 0.02 0.01 shear $about 50 $wall
run 20000" "$round
assert a[-1].step == 20000 and near(hypot(first[0][$p] - 0.02, first[0][$q] - 0.01), 0.049)
for row in a[2:]:
    assert goes_round(row, first[0], $p, $q, (0.02, 0.01), $along, 1e-10), row"
done << END
x y 1 2 3 0.05 0.045 0.02 0 1 0.2
y x 2 3 1 0.02 0.05 0.045 0.2 0 1
z x 3 1 2 0.045 0.02 0.05 1 0.2 0
END

# A step of 0.
holds zero 0.002 10 "1 0.02 0.01 0.005 0 0 -1
2 -0.03 0.04 0.004 0 0 -1" "fix plate all mesh/surface file plate.stl type 1
fix push all move/mesh mesh plate linear 0.1 0 0
fix wall all wall/rebound mesh n_meshes 1 meshes plate ledger 100 file zero.csv $wall
run 1000
timestep 0
run 10
timestep 1e-5
run 1000" 'before = at(a, 1000)
for row in a:
    assert row.step != 1010 or row[1:4] == before[int(row.id) - 1][1:4], "it stays"
    assert row.step <= 1010 or apart(row[4:7], (0.1, 0, 0)) < 1e-12, "it goes along"
assert a[-1].step == 2010 and len(read("zero.csv")) == 2'
