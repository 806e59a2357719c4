# The results of the picture, in numbers: impacts, and from the mean heights and the profiles those over the second half.
# For each run its files NAME.impacts, NAME.heights and NAME.profile. After ../seeds.awk.
# SPDX-License-Identifier: GPL-3.0-or-later
FILENAME ~ /impacts/ { finish(); name = case_of(FILENAME); add(name, "impacts", $1); n = z = w = u = all = low = high = 0 }
FILENAME ~ /heights/ && $1 > 0.5 { n++; z += $2; w += $3 * $3; u += $4 }
FILENAME ~ /profile/ { all += $5; if ($1 < 0.25) low += $5; if ($1 > 0.75) high += $5 }
function finish() {
  if (!name) return
  add(name, "height", z / n); add(name, "rms", sqrt(w / n)); add(name, "along", u / n)
  add(name, "low", 100 * low / all); add(name, "high", 100 * high / all)
}
END {
  finish()
  form = "%-9s %15s %17s %14s %14s %16s %17s\n"
  printf form, "", "impacts", "mean height, mm", "rms v_z, m/s", "mean v_x, m/s", "lowest fourth, %", "highest fourth, %"
  for (k = 1; k <= cases; k++) {
    name = names[k]
    printf form, name, show(name, "impacts", "%.0f"), show(name, "height", "%.1f"), show(name, "rms", "%.3f"),
      show(name, "along", "%.2f"), show(name, "low", "%.1f"), show(name, "high", "%.1f")
  }
}
