# The results of the pictures, in numbers: for each run its ledger NAME.csv, then NAME.depths by wear.awk. After blade.awk
# and ../seeds.awk.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { FS = ","; set_up() }
FNR == 1 && FILENAME ~ /csv$/ { name = case_of(FILENAME); split("", d); n = later = flat = back = deposits = again = mass = energy = grazing = 0 }
/^#/ || $1 == "tag" { next }
FILENAME ~ /depths$/ {
  split($0, depth, " ")
  add(name, "worn", depth[1]); add(name, "nose", depth[2]); add(name, "behind", depth[3]); add(name, "edge", depth[4])
  add(name, "impacts", n); add(name, "later", share(later, n)); add(name, "flat", share(flat, later))
  add(name, "back", share(back, later)); add(name, "deposits", deposits); add(name, "median", median())
  add(name, "again", share(again, deposits)); add(name, "mass", mass * 1e9); add(name, "grazing", share(grazing, energy))
  next
}
{ n++; m = PI / 6 * 2650 * $9 ^ 3; energy += m * $10 ^ 2; if ($11 < 5) grazing += m * $10 ^ 2 }
$2 > 1 { later++; flat += $11 < 5; back += position(int($5 / 2) % LOOP) >= 0.79 }
$19 == 1 { d[++deposits] = $9; again += $2 > 1; mass += m }
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
function row(title, what, form,   k) {
  printf "%-42s", title
  for (k = 1; k <= cases; k++) printf " %18s", show(names[k], what, form)
  print ""
}
END {
  printf "%-42s", ""
  for (k = 1; k <= cases; k++) printf " %18s", names[k]
  print ""
  row("impacts", "impacts", "%.0f")
  row("later than a grain's first, %", "later", "%.2f")
  row("  of these under 5 degrees, %", "flat", "%.1f")
  row("  of these in the last fifth of the chord, %", "back", "%.1f")
  row("deposits", "deposits", "%.0f")
  row("  median diameter, um", "median", "%.2f")
  row("  of these at a later impact, %", "again", "%.1f")
  row("  mass, ug", "mass", "%.4f")
  row("impact energy under 5 degrees, %", "grazing", "%.2f")
  row("worn off, ug", "worn", "%.4f")
  row("  depth, nose, nm", "nose", "%.3f")
  row("  depth, pressure side behind 30 %, nm", "behind", "%.3f")
  row("  depth, last 15 % of the chord, nm", "edge", "%.3f")
}
