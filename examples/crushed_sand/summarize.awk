# From a ledger with `columns full`: each grain's first impact to its last one, as one rebound. Prints for each impact angle:
# angle, n, mean and sd of CoR_N, mean and sd of CoR_T (0 at 90 degrees, where it is not defined), impacts per grain, the share
# of the energy of flight that is left; with DOTS, "angle CoR_N CoR_T" of each grain, the angles
# spread by 4 degrees.
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { FS = "," }
/^#/ || $1 == "tag" { next }
{
  id = $40 > 0 ? "body " $40 : $1
  if (!(id in v)) { name[++grains] = id; v[id] = $26; t[id] = $24; angle[id] = 10 * int($11 / 10 + 0.5) }
  w[id] = $29; x[id] = $27; y[id] = $28; hits[id]++
}
function sd(k, s, q) { return sqrt(q[k] / n[k] - (s[k] / n[k]) ^ 2) }
END {
  for (i = 1; i <= grains; i++) {
    id = name[i]; k = angle[id]; c = -w[id] / v[id]; d = k < 90 ? x[id] / t[id] : 0
    if (DOTS != "") { printf "%.3f %.5f %s\n", k + 4 * ((i * 0.618034) % 1 - 0.5), c, k < 90 ? d : "NaN" > DOTS; }
    n[k]++; s[k] += c; q[k] += c * c; st[k] += d; qt[k] += d * d; h[k] += hits[id]
    e[k] += (x[id] ^ 2 + y[id] ^ 2 + w[id] ^ 2) / 400
  }
  for (k = 10; k <= 90; k += 10)
    printf "%d %d %.5f %.5f %.5f %.5f %.4f %.5f\n", k, n[k], s[k] / n[k], sd(k, s, q), st[k] / n[k], sd(k, st, qt), h[k] / n[k], e[k] / n[k]
}
