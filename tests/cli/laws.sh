#!/usr/bin/env bash
# The commands rebound and compare, and laws, tables and materials of the user's own in all commands.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"
data=$root/examples/data

# rebound: the regimes of 10 um quartz on Hastelloy X, capture at 5.8 m/s, always under 1.6 um.
"$asperity" rebound --dp 10um --speed 5.7,5.9,10,100 > r
[ "$(header r)" = dp_um,v1_m_s,alpha1_deg,cor_n,cor_t,outcome ] || die "rebound: columns"
[ "$(column outcome r | paste -sd' ')" = "deposit rebound rebound rebound" ] || die "rebound: outcomes: $(cat r)"
"$asperity" rebound materials ard hastelloy-x vs materials ard ti-6al-4v --map capture --dp 1um,10um > c
[ "$(column capture_speed_m_s c | head -n 1)" = "" ] || die "capture: 1 um is caught at any speed"
column capture_speed_m_s c | awk 'NR == 2 { exit !($1 > 5.7 && $1 < 5.9) }' || die "capture: $(cat c)"
"$asperity" rebound surface_energy 0 --map capture --dp 10um > c
[ "$(column capture_speed_m_s c)" = 0 ] || die "capture without adhesion: $(cat c)"
"$asperity" rebound --map capture --points 9 > c
[ "$(rows c | wc -l)" = 9 ] && [ "$(column dp_um c | sed -n '1p;9p' | paste -sd' ')" = "0.5 200" ] || die "equal ratios: $(cat c)"
"$asperity" rebound rebound grant_tabakoff --map angles --angles 30,90 > a
[ "$(column cor_n a | head -n 1)" = 0.428811 ] && [ "$(column cor_t a | tail -n 1)" = "" ] || die "angles: $(cat a)"
"$asperity" rebound rebound bons temperature 1400 surface_energy 0 --map angles --angles 45 > a
"$asperity" rebound surface_energy 0 yield_stress 110e6 --map angles --angles 45 > b
[ "$(column cor_n a)" = "$(column cor_n b)" ] || die "rebound: temperature"
"$asperity" rebound --list > list
for law in bons constant grant_tabakoff table thornton_ning walton; do grep -q "^$law,,.*source" list || die "rebound --list: $law"; done
! "$asperity" rebound rebound bons soften 800 0.001 2> words || die "rebound: 'soften' without 'temperature'"
grep -q "'soften' has no effect without 'temperature T'" words || { cat words; die "rebound: 'soften' alone"; }
"$asperity" rebound rebound bons temperature 1800 --map capture --dp 10um > /dev/null 2> words
grep -q "a yield stress of 2e+07" words || { cat words; die "rebound: the yield stress of hot particles"; }
grep -q '^bons,temperature,K,0,' list || die "rebound --list: parameters"
for map in regimes capture angles; do
  "$asperity" rebound --map $map --points 5 --plot $map.png -o $map.csv 2> err
  head -c 4 $map.png | grep -q PNG || die "rebound --map $map --plot"
done
# spin on, friction of a law's own, and a flow that takes away what sticks
"$asperity" rebound rebound walton 0.98 0.092 0 --map angles --angles 60.55 > a
column cor_t a | awk '{ exit !($1 > 0.714 && $1 < 0.7143) }' || die "walton: $(cat a)"
"$asperity" rebound rebound bons spin on friction 5 surface_energy 0 --map angles --angles 20 > a
column cor_t a | awk '{ exit !($1 > 0.7142 && $1 < 0.7143) }' || die "bons spin on: $(cat a)"
"$asperity" rebound deposit freeze remove u_tau 2 gas_density 1.2 --map capture --dp 10um,100um > c
[ "$(column capture_speed_m_s c | tail -n 1)" = 0 ] && [ "$(column capture_speed_m_s c | head -n 1)" != 0 ] || die "--remove: $(cat c)"
# several laws: a law's own options go to the laws that have them; the picture names each
"$asperity" rebound rebound bons yield_rate 3e6 vs rebound bons yield_rate 3e6 materials ard quartz vs rebound thornton_ning vs rebound thornton_ning materials ard quartz --map angles --angles 45 --plot laws.svg > a 2> err
[ "$(column law a | paste -sd' ')" = "bons bons thornton_ning thornton_ning" ] || die "several laws: $(cat a)"
"$asperity" rebound rebound bons yield_rate 3e6 --map angles --angles 45 > b
[ "$(column cor_n a | head -n 1)" = "$(column cor_n b)" ] || die "several laws: --yield-rate"
"$asperity" rebound rebound thornton_ning materials ard quartz --map angles --angles 45 > b
[ "$(column cor_n a | tail -n 1)" = "$(column cor_n b)" ] || die "several laws: thornton_ning"
grep -q 'bons on quartz' laws.svg && grep -q 'several laws' laws.svg || die "several laws: names in the picture"
"$asperity" rebound rebound bons vs rebound thornton_ning --map capture --dp 10um > c
[ "$(column law c | paste -sd' ')" = "bons thornton_ning" ] || die "capture by several laws: $(cat c)"
refuses 2 "'vs' is given" "one description" -- rebound vs rebound walton 0.9 0.3 0
refuses 2 "'compliance' is unknown" -- rebound rebound bons compliance 3
refuses 2 "--speed is given" -- rebound --map capture --speed 5
refuses 2 "--dp is '1um,5um:200um'" "from:to:step" -- rebound --map capture --dp 1um,5um:200um
refuses 2 "a log-normal law" -- rebound --dp lognormal:1um:9um:3um
refuses 2 "--speed is '1,5:200'" -- rebound --map regimes --speed 1,5:200
"$asperity" rebound --map angles --dp 1um,10um --plot stick.svg > a 2> err
grep -q '1 µm, 100 m/s (sticks)' stick.svg && ! grep -q warning err || die "a curve that sticks: $(cat err)"
"$asperity" rebound --map angles --dp 1um --speed 1 --plot stick.svg > a 2> err || die "only curves that stick: $(cat err)"
printf 'alpha1_deg,cor_n,cor_t\n10,1.5,-0.3\n90,0.4,0.5\n' > beyond.csv
"$asperity" rebound rebound table beyond.csv --map angles --plot beyond.svg > a 2> err
grep -q '> *1.4<' beyond.svg && grep -q '> *-0.2<' beyond.svg || die "the axes do not grow"
refuses 2 "spin" "'maybe'" "off on" -- rebound rebound bons spin maybe
refuses 2 "gas_density" -- rebound deposit freeze remove u_tau 2
refuses 2 "'u_tau U' is expected" -- rebound deposit freeze remove gas_density 1.2
refuses 2 "gas_density is 0" -- rebound deposit freeze remove u_tau 2 gas_density 0
refuses 2 "c is missing" -- rebound rebound bons contact_area 0.2 0.1
refuses 2 "c is 11" "0 to 10" -- rebound rebound bons contact_area 0.2 0.1 11
refuses 2 "'scatter' is unknown" -- rebound rebound bons scatter 1
refuses 2 "yield_rate is 'soft'" -- rebound rebound bons yield_rate soft
refuses 2 "regimes, capture or angles" -- rebound --map all
refuses 2 "from <= to" -- rebound --dp 2um:1um:0.1um
refuses 2 "one angle" -- rebound --map capture --angles 10,20
refuses 2 "'surface' has no effect" "smooth" -- rebound surface sigma 3

# table: a user's coefficients
printf 'alpha1_deg,v1_m_s,cor_n,cor_t\n10,50,0.9,0.8\n80,50,0.3,0.7\n10,150,0.7,0.6\n80,150,0.1,0.5\n' > law.csv
"$asperity" rebound rebound table law.csv --map angles --angles 45 --speed 100 > a
[ "$(column cor_n a),$(column cor_t a)" = 0.5,0.65 ] || die "table: $(cat a)"
refuses 2 "'rebound table' is missing" -- rebound rebound table
refuses 2 "'law.csv' is unknown" -- rebound rebound bons law.csv
refuses 2 "no.csv" "No such file" -- rebound rebound table no.csv
refuses 2 "materials: " "no.csv" "No such file" -- rebound materials ard hastelloy-x file no.csv
refuses 2 "--materials: " "no.csv" "No such file" -- materials --materials no.csv
sed 4d law.csv > gap.csv; refuses 2 gap.csv "a gap" "150" -- rebound rebound table gap.csv
(cat law.csv; tail -n 1 law.csv) > twice.csv; refuses 2 "two rows" "80 degrees" -- rebound rebound table twice.csv

# Scatter that is counted twice: the means warn, the scatter is refused unless asked for.
"$asperity" cor surface rq 5um lambda_c 40um rebound grant_tabakoff --samples 2 -o x 2> err
grep -q "warning.*counts twice" err || die "cor: no warning: $(cat err)"
refuses 2 "twice" "scatter_twice" -- cor surface rq 5um lambda_c 40um rebound grant_tabakoff scatter 1
"$asperity" cor surface rq 5um lambda_c 40um rebound grant_tabakoff scatter 1 scatter_twice --samples 2 -o x 2> err
"$asperity" cor rebound grant_tabakoff scatter 1 --samples 2 -o x 2> err
[ ! -s err ] || die "cor: a warning on a smooth wall: $(cat err)"

# materials: what the command prints can be edited and read again.
"$asperity" materials -o mine.csv
sed -i 's/^quartz,"quartz",7e+10/quartz,"my ""quartz""",5e+10/; s/^al-2024/alu/' mine.csv
"$asperity" materials --materials mine.csv > all
[ "$(rows all | grep -c '^quartz,')" = 1 ] && grep -q '^quartz,"my ""quartz""",5e+10' all && grep -q '^alu,' all && grep -q '^al-2024,' all || die "materials: $(cat all)"
"$asperity" rebound materials quartz alu file mine.csv --map capture --dp 10um > a
"$asperity" rebound materials quartz al-2024 --map capture --dp 10um > b
[ "$(column capture_speed_m_s a)" != "$(column capture_speed_m_s b)" ] || die "materials: own quartz is not taken"
refuses 2 "'alu'" -- rebound materials ard alu
refuses 2 "yield stress" -- rebound materials al-2024 hastelloy-x
printf 'name,youngs_modulus_pa,poissons_ratio,density_kg_m3\nchalk,soft,0.2,2000\n' > bad.csv
refuses 2 "bad.csv:2" "'soft'" -- materials --materials bad.csv

# compare: the law's own scatter against the data that it is made of.
"$asperity" cor rebound grant_tabakoff scatter 1 --dp 100um --samples 300 -o gt.csv
"$asperity" compare gt.csv "$data/grant_tabakoff_1975.csv" --plot gt.png > g 2> err
head -c 4 gt.png | grep -q PNG || die "compare --plot"
[ "$(rows g | wc -l)" = 35 ] && rows g | tail -n 1 | grep -q ^score || die "compare: rows"
rows g | awk -F, '$8 != "" && $15 != "" && ($8 - $13) ^ 2 > (0.2 * $15) ^ 2 { print; bad = 1 } END { exit bad }' || die "compare: means"
grep -q '^# note:.*' g || die "compare: no note"

# points: a sample against itself has distance 0; against a shifted one it is told apart.
awk -F, '/^#/ { next } NR == 2 { print "note;alpha1_deg;cor_n"; next } NR % 40 == 0 { sub(/\./, ",", $8); print "x;" $3 ";" $8 }' gt.csv > self.csv
"$asperity" compare gt.csv self.csv --bin 10 > s
[ "$(column quantity s | sort | uniq -c | awk '{ print $1 }' | paste -sd' ')" = "9 9 1" ] || die "compare: bins"
rows s | awk -F, '$1 == "cor_t" && $13 != "" { bad = 1 } $1 == "score" { n++; bad = bad || $17 > 1 + 3 * $18 } END { exit bad || n != 1 }' || die "compare: the same law is told apart: $(cat s)"
awk -F';' 'NR > 1 { sub(/,/, ".", $3); $3 *= 2; } { print $2 "," $3 }' self.csv | sed '1s/.*/alpha1_deg,cor_n/' > twice.csv
"$asperity" compare gt.csv twice.csv --bin 10 > s
rows s | awk -F, '$1 == "score" { exit !($17 > 1 + 3 * $18) }' || die "compare: another law is not told apart: $(cat s)"

# Deposits have no coefficients; a place without impacts is told.
printf 'alpha1_deg,cor_n,cor_t,outcome\n30,0.5,0.7,rebound\n30,,,deposit\n90,0.25,,rebound\n30,0.5,0.7,rebound\n' > some
printf 'alpha1_deg,cor_n,cor_t\n30,0.5,0.7\n88,0.3,0.9\n' > d.csv
"$asperity" compare some d.csv > s 2> err
grep -q '^# 3 rebounds, 1 deposits' s && grep -q '^cor_n,30,30,30,,,2,0.5,' s && grep -q '^cor_t,30,30,30,,,2,0.7,' s && grep -q '^cor_t,88,86,90,,,0,' s || die "compare: deposits: $(cat s)"
grep -q "warning: cor_t: 1 of 2 bins" err || die "compare: empty bins: $(cat err)"

# what goes wrong
printf '\xef\xbb\xbfalpha1_deg\tcor_n\r\n30\t0,5\r\n' > bom.csv; "$asperity" compare gt.csv bom.csv > s || die "compare: byte-order mark"
printf 'alpha1_deg,cor_n\n0.5,0.9\n1.2,0.6\n' > rad.csv; "$asperity" compare gt.csv rad.csv > s 2> err
grep -q "look like radians" err || die "compare: radians: $(cat err)"
"$asperity" cor surface rq 5um lambda_c 40um rebound bons yield_rate 3e6 --samples 9 -o rough.csv
"$asperity" compare rough.csv d.csv > s 2> err; grep -q "counted twice" err || die "compare: double counting: $(cat err)"
refuses 2 "one file or two" -- compare
refuses 2 "no.csv" -- compare no.csv d.csv
refuses 2 "no.csv" -- compare gt.csv no.csv
printf 'angle,cor_n\n30,0.5\n' > bad.csv; refuses 2 "'alpha1_deg' is missing" "angle cor_n" -- compare gt.csv bad.csv
printf 'alpha1_deg,restitution\n30,0.5\n' > bad.csv; refuses 2 "neither points nor means" -- compare gt.csv bad.csv
printf 'alpha1_deg,cor_n,cor_n_mean\n30,0.5,0.5\n' > bad.csv; refuses 2 "both points and means" -- compare gt.csv bad.csv
printf 'alpha1_deg,cor_n\n30,0.5\n40 0.6\n' > bad.csv; refuses 2 "bad.csv:3" "1 fields" -- compare gt.csv bad.csv
printf 'alpha1_deg,cor_n\n120,0.5\n' > bad.csv; refuses 2 "bad.csv:2" "0 to 90" -- compare gt.csv bad.csv
bad() { printf '%b' "$1" > bad.csv; shift; refuses 2 bad.csv "$@" -- compare gt.csv bad.csv; }
bad 'alpha1_deg,cor_n,outcome\n30,0.5,lost\n' bad.csv:2 "outcome is 'lost'" "rebound or deposit"
bad 'alpha1_deg,cor_n [%]\n30,50\n' "'cor_n [%]'" "a number such as 0.5"
bad 'alpha1_deg,cor_n\n30,50\n60,40\n' "2 of 2 coefficients" "per cent"
bad 'alpha1_deg,cor_n,v1 [km/h]\n30,0.5,3\n' "'v1 [km/h]'" "m/s cm/s mm/s"
bad 'alpha1_deg,cor_n,v1_kmh\n30,0.5,3\n' "'v1_kmh'" "m/s cm/s mm/s"
bad 'alpha1_deg,cor_n,dp\n30,0.5,3\n' "'dp' is not stated" dp_um
bad 'alpha1_deg,cor_n,CoR_N [-]\n30,0.5,0.3\n' "columns 2 and 3, 'cor_n' and 'CoR_N [-]'" "must be one"
bad 'alpha1_deg,cor_n\n30,0.5,3\n' bad.csv:2 "3 fields under 2"
bad '1,2\n3,4\n' bad.csv:1 "'1' stands where a column name"
# the dialects of other people's tables, each with the same rows; what is stuck is a deposit
printf 'alpha1_deg,cor_n,cor_t,dp_um,v1_m_s,outcome\n30,0.5,0.7,10,20,rebound\n30,,,10,20,deposit\n60,0.25,0.75,10,20,rebound\n' > plain.csv
"$asperity" cor --angles 30,60 --speed 20 --samples 3 -o ours.csv
"$asperity" compare ours.csv plain.csv 2> err | grep -v '^#' > wanted
rows=(30 0,5 0,7 10 20 Rebound 30 '' '' 10 20 stuck 60 0,25 0,75 10 20 0)
dialect() { # LINES ABOVE, format of a row, mark of decimals
  { printf '%b' "$1"; printf "$2" "${rows[@]//,/$3}"; } > other.csv
  "$asperity" compare ours.csv other.csv 2> err | grep -v '^#' | cmp -s - wanted || die "compare: another dialect: $1: $(cat err)"
}
dialect 'sep=;\r\nRig 3, 2019\r\nProbe;A12\r\nAufprallwinkel [°];e_n;e_t [-];Durchmesser [µm];Aufprallgeschwindigkeit [m/s];outcome\r\n' '%s;%s;%s;%s;%s;%s\r\n' ,
dialect '# rig\nα1\te_n\te_t\td_p\tv1\toutcome\n[°]\t-\t-\tum\tm/s\t\n' '%s\t%s\t%s\t%s\t%s\t%s\n' ,
dialect 'Measured in May\n\nimpact angle (deg),CoR_N,CoR_T,particle diameter (um),impact speed (m/s),outcome\n' '%s,%s,%s,%s,%s,%s\n' .
printf 'alpha1_deg,cor_n\n' > bad.csv; refuses 2 "no row of data" -- compare gt.csv bad.csv
printf 'alpha1_deg,cor_n,outcome\n30,0.5,rebound\n' > few.csv; printf 'alpha1_deg,cor_n\n60,0.5\n' > far.csv
"$asperity" compare few.csv far.csv > s 2> err && die "compare: no overlap"
grep -q "do not overlap" err || die "compare: $(cat err)"
# Clumps and eccentric grains: a dumbbell in random positions, and the words.
printf 'x,y,z,d\n0,0,0,1\n1,0,0,1\n' > dumbbell.csv
"$asperity" cor rebound walton 0.9 0 0 deposit off grain clump dumbbell.csv --angles 90 --samples 100000 --summary > s
column cor_n_mean s | awk '$1 < 0.3159 || $1 > 0.3199 { exit 1 }' || die "dumbbell: $(cat s)"
column cor_n_sd s | awk '$1 < 0.2145 || $1 > 0.2165 { exit 1 }' || die "dumbbell: $(cat s)"
"$asperity" cor rebound walton 0.9 0.2 0 grain lever 0.03 --samples 1 > s
grep -q 'grain lever 0.03 seed' s || die "grain: $(head -n 1 s)"
refuses 2 "grain is 'cube'; it must be sphere, lever S or clump FILE" -- cor grain cube
refuses 2 "lever is 0; it must be 0 to 0.5" -- cor grain lever 0
refuses 2 "BETA0 0" -- cor rebound walton 0.9 0.2 0.4 grain lever 0.03
refuses 2 "absent.csv" -- cor grain clump absent.csv
refuses 2 "is for the command cor" -- calibrate "$data/lamarche_2022.csv" grain clump dumbbell.csv
exit 0
