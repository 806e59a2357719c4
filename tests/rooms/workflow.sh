#!/usr/bin/env bash
# The workflow and its scripts name scripts that are there, and tests that are there: each word of a filter of ctest
# meets one. A script that starts an engine has Open MPI's session folder for itself. examples/run installs and builds
# what the cases need, and no more. Usage: workflow.sh BUILD
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
bad=0
say() { echo "FAILED: $*"; bad=1; }
# Those of this build, and by their files those that need an engine or a library that it is without.
tests=$(ctest --test-dir "$1" -N | sed -n 's/^ *Test *#[0-9]*: //p'
  for file in tests/{engine,unit,openfoam}/*.*; do
    name=${file##*/test_} name=${name##*/}
    for label in "$(basename "${file%/*}")" lammps; do echo "${label}_${name%.*}"; done
  done)
words=$(sed -nE "s/.*ctest --test-dir build[-a-z0-9]* .*-[ER] '([^']*)'.*/\1/p; s/^  '([^']*)' .*/\1/p; s/^  '([^']*)'$/\1/p" .ci/* .github/workflows/*.yml |
  tr '|' '\n')
[ "$(wc -w <<< "$words")" -ge 6 ] || say "only the filters $words were found"
while read -r word; do
  grep -qE -- "$word" <<< "$tests" || say "a filter of the workflow has '$word', which is in the name of no test"
done <<< "$words"
paths=$(sed -nE 's/^([^#]* )?((\.ci|cmake|tests)\/[a-z0-9_\/.]+).*/\2/p' .ci/* .github/workflows/*.yml)
[ "$(wc -w <<< "$paths")" -ge 8 ] || say "only the scripts $paths were found"
while read -r path; do [ -x "$path" ] || [[ -e $path && $path == *.sh ]] || say "the workflow has '$path', which is no script"; done <<< "$paths"
# Each test of this build has a row in the table of tests.
while read -r name; do
  grep -qF "\`$name\`" tests/README.md || say "tests/README.md has no row for the test '$name'"
done < <(ctest --test-dir "$1" -N | sed -n 's/^ *Test *#[0-9]*: //p')
launching=$(find examples tests .ci \( -name run -o -name '*.sh' \) -not -path '*/rooms/*' -exec grep -lE '(mpirun|timeout|launch).*(-asperity|program|lmp)"' {} +)
[ "$(wc -w <<< "$launching")" -ge 17 ] || say "only the scripts $launching start an engine"
for script in $launching; do
  grep -qE 'OMPI_MCA_orte_tmpdir_base=|^source .*/engine\.sh"' "$script" || say "$script starts an engine without OMPI_MCA_orte_tmpdir_base"
done

# A copy with cases that do nothing, on a machine with no package, whose apt-get and cmake note what they are to do. The
# file `unknown` has what its apt does not know.
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
mkdir -p "$work/bin" "$work/examples" "$work/build"
cp -r cmake "$work"; cp examples/run "$work/examples"
for case in examples/*/run; do install -D <(sed '1a exit' "$case") "$work/$case"; done
for name in apt-get cmake; do printf '#!/bin/sh\necho %s "$@" >> %s/log\n' $name "$work" > "$work/bin/$name"; done
printf '#!/bin/sh\ngrep -qx "$2" %s/unknown && echo "  Candidate: (none)" || echo "  Candidate: 1"\n' "$work" > "$work/bin/apt-cache"; : > "$work/unknown"
printf '#!/bin/sh\nexit 1\n' > "$work/bin/dpkg-query"; printf '#!/bin/sh\nexec "$@"\n' > "$work/bin/sudo"
chmod +x "$work"/bin/*
asked() { # WORDS THAT MUST BE ASKED FOR -- AND NOT -- COMMAND
  local wanted=() not=() word
  while [ "$1" != -- ]; do wanted+=("$1"); shift; done; shift
  while [ "$1" != -- ]; do not+=("$1"); shift; done; shift
  rm -f "$work/log"
  (cd "$work" && PATH=$work/bin:$PATH "$@" > out 2>&1) || say "$*: $(cat "$work/out")"
  for word in "${wanted[@]}"; do grep -qE -- "[ =]$word( |$)" "$work/log" || say "$* does not ask for $word: $(cat "$work/log")"; done
  for word in "${not[@]}"; do ! grep -qE -- "[ =]$word( |$)" "$work/log" || say "$* asks for $word"; done
}
for_tests="liblammps-dev libcmocka-dev valgrind help2man python3-sphinx python3-numpy python3-pip python3-setuptools python3-wheel python3-venv"
asked libliggghts-dev libgsl-dev gnuplot-nox asperity_command liggghts-asperity -DASPERITY_LAMMPS=OFF -- $for_tests lammps-asperity all -- examples/run
asked liblammps-dev lammps-asperity -DASPERITY_LIGGGHTS=OFF -- libliggghts-dev python3-sphinx all -- examples/run flat_plate --engine lammps
asked liblammps-dev lammps-asperity libliggghts-dev liggghts-asperity -- python3-sphinx -- examples/run hopper rotating_drum
asked weibull_fit -- libopenmpi-dev liggghts-asperity -- examples/run paper_figures
asked $for_tests libliggghts-dev installed -DASPERITY_LAMMPS=ON -- all -- examples/run c_program
asked $for_tests libliggghts-dev all -DASPERITY_LIGGGHTS=ON -DASPERITY_LAMMPS=ON -DASPERITY_TESTS=ON -- openfoam -- cmake/prepare
# Where an engine has no package.
says() { grep -q "$1" "$work/out" || say "'$1' is not said: $(cat "$work/out")"; }
echo libliggghts-dev > "$work/unknown"
asked liblammps-dev lammps-asperity -DASPERITY_LIGGGHTS=OFF -- libliggghts-dev liggghts -- examples/run
asked liblammps-dev -- libliggghts-dev -- examples/run channel hopper
says "channel is left out: this system has no package of LIGGGHTS"
echo liblammps-dev >> "$work/unknown"
asked libcmocka-dev python3-numpy all -DASPERITY_LIGGGHTS=OFF -DASPERITY_LAMMPS=OFF -DASPERITY_TESTS=ON -- libliggghts-dev liblammps-dev libopenmpi-dev -- cmake/prepare
says "without LIGGGHTS, of which" && says "without LAMMPS, of which"
asked weibull_fit -- liblammps-dev -- examples/run paper_figures
! (cd "$work" && PATH=$work/bin:$PATH examples/run > out 2>&1) || say "examples/run without an engine ends well"
says "flat_plate is left out: this system has no package of LIGGGHTS"
exit $bad
