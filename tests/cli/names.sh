#!/usr/bin/env bash
# Names that a user or a file gives reach gnuplot, CSV and the file system as text: pictures, data and
# materials whose names hold quotes, commands, gnuplot's own marks, newlines. Files that are written whole or not at all.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"

# Nothing but what is asked for may come into being: no file that a name would make if it were run.
no_more() { [ "$(find . -name '*pwned*' ! -name '*touch*' -printf x)" = "" ] || die "$1: a name was run: $(ls)"; }
is_picture() {
  case $1 in
    *.png) head -c 4 "$1" | grep -q PNG ;;
    *.pdf) head -c 5 "$1" | grep -q '%PDF-' && tail -c 6 "$1" | grep -q EOF ;;
    *.svg) grep -q '</svg>' "$1" ;;
  esac
}

# Names of pictures, and of the profiles that they show.
names=("it's" "x'; system 'touch pwned1'; set output 'y" 'x"; system "touch pwned2"; set output "y'
  '`touch pwned3`' '$(touch pwned4)' 'back\slash' 'back\' 'a_b^c{d}@e&f~g%s%n' $'new\nsystem "touch pwned5"' '-o' '#x' 'ü<&>')
{ echo x_um,z_um; awk 'BEGIN { srand(1); for (i = 0; i < 400; i++) { z = 0.9 * z + rand() - 0.5; print i "," z } }'; } > profile
mkdir pictures data
endings=(png svg pdf)
for i in "${!names[@]}"; do
  name=${names[i]} picture=pictures/${names[i]}.${endings[i % 3]}
  cp profile "data/$name"
  "$asperity" surface surface profile "data/$name" --dp 10um --plot "$picture" -o table 2> err || die "'$name': $(cat err)"
  is_picture "$picture" || die "no picture '$picture'"
  [ "$(grep -vc '^#' table)" = 2 ] || die "'$name' is not within its comment: $(cat table)"
done
[ "$(find pictures -type f -printf x | wc -c)" = ${#names[@]} ] || die "other files among the pictures: $(ls pictures)"
# compare puts two of them in its title.
"$asperity" cor rebound grant_tabakoff scatter 1 --dp 100um --angles 10:80:10 --samples 40 -o impacts
for name in "${names[@]:1:2}"; do
  cp impacts "data/$name"
  "$asperity" compare "data/$name" "data/$name" --plot c.svg -o table 2> err || die "compare '$name': $(cat err)"
  is_picture c.svg && [ "$(grep -vc '^#' table)" = 26 ] || die "compare '$name': $(cat table)"
done
no_more "files"

# Names of materials: shown in the title, letter by letter, and CSV stays CSV.
shown() { # NAME FILE: a text of the picture has the name
  sed 's/<[^>]*>//g; s/&lt;/</g; s/&gt;/>/g; s/&amp;/\&/g' "$2" | NAME=$1 awk '{ sub(/^[ \t]+/, "") } index($0, ENVIRON["NAME"]) { found = 1 } END { exit !found }'
}
for name in "e'.system('>pwned6').'" "e'.system(\">pwned7\").'" '`>pwned8`$HOME' 'a_b^c{d}@e~f%s%n%d' '<b>&lt&ünï-back\'; do
  quoted=${name//\"/\"\"}
  printf 'name,youngs_modulus_pa,poissons_ratio,density_kg_m3,yield_stress_pa\n"%s",7e10,0.17,2650,2e8\n' "$quoted" > own.csv
  own=(materials "$name" "$name" file own.csv)
  "$asperity" cor "${own[@]}" surface rq 5um lambda_c 40um --dp 10um --samples 3 --plot m.svg -o /dev/null 2> err || die "cor of '$name': $(cat err)"
  shown "materials $name $name" m.svg || die "cor: '$name' is not in the picture's title"
done
printf 'name,youngs_modulus_pa,poissons_ratio,density_kg_m3,yield_stress_pa\nbad\x01name,7e10,0.17,2650,2e8\n' > own.csv
"$asperity" cor materials "$(printf 'bad\x01name')" hastelloy-x file own.csv --samples 3 --plot m.svg -o /dev/null 2> err
shown 'bad name' m.svg || die "a control character"
no_more "materials"

# gnuplot reads no start-up file of the folder or of the user.
echo "system 'touch pwned9'" > .gnuplot
HOME=$work "$asperity" spread surface sigma 10 --samples 50 --plot h.png -o /dev/null 2> err
no_more "start-up file"

mkdir deep; "$asperity" materials -o deep/target
cp deep/target before
# A failure leaves what was there, and no part of a file; standard output is written to, not replaced.
"$asperity" compare impacts profile -o deep/target 2> err && die "compared with no data"
"$asperity" spread surface rq 20um lambda_c 40um --dp 2mm -o deep/target 2> err && die "spread beyond the table"
cmp before deep/target || die "a failure changed its output"
if PATH=/nowhere "$asperity" spread surface sigma 10 --samples 50 --plot none.png > /dev/null 2> err; then die "gnuplot is missing"; fi
grep -q "gnuplot-nox" err || die "no gnuplot: $(cat err)"
[ ! -e none.png ] || die "an empty picture was left"
# Which is seen before any work is done: that of these options would take hours.
work_of_hours=(trade surface rq 5um lambda_c 40um --dp 10um --rays 1000000000)
for plot in 'PATH=/nowhere none.png gnuplot-nox' 'A=1 /nowhere/none.png No such file' 'A=1 none.bmp .png, .svg or .pdf'; do
  read -r variable file words <<< "$plot"
  timeout 20 env "$variable" "$asperity" "${work_of_hours[@]}" --plot $file > /dev/null 2> err && die "--plot $file"
  grep -q "$words" err || die "--plot $file: $(cat err)"
done
echo before > log; "$asperity" materials -o /dev/stdout >> log; "$asperity" materials -o - >> log
[ "$(grep -c '^quartz,' log)" = 2 ] && [ "$(head -n 1 log)" = before ] || die "-o /dev/stdout"
[ -z "$(find . -name '*.partial')" ] || die "a partial file is left"
exit 0
