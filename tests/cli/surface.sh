#!/usr/bin/env bash
# The commands surface and doe: columns, measured profiles, seeds, threads, messages, files, pictures.
set -euo pipefail
asperity=${ASPERITY_BIN:-$(dirname "$0")/../../build/bin}/asperity
asperity=$(cd "$(dirname "$asperity")" && pwd)/asperity
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT; cd "$work"
die() { echo "FAILED: $*" >&2; exit 1; }
rows() { grep -v '^#' "$1" | tail -n +2; }
columns=dp_um,rq_um,lambda_c_um,phi_r,kappa,slope_rms,angle_mean_deg,angle_sd_deg,angle_kurtosis,kl_normal

# refuses STATUS WORD... -- ARGUMENTS: exits with the status, says one line with the words, writes nothing.
refuses() {
  local status=$1 words=() got=0; shift
  while [ "$1" != -- ]; do words+=("$1"); shift; done; shift
  "$asperity" "$@" > out 2> err || got=$?
  [ $got = "$status" ] || die "exit $got, not $status: asperity $*"
  [ ! -s out ] || die "wrote something: asperity $*"
  [ "$(wc -l < err)" = 1 ] || die "not one line of message: asperity $*: $(cat err)"
  for word in "${words[@]}"; do grep -qF -- "$word" err || die "'$word' is not in: $(cat err)"; done
}

# A generated wall: its columns, its numbers, its seed.
"$asperity" surface --rq 5um --lambda-c 40um --dp 10um,55um,400um --save profile.csv -o a
grep -v '^#' a | head -n 1 | grep -qx "$columns" || die "surface: columns"
rows a | awk -F, 'function off(x, y) { d = x / y - 1; return d > 0.03 || d < -0.03 }
  off($6, $1 < 100 ? 0.1768 : 0.1290) || off($8, $1 < 100 ? 9.835 : 7.29) || off($4, 0.125) { exit 1 }
  $10 < 0 || $10 > 0.01 || $7 > 0.1 || $7 < -0.1 { exit 1 } END { exit NR != 3 }' || die "surface: numbers: $(cat a)"
"$asperity" surface --rq 5um --lambda-c 40um --dp 10um,55um,400um > b
cmp <(rows a) <(rows b) || die "surface: the same seed, other numbers"
"$asperity" surface --rq 5um --lambda-c 40um --dp 10um,55um,400um --seed 2 > b
cmp -s <(rows a) <(rows b) && die "surface: another seed, the same numbers"

# What was saved reads back as the same wall, and the generated one is another profile with the same angles.
"$asperity" surface --profile profile.csv --dp 10um,55um > m
rows m | awk -F, 'function off(x, y) { d = x / y - 1; return d > 0.03 || d < -0.03 }
  off($2, 5) || off($3, 40) || off($8, 9.835) { exit 1 } END { exit NR != 2 }' || die "surface --profile: $(cat m)"
grep -q '^# profile profile.csv: 524288 points read, 0 bad' m || die "surface --profile: the file is not described"
awk '/D_KL\(measured/ { n++; if (!($NF > 1e-5 && $NF < 0.02)) exit 1 } END { exit n != 2 }' m || die "surface --profile: D_KL: $(cat m)"

# Options of the reader.
awk 'BEGIN { srand(1); for (i = 0; i < 3000; i++) { z = z * 0.95 + rand() - 0.5
  if (i >= 500 && i < 504) continue
  printf "%.1f;%s\n", i * 0.5, i == 900 ? "nan" : i == 1500 ? 80 : z + i * 0.02 + 1e-6 * i * i } }' > raw.txt
refuses 1 raw.txt:1 'no unit of length is stated' -- surface --profile raw.txt
refuses 1 raw.txt: 'bad or missing points' -- surface --profile raw.txt --unit um
"$asperity" surface --profile raw.txt --unit um --gaps fill --spikes 20 --form 2 --dp 20um > m
grep -q '1 bad, 1 spikes, 6 points filled in (longest gap 4)' m || die "gaps: $(cat m)"
grep -q 'polynomial of degree 2' m || die "form"
"$asperity" surface --profile raw.txt --unit um,nm --gaps fill --dp 20um | grep -q 'phi_r 0.00' || die "--unit um,nm"
refuses 1 'the spacing is not equal' -- surface --profile raw.txt --unit um --gaps fill --spacing refuse
"$asperity" surface --profile raw.txt --unit um --gaps fill --spikes 20 --level 0.2 | grep -q 'lambda_c (0.2 lag)' || die "--level"
printf 'aISO-1.0\nNumPoints = 200\nNumProfiles = 40\nXscale = 1e-6\nYscale = 2e-6\nZscale = 1e-6\n*\n' > map.sdf
awk 'BEGIN { srand(2); for (i = 0; i < 8000; i++) print rand() }' >> map.sdf
"$asperity" surface --profile map.sdf --row 7 --dp 4um 2>&1 | grep -q '200 points; ' || die "--row"
"$asperity" surface --profile map.sdf --column 7 --dp 4um 2>&1 | grep -q 'spacing 2 um, 40 points; ' || die "--column"
head -c 40 map.sdf > cut.sdf
refuses 1 cut.sdf:3 'within the SDF header' -- surface --profile cut.sdf
{ echo x_um,z_um; awk 'BEGIN { for (i = 0; i < 400; i++) print i "," sin(i / 8) }'; } > short.csv
"$asperity" surface --profile short.csv > /dev/null 2> err
{ echo x_um,z_um; awk 'BEGIN { for (i = 0; i < 400; i++) print i "," sin(i / 30) }'; } > short.csv
"$asperity" surface --profile short.csv > m 2> err
grep -q 'lambda_c long' err && grep -q '^# only .* lambda_c long' m || die "a short profile is not said"

# The design of experiments, on any number of threads.
"$asperity" doe --rq 2um,25um --lambda-c 40um,400um --dp 40um,200um --points 131072 --plot doe.svg -o d 2> err
OMP_NUM_THREADS=1 "$asperity" doe --rq 2um,25um --lambda-c 40um,400um --dp 40um,200um --points 131072 > e
cmp <(rows d) <(rows e) || die "doe: depends on threads"
grep -v '^#' d | head -n 1 | grep -qx "$columns,slope_closed_form,slope_law" || die "doe: columns"
[ "$(rows d | wc -l)" = 8 ] || die "doe: rows"
grep -q 'paper.*0.0251' d || die "doe: the paper's median"
rows d | awk -F, 'function off(x, y) { d = x / y - 1; return d > 0.08 || d < -0.08 } off($6, $12) { exit 1 }' || die "doe: the size law is off"
"$asperity" doe --rq 50um --lambda-c 40um --dp 10um --points 16384 | tail -n 1 | grep -q ',$' || die "doe: a law beyond the table"

# Pictures.
"$asperity" surface --profile profile.csv --dp 55um --plot s.png -o /dev/null 2> err
head -c 8 s.png | grep -q PNG && [ "$(wc -c < s.png)" -gt 10000 ] || die "surface --plot"
for figure in 'fig. 10' 'fig. 11' 'fig. 12'; do grep -q "$figure" doe.svg || die "doe --plot: $figure"; done

# Bad usage.
refuses 2 --lambda-c missing -- surface --rq 5um
refuses 2 --rq -5um '> 0' -- surface --rq -5um --lambda-c 40um
refuses 2 --dp -10um '> 0' -- surface --rq 5um --lambda-c 40um --dp -10um
refuses 2 --rq --profile -- surface --rq 5um --profile profile.csv
refuses 2 --gaps bend refuse fill -- surface --profile profile.csv --gaps bend
refuses 2 --level 0.5 1/e -- surface --profile profile.csv --level 0.5
refuses 2 --form 12 '0 to 9' -- surface --profile profile.csv --form 12
refuses 2 --unit furlong nm -- surface --profile profile.csv --unit furlong
refuses 2 --points 100 4096 -- doe --points 100
refuses 2 --dp 'reaches to' -- cor --rq 20um --lambda-c 40um --dp 2mm --model truncated
"$asperity" spread --rq 20um --lambda-c 40um --dp 2mm --angle 20 -o x 2> err && die "spread beyond the table"
grep -q -- '--dp: .* reaches to' err || die "spread beyond the table: $(cat err)"
refuses 2 phi_r 'reaches to 1' -- cor --rq 50um --lambda-c 40um --model truncated
refuses 2 --rq furlong nm -- doe --rq 2furlong
refuses 1 --dp 0.1um 0.3125um -- surface --profile profile.csv --dp 0.1um
refuses 1 d_p "profile's length" -- surface --profile profile.csv --dp 1m
refuses 1 nowhere.csv 'No such file' -- surface --profile nowhere.csv
: > empty.csv
refuses 1 empty.csv:1 'is empty' -- surface --profile empty.csv
[ -z "$(ls ./*.partial 2> /dev/null)" ] || die "a partial file is left"
