#!/usr/bin/env bash
# Capture, the command compare, and tables and materials of the user's own. (What laws and tables are: unit_laws, unit_rebound,
# unit_spin.)
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"
data=$root/examples/data

# Capture of quartz on Hastelloy X: at 5.8 m/s for 10 um, always under 1.6 um, never without adhesion.
capture() { "$asperity" cor "$@" --capture --samples 20 > c && column capture_share c | paste -sd' '; }
[ "$(capture --dp 10um --speed 5.7,5.9,10,100)" = "1 0 0 0" ] || die "capture: $(cat c)"
[ "$(capture --dp 1um --speed 10,1e5)" = "1 1" ] || die "capture: 1 um is caught at any speed: $(cat c)"
[ "$(capture surface_energy 0 --dp 10um --speed 1e-9)" = 0 ] || die "capture without adhesion: $(cat c)"
[ "$(capture rebound bons soften 500C 0.001/K temperature 1500 --dp 10um --speed 7)" != "$(capture --dp 10um --speed 7)" ] || die "capture on a hot wall: $(cat c)"
read -r slow fast <<< "$(capture surface rq 5um lambda_c 40um --dp 10um --speed 6,12)"
awk -v a="$slow" -v b="$fast" 'BEGIN { exit !(a > b && a > 0 && a <= 1 && b < 1) }' || die "capture on a rough wall: $(cat c)"
draws
"$asperity" cor --capture --samples 1 --plot capture.svg > c 2> err || die "capture --plot: $(cat err)"
[ "$(rows c | wc -l)" = 3721 ] && [ "$(rows c | sed -n '1p;$p' | cut -d, -f 1,2 | paste -sd' ')" = "0.5,0.1 200,1000" ] || die "the grid of capture: $(head -n 3 c)"
grep -q 'share that sticks' capture.svg || die "capture --plot"

# What sticks by its viscosity is min(1, 10^(8.5 - 9000/(T - 500))) of the impacts at each temperature, a column of its own.
hot='rebound walton 0.8 0.3 0 deposit delete viscosity critical 1e4 vft -4.5 9000 500'
"$asperity" cor $hot --temperature 1380,1450:1600:75 --angles 90 --samples 20000 --summary > c
head -n 2 c | tail -n 1 | grep -q ',temperature_k$' || die "cor --temperature: the columns $(head -n 2 c)"
rows c | awk -F, '/^[0-9]/ { p = 10 ^ (8.5 - 9000 / ($NF - 500)); p = p > 1 ? 1 : p; d = $5 - p; n++; bad += d * d > 16 * p * (1 - p) / 20000 + 1e-12 }
  END { exit n != 4 || bad > 0 }' || die "the share that sticks by viscosity: $(cat c)"
refuses 2 "--temperature: the viscosity is asked for at 400 K" "more than 500 K" -- cor $hot --temperature 1400,400
refuses 2 "'viscosity' has no effect without 'temperature T'" -- cor $hot
refuses 2 "--temperature is given with --capture" -- cor $hot --temperature 1400 --capture
refuses 2 "'temperature' has no effect" "one of their own" -- cor ${hot/ deposit/ temperature 1400 deposit} --temperature 1400

smooth() { "$asperity" cor "$@" --samples 1; }
printf 'alpha1_deg,cor_n,cor_t\n10,1.5,-0.3\n90,0.4,0.5\n' > beyond.csv
smooth rebound table beyond.csv --plot beyond.svg > a 2> err
grep -q '> *1.4<' beyond.svg && grep -q '> *-0.2<' beyond.svg || die "the axes do not grow"

# Scatter that is counted twice: the means warn, the scatter is refused.
"$asperity" cor surface rq 5um lambda_c 40um rebound grant_tabakoff --samples 2 -o x 2> err
grep -q "warning.*counts twice" err || die "cor: no warning: $(cat err)"
"$asperity" cor rebound grant_tabakoff scatter 1 --samples 2 -o x 2> err
[ ! -s err ] || die "cor: a warning on a smooth wall: $(cat err)"

# materials: what the command prints can be edited and read again.
"$asperity" materials -o mine.csv
sed -i 's/^quartz,"quartz",7e+10/quartz,"my ""quartz""",5e+10/; s/^al-2024/alu/' mine.csv
smooth materials quartz alu file mine.csv --angles 45 > a
smooth materials quartz al-2024 --angles 45 > b
[ "$(column cor_n a)" != "$(column cor_n b)" ] || die "materials: own quartz is not taken"

# compare: the law's own scatter against the data that it is made of.
"$asperity" cor rebound grant_tabakoff scatter 1 --dp 100um --samples 300 -o gt.csv
"$asperity" compare gt.csv "$data/grant_tabakoff_1975.csv" --plot gt.png > g 2> err
head -c 4 gt.png | grep -q PNG || die "compare --plot"
[ "$(rows g | wc -l)" = 35 ] && rows g | tail -n 1 | grep -q ^score || die "compare: rows"
rows g | awk -F, '$8 != "" && $15 != "" && ($8 - $13) ^ 2 > (0.2 * $15) ^ 2 { print; bad = 1 } END { exit bad }' || die "compare: means"
grep -q '^# note:.*' g || die "compare: no note"

# Deposits have no coefficients; a place without impacts is told.
printf 'alpha1_deg,cor_n,cor_t,outcome\n30,0.5,0.7,rebound\n30,,,deposit\n90,0.25,,rebound\n30,0.5,0.7,rebound\n' > some
printf 'alpha1_deg,cor_n,cor_t\n30,0.5,0.7\n88,0.3,0.9\n' > d.csv
"$asperity" compare some d.csv > s 2> err
grep -q '^# 3 rebounds, 1 deposits' s && grep -q '^cor_n,30,30,30,,,2,0.5,' s && grep -q '^cor_t,30,30,30,,,2,0.7,' s && grep -q '^cor_t,88,86,90,,,0,' s || die "compare: deposits: $(cat s)"
grep -q "warning: cor_t: 1 of 2 bins" err || die "compare: empty bins: $(cat err)"

# what goes wrong
printf '\xef\xbb\xbfalpha1_deg\tcor_n\r\n30\t0,5\r\n' > bom.csv; "$asperity" compare gt.csv bom.csv > s || die "compare: byte-order mark"
refuses_rows laws
printf 'alpha1_deg,bounce\n30,0.5\n' > bad.csv; refuses 2 "neither impacts nor means" -- compare gt.csv bad.csv
printf 'alpha1_deg,cor_n,cor_n_mean\n30,0.5,0.5\n' > bad.csv; refuses 2 "both impacts and means" -- compare gt.csv bad.csv
bad() { printf '%b' "$1" > bad.csv; shift; refuses 2 bad.csv "$@" -- compare gt.csv bad.csv; }
bad 'alpha1_deg,cor_n [%]\n30,50\n' "'cor_n [%]'" "a number such as 0.5"
bad 'alpha1_deg,cor_n,v1 [km/h]\n30,0.5,3\n' "'v1 [km/h]'" "m/s cm/s mm/s"
bad 'alpha1_deg,cor_n,dp\n30,0.5,3\n' "'dp' is not stated" dp_um
bad 'alpha1_deg,cor_n,CoR_N [-]\n30,0.5,0.3\n' "columns 2 and 3, 'cor_n' and 'CoR_N [-]'" "must be one"
# the dialects of other people's tables, each with the same rows; what is stuck is a deposit
printf 'alpha1_deg,cor_n,cor_t,dp_um,v1_m_s,outcome\n30,0.5,0.7,10,20,rebound\n30,,,10,20,deposit\n60,0.25,0.75,10,20,rebound\n' > plain.csv
"$asperity" cor --angles 30,60 --speed 20 --samples 3 -o ours.csv
"$asperity" compare ours.csv plain.csv 2> err | grep -v '^#' > wanted
rows=(30 0,5 0,7 10 20 Rebound 30 '' '' 10 20 stuck 60 0,25 0,75 10 20 0)
dialect() { # LINES ABOVE, format of a row, mark of decimals
  { printf '%b' "$1"; printf "$2" "${rows[@]//,/$3}"; } > other.csv
  "$asperity" compare ours.csv other.csv 2> err | grep -v '^#' | cmp -s - wanted || die "compare: another dialect: $1: $(cat err)"
}
dialect 'sep=;\r\nRig 3, 2019\r\nProbe;A12\r\nimpact angle [°];e_n;e_t [-];diameter [µm];impact speed [m/s];outcome\r\n' '%s;%s;%s;%s;%s;%s\r\n' ,
dialect '# rig\nalpha_1\te_n\te_t\td_p\tv1\toutcome\n[°]\t-\t-\tum\tm/s\t\n' '%s\t%s\t%s\t%s\t%s\t%s\n' ,
dialect 'Measured in May\n\nimpact angle (deg),CoR_N,CoR_T,particle diameter (um),impact speed (m/s),outcome\n' '%s,%s,%s,%s,%s,%s\n' .
printf 'alpha1_deg,cor_n\n' > bad.csv; refuses 2 "no row of data" -- compare gt.csv bad.csv
printf 'alpha1_deg,cor_n,outcome\n30,0.5,rebound\n' > few.csv; printf 'alpha1_deg,cor_n\n60,0.5\n' > far.csv
"$asperity" compare few.csv far.csv > s 2> err && die "compare: no overlap"
grep -q "do not overlap" err || die "compare: $(cat err)"
