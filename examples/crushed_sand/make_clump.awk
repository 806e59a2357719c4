# The spheres of grain.txt, scaled to the volume of a sphere of the diameter D, for fix particletemplate/multisphere: x, y,
# z and radius. Overlapping parts count once: the volume by lines along x. mawk and gawk give the same.
#   awk -v D=2e-4 -f make_clump.awk grain.txt
# SPDX-License-Identifier: GPL-3.0-or-later
/^#/ || $1 == "x" { next }
{ n++; x[n] = $1; y[n] = $2; z[n] = $3; r[n] = $4 / 2 }
# What the spheres cover of the line at (Y, Z).
function covered(Y, Z,   m, i, k, h, from, to, sum, last) {
  m = sum = 0
  for (i = 1; i <= n; i++) {
    h = r[i] ^ 2 - (Y - y[i]) ^ 2 - (Z - z[i]) ^ 2
    if (h <= 0) continue
    h = sqrt(h)
    for (k = ++m; k > 1 && from[k - 1] > x[i] - h; k--) { from[k] = from[k - 1]; to[k] = to[k - 1] }
    from[k] = x[i] - h; to[k] = x[i] + h
  }
  last = -1e9
  for (k = 1; k <= m; k++) { if (to[k] > last) sum += to[k] - (from[k] > last ? from[k] : last); if (to[k] > last) last = to[k] }
  return sum
}
END {
  step = 0.02
  for (Y = -3 + step / 2; Y < 3; Y += step) for (Z = -3 + step / 2; Z < 3; Z += step) volume += covered(Y, Z) * step * step
  scale = D / exp(log(6 / (4 * atan2(1, 1)) * volume) / 3)
  for (i = 1; i <= n; i++) printf "%.9g %.9g %.9g %.9g\n", x[i] * scale, y[i] * scale, z[i] * scale, r[i] * scale
}
