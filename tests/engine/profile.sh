#!/usr/bin/env bash
# Measured profiles and maps as the wall: the log states them, and sigma per diameter, as `asperity surface` has it; what is
# doubtful is told once; impacts are the same on 1 and 2 ranks, in all units, and after a restart; each size has its own
# heights. A bad file, one that a rank cannot read, and memory that runs out on one end the run with one error.
# Usage: profile.sh LIBRARY (fail_memory.c)
# SPDX-License-Identifier: GPL-3.0-or-later
library=${1:-}
source "$(dirname "$0")/engine.sh"
"$bin/asperity" surface surface rq 8um lambda_c 25um seed 3 --points 20000 --save wall.csv -o /dev/null
script() { # DATA SURFACE RUNS, in $units of `length`, `time`, `pa` and `jm2`
  flying $1
  echo "timestep $(mul 1e-8 "${time:-1}")
fix wall all wall/rebound primitive type 2 zplane 0.0 surface $2 ledger 400 file \${out}"
  printf '%b\n' "$3"
}
grains 300 > si.data
grains 300 1e6 1 1e-3 > micro.data
wall='profile wall.csv dp_bins 7 spread truncated'
script si.data "$wall" 'run 400' > si.in
units=micro length=1e6 time=1e6 pa=1e-3 jm2=1e3 script micro.data "$wall" 'run 400' > micro.in
engine 1 si.in -var out si.csv
engine 2 si.in -var out two.csv
same si.csv two.csv "1 and 2 ranks"
engine 1 micro.in -var out micro.csv
awk -F, -v OFS=, -v OFMT=%.12g -v CONVFMT=%.12g '/^#/ || /^tag/ { print; next } { $3 /= 1e6; for (i = 6; i <= 9; i++) $i /= 1e6; print }' micro.csv > micro.si.csv
near si.csv micro.si.csv "tag impact time d_p v1 alpha1_deg delta_alpha_deg hits v2 alpha2_deg cor_n cor_t outcome" 1e-6
[ "$(count_rows si.csv)" -ge 300 ] || die "too few impacts"

# The log: file, numbers, and sigma of each bin.
grep -q 'profile wall.csv (20000 points read' si.in.screen && grep -q 'uncertain by about' si.in.screen || die "the log does not state the profile"
! grep WARNING si.in.screen | grep -qE 'dust|covers|clipped|correlation lengths' || die "a warning of a good profile"
grep -E '^  bin [0-9]+: d_p' si.in.screen | tr -d , | awk '{ print $4, $6 }' > bins
while read -r d_p _; do "$bin/asperity" surface surface profile wall.csv --dp "$d_p" | tail -n 1 | cut -d, -f12; done < bins > sigmas
table bins=<(paste -d' ' bins sigmas) 'assert len(bins) == 7 and all(near(r[1], r[2], 2e-3) for r in bins)
assert all(b[1] <= a[1] for a, b in zip(bins, bins[1:]))' || die "sigma of the bins: $(cat bins)"

# A doubtful profile, and a doubtful map: one warning each, once for all runs.
awk 'NR == 3000 { sub(/,.*/, ",90") } 1' wall.csv > dusty.csv
awk -F, '/^#/ || /^x/ { print; next } n++ % 8 == 0 && n < 1200' wall.csv > coarse.csv
awk 'BEGIN { printf "# Width: 200 um\n# Height: 200 um\n# Value units: um\n"; srand(5); for (k = 0; k < 30; k++) { a[k] = 6.28 * rand(); b[k] = (0.1 + 0.01 * k) * cos(2.4 * k); c[k] = (0.1 + 0.01 * k) * sin(2.4 * k) }
  for (j = 0; j < 100; j++) for (i = 0; i < 100; i++) { z = j == 40 && i == 70 ? 8 : 0; for (k = 0; k < 30; k++) z += 0.1 * sin(b[k] * i + c[k] * j + a[k]); printf "%.5f%s", z, i < 99 ? "\t" : "\n" } }' > map.txt
doubts="profile dusty.csv: .* of 20000 points .* as dust does
profile coarse.csv: a particle of d_p .* covers .* points .* only .* correlation lengths long
map map.txt: .* of 10000 points .* as dust does
map map.txt: a particle of d_p .* covers .* points"
while read -r doubt; do
  script si.data "${doubt%%:*} dp_bins 2" 'run 1\nrun 1' > doubt.in
  engine 2 doubt.in -var out doubt.csv
  [ "$(grep -c "WARNING: .*$doubt" doubt.in.screen)" = 1 ] || die "no '$doubt': $(grep WARNING doubt.in.screen)"
done <<< "$doubts"

# A restart, after the small grains have been taken out: the bins are those of the whole run.
lost='thermo_modify lost ignore\nrun'
script si.data "$wall deposit delete" "$lost 200\nwrite_restart half.restart\nrun 200" > whole.in
script half.restart "$wall deposit delete" "$lost 200" > rest.in
engine 1 whole.in -var out whole.csv
mv whole.csv all.csv
sed -i '$d' whole.in; engine 1 whole.in -var out whole.csv; engine 2 rest.in -var out whole.csv
same all.csv whole.csv "one run and a restart"

# The tilts of small and of large grains are as the command has them for that size alone.
awk 'BEGIN { n = 1500; print "grains\n\n" 2 * n " atoms\n2 atom types\n\n-1e-3 1.51e-1 xlo xhi\n-1e-3 1e-3 ylo yhi\n-5e-4 1e-3 zlo zhi\n\nAtoms\n"
  for (i = 1; i <= 2 * n; i++) { d = i > n ? 60e-6 : 5e-6; print i, 1, d, 2650, 1e-4 * (i % n), (i > n ? 5e-4 : -5e-4), d / 2 + 5e-6 }
  print "\nVelocities\n"; for (i = 1; i <= 2 * n; i++) print i, 86.60254, 0, -50, 0, 0, 0 }' > sizes.data
law='spread traced rebound constant 1 1'
script sizes.data "profile wall.csv dp_bins 4 $law deposit off" 'run 100' > sizes.in
engine 1 sizes.in -var out sizes.csv
for d_p in 5 60; do
  "$bin/asperity" cor surface profile wall.csv dp_bins 4 $law --dp ${d_p}um --angles 30 --samples 1500 > command.csv
  table fix=sizes.csv command=command.csv "
fix = [row.delta_alpha_deg for row in fix if row.impact == 1 and near(row.d_p, ${d_p}e-6, 0.1)]
command = [row.delta_alpha_deg for row in command]
assert len(fix) == len(command) == 1500 and near(sd(fix), sd(command), 0.1) and abs(mean(fix) - mean(command)) < 0.13 * sd(command)" || die "tilts of $d_p um"
done

# Bad files, and one that a rank does not find.
printf '0 0\n1 1\n2 0\n3 1\n' > nounit.txt
awk 'BEGIN { print "x_um,z_um"; for (i = 0; i < 2000; i++) print 10 * i "," sin(i / 7) + sin(i / 3.1) }' > coarse.csv
export OPTIONS='-var out bad.csv'
while IFS=: read -r surface words; do
  script si.data "$surface" 'run 1' > bad.in
  refuses 2 bad.in $words
done << END
profile nowhere.csv:nowhere.csv No such file
profile nounit.txt:nounit.txt unit
profile coarse.csv:coarse.csv spacing 1e-05
rq 1e-4 lambda_c 4e-5:their ratio
END
script si.data "$wall" 'run 1' > bad.in
mkdir elsewhere
one=("$program" -in bad.in -log none -var out bad.csv)
! timeout 60 mpirun -np 1 "${one[@]}" : -np 1 -wdir elsewhere "${one[@]}" > bad.screen 2>&1 || die "accepted: a file for one rank"
grep -q "^ERROR.*the file 'wall.csv' cannot be read by all ranks" bad.screen || { tail bad.screen; die "a file for one rank"; }
# Memory for 20000 heights, which one rank has, and the other does not wait for it. (Each allocation: unit/test_memory.c.)
[ -z "$library" ] || ! timeout 60 mpirun -np 1 "${one[@]}" : -np 1 -x LD_PRELOAD="$library" -x FAIL_FROM=160000 -x FAIL_TO=170000 "${one[@]}" > bad.screen 2>&1 || die "ran without memory"
[ -z "$library" ] || grep -aq '^ERROR.*out of memory' bad.screen || { tail bad.screen; die "memory of the second rank"; }
