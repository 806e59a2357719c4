# The triangles of an STL file (text) with the impacts of a ledger on each, for map.gp: x y z / mm of the corners, and
# impacts per mm^2. A ledger counts triangles from 0, in the order of the file.
#   awk -f map.awk impacts.csv blade.stl > map.txt
# SPDX-License-Identifier: GPL-3.0-or-later
FNR == NR { split($0, row, ","); if (row[1] ~ /^[0-9]/) impacts[row[5]]++; next }
$1 == "vertex" {
  for (k = 1; k <= 3; k++) p[corner, k] = 1e3 * $(k + 1)
  if (++corner < 3) next
  corner = 0
  for (k = 1; k <= 3; k++) { u[k] = p[1, k] - p[0, k]; v[k] = p[2, k] - p[0, k] }
  area = sqrt((u[2] * v[3] - u[3] * v[2]) ^ 2 + (u[3] * v[1] - u[1] * v[3]) ^ 2 + (u[1] * v[2] - u[2] * v[1]) ^ 2) / 2
  for (i = 0; i < 4; i++) {
    c = i < 3 ? i : 2
    print p[c, 1], p[c, 2], p[c, 3], impacts[triangle] / area
    if (i % 2) print ""
  }
  print ""
  triangle++
}
