# From the triangles' values in a mesh/vtk file to the quadrilaterals of the blade's surface, each a small grid
# of four corners for gnuplot. Columns: position along the chord (negative: suction side), span / mm, x y z / mm
# of the corner; impacts per mm^2, deposited mass in ng per mm^2, impact energy in uJ per mm^2 of the
# quadrilateral.
#   awk -f blade.awk -f map.awk smooth.30000.vtk > smooth.map
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
function corner(i, p) { print position(i), P[p, 2], P[p, 1], P[p, 2], P[p, 3], values }
END {
  for (c = 0; c < cells; c++) {
    q = int(value["meshid", c] / 2)
    impacts[q] += value["impacts", c]; mass[q] += value["deposited_mass", c]; energy[q] += value["impact_energy", c]
  }
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
      mm2 = area(p, p + 1, p + LOOP + 2) + area(p, p + LOOP + 2, p + LOOP + 1)
      values = impacts[q] / mm2 " " mass[q] * 1e12 / mm2 " " energy[q] * 1e6 / mm2
      corner(i, p); corner(i + 1, p + 1); print ""
      corner(i, p + LOOP + 1); corner(i + 1, p + LOOP + 2); print "\n"
    }
}
