#!/usr/bin/env bash
# cmake/lammps_tree on a LAMMPS source tree: its sources compile there against what `cmake --install` has put in place,
# with 8-byte tags, each list names the package once, and remove leaves what was there before. The tree is made of
# LAMMPS's headers, with which this build has compiled them with 4-byte tags, and the lines that matter; or it is that in
# ASPERITY_LAMMPS_TREE, which is copied, and they compile with both.
# Usage: lammps_tree.sh BUILD HEADERS...
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
home=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$1; shift
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
die() { echo "FAILED: $*" >&2; exit 1; }
tree=$work/lammps
mkdir -p "$tree"/{src,cmake/Modules/Packages,doc/src,doc/utils/sphinx-config}
if [ -n "${ASPERITY_LAMMPS_TREE:-}" ]; then
  sizes="SMALLBIG BIGBIG"
  for folder in src cmake doc; do cp -r "$ASPERITY_LAMMPS_TREE/$folder" "$tree"; done
else
  sizes=BIGBIG
  for folder in "$@"; do cp -r "$folder/." "$tree/src"; done
  printf 'set(STANDARD_PACKAGES\n  ADIOS\n  ASPHERE\n  ATC)\nforeach(PKG_WITH_INCL KSPACE PYTHON)\nendforeach()\n' > "$tree/cmake/CMakeLists.txt"
  printf '   * :doc:`wall/piston <fix_wall_piston>`\n   * :doc:`wall/reflect (k) <fix_wall_reflect>`\n' > "$tree/doc/src/Commands_fix.rst"
  printf '* :doc:`wall/reflect <fix_wall_reflect>` - reflecting wall(s)\n' > "$tree/doc/src/fix.rst"
  printf '   * :ref:`ASPHERE <PKG-ASPHERE>`\n\n----------\n\n.. _PKG-ASPHERE:\n\nASPHERE package\n' > "$tree/doc/src/Packages_details.rst"
  printf '   * - :ref:`ASPHERE <PKG-ASPHERE>`\n     - aspherical particle models\n     - x\n     - ellipse\n     - no\n' > "$tree/doc/src/Packages_list.rst"
  printf 'Aachen\nZyl\n' > "$tree/doc/utils/sphinx-config/false_positives.txt"
fi
cp -r "$tree" "$work/before"
script=$home/cmake/lammps_tree
"$script" install "$tree" > "$work/how"
"$script" install "$tree" > /dev/null # again: nothing twice
grep -q -- '-DPKG_ASPERITY=on -DCMAKE_PREFIX_PATH=' "$work/how" || die "how to build: $(cat "$work/how")"
[ "$(grep -cx '  ASPERITY' "$tree/cmake/CMakeLists.txt")" = 1 ] || die "the package is not in the list once"
[ "$(grep -cx 'include(Packages/ASPERITY)' "$tree/cmake/CMakeLists.txt")" = 1 ] || die "its CMake file is not included once"
for page in Commands_fix fix Packages_list; do
  [ "$(grep -c 'fix_wall_rebound' "$tree/doc/src/$page.rst")" = 1 ] || die "$page.rst does not name it once"
done
[ "$(grep -c '_PKG-ASPERITY:' "$tree/doc/src/Packages_details.rst")" = 1 ] || die "Packages_details.rst does not describe it once"
"$script" diff "$tree" > "$work/diff"
{ diff -rq "$work/before" "$tree" || true; } | sed -nE 's/^Files .* and (.*) differ$/\1/p' | sed "s|^$tree/||" | sort |
  diff <(sed -n 's/^changed: //p' "$work/diff" | sort) - || die "diff does not list what was changed"

cmake --install "$build" --prefix "$work/prefix" > /dev/null
sources=0
for file in $(sed -n 's/^added: \(.*\.cpp\)$/\1/p' "$work/diff"); do
  sources=$((sources + 1))
  for size in $sizes; do
    mpicxx -std=c++11 -fsyntax-only -DLAMMPS_$size -I"$work/prefix/include" -I"$work/prefix/include/asperity" \
      -I"$tree/src" -I"$tree/src/ASPERITY" "$tree/$file" 2> "$work/log" ||
      { head -n 20 "$work/log"; die "$file does not compile in the tree"; }
  done
done
[ "$sources" -ge 5 ] || die "only $sources sources were added"
# A style's header includes its base class only.
[ "$(grep -h '#include' "$tree/src/ASPERITY/fix_wall_rebound.h")" = '#include "fix.h"' ] || die "the header of the style includes more than fix.h"
"$script" remove "$tree" > /dev/null
diff -r "$work/before" "$tree" || die "remove leaves another tree than before"
