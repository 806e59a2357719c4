# Writes one plate as an STL mesh: 20 mm along the jet, 10 mm wide, normal +z, of eight triangles.
#   awk -v side=-1 -f make_plates.awk > ground.stl     (side=1: the other one)
# SPDX-License-Identifier: GPL-3.0-or-later
function facet(x1, y1, x2, y2, x3, y3) {
  printf "facet normal 0 0 1\nouter loop\nvertex %g %g 0\nvertex %g %g 0\nvertex %g %g 0\nendloop\nendfacet\n", x1, y1, x2, y2, x3, y3
}
BEGIN {
  W = 0.01; y = side < 0 ? -W : 0
  print "solid plate"
  for (i = 0; i < 4; i++) {
    x = -0.01 + i * 0.005
    facet(x, y, x + 0.005, y, x + 0.005, y + W)
    facet(x, y, x + 0.005, y + W, x, y + W)
  }
  print "endsolid plate"
}
