#!/usr/bin/env bash
# The fit of `asperity calibrate` finds the same minimum wherever it begins: calibrate_starts.sh [SETS [STARTS [JOBS]]];
# without SETS, one on which searches once ended apart.
# Random data sets, of walls and laws with random constants, each fitted from the true constants and from random starts;
# chi^2 of all starts of a set must lie within 0.1. Prints a row for each set.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/../cli/cli.sh"
sets=${1:-1} starts=${2:-2} jobs=${3:-1} first=$(($# ? 1 : 23))
export asperity starts

one() {
  read -r law of angles samples < <(awk -v seed="$1" 'BEGIN { srand(seed); for (i = 0; i < 9; i++) rand()
    law = seed % 2 ? "walton" : "bons"
    of = law == "bons" ? sprintf("friction;%.3g;yield_stress;%.4g", 0.1 + 0.4 * rand(), 1e8 * (1 + 4 * rand())) : sprintf("%.3g;%.3g;0.2", 0.4 + 0.5 * rand(), 0.05 + 0.25 * rand())
    print law, sprintf("%s;surface;sigma;%.4g", of, 2 + 8 * rand()), "20,45,70", 40 + int(80 * rand()) }')
  "$asperity" cor rebound "$law" ${of//;/ } seed "$1" --speed 60 --angles "$angles" --samples "$samples" -o "data.$1"
  for start in $(seq 0 $((starts - 1))); do
    begin=$(awk -v truth="$of" -v law="$law" -v start="$start" -v seed="$1$start" 'BEGIN { srand(seed); for (i = 0; i < 9; i++) rand(); split(truth, t, ";")
      if (start == 0) { printf law == "bons" ? "materials ard hastelloy-x friction fit=%s yield_stress fit=%s surface sigma fit=%s\n" : "fit=%s fit=%s 0.2 surface sigma fit=%s\n", t[law == "bons" ? 2 : 1], t[law == "bons" ? 4 : 2], t[law == "bons" ? 7 : 6]; exit }
      if (law == "bons") printf "materials ard hastelloy-x friction fit=%.4g yield_stress fit=%.4g", 0.05 * 20 ^ rand(), 5e7 * 20 ^ rand()
      else printf "fit=%.4g fit=%.4g 0.2", 0.1 + 0.85 * rand(), 0.02 * 30 ^ rand()
      printf " surface sigma fit=%.4g\n", 20 ^ rand() }')
    "$asperity" calibrate "data.$1" rebound "$law" $begin --speed 60 2> /dev/null |
      awk '/^# the best/ { agreed = $9 "/" $5 } /^# chi/ { sub(/:.*chi.2 /, " ", $0); split($4, w, ","); print w[1], agreed }'
  done > "chi.$1"
  awk -v set="$1" -v law="$law" -v n="$samples" -v starts="$starts" '{ v = $1; if (NR == 1 || v < low) low = v; if (NR == 1 || v > high) high = v }
    END { printf "%d,%s,%d,%d,%.4f,%.4f\n", set, law, 3 * n, NR, low, high - low; exit !(NR == starts && high - low < 0.1) }' "chi.$1" >> rows || :
  rm "data.$1"
}
export -f one
seq "$first" $((first + sets - 1)) | xargs -P "$jobs" -L 1 bash -c 'one "$@"' one
echo 'set,law,impacts,starts,least_chi2,farthest_above'
sort -n rows
awk -F, -v sets="$sets" -v starts="$starts" '{ n++; if ($4 != starts || !($6 < 0.1)) bad++ } END { printf "# %d of %d sets have all of their starts within 0.1\n", n - bad, sets; exit bad > 0 || n != sets }' rows || die "starts that end elsewhere"
