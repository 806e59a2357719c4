# The results of the picture, in numbers: the two drums over the second half of the run, and the check of the frame. After
# ../seeds.awk.
# SPDX-License-Identifier: GPL-3.0-or-later
function finish() { if (name) { add(name, "height", z / n); add(name, "energy", e / n) } name = ""; n = e = z = 0 }
FNR == 1 { finish() }
FILENAME ~ /heights/ { name = case_of(FILENAME); if ($1 > 0.45) { n++; e += $2; z += $3 } next }
FILENAME ~ /motion/ { grains++; de += $1; e0 += $3; d = $1 - $2; dd += d * d; next }
!/^#/ && !/^tag/ {
  split($0, c, ","); rows++
  d = c[15] / c[10] - 1; if (d < 0) d = -d; if (d > most) most = d
}
END {
  for (k = 1; k <= cases; k++)
    printf "%-7s mean height %s mm, mean energy per mass %s (m/s)^2 (0.55 is the wall's)\n", names[k], show(names[k], "height", "%.1f"), show(names[k], "energy", "%.4f")
  printf "frame   %d impacts; in the wall's frame v2/v1 is 1 to %.1g; in the lab the energy per mass grows from %.3f to %.3f (m/s)^2\n", rows, most, e0 / grains, (e0 + de) / grains
  printf "        energy gained less omega times angular momentum gained: rms %.2g (m/s)^2, %.1f %% of the mean gain\n", sqrt(dd / grains), 100 * sqrt(dd / grains) / (de / grains)
}
