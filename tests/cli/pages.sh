#!/usr/bin/env bash
# The pages against the files and the command: every link leads to a file that is there, every option that they name
# is one of the command that they name it for, the commands of the command's page run in their order, and their lines of
# Python run (where there are pandas and numpy).
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"
pages=$(cd "$root" && { { [ -e .git ] && git ls-files '*.md' 2> /dev/null; } || find . -name '*.md' -not -path './build*' -printf '%P\n'; })
[ "$(wc -w <<< "$pages")" -ge 15 ] || die "pages: $pages"

[ "$(wc -w < "$root/README.md")" -le 700 ] || die "README.md has $(wc -w < "$root/README.md") words"
links=0
while IFS=: read -r page link; do
  case $link in http*) continue ;; esac
  links=$((links + 1))
  [ -e "$root/${page%"${page##*/}"}${link%%#*}" ] || die "$page: the link $link leads nowhere"
done < <(cd "$root" && grep -oHP '\]\(\K[^)\s]+' $pages)
[ "$links" -ge 40 ] || die "only $links links were looked at"

# `asperity COMMAND ... --option`, up to the end of the line, a backtick, or a pipe: commands and options, once each.
commands='calibrate|compare|cor|erosion|map|materials|spread|surface|trade'
(cd "$root" && grep -ohP "\basperity \K($commands) [^\`|]*" $pages) | awk '
  { text = $0; while (match(text, /(^|[^A-Za-z0-9_-])--[a-z][a-z-]*/)) { word = substr(text, RSTART, RLENGTH); sub(/^[^-]/, "", word)
      print $1, word; text = substr(text, RSTART + RLENGTH) } }' | sort -u > named
for command in ${commands//|/ }; do options_of "$command" | sed "s/^/$command /"; done | sort > known
[ "$(wc -l < named)" -ge 25 ] || die "only these options were looked at: $(cat named)"
[ -z "$(comm -23 named known)" ] || die "a page has options that there are not: $(comm -23 named known)"

# The block of the command's page runs from the top, with few samples: each line reads what is in the tree or what one
# before it wrote.
ln -s "$root/examples" .
draws
sed -nE 's/^build\/bin\/asperity ([^#]*).*/\1/p' "$root/src/cli/README.md" > block
[ "$(wc -l < block)" -ge 10 ] || die "src/cli/README.md: the block has $(wc -l < block) lines"
while read -r line; do
  set -f; set -- ${line//400um:5um/400um:200um}; set +f
  case $1 in
    cor | spread) set -- "$@" --samples 5 ;;
    trade) set -- "$@" --angles 10 --rays 1000; [[ $line == *profile* ]] || set -- "$@" --ensemble 4 ;;
    calibrate) set -- "$@" --samples 100 ;;
  esac
  "$asperity" "$@" > out 2> err || die "src/cli/README.md: $line: $(cat err)"
done < block
"$asperity" sensitivity ledger.csv surface sigma 5 2> err && die "sensitivity reads a ledger of cor"
grep -q "the ledger that a fix wrote with 'columns full'" err || die "sensitivity: $(cat err)"

/usr/bin/python3 -c 'import numpy, pandas' 2> /dev/null || { echo "no pandas: the lines of Python are not run"; exit 0; }
"$asperity" surface surface rq 5um lambda_c 40um --points 8192 -o cor.csv
"$asperity" cor surface sigma 10 --angles 20 --samples 3 --columns ledger -o impacts.csv
for step in 1 2; do printf 'ITEM: TIMESTEP\n\n\n\n\n\n\n\nITEM: ENTRIES \n1 1 20 0.5 \n2 1 30 0.5 \n'; done | split -l 11 -d - rows. --additional-suffix .txt
{ printf 'import glob, numpy, pandas\n'
  for page in src/cli/README.md src/dem/fix.md; do
    grep -hE '^ *(table|impacts|rows) += ' "$root/$page" | sed 's/^ *//'
  done; } > lines.py
[ "$(grep -c 'pandas\.' lines.py)" -ge 3 ] && [ "$(grep -c 'numpy\.' lines.py)" -ge 2 ] || die "lines of Python: $(cat lines.py)"
printf 'assert len(rows) == 4\n' >> lines.py
/usr/bin/python3 lines.py || die "lines of Python: $(cat lines.py)"
