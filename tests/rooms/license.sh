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
bad=0 looked=0
files() { git ls-files 2> /dev/null || find . -type f -not -path './.git*' -not -path './build*' -printf '%P\n'; }
while read -r file; do
  stated "$file" && continue
  looked=$((looked + 1))
  head -n 40 "$file" | grep -q 'SPDX-License-Identifier: ' || { echo "FAILED: $file does not say its license"; bad=1; }
done < <(files)
[ "$looked" -gt 100 ] || { echo "FAILED: only $looked files were looked at"; bad=1; }
exit $bad
