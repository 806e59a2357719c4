# From the fields on the outer wall (text of a sampled surface: x y z value) to maps: means over 2 x 2 faces. Columns: place
# along the wall and across it / mm, half of the lengths / mm, wear / um per kg of dust, deposits / kg per m^2 and kg of dust.
# Along the wall the bend reaches from 0 to 196 mm. The second file, PROFILE, gets the means over the width.
#   awk -v dust=MASS -v profile=FILE -f maps.awk erodedDepth depositedMass > MAP
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { PI = atan2(0, -1) }
/^#/ { next }
FNR == NR { # 20 faces across, 40 + 50 + 40 along
  i = int(n / 40); j = int(n % 20 / 2); n++
  angle = $1 < 0 ? 0 : $2 > 0.1 ? PI / 2 : atan2($1, 0.1 - $2)
  s[i] += ($1 < 0 ? $1 : 0.125 * angle + ($2 > 0.1 ? $2 - 0.1 : 0)) / 40; z[j] += $3; count[j]++
  wear[i, j] += $4 / 4
  next
}
{ i = int(m / 40); j = int(m % 20 / 2); m++; mass[i, j] += $4 }
END {
  for (i = 0; i < n / 40; i++) {
    half = i < 20 ? 6.25e-3 : i < 45 ? 0.125 * PI / 100 : 5e-3
    mean = stuck = 0
    for (j = 0; j < 10; j++) {
      per_area = mass[i, j] / (2 * half * 0.05 / 10)
      print s[i] * 1e3, z[j] / count[j] * 1e3, half * 1e3, 2.5, wear[i, j] * 1e6 / dust, per_area / dust
      mean += wear[i, j] / 10; stuck += per_area / 10
    }
    print s[i] * 1e3, mean * 1e6 / dust, stuck / dust > profile
  }
}
