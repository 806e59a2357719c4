#!/usr/bin/env bash
# Help, the pages of the manual and the completion of the shell that are made from it, lists of numbers, names in
# any case and with suggestions, endings of pictures.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"

# Every command of the list has its help.
commands=$("$asperity" --help | sed -n '/^Commands:/,/^$/s/^  \([a-z]*\) .*/\1/p')
[ "$(wc -w <<< "$commands")" -ge 7 ] || die "commands: $commands"
for command in $commands; do
  "$asperity" help "$command" > text
  "$asperity" "$command" --help | cmp - text || die "help $command is not $command --help"
  grep -q '^Examples:' text && grep -q "^  \$ asperity $command" text || die "$command: no examples"
done
"$asperity" compare --help | grep -qx 'Usage: asperity compare IMPACTS \[DATA\] \[options\]' || die "compare: its arguments in the synopsis"
! "$asperity" help nothing 2> err || die "help nothing"

# The pages of the manual tell the same, and no line of them begins as a request that is none.
if command -v help2man > /dev/null; then
  sh "$root/src/cli/man_pages.sh" man "$asperity"
  for command in $commands; do
    page=man/asperity-$command.1
    for section in NAME SYNOPSIS DESCRIPTION OPTIONS EXAMPLES '"SEE ALSO"'; do grep -qx ".SH $section" "$page" || die "$page: no $section"; done
    [ "$(grep -c '^\\fB\\-\\-' "$page")" -ge "$(options_of "$command" | wc -l)" ] || die "$page: options are missing"
  done
  grep -qx '.SH "DESCRIPTION OF A WALL"' man/asperity.1 && grep -q 'lambda_c' man/asperity.1 || die "the page of all commands"
  ! grep -nP "^['.](?!\\\\|[A-Z]|(br|nf|fi)$)" man/*.1 || die "a line of text begins as a request of troff"
fi

# Completion.
touch myfile.csv
source "$root/src/cli/asperity.bash"
complete_words() { COMP_LINE="$asperity $*"; COMP_POINT=${#COMP_LINE}; _asperity; }
complete_words help wall; [ "${COMPREPLY[*]}" = wall ] || die "completes help wall: ${COMPREPLY[*]}"
complete_words tra; [ "${COMPREPLY[*]}" = trade ] || die "completes commands: ${COMPREPLY[*]}"
complete_words cor --sam; [ "${COMPREPLY[*]}" = --samples ] || die "completes options: ${COMPREPLY[*]}"
complete_words cor materials ard hast; [ "${COMPREPLY[*]}" = hastelloy-x ] || die "completes materials: ${COMPREPLY[*]}"
complete_words cor surface sigma 5 spread trun; [ "${COMPREPLY[*]}" = truncated ] || die "completes models: ${COMPREPLY[*]}"
complete_words cor surface sigma 5 spread visible iso; [ "${COMPREPLY[*]}" = isotropic ] || die "completes choices: ${COMPREPLY[*]}"
complete_words cor rebound thorn; [ "${COMPREPLY[*]}" = thornton_ning ] || die "completes laws: ${COMPREPLY[*]}"
complete_words cor rebound wal; [ "${COMPREPLY[*]}" = walton ] || die "completes what is no law: ${COMPREPLY[*]}"
complete_words cor deposit off grain ''; [ "${COMPREPLY[*]}" = "sphere lever" ] || die "completes the values of grain: ${COMPREPLY[*]}"
complete_words cor surface rq 5um ''; [ "${COMPREPLY[*]}" = "lambda_c rdq rsm lay dp_bins" ] || die "completes what must follow rq: ${COMPREPLY[*]}"
complete_words cor surface rq 5um lambda_c ''; [ -z "${COMPREPLY[*]}" ] || die "completes a number: ${COMPREPLY[*]}"
complete_words cor surface rq 5um lambda_c 9um s; [ "${COMPREPLY[*]}" = "spread surface_energy seed" ] || die "completes the next clause: ${COMPREPLY[*]}"
complete_words surface surface rq 1um lambda_c 9um --gaps ""; [ "${COMPREPLY[*]}" = "refuse fill" ] || die "completes the values of an option: ${COMPREPLY[*]}"
complete_words surface surface rq 1um,2um lambda_c 9um --sa; [ "${COMPREPLY[*]}" = --save ] || die "completes options behind a list: ${COMPREPLY[*]}"
complete_words calibrate myfile.csv friction fit=0.1 rebound thorn; [ "${COMPREPLY[*]}" = thornton_ning ] || die "completes behind fit=: ${COMPREPLY[*]}"
for begun in compare calibrate "erosion" "compare myfile.csv" "cor -o" "cor surface profile" "cor rebound table" "compare --columns no.csv"; do
  complete_words $begun my; [ "${COMPREPLY[*]}" = myfile.csv ] || die "completes the file behind $begun: ${COMPREPLY[*]}"
done
complete_words cor my; [ -z "${COMPREPLY[*]}" ] || die "completes a file where none may be: ${COMPREPLY[*]}"
complete_words cor -o myf; [ "${COMPREPLY[*]}" = myfile.csv ] || die "completes files: ${COMPREPLY[*]}"

# Lists with ranges, whole numbers with exponents.
angles() { "$asperity" spread surface sigma 10 --summary --samples 10 --angles "$1" | awk -F, 'NR > 2 { printf "%s ", $2 }'; }
[ "$(angles 5,10:30:10,85)" = "5 10 20 30 85 " ] || die "a list with a range: $(angles 5,10:30:10,85)"
for bad in '' , 1, 1,,2 1:2 1:2:3:4 2:1:1 1:2:0 1:2:-1 0:1:1e-9 '1;2' 1:2: 91 0:91:1 nan 20-40 lognormal:1:2 lognormal:1:2:3 lognormal:1:3:2:1 lognormal:0:3:2 lognormal: normal:1:3:2; do
  refuses 2 "--angles is" -- cor --angles "$bad"
done
[ "$("$asperity" spread surface sigma 10 --samples 2e3 | wc -l)" = 2002 ] || die "--samples 2e3"
for bad in 1.5 -3 1e99 2e-1 1e3x nan ''; do
  ! "$asperity" spread surface sigma 10 --samples "$bad" > /dev/null 2> err || die "--samples '$bad'"
  grep -q "whole number, 1 to" err || die "--samples '$bad': $(cat err)"
done

# The words of a description, from their table: every clause and every word in it, with its values.
"$asperity" help wall > wall
for word in surface spread rebound materials friction surface_energy yield_stress deposit seed rq lambda_c lay dp_bins plane collisions remove u_tau; do
  grep -q "^ *$word " wall || die "help wall: $word"
done
for name in visible weibull bons thornton_ning yield_rate; do grep -qw "$name" wall || die "help wall: $name"; done
grep -q 'COR_N (0 to 1): [^[]*$' wall || die "help wall: a number that must be given shows a default"
for word in bons visible sigma oka; do
  "$asperity" help $word > text || die "help $word"
  grep -q "^  $word" text && [ "$(wc -l < text)" -lt 20 ] || die "help $word: $(cat text)"
done
grep -q 'HARDNESS (0 to inf stress)' text || die "help oka: its parameters"
complete_words help tho; [ "${COMPREPLY[*]}" = thornton_ning ] || die "completes help of a law: ${COMPREPLY[*]}"
# At most fifteen options, besides --help.
for command in surface spread cor trade; do [ "$(options_of $command | grep -vc '^--help$')" -le 15 ] || die "$command has too many options"; done

# Names.
one() { "$asperity" cor materials "$@" --samples 1 --angles 30 | tail -n 1; }
[ "$(one ard Hastelloy-X)" = "$(one ard hastelloy-x)" ] || die "names in any case"
! one ard hasteloyx 2> err || die "hasteloyx"
grep -q "did you mean 'hastelloy-x'?" err || die "suggestion: $(cat err)"
! one ard unobtainium 2> err || die "unobtainium"
! grep -q "did you mean" err || die "a suggestion that is none: $(cat err)"
printf 'name,youngs_modulus_pa,poissons_ratio,density_kg_m3\nMyAlloy,1e11,0.3,5000\n' > own.csv
[ "$(one ard myalloy file own.csv)" = "$(one ard MyAlloy file own.csv)" ] || die "own names in any case"
printf 'name,youngs_modulus_pa,poissons_ratio,density_kg_m3\nA,1e11,0.3,5000\na,1e11,0.3,5000\n' > twice.csv
! one ard a file twice.csv 2> err || die "the same name twice"
"$asperity" materials | awk -F, 'NR > 2' | grep -c '' | { read -r n; [ "$n" -ge 18 ] || die "$n materials"; }

# Pictures.
draws
"$asperity" spread surface sigma 10 --samples 100 --plot A.PNG -o /dev/null 2> /dev/null && head -c 4 A.PNG | grep -q PNG || die ".PNG"

# Files that cannot be written, or are two in one, are refused before work begins.
! timeout 5 "$asperity" trade surface sigma 9 --rays 1000000000 -o /nowhere/x.csv 2> err || die "trade -o /nowhere"
grep -q "cannot write '/nowhere/x.csv'" err || die "trade -o is checked before work begins: $(cat err)"
refuses 1 "cannot write '/nowhere/p.csv'" -- surface surface rq 5um lambda_c 40um --save /nowhere/p.csv
refuses 2 "--output and --save are both 'p.csv'" -- surface surface rq 5um lambda_c 40um -o p.csv --save p.csv
mkdir -p folder && ln -sf . here
for other in ./p.png folder/../p.png here/p.png "$PWD/p.png"; do
  refuses 2 "--output and --plot are both 'p.png'" -- cor surface sigma 5 --samples 2 -o "$other" --plot p.png
done
echo 'alpha1_deg,cor_n,cor_t' > read.csv
refuses 2 "--output is 'here/../$(basename "$PWD")/read.csv', which is read" -- compare read.csv -o "here/../$(basename "$PWD")/read.csv"
refuses 2 "--save is '-'" -- surface surface rq 5um lambda_c 40um --save -
"$asperity" surface surface rq 5um lambda_c 40um --points 8192 --save - -o slopes.csv | "$asperity" surface surface profile /dev/stdin --dp 10um > piped
grep -q '8192 points read' piped && [ -s slopes.csv ] || die "surface --save - in a pipe"
mkfifo pipe; cat pipe > through & "$asperity" spread surface sigma 10 --samples 10 -o pipe; wait
[ "$(wc -l < through)" = 12 ] || die "-o PIPE: $(cat through)"
