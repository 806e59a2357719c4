#!/usr/bin/env bash
# Installs the build into a folder and uses the library from there as a program outside the project does: by CMake's
# find_package, and by pkg-config. Usage: check.sh BUILD
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
build=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
cmake --install "$build" --prefix "$work/prefix" > /dev/null
"$work/prefix/bin/asperity" --version

# Programs look for libraries in absolute folders only: an empty element of a run path, or one that is not
# absolute, would be the current directory.
programs=0
for program in "$build"/bin/* "$work"/prefix/bin/*; do
  programs=$((programs + 1))
  paths=$(readelf -d "$program" | sed -nE 's/.*\((RPATH|RUNPATH)\).*\[(.*)\]$/\2/p')
  [ -z "$paths" ] || ! grep -qvE '^/' <<< "${paths//:/$'\n'}" || { echo "$program: run path '$paths'"; exit 1; }
done
[ "$programs" -ge 2 ] || { echo "no programs were looked at"; exit 1; }

kind=static; [ ! -e "$(find "$work/prefix" -name libasperity.so)" ] || kind=shared
"$here/users.sh" "$work/prefix" $kind
program=$here/../../examples/c_program
cmake -S "$program" -B "$work/cmake" -DCMAKE_PREFIX_PATH="$work/prefix" > "$work/log" 2>&1 || { cat "$work/log"; exit 1; }
cmake --build "$work/cmake" > "$work/log" 2>&1 || { cat "$work/log"; exit 1; }
"$work/cmake/scatter"
"$work/cmake/engine" | grep -q '^the grain hits [1-9][0-9]* times, [1-9]'
# The line of the program's page, as printed, with the home folder here.
ln -s prefix "$work/.local"
line=$(grep '^cc scatter.c' "$program/README.md")
cp "$program/scatter.c" "$work"
(cd "$work" && HOME=$work bash -c "${line/cc /gcc -std=c11 -Wall -Wextra -Werror }")
"$work/scatter" > "$work/found"
# The same wall by the command: the rebounds of 10 000 impacts and their means agree within four standard errors of both.
"$work/prefix/bin/asperity" cor surface rq 5um lambda_c 40um spread visible plane collisions multiple \
  materials quartz 304-ss --dp 10um --speed 100 --angles 20 --samples 10000 |
  awk -F '[ ,]' 'NR == FNR { rebound = $6; n = $14; t = $18; next } $10 == "rebound" { k++; a += $8; b += $9; aa += $8 ^ 2; bb += $9 ^ 2 }
    function far(mean, sum, squares) { return (mean - sum / k) ^ 2 > 16 * 2 * (squares / k - (sum / k) ^ 2) / k + 1e-6 }
    END { exit (k - rebound) ^ 2 > 16 * 2 * (10000 - k) + 1 || far(n, a, aa) || far(t, b, bb) }' "$work/found" - ||
  { echo "the program and the command differ: $(cat "$work/found")"; exit 1; }

# The manual's pages, one of the command and one of each of its eight, and the shell's completion.
[ "$(find "$work/prefix" -path '*/man/man1/*.1' | wc -l)" -ge 9 ] || { echo "the manual's pages are not installed"; exit 1; }
[ -n "$(find "$work/prefix" -path '*/bash-completion/completions/asperity')" ] || { echo "no completion is installed"; exit 1; }
# A picture, by the scripts that are installed.
"$work/prefix/bin/asperity" cor surface sigma 5 --samples 5 --plot "$work/cor.svg" -o /dev/null 2> "$work/log" && grep -q '<svg' "$work/cor.svg" || { cat "$work/log"; exit 1; }
[ -e "$work/prefix/share/asperity/plot/look.gp" ] || { echo "no scripts are installed"; exit 1; }
# Pages and examples, whose links lead to what is installed.
doc=$work/prefix/share/doc/asperity
[ -x "$doc/examples/flat_plate/run" ] && [ -e "$doc/examples/look.gp" ] || { echo "no examples are installed"; exit 1; }
grep -q 'D. E. Shaw' "$doc/LICENSES/BSD-3-Clause.txt" || { echo "the license of what is compiled in is not installed"; exit 1; }
[ ! -e "$doc/examples/flat_plate/output" ] || { echo "an example's output is installed"; exit 1; }
while read -r page; do
  for link in $(grep -oP '\]\(\K[^)\s#]+' "$page" | grep -v '^http'); do
    case $link in *.h | *.c | *.cpp | *.gp | *tests/* | *.awk) continue ;; esac
    [ -e "$(dirname "$page")/$link" ] || { echo "$page: the link $link leads nowhere"; exit 1; }
  done
done < <(find "$doc" -name '*.md')
# The headers are C and C++ of any year from 1998 on, and the shared library promises what they declare, and no more.
for header in asperity.h asperity_engine.h; do
  for standard in c99 c11 c++98 c++17; do
    language=${standard%%[0-9]*}
    gcc -std=$standard -pedantic -Wall -Wextra -Werror -Wno-long-long -fsyntax-only -x "$language" "$work/prefix/include/$header"
  done
done
library=$(find "$work/prefix" -name 'libasperity.so.*' | head -n 1)
nm -D "$library" | sed -n 's/.* T \(asp_.*\)@@ASPERITY_[0-9]*$/\1/p' | sort > "$work/promised"
cat "$work"/prefix/include/asperity*.h | gcc -fpreprocessed -dD -E -P -x c - | grep -o 'asp_[a-z_]*(' | tr -d '(' | sort > "$work/declared"
[ "$(wc -l < "$work/promised")" -ge 60 ] && diff "$work/promised" "$work/declared" || { echo "the library promises other names than its headers"; exit 1; }
[ -z "$(nm -D --defined-only "$library" | grep ' T ' | grep -v '@@ASPERITY_')" ] || { echo "names without a version"; exit 1; }

# What was installed goes again, and nothing else.
installed=$(find "$work/prefix" -type f | wc -l)
[ "$installed" -ge 5 ] || { echo "only $installed files were installed"; exit 1; }
touch "$work/prefix/bin/another"
cmake --build "$build" --target uninstall > "$work/log" 2>&1 || { cat "$work/log"; exit 1; }
[ "$(find "$work/prefix" -type f -printf '%P ')" = 'bin/another ' ] || { echo "left: $(find "$work/prefix" -type f)"; exit 1; }
[ -z "$(find "$work/prefix" -type d -empty)" ] || { echo "empty folders are left: $(find "$work/prefix" -type d -empty)"; exit 1; }
if cmake --build "$build" --target uninstall > "$work/log" 2>&1; then echo "uninstalled twice"; exit 1; fi
tr -s " \n" " " < "$work/log" | grep -q "nothing is installed" || { cat "$work/log"; exit 1; }
