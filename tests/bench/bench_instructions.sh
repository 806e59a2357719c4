#!/usr/bin/env bash
# One contact in instructions, counted by valgrind inside asp_wall_impact: a number that a noisy machine does
# not blur. Valgrind knows no AVX-512; the C library's functions are then those for AVX2.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
if ! command -v valgrind > /dev/null; then
  printf 'instructions of one contact: left out, for want of valgrind\t-\t-\t-\n'
  exit 0
fi
program=$ASPERITY_BIN/../tests/one_impact
contacts=90000
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
count() { # model, phi_r, isotropic or none; libraries are linked beforehand, so that the first call costs no more
  LD_BIND_NOW=1 valgrind --tool=callgrind --callgrind-out-file="$work/out" --toggle-collect=asp_wall_impact \
    "$program" "$1" "$2" "$contacts" ${3:-} 2> "$work/log" || { tail -n 5 "$work/log" >&2; exit 1; }
  awk -v contacts=$contacts '/Collected/ { printf "%.0f", $NF / contacts }' "$work/log"
}
none=$(count none 0.04)
printf 'instructions of one contact, `none` + bons\t%s\t-\t-\n' "$none"
for model in weibull visible 'visible isotropic' profile; do
  for phi_r in 0.04 0.13; do
    awk -v model="$model" -v phi_r=$phi_r -v here="$(count ${model%% *} $phi_r ${model#"${model%% *}"})" -v none="$none" 'BEGIN {
      printf "... `%s` + bons, phi_r %s, over `none`\t%.3g x (%d)\t-\t-\n", model, phi_r, here / none, here }'
  done
done
