# From a ledger: mean and standard deviation of CoR_N and CoR_T of the rebounds, in bins of 2 degrees.
# Columns: angle, mean and sd of CoR_N, mean and sd of CoR_T, number.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { FS = "," }
/^#/ || $1 == "tag" || $19 != 0 || $18 == "" { next }
{
  bin = int($11 / 2); n[bin]++
  sn[bin] += $17; qn[bin] += $17 * $17
  st[bin] += $18; qt[bin] += $18 * $18
}
function sd(sum, square, count) { v = (square - sum * sum / count) / (count - 1); return v > 0 ? sqrt(v) : 0 }
END {
  for (bin = 0; bin < 45; bin++)
    if (n[bin] > 1)
      print 2 * bin + 1, sn[bin] / n[bin], sd(sn[bin], qn[bin], n[bin]), st[bin] / n[bin], sd(st[bin], qt[bin], n[bin]), n[bin]
}
