# A run against the measurement: at each measured height the beads of the slice within 0.025 R of it (near the wall, within
# their distance from it); the root mean square difference of U_p, u' and d, each with its standard error by leaving out one
# of ten groups of beads at a time; impacts per bead and second, and how far the mean height still moves.
#   awk -f score.awk -v name=smooth -v rate=IMPACTS ../data/huber_sommerfeld_1998.csv output/smooth.at.txt
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { GROUPS = 10; R = 0.075; SPEED = 27; SIZE = 40e-6; last = GROUPS }
FNR == NR {
  if (split($0, part, ",") != 3 || (part[1] != "u_p" && part[1] != "u_rms" && part[1] != "d")) next
  rows++; what[rows] = part[1]; at[rows] = part[2]; measured[rows] = part[3]
  half[rows] = 1 - (at[rows] < 0 ? -at[rows] : at[rows]); if (half[rows] > 0.025) half[rows] = 0.025
  next
}
/ITEM: TIMESTEP/ { getline; frames++; next }
/^ITEM/ { atoms = /ITEM: ATOMS/; next }
atoms {
  h = $3 / R; g = $1 % GROUPS; u = $4 / SPEED
  beads[frames]++; height[frames] += h
  for (k = 1; k <= rows; k++) if (h > at[k] - half[k] && h < at[k] + half[k]) {
    n[k, g]++; s[k, g] += what[k] == "d" ? 2 * $7 / SIZE : u; ss[k, g] += u * u
    n[k, last]++; s[k, last] += what[k] == "d" ? 2 * $7 / SIZE : u; ss[k, last] += u * u
  }
}
function value(k, out,   m, a, b) { # of row k without group `out`; out = last: of all
  m = n[k, last]; a = s[k, last]; b = ss[k, last]
  if (out < last) { m -= n[k, out]; a -= s[k, out]; b -= ss[k, out] }
  if (!m) return measured[k]
  return what[k] == "u_rms" ? sqrt(b / m - (a / m) ^ 2 + 1e-12) : a / m
}
function rms(which, out,   k, m, sum) {
  for (k = 1; k <= rows; k++) if (what[k] == which) { m++; sum += (value(k, out) - measured[k]) ^ 2 }
  return sqrt(sum / m)
}
function error(which,   g, mean, sum) {
  for (g = 0; g < GROUPS; g++) mean += rms(which, g) / GROUPS
  for (g = 0; g < GROUPS; g++) sum += (rms(which, g) - mean) ^ 2
  return sqrt(sum * (GROUPS - 1) / GROUPS)
}
END {
  for (f = 1; f <= frames; f++) if (2 * f <= frames) { a += height[f]; b += beads[f] } else { c += height[f]; d += beads[f] }
  printf "%s", name
  split("u_p u_rms d", q, " ")
  for (i = 1; i <= 3; i++) printf ",%.4f,%.4f", rms(q[i], last), error(q[i])
  printf ",%.1f,%.3f\n", rate, c / d - a / b
}
