#!/usr/bin/env bash
# Corners and narrow places: nothing leaves a closed box with the shape of a star, also where it moves by several
# radii in a step; and a grain that walls leave no room for goes with them: it is counted as guarded, is not faster
# than they are, and writes no rows.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"

# The star: 7 points, radii 22 and 50 mm, 60 mm high.
corner='function corner(k) { a = atan2(0, -1) * k / 7 + 0.13; r = k % 2 ? 0.022 : 0.05; x[k] = r * cos(a); y[k] = r * sin(a) }
  BEGIN { H = 0.03; for (k = 0; k < 15; k++) corner(k) }'
# inside(): whether p, q is; depth(): how far from the nearest side.
place='function inside(p, q,   k, in_it) {
    for (k = 0; k < 14; k++)
      if ((y[k] > q) != (y[k + 1] > q) && p < (x[k + 1] - x[k]) * (q - y[k]) / (y[k + 1] - y[k]) + x[k]) in_it = !in_it
    return in_it }
  function depth(p, q,   k, u, v, t, d, least) {
    least = 1
    for (k = 0; k < 14; k++) {
      u = x[k + 1] - x[k]; v = y[k + 1] - y[k]; t = ((p - x[k]) * u + (q - y[k]) * v) / (u * u + v * v); t = t < 0 ? 0 : t > 1 ? 1 : t
      d = sqrt((p - x[k] - t * u) ^ 2 + (q - y[k] - t * v) ^ 2); if (d < least) least = d }
    return least }'
awk "$corner"' BEGIN {
  for (k = 0; k < 14; k++) {
    printf "%.17g %.17g %g %.17g %.17g %g %.17g %.17g %g %.17g %.17g %g\n", x[k], y[k], -H, x[k+1], y[k+1], -H, x[k+1], y[k+1], H, x[k], y[k], H
    for (z = -H; z <= H; z += 2 * H) printf "0 0 %g %.17g %.17g %g %.17g %.17g %g\n", z, x[k], y[k], z, x[k+1], y[k+1], z } }' | stl > star.stl
awk -v n=500 -v state=31415 "$corner $place"'
  function uniform() { state = (16807 * state) % 2147483647; return state / 2147483647 }
  BEGIN {
    printf "star\n\n%d atoms\n1 atom types\n-0.1 0.1 xlo xhi\n-0.1 0.1 ylo yhi\n-0.1 0.1 zlo zhi\n\nAtoms\n\n", n
    while (i < n) {
      p = 0.1 * uniform() - 0.05; q = 0.1 * uniform() - 0.05; z = 2 * H * uniform() - H; r = 0.0005 * (0.3 + 0.7 * uniform())
      if (!inside(p, q) || depth(p, q) < 1.01 * r || H - z < 1.01 * r || H + z < 1.01 * r) continue
      printf "%d 1 %.17g 2500 %.17g %.17g %.17g\n", ++i, 2 * r, p, q, z }
    printf "\nVelocities\n\n"
    for (i = 1; i <= n; i++) {
      w = 2 * uniform() - 1; s = sqrt(1 - w * w); a = 2 * atan2(0, -1) * uniform()
      printf "%d %.17g %.17g %.17g 0 0 0\n", i, 10 * s * cos(a), 10 * s * sin(a), 10 * w } }' > star.data
for step in 2e-4 1e-3; do # v dt = 2 mm, and 10 mm
  { soft "-0.1 0.1 -0.1 0.1 -0.1 0.1" | sed 's/^region .*/read_data star.data/; /^create_box/d'
    echo "neigh_modify exclude group all all
fix star all mesh/surface file star.stl type 1
fix wall all wall/rebound mesh n_meshes 1 meshes star rebound constant 1 1 deposit off ledger 1000 file star.csv
fix move all nve/sphere
timestep $step
thermo_style custom step atoms f_wall[1] f_wall[6]
dump at all custom 50 at.txt id x y z vx vy vz radius
dump_modify at sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g %.17g\"
run $(awk -v s=$step "BEGIN { printf \"%d\", 0.05 / s + 0.5 }")"; } > star.in
  for ranks in 1 2; do
    rm -f star.csv
    engine $ranks star.in
    cp star.csv star.$ranks.csv
    awk "$corner $place"'
      NF == 8 && $1 ~ /^[0-9]+$/ { n++; H2 = $4 < 0 ? H + $4 : H - $4; d = depth($2, $3); if (H2 < d) d = H2
        v = sqrt($5 ^ 2 + $6 ^ 2 + $7 ^ 2)
        if (!inside($2, $3) || !(d > $8 * (1 - 1e-6)) || !(v > 10 * (1 - 1e-9) && v < 10 * (1 + 1e-9))) { print "outside, in the wall, or of another speed: " $0; bad = 1 } }
      END { exit bad || n < 1000 || n % 500 }' at.txt > wrong || { head -n 5 wrong; die "star at a step of $step on $ranks ranks"; }
  done
  same star.1.csv star.2.csv "star on 1 and 2 ranks"
  echo "star, a step of $step: $(count_rows star.1.csv) impacts; $(tail -n 60 star.in.screen | grep -E '^ +[0-9]+ +500 ' | tail -n 1)"
done

# A grain of 2 mm between plates that leave it 1.5 mm: two meshes of one wall, of two, two planes; at rest and thrown.
stl <<< "-0.1 -0.1 0  0.1 -0.1 0  0.1 0.1 0  -0.1 0.1 0" > plate.stl
scene() { # grain, walls, steps
  soft "-0.2 0.2 -0.2 0.2 -0.05 0.05" | sed 's/^neighbor .*/neighbor 0.01 bin/'
  put 0.002 <<< "$1"
  echo "$2
fix move all nve/sphere
timestep 1e-5
variable guarded equal f_low[6]${high:+"+f_high[6]"}
thermo_style custom step f_low v_guarded
thermo 1
dump at all custom 1 at.txt id x y z vx vy vz
dump_modify at sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g\"
run $3"
}
walls() { # kind, height of the upper one, law
  local end="$3 deposit off ledger 1 file narrow.csv"
  [ "$1" = planes ] || echo "fix a all mesh/surface file plate.stl type 1
fix b all mesh/surface file plate.stl type 1 move 0 0 $2"
  case $1 in
    one) echo "fix low all wall/rebound mesh n_meshes 2 meshes a b rebound constant $end" ;;
    two) echo "fix low all wall/rebound mesh n_meshes 1 meshes a rebound constant $end
fix high all wall/rebound mesh n_meshes 1 meshes b rebound constant $3 deposit off" ;;
    planes) echo "fix low all wall/rebound primitive type 1 zplane 0.0 rebound constant $end
fix high all wall/rebound primitive type 1 zplane $2 rebound constant $3 deposit off" ;;
  esac
}
# pictures: a line a step, "STEP X Y Z VX VY VZ GUARDED", the last one the particle's counter until then.
pictures() {
  awk 'FNR == NR { if (NF == 3 && $1 ~ /^[0-9]+$/) guarded[$1] = $3; next }
    /TIMESTEP/ { getline; step = $1 } NF == 7 && $1 == 1 { $1 = step; print $0, guarded[step] }' "$1.screen" at.txt
}
for kind in one two planes; do
  for law in "1 1" "0.5 0.9"; do
    for grain in "0 0 0.0007 0 0 0" "0.01 0 0.0008 0.3 0 -2" "0 0.01 0.0001 0 0 1"; do
      high=; [ $kind = one ] || high=1
      scene "1 $grain" "$(walls $kind 0.0015 "$law")" 100 > narrow.in
      for ranks in $([ $kind = two ] && echo 2 || echo 1); do
        rm -f narrow.csv
        engine $ranks narrow.in
        [ "$(count_rows narrow.csv)" = 0 ] || die "narrow, $kind, $law, $grain: $(count_rows narrow.csv) rows"
        pictures narrow.in | awk -v still="${grain% 0 0 0}" -v grain="$grain" '
          $1 > 50 && ($5 ^ 2 + $6 ^ 2 + $7 ^ 2 > 0 || (still == grain && ($4 - 0.00075) ^ 2 > 1e-20)) { print; bad = 1 }
          END { exit bad || $1 != 100 || (still == grain && !($8 > 0)) }' > wrong ||
          { head -n 3 wrong; die "narrow, $kind, $law, $grain, on $ranks ranks: not caught, or not counted"; }
      done
    done
  done
done

# The upper plate comes down at 0.1 m/s on a grain that has room at first.
for law in "1 1" "0.5 0.9" "0.9 0.9 surface rq 1e-5 lambda_c 1e-4"; do
  for kind in one two; do
    high=; [ $kind = one ] || high=1
    scene "1 0 0 0.0011 0 0 0" "$(walls $kind 0.0023 "$law")
fix down all move/mesh mesh b linear 0. 0. -0.1" 1000 > closing.in
    for ranks in $([ $kind = two ] && echo 2 || echo 1); do
      rm -f narrow.csv
      engine $ranks closing.in
      # From the step on in which the gap is as wide as the grain, it is in the middle of it, with half of its speed.
      pictures closing.in | awk '
        $1 > 300 && (($7 + 0.05) ^ 2 > 1e-20 || $5 ^ 2 + $6 ^ 2 > 1e-6 || ($4 - (0.0023 - 1e-6 * $1) / 2) ^ 2 > 1e-14) { print; bad = 1 }
        $1 > 300 && !($8 > before) { print "not counted: " $0; bad = 1 }
        { before = $8 } END { exit bad || $1 != 1000 }' > wrong || { head -n 3 wrong; die "closing, $law, $kind, on $ranks ranks"; }
      [ "$(count_rows narrow.csv)" -lt 100 ] || die "closing, $law, $kind: $(count_rows narrow.csv) rows"
      ! rows narrow.csv | awk -F, '$3 > 300e-5' | grep . || die "closing, $law, $kind: rows of a grain that is caught"
    done
  done
done
