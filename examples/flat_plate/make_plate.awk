# Writes the plate as an STL mesh: a square of SIDE meters in the plane z = 0, normal +z, cut into
# 2 CELLS^2 triangles.   awk -f make_plate.awk > plate.stl
# SPDX-License-Identifier: GPL-3.0-or-later
function vertex(i, j) { printf "vertex %.9g %.9g 0\n", i * SIDE / CELLS, j * SIDE / CELLS }
function facet(i1, j1, i2, j2, i3, j3) {
  print "facet normal 0 0 1\nouter loop"
  vertex(i1, j1); vertex(i2, j2); vertex(i3, j3)
  print "endloop\nendfacet"
}
BEGIN {
  SIDE = 0.06; CELLS = 20
  print "solid plate"
  for (i = 0; i < CELLS; i++)
    for (j = 0; j < CELLS; j++) {
      facet(i, j, i + 1, j, i + 1, j + 1)
      facet(i, j, i + 1, j + 1, i, j + 1)
    }
  print "endsolid plate"
}
