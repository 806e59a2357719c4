#!/usr/bin/env bash
# Coverage of the 95 % intervals of `asperity calibrate` over synthetic measurements with known constants, for three laws:
# calibrate.sh [TRIALS [JOBS [IMPACTS_AT_AN_ANGLE...]]] (of seven angles). Of all intervals, 0.93 to 0.97 must hold the truth
# in 100 trials and more, with fewer than 50 impacts 0.90 and more; in the few of a test 0.75 of them, and no estimate may be farther off than 4.5 standard errors.
# Prints a row for each constant. Before that: a yield stress that scatters and a lever, each of them alone in the data and both unknown, are told apart.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/../cli/cli.sh"
trials=${1:-1} jobs=${2:-1}; shift $(($# < 2 ? $# : 2))
sizes=${*:-10}
export asperity

# trial LAW IMPACTS SEED: rows LAW,IMPACTS,NAME,TRUTH,ESTIMATE,ERROR,LOW,HIGH,CHI2_PER_DOF. The search begins at 5 degrees, and
# at constants half as large again.
trial() {
  local law=$1 each=$2 seed=$((20 * $3 + ${#1})) of begin truth sigma=7.13
  case $law in
    bons) of='friction 0.3 yield_stress 2e8' begin='materials ard hastelloy-x friction fit=0.45 yield_stress fit=3e8' truth=$of ;;
    thornton_ning) of='friction 0.2 yield_stress 3e8' begin='materials ard hastelloy-x friction fit=0.3 yield_stress fit=2e8' truth=$of ;;
    walton) of='0.7 0.15 0.2' begin='fit=0.8 fit=0.25 0.2' truth='e 0.7 mu 0.15' ;;
  esac
  "$asperity" cor rebound "$law" $of surface sigma $sigma seed "$seed" --speed 60 --angles 10,20,30,45,60,75,85 --samples "$each" -o "data.$law.$each.$seed"
  "$asperity" calibrate "data.$law.$each.$seed" rebound "$law" $begin surface sigma fit seed $((100000 + seed)) --speed 60 2> /dev/null |
    awk -F, -v law="$law" -v each="$each" -v truth="sigma $sigma $truth" '
      BEGIN { n = split(truth, t, " "); for (i = 1; i < n; i += 2) is[t[i]] = t[i + 1] }
      /^# chi/ { split($0, w, " "); chi = w[3]; sub(/:/, "", chi) }
      $1 in is { row[++k] = law "," 7 * each "," $1 "," is[$1] "," $2 "," $3 "," ($4 == "" ? -1e99 : $4) "," ($5 == "" ? 1e99 : $5) }
      END { for (i = 1; i <= k; i++) print row[i] "," chi }' > "rows.$law.$each.$seed"
  rm "data.$law.$each.$seed"
}
export -f trial
# apart WORDS PRESENT VALUE ABSENT: sigma, friction and what is present come back within two standard errors; of what is absent there is a bound.
apart() {
  local wall='surface sigma' dust='materials quartz hastelloy-x yield_stress 200MPa' at='--dp 20um --speed 100'
  "$asperity" cor $wall 6 $dust $1 seed 21 $at --angles 10,20,30,45,60,75,85 --samples 100 -o steep
  "$asperity" calibrate steep $wall fit $dust scatter fit friction fit grain lever fit $at --samples 400 -o apart 2> err
  awk -F, -v wanted="sigma 6 friction 0.3 $2 $3" 'BEGIN { n = split(wanted, w, " "); for (i = 1; i < n; i += 2) is[w[i]] = w[i + 1] }
    $1 in is { z = ($2 - is[$1]) / $3; found += $3 > 0 && z < 2 && z > -2 } END { exit found != 3 }' apart &&
    grep -qE "^# $4 < 0\.[0-9]+ at 95 %" apart && [ "$(grep -c '^# correlation' apart)" = 6 ] || die "$2 $3 and no $4: $(cat apart err)"
}
apart 'scatter 0.3' scatter 0.3 lever
apart 'grain lever 0.1' lever 0.1 scatter

for seed in $(seq 1 "$trials"); do for law in bons thornton_ning walton; do for each in $sizes; do echo "$law $each $seed"; done; done; done |
  xargs -P "$jobs" -L 1 bash -c 'trial "$@"' trial
cat rows.* > all
[ "$(wc -l < all)" = $((trials * 9 * $(wc -w <<< "$sizes"))) ] || { echo "FAILED: $(wc -l < all) rows"; exit 1; }
awk -F, -v trials="$trials" '
  BEGIN { print "law,impacts,parameter,truth,mean_estimate,mean_standard_error,sd_of_estimates,covered,farthest_z,mean_chi2_per_dof" }
  { k = $1 "," $2 "," $3; if (!(k in n)) order[++m] = k
    z = $6 > 0 ? ($5 - $4) / $6 : 0; if (z < 0) z = -z
    held = $7 <= $4 && $4 <= $8; of[$2]++; within[$2] += held
    n[k]++; truth[k] = $4; sum[k] += $5; square[k] += ($5 - $4) ^ 2; error[k] += $6; chi[k] += $9; hit[k] += held; if (z > far[k]) far[k] = z
    if (z > 4.5 && trials < 20 && $2 > 100) bad = 1 }
  END {
    for (i = 1; i <= m; i++) { k = order[i]; mean = sum[k] / n[k]
      printf "%s,%g,%g,%g,%g,%g,%.2f,%.3g\n", k, truth[k], mean, error[k] / n[k], sqrt(square[k] / n[k] - (mean - truth[k]) ^ 2), hit[k] / n[k], far[k], chi[k] / n[k] }
    for (size in of) { share = within[size] / of[size]; printf "# %.3f of the %d intervals from %d impacts hold the truth\n", share, of[size], size
      if (trials < 100 ? share < 0.75 : size < 50 ? share < 0.90 : share < 0.93 || share > 0.97) bad = 1 }
    if (bad) print "FAILED"; exit bad }' all
