# From tilted.wear, and the table of `asperity sensitivity`: the wear / nm over the chord of the pressure side if R_q were
# 20 % less and 20 % more, which are taken of three rows of triangles at a time. Prints what that does on the whole blade.
#   awk -F, -f blade.awk -f band.awk -v band=tilted.band tilted.wear sensitivity.csv
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { set_up() }
FILENAME ~ /wear$/ { split($0, of, " "); at[++n] = of[1]; depth[n] = of[2]; next }
$1 == "eroded_mass_kg" && $3 != "all" { i = int($3 / 2) % LOOP; i -= i % 3; worn[i] += $5; by_rq[i] += $7 }
$2 == "all" && $3 == "all" && $1 ~ /^(stuck|eroded)/ {
  printf "%-14s by ln R_q: %+4.0f +- %.0f %%; with 10 %% more R_q %+.1f %%\n", $1, 100 * $7 / $5, 100 * $8 / $5, 100 * ($11 / $5 - 1)
}
END {
  for (i = NC; i < LOOP; i++) {
    share = by_rq[i - i % 3] / worn[i - i % 3]
    print at[i - NC + 1], depth[i - NC + 1] * (1 + log(0.8) * share), depth[i - NC + 1] * (1 + log(1.2) * share) > band
  }
}
