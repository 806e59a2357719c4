#!/usr/bin/env bash
# cmake/liggghts_tree on a copy of the engine's headers: every source that it adds compiles there, and remove leaves what
# was there before. Usage: tree.sh BUILD HEADERS...
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
script=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)/cmake/liggghts_tree
build=$1; shift
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
die() { echo "FAILED: $*" >&2; exit 1; }

mkdir "$work/src"
for folder in "$@"; do cp -r "$folder/." "$work/src"; done
touch "$work/src/Make.sh"
(cd "$work/src" && find . | sort) > "$work/before"
"$script" install "$work/src" "$build" > "$work/how"
option=$(grep -oE -- "-iquote [^\"]+" "$work/how") || die "no -iquote in: $(cat "$work/how")"
grep -q -- "-L$work/src/asperity -lasperity_dem -lasperity" "$work/how" || die "no libraries in: $(cat "$work/how")"
mapfile -t added < <("$script" diff "$work/src" | sed -n 's/^added: //p')
sources=0
for file in "${added[@]}"; do
  [[ $file == *.cpp ]] || continue
  sources=$((sources + 1))
  # shellcheck disable=SC2086
  mpicxx -std=c++11 -fsyntax-only $option -I"$work/src" "$work/src/$file" 2> "$work/log" ||
    { head -n 20 "$work/log"; die "$file does not compile in the tree"; }
done
[ "$sources" -ge 2 ] || die "only $sources sources were added: ${added[*]}"
(cd "$work/src" && find . -type f -newer "$work/before" ! -path './asperity/*' | sed 's|^\./||' | sort) > "$work/new"
printf '%s\n' "${added[@]}" | grep -v '^asperity/' | sort | diff - "$work/new" || die "diff does not list what was added"
"$script" remove "$work/src" > /dev/null
(cd "$work/src" && find . | sort) | diff "$work/before" - || die "remove leaves another tree than before"

# A fork with other classes is refused, and stays as it is.
rm "$work/src/mesh_module_stress.h"
! "$script" install "$work/src" "$build" 2> "$work/log" || die "a tree without mesh_module_stress.h was taken"
grep -q "is not LIGGGHTS-PUBLIC 3.8.0 (LIGGGHTS-PFM" "$work/log" || die "no word of LIGGGHTS-PFM: $(cat "$work/log")"
[ ! -e "$work/src/asperity" ] || die "a refused tree was changed"
