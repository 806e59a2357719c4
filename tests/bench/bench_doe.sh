#!/usr/bin/env bash
# The paper's whole design of experiments, 2952 combinations from 262144 points each, and a part of it on one
# core and on two, in turn.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
asperity=$ASPERITY_BIN/asperity
grid() { # R_Q POINTS
  seconds "$asperity" surface surface rq "$1" lambda_c 40um,80um,120um,240um,360um,400um --dp 1um,2um,5um:400um:5um --points "$2"
}
result=$(mktemp) rounds=$(mktemp); trap 'rm -f "$result" "$rounds"' EXIT
seconds() { local begun; begun=$(date +%s.%N); "$@" > "$result"; awk -v a="$begun" -v b="$(date +%s.%N)" 'BEGIN { print b - a }'; }

# Five rounds: seconds on one core, on two, and their ratio.
for round in 1 2 3 4 5; do
  for threads in 1 2; do OMP_NUM_THREADS=$threads grid 5um,20um 65536; done |
    paste -s | awk '{ print $1, $2, $1 / $2 }'
done > "$rounds"
median() { cut -d ' ' -f "$1" "$rounds" | sort -g | sed -n 3p; }
printf '`asperity surface`, a part of the grid, on one core over two\t%.3g x (%.3g / %.3g s)\t-\t-\n' \
  "$(median 3)" "$(median 1)" "$(median 2)"

whole=$(grid 2um,5um,10um,15um,20um,25um 262144)
awk -v s="$whole" -v cores="$(nproc)" 'BEGIN {
  printf "`asperity surface`, the whole grid, cores: %d\t%.3g s\t<= 60\t%s\n", cores, s, s <= 60 ? "yes" : "NO" }'
grep -v '^#' "$result" | tail -n +2 | cut -d, -f11 | sort -g | awk '{ x[NR] = $1 } END { printf "median D_KL of the normal fit; the paper\047s is 0.0251\t%.4f\t-\t-\n", (x[int((NR + 1) / 2)] + x[int(NR / 2) + 1]) / 2 }'
