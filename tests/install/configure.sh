#!/usr/bin/env bash
# The configuration: without engines the core and the command build alone; a missing or another LIGGGHTS or LAMMPS
# stops it with a message that says what to install.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
die() { echo "FAILED: $*" >&2; exit 1; }

cmake -S "$source_dir" -B "$work/off" -DASPERITY_LIGGGHTS=OFF -DASPERITY_LAMMPS=OFF -DASPERITY_TESTS=OFF > "$work/log" 2>&1 || { cat "$work/log"; die "configuration without engines"; }
cmake --build "$work/off" -j 2 > "$work/log" 2>&1 || { cat "$work/log"; die "build without engines"; }
"$work/off/bin/asperity" --version > /dev/null
! ls "$work"/off/bin/*-asperity 2> /dev/null || die "a launcher was built without an engine"
! grep -q 'warning:' "$work/log" || { cat "$work/log"; die "the core does not compile without a warning"; }

# stops WORD... -- OPTIONS: the configuration fails and says the words.
stops() {
  local words=()
  while [ "$1" != -- ]; do words+=("$1"); shift; done; shift
  rm -rf "$work/on"
  if cmake -S "$source_dir" -B "$work/on" "$@" > "$work/log" 2>&1; then die "configured with $*"; fi
  for word in "${words[@]}"; do tr -s ' \n' ' ' < "$work/log" | grep -qF -- "$word" || { cat "$work/log"; die "'$word' is not in the message for $*"; }; done
}
stops "apt-get install liggghts libliggghts-dev" "ASPERITY_LIGGGHTS=OFF" -- -DLIGGGHTS_LIBRARY=0
stops "apt-get install liggghts libliggghts-dev" -- -DLIGGGHTS_INCLUDE_DIR=0
echo 'no library at all' > "$work/libliggghts.so"
stops "LIGGGHTS_VERSION" "apt-get install liggghts" -- -DLIGGGHTS_LIBRARY="$work/libliggghts.so"
echo 'Version LIGGGHTS-PUBLIC 3.7.0, compiled' > "$work/libliggghts.so"
stops "is LIGGGHTS-PUBLIC 3.7.0" "LIGGGHTS-PUBLIC 3.8.0" "ASPERITY_LIGGGHTS=OFF" -- -DLIGGGHTS_LIBRARY="$work/libliggghts.so"
stops "apt-get install liblammps-dev" "ASPERITY_LAMMPS=OFF" -- -DASPERITY_LAMMPS=ON -DLAMMPS_LIBRARY=0
echo 'Massively Parallel Simulator - 4 Feb 2025' > "$work/liblammps.so"
stops "is of 4 Feb 2025" "29 Sep 2021" "ASPERITY_LAMMPS=OFF" -- -DLAMMPS_LIBRARY="$work/liblammps.so"
stops "apt-get install librandom123-dev" -- -DRandom123_INCLUDE_DIR=0
