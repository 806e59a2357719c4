#!/usr/bin/env bash
# Over 80 pairs of seeds the score of `asperity compare` is 1 on average, and scatters as its standard error says.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/../cli/cli.sh"
wall='surface rq 5um lambda_c 40um'
for seed in $(seq 1 80); do
  "$asperity" cor $wall seed "$seed" --angles 10,30,60 --samples 400 -o model
  "$asperity" cor $wall seed $((1000 + seed)) --angles 10,30,60 --samples 200 -o data
  "$asperity" compare model data | tail -n 1 >> scores
done
awk -F, '{ n++; s += $17; q += $17 ^ 2; e += $18 / 80; out += ($17 - 1) ^ 2 > 4 * $18 ^ 2 }
  END { m = s / n; sd = sqrt(q / n - m * m); print n, m, sd, e, out; exit !(n == 80 && m > 0.9 && m < 1.1 && e > 0.8 * sd && e < 1.25 * sd && out < 6) }' scores > verdict || die "scores of the true model: $(cat verdict)"
