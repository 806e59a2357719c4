#!/usr/bin/env bash
# cmake/lammps_tree on a LAMMPS source tree: its sources compile there against what `cmake --install` has put in place,
# with 8-byte tags and without MPI, each list names the package once, and remove leaves what was there before. The tree is made of
# LAMMPS's headers, with which this build has compiled them with 4-byte tags, and the lines that matter, as in 2021 and as
# in 2026; or it is that in ASPERITY_LAMMPS_TREE, which is copied: they compile with both, and its own checks of lists and
# of style must find nothing.
# Usage: lammps_tree.sh BUILD HEADERS...
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
home=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=$1; shift
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
die() { echo "FAILED: $*" >&2; exit 1; }
tree=$work/lammps
mkdir -p "$tree"/{src,cmake/Modules/Packages,doc/src,doc/utils/sphinx-config,unittest/force-styles/tests,examples/PACKAGES}
if [ -n "${ASPERITY_LAMMPS_TREE:-}" ]; then
  sizes="SMALLBIG BIGBIG"
  mkdir "$tree/tools"
  mkdir -p "$tree/examples/PACKAGES"
  for folder in src cmake doc unittest tools/coding_standard; do
    cp -r "$ASPERITY_LAMMPS_TREE/$folder" "$tree/$(dirname $folder)"
  done
else
  sizes=BIGBIG
  for folder in "$@"; do cp -r "$folder/." "$tree/src"; done
  printf 'set(STANDARD_PACKAGES\n  ADIOS\n  ASPHERE\n  ATC)\nforeach(PKG_WITH_INCL KSPACE PYTHON)\nendforeach()\n' > "$tree/cmake/CMakeLists.txt"
  printf '   * :doc:`wall/piston <fix_wall_piston>`\n   * :doc:`wall/reflect (k) <fix_wall_reflect>`\n' > "$tree/doc/src/Commands_fix.rst"
  printf '* :doc:`wall/reflect <fix_wall_reflect>` - reflecting wall(s)\n' > "$tree/doc/src/fix.rst"
  printf '   * :ref:`ADIOS <adios>`\n   * :ref:`ATC <atc>`\n   * :ref:`COLVARS <colvars>`\n' > "$tree/doc/src/Build_package.rst"
  { cat "$tree/doc/src/Build_package.rst"; printf '\n----------\n\n.. _atc:\n\nATC package\n-----------\n'; } > "$tree/doc/src/Build_extras.rst"
  printf '   * :ref:`ASPHERE <PKG-ASPHERE>`\n\n----------\n\n.. _PKG-ASPHERE:\n\nASPHERE package\n' > "$tree/doc/src/Packages_details.rst"
  printf '   * - :ref:`ASPHERE <PKG-ASPHERE>`\n     - aspherical particle models\n     - x\n     - ellipse\n     - no\n' > "$tree/doc/src/Packages_list.rst"
  printf 'Aachen\nZyl\n' > "$tree/doc/utils/sphinx-config/false_positives.txt"
fi
script=$home/cmake/lammps_tree
list=Packages_list
if [ -z "${ASPERITY_LAMMPS_TREE:-}" ]; then
  # The tree of 2026: another page has the table of packages, and the tester can leave r-RESPA out.
  cp -r "$tree" "$work/newest"
  mv "$work/newest/doc/src/Packages_list.rst" "$work/newest/doc/src/Packages.rst"
  sed -i '/ATC/d; s/_atc:/_colvar:/; s/<colvars>/<colvar>/' "$work/newest"/doc/src/Build_{extras,package}.rst
  echo 'has_tag("no_respa")' > "$work/newest/unittest/force-styles/test_fix_timestep.cpp"
  cp -r "$work/newest" "$work/newest_before"
  "$script" install "$work/newest" > /dev/null
  [ "$(grep -c 'fix_wall_rebound' "$work/newest/doc/src/Packages.rst")" = 1 ] || die "Packages.rst does not name it once"
  for file in "$home"/cmake/lammps/tests/*; do
    cmp "$file" "$work/newest/unittest/force-styles/tests/${file##*/}" || die "the unit tests are not in the newest tree"
  done
  "$script" remove "$work/newest" > /dev/null
  diff -r "$work/newest_before" "$work/newest" || die "remove leaves another newest tree than before"
elif [ ! -f "$tree/doc/src/Packages_list.rst" ]; then
  list=Packages
fi
cp -r "$tree" "$work/before"
"$script" install "$tree" > "$work/how"
"$script" install "$tree" > /dev/null # again: nothing twice
grep -q -- '-DPKG_ASPERITY=on -DCMAKE_PREFIX_PATH=' "$work/how" || die "how to build: $(cat "$work/how")"
[ "$(grep -cx '  ASPERITY' "$tree/cmake/CMakeLists.txt")" = 1 ] || die "the package is not in the list once"
[ "$(grep -cx 'include(Packages/ASPERITY)' "$tree/cmake/CMakeLists.txt")" = 1 ] || die "its CMake file is not included once"
for page in Commands_fix fix $list; do
  [ "$(grep -c 'fix_wall_rebound' "$tree/doc/src/$page.rst")" = 1 ] || die "$page.rst does not name it once"
done
for page in Build_extras Build_package; do
  [ "$(grep -c 'ref:`ASPERITY <asperity>`' "$tree/doc/src/$page.rst")" = 1 ] || die "$page.rst does not list it once"
done
[ "$(grep -c '_asperity:' "$tree/doc/src/Build_extras.rst")" = 1 ] || die "Build_extras.rst does not tell once how to build it"
[ -f "$tree/examples/PACKAGES/asperity/in.dust" ] || die "its example is not there"
[ "$(grep -c '_PKG-ASPERITY:' "$tree/doc/src/Packages_details.rst")" = 1 ] || die "Packages_details.rst does not describe it once"
if [ -n "${ASPERITY_LAMMPS_TREE:-}" ]; then
  for check in "$tree"/doc/utils/check-*.py "$tree"/tools/coding_standard/*.py; do
    (cd "$tree" && PYTHONDONTWRITEBYTECODE=1 python3 "$check" $([[ $check == */doc/* ]] || echo .)) > "$work/log" 2>&1 || true
    ! grep -iE 'asperity|rebound|python3:|Traceback' "$work/log" || die "LAMMPS's ${check##*/}"
  done
fi
"$script" diff "$tree" > "$work/diff"
{ diff -rq "$work/before" "$tree" || true; } | sed -nE 's/^Files .* and (.*) differ$/\1/p' | sed "s|^$tree/||" | sort |
  diff <(sed -n 's/^changed: //p' "$work/diff" | sort) - || die "diff does not list what was changed"

cmake --install "$build" --prefix "$work/prefix" > /dev/null
standard=c++11
! grep -q 'requires a C++17' "$tree/src/lmptype.h" || standard=c++17
sources=0
for file in $(sed -n 's/^added: \(.*\.cpp\)$/\1/p' "$work/diff"); do
  sources=$((sources + 1))
  for size in $sizes; do
    mpicxx -std=$standard -fsyntax-only -DLAMMPS_$size -I"$work/prefix/include" -I"$work/prefix/include/asperity" \
      -I"$tree/src" -I"$tree/src/ASPERITY" "$tree/$file" 2> "$work/log" ||
      { head -n 20 "$work/log"; die "$file does not compile in the tree"; }
  done
done
[ "$sources" -ge 5 ] || die "only $sources sources were added"
# ... and, as for BUILD_MPI=off, with LAMMPS's stubs in place of MPI, which have few of its names; the library, too.
stubs=$home/tests/install/stubs
[ -z "${ASPERITY_LAMMPS_TREE:-}" ] || stubs=$tree/src/STUBS
for file in $(grep -rl --include="*.cpp" MPI_ "$home"/src/dem "$tree"/src/ASPERITY); do
  g++ -std=$standard -fsyntax-only -I"$stubs" -I"$home/src" -I"$tree/src" -I"$tree/src/ASPERITY" "$file" 2> "$work/log" ||
    { head -n 20 "$work/log"; die "$file does not compile without MPI"; }
done
# The package's files need the C++ library and LAMMPS only, no POSIX.
! grep -lE '#include <(unistd|strings|fcntl|dlfcn|sys/.*)\.h>' "$tree"/src/ASPERITY/* || die "a file of the package needs POSIX"
# A style's header includes its base class only.
[ "$(grep -h '#include' "$tree/src/ASPERITY/fix_wall_rebound.h")" = '#include "fix.h"' ] || die "the header of the style includes more than fix.h"
"$script" remove "$tree" > /dev/null
diff -r "$work/before" "$tree" || die "remove leaves another tree than before"
