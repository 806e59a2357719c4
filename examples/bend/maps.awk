# From the fields on the outer wall (text of a sampled surface: x y z value) to 2 x 2 of its faces in space, for bend.gp:
# x y z / mm of the corners as the picture has them (x and y turned around), wear / um per kg of dust. The file PROFILE
# gets means over the width: way along the wall / mm (in the bend from 0 to 196 mm), wear, deposits / kg per m^2 and kg.
#   awk -v dust=MASS -v profile=FILE -f maps.awk erodedDepth depositedMass > FACES
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { PI = atan2(0, -1); BEND = 125 * PI / 2 }
/^#/ { next }
FNR == NR { i = int(n / 40); wear[i, int(n % 20 / 2)] += $4 / 4 * 1e6 / dust; n++; next } # 20 faces across
{ mass[int(m / 40)] += $4 / dust; m++ }
function start(i) { return i < 20 ? 12.5 * i - 250 : i < 45 ? BEND / 25 * (i - 20) : BEND + 10 * (i - 45) }
function corner(i, j,  s, angle) {
  s = start(i); angle = s < 0 ? 0 : (s < BEND ? s : BEND) / 125
  print -125 * sin(angle) - (s < 0 ? s : 0), 125 * cos(angle) - 100 - (s > BEND ? s - BEND : 0), 5 * j - 25, of_face
}
END {
  for (i = 0; i < n / 40; i++) {
    for (j = mean = 0; j < 10; j++) {
      mean += wear[i, j] / 10; of_face = wear[i, j]
      if (i < 17 || i > 48) continue # the bend and what is near it
      corner(i, j + 1); corner(i, j); print ""
      corner(i + 1, j + 1); corner(i + 1, j); print "\n"
    }
    print (start(i) + start(i + 1)) / 2, mean, mass[i] / ((start(i + 1) - start(i)) * 0.05e-3) > profile
  }
}
