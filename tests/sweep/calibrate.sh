#!/usr/bin/env bash
# Synthetic measurements with known constants through `asperity calibrate`, for three laws and two walls:
# calibrate.sh [TRIALS [JOBS]]. The 95 % intervals must hold the truth in 90 to 99 % of 100 trials; in the few of a test,
# no estimate may be farther off than 4.5 standard errors, and 0.75 of them within 1.96. Prints a row for each constant.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/../cli/cli.sh"
trials=${1:-1} jobs=${2:-1}
export asperity

# trial LAW R_Q SEED: rows LAW,R_Q,NAME,TRUTH,ESTIMATE,ERROR,CHI2_PER_DOF
trial() {
  local law=$1 rq=$2 seed=$3 names options truth
  case $law in
    bons) names=sigma,friction,yield_stress options='--speed 60' truth='friction 0.3 yield_stress 2e8' ;;
    thornton_ning) names=sigma,friction,yield_stress options='--speed 60 --mu 0.2 --yield 3e8' truth='friction 0.2 yield_stress 3e8' ;;
    walton) names=sigma,e,mu options='--set e=0.7,mu=0.15,beta0=0.2' truth='e 0.7 mu 0.15' ;;
  esac
  local sigma; sigma=$(awk -v rq="$rq" 'BEGIN { print atan2(sqrt(2) * rq / 40, 1) * 45 / atan2(1, 1) }')
  "$asperity" cor --rebound "$law" $options --rq "$rq"mm --lambda-c 40mm --model visible --tilt isotropic --collisions multiple \
    --angles 15:75:15 --samples 200 --seed "$seed" -o "data.$law.$rq.$seed"
  # the search begins elsewhere: at 5 degrees, and at constants half as large again
  local begin
  case $law in
    bons) begin='--speed 60 --mu 0.45 --yield 3e8' ;;
    thornton_ning) begin='--speed 60 --mu 0.3 --yield 2e8' ;;
    walton) begin='--set e=0.8,mu=0.25,beta0=0.2' ;;
  esac
  OMP_NUM_THREADS=1 "$asperity" calibrate "data.$law.$rq.$seed" --rebound "$law" $begin --samples 1000 --fit $names --seed $((100000 + seed)) 2> /dev/null |
    awk -F, -v law="$law" -v rq="$rq" -v truth="sigma $sigma $truth" '
      BEGIN { n = split(truth, t, " "); for (i = 1; i < n; i += 2) is[t[i]] = t[i + 1] }
      /^# chi/ { split($0, w, " "); chi = w[3]; sub(/:/, "", chi) }
      $1 in is { row[++k] = law "," rq "," $1 "," is[$1] "," $2 "," $3 }
      END { for (i = 1; i <= k; i++) print row[i] "," chi }' > "rows.$law.$rq.$seed"
  rm "data.$law.$rq.$seed"
}
export -f trial
walls='1.13 3.54' # Phi_R 0.028 and 0.088, sigma 2.3 and 7.1 degrees
for seed in $(seq 1 "$trials"); do for law in bons thornton_ning walton; do for rq in $walls; do echo "$law $rq $seed"; done; done; done |
  xargs -P "$jobs" -L 1 bash -c 'trial "$@"' trial
cat rows.* > all
[ "$(wc -l < all)" = $((trials * 18)) ] || { echo "FAILED: $(wc -l < all) rows of $((trials * 18))"; exit 1; }
awk -F, -v trials="$trials" '
  BEGIN { print "law,rq_mm,parameter,truth,mean_estimate,mean_standard_error,sd_of_estimates,covered,farthest_z,mean_chi2_per_dof" }
  { k = $1 "," $2 "," $3; if (!(k in n)) order[++m] = k
    z = ($5 - $4) / $6; if (z < 0) z = -z
    n[k]++; truth[k] = $4; sum[k] += $5; square[k] += ($5 - $4) ^ 2; error[k] += $6; chi[k] += $7; hit[k] += z < 1.96; if (z > far[k]) far[k] = z
    within += z < 1.96; if (z > 4.5 && trials < 100) bad = 1 }
  END {
    for (i = 1; i <= m; i++) { k = order[i]; mean = sum[k] / n[k]; share = hit[k] / n[k]
      printf "%s,%g,%g,%g,%g,%g,%.2f,%.3g\n", k, truth[k], mean, error[k] / n[k], sqrt(square[k] / n[k] - (mean - truth[k]) ^ 2), share, far[k], chi[k] / n[k]
      if (trials >= 100 && (share < 0.90 || share > 0.99)) bad = 1 }
    if (trials < 100 && within < 0.75 * NR) bad = 1
    printf "# %.3f of all %d intervals hold the truth\n", within / NR, NR
    if (bad) print "FAILED"; exit bad }' all
