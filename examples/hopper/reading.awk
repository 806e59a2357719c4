# From "time, grains out, impacts" of each case: when half of the grains and when all are out, the rate between the 50th
# and the 450th, and all impacts. Files NAME.out, NAME.2.out, ... are fillings of one case: their means and standard errors.
# SPDX-License-Identifier: GPL-3.0-or-later
function finish(   value, k) {
  if (!name)
    return
  value[1] = half; value[2] = all; value[3] = (last - first) / (to - from); value[4] = impacts
  if (!(name in fillings))
    names[++cases] = name
  fillings[name]++
  for (k = 1; k <= 4; k++) { sum[name, k] += value[k]; squares[name, k] += value[k] ^ 2 }
}
function mean(name, k, form,   n, m, s) {
  n = fillings[name]; m = sum[name, k] / n; s = squares[name, k] / n - m * m
  return n < 2 ? sprintf(form, m) : sprintf(form " +- " form, m, sqrt((s > 0 ? s : 0) / (n - 1)))
}
FNR == 1 {
  finish()
  n = split(FILENAME, part, "/"); name = part[n]; sub(/(\.[0-9]+)?\.out$/, "", name)
  half = all = from = to = 0
}
/^#/ { next }
{ if ($2 >= 250 && !half) half = $1
  if ($2 >= 500 && !all) all = $1
  if ($2 >= 50 && !from) { from = $1; first = $2 }
  if ($2 <= 450) { to = $1; last = $2 }
  impacts = $3 }
END {
  finish()
  printf "%-9s %18s %18s %16s %15s\n", "", "half out, s", "all out, s", "between, 1/s", "impacts"
  for (k = 1; k <= cases; k++)
    printf "%-9s %18s %18s %16s %15s\n", names[k], mean(names[k], 1, "%.3f"), mean(names[k], 2, "%.3f"), mean(names[k], 3, "%.0f"), mean(names[k], 4, "%.0f")
}
