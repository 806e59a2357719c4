#!/usr/bin/env bash
# The ledger as a NumPy array: the rows of the CSV, to a float's precision, the same bytes on 1, 2 and 4 ranks
# and across a restart; `asperity compare` reads both alike, and says what is wrong with a bad file.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
grains 600 > grains.data
script() { # beginning, end
  head_of si | sed 's/boundary.*/boundary m m f/'; echo "$1
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all"; materials; echo "fix wall all wall/rebound primitive type 2 zplane 0.0 surface rq 10e-6 lambda_c 90e-6 rebound bons yield_rate 3e6 seed 4 ledger 70 file \${out}
fix move all nve/sphere
timestep 1e-8
$2"
}
script 'read_data grains.data' 'run 150
write_restart half.restart
run 250' > whole.in
script 'read_data grains.data' 'run 150' > first.in
script 'read_restart half.restart' 'run 250' > rest.in

# text FILE: the rows of an array, read by its layout: 88 bytes each behind a header of 2048.
text() {
  perl -e 'open F, "<:raw", $ARGV[0]; read F, $h, 2048; $h =~ /shape.: \((\d+),\)/ or die "no shape"; $n = $1;
    for (1 .. $n) { read(F, $r, 88) == 88 or die "cut short"; @v = unpack("q l d s l d d d f f f f f c f f f f c", $r);
      print join(",", map { my $t = sprintf("%.9g", $_); $t =~ /nan/i ? "" : $t } @v), "\n" } eof F or die "too long"' "$1"
}
engine 1 whole.in -var out whole.csv
[ "$(count_rows whole.csv)" -gt 500 ] || die "too few impacts for this test"
for ranks in 1 2 4; do
  engine $ranks whole.in -var out $ranks.npy
  same 1.npy $ranks.npy "$ranks ranks"
done
text 1.npy > rows.csv
[ "$(wc -l < rows.csv)" = "$(count_rows whole.csv)" ] || die "another number of rows than the CSV"
near whole.csv rows.csv "1 2 3 4 5 6 7 8 14 19" 1e-8
near whole.csv rows.csv "9 10 11 12 13 15 16 17 18" 1e-7
head -c 300 1.npy | grep -aq "; surface rq 1e-05 lambda_c 9e-05 spread visible isotropic collisions multiple rebound bons yield_rate 3000000" || die "no heading"

# A restart goes on where its file has the ledger, whatever the file is called by now, and cuts off the rest.
engine 2 first.in -var out part.npy
head -c 100 1.npy >> part.npy
engine 2 rest.in -var out part.npy
same 1.npy part.npy "a restart"
[ "$(head -c 2048 part.npy | tail -c 1 | od -An -tx1 | tr -d ' ')" = 0a ] || die "the header's end"

# asperity compare: the same from both, the warning of a fitted constant too.
printf 'alpha1_deg,cor_n,cor_t\n20,0.5,0.6\n40,0.4,0.5\n60,0.3,0.4\n' > data.csv
"$bin/asperity" compare whole.csv data.csv > a 2> a.err
"$bin/asperity" compare 1.npy data.csv > b 2> b.err
[ "$(grep -c '^cor_[nt],' a)" = 6 ] || die "compare: $(cat a)"
paste -d, <(grep '^cor_' a) <(grep '^cor_' b) | awk -F, '{ n = NF / 2; for (i = 2; i <= n; i++) { d = $i - $(i + n); if (d < 0) d = -d; m = $i < 0 ? -$i : $i; if (d > 2e-5 * m || ($i == "") != ($(i + n) == "")) { print; bad = 1 } } } END { exit bad }' || die "compare: CSV and array differ"
grep -q yield_rate a.err || die "compare: no warning"
same a.err b.err "compare: warnings"
# asperity erosion: alike.
for of in whole.csv 1.npy; do "$bin/asperity" erosion $of erosion dnv density 7800 --density 2650 | tail -n 1; done | paste -sd, |
  awk -F, '{ exit !($3 > 500 && $3 == $7 && $4 > 0 && ($4 / $8 - 1) ^ 2 < 1e-12) }' || die "erosion: CSV and array differ"

# Files that are none. bad FILE TEXT
bad() { ! "$bin/asperity" compare "$1" data.csv > out 2> err || die "$1 was taken"; grep -qF -- "$2" err || { cat err; die "'$2' is not in the message about $1"; }; }
head -c 5000 1.npy > short.npy;                                  bad short.npy "but it ends in row 34"
head -c 700 1.npy > header.npy;                                  bad header.npy "cut short"
sed "s/'alpha1_deg'/'alpha9_deg'/" 1.npy > column.npy;           bad column.npy "column 'alpha1_deg' is missing"
sed "s/('x', '<f8')/('x', '>f8')/" 1.npy > endian.npy;           bad endian.npy "column 'x' is of type '>f8'"
sed "s/'shape': (\([0-9]*\),)/'shape': (\1,2)/" 1.npy > two.npy; bad two.npy "one dimension"
sed "s/'descr': \[/'descr':  /" 1.npy > plain.npy;               bad plain.npy "named columns"
{ head -c 2048 1.npy; tail -c +2053 1.npy; } > moved.npy;        bad moved.npy "moved.npy: row "
{ printf '\x93NUMPY\x07\x00'; tail -c +9 1.npy; } > version.npy; bad version.npy "version 7"
