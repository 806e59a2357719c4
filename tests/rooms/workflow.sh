#!/usr/bin/env bash
# The workflow and its scripts name scripts that are there, and tests that are there: each word of a filter of ctest
# meets one. A script that starts an engine has Open MPI's session folder for itself. Usage: workflow.sh BUILD
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
bad=0
say() { echo "FAILED: $*"; bad=1; }
tests=$(ctest --test-dir "$1" -N | sed -n 's/^ *Test *#[0-9]*: //p')
words=$(sed -nE "s/.*ctest --test-dir build[-a-z0-9]* .*-[ER] '([^']*)'.*/\1/p; s/^  '([^']*)' .*/\1/p; s/^  '([^']*)'$/\1/p" .ci/* .github/workflows/*.yml |
  tr '|' '\n')
[ "$(wc -w <<< "$words")" -ge 6 ] || say "only the filters $words were found"
while read -r word; do
  grep -qE -- "$word" <<< "$tests" || say "a filter of the workflow has '$word', which is in the name of no test"
done <<< "$words"
paths=$(sed -nE 's/^([^#]* )?((\.ci|cmake|tests)\/[a-z0-9_\/.]+).*/\2/p' .ci/* .github/workflows/*.yml)
[ "$(wc -w <<< "$paths")" -ge 8 ] || say "only the scripts $paths were found"
while read -r path; do [ -x "$path" ] || [[ -e $path && $path == *.sh ]] || say "the workflow has '$path', which is no script"; done <<< "$paths"
launching=$(find examples tests .ci \( -name run -o -name '*.sh' \) -not -path '*/rooms/*' -exec grep -lE '(mpirun|timeout|launch).*(-asperity|program|lmp)"' {} +)
[ "$(wc -w <<< "$launching")" -ge 17 ] || say "only the scripts $launching start an engine"
for script in $launching; do
  grep -qE 'OMPI_MCA_orte_tmpdir_base=|^source .*/engine\.sh"' "$script" || say "$script starts an engine without OMPI_MCA_orte_tmpdir_base"
done
exit $bad
