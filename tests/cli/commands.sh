#!/usr/bin/env bash
# The commands spread, cor and materials: columns, exit codes, messages, files, pictures.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"

"$asperity" --help > help
for command in surface spread cor materials; do
  grep -q "^  $command " help || die "$command is not in --help"
  "$asperity" $command --help | grep -q -- '--output FILE' || die "$command --help"
done
"$asperity" --version | grep -qx 'asperity [0-9.]*' || die "--version"

# spread
"$asperity" spread surface sigma 10 seed 3 --angles 20 --samples 1000 > a
"$asperity" spread surface sigma 10 seed 3 --angles 20 --samples 1000 -o b
cmp <(tail -n +2 a) <(tail -n +2 b) || die "spread: the same seed, other samples"
"$asperity" spread surface sigma 10 seed 4 --angles 20 --samples 1000 > b
cmp -s <(tail -n +2 a) <(tail -n +2 b) && die "spread: another seed, the same samples"
[ "$(header a)" = delta_alpha_deg ] && [ "$(wc -l < a)" = 1002 ] || die "spread: samples"
head -n 1 a | grep -q '^# asperity [0-9.]*; spread surface sigma 10 .*; surface sigma 10 spread visible .* seed 3$' || die "spread: comment line"
for model in normal rejection truncated weibull; do
  "$asperity" spread surface rq 5um lambda_c 40um spread $model --dp 10um --angles 5:85:20 --summary --samples 2000 > s
  [ "$(header s)" = model,alpha1_deg,mean_deg,sd_deg,p05_deg,p50_deg,p95_deg ] && [ "$(wc -l < s)" = 7 ] || die "spread --summary: $model"
  awk -F, 'NR > 2 { if (!($4 > 5 && $4 < 12 && $5 < $6 && $6 < $7)) bad = 1 } END { exit bad }' s || die "spread --summary: $model: $(cat s)"
done
"$asperity" spread surface sigma 10 --pdf --angles 20 | awk -F, 'NR > 2 { sum += $2 * 0.1 } END { exit !(sum > 0.999 && sum < 1.001) }' || die "spread --pdf does not sum to 1"

# cor
"$asperity" cor surface rq 15.6um lambda_c 120um spread truncated materials ard hastelloy-x --dp lognormal:1um:100um:10um --speed 100 --angles 2,45,88,90 --samples 500 > c
[ "$(header c)" = dp_um,v1_m_s,alpha1_deg,delta_alpha_deg,hits,cor_v_plane,cor_alpha_plane,cor_n,cor_t,outcome,cor_v_space,cor_alpha_space ] && [ "$(wc -l < c)" = 2002 ] || die "cor: columns or rows"
awk -F, 'NR > 2 {
    if ($1 < 1 || $1 > 100 || $6 > 1 || ($10 == "deposit" && $8 $9 != "")) bad = 1
    if ($3 == 90 && $9 != "") bad = 1
    over += $3 == 2 && $8 > 1; negative += $3 == 88 && $9 != "" && $9 < 0; deposits += $10 == "deposit" }
  END { exit bad || over < 100 || negative < 50 || deposits < 10 }' c || die "cor: the scatter is not as it should be"
"$asperity" cor surface_energy 0 --dp 10um --angles 90 --samples 1 | awk -F, 'NR == 3 { d = $8 - 0.166; exit !(d < 1e-3 && d > -1e-3) }' || die "cor: CoR_N(90) is not v_y/v1"
# The same impacts as a ledger has them: in SI, outcomes as numbers.
many=(cor surface rq 5um lambda_c 40um --dp 1um,20um --angles 5,60,90 --samples 20)
"$asperity" "${many[@]}" > own; "$asperity" "${many[@]}" --columns ledger > ledger
[ "$(header ledger)" = tag,impact,time,mesh,triangle,x,y,z,d_p,v1,alpha1_deg,delta_alpha_deg,tilt_out_deg,hits,v2,alpha2_deg,cor_n,cor_t,outcome ] || die "cor --columns ledger: columns"
# cor_v in space is the ledger's v2/v1
paste -d, <(rows own | awk -F, -v OFS=, '{ $6 = $11; NF = 10; print }') <(rows ledger) | awk -F, '{ n++; deposits += $29
    near = ($1 - $19 * 1e6) ^ 2 < 1e-8 && $2 == $20 && ($4 - $22) ^ 2 < 1e-8 && $5 == $24 && ($6 - $25 / $20) ^ 2 < 1e-9 && ($8 - $27) ^ 2 < 1e-7
    same = ($9 == "") == ($28 == "") && $29 == ($10 == "deposit") && $11 == n
    if (!near || !same) { print; bad = 1 } } END { exit bad || n != 120 || deposits < 20 || deposits > 100 }' || die "cor --columns ledger: other numbers"
refuses 2 "own or ledger" -- cor --columns both
refuses 2 "'-sigma'" "word of the description" -- cor -sigma 5
"$asperity" materials | grep -q '^hastelloy-x,.*handbook values"$' || die "materials"

# Pictures, by the scripts of share/asperity/plot: of impacts, of their means, and of samples.
draws
for ending in png svg pdf; do
  "$asperity" cor surface rq 5um lambda_c 40um --samples 20 --plot cor.$ending -o drawn.csv 2> err || die "cor --plot cor.$ending: $(cat err)"
done
head -c 4 cor.png | grep -q PNG && head -c 4 cor.pdf | grep -q PDF || die "cor --plot"
"$asperity" cor surface rq 5um lambda_c 40um --samples 20 | rows /dev/stdin | cmp - <(rows drawn.csv) || die "cor --plot: another table"
"$asperity" cor surface rq 5um lambda_c 40um --samples 500 --plot cor.svg -o c 2> err
grep -q 'outside: .* of ' cor.svg && grep -q 'one of 3' cor.svg || die "cor --plot: what it leaves out"
[ "$(grep -c '<text>mean ± sd' cor.svg)" = 1 ] || die "cor --plot: more than one legend"
[ "$(grep -c '>CoR<.*>[NT]<' cor.svg)" = 2 ] && grep -q 'lambda_c' cor.svg && ! grep -q warning err || die "cor --plot: names with _"
"$asperity" cor surface sigma 5 --samples 1 --angles 45 --plot cor.svg -o c 2> err
! grep -q warning err && grep -q 'share of the rebounds' cor.svg || die "cor --plot of one impact: $(cat err)"
"$asperity" cor surface sigma 5 --speed 0.01 --samples 5 --plot cor.svg -o c 2> err || die "cor --plot where all stick: $(cat err)"
! grep -q warning err && grep -q '>450 of 450 impacts stick<' cor.svg || die "cor --plot does not say that all stick: $(cat err)"
"$asperity" cor surface sigma 5 --speed 0.01 --angles 30,60 --samples 5 --summary --plot cor.svg -o c 2> err
! grep -q warning err && grep -q '>10 of 10 impacts stick<' cor.svg || die "cor --summary --plot does not say that all stick: $(cat err)"
for kind in "--columns own" "--columns ledger" --summary; do
  "$asperity" cor surface sigma 5 --speed 30 --samples 5 $kind --plot cor.svg -o c 2> err
  case $kind in
    --summary) stuck=$(paste -d ' ' <(column impacts c) <(column capture_share c) | awk '{ n += $1 * $2 } END { printf "%.0f", n }') ;;
    *) stuck=$(column outcome c | grep -cv '^rebound$\|^0$') ;;
  esac
  [ "$stuck" -gt 0 ] && [ "$stuck" -lt 450 ] && [ "$(grep -c ">$stuck of 450 impacts stick<" cor.svg)" = 1 ] || die "cor $kind --plot: not $stuck of 450 stick"
done
"$asperity" cor surface sigma 5 --angles 20,40 --samples 9 --plot cor.svg -o c 2> err
! grep -q warning err && ! grep -q '±' cor.svg || die "cor --plot: a mean of 9 impacts: $(cat err)"
"$asperity" cor surface smooth --angles 30 --plot cor.svg -o c 2> err
! grep -q warning err && grep -q 'all 0.304<' cor.svg && ! grep -q polygon cor.svg || die "cor --plot without scatter: $(cat err)"
"$asperity" spread surface sigma 0.3 --plot spread.svg -o s 2> err
[ "$(grep -c polygon spread.svg)" -gt 10 ] || die "spread --plot: bins wider than the spread"
for kind in --summary --capture; do
  "$asperity" cor surface sigma 5 --angles 45 --dp 1um,2um --speed 1,2 $kind --plot $kind.svg -o c 2> err && grep -q '<svg' ./$kind.svg || die "cor $kind --plot: $(cat err)"
done
for kind in "" --pdf; do
  "$asperity" spread surface sigma 10 $kind --plot spread.svg -o s 2> err && grep -q 'density / (1/degree)' spread.svg || die "spread $kind --plot: $(cat err)"
done
# A copy of the scripts, as a user has it.
cp -r "$(dirname "$asperity")/../share/asperity/plot" scripts
sed -i "s/impact angle/angle of incidence/" scripts/cor.gp
gnuplot -d -c scripts/cor.gp drawn.csv own.svg 'My title' 500x300 0:2 && grep -q 'angle of incidence' own.svg && grep -q 'My title' own.svg || die "a copy of a script"
! gnuplot -d -c scripts/cor.gp 2> err && grep -q usage: err || die "a script without arguments"

# bad usage
refuses 2 "--speed is 0; it must be 1e-09 to 1e+06 m/s" -- cor surface sigma 5 --speed 0
refuses 2 "--dp is '5', i.e. 5 m; did you mean 5um?" -- cor --dp 5,10um
refuses 2 "min < median < max" "from:to:step" -- cor --dp lognormal:1um:10um:100um
refuses_rows 'commands, with pictures'
refuses 1 "/nowhere/x.csv" "No such file" -- spread surface sigma 10 -o /nowhere/x.csv
[ ! -e picture.bmp ] || die "half a picture was left"
"$asperity" cor --samples 5000 -o /dev/full 2> err && die "a full disk went unnoticed"
for words in --help --version "help wall" "help cor" "cor --help"; do
  status=0; "$asperity" $words > /dev/full 2> err || status=$?
  [ $status = 1 ] && grep -q "cannot write standard output: No space" err || die "$words to a full disk: exit $status: $(cat err)"
done
grep -q "cannot write" err || die "full disk: $(cat err)"
! ls ./*.partial > /dev/null 2>&1 || die "a partial file was left"

# A wall in every way: sigma, its two numbers; not in both. Speeds as a list with a range, and log-normal.
cor() { "$asperity" cor "$@" --samples 400 --angles 20 | grep -v '^#\|^dp'; }
mean() { awk -F, -v k="$1" '{ s += $k } END { print s / NR }'; }
a=$(cor surface sigma 10.026 --dp 4um | mean 8) b=$(cor surface rq 5um lambda_c 40um --dp 4um | mean 8)
awk -v a="$a" -v b="$b" 'BEGIN { exit !(a / b > 0.999 && a / b < 1.001) }' || die "sigma: $a, by its numbers $b"
[ "$(cor surface sigma 10 --dp 10um,20um --speed 50,100:120:10 | cut -d, -f1,2 | sort -u | wc -l)" = 8 ] || die "sizes x speeds"
[ "$(cor surface sigma 10 --speed 0.2:0.5:0.1 | cut -d, -f2 | sort -u | xargs)" = "0.2 0.3 0.4 0.5" ] || die "the last step of a range"
cor surface sigma 10 --speed lognormal:10:200:50 | awk -F, '{ if ($2 < 10 || $2 > 200) bad = 1; s += log($2) } END { m = exp(s / NR); exit bad || m < 42 || m > 58 }' || die "log-normal speeds"
# Per angle mean, sd and capture share, of the same impacts.
"$asperity" cor surface rq 5um lambda_c 40um --dp 1.6um --angles 5:85:20 --samples 300 > all
"$asperity" cor surface rq 5um lambda_c 40um --dp 1.6um --angles 5:85:20 --samples 300 --summary > means
[ "$(header means)" = dp_um,v1_m_s,alpha1_deg,impacts,capture_share,n,cor_n_mean,cor_n_sd,cor_t_mean,cor_t_sd ] || die "cor --summary: columns"
rows all | awk -F, '{ n[$3]++; stuck[$3] += $10 == "deposit" } $10 == "rebound" { k[$3]++; s[$3] += $8; q[$3] += $8 * $8; t[$3] += $9 }
  END { for (a in n) { m = s[a] / k[a]; printf "%g,%d,%.4f,%d,%.4f,%.4f,%.4f\n", a, n[a], stuck[a] / n[a], k[a], m, sqrt((q[a] - k[a] * m * m) / (k[a] - 1)), t[a] / k[a] } }' | sort -g > wanted
rows means | cut -d, -f3- | awk -F, '{ printf "%g,%d,%.4f,%d,%.4f,%.4f,%.4f\n", $1, $2, $3, $4, $5, $6, $7 }' | cmp - wanted || die "cor --summary: $(cat means)"
# A row for each size and speed; the same bytes on any number of cores; numbers as printf has them.
"$asperity" cor surface sigma 5 deposit off --dp 5um,50um --speed 80,100 --angles 40,60 --samples 11 --summary -o means
"$asperity" cor surface sigma 5 deposit off --dp 5um,50um --speed 80,100 --angles 40,60 --samples 11 -o all
paste -d, <(rows means | cut -d, -f1-4,7) <(rows all | awk -F, '{ k = $1 "," $2 "," $3; if (!(k in n)) of[++m] = k; n[k]++; s[k] += $8 } END { for (i = 1; i <= m; i++) print of[i] "," n[of[i]] "," s[of[i]] / n[of[i]] }') |
  awk -F, '{ d = $5 - $10; if ($1 "," $2 "," $3 "," $4 != $6 "," $7 "," $8 "," $9 || d * d > 1e-10) bad = 1 } END { exit bad || NR != 8 }' || die "cor --summary of two sizes and speeds: $(cat means)"
# Along the wall there is no CoR_N, and yet a rebound.
"$asperity" cor rebound walton 0.9 0.3 0 --angles 1e-12 --samples 3 --summary -o along
[ "$(rows along | cut -d, -f4-8)" = 3,0,3,, ] || die "cor along the wall: $(cat along)"
# --samples counts for each of them; the last value of a range is its end.
"$asperity" cor --dp 1um:200um:1um --angles 45 --samples 1 --summary -o means
[ "$(rows means | awk -F, '$1 == NR && $4 == 1' | wc -l)" = 200 ] || die "cor --summary of 200 sizes: $(rows means | wc -l) rows"
for range in 0.9:90:0.9 0.1:0.3:0.1; do
  step=${range##*:} end=${range#*:} end=${end%:*}
  "$asperity" spread surface sigma 10 --angles $range --summary --samples 20 -o ranged
  "$asperity" spread surface sigma 10 --angles $end --summary --samples 20 -o single
  cmp <(rows ranged | tail -n 1) <(rows single) || die "--angles $range does not end as $end does"
  column alpha1_deg ranged | awk -v step=$step -v end=$end '($1 / NR / step - 1) ^ 2 > 1e-12 { bad = 1 } END { exit bad || $1 != end }' || die "--angles $range"
done
OMP_NUM_THREADS=1 "$asperity" cor surface sigma 5 --samples 1500 -o all; OMP_NUM_THREADS=3 "$asperity" cor surface sigma 5 --samples 1500 | sed 1d | cmp - <(sed 1d all) || die "cor: other rows on other cores"
angles=$(awk 'BEGIN { srand(3); for (i = 0; i < 3000; i++) printf "%s%s", i ? "," : "", i % 3 ? sprintf("%.12g", 90 * rand() ^ (1 + i % 7)) : sprintf("%d.%06d5", i % 90, i * 331 % 1000000) }')
"$asperity" cor --angles "$angles" --samples 1 | rows /dev/stdin | cut -d, -f3 | cmp - <(tr , '\n' <<< "$angles" | awk '{ printf "%.6g\n", $1 }') || die "numbers are not those of printf"
[ "$(rows <("$asperity" cor --speed 0.1km/s --angles 30deg --dp 1e4nm --samples 1))" = "$(rows <("$asperity" cor --angles 30 --samples 1))" ] || die "units behind numbers"
# Constants that look like a mistake.
"$asperity" cor yield_stress 2e10 --samples 1 --angles 45 2>&1 > /dev/null | grep -q 'warning: the yield stress' || die "cor: a yield stress over a tenth of the modulus"
"$asperity" cor surface_energy 1e3 --samples 1 --angles 45 2>&1 > /dev/null | grep -q 'warning: particles up to .* always stick' || die "cor: everything sticks"

# One color for each model and for each law, and titles that fit.
look=$root/examples/look.gp
"$asperity" help wall > words
for kind in model law; do
  names=$(sed -n "/^${kind^^}[:,]/,/^$/s/^  \([a-z_]*\).*/\1/p" words | grep . | sort -u) # and none, on a smooth wall
  [ $kind = law ] || names+=' none'
  for name in $names; do grep -q "^${kind}_$name = " "$look" || die "examples/look.gp:$(grep -n "^${kind}_" "$look" | tail -n 1 | cut -d: -f1): add a style ${kind}_$name behind this line"; done
  [ "$(grep "^${kind}_" "$look" | grep -o "rgb '[^']*'" | sort -u | wc -l)" = "$(wc -w <<< "$names")" ] || die "two of kind $kind have one color"
done
# The scripts by hand: a title of two lines, the size and the vertical axis as given.
"$asperity" cor surface sigma 5 --samples 3 --angles 40,45 -o c
plot=$(dirname "$asperity")/../share/asperity/plot
gnuplot -c "$plot/cor.gp" c long.svg 'a long title of many short words that does not fit on one line of a small picture' 400x300 -2:7
[ "$(grep -c 'a long title\|small picture' long.svg)" = 2 ] || die "a long title stays on one line"
grep -q 'width="400" height="300"' long.svg && grep -q '> *7<' long.svg && grep -q '> *-2<' long.svg || die "size and range of a picture"

# On a terminal: percents from the beginning on with the time left, gone at the end and at Ctrl-C; warnings in color. Its
# last characters are those that blank the line.
on_terminal() { script -qefc "$*" log < "${keys:-/dev/null}" > /dev/null; }
on_terminal timeout -s INT 2 "$asperity" trade surface rq 5um lambda_c 40um --dp 10um -o out.csv || true
grep -q 'ensemble   0 %' log || die "no percents at the beginning: $(cat -A log)"
on_terminal "$asperity" cor surface sigma 5 --angles 30 --samples 2000000 --summary -o out.csv
grep -qE 'impacts +[0-9]+ %, [0-9]+ s left' log || die "no time left: $(cat -A log)"
tr '\r' '\n' < log | grep -A 9 ' left' | grep -qx ' \{40\}' || die "the percents stay: $(cat -A log)"
mkfifo keys; { sleep 1; printf '\003'; sleep 1; } > keys &
keys=keys on_terminal "$asperity" cor surface sigma 5 --angles 30 --samples 100000000 --summary -o out.csv && die "Ctrl-C"
tr '\r' '\n' < log | sed '/^Script/d; /^$/d' | tail -n 1 | grep -qx ' \{40\}' || die "Ctrl-C leaves the percents: $(cat -A log)"
[ -z "$(find . -name '*.partial')" ] || die "Ctrl-C leaves a partial file"
on_terminal "$asperity" cor yield_stress 2e10 --samples 1 --angles 45 -o out.csv
grep -q $'\033\[33mwarning: \033\[0m' log || die "a warning without color: $(cat -A log)"
on_terminal env NO_COLOR=1 "$asperity" cor yield_stress 2e10 --samples 1 --angles 45 -o out.csv
grep -q '^asperity: warning: ' log || die "a color in spite of NO_COLOR: $(cat -A log)"
! "$asperity" cor yield_stress 2e10 --samples 1 --angles 45 2>&1 > /dev/null | grep -q $'\033' || die "a color in a file"
