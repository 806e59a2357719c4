# The results of the picture, in numbers: the two drums over the second half of the run, and the check of the frame.
# SPDX-License-Identifier: GPL-3.0-or-later
FNR == 1 && FILENAME ~ /heights/ { if (name) show(); name = FILENAME; sub(/.*\//, "", name); sub(/\.heights/, "", name); n = e = z = 0 }
FILENAME ~ /heights/ { if ($1 > 0.45) { n++; e += $2; z += $3 } next }
FNR == 1 && name { show(); name = "" }
FILENAME ~ /motion/ { grains++; de += $1; e0 += $3; d = $1 - $2; dd += d * d; next }
FILENAME ~ /csv/ && !/^#/ && !/^tag/ {
  split($0, c, ","); rows++
  d = c[15] / c[10] - 1; if (d < 0) d = -d; if (d > most) most = d
}
function show() { printf "%-7s mean height %.1f mm, mean energy per mass %.3g (m/s)^2 (0.55 is the wall's)\n", name, z / n, e / n }
END {
  printf "frame   %d impacts; in the wall's frame v2/v1 is 1 to %.1g; in the lab the energy per mass grows from %.3f to %.3f (m/s)^2\n", rows, most, e0 / grains, (e0 + de) / grains
  printf "        energy gained less omega times angular momentum gained: rms %.2g (m/s)^2, %.1f %% of the mean gain\n", sqrt(dd / grains), 100 * sqrt(dd / grains) / (de / grains)
}
