#!/usr/bin/env bash
# A build without engines, as a shared library, with the tests: every program that links it does, also those that are
# built on demand only. Every symbol that the library exports begins with asp_ and is declared in asperity.h or
# asperity_internal.h, every function declared there is exported, a program outside the project needs nothing but it, and the
# command runs. In the static library, too, what is not declared there does not begin with asp_. A missing or another LIGGGHTS or LAMMPS stops the
# configuration with a message that says what to install.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source_dir=$(cd "$here/../.." && pwd)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
die() { echo "FAILED: $*" >&2; exit 1; }

cmake -S "$source_dir" -B "$work/build" -DBUILD_SHARED_LIBS=ON -DASPERITY_LIGGGHTS=OFF -DASPERITY_LAMMPS=OFF \
  -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_FLAGS_DEBUG=-O0 -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DCMAKE_INSTALL_PREFIX="$work/prefix" \
  > "$work/log" 2>&1 || { cat "$work/log"; die "configuration without engines"; }
cmake --build "$work/build" -j 2 --target programs asperity > "$work/log" 2>&1 || { cat "$work/log"; die "build without engines"; }
! grep -q 'warning:' "$work/log" || { cat "$work/log"; die "the core does not compile without a warning"; }
cmake --install "$work/build" > "$work/install.log" 2>&1 || { cat "$work/install.log"; die "installation without engines"; }
! ls "$work"/build/bin/*-asperity 2> /dev/null || die "a launcher was built without an engine"
library=$(find "$work/prefix" -name libasperity.so)
[ -e "$library" ] || die "no libasperity.so is installed"

gcc -E -P -I"$source_dir/src" "$source_dir/src/asperity_internal.h" | tr '\n' ' ' | grep -oE '\basp_[a-z0-9_]+ *\(' | tr -d ' (' | sort -u > "$work/declared"
[ "$(wc -l < "$work/declared")" -gt 60 ] || die "few functions were found in asperity.h"
nm -D --defined-only "$library" | awk '$2 != "A" { sub(/@.*/, "", $3); print $3 }' | sort -u > "$work/exported"
more=$(comm -13 "$work/declared" "$work/exported")
[ -z "$more" ] || die "exported, and not declared in a header: $more"
less=$(comm -23 "$work/declared" "$work/exported")
[ -z "$less" ] || die "declared in a header, and not exported: $less"
nm -g --defined-only "$work"/build/src/CMakeFiles/asperity_core.dir/*/*.o | awk 'NF == 3 { print $3 }' | sort -u > "$work/global"
grep '^asp_' "$work/global" | comm -13 "$work/declared" - > "$work/inside"
[ ! -s "$work/inside" ] || die "names of the core's own begin as the public ones: $(cat "$work/inside")"
grep -v -e '^asp_' -e '^aspi_' "$work/global" > "$work/bare" && die "global names without a prefix: $(cat "$work/bare")"

"$here/users.sh" "$work/prefix" shared
"$work/prefix/bin/asperity" --version

# stops WORD... -- OPTIONS: the configuration fails and says the words.
stops() {
  local words=()
  while [ "$1" != -- ]; do words+=("$1"); shift; done; shift
  if cmake -S "$source_dir" -B "$work/build" -U 'LIGGGHTS_*' -U 'LAMMPS_*' -DASPERITY_LIGGGHTS=ON -DASPERITY_LAMMPS=ON "$@" > "$work/log" 2>&1; then die "configured with $*"; fi
  for word in "${words[@]}"; do tr -s ' \n' ' ' < "$work/log" | grep -qF -- "$word" || { cat "$work/log"; die "'$word' is not in the message for $*"; }; done
}
stops "apt-get install liggghts libliggghts-dev" "ASPERITY_LIGGGHTS=OFF" -- -DLIGGGHTS_LIBRARY=0
stops "apt-get install liggghts libliggghts-dev" -- -DLIGGGHTS_INCLUDE_DIR=0
echo 'no library at all' > "$work/libliggghts.so"
stops "LIGGGHTS_VERSION" "apt-get install liggghts" -- -DLIGGGHTS_LIBRARY="$work/libliggghts.so"
echo 'Version LIGGGHTS-PUBLIC 3.7.0, compiled' > "$work/libliggghts.so"
stops "is LIGGGHTS-PUBLIC 3.7.0" "LIGGGHTS-PUBLIC 3.8.0" "ASPERITY_LIGGGHTS=OFF" -- -DLIGGGHTS_LIBRARY="$work/libliggghts.so"
stops "apt-get install liblammps-dev" "ASPERITY_LAMMPS=OFF" -- -DASPERITY_LAMMPS=ON -DLAMMPS_LIBRARY=0
echo 'Massively Parallel Simulator - 2 Aug 2023' > "$work/liblammps.so"
stops "is of 2 Aug 2023" "29 Sep 2021, 7 Feb 2024, 4 Feb 2025" "ASPERITY_LAMMPS=OFF" -- -DLAMMPS_LIBRARY="$work/liblammps.so"
stops "apt-get install librandom123-dev" -- -DRandom123_INCLUDE_DIR=0
