#!/usr/bin/env bash
# Bodies of LIGGGHTS's fix multisphere at walls: a dumbbell's first hit, a rod that lands flat, sliding, rolling and
# rest, a gas of rods in a rough box, long steps, one sphere as a body, and ranks.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"

source "$here/body_scene.sh"

# The first hit: CoR_N of the center is 1 - 2 q/(1 + q), q = (5/7) cos^2 theta, by the lever in the row. The engine's
# inertia is a sum over random points.
{ bodies 1500 random -0.012 0.019
  echo "fix floor all wall/rebound primitive type 1 zplane -0.02 rebound walton 1 0 0 deposit off ledger 1 file first.csv columns full
timestep 2e-5
run 1200"; } > first.in
engine 1 first.in
rows first.csv | awk -F, '$26 == -1.5 && $30 == 0 && $31 == 0 && !($40 in seen) { seen[$40] = 1; n++
    q = 5 / 7 * ($41 ^ 2 + $42 ^ 2) / 0.25e-6; d = $17 - (1 - 2 * q / (1 + q)); if (d < 0) d = -d
    if (d > 0.003) bad = 1; s += $17; t += $17 ^ 2 }
  END { m = s / n; sd = sqrt(t / n - m * m); print "first hits: " n ", mean CoR_N " m " (0.3872), sd " sd " (0.2268)"
    exit bad || n < 1000 || m < 0.36 || m > 0.414 || sd < 0.215 || sd > 0.238 }' || die "the first hit of a dumbbell"

# The same ledger on 1, 2 and 4 ranks, of rough walls with friction; the engine inserts by rank, so that the bodies come
# from a restart file.
poured 300 ranks.bin
{ from_restart ranks.bin
  closed surface sigma 10 rebound walton 0.9 0.3 0 deposit off ledger 1 file LEDGER.csv columns full | sed 's/^fix \([^ ]*\) \(.*\)LEDGER/fix \1 \2\1/'
  echo "timestep 2e-5
run 1000"; } > ranks.in
for ranks in 1 2 4; do
  engine $ranks ranks.in
  for plane in xlo xhi ylo yhi zlo zhi; do grep -v -e "^#" -e "^tag" $plane.csv || true; rm $plane.csv; done > ranks.$ranks
done
[ "$(wc -l < ranks.1)" -gt 250 ] || die "ranks: $(wc -l < ranks.1) impacts"
same ranks.1 ranks.2 "2 ranks"; same ranks.1 ranks.4 "4 ranks"

# A rod that lands flat: both ends at once, V -> -e V without spin, as far as the engine puts the center of mass between
# its spheres (it is 3e-4 of a diameter off).
{ bodies 20 "constant 1 0 0 0" -0.012 0.019
  echo "fix floor all wall/rebound primitive type 1 zplane -0.02 rebound walton 0.8 0.3 0 deposit off ledger 1 file flat.csv columns full
timestep 2e-5
run 1000"; } > flat.in
engine 1 flat.in
check_rows flat.csv 'abs(r.v2z - 1.2) < 1e-4 and hypot(r.omega2x, r.omega2y, r.omega2z) < 4 and abs(r.v2y) < 2e-3' "a rod lands flat"

# On a slope: a rod across it rolls with 5/7 g sin theta, along it slides with g (sin theta - mu cos theta); at rest the
# wall carries the weight.
slope() { # NAME ORIENTATION DEGREES
  { velocity="0 0 0"; right=-0.005; bodies 5 "$2" -0.0199 -0.0170
    echo "fix floor all wall/rebound primitive type 1 zplane -0.02 rebound walton 0.5 0.2 0 deposit off
fix g all gravity 9.81 vector $(awk -v a="$3" 'BEGIN { a *= 3.14159265358979 / 180; print sin(a), 0, -cos(a) }')
compute v all reduce ave vx
thermo_style custom step atoms c_v f_floor[9]
timestep 2e-5
thermo 1000
run 7000"; } > slope.$1.in
  engine 1 slope.$1.in
  grep -E '^ +[57]000 ' slope.$1.in.screen | awk '{ v[NR] = $3; f = $4; m = $2 * 2500 * 0.523598775598e-9 } END { printf "%.6g %.6g\n", (v[2] - v[1]) / 0.04, -f / m }'
}
read -r a _ < <(slope across "constant 0.70710678118 0 0 0.70710678118" 10)
awk -v a="$a" 'BEGIN { s = 5 / 7 * 9.81 * sin(10 * 3.14159265358979 / 180); print "rolls: " a " (" s ")"; exit a < 0.99 * s || a > 1.01 * s }' || die "a rod that rolls: $a"
read -r a _ < <(slope along "constant 1 0 0 0" 20)
awk -v a="$a" 'BEGIN { t = 20 * 3.14159265358979 / 180; s = 9.81 * (sin(t) - 0.2 * cos(t)); print "slides: " a " (" s ")"; exit a < 0.99 * s || a > 1.01 * s }' || die "a rod that slides: $a"
read -r a f < <(slope rest "constant 1 0 0 0" 5)
awk -v a="$a" -v f="$f" 'BEGIN { g = 9.81 * cos(5 * 3.14159265358979 / 180); print "rests: " a ", carries " f " (" g ")"; exit a ^ 2 > 1e-8 || f < 0.999 * g || f > 1.001 * g }' || die "a rod at rest: $a $f"

# An elastic gas in a rough box: energy stays as far as the engine turns bodies right, E_rot/E_trans becomes 2/3
# (frictionless walls do not spin a dumbbell about its axis); at steps of 100 diameters nothing crosses. There the engine
# turns a body by many radians per step, which does not keep its energy of rotation. BODIES=2000 flies 10^5 such steps.
gas() { # NAME COUNT STEP STEPS
  { velocity="0.5 -0.8 -1.2"; bodies $2 random -0.018 0.018 | sed "${BODIES:+s/overlapcheck yes/overlapcheck no/}"
    closed surface sigma 10 rebound constant 1 1 deposit off
    echo "variable out atom (x<-0.0195001)||(x>0.0195001)||(y<-0.0195001)||(y>0.0195001)||(z<-0.0195001)||(z>0.0195001)
compute out all reduce sum v_out
thermo_style custom step c_ke c_re c_out
timestep $3
thermo $(($4 / 50))
run $4"; } > gas.$1.in
  engine 1 gas.$1.in
  awk -v all="$4" 'NF == 4 && $1 ~ /^[0-9]+$/ && $1 > 0 && $2 + 0 > 0 { e = $2 + $3; if (!first) first = e; d = e / first - 1; if (d < 0) d = -d; if (d > worst) worst = d; out += $4
      if ($1 > all / 4) { n++; r += $3 / $2 } }
    END { printf "%.3g %d %.4f\n", worst, out, n ? r / n : -1 }' gas.$1.in.screen
}
read -r drift out ratio < <(gas short 500 1e-4 3000)
echo "gas: energy off by $drift, $out outside, E_rot/E_trans $ratio (0.6667)"
awk -v d="$drift" -v o="$out" -v r="$ratio" 'BEGIN { exit d > 0.01 || o || r < 0.6 || r > 0.73 }' || die "a gas of rods: $drift $out $ratio"
read -r _ out _ < <(gas long ${BODIES:-200} 0.06 50)
echo "gas at 100 diameters per step: $out outside"
[ "$out" = 0 ] || die "long steps: $out"

# Words that bodies refuse.
refuses() { # WORDS, part of the message
  { bodies 5 random -0.012 0.019; echo "fix floor all wall/rebound primitive type 1 zplane -0.02 $1
timestep 2e-5
run 1"; } > bad.in
  ! timeout 60 "$program" -in bad.in -log none > bad.screen 2>&1 || die "runs with: $1"
  grep -q "$2" bad.screen || die "$1: $(tail -n 3 bad.screen)"
}
refuses "rebound walton 0.9 0.3 0.4 deposit off" "BETA0 0"
