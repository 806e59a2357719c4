#!/usr/bin/env bash
# Flights with known answers: where particles are after their rebounds, whatever the step, on 1 and 2 ranks; with several
# contacts in a step, over periods, at edges, on thin walls, belts, meshes that move and turn, and primitive walls; walls of
# several kinds beside each other; particles that come and go; a path of millions of radii.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
mirror='surface smooth rebound constant 1 1 deposit off'
# scene NAME GRAINS STEP STEPS WALLS: grains of 0.1 mm, each "x y z vx vy vz"; at the end they are in NAME.txt.
scene() {
  head_of si | sed "s/^boundary.*/boundary ${boundary:-f f f}/"
  echo "region box block -0.01 0.01 -0.01 0.01 -0.01 0.01 units box
create_box 2 box
neighbor 1e-3 bin
neigh_modify delay 0 exclude group all all"
  materials
  awk '{ print NR, $0 }' <<< "$2" | put 1e-4
  echo "group p2 id 2
fix move all nve/sphere
timestep $3
$5
$(pictures "$4" "$1.txt")
run $4
clear"
}
mesh() { # WALL FILE [KEYWORDS]
  echo "fix m$1 all mesh/surface file $2.stl type 2
fix $1 all wall/rebound mesh n_meshes 1 meshes m$1 ${3:-$mirror}"
}
floor="fix floor all wall/rebound primitive type 2 zplane 0.0"
tube='fix w all wall/rebound primitive type 2 xcylinder 2e-3 0 0'
at() { stl <<< "-0.005 -0.005 $1  0.005 -0.005 $1  0.005 0.005 $1  -0.005 0.005 $1"; }
at 0 > thin.stl; at 2e-3 > stop.stl
{ at 0; at 1.5e-4; } | sed '/^endsolid/d; 2,$ { /^solid/d }' > slot.stl; echo endsolid >> slot.stl
sed 's/ 1.5e-4$/ 2.2e-4/' slot.stl > gap.stl
stl <<< "-0.01 -0.01 0  0.01 -0.01 0  0.01 0.01 0  -0.01 0.01 0" > full.stl
stl <<< "0 -0.005 0  0.005 -0.005 0  0 0.005 0" > edge.stl
stl <<< "6e-5 -0.005 0  6e-5 0.005 0  6e-5 0.005 0.005  6e-5 -0.005 0.005" > end.stl
printf '%s\n' "0 -0.005 0  0.005 -0.005 0  0.005 0.005 0  0 0.005 0" "0 -0.005 0  0 0.005 0  0 0.005 0.005  0 -0.005 0.005" | stl > corner.stl
roof=("0 0.005 0  0 -0.005 0  0.005 -0.005 -0.003  0.005 0.005 -0.003" "0 -0.005 0  0 0.005 0  -0.005 0.005 -0.003  -0.005 -0.005 -0.003")
printf '%s\n' "${roof[@]}" | stl > east.stl; printf '%s\n' "${roof[1]}" "${roof[0]}" | stl > west.stl

# A belt that runs at 4 m/s drags what lands on it into the wall at its end, within one step. LAMMPS's meshes are no belts.
belt() { echo "$1 surface smooth rebound constant 1 0 deposit off"; mesh one end; }
plane_belt=$(belt "$floor shear x 4.")
mesh_belt=$(belt "fix b all mesh/surface file thin.stl type 2 surface_vel 4. 0. 0.
fix onb all wall/rebound mesh n_meshes 1 meshes b")
[ $simulator = liggghts ] || mesh_belt=$plane_belt
styles=(xplane yplane zplane xcylinder xcylinder ycylinder zcylinder)
onto=("3e-4 0 0 -50 0 0" "0 -3e-4 0 0 50 0" "0 0 3e-4 0 0 -50" "0 1.7e-3 0 0 50 0" "0 2.3e-3 0 0 -50 0" "0 0 1.7e-3 0 0 50" "-1.7e-3 0 0 -50 0 0")
ridge=$(awk 'BEGIN { for (i = -19; i <= 19; i += 2) printf "%.9g %.9g %.9g 0 %.9g -30\n", i * 1e-6, i * 1.7e-4, 1e-4 + 3.3e-6 * (i + 20), i * 1.3 }')
{ # the contact falls inside of a step
  for step in "1e-7 100" "1e-6 10" "3.333333333333333e-6 3"; do scene "plane${step#* }" "0 0 3.5e-4 10 0 -50" $step "$floor $mirror"; done
  scene half "0 0 2.5e-4 10 0 -50" 1e-6 10 "$floor surface smooth rebound constant 0.5 0.9 deposit off"
  scene planes "0 0 7e-5 1 0 -50" 6e-6 2 "$floor $mirror
fix b all wall/rebound primitive type 2 zplane 1.5e-4 $mirror"
  scene slot "0 0 7e-5 1 0 -50" 6e-6 2 "$(mesh w slot)"
  boundary='p p f' scene periods "0 0 4.55e-3 100 0 -15" 2e-7 2000 "$(mesh w full)"
  scene edge "-3e-5 -1e-3 2.4e-4 0 0 -50" 1e-6 8 "$(mesh w edge)"
  scene long "0 3e-4 -2e-4 0 30 40" 4e-5 20 "$tube $mirror"
  scene slide "0 0 -1.5e-3 0 50 -1" 1e-6 200 "$tube surface smooth rebound constant 0 1 friction 0.3 deposit off"
  scene corner "2e-4 0 1.5e-4 -50 0 -40
1.2e-4 1e-3 3e-4 -50 0 -40" 1e-5 1 "$(mesh w corner)"
  scene thin "1e-4 1e-4 2e-4 0 0 -30
3e-4 -2e-4 -2e-4 0 0 30" 1e-6 10 "$(mesh w thin)"
  scene plane_belt "0 1e-4 5.125e-5 0 0 -0.25" 1e-5 1 "$plane_belt"
  scene mesh_belt "0 1e-4 5.125e-5 0 0 -0.25" 1e-5 1 "$mesh_belt"
  # The same where a step before it has 10 ns, which `dt/reset` makes 10 us when another grain has lost its speed.
  scene reset "0 1e-4 5.12525e-5 0 0 -0.25
0 1e-3 1.94999e-3 0 0 100" 1e-8 2 "$mesh_belt
$(mesh ons stop "surface smooth rebound constant 1e-6 1 deposit off")
fix dt p2 dt/reset 1 1e-8 1e-5 1e-9"
  for first in east west; do scene $first "$ridge" 1e-6 10 "$(mesh w $first "$mirror ledger 10 file $first.csv")"; done
  scene gap "1e-4 1e-4 2e-5 0 0 -10" 1e-7 150 "$(mesh w gap)"
  scene rise "1e-3 1e-3 1.5e-4 0 0 0
-1e-3 1e-3 4.5e-4 0 0 -30" 1e-6 20 "fix mw all mesh/surface file thin.stl type 2
fix up all move/mesh mesh mw linear 0 0 10
fix w all wall/rebound mesh n_meshes 1 meshes mw $mirror"
  scene turn "2e-3 0 6e-5 0 0 0
-2e-3 0 6e-5 0 0 0" 1e-7 100 "fix mw all mesh/surface file thin.stl type 2
fix turn all move/mesh mesh mw rotate origin 0. 0. 0. axis 0. -1. 0. period 6.283185307179586e-3
fix w all wall/rebound mesh n_meshes 1 meshes mw $mirror ledger 100 file turn.csv"
  for k in "${!styles[@]}"; do
    size=0.0; [[ ${styles[k]} == *plane ]] || size="2e-3 0 0"
    scene first$k "${onto[k]}" 1e-6 10 "fix w all wall/rebound primitive type 2 ${styles[k]} $size $mirror ledger 10 file primitive.$k.csv"
  done
  # A cylinder, its axis beside the origin, that turns about it with 1000 rad/s; arms in order of the axes behind its own.
  while read -r axis about grain; do
    scene turning_$axis "$grain" 1e-6 10 "fix w all wall/rebound primitive type 2 ${axis}cylinder 2e-3 1e-3 -2e-3 shear $about 1000 surface smooth rebound constant 1 0 deposit off"
  done <<< "x y 0 2.2e-3 -6e-4 0 30 35
y x -6e-4 0 2.2e-3 35 0 30
z x 2.2e-3 -6e-4 0 30 35 0"; } > all.in
for ranks in 1 2; do
  engine $ranks all.in
  cat > check.py << 'END_OF_CHECK'
def arrives(name, *wanted, x=1e-12, v=1e-9):
    rows = read(name + ".txt")[-len(wanted):]
    for row, want in zip(rows, wanted):
        for k in range(6):
            assert abs(row[k + 1] - want[k]) <= (v if k > 2 else x), (name, row, want)
for n in 100, 10, 3:
    arrives(f"plane{n}", (1e-4, 0, 2.5e-4, 10, 0, 50))
arrives("half", (4e-5 + 5.4e-5, 0, 5e-5 + 6e-6 * 25, 9, 0, 25))
for name in "planes", "slot": # 0.6 mm in a gap of 50 um
    arrives(name, (1.2e-5, 0, 7e-5, 1, 0, -50))
arrives("periods", (0, 0, 1.55e-3, 100, 0, 15))
# contact at the height 40 um after 4 us; normal (-0.6, 0, 0.8); v2 = v - 2 (v.n) n
arrives("edge", (-3e-5 - 48 * 4e-6, -0.001, 4e-5 + 14 * 4e-6, -48, 0, 14))
y, z, u, w, left, R = 3e-4, -2e-4, 30, 40, 20 * 4e-5, 1.95e-3
while True: # each chord turns the flight by the same angle
    b = (y * u + z * w) / 2500
    t = sqrt(b * b + (R * R - y * y - z * z) / 2500) - b
    if t > left:
        break
    y, z, left = y + u * t, z + w * t, left - t
    n = 2 * (u * y + w * z) / (y * y + z * z)
    u, w = u - n * y, w - n * z
arrives("long", (0, y + u * left, z + w * left, 0, u, w), x=1e-10, v=1e-5)
# Pressed against the cylinder by the curve of its path: mu takes speed until it rolls at 5/7 of it, after ln(7/5)/mu.
end, mu, t = read("slide.txt")[-1], 0.3, (sqrt(1.5e-3 ** 2 + 2501 * (R ** 2 - 1.5e-3 ** 2)) - 1.5e-3) / 2501
b, begin = 1.5e-3 + t, 50 * t
u = (50 * b - begin) / R
angle = atan2(begin, b) + log(7 / 5) / mu + 5 / 7 * (u * (2e-4 - t) / R - 0.4 / mu)
assert hypot(end.y, end.z) < R * (1 + 1e-9) and abs(angle - atan2(end.y, -end.z) - 2 * pi) < 3e-3, (angle, end)
arrives("corner", (5e-5 + 50 * 7e-6, 0, 5e-5 + 40 * 7.5e-6, 50, 0, 40), (5e-5 + 50 * 8.6e-6, 0.001, 5e-5 + 40 * 3.75e-6, 50, 0, 40))
arrives("thin", (1e-4, 1e-4, 2e-4, 0, 0, 30), (3e-4, -2e-4, -2e-4, 0, 0, -30))
for name in "plane_belt", "mesh_belt":
    arrives(name, (0, 1e-4, 5.125e-5, -4, 0, 0.25))
arrives("reset", (0, 1e-4, 5.125e-5, -4, 0, 0.25), (0, 1e-3, 1.95e-3, 0, 0, -1e-4), x=2e-9)
for name in "east", "west": # all impacts on a ridge are of its first triangle
    assert [row.triangle for row in read(name + ".csv")] == 20 * [0], name
arrives("gap", (1e-4, 1e-4, 1.4e-4, 0, 0, -10)) # lifted out of the floor
arrives("rise", (1e-3, 1e-3, 1.5e-4 + 20 * 1e-5, 0, 0, 20), (-1e-3, 1e-3, 4.5e-4 + 20 * 1e-5, 0, 0, 50), x=1e-10, v=1e-6)
up, down = read("turn.txt")[-2:]
assert 3.95 < up.vz < 4.05 and down.vz == 0
for row in read("turn.csv"): # speeds in the wall's frame
    assert row.tag == 1 and 1.98 < row.v1 < 2.02 and row.alpha1_deg > 89 and abs(row.cor_n - 1) < 1e-4, row
for k in range(7):
    [row] = read(f"primitive.{k}.csv")
    assert row.mesh == 0 and abs(row.cor_n - 1) < 1e-9 and abs(row.v2 - 50) < 1e-3 and row.alpha1_deg > 89, (k, row)
a = 1.95e-3 * 30 / hypot(30, 35)
first, second = -30 - 1000 * a * 35 / 30, -35 + 1000 * a
for axis, *v in ("x", 0, first, second), ("y", second, 0, first), ("z", first, second, 0):
    end = read(f"turning_{axis}.txt")[-1]
    assert all(abs(is_ - want) < 1e-8 for is_, want in zip(end[4:], v)), (axis, end, v)
END_OF_CHECK
  table < check.py || die "a flight on $ranks ranks"
done

# Rough walls of two kinds, a smooth one, and the engine's resolved contact, in one run: each does its part.
grains 400 > grains.data
plate 6 1 3.9e-3 > plate.stl
{ boundary='m m f' flying grains.data; echo "$(mesh rough plate "surface rq 15e-6 lambda_c 90e-6 deposit off ledger 1000 file rough.csv")
fix fine all wall/rebound primitive type 2 zplane 5e-4 surface rq 2e-6 lambda_c 90e-6 deposit off ledger 1000 file fine.csv
fix gran all wall/gran model hertz tangential history primitive type 2 zplane 7e-4
timestep 1e-8
thermo_modify lost error
run 2000"; } > many.in
for ranks in 1 3; do engine $ranks many.in; for wall in rough fine; do mv $wall.csv $wall.$ranks.csv; done; done
for wall in rough fine; do same $wall.1.csv $wall.3.csv "1 and 3 ranks"; done
table rough=rough.1.csv fine=fine.1.csv 'assert len(rough) >= 400 and len(fine) > 30
assert 8 < sd(r.delta_alpha_deg for r in rough) < 13.5
assert 1.2 < sd(r.delta_alpha_deg for r in fine) < 1.9' || die "two roughnesses"

# A path of 5e6 radii in a closed box is cut off with a warning, in a short time, and the grain stays in the box.
cube 0.05 | stl > box.stl
{ boundary='p p p' soft "-0.1 0.1 -0.1 0.1 -0.1 0.1" 0 1 | sed 's/^atom_modify .*/& sort 0 0/'
  printf '1 0.01 0 0 2e5 1e5 1.7e5\n2 0.08 0.08 0.08 1 0 0\n' | put 0.001
  mesh wall box "rebound constant 1 1 friction 0 deposit off" | sed 's/type 2/type 1/'
  echo "fix move all nve/sphere
timestep 1e-2
$(pictures 1)
run 1"; } > far.in
TIMEFORMAT=%U
seconds=$( { time engine 1 far.in; } 2>&1 )
table a=at.txt "assert $seconds < 5 and len(a) == 4 and all(abs(x) < 0.0496 for x in a[2][1:4])" || die "a path of 5e6 radii takes $seconds s, or leaves the box"
grep -q "more than 10000 contacts in one step" far.in.screen || die "no warning that contacts were cut off"

[ $simulator = liggghts ] || exit 0 # features.sh has what LAMMPS inserts

# Particles that are inserted, deleted and lost while it runs: each counts its own impacts from 1. (Without
# `compress no`, delete_atoms would give the rest new tags, and with them new draws.)
{ head_of si; echo "region box block 0 2e-3 0 2e-3 -1e-4 1e-3 units box
create_box 2 box
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all"; materials; echo "fix t all particletemplate/sphere 15485863 atom_type 1 volume_limit 1e-20 density constant 2650 radius constant 5e-6
fix d all particledistribution/discrete 32452843 1 t 1.0
region source block 2e-4 12e-4 2e-4 18e-4 1e-4 3e-4 units box
fix in all insert/rate/region seed 49979687 distributiontemplate d nparticles 600 particlerate 5e7 insert_every 100 overlapcheck yes vel constant 20 0 -40 region source
fix low all wall/rebound primitive type 2 zplane 0.0 surface rq 1e-5 lambda_c 9e-5 deposit off rebound constant 0.9 0.9 ledger 100 file low.csv
fix high all wall/rebound primitive type 2 zplane 4e-4 surface smooth deposit off rebound constant 1 1 ledger 100 file high.csv
fix move all nve/sphere
timestep 2e-8
thermo_modify lost ignore
run 700
region hole cylinder z 1e-3 1e-3 3e-4 INF INF units box
delete_atoms region hole compress no
run 1300"; } > flow.in
engine 2 flow.in
table low=low.csv high=high.csv 'for rows in low, high:
    last = {}
    for row in rows:
        assert row.impact == last.get(row.tag, 0) + 1, row
        last[row.tag] = row.impact
    assert len(rows) >= 300
assert sum(row.impact > 1 for row in low) > 30' || die "impact numbers of particles that come and go"
