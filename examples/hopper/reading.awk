# From "time, grains out, impacts" of each run: when half of the grains and when all are out, the rate between the 50th
# and the 450th, and all impacts. After ../seeds.awk.
# SPDX-License-Identifier: GPL-3.0-or-later
function finish() {
  if (!name)
    return
  add(name, "half", half); add(name, "all", all); add(name, "rate", (last - first) / (to - from)); add(name, "impacts", impacts)
}
FNR == 1 { finish(); name = case_of(FILENAME); half = all = from = to = 0 }
/^#/ { next }
{ if ($2 >= 250 && !half) half = $1
  if ($2 >= 500 && !all) all = $1
  if ($2 >= 50 && !from) { from = $1; first = $2 }
  if ($2 <= 450) { to = $1; last = $2 }
  impacts = $3 }
END {
  finish()
  form = "%-9s %18s %18s %16s %15s\n"
  printf form, "", "half out, s", "all out, s", "between, 1/s", "impacts"
  for (k = 1; k <= cases; k++)
    printf form, names[k], show(names[k], "half", "%.3f"), show(names[k], "all", "%.3f"), show(names[k], "rate", "%.0f"), show(names[k], "impacts", "%.0f")
}
