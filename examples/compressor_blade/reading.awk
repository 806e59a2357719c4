# The results of the picture, in numbers, from the two ledgers.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN {
  FS = ","
  printf "%-7s %8s %14s %26s %9s %13s %16s %10s\n", "", "impacts", "later ones", "of these under 5 degrees",
    "deposits", "median d_p", "at later impact", "mass"
}
FNR == 1 { if (name) show(); name = FILENAME; sub(/.*\//, "", name); sub(/\.csv/, "", name); split("", d); n = later = flat = deposits = again = mass = 0 }
/^#/ || $1 == "tag" { next }
{ n++ }
$2 > 1 { later++; flat += $11 < 5 }
$19 == 1 { d[++deposits] = $9; again += $2 > 1; mass += 3.14159265 / 6 * 2650 * $9 ^ 3 }
function median(  i, j, x, gap) { # shell sort
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
  printf "%-7s %8d %12.1f %% %24.1f %% %9d %10.2f um %14.1f %% %7.3g ng\n", name, n, share(later, n),
    share(flat, later), deposits, median(), share(again, deposits), mass * 1e12
}
END { show() }
