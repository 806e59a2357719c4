#!/usr/bin/env bash
# Names that a user or a file gives reach gnuplot, CSV and the file system as text: pictures, profiles and materials whose
# names hold quotes, commands, gnuplot's own marks, newlines. Files are written whole or not at all.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"
{ echo x_um,z_um; awk 'BEGIN { srand(1); for (i = 0; i < 400; i++) { z = 0.9 * z + rand() - 0.5; print i "," z } }'; } > profile
mkdir pictures data
draws
echo "system 'touch pwned'" > .gnuplot # no start-up file is read
export HOME=$work
shown() { # NAME FILE: a text of the picture has the name
  sed 's/<[^>]*>//g; s/&lt;/</g; s/&gt;/>/g; s/&amp;/\&/g' "$2" | NAME=$1 awk '{ sub(/^[ \t]+/, "") } index($0, ENVIRON["NAME"]) { found = 1 } END { exit !found }'
}
names=("x'; system 'touch pwned'; set output 'y" 'x"; system "touch pwned"; set output "y' '`touch pwned`$(touch pwned)' 'back\' 'a_b^c{d}@e&f~g%s%n'
  $'new\nsystem "touch pwned"' '-o' '#x' 'ü<&>')
for i in "${!names[@]}"; do
  name=${names[i]} picture=pictures/${names[i]}.svg
  cp profile "data/$name"
  "$asperity" surface surface profile "data/$name" --dp 10um --plot "$picture" -o table 2> err || die "'$name': $(cat err)"
  grep -q '</svg>' "$picture" || die "no picture '$picture'"
  [ "$(grep -vc '^#' table)" = 2 ] || die "'$name' is not within its comment: $(cat table)"
done
for name in "e'.system('>pwned').'" "e'.system(\">pwned\").'" '`>pwned`$HOME' 'a_b^c{d}@e~f%s%n%d' '<b>&lt&ünï-back\'; do
  printf 'name,youngs_modulus_pa,poissons_ratio,density_kg_m3,yield_stress_pa\n"%s",7e10,0.17,2650,2e8\n' "${name//\"/\"\"}" > own.csv
  "$asperity" cor materials "$name" "$name" file own.csv surface rq 5um lambda_c 40um --dp 10um --samples 3 --plot m.svg -o /dev/null 2> err || die "cor of '$name': $(cat err)"
  shown "materials $name $name" m.svg || die "cor: '$name' is not in the picture's title"
done
[ "$(find pictures -type f -printf x | wc -c)" = ${#names[@]} ] || die "other files among the pictures: $(ls pictures)"
[ "$(find . -name pwned)" = "" ] || die "a name was run"

# A failure leaves what was there, and no part of a file; standard output is written to, not replaced.
"$asperity" materials -o target
cp target before
"$asperity" compare target profile -o target 2> err && die "compared with no data"
"$asperity" spread surface rq 20um lambda_c 40um --dp 2mm -o target 2> err && die "spread beyond the table"
cmp before target || die "a failure changed its output"
# What is wrong with a picture is seen before any work is done: that of these options would take hours.
work_of_hours=(trade surface rq 5um lambda_c 40um --dp 10um --rays 1000000000)
for plot in 'PATH=/nowhere none.png gnuplot-nox' 'A=1 /nowhere/none.png No such file' 'A=1 none.bmp .png, .svg or .pdf'; do
  read -r variable file words <<< "$plot"
  timeout 20 env "$variable" "$asperity" "${work_of_hours[@]}" --plot $file > /dev/null 2> err && die "--plot $file"
  grep -q "$words" err || die "--plot $file: $(cat err)"
done
[ ! -e none.png ] || die "an empty picture was left"
echo before > log; "$asperity" materials -o /dev/stdout >> log; "$asperity" materials -o - >> log
[ "$(grep -c '^quartz,' log)" = 2 ] && [ "$(head -n 1 log)" = before ] || die "-o /dev/stdout"
[ -z "$(find . -name '*.partial')" ] || die "a partial file is left"

# A signal that ends the command leaves neither its part of a file nor the table of a picture.
mkdir temporary
for signal in INT TERM HUP; do
  for to in "-o out" "-o out --plot out.png"; do
    TMPDIR=$work/temporary env --default-signal "$asperity" cor surface sigma 5 --samples 1000000 $to 2> err & pid=$!
    until [ -n "$(find . -name 'out.*.partial'; find /proc/$pid/fd -lname '/tmp/*(deleted)')" ]; do sleep 0.02; kill -0 $pid || die "cor $to: $(cat err)"; done
    status=0; kill -s $signal $pid; wait $pid 2> /dev/null || status=$?
    [ $status = $((128 + $(kill -l $signal))) ] || die "$signal: exit $status"
    [ -z "$(ls temporary; find . -name 'out*')" ] || die "$signal leaves: $(ls temporary; find . -name 'out*')"
  done
done
