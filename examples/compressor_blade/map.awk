# From the triangles' values in a mesh/vtk file to the faces of the blade, two triangles each, for blade.gp: x y z / mm of
# the corners as the picture has them (y and z turned around), and impacts per mm^2.
#   awk -f blade.awk -f map.awk smooth.30000.vtk > smooth.faces
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { set_up() }
$1 == "CELL_DATA" { cells = $2; next }
cells && NF == 4 && $2 == 1 { name = $1; at = 0; next }
cells && name { for (k = 1; k <= NF; k++) value[name, at++] = $k }
function area(a, b, c,  u, v, k, n) { # of the triangle with these three points, in mm^2
  for (k = 1; k <= 3; k++) { u[k] = P[b, k] - P[a, k]; v[k] = P[c, k] - P[a, k] }
  n = (u[2] * v[3] - u[3] * v[2]) ^ 2 + (u[3] * v[1] - u[1] * v[3]) ^ 2 + (u[1] * v[2] - u[2] * v[1]) ^ 2
  return sqrt(n) / 2
}
function corner(p) { print P[p, 1], -P[p, 2], -P[p, 3], of_face }
END {
  for (c = 0; c < cells; c++) impacts[int(value["meshid", c] / 2)] += value["impacts", c]
  for (j = 0; j <= NS; j++) {
    section(j)
    for (i = 0; i <= LOOP; i++) {
      p = j * (LOOP + 1) + i
      P[p, 1] = PX[i] * 1e3; P[p, 2] = SPAN * j / NS * 1e3; P[p, 3] = PZ[i] * 1e3
    }
  }
  for (j = 0; j < NS; j++)
    for (i = 0; i < LOOP; i++) {
      p = j * (LOOP + 1) + i; q = j * LOOP + i
      of_face = impacts[q] / (area(p, p + 1, p + LOOP + 2) + area(p, p + LOOP + 2, p + LOOP + 1))
      corner(p); corner(p + 1); print ""
      corner(p + LOOP + 1); corner(p + LOOP + 2); print "\n"
    }
}
