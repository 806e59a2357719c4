#!/usr/bin/env bash
# Every spread model in the fix, by the registry's list: the ledger's mean and spread of delta_alpha are the
# command's, and the impacts are the same on 1 and 2 ranks.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
awk 'BEGIN { n = 800; print "g\n\n" n " atoms\n2 atom types\n\n-0.002 0.006 xlo xhi\n-0.002 0.006 ylo yhi\n-0.0005 0.001 zlo zhi\n\nAtoms\n"
  for (i = 1; i <= n; i++) printf "%d 1 2e-5 2650 %.12g %.12g %.12g\n", i, 1e-4 * (i % 40) - 9.396926e-5, 1e-4 * int(i / 40), 1e-5 + 3.420201e-5
  print "\nVelocities\n"; for (i = 1; i <= n; i++) print i, "93.96926 0 -34.20201 0 0 0" }' > beam.data
deck() { # spread
  head_of si
  echo "read_data beam.data
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all"
  materials
  echo "fix move all nve/sphere
timestep 5e-8
fix wall all wall/rebound primitive type 2 zplane 0.0 surface rq 8e-6 lambda_c 60e-6 $([ "${1%% *}" = traced ] && echo dp_bins 4) spread $1 rebound constant 1 1 deposit off ledger 40 file \${out}
run 40"
}
for model in $("$bin/asperity" help wall | sed -n '/^MODEL/,/^$/s/^  \([a-z]*\)$/\1/p'); do
  deck "$model collisions single" > "$model.in"
  engine 1 "$model.in" -var out one.csv
  engine 2 "$model.in" -var out two.csv
  same one.csv two.csv "$model on 1 and 2 ranks"
  [ "$(count_rows one.csv)" -ge 800 ] || die "$model: $(count_rows one.csv) impacts"
  read -r mean sd < <("$bin/asperity" cor surface rq 8um lambda_c 60um spread "$model" collisions single friction 0 yield_stress 1e15 deposit off --dp 20um --angles 20 --samples 20000 |
    awk -F, 'NR > 2 { n++; s += $4; q += $4 ^ 2 } END { m = s / n; v = q / n - m ^ 2; print m, (v > 0 ? sqrt(v) : 0) }')
  rows one.csv | awk -F, -v mean="$mean" -v sd="$sd" '$2 == 1 { n++; s += $12; q += $12 ^ 2 }
    END { m = s / n; v = q / n - m ^ 2; v = v > 0 ? sqrt(v) : 0; d = m - mean; e = v - sd
      if (d < 0) d = -d; if (e < 0) e = -e
      if (!(n == 800 && d <= 5 * sd / sqrt(n) && e <= 5 * sd / sqrt(n))) { print n, m, v, "command:", mean, sd; exit 1 } }' || die "$model: the ledger's tilts are not the command's"
done
