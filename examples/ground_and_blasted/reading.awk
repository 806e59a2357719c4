# The results of the picture, in numbers: mean and sd of the rebound angle and of the lateral angle, and the width of the footprint.
# SPDX-License-Identifier: GPL-3.0-or-later
FNR == 1 { if (name) show(); name = FILENAME; sub(/.*\//, "", name); sub(/\.foot/, "", name); n = a = aa = l = ll = y = yy = 0 }
{ n++; a += $3; aa += $3 * $3; l += $4; ll += $4 * $4; if ($1 > 0 && $1 < 60) { m++; y += $2; yy += $2 * $2 } }
function show() {
  printf "%-8s %5d grains: alpha2 %.1f deg (sd %.1f), lateral angle %+.2f deg (sd %.1f); on the screen up to 60 mm ahead %+.1f mm to the side (sd %.1f)\n",
    name, n, a / n, sqrt(aa / n - (a / n) ^ 2), l / n, sqrt(ll / n - (l / n) ^ 2), y / m, sqrt(yy / m - (y / m) ^ 2)
  m = 0
}
END { show() }
