#!/usr/bin/env bash
# compare: the same model with another seed scores 1; data in all the forms
# that people have; deposits; places by angle, speed and size; standard input.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"
wall='surface rq 5um lambda_c 40um'

# The score of a file of comparison: of the same law (near 1, by its error), or of another one.
fits() { tail -n 1 "$1" | awk -F, '{ exit !($1 == "score" && $18 > 0 && $17 < 1 + 3 * $18) }'; }
differs() { tail -n 1 "$1" | awk -F, '{ exit !($1 == "score" && $18 > 0 && $17 > 1 + 3 * $18) }'; }

# The same law with another seed fits (tests/sweep/compare.sh: with 80 of them); another law differs, and so does one with
# the same means and no scatter.
"$asperity" cor $wall --angles 10,30,60 --samples 400 -o model
"$asperity" cor $wall seed 1001 --angles 10,30,60 --samples 200 -o data
"$asperity" compare model data > got; fits got || die "compare: the same law: $(cat got)"
"$asperity" cor $wall friction 0.2 seed 2 --angles 10,30,60 --samples 200 -o data
"$asperity" compare model data > got; differs got || die "compare: another law: $(cat got)"
"$asperity" compare model data | cmp - got || die "compare: the score is not the same again"
awk 'BEGIN { print "alpha1_deg,cor_n"; for (i = 0; i < 50; i++) print "30," 0.5 + (i - 24.5) / 100 }' > scatters
awk 'BEGIN { print "alpha1_deg,cor_n"; for (i = 0; i < 50; i++) print "30,0.5" }' > smooth
"$asperity" compare smooth scatters > got; differs got || die "compare: no scatter: $(cat got)"

# One sample in all the forms: the same numbers come out. At 90 degrees CoR_T is not defined.
"$asperity" cor $wall deposit off seed 3 --angles 20,50,80 --samples 80 --speed 50 -o cor.csv
"$asperity" compare model cor.csv --near 90,9,9 | rows /dev/stdin | cut -d, -f1,8-11,13-17 > wanted
awk -F, -v pi=3.14159265358979 '/^#/ || /^dp/ { next }
  { a = $3 * pi / 180; n2 = $8 * 50 * sin(a); t2 = $9 * 50 * cos(a); v2 = sqrt(n2 * n2 + t2 * t2); a2 = atan2(n2, t2); f = "%.12g"
    if (!n++) { print "alpha1_deg,v1,alpha2_plane_deg,v2_plane" > "velocities"; print "alpha_1 [rad];v1 [mm/s];alpha_2_plane (rad);v2_plane (mm/s)" > "radians"; print "v1_n_m_s,v1_t_m_s,v2_n_m_s,v2_t_m_s" > "components"; print "alpha1_deg,cor_v_plane,cor_alpha_plane,v1" > "ratios"; print "alpha1_deg,cor_n,cor_t,outcome,v1_m_s,d_p [um]" > "pairs" }
    printf "%.12g,50,%.12g,%.12g\n", $3, a2 * 180 / pi, v2 > "velocities"
    printf "%.12g;50000;%.12g;%.12g\n", a, a2, v2 * 1e3 > "radians"
    printf "%.12g,%.12g,%.12g,%.12g\n", -50 * sin(a), 50 * cos(a), n2, t2 > "components"
    printf "%.12g,%.12g,%.12g,50\n", $3, v2 / 50, a2 / a > "ratios"
    printf "%.12g,%.12g,%.12g,rebound,50,10\n", $3, $8, $9 > "pairs" }' cor.csv
for form in velocities radians components ratios pairs; do
  "$asperity" compare model $form --near 90,9,9 2> err | grep -v '^deposits' > got || die "compare: $form: $(cat err)"
  [ ! -s err ] || die "compare: $form: a warning: $(cat err)"
  paste -d, wanted <(rows got | cut -d, -f1,8-11,13-17) | grep -v '^score' | awk -F, '{ for (i = 2; i <= 10; i++) { d = $i - $(i + 10); if (d > 2e-5 || d < -2e-5) exit 1 } if ($1 != $11) exit 1; n++ } END { exit n != 6 }' || die "compare: $form gives other numbers"
done
sed 1s/alpha1_deg/alpha1/ velocities > unnamed
"$asperity" compare model unnamed --near 90,9,9 2>&1 > /dev/null | grep -q "unit of column 'alpha1' is not stated.*degrees" || die "compare: an angle without a unit"

# Angles of rebounds without speeds, one by one and as means in radians: awk's means come out, and the true model fits.
"$asperity" cor $wall seed 21 --angles 20:60:20 --samples 2000 -o truth
"$asperity" cor $wall seed 22 --angles 20:60:20 --samples 2000 -o model
awk -F, '/^#/ { next } !n++ { print "alpha1_deg,Rebound angle (deg)"; next } $10 == "rebound" { print $3 "," $3 * $7 }' truth > angles
awk -F, -v rad=57.29577951308232 'NR > 1 { n[$1]++; s[$1] += $2; q[$1] += $2 ^ 2 } END { print "alpha1_deg,alpha2_plane_mean_rad,alpha2_plane_sd_rad,n"
  for (a in n) printf "%s,%.12g,%.12g,%d\n", a, s[a] / n[a] / rad, sqrt((q[a] - s[a] ^ 2 / n[a]) / (n[a] - 1)) / rad, n[a] }' angles > angles.means
for data in angles angles.means; do
  "$asperity" compare model $data > got; fits got || die "compare: $data: $(cat got)"
  awk -F, -v rad=57.29577951308232 'NR == FNR { mean[$1] = $2 * rad; sd[$1] = $3 * rad; next } $1 == "alpha2_deg" { n++
    if (!(($13 - mean[$2]) ^ 2 < 1e-8 && ($15 - sd[$2]) ^ 2 < 1e-8 && ($8 - $13) ^ 2 < 16 * ($9 ^ 2 + $14 ^ 2))) bad++ } END { exit n != 3 || bad }' angles.means got || die "compare: $data: other means: $(cat got)"
done
"$asperity" cor $wall friction 0.6 seed 22 --angles 20:60:20 --samples 2000 -o other
"$asperity" compare other angles > got; differs got || die "compare: angles: another law: $(cat got)"

# The true model, of a wall that throws to the side: rebounds as seen in the plane of incidence, and in space, from files that
# say which, by a ledger too. A mixture of both, as a ledger has it, is not taken without a word, and is no data.
"$asperity" cor $wall seed 11 --angles 10,30,60 --samples 2000 -o model
"$asperity" cor $wall seed 11 --angles 10,30,60 --samples 2000 --columns ledger -o model.ledger
"$asperity" cor $wall seed 12 --angles 10,30,60 --samples 1500 -o truth
"$asperity" cor $wall seed 12 --angles 10,30,60 --samples 1500 --columns ledger | awk -F, '/^#/ { next } !n++ { print "alpha1_deg,v1,alpha2_deg,v2"; next } $19 == 0 { print $11 "," $10 "," $16 "," $15 }' > mixture
# Rows of grains that slide have no cor_n, and change nothing at other angles.
{ cat model.ledger; rows model.ledger | awk -F, -v OFS=, 'NR <= 200 { $11 = 0; $17 = ""; $19 = 0; print }'; } > sliding
"$asperity" compare sliding > alone
[ "$(awk -F, '$2 == "0" { print $1, $7, $8 != "" }' alone | paste -sd' ')" = "cor_n 0 0 cor_t 196 1 deposits 200 1" ] || die "compare: grains that slide: $(cat alone)"
for view in plane space; do
  awk -F, -v view=$view '/^#/ { next } !n++ { print "alpha1_deg,v1,alpha2_" view "_deg,v2_" view; next } $10 == "rebound" { print $3 "," $2 "," $3 * $(view == "plane" ? 7 : 12) "," $2 * $(view == "plane" ? 6 : 11) }' truth > truth.$view
  awk -F, -v view=$view '/^#/ { next } !n++ { print "alpha1_deg,cor_alpha_" view ",cor_v_" view; next } $10 == "rebound" { print $3 "," $(view == "plane" ? 7 : 12) "," $(view == "plane" ? 6 : 11) }' truth > ratio.$view
  for data in truth.$view ratio.$view; do for of in model model.ledger sliding; do
    "$asperity" compare $of $data > got; fits got || die "compare: the true model, $data by $of"
    [ $of != sliding ] || cmp <(rows got) <("$asperity" compare model.ledger $data | rows /dev/stdin) || die "compare: grains that slide count at other angles"
  done; done
done
sed '1s/v2_plane/v2_space/' truth.plane > crossed

# Means count by their standard errors, else by sd and n, else by the sd; what was not measured stays empty.
printf 'alpha1_deg,cor_n_mean,cor_n_sd,cor_n_se,cor_t_mean,n\n30,0.33,0.15,,,100\n60,0.165,0.1,0.004,0.79,\n60,0.165,0.1,,,\n' > means
"$asperity" compare model means > got
[ "$(column data_mean_se got | paste -sd,)" = 0.015,0.004,0.1,,,, ] || die "compare: means: $(cat got)"
rows got | awk -F, '$1 == "cor_n" { chi2 += ($8 - $13) ^ 2 / ($9 ^ 2 + $14 ^ 2) / 3 } $1 == "score" { d = $17 / chi2 - 1; exit !(d * d < 1e-8 && $18 > 0) }' || die "compare: the score of means: $(cat got)"

# Names and units as people write them: components with a unit in brackets, std and sem, radius; what is left out and what is
# too fast, and why there is no score, is said.
sed '1s|.*|v1_n [m/s],v1_t [m/s],v2_n [m/s],v2_t [m/s]|' components > brackets
"$asperity" compare model brackets --near 90,9,9 | rows /dev/stdin | cmp - <("$asperity" compare model components --near 90,9,9 | rows /dev/stdin) || die "compare: units of components in brackets"
printf 'alpha1_deg,e_n_mean,e_n_std,e_n_sem,cor_t_mean,N,radius_um\n30,0.33,0.15,,,100,5\n60,0.165,0.1,0.004,0.79,,5\n60,0.165,0.1,,,,5\n' > words
"$asperity" compare model words > got
[ "$(column data_mean_se got | paste -sd,)" = 0.015,0.004,0.1,,,, ] && [ "$(column dp_um got | head -n 1)" = 10 ] || die "compare: std, sem, radius: $(cat got)"
printf 'alpha1_deg,cor_n\n30,0.3\n30,nan\n30,\n30,0.4\n' > gaps
"$asperity" compare model gaps > got 2> err
grep -q "gaps: 2 of 4 rows have neither" err || die "compare: rows without numbers: $(cat err)"
grep -q "gaps: there is no score, as no bin has 10 impacts" err || die "compare: no reason for a missing score: $(cat err)"
printf 'alpha1_deg,cor_n_mean\n30,0.3\n' | "$asperity" compare model - > got 2> err
grep -q "no score, as no mean has a standard error: columns cor_n_se" err || die "compare: no reason for a missing score: $(cat err)"
printf 'alpha1_deg,cor_n\n30,0.3\n30,1e6\n30,0.2\n' > million

# Names as papers print them: of Greek letters, of angles from the normal (by their name, or --from), of columns that only the
# user knows; a drop test has normal speeds alone. A rebound angle and a ratio of speeds make both coefficients: of Beladjine et
# al. (2007) 20 degrees, 26.68 degrees and 0.610 are 0.801 and 0.580.
printf 'α_in [°],e_n [-],e_t [-]\n30,0.84,0.72\n' > greek
printf 'angle_from_normal_deg,e_n,e_t\n60,0.84,0.72\n' > normal
printf '60 0.84 0.72\n60 0.84 0.72\n' > nameless
printf 'impact angle (deg),rebound angle (deg),v_in [m/s],e\n20,26.68,26,0.61\n' > beads
printf 'v1_n [m/s],v2_n [m/s]\n2,1.5\n' > drop
means() { "$asperity" compare alonemodel "$@" --near 90,90 2> err | rows /dev/stdin | awk -F, '/^cor/ { printf "%s %.3f;", $2, $13 }'; }
"$asperity" cor rebound constant 0.5 0.5 --angles 20,30,90 --samples 2 -o alonemodel
[ "$(means greek)" = '30 0.840;30 0.720;' ] || die "compare: Greek names: $(means greek) $(cat err)"
[ "$(means normal)" = '30 0.840;30 0.720;' ] || die "compare: angles from the normal: $(means normal) $(cat err)"
[ "$(means nameless --columns alpha1=1,cor_n=2,cor_t=3 --from normal)" = '30 0.840;30 0.720;' ] || die "compare --columns --from: $(cat err)"
[ "$(means beads --columns cor_v_plane=e)" = '20 0.801;20 0.580;' ] || die "compare: a rebound angle and a ratio of speeds: $(means beads --columns cor_v_plane=e) $(cat err)"
[ "$(means drop)" = '90 0.750;90 0.000;' ] || die "compare: normal speeds alone: $(means drop) $(cat err)"
printf 'v1_m_s,v2_m_s\n2,1.5\n' > speeds
[ "$(means speeds --columns v1_n=1,v2_n=2)" = '90 0.750;90 0.000;' ] || die "compare: a drop by --columns: $(cat err)"
printf 'theta_i [deg],e_n\n60,0.84\n' > theta
means theta > got; grep -q "'theta_i \[deg\]' are taken from the wall; --from normal" err || die "compare: no doubt of theta: $(cat err)"

# Places by speed and size: the model's impacts there, and no others.
{ "$asperity" cor --angles 30 --speed 20 --samples 30; "$asperity" cor --angles 30 --speed 80 --samples 30 | rows /dev/stdin; "$asperity" cor --angles 30 --speed 80 --dp 50um --samples 30 | rows /dev/stdin; } > model
printf 'alpha1_deg,v1_m_s,dp_um,cor_n\n30,20,10,0.9\n30,80,10,0.4\n30,80,50,0.4\n30,300,50,0.4\n' > data
"$asperity" compare model data --bin 90 > got 2> err
"$asperity" compare model <(sed 's/cor_n/cor_n_mean/' data) > got 2> err
[ "$(column model_n got | head -n 4 | paste -sd,)" = 30,30,30,0 ] && grep -q "1 of 4 bins" err || die "compare: speeds and sizes: $(cat got err)"
[ "$(column v1_m_s got | sed -n 2p),$(column dp_um got | sed -n 3p)" = 80,50 ] || die "compare: places: $(cat got)"

# Weights: of 30 and 30 impacts of the model where the data have 54 and 6, Kish's effective number is 1/(0.9^2 + 0.1^2) of 30.
for n in 30 54; do
  awk -v n=$n 'BEGIN { print "alpha1_deg,cor_n"; for (i = 0; i < 60; i++) print i < n ? "30,0.2" : "40,0.6" }' > weighted.$n
done
"$asperity" compare weighted.30 weighted.54 --bin 90 | rows /dev/stdin | awk -F, '$1 == "cor_n" { m = 0.9 ^ 2 + 0.1 ^ 2
    se = sqrt(0.09 * 0.4 ^ 2 / (1 - m / 30) * m / 30) / $9 - 1; exit !($8 == 0.24 && se ^ 2 < 1e-10) }' || die "compare: the error of a weighted mean"

# Deposits: their shares, where the data tell outcomes.
awk 'BEGIN { print "alpha1_deg,cor_n,cor_t,outcome"; for (i = 0; i < 200; i++) print "30,0.5,0.7," (i % 4 ? "rebound" : "deposit") }' > quarter
awk 'BEGIN { print "alpha1_deg,cor_n,cor_t,outcome"; for (i = 0; i < 200; i++) print "30,0.5,0.7," (i % 2 ? "rebound" : "deposit") }' > half
"$asperity" compare quarter half > got
rows got | awk -F, '$1 == "deposits" { exit !($8 == 0.25 && $13 == 0.5 && $14 > 0) }' || die "compare: deposits: $(cat got)"
rows got | awk -F, '$1 == "cor_n" { exit !($7 == 150 && $12 == 100) }' || die "compare: deposits in means: $(cat got)"
awk -F, '$1 == "score" { d = $17 - 0.25 ^ 2 / (0.375 * 0.625 / 100); exit !(d * d < 1e-6) }' got || die "compare: Pearson's chi-square: $(cat got)"
"$asperity" compare quarter quarter | awk -F, '$1 == "score" { exit !($17 < 1e-20 && $18 > 0) }' || die "compare: the same deposits"

# Outcomes as other programs write them, and ledgers in units without a size: coefficients and angles count, no speeds.
ledger() { awk -F, -v units="$1" '!n++ { print "# asperity 1.0.0; fix w wall/rebound; units " units "; surface smooth"; print "alpha1_deg,cor_n,cor_t,outcome,v1,d_p"; next }
  { print $1 "," $2 "," $3 "," ($4 == "deposit" ? "1.0" : "0.0") ",7,1" }' quarter > "$1"; }
ledger si; ledger lj
"$asperity" compare si | rows /dev/stdin | awk -F, '$1 == "deposits" { exit !($8 == 0.25 && $5 == 7 && $6 == 1e6) }' || die "compare: outcomes 0.0 and 1.0"
"$asperity" compare lj | rows /dev/stdin | awk -F, '{ bad = bad || $5 $6 != "" } $1 == "deposits" { exit bad || $8 != 0.25 }' || die "compare: speeds and sizes of 'units lj'"
"$asperity" compare lj half | awk -F, '$1 == "cor_n" { exit !($7 == 150 && $12 == 100) }' || die "compare: 'units lj' and data"
sed 's/1.0,7,1$/maybe,7,1/' si > outcomes
refuses_rows compare

# Standard input in place of either, and of any file of any command.
"$asperity" compare quarter half | grep -v '^#' > wanted
"$asperity" compare - half < quarter | grep -v '^#' | cmp wanted || die "compare - from a file"
cat half | "$asperity" compare quarter - | grep -v '^#' | cmp wanted || die "compare - from a pipe"
"$asperity" materials | "$asperity" cor materials ard hastelloy-x file /dev/stdin --angles 45 > got || die "cor materials ... file /dev/stdin"
printf 'alpha1_deg,cor_n,cor_t\n10,0.9,0.8\n80,0.3,0.7\n' | "$asperity" cor rebound table /dev/stdin --samples 1 --angles 10 | grep -q ',0.9,0.8,' || die "cor rebound table /dev/stdin"
printf 'x_um,z_um\n%s\n' "$(seq 0 400 | awk '{ print $1 "," sin($1 / 7) }')" | "$asperity" surface surface profile /dev/stdin --dp 10um > got || die "surface --profile -"

# The measurements that ship are read, and a law that was made of one set is that set.
data=$root/examples/data
for file in "$data"/grant_tabakoff_1975.csv "$data"/forder_1998.csv "$data"/kharaz_2001.csv "$data"/lamarche_2022.csv; do
  "$asperity" cor --angles 5:85:5,30.16,40.45,50.7,59.78,69.92,80.37,86.07,87.97,90 --samples 1 -o impacts
  "$asperity" compare impacts "$file" > got 2> err || die "$file: $(cat err)"
  [ "$(grep -vcE '1 of .* bins|there is no score' err)" = 0 ] || die "$file: $(cat err)" # CoR_T at 90 degrees is not defined
done
for set in grant_tabakoff_1975:grant_tabakoff "forder_1998:table $data/forder_1998.csv"; do
  # shellcheck disable=SC2086
  "$asperity" cor rebound ${set#*:} --angles 10:85:5 --samples 1 -o impacts
  "$asperity" compare impacts "$data/${set%%:*}.csv" --near 0.1 2> /dev/null | rows /dev/stdin | awk -F, '/^cor/ && $8 != "" && $13 != "" { s += ($8 - $13) ^ 2; n++ } END { exit !(n && sqrt(s / n) < 6e-5) }' || die "${set#*:} is not its data"
done
[ "$(grep -c 'Permission is hereby granted' "$data/lamarche_2022.LICENSE")" = 1 ] || die "LaMarche's data without their license"

# The picture names both files.
draws
"$asperity" compare quarter half --plot p.svg > got 2> err
printf 'alpha1_deg,cor_n,cor_t\n5,9,1\n5,1,1\n5,1.2,1\n' > far_off.csv
"$asperity" compare far_off.csv far_off.csv --plot off_axis.svg > got 2> err
grep -q 'outside: 2 of ' off_axis.svg && grep -q 'far_off' off_axis.svg || die "compare --plot: what it leaves out"
grep -q 'quarter' p.svg && grep -q 'half' p.svg || die "compare --plot: no names"
key=$(grep -B 1 -m 1 '<text>measured, mean' p.svg | grep -oE 'translate\([0-9.]+,[0-9.]+' | cut -d, -f2)
frame=$(grep "stroke='rgb( 68,  68,  68)'" p.svg | grep -oE "d='M[0-9.]+,[0-9.]+" | cut -d, -f2 | sort -g | head -n 1)
awk -v key="$key" -v frame="$frame" 'BEGIN { exit !(key > 0 && key < frame) }' || die "compare --plot: the key at $key is within the panel, from $frame on"

# One file of impacts alone: the same table without data, as `cor --summary` has it; a ledger by intervals of angle.
for way in --summary '--columns own' '--columns ledger'; do "$asperity" cor $wall seed 5 --angles 15,40,90 --samples 300 $way -o "alone${way##* }"; done
"$asperity" compare aloneown --plot alone.svg > got 2> err
[ "$(rows got | grep '^deposits' | cut -d, -f7 | paste -sd,)" = 300,300,300 ] && grep -q 'aloneown' alone.svg || die "compare IMPACTS: $(cat got err)"
rows got | awk -F, '$12 $13 $14 $15 $16 $17 $18 != "" || $1 == "score" { exit 1 }' || die "compare IMPACTS: data without a file: $(cat got)"
for name in capture_share:deposits:8 n:cor_n:7 cor_n_mean:cor_n:8 cor_n_sd:cor_n:10 cor_t_mean:cor_t:8 cor_t_sd:cor_t:10; do
  IFS=: read -r theirs quantity ours <<< "$name"
  paste <(rows got | grep "^$quantity," | cut -d, -f"$ours") <(column "$theirs" alone--summary) | awk '{ d = $1 - $2; if (d * d > 1e-9) exit 1 } END { exit NR != 3 }' || die "compare IMPACTS: $theirs is not that of cor --summary: $(cat got alone--summary)"
done
"$asperity" compare aloneledger | rows /dev/stdin | cut -d, -f1,7,8 | sed 's/0*\([0-9]e\)/\1/g' | cut -d, -f1,2 | cmp - <(rows got | cut -d, -f1,7) || die "compare LEDGER"
"$asperity" cor $wall --angles 1:90:0.5 --samples 2 | "$asperity" compare - --bin 30 > got
[ "$(rows got | grep '^deposits' | cut -d, -f7 | paste -sd,)" = 116,120,122 ] || die "compare - by intervals: $(cat got)"
# A ledger of a curved wall: flat triangles are hit many times at the same angle, others once. They are not places.
{ "$asperity" cor $wall --angles 20:60:2 --samples 30; "$asperity" cor $wall --angles 20.1:60:0.5 --samples 1 | grep '^[0-9]'; } > curved
"$asperity" compare curved --plot curved.svg > got
[ "$(rows got | grep '^deposits' | cut -d, -f7 | paste -sd,)" = 170,170,170,170,30 ] || die "compare LEDGER of a curved wall: $(head -n 20 got)"

# Bad usage; no input is written over.
refuses 2 "--near has no effect without DATA" -- compare aloneown --near 3
refuses 2 "one file or two" -- compare
printf 'alpha1_deg,cor_n_mean\n25,0.5\n' > elsewhere
refuses 2 "no bin has both" -- compare aloneown elsewhere
cp half kept; ln -s half link
for output in half ./link; do
  refuses 2 "is '$output', which is read" -- compare quarter half -o $output
  refuses 2 "is '$output', which is read" -- compare half -o $output
done
cmp -s half kept || die "the data were written over"

# A laboratory's angles, to half a degree on both sides of a border: a bin for each of them.
awk 'BEGIN { srand(3); print "alpha1_deg,cor_n,cor_t"
  for (a = 15; a <= 75; a += 15) for (i = 0; i < 30; i++) printf "%.3f,%.3f,%.3f\n", a + rand() - 0.5, 0.7 + 0.1 * rand(), 0.8 }' > lab
"$asperity" compare lab lab --near 1 --plot lab.svg > got 2> err
[ "$(rows got | grep -c ^cor_n)" = 5 ] || die "compare: clusters are cut: $(cat got err)"
"$asperity" calibrate lab rebound constant fit 0.8 --samples 100 2> err | grep -q ' 5 bins, 150 impacts' || die "calibrate: clusters are cut: $(cat err)"
"$asperity" compare lab lab --near 1 --bin 0.2 2> err > got
[ "$(rows got | grep -c ^cor_n)" -gt 5 ] || die "compare --bin 0.2: $(cat got err)"
exit 0
