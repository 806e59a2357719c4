#!/usr/bin/env bash
# A wall is rough at every contact: grains that roll, hop or lie on it. Their speed on a slope is that of a sphere over
# generated walls, whatever the step and whether they are dropped or laid down; grains laid at rest start at the angles
# of their valleys, and below these a force that turns moves none; the ledger is that of any number of ranks, of a
# restart in the middle of a face, and of the other engine. The physics runs in LAMMPS: it is the same code.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
use lammps
down() { awk -v a="$1" -v g="${2:-1}" 'BEGIN { a *= atan2(0, -1) / 180; printf "%.17g vector %.17g 0 %.17g", g, sin(a), -cos(a) }'; }
# slope D COUNT SPEED HEIGHT: grains without contact to each other over the plane z = 0, apart by 5 D.
slope() {
  head_of si
  awk -v d="$1" -v n="$2" -v v="$3" -v h="$4" 'BEGIN {
    side = int(sqrt(n) + 0.999)
    printf "grains\n\n%d atoms\n1 atom types\n\n%g %g xlo xhi\n%g %g ylo yhi\n%g %g zlo zhi\n\nAtoms\n\n", n, -100 * d, 500 * d, -200 * d, 200 * d, -d, 40 * d > "grains.data"
    for (i = 0; i < n; i++) printf "%d 1 %g 1 %.15g %.15g %.15g\n", i + 1, d, 5 * d * (i % side), 5 * d * int(i / side), d / 2 + h > "grains.data"
    print "\nVelocities\n" > "grains.data"
    for (i = 0; i < n; i++) printf "%d %g 0 0 0 0 0\n", i + 1, v > "grains.data" }'
  echo "read_data grains.data
neighbor $1 bin
neigh_modify delay 0 exclude group all all
$(springs)
fix move all nve/sphere
thermo 1000000"
}
pictures() { echo "dump at all custom $1 at.txt id x z vx
dump_modify at sort id format \"%d %.12g %.12g %.12g\""; }

# rolling SPREAD STEP: units of gravity and lambda_c, as in the reference: slope rms 0.2, d 4, 5 degrees, e 0.5, mu 0.3;
# the mean speed over times 100 to 200, and its standard error.
rolling() {
  local half=$(awk -v dt="$2" 'BEGIN { printf "%d", 100 / dt }')
  slope 4 49 1.5 0.01 > roll.in
  echo "fix fall all gravity $(down 5)
fix wall all wall/rebound primitive type 1 zplane 0.0 surface rq 0.1414213562m lambda_c 1m spread visible $1 rebound walton 0.5 0.3 0 deposit off
timestep $2
$(pictures "$half")
run $((2 * half))" >> roll.in
  engine 1 roll.in
  awk -v half="$half" -v dt="$2" '/^ITEM/ { data = /: ATOMS/; picture += data; next }
    data && picture == 2 { x[$1] = $2 } data && picture == 3 { v = ($2 - x[$1]) / (half * dt); n++; s += v; q += v * v }
    END { m = s / n; printf "%.4f %.4f\n", m, sqrt((q / n - m * m) / n) }' at.txt
}
for spread in plane isotropic; do
  read -r fast error <<< "$(rolling $spread 0.1)"
  read -r slow other <<< "$(rolling $spread 0.02)"
  # The truth, by geometry alone (tests/sweep/rolling.csv): 1.285 on profiles, 1.13 on surfaces. Without kinks it is 1.5 on both.
  awk -v a="$fast" -v b="$slow" -v se="$error" -v so="$other" -v truth="$([ $spread = plane ] && echo 1.285 || echo 1.13)" '
    BEGIN { exit !((b - truth) ^ 2 < (0.12 * truth) ^ 2 && (a - b) ^ 2 < (0.05 * b) ^ 2 + 9 * (se ^ 2 + so ^ 2)) }' ||
    die "$spread: rolls at $fast +- $error and $slow +- $other"
done

# Laid at rest, or dropped from a height, on a slope of 20 degrees: those that move, move alike, whatever the step. With
# HEIGHTS="0 1e-6 1e-4" STEPS="1e-3 1e-4 1e-5" it prints the table of the README and ends.
read -ra heights <<< "${HEIGHTS:-0 1e-4}"
read -ra steps_of <<< "${STEPS:-1e-3 2e-4}"
for height in "${heights[@]}"; do
  for step in "${steps_of[@]}"; do
    steps=$(awk -v dt="$step" 'BEGIN { printf "%d", 1 / dt }')
    slope 0.002 196 0 $height > skim.in
    echo "fix fall all gravity $(down 20 9.81)
fix wall all wall/rebound primitive type 1 zplane 0.0 surface sigma 10 rebound walton 0.5 0.3 0 deposit off
timestep $step
$(pictures "$steps")
run $steps" >> skim.in
    engine 1 skim.in
    awk -v what="$height $step" '/^ITEM/ { data = /: ATOMS/; picture += data; next } data && picture == 2 && $4 > 0.01 { n++; s += $4; q += $4 * $4 }
      END { m = s / n; print what, n, m, sqrt((q / n - m * m) / n) }' at.txt
  done
done > skim.txt
[ -z "${STEPS:-}" ] || { echo "height step grains that move, mean speed, standard error"; cat skim.txt; exit; }
awk '{ n[NR] = $3; v[NR] = $4; e[NR] = $5 } END { if (NR != 4) exit 1
  for (i = 2; i <= NR; i++) if ((v[i] - v[1]) ^ 2 > (0.05 * v[1]) ^ 2 + 9 * (e[i] ^ 2 + e[1] ^ 2)) exit 1
  for (i = 1; i < NR; i += 2) if (n[i] - n[i + 1] > 12 || n[i + 1] - n[i] > 12) exit 1 }' skim.txt || { cat skim.txt; die "the speed on a slope depends on the step or on how grains came there"; }

# Valleys hold what is laid at rest up to an angle of their own: tan(start)/s_eff of the Rayleigh distribution, of the
# larger of two on a surface. 10 degrees of sigma: shares that have started at three slopes.
for spread in plane isotropic; do
  slope 0.002 400 0 0 > start.in
  echo "fix wall all wall/rebound primitive type 1 zplane 0.0 surface sigma 10 spread visible $spread rebound walton 0.5 0.3 0 deposit off
timestep 1e-3" >> start.in
  for angle in 8 13 20; do
    echo "fix fall all gravity $(down $angle 9.81)
run 100
dump at all custom 1 at.$angle.txt id x
run 0
undump at"
  done >> start.in
  # Around below the last angle: none that lies moves any more.
  for turn in 0 1 2 3 4 5 6 7; do
    echo "fix fall all gravity $(awk -v k=$turn 'BEGIN { pi = atan2(0, -1); a = 19.9 * pi / 180; w = k * pi / 4; printf "9.81 vector %.17g %.17g %.17g", sin(a) * cos(w), sin(a) * sin(w), -cos(a) }')
run 50"
  done >> start.in
  echo "dump at all custom 1 at.end.txt id x
run 0" >> start.in
  engine 1 start.in
  for angle in 8 13 20 end; do
    awk -v angle=$angle -v power=$([ $spread = plane ] && echo 1 || echo 2) '/^ITEM/ { data = /: ATOMS/; next }
      data { away = $2 - 0.01 * (($1 - 1) % 20); n++; out += away * away > 1e-24 }
      END { pi = atan2(0, -1); tan_a = sin((angle == "end" ? 20 : angle) * pi / 180) / cos((angle == "end" ? 20 : angle) * pi / 180); x = tan_a / (sin(pi / 18) / cos(pi / 18))
        share = (1 - exp(-x * x / 2)) ^ power; d = out / n - share; if (d * d > 12 * share * (1 - share) / n + 1e-4) { print angle, out / n, share; exit 1 } }' "at.$angle.txt" ||
      die "$spread: grains laid at rest start at other slopes"
  done
done

# One ledger: any number of ranks, a restart in the middle of faces, the other engine. A belt with a lay and a rough
# wall beside it, at which half of the grains come to roll in the corner.
tracks() { # RUNS
  slope 0.002 64 0.3 5e-4
  echo "fix fall all gravity 9.81 vector 0.3 -0.35 -0.9
fix wall all wall/rebound primitive type 1 zplane 0.0 shear x 0.05 surface rq 2e-4m lambda_c 1.5e-3m 4e-3m lay 1 1 0 rebound walton 0.5 0.3 0 deposit off ledger 100 file \${out}
fix side all wall/rebound primitive type 1 yplane -0.0015 surface sigma 10 rebound walton 0.5 0.3 0 deposit off ledger 100 file side.\${out}
timestep 2e-4
$1"
}
tracks 'run 1500' > tracks.in
tracks 'run 700
write_restart half.restart' > half.in
{ tracks 'run 800' | sed 's/^read_data.*/read_restart half.restart/'; } > rest.in
for engine in lammps liggghts; do
  use $engine
  for ranks in 1 2 4; do
    [ "$engine $ranks" != "liggghts 4" ] || continue
    engine $ranks tracks.in -var out $engine.$ranks.csv
  done
  rm -f parts.csv side.parts.csv
  engine 2 half.in -var out parts.csv
  engine 1 rest.in -var out parts.csv
  for file in "" side.; do
    same ${file}$engine.1.csv ${file}$engine.2.csv "$engine on 1 and 2 ranks"
    [ $engine = liggghts ] || same ${file}$engine.1.csv ${file}$engine.4.csv "1 and 4 ranks"
    same ${file}$engine.1.csv ${file}parts.csv "$engine, a restart in the middle of faces"
    n=$(count_rows ${file}$engine.1.csv); [ "$n" -gt 50 ] || die "$engine: only $n impacts"
  done
done
for file in "" side.; do same <(rows ${file}lammps.1.csv) <(rows ${file}liggghts.1.csv) "both engines"; done
