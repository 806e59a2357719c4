# Profiles over the height from the slice that in.pipe_flow writes: in bins of the height z/R the mean speed along the pipe and
# its root mean square about that mean, over 27 m/s, and the mean diameter over 40 um, each with its standard error. The beads
# are independent of each other, so the errors come from ten groups of beads, by number.
#   columns: z/R, beads, U_p, error, u', error, d, error, concentration over the mean
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { BINS = 40; R = 0.075; SPEED = 27; SIZE = 40e-6; GROUPS = 10 }
/^ITEM/ { atoms = /ITEM: ATOMS/; next }
atoms {
  k = int(($3 / R + 1) / 2 * BINS); g = $1 % GROUPS
  if (k < 0) k = 0; if (k >= BINS) k = BINS - 1
  total++
  for (i = 0; i < 2; i++) { j = k SUBSEP (i ? g : "all"); n[j]++; h[j] += $3 / R; u[j] += $4 / SPEED; uu[j] += $4 * $4 / SPEED / SPEED; d[j] += 2 * $7 / SIZE }
}
function take(j) { m = n[j] ? n[j] : 1; v[1] = u[j] / m; v[2] = sqrt(uu[j] / m - v[1] * v[1] + 1e-12); v[3] = d[j] / m }
END {
  for (k = 0; k < BINS; k++) {
    all = k SUBSEP "all"
    if (n[all] < 100) continue
    split("", s); split("", ss)
    for (g = 0; g < GROUPS; g++) { take(k SUBSEP g); for (q = 1; q <= 3; q++) { s[q] += v[q]; ss[q] += v[q] * v[q] } }
    take(all)
    printf "%.4f %d", h[all] / n[all], n[all]
    for (q = 1; q <= 3; q++) printf " %.5g %.2g", v[q], sqrt((ss[q] - s[q] * s[q] / GROUPS) / GROUPS / (GROUPS - 1))
    printf " %.4g\n", n[all] * BINS / total
  }
}
