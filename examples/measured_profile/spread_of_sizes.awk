# From a ledger: the standard deviation of delta_alpha over the diameter, in bins of a fifth of a decade.
# Columns: diameter / um, sd / degrees, its standard error.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { FS = "," }
/^#/ || $1 == "tag" || $9 <= 0 { next }
{ b = int(5 * log($9 * 1e6) / log(10)); n[b]++; s[b] += $12; q[b] += $12 * $12 }
END {
  for (b = 0; b < 15; b++)
    if (n[b] > 20) { sd = sqrt(q[b] / n[b] - (s[b] / n[b]) ^ 2); print 10 ^ ((b + 0.5) / 5), sd, sd / sqrt(2 * n[b]) }
}
