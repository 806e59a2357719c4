#!/usr/bin/env bash
# The paper's whole design of experiments, 2952 combinations from 262144 points each, and a part of it on one
# core and on two, in turn.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
asperity=$ASPERITY_BIN/asperity
result=$(mktemp) rounds=$(mktemp); trap 'rm -f "$result" "$rounds"' EXIT
seconds() { local begun; begun=$(date +%s.%N); "$@" > "$result"; awk -v a="$begun" -v b="$(date +%s.%N)" 'BEGIN { print b - a }'; }

# Five rounds: seconds on one core, on two, and their ratio.
for round in 1 2 3 4 5; do
  for threads in 1 2; do OMP_NUM_THREADS=$threads seconds "$asperity" doe --rq 5um,20um --points 65536; done |
    paste -s | awk '{ print $1, $2, $1 / $2 }'
done > "$rounds"
median() { cut -d ' ' -f "$1" "$rounds" | sort -g | sed -n 3p; }
printf '`asperity doe`, a part of the grid, on one core over two\t%.3g x (%.3g / %.3g s)\t-\t-\n' \
  "$(median 3)" "$(median 1)" "$(median 2)"

whole=$(seconds "$asperity" doe)
awk -v s="$whole" -v cores="$(nproc)" 'BEGIN {
  printf "`asperity doe`, the whole grid, cores: %d\t%.3g s\t<= 60\t%s\n", cores, s, s <= 60 ? "yes" : "NO" }'
awk '/median D_KL/ { printf "median D_KL of the normal fit; the paper'\''s is 0.0251\t%s\t-\t-\n", $12 }' "$result"
