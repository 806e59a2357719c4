#!/usr/bin/env bash
# Installs the build into a folder and uses the library from there as a stranger would: by CMake's
# find_package, and by pkg-config. Usage: check.sh BUILD
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

cmake -S "$here" -B "$work/cmake" -DCMAKE_PREFIX_PATH="$work/prefix" > "$work/log" 2>&1 || { cat "$work/log"; exit 1; }
cmake --build "$work/cmake" > "$work/log" 2>&1 || { cat "$work/log"; exit 1; }
"$work/cmake/stranger"
pc=$(find "$work/prefix" -name asperity.pc -printf %h)
# shellcheck disable=SC2046
gcc "$here/stranger.c" -o "$work/stranger" $(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs asperity) -lm
"$work/stranger"
# The header is C++11 too.
g++ -std=c++11 -pedantic -Wall -Werror -fsyntax-only -x c++ "$work"/prefix/include/asperity.h

# What was installed goes again, and nothing else.
installed=$(find "$work/prefix" -type f | wc -l)
[ "$installed" -ge 5 ] || { echo "only $installed files were installed"; exit 1; }
touch "$work/prefix/bin/another"
cmake --build "$build" --target uninstall > "$work/log" 2>&1 || { cat "$work/log"; exit 1; }
[ "$(find "$work/prefix" -type f -printf '%P ')" = 'bin/another ' ] || { echo "left: $(find "$work/prefix" -type f)"; exit 1; }
[ -z "$(find "$work/prefix" -type d -name asperity)" ] || { echo "an empty folder is left"; exit 1; }
if cmake --build "$build" --target uninstall > "$work/log" 2>&1; then echo "uninstalled twice"; exit 1; fi
tr -s " \n" " " < "$work/log" | grep -q "nothing is installed" || { cat "$work/log"; exit 1; }
