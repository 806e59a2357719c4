# Writes the blade as an STL mesh, facets in the order of the section's loop, row by row of the span:
# quadrilateral q = j * LOOP + i is the facets 2q and 2q + 1. Hub and tip are open.
#   awk -f blade.awk -f make_blade.awk > blade.stl
# SPDX-License-Identifier: GPL-3.0-or-later
function vertex(i, j) { printf "vertex %.9g %.9g %.9g\n", X[i, j], SPAN * j / NS, Z[i, j] }
function facet(i1, j1, i2, j2, i3, j3) {
  print "facet normal 0 0 0\nouter loop"
  vertex(i1, j1); vertex(i2, j2); vertex(i3, j3)
  print "endloop\nendfacet"
}
BEGIN {
  set_up()
  for (j = 0; j <= NS; j++) {
    section(j)
    for (i = 0; i <= LOOP; i++) { X[i, j] = PX[i % LOOP]; Z[i, j] = PZ[i % LOOP] }
  }
  print "solid blade"
  for (j = 0; j < NS; j++)
    for (i = 0; i < LOOP; i++) {
      facet(i, j, i + 1, j, i + 1, j + 1)
      facet(i, j, i + 1, j + 1, i, j + 1)
    }
  print "endsolid blade"
}
