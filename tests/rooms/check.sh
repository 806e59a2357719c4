#!/usr/bin/env bash
# Which room of src may know which: no file includes a header of a room that its own must not know, no object of the
# core uses a symbol that such a room defines, and no file lies loose in src. The table of CONTRIBUTING.md beside SRC has
# a row for each room, and no other. Each law and spread model is in the list of its kind and on the pages.
# Usage: check.sh SRC [OBJECTS]: the folder of the rooms, and that of the core's object files, in the same rooms.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
src=$1 objects=${2:-}
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
bad=0
say() { echo "FAILED: $*"; bad=1; }

# The rooms, and what each may know besides itself and the headers in src, of which the engines' rooms know those that are
# installed. An engine's headers are known to its own room only.
declare -A knows=(
  [base]=''
  [analysis]='base contact surface readers spread rebound erosion wall description'
  [surface]='base'
  [readers]='base surface'
  [spread]='base surface'
  [rebound]='base'
  [erosion]='base rebound'
  [wall]='base surface spread rebound erosion'
  [description]='base surface readers spread rebound erosion wall'
  [contact]='base'
  [dem]='base contact'
  [liggghts]='base contact dem'
  [lammps]='base contact dem'
  [openfoam]='base dem'
  [python]=''
  [cli]='base contact surface readers spread rebound erosion wall description analysis'
)
engines=' liggghts lammps openfoam '
with_mpi=" dem$engines"

may_know() { # ROOM OTHER
  [ "$1" = "$2" ] || [[ " ${knows[$1]} " == *" $2 "* ]]
}

for path in "$src"/*; do
  name=$(basename "$path")
  if [ -d "$path" ]; then
    [ -n "${knows[$name]+known}" ] || say "room '$name' is not in the list of $0"
  else
    [[ $name == @(CMakeLists.txt|asperity.h|asperity_engine.h|asperity_internal.h) ]] || say "'$name' lies loose in src"
  fi
done

# Rows of the table: `src/ROOM` ... | what it is.
contributing=$src/../.github/CONTRIBUTING.md
sed -nE '/^\| *`src\//s/^\|([^|]*)\|([^|]*[[:alpha:]][^|]*)\|.*/\1/p' "$contributing" | grep -oE '`src/[^`]+`' | tr -d '`' |
  sed 's|^src/||' | sort > "$work/described"
for path in "$src"/*; do
  name=$(basename "$path")
  [ "$name" = CMakeLists.txt ] || echo "$name"
done | sort > "$work/rooms"
# What a comment of a header that is installed names, one that is installed declares.
names() { grep -oE '\basp_[a-z0-9_]*[a-z0-9]\b' | sort -u; }
cat "$src"/asperity.h "$src"/asperity_engine.h > "$work/public"
comm -23 <(names < "$work/public") <(gcc -fpreprocessed -dD -E -P -x c "$work/public" | names) > "$work/undeclared"
while read -r name; do say "a header that is installed speaks of $name, which none declares"; done < "$work/undeclared"

comm -13 "$work/described" "$work/rooms" | while read -r name; do say "CONTRIBUTING.md does not describe src/$name"; done
comm -23 "$work/described" "$work/rooms" | while read -r name; do say "CONTRIBUTING.md describes src/$name, which is not there, or twice"; done
cmp -s "$work/described" "$work/rooms" || bad=1

# The test that calls every public function leaves none out.
functions() { grep -oE '\basp_[a-z0-9_]+\(' "$1" | sort -u; }
comm -23 <(functions "$src/asperity.h") <(functions "$src/../tests/unit/test_api.c") > "$work/uncalled"
[ ! -s "$work/uncalled" ] || say "tests/unit/test_api.c does not call $(paste -sd' ' "$work/uncalled")"

# What a law or model needs besides its file: a line in the list of its kind, and its name on the pages.
listed() { # NAME PATTERN FILE WORDS: the pattern is in the file, or belongs behind the first line with the words
  grep -qE -- "$2" "$src/$3" || say "src/$3:$(grep -nm 1 -- "$4" "$src/$3" | cut -d: -f1): add $1 here"
}
records=0
while IFS=, read -r room type list macro heading syntax; do
  for name in $(grep -ohP "^const $type aspi_${room}_\K\w+(?= = )" "$src/$room"/*.c); do
    records=$((records + 1))
    listed "$name" "\bX\($name\)" "$room/$list.h" "$macro"
    listed "$name" "\`$name\b" wall/models.md "^## $heading"
    [ -z "$syntax" ] || listed "$name" "\b$name\b" liggghts/fix_wall_rebound.md "^$syntax  "
    [ -z "$syntax" ] || listed "$name" "\*$name\*" lammps/fix_wall_rebound.rst "\*$syntax\* value"
  done
done << 'END'
rebound,asp_rebound_law,laws,ASP_REBOUND_LAWS(X),Restitution laws,rebound
spread,asp_spread_model,models,ASP_SPREAD_MODELS(X),Spread models,
erosion,aspi_erosion_law,laws,ASPI_EROSION_LAWS(X),Erosion,erosion
END
[ $records -ge 19 ] || say "only $records laws and models were found"

looked=0
while IFS=: read -r file include; do
  room=${file#"$src"/}; room=${room%%/*}
  looked=$((looked + 1))
  case $include in
    '<mpi.h>') [[ $with_mpi == *" $room "* ]] || say "$file includes $include" ;;
    '<'*) ;;
    asperity.h | asperity_engine.h | *.inc) ;;
    asperity_internal.h) [[ $with_mpi != *" $room "* ]] || say "$file includes $include; $room must do with asperity_engine.h" ;;
    */*) may_know "$room" "${include%%/*}" || say "$file includes $include: $room must not know ${include%%/*}"
      [ -e "$src/$include" ] || say "$file includes $include, which is not there" ;;
    *) [[ $engines == *" $room "* ]] || say "$file includes $include, which names no room" ;;
  esac
done < <(grep -rnoE '^#include +("[^"]*"|<[^>]*>)' --include='*.[ch]' --include='*.cpp' "$src"/*/ |
  sed -E 's/^([^:]*):[0-9]*:#include +/\1:/; s/"//g')
[ $looked -gt 100 ] || say "only $looked includes were found in $src"

# The symbols of the objects whose files are there: who defines them, and who uses them.
if [ -n "$objects" ]; then
  build=${objects%/src/CMakeFiles/*}
  symbols() { # SUFFIX [OPTION]: lines of folder of the objects, file, kind and symbol
    find "$build/src/CMakeFiles" -path '*.dir/*' -name "*.$1.o" | while read -r object; do
      path=${object##*.dir/}
      [ ! -e "$src/${path%.o}" ] || echo "$object"
    done | xargs -r nm -A -g ${2:-} | sed -nE 's|^.*/([^/]*\.dir)/([^:]*)\.o:[0-9a-f ]* ([A-Za-z]) (.*)|\1 \2 \3 \4|p'
  }
  symbols c > "$work/c"
  symbols cpp -C > "$work/cpp"
  [ "$(cut -d' ' -f 1,2 "$work/c" | sort -u | wc -l)" -gt 60 ] || say "few objects were found in $build"

  # Of the core.
  grep "^$(basename "$objects") " "$work/c" | awk -v work="$work" '{ room = $2; sub(/\/.*/, "", room) }
    $3 ~ /[Uw]/ { print $4, room, $2 > (work "/used"); next } { print $4, room > (work "/defined") }'
  [ "$(wc -l < "$work/defined")" -gt 50 ] || say "few symbols were found in $objects"
  while read -r symbol room file other; do
    may_know "$room" "$other" || say "$file uses $symbol: $room must not know $other"
  done < <(join <(sort "$work/used") <(sort "$work/defined"))

  # No two files of a room need each other, directly or through others.
  for room in base erosion readers spread rebound surface wall description contact analysis cli; do
    awk -v room="$room/" 'index($2, room) != 1 { next } $3 == "U" { uses[$2 " " $4]; next } { of[$4] = $2 }
      END { for (u in uses) { split(u, w, " "); if (w[2] in of) print w[1], of[w[2]] } }' "$work/c" > "$work/uses"
    tsort "$work/uses" > /dev/null 2> "$work/circle" || say "files of $room need each other: $(grep -v loop "$work/circle" | cut -d: -f2 | paste -sd' ')"
  done

  # Prefixes: what an object of C defines begins with asp_ or aspi_, in the command with cli_; what one of C++ defines is
  # in namespace asperity, or begins with aspi_ where it is found by name.
  # An engine's classes and the functions that it calls are named as it wants them, also MPI_Bcast of the launchers.
  awk '$3 !~ /[Uw]/ && $4 !~ ($2 ~ /^cli\// ? "^(cli_|main$)" : "^aspi?_") { print $2, $4 }' "$work/c" | sort -u > "$work/astray"
  awk '$3 ~ /[TDBR]/ { file = $2; sub(/^[^ ]* [^ ]* [^ ]* /, "")
      if (!/^(vtable for |typeinfo (name )?for |non-virtual thunk to )?(asperity|LAMMPS_NS|Foam)::/ && !/^(main|lammpsplugin_init|aspi_.*)$/ && !(file ~ /main\.cpp$/ && /^MPI_Bcast$/)) print file, $0 }' "$work/cpp" |
    sort -u >> "$work/astray"
  while read -r file symbol; do
    say "$file defines $symbol, which is neither asp_, aspi_ or cli_ as its room has it nor in namespace asperity"
  done < "$work/astray"
fi
exit $bad
