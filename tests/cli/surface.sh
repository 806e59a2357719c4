#!/usr/bin/env bash
# The command surface: columns, measured profiles, seeds, threads, messages, files, pictures.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"
columns=dp_um,rq_um,lambda_c_um,phi_r,kappa,slope_rms,sigma_deg,angle_mean_deg,angle_sd_deg,angle_kurtosis,kl_normal,tilt_sigma_deg

# A generated wall: its columns, its numbers, its seed.
"$asperity" surface surface rq 5um lambda_c 40um --dp 10um,55um,400um -o a
grep -v '^#' a | head -n 1 | grep -qx "$columns" || die "surface: columns"
rows a | awk -F, 'function off(x, y) { d = x / y - 1; return d > 0.03 || d < -0.03 }
  off($6, $1 < 100 ? 0.1768 : 0.1290) || off($7, $1 < 100 ? 10.03 : 7.35) || off($9, $1 < 100 ? 9.835 : 7.29) || off($4, 0.125) { exit 1 }
  off($12, $1 < 100 ? 10.02 : 6.49) || $11 < 0 || $11 > 0.01 || $8 > 0.1 || $8 < -0.1 { exit 1 } END { exit NR != 3 }' || die "surface: numbers: $(cat a)"
made() { "$asperity" surface surface rq 5um lambda_c 40um "$@" --dp 10um,55um --points 131072; }
made --save profile.csv > a; made > b; made seed 2 > c
cmp <(rows a) <(rows b) || die "surface: the same seed, other numbers"
cmp -s <(rows a) <(rows c) && die "surface: another seed, the same numbers"

# A saved wall reads back as the same wall.
"$asperity" surface surface profile profile.csv --dp 10um,55um > m
paste -d, <(rows m) <(rows a) | awk -F, 'function off(x, y, part) { d = x / y - 1; return d > part || d < -part }
  off($2, 5, 0.05) || off($3, 40, 0.05) || off($6, $18, 1e-3) || off($9, $21, 1e-3) { exit 1 } END { exit NR != 2 }' || die "surface --profile: $(cat m a)"
grep -q '^# profile profile.csv: 131072 points read, 0 bad' m || die "surface --profile: the file is not described"
grep -q '^# for particles of 10 um by numbers: surface rq [45].*um rdq 0.1[78]' m || die "surface --profile: words: $(cat m)"
! grep -q 'more than one wave' m || die "a wall of one wave has more: $(cat m)"


# What is read is not replaced.
for output in "-o profile.csv" "--save ./profile.csv"; do
  refuses 2 "which is read" -- surface surface profile profile.csv --dp 10um $output
done

# Options of the reader.
awk 'BEGIN { srand(1); for (i = 0; i < 3000; i++) { z = z * 0.95 + rand() - 0.5
  if (i >= 500 && i < 504) continue
  printf "%.1f;%s\n", i * 0.5, i == 900 ? "nan" : i == 1500 ? 80 : z + i * 0.02 + 1e-6 * i * i } }' > raw.txt
"$asperity" surface surface profile raw.txt --unit um --gaps fill --spikes 20 --form 2 --dp 20um > m 2> err
grep -q ' 1 bad, unequal spacing .*, 1 spikes, 6 points filled in (longest gap 4)' m || die "gaps: $(cat m)"
grep -q 'polynomial of degree 2' m || die "form"
! grep -q 'as dust does' err || die "dust that was taken out is told"
# dust gives a warning without --spikes
"$asperity" surface surface profile raw.txt --unit um,nm --gaps fill --dp 20um > m 2> err
grep -q 'phi_r 0.00' m || die "--unit um,nm"
grep -q 'warning: raw.txt: 1 of 2995 points .* --spikes 12' err || die "dust is not told"
printf 'aISO-1.0\nNumPoints = 200\nNumProfiles = 40\nXscale = 1e-6\nYscale = 2e-6\nZscale = 1e-6\n*\n' > map.sdf
awk 'BEGIN { srand(2); for (i = 0; i < 8000; i++) { s = i % 200; print sin(s * 0.4) + cos(int(i / 200) * 0.4) + 0.1 * rand() } }' >> map.sdf
# The options that a message names read the file.
awk 'BEGIN { srand(4); print "n,a,b"; for (i = 0; i < 900; i++) print i "," 0.5 * i "," (i == 70 ? -9999 : rand()) }' > lettered.csv
sed 's/n,a,b/n,x_um,z_um/' lettered.csv > marked.csv
"$asperity" surface surface profile lettered.csv --unit um --x-column a --column 3 --missing -9999 --gaps fill --lambda_s 9um --dp 20um 2> err |
  grep -q '900 points read, 1 bad, of columns 2 and 3, 1 points filled in' || die "--x-column --column --missing: $(cat err)"
"$asperity" surface surface profile map.sdf --dp 4um --row 7 2>&1 | grep -q '200 points; ' || die "--row"
"$asperity" surface surface profile map.sdf --dp 4um --column 7 2>&1 | grep -q 'spacing 2 um, 40 points; ' || die "--column"
{ echo x_um,z_um; awk 'BEGIN { for (i = 0; i < 400; i++) print i "," sin(i / 30) }'; } > short.csv
"$asperity" surface surface profile short.csv > m 2> err
grep -q 'short.csv: .*only .* correlation lengths long' err || die "a short profile is not said"
# every command that reads a wall says what is doubtful about it, of profiles and of maps
awk 'NR == 1000 { sub(/,.*/, ",30") } NR < 3000' profile.csv > dusty.csv
for command in "cor surface" "spread surface"; do
  "$asperity" $command profile dusty.csv --samples 2 --dp 2um 2> err > /dev/null
  grep 'as dust does' err | grep -q 'dusty.csv: ' || die "$command: dust is not told"
  grep -q 'covers .* points' err || die "$command: few points are not told"
done

# Filter: a wave of 800 um and one of 8 um, of which half passes at the cut-off. What it does to heights is unit/test_filter.c.
{ echo x_um,z_um; awk 'BEGIN { for (i = 0; i < 16000; i++) { x = 0.5 * i; printf "%.1f,%.6f\n", x, 0.1 * sin(x * 6.2831853 / 800) + 0.1 * sin(x * 6.2831853 / 8) } }'; } > waves.csv
rq_of() { "$asperity" surface surface profile waves.csv --dp 2um "$@" 2> err | grep '^# length' | sed 's/.*R_q \([0-9.e-]*\) um.*/\1/'; }
near() { awk -v a="$1" -v b="$2" -v part="$3" 'BEGIN { exit !(a > b * (1 - part) && a < b * (1 + part)) }' || die "$4: $1, not $2"; }
near "$(rq_of)" 0.1 0.01 "no filter"
grep -q 'covers 4 points' err || die "few points per particle"
awk -F, 'NR > 1 { $2 = 0.4 * sin($1 * 6.2831853 / 800) + 0.02 * sin($1 * 6.2831853 / 8) } { print $1 "," $2 }' waves.csv > two.csv
"$asperity" surface surface profile two.csv --dp 2um 2> err | grep -q 'more than one wave' || die "two waves are taken for one"
near "$(rq_of --lambda_s 8um)" 0.0791 0.01 "half of the short wave is left"
"$asperity" surface surface profile waves.csv --dp 20um --lambda_s 8um 2> err | grep -q ', lambda_s 8e-06 m' || die "--lambda_s is not told"

# Heights that cannot be roughness.
{ echo x_um,z_um; awk 'BEGIN { srand(3); for (i = 0; i < 4000; i++) print i "," rand() }'; } > noise.csv
"$asperity" surface surface profile noise.csv --dp 20um --lambda_s 20um > /dev/null 2> err || die "noise filtered: $(cat err)"
{ echo x_um,z_um; awk 'BEGIN { for (i = 0; i < 4000; i++) print i * 0.001 "," 10 * sin(i * 0.01) }'; } > steep.csv

refuses 2 'row 2 is asked for; the text has 1 trace' -- surface surface profile waves.csv --row 2
"$asperity" surface surface map map.sdf --dp 12um 2> err > /dev/null
grep -q 'map.sdf: .*covers 6 points .*correlation lengths long' err || die "few points of a map per particle"

# Options that say nothing of the wall at hand, and lengths that were forgotten a unit.
refuses_rows surface

# Lists of walls: a row per wall and diameter, the seed of each one more than that before.
"$asperity" surface surface rq 2um,5um lambda_c 40um:80um:40um seed 4 --dp 10um,50um --points 8192 > many
[ "$(rows many | cut -d, -f1-3 | paste -sd' ')" = "10,2,40 50,2,40 10,2,80 50,2,80 10,5,40 50,5,40 10,5,80 50,5,80" ] || die "lists of walls: $(cat many)"
"$asperity" surface surface rq 5um lambda_c 80um seed 7 --dp 10um,50um --points 8192 > one
cmp <(rows many | tail -n 2) <(rows one) || die "a list of walls and one of them"
draws

# The same on any number of threads, and the slope by the size law, s = sqrt(2) phi_r (1 + 0.92 kappa^3)^(-1/6).
grid=(surface surface rq 2um,10um lambda_c 40um,400um --dp 40um,200um --points 131072)
"$asperity" "${grid[@]}" > d
OMP_NUM_THREADS=1 "$asperity" "${grid[@]}" > e
cmp <(rows d) <(rows e) || die "surface: depends on threads"
rows d | awk -F, '{ d = $6 / (sqrt(2) * $4 * (1 + 0.92 * $5 ^ 3) ^ (-1 / 6)) - 1; if (d > 0.08 || d < -0.08) bad = 1 } END { exit bad || NR != 8 }' || die "surface: the size law is off: $(cat d)"

# Pictures.
"$asperity" surface surface profile dusty.csv --dp 55um --plot s.png -o /dev/null 2> err
head -c 8 s.png | grep -q PNG && [ "$(wc -c < s.png)" -gt 10000 ] || die "surface --plot"

# Bad usage.
"$asperity" spread surface rq 20um lambda_c 40um --dp 2mm --angles 20 -o x 2> err && die "spread beyond the table"
grep -q -- '--dp: .* valid up to' err || die "spread beyond the table: $(cat err)"
refuses_rows 'surface, with pictures'
[ -z "$(ls ./*.partial 2> /dev/null)" ] || die "a partial file is left"

# The picture has all of the particle, also where it bridges the most at the end of the profile.
"$asperity" surface surface profile "$root/examples/measured_profile/blade.csv" --gaps fill --spikes 12 --form 2 --dp 20um --plot wall.svg > out 2> err
awk -v RS="'/>" "/rgb\\(  0, 158, 115\\)'  d='M/ { sub(/.*d='M/, \"\"); gsub(/[^0-9.,]+/, \" \"); path = \$0 } END { print path }" wall.svg |
  awk '{ for (i = 1; i <= NF; i++) { split($i, p, ","); if (i == 1 || p[1] < a) a = p[1]; if (i == 1 || p[1] > b) b = p[1]
      if (i == 1 || p[2] < c) c = p[2]; if (i == 1 || p[2] > d) d = p[2] } exit !(NF > 50 && (b - a - (d - c)) ^ 2 < 4) }' ||
  die "surface --plot cuts the particle"
