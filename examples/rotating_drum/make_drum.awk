# Writes the drum as an STL mesh: a cylinder about the y axis, 50 mm in radius and 44 mm long, in 64 flat strips.
#   awk -f make_drum.awk > drum.stl
# SPDX-License-Identifier: GPL-3.0-or-later
function vertex(i, j) {
  printf "vertex %.9g %.9g %.9g\n", RADIUS * cos(2 * PI * i / AROUND), LENGTH * (j / ALONG - 0.5), RADIUS * sin(2 * PI * i / AROUND)
}
function facet(i1, j1, i2, j2, i3, j3) {
  print "facet normal 0 0 0\nouter loop"
  vertex(i1, j1); vertex(i2, j2); vertex(i3, j3)
  print "endloop\nendfacet"
}
BEGIN {
  PI = atan2(0, -1); RADIUS = 50e-3; LENGTH = 44e-3; AROUND = 64; ALONG = 8
  print "solid drum"
  for (i = 0; i < AROUND; i++)
    for (j = 0; j < ALONG; j++) {
      facet(i, j, i + 1, j, i + 1, j + 1)
      facet(i, j, i + 1, j + 1, i, j + 1)
    }
  print "endsolid drum"
}
