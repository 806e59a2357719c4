# The results of the picture, in numbers, from the three ledgers.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN {
  FS = ","
  printf "%-10s %22s %20s %22s %9s %18s\n", "", "CoR_N > 1, a1 < 10 deg", "sd CoR_N, 40-50 deg",
    "CoR_T < 0, a1 > 80 deg", "deposits", "their median d_p"
}
FNR == 1 { if (name) show(); name = FILENAME; sub(/.*\//, "", name); sub(/\.csv/, "", name); split("", d); low = over = n = s = q = steep = negative = deposits = 0 }
/^#/ || $1 == "tag" { next }
$19 == 1 { d[++deposits] = $9; next }
$11 < 10 { low++; over += $17 > 1 }
$11 > 40 && $11 < 50 { n++; s += $17; q += $17 * $17 }
$11 > 80 && $18 != "" { steep++; negative += $18 < 0 }
function median(  i, j, k, x, gap) { # shell sort
  for (gap = int(deposits / 2); gap > 0; gap = int(gap / 2))
    for (i = gap + 1; i <= deposits; i++) {
      x = d[i]
      for (j = i; j > gap && d[j - gap] > x; j -= gap) d[j] = d[j - gap]
      d[j] = x
    }
  return deposits ? d[int((deposits + 1) / 2)] * 1e6 : 0
}
function share(part, whole) { return whole ? 100 * part / whole : 0 }
function show() {
  printf "%-10s %20.1f %% %20.3f %20.1f %% %9d %15.2f um\n", name, share(over, low), sqrt(q / n - (s / n) ^ 2),
    share(negative, steep), deposits, median()
}
END { show() }
