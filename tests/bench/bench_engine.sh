#!/usr/bin/env bash
# The fix in LIGGGHTS: its share of the flat-plate case; a whole case against LIGGGHTS's own resolved contact
# at the real modulus; 10^6 particles on two ranks: memory, share, and time over contacts.
set -euo pipefail
bin=$ASPERITY_BIN
[ -x "$bin/liggghts-asperity" ] || { echo "the fix in LIGGGHTS: not built"; exit 0; }
home=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
cd "$work"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
row() { awk -v what="$1" -v value="$2" -v unit="$3" -v sign="$4" -v limit="$5" 'BEGIN {
  good = sign == "<=" ? value <= limit : value >= limit
  printf "%s\t%.3g %s\t%s %g\t%s\n", what, value, unit, sign, limit, good ? "yes" : "NO" }'; }
engine() { mpirun -np "$1" "$bin/liggghts-asperity" -in "$2" -log none "${@:3}" > "$2.screen" 2>&1 || { tail -n 5 "$2.screen" >&2; exit 1; }; }
# share SCREEN: the fix's part of the loop, in percent, summed over its hooks (slowest rank).
share() { awk '/^Loop time/ { loop = $4 } /^Fix wall wall\/rebound time/ { sub(/.*= */, ""); fix = $1 } END { print 100 * fix / loop }' "$1"; }
median() { sort -g | awk '{ x[NR] = $1 } END { print x[int((NR + 1) / 2)] }'; }

# The flat plate as it comes, rough, on two ranks.
mkdir output
awk -f "$home/examples/flat_plate/make_plate.awk" > output/plate.stl
awk -f "$home/examples/flat_plate/make_jet.awk" > output/jet.data
sed 's/^run /modify_timing on\nrun /' "$home/examples/flat_plate/in.flat_plate" > plate.in
sed '/ ledger 2000/d; s/seed 1 &$/seed 1/' plate.in > quiet.in
for k in 1 2 3; do
  for deck in plate quiet; do
    begun=$(date +%s.%N)
    engine 2 $deck.in -var name plate -var surface "rq 15.6e-6 lambda_c 120e-6"
    share $deck.in.screen >> $deck.share
    awk -v a="$begun" -v b="$(date +%s.%N)" '/^Fix wall wall\/rebound time/ { sub(/.*= */, ""); print 100 * $1 / (b - a) }' $deck.in.screen >> $deck.whole
  done
done
row "flat plate: the fix, ledger and all, of the run" "$(median < plate.whole)" "%" "<=" 10
row "flat plate: the fix, ledger and all, of a step" "$(median < plate.share)" "%" "<=" 5
row "flat plate: the fix without a ledger, of a step" "$(median < quiet.share)" "%" "<=" 5

# 20 000 grains of 10 um at 100 m/s on a plate for 60 us: rebound with its step, and hertz with a tenth of the
# Rayleigh time.
awk 'BEGIN { n = 20000; print "g\n\n" n " atoms\n2 atom types\n\n-0.0002 0.006 xlo xhi\n-0.0002 0.006 ylo yhi\n-0.0005 0.0065 zlo zhi\n\nAtoms\n"
  for (i = 1; i <= n; i++) printf "%d 1 1e-5 2650 %.12g %.12g %.12g\n", i, 4e-5 * (i % 142), 4e-5 * int(i / 142), 1e-5 + 5e-4 * (i % 997) / 997
  print "\nVelocities\n"; for (i = 1; i <= n; i++) print i, "0 0 -100 0 0 0" }' > drop.data
drop() { # name, wall, step
  cat > "$1.in" << END
units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
hard_particles yes
read_data drop.data
neighbor 2e-5 bin
neigh_modify delay 0 binsize 2e-4 exclude group all all
fix m1 all property/global youngsModulus peratomtype 70e9 205e9
fix m2 all property/global poissonsRatio peratomtype 0.17 0.32
fix m3 all property/global yieldStress peratomtype 200e6 200e6
fix m4 all property/global surfaceEnergy peratomtypepair 2 0.8 0.8 0.8 0.8
fix m5 all property/global coefficientFriction peratomtypepair 2 0.3 0.3 0.3 0.3
fix m6 all property/global coefficientRestitution peratomtypepair 2 0.9 0.9 0.9 0.9
pair_style gran model hertz tangential history
pair_coeff * *
fix move all nve/sphere
fix wall all $2
timestep $3
compute ke all ke
thermo_style custom step c_ke
thermo 100000
run $(awk -v dt="$3" 'BEGIN { printf "%d", 6e-5 / dt + 0.5 }')
END
}
drop rebound 'wall/rebound primitive type 2 zplane 0.0 surface smooth' 4e-8
drop hertz 'wall/gran model hertz tangential history primitive type 2 zplane 0.0' 5e-10
seconds() { local begun; begun=$(date +%s.%N); engine 1 "$1.in"; awk -v a="$begun" -v b="$(date +%s.%N)" 'BEGIN { print b - a }'; }
hertz=$(seconds hertz)
for k in 1 2 3; do seconds rebound; done > rebound.times
row "20 000 grains, 60 us: resolved Hertz contact over rebound" "$(awk -v a="$hertz" -v b="$(median < rebound.times)" 'BEGIN { print a / b }')" "x" ">=" 20
energy() { awk '/^ +Step/ { on = 1; next } on && NF == 2 && $1 > 0 { e = $2 } END { print e / (20000 * 2650 * 3.14159265 / 6 * 1e-15 * 5000) }' "$1.in.screen"; }
bons=$("$bin/asperity" cor --model none --dp 10um --angles 90 --samples 1 | awk -F, 'NR == 3 { print $8 * $8 }')
printf 'energy left after the impact: the Bons law\t%.3g\t-\t-\n... wall/rebound\t%.3g\t-\t-\n... resolved Hertz with e = 0.9\t%.3g\t-\t-\n' "$bons" "$(energy rebound)" "$(energy hertz)"

# 10^6 grains on two ranks, half of them hitting in 50 steps; the same with a tenth of the hits.
million() { # name, share that hits
  awk -v hits="$2" 'BEGIN { n = 1000000; print "g\n\n" n " atoms\n2 atom types\n\n-0.001 0.041 xlo xhi\n-0.001 0.041 ylo yhi\n-0.0005 0.001 zlo zhi\n\nAtoms\n"
    for (i = 1; i <= n; i++) { hit = (i % 10) < 10 * hits; printf "%d 1 1e-5 2650 %.9g %.9g %.9g\n", i, 4e-5 * (i % 1000), 4e-5 * int(i / 1000), hit ? 6e-6 + 8e-5 * (i % 97) / 97 : 2e-4 }
    print "\nVelocities\n"; for (i = 1; i <= n; i++) print i, "30 0", (i % 10) < 10 * hits ? -40 : 0, "0 0 0" }' > drop.data
  drop "$1" 'wall/rebound primitive type 2 zplane 0.0 surface rq 5e-6 lambda_c 40e-6' 4e-8
  sed -i 's/^run .*/modify_timing on\nrun 50/' "$1.in"
  sed -i 's/^thermo_style .*/thermo_style custom step f_wall/' "$1.in"
  mpirun -np 2 "$bin/liggghts-asperity" -in "$1.in" -log none > "$1.in.screen" 2>&1 &
  local job=$!
  while kill -0 $job 2> /dev/null; do
    for pid in $(pgrep -f "liggghts-asperity -in $1.in" || true); do awk -v pid="$pid" '/^VmHWM/ { print pid, $2 }' "/proc/$pid/status" 2> /dev/null || true; done >> "$1.memory"
    sleep 0.2
  done
  wait $job || { tail -n 5 "$1.in.screen" >&2; exit 1; }
}
contacts() { awk '/^ +50 / { n = $2 } END { print n }' "$1.in.screen"; }
fix_seconds() { awk '/^Fix wall wall\/rebound time/ { sub(/.*= */, ""); print $1 }' "$1.in.screen"; }
million many 0.5
million few 0.1
row "10^6 grains, 2 ranks: memory of both" "$(awk '$2 > m[$1] { m[$1] = $2 } END { for (p in m) s += m[p]; print s / 1048576 }' many.memory)" "GiB" "<=" 4
row "10^6 grains: the fix of a run" "$(share many.in.screen)" "%" "<=" 10
awk -v a="$(fix_seconds many)" -v b="$(fix_seconds few)" -v m="$(contacts many)" -v f="$(contacts few)" 'BEGIN {
  printf "10^6 grains: one more contact costs the fix\t%.3g us\t-\t-\n", 1e6 * 2 * (a - b) / (m - f) }'
