#!/usr/bin/env bash
# Grains at rest on a wall that keeps none: they write no rows, stay where they are or roll on, on slopes by Coulomb's
# friction whatever the law and the step, and a bed of them is as high as on wall/gran's walls and does not creep. In
# LAMMPS one kind of wall, one step and one bed: the walls are the same code.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
plate 1 1 0.02 > plate.stl
kinds="floor mesh_floor" steps_of="1e-4 1e-5" beds="gran:plane smooth:plane"
[ $simulator = liggghts ] || { kinds=mesh_floor steps_of=1e-4 beds=gran:plane; }
floor() { # options
  echo "fix wall all wall/rebound primitive type 1 zplane 0.0 deposit off $1"
}
mesh_floor() {
  echo "fix plate all mesh/surface file plate.stl type 1
fix wall all wall/rebound mesh n_meshes 1 meshes plate deposit off $1"
}
scene() { # grains (ID X Y Z VX VY VZ lines), gravity's direction, step, walls, run
  soft "-0.03 0.03 -0.03 0.03 -0.03 0.03" "${friction:-0.3}" | sed 's/^neighbor .*/neighbor 0.02 bin/'
  put 0.002 <<< "$1"
  echo "neigh_modify exclude group all all
fix fall all gravity 9.81 vector $2
$4
fix move all nve/sphere
timestep $3
dump at all custom \${every} at.txt id x y z vx vy vz
dump_modify at sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g\"

thermo 100000
$5"
}
# at ID LINE: the numbers of a grain in the LINE-th picture of at.txt, from 1.
at() { awk -v id="$1" -v line="$2" 'NF == 7 && $1 == id && ++n == line' at.txt; }

# Two grains that fall, one aslant, bounce some ten times, and rest, or, on rough walls and aslant, roll on at the same speed: a row an impact, and
# none after that.
falling="1 0.001 0.002 0.002 0 0 0
2 0.008 0.002 0.0015 0.05 0.02 -0.1"
for kind in $kinds; do
  for surface in smooth "rq 2e-6 lambda_c 40e-6"; do
    scene "$falling" "0 0 -1" 1e-4 "$($kind "surface $surface rebound constant 0.5 0.5 ledger 1000 file rest.csv")" "run 20000" > rest.in
    for ranks in 1 2; do
      rm -f rest.csv
      engine $ranks rest.in -var every 5000
      n=$(count_rows rest.csv)
      [ "$n" -ge 10 ] && [ "$n" -le 60 ] || die "$kind, $surface: $n rows of grains that come to rest"
      check_rows rest.csv '$3 < 0.5' "$kind, $surface: impacts of a grain at rest"
      for id in 1 2; do
        { at $id 3; at $id 5; } | awk -v still=$([ "$id $surface" = "1 smooth" ] && echo 1 || echo 0) '
          { for (k = 2; k <= 4; k++) { d = $k - before[k]; if (NR == 2 && (still || k == 4) && !(d * d < 1e-24)) bad = 1; before[k] = $k } # 1e-9 r
            v = $5 * $5 + $6 * $6; if (NR == 2 && !((v - speed) ^ 2 < 1e-20 * v * v + 1e-40)) bad = 1; speed = v
            if (!($4 > 1e-3 * (1 - 1e-9) && $4 < 1e-3 * (1 + 1e-9)) || (still && v > 1e-20) || $7 * $7 > 1e-20) bad = 1 }
          END { exit bad || NR != 2 }' || { cat at.txt; die "$kind, $surface: grain $id does not rest"; }
      done
    done
  done
done

# On a slope of 30 degrees a grain slides without friction, and rolls with 5/7 g sin where tan < 3.5 mu, whatever the
# law's own coefficients and the step.
down() { awk -v a="$1" 'BEGIN { a *= atan2(0, -1) / 180; printf "%.17g 0 %.17g", sin(a), -cos(a) }'; }
for kind in $kinds; do
  for law in "constant 0.5 0.9" "constant 0.5 1" "bons"; do
    for step in $steps_of; do
      case $law in # of the last two, `constant` without friction where the script states none
        bons) mu=0.2 friction=0.2 ;;
        *" 1") mu=0 friction= ;;
        *) mu=0.3 friction= ;;
      esac
      steps=$(awk -v dt=$step 'BEGIN { printf "%d", 0.08 / dt + 0.5 }')
      friction=${friction:-0.3} scene "1 0.001 0.001 0.001 0 0 0" "$(down 30)" $step "fix m5 all property/global yieldStress peratomtype 1e5
$($kind "rebound $law")" "run $steps" > slope.in
      [ -n "$friction" ] || sed -i '/coefficientFriction/d; s/tangential history/tangential off/' slope.in
      engine 1 slope.in -var every "$steps"
      at 1 2 | awk -v mu=$mu -v law="$kind, $law at a step of $step" '{ g = 9.81; a = mu > 0 ? 5 / 7 * g * 0.5 : g * 0.5; v = a * 0.08; d = $5 / v - 1
        x = $2 - 0.001 - 0.5 * a * 0.08 ^ 2; printf "%s: speed off by %g, way by %g m\n", law, d, x
        exit !(d < 1e-6 && d > -1e-6 && x < 1e-9 && x > -1e-9) }' || die "slope of 30 degrees: $kind, $law at a step of $step"
    done
  done
done
unset friction

# Beds: as high as on wall/gran's walls, as far as a packing of so few grains tells (1.4 % sd over seeds), and still.
walls() { # kind, floor
  local k=0
  for plane in "zplane 0.0" "xplane -0.03" "xplane 0.03" "yplane -0.03" "yplane 0.03"; do
    k=$((k + 1))
    local wall="primitive type 1 $plane"
    [ $k != 1 ] || [ "$2" != mesh ] || wall="mesh n_meshes 1 meshes floor"
    if [ "$1" = gran ]; then echo "fix w$k all wall/gran model hertz tangential history $wall"
    else echo "fix w$k all wall/rebound $wall rebound constant 0.5 0.9 deposit off surface $1 ledger 1000 file bed.csv" | { [ $k = 1 ] && cat || sed 's/ledger.*//'; }; fi
  done
}
stl <<< "-0.0305 -0.0305 0  0.0305 -0.0305 0  0.0305 0.0305 0  -0.0305 0.0305 0" > floor.stl
bed() { # kind of walls, floor
  soft "-0.031 0.031 -0.031 0.031 -0.001 0.2" 0.3 0.5
  stack 6 6 5 0.0095 0.3 | put
  [ "$2" != mesh ] || echo "fix floor all mesh/surface file floor.stl type 1"
  walls "$1" "$2"
  echo "timestep 5e-5
fix fall all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
dump at all custom 4000 at.txt id x y z vx vy vz
dump_modify at sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g\"
run 20000"
}
for of in $beds "rq 4e-5 lambda_c 4e-4:mesh"; do
  bed "${of%:*}" "${of#*:}" > bed.in
  engine 1 bed.in
  # of the pictures at 0.8 and 1 s: mean heights, the farthest way in between, the lowest center, number
  awk 'NF == 7 && $1 == 1 { n++ }
    NF == 7 && n == 5 && $1 ~ /^[0-9]+$/ { x[$1] = $2; y[$1] = $3; z[$1] = $4; before += $4 }
    NF == 7 && n == 6 && $1 ~ /^[0-9]+$/ {
      all++; high += $4; d = sqrt(($2 - x[$1]) ^ 2 + ($3 - y[$1]) ^ 2 + ($4 - z[$1]) ^ 2)
      if (d > most) most = d
      if (all == 1 || $4 < least) least = $4 }
    END { printf "%.9g %.9g %.3g %.17g %d\n", before / all, high / all, most, least, all }' at.txt > bed.now
  echo "bed, $of: mean heights at 0.8 and 1 s, farthest way in between, lowest center, grains: $(cat bed.now)"
  [ "$of" != gran:plane ] || { cp bed.now bed.gran; continue; }
  paste -d' ' bed.gran bed.now | awk '{ d = $7 / $2 - 1; creep = $7 / $6 - 1
    exit !($10 == 180 && d < 0.05 && d > -0.05 && creep < 1e-3 && creep > -1e-3 && $8 < 4e-4 && $9 > 4e-3 * (1 - 1e-9)) }' ||
    die "bed, $of: sinks, creeps, or is not as high as with wall/gran: $(cat bed.gran)"
  [ "$(count_rows bed.csv)" -lt 1800 ] || die "bed, $of: $(count_rows bed.csv) rows of one floor"
done
