#!/usr/bin/env bash
# What sticks stays on its wall: when a mesh stops, on belts to their end, on turning meshes and cylinders, across
# periodic edges, at a step of 0; and a run that goes on from a restart file tells it the same way.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
sticky='fix m5 all property/global yieldStress peratomtype 1e6
fix m6 all property/global surfaceEnergy peratomtypepair 1 1e9'
scene() { # box, grains (ID X Y Z VX VY VZ lines), diameter, lines
  soft "$1" | sed 's/^neighbor .*/neighbor 0.01 bin/'
  echo "$sticky"
  put "$3" <<< "$2"
  echo "neigh_modify exclude group all all
timestep 1e-5
thermo 100000
dump at all custom \${every} at.txt id x y z vx vy vz
dump_modify at sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g\"
$4"
}
# places NAME RANKS EVERY: runs a script; `now` then has the grains' lines of all pictures, "PICTURE ID X Y Z VX VY VZ".
places() {
  rm -f at.txt
  engine "$2" "$1.in" -var every "$3"
  awk '/TIMESTEP/ { getline; step = $1 } NF == 7 && $1 ~ /^[0-9]+$/ { print step, $0 }' at.txt > now
}
holds() { # awk program over `now` that prints what is wrong, message
  awk -v pi=3.14159265358979 "function off(a, b) { return a > b ? a - b : b - a } $1" now > wrong
  [ ! -s wrong ] || { head -n 5 wrong; die "$2"; }
}
stl <<< "-0.1 -0.1 0  0.1 -0.1 0  0.1 0.1 0  -0.1 0.1 0" > plate.stl
body='fix fall all gravity 9.81 vector 0.3 0 1'

# A plate that moves, and is stopped by `unfix`.
for motion in "linear 0.1 0 0.02" "rotate origin 0. 0. 0. axis 0. 0. 1. period 2." "wiggle amplitude 0.01 0. 0. period 0.2"; do
  scene "-0.2 0.2 -0.2 0.2 -0.02 0.02" "1 0.02 0.01 0.005 0 0 -1
2 -0.03 0.04 0.004 0 0 -1
3 0.05 -0.02 -0.005 0 0 1" 0.002 "$body
fix plate all mesh/surface file plate.stl type 1
fix wall all wall/rebound mesh n_meshes 1 meshes plate rebound bons deposit freeze
fix push all move/mesh mesh plate $motion
fix move all nve/sphere
run 7000
unfix push
run 7000" > stop.in
  for ranks in 1 2; do
    places stop $ranks 1000
    holds '{ m = NR > 1 ? $1 : 0 }
      $1 > 7000 && $6 * $6 + $7 * $7 + $8 * $8 > 0 { print "moves on: " $0 }
      $1 == 7000 && $6 * $6 + $7 * $7 < 1e-6 { print "does not go along: " $0 }
      $1 == 7000 { x[$2] = $3; y[$2] = $4; z[$2] = $5; n++ }
      $1 > 7000 && off($3, x[$2]) + off($4, y[$2]) + off($5, z[$2]) > 0 { print "is moved on: " $0 }
      END { if (n != 3 || $1 != 14000) print n " grains, step " $1 }' "$motion, stopped, on $ranks ranks"
  done
done

# A belt takes it to its end, and no farther; one on the underside too.
stl <<< "0 -0.1 0  0.3 -0.1 0  0.3 0.1 0  0 0.1 0" > belt.stl
scene "-0.5 0.5 -0.2 0.2 -0.05 0.05" "1 0.2 0.013 0.02 0 0 -1
2 0.25 -0.03 -0.02 0 0 1" 0.01 "$body
fix belt all mesh/surface file belt.stl type 1 surface_vel -1.5 0.5 0.
fix wall all wall/rebound mesh n_meshes 1 meshes belt rebound bons deposit freeze
fix move all nve/sphere
run 30000" > belt.in
for ranks in 1 2; do
  places belt $ranks 1000
  cp now belt.$ranks
  holds '$1 >= 3000 && off($5, $2 == 1 ? 0.005 : -0.005) > 1e-12 { print "not on the belt: " $0 }
    $3 < -1e-12 || $4 > 0.1 + 1e-12 { print "beyond its end: " $0 }
    $1 == 5000 && off($6, -1.5) + off($7, 0.5) > 1e-9 { print "does not go along: " $0 }
    $1 == 30000 && ($3 > 1e-3 && $4 < 0.099 || $6 * $6 + $7 * $7 > 0) { print "not at rest at its end: " $0 }
    END { if ($1 != 30000) print "step " $1 }' "belt on $ranks ranks"
done
same belt.1 belt.2 "belt on 1 and 2 ranks"

# surface_ang_vel: round with the surface.
scene "-0.2 0.2 -0.2 0.2 -0.05 0.05" "1 0.05 0 0.02 0 0 -1
2 -0.02 0.03 -0.02 0 0 1" 0.01 "$body
fix disc all mesh/surface file plate.stl type 1 surface_ang_vel origin 0. 0. 0. axis 0. 0. 1. omega 50.
fix wall all wall/rebound mesh n_meshes 1 meshes disc rebound bons deposit freeze
fix move all nve/sphere
run 20000" > disc.in
for ranks in 1 2; do
  places disc $ranks 5000
  holds '{ r = sqrt($3 ^ 2 + $4 ^ 2); v = sqrt($6 ^ 2 + $7 ^ 2) }
    $1 == 5000 { first[$2] = r; angle[$2] = atan2($4, $3) }
    $1 > 5000 && off(r, first[$2]) > 1e-3 * r { print "leaves its circle: " $0 }
    $1 > 5000 && off(v, 50 * r) > 1e-2 * v { print "speed " v " at r " r ": " $0 }
    $1 > 5000 { turn = (atan2($4, $3) - angle[$2] - 50 * ($1 - 5000) * 1e-5) / (2 * pi); turn -= int(turn + (turn < 0 ? -0.5 : 0.5))
      if (off(turn, 0) > 0.02) print "at " turn " of a turn from where it must be: " $0 }
    END { if ($1 != 20000) print "step " $1 }' "surface_ang_vel on $ranks ranks"
done

# A cylinder that turns, by `shear`, its axis beside the origin.
while read -r axis about along p q grain; do # columns of the grain's lines along the axis, and of both arms
  scene "-0.2 0.2 -0.2 0.2 -0.2 0.2" "1 $grain" 0.002 "$body
fix wall all wall/rebound primitive type 1 ${axis}cylinder 0.05 0.02 0.01 shear $about 50 rebound bons deposit freeze
fix move all nve/sphere
run 20000" > drum.in
  for ranks in 1 2; do
    places drum $ranks 5000
    holds '{ along = '$along'; p = '$p'; q = '$q'
        a = $p - 0.02; b = $q - 0.01; r = sqrt(a * a + b * b); va = $(p + 3); vb = $(q + 3) }
      $1 >= 5000 && off(r, 0.049) > 1e-9 * r { print "r " r ": " $0 }
      $1 >= 5000 && (off(sqrt(va * va + vb * vb), 50 * r) > 1e-9 || off(a * va + b * vb, 0) > 1e-9) { print "speed: " $0 }
      $1 == 5000 { angle = atan2(b, a); sense = a * vb - b * va > 0 ? 1 : -1; along_first = $along }
      $1 > 5000 { turn = (atan2(b, a) - angle - sense * 50 * ($1 - 5000) * 1e-5) / (2 * pi); turn -= int(turn + (turn < 0 ? -0.5 : 0.5))
        if (off(turn, 0) > 1e-9 || off($along, along_first) > 1e-12) print "at " turn " of a turn from where it must be: " $0 }
      END { if ($1 != 20000) print "step " $1 }' "${axis}cylinder on $ranks ranks"
  done
done << END
x y 3 4 5 0.05 0.045 0.02 0 1 0.2
y x 4 5 3 0.02 0.05 0.045 0.2 0 1
z x 5 3 4 0.045 0.02 0.05 1 0.2 0
END

# Just beyond the periodic edge of a floor that shakes.
stl <<< "-0.05 -0.05 0  0.05 -0.05 0  0.05 0.05 0  -0.05 0.05 0" > floor.stl
for from in "0.0499 0.013 0" "0.0499 0.013 0.0124" "-0.04995 0.0499 -0.02" "0.0495 -0.0499 0.0124"; do
  set -- $from
  boundary="p p m" scene "-0.05 0.05 -0.05 0.05 -0.06 0.06" "1 $1 $2 -0.04 $3 $3 1" 0.001 "fix floor all mesh/surface file floor.stl type 1
fix shake all move/mesh mesh floor wiggle amplitude 0. 0. 0.001 period 0.01
fix wall all wall/rebound mesh n_meshes 1 meshes floor rebound bons deposit freeze
fix move all nve/sphere
run 8100" > edge.in
  for ranks in 1 2; do
    places edge $ranks 100
    holds '$1 >= 4200 { v = sqrt($6 ^ 2 + $7 ^ 2 + $8 ^ 2); if (v > 0.64) print "v " v ": " $0; if (v > fastest) fastest = v }
      $1 >= 4200 && off($5, -0.0005 + 0.001 * sin(2 * pi * $1 * 1e-5 / 0.01)) > 1e-5 { print "not on the floor: " $0 }
      END { if ($1 != 8100 || fastest < 0.1) print "step " $1 ", fastest " fastest }' "periodic edge from $from on $ranks ranks"
  done
done

# A step of 0.
scene "-0.2 0.2 -0.2 0.2 -0.02 0.02" "1 0.02 0.01 0.005 0 0 -1
2 -0.03 0.04 0.004 0 0 -1" 0.002 "fix plate all mesh/surface file plate.stl type 1
fix wall all wall/rebound mesh n_meshes 1 meshes plate rebound bons deposit freeze ledger 100 file zero.csv
fix push all move/mesh mesh plate linear 0.1 0 0
fix move all nve/sphere
run 1000
timestep 0
run 10
timestep 1e-5
run 1000" > zero.in
for ranks in 1 2; do
  rm -f zero.csv
  places zero $ranks 10
  holds '/nan|inf/ { print } $1 > 1010 && (off($6, 0.1) > 1e-12 || off($7, 0) + off($8, 0) > 0) { print "speed: " $0 }
    $1 == 1000 { x[$2] = $3 } $1 == 1010 && off($3, x[$2]) > 0 { print "moved: " $0 }
    END { if ($1 != 2010) print "step " $1 }' "a step of 0 on $ranks ranks"
  [ "$(count_rows zero.csv)" = 2 ] || die "a step of 0: $(count_rows zero.csv) rows"
done

# A restart while grains hit a mesh that moves: the ledger of an undisturbed run, byte for byte, and the same places.
grains 200 > grains.data
plate 4 1 3.9e-3 > grid.stl
for motion in "linear 5. -3. 4." "rotate origin 1e-3 1e-3 0. axis 0. 1. 0. period 1e-3" \
  "wiggle amplitude 0. 0. 1e-5 period 1e-6"; do
  after="neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all
$(materials)
fix mesh all mesh/surface file grid.stl type 2
fix wall all wall/rebound mesh n_meshes 1 meshes mesh surface rq 10e-6 lambda_c 90e-6 rebound bons deposit freeze seed 4 ledger 60 file out.csv
fix push all move/mesh mesh mesh $motion
fix move all nve/sphere
timestep 1e-8
thermo 1000
dump end all custom 500 out.csv.end id x y z vx vy vz
dump_modify end format \"%d %.17g %.17g %.17g %.17g %.17g %.17g\" sort id"
  { head_of si | sed 's/boundary.*/boundary m m f/'; echo "read_data grains.data
$after
run 130
write_restart half.restart
run 370"; } > whole.in
  { head_of si | sed 's/boundary.*/boundary m m f/'; echo "read_restart half.restart
$after
run 370"; } > rest.in
  rm -f out.csv
  engine 2 whole.in
  cp out.csv whole.csv; cp out.csv.end whole.end
  [ "$(rows whole.csv | awk -F, '$3 < 130e-8' | wc -l)" -gt 30 ] && [ "$(rows whole.csv | awk -F, '$3 > 135e-8' | wc -l)" -gt 30 ] ||
    die "$motion: too few impacts for this test"
  for ranks in 1 2; do
    cp whole.csv out.csv
    engine $ranks rest.in
    same <(tail -n 200 whole.end) <(tail -n 200 out.csv.end) "places after a restart on $ranks ranks, $motion"
    same whole.csv out.csv "one run and a restart on $ranks ranks, $motion"
  done
done
