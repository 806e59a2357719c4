# The results of the picture, in numbers: from the mean heights and the profiles, both over the second half.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { printf "%-9s %12s %10s %10s %22s %20s\n", "", "mean height", "rms v_z", "mean v_x", "in the lowest fourth", "in the highest fourth" }
FNR == 1 { if (name && FILENAME ~ /heights/) show(); if (FILENAME ~ /heights/) { name = FILENAME; sub(/.*\//, "", name); sub(/\.heights/, "", name); n = z = w = u = all = low = high = 0 } }
FILENAME ~ /heights/ && $1 > 0.5 { n++; z += $2; w += $3 * $3; u += $4 }
FILENAME ~ /profile/ { all += $5; if ($1 < 0.25) low += $5; if ($1 > 0.75) high += $5 }
function show() {
  printf "%-9s %9.1f mm %6.2f m/s %6.2f m/s %20.1f %% %18.1f %%\n", name, z / n, sqrt(w / n), u / n, 100 * low / all, 100 * high / all
}
END { show() }
