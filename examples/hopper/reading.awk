# From "time, grains out, impacts" of each case: when half of the grains and when all are out, the rate in between, and
# the impacts in all.
# SPDX-License-Identifier: GPL-3.0-or-later
FNR == 1 { n = split(FILENAME, part, "/"); name = part[n]; sub(/\.out$/, "", name); names[++cases] = name }
/^#/ { next }
{ if ($2 >= 250 && !(name in half)) half[name] = $1
  if ($2 >= 500 && !(name in all)) all[name] = $1
  if ($2 >= 50 && !(name in from)) { from[name] = $1; first[name] = $2 }
  if ($2 <= 450) { to[name] = $1; last[name] = $2 }
  impacts[name] = $3 }
END {
  printf "%-9s %14s %14s %18s %10s\n", "", "half out", "all out", "between, 1/s", "impacts"
  for (k = 1; k <= cases; k++) { c = names[k]
    printf "%-9s %12.3f s %12s s %18.0f %10d\n", c, half[c], (c in all) ? sprintf("%.3f", all[c]) : "-", (last[c] - first[c]) / (to[c] - from[c]), impacts[c] }
}
