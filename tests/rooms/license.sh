#!/usr/bin/env bash
# Every source file says its license in one of its first lines (SPDX); pages, data and pictures, which have
# no room for it, are named in .reuse/dep5.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
patterns=$(sed -n 's/^Files: //p' .reuse/dep5 | grep -vx '\*') # the first, of all files, is for their copyright
stated() { # whether dep5 names the file
  local pattern
  set -f
  for pattern in $patterns; do
    # shellcheck disable=SC2254
    case $1 in $pattern) set +f; return 0 ;; esac
  done
  set +f
  return 1
}
# The tree of an archive has no git, and what runs have written besides (.gitignore).
files() { git ls-files 2> /dev/null || find . \( -path './build*' -o -name output -o -name __pycache__ \) -prune -o \
  -type f -not -name '*.log' -not -name log.liggghts -printf '%P\n'; }
mapfile -t looked < <(files | while read -r file; do stated "$file" || echo "$file"; done)
[ ${#looked[@]} -gt 100 ] || { echo "FAILED: only ${#looked[@]} files were looked at"; exit 1; }
bad=$(printf '%s\n' "${looked[@]}" | sort |
  comm -13 <(grep -nHm 1 'SPDX-License-Identi[f]ier: ' "${looked[@]}" | awk -F: '$2 <= 40 { print $1 }' | sort) -)
[ -z "$bad" ] || { sed 's/.*/FAILED: & does not say its license/' <<< "$bad"; exit 1; }
