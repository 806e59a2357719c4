# From a run's log and the triangles' depth of erosion in its mesh/vtk file: the mean depth / nm over the chord of the
# pressure side, in the file `chord`, and one line: the mass worn off / ug, and mean depths / nm of the nose, of the
# pressure side behind 30 % of the chord, and of its last 15 %.
#   awk -f blade.awk -f wear.awk -v chord=smooth.wear smooth.log smooth.30000.vtk
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { set_up() }
FILENAME ~ /log$/ { if ($1 == 30000) worn = $7 * 1e9; next }
$1 == "CELL_DATA" { cells = $2; next }
cells && NF == 4 && $2 == 1 { now = $1; at = 0; next }
cells && now { for (k = 1; k <= NF; k++) value[now, at++] = $k }
END {
  for (c = 0; c < cells; c++) depth[int(value["meshid", c] / 2)] += value["erosion_depth", c] / 2 * 1e9
  for (j = 0; j < NS; j++)
    for (i = 0; i < LOOP; i++) {
      d = depth[j * LOOP + i]; s = (position(i) + position(i + 1)) / 2
      of[i] += d / NS
      if (s < 0.05 && s > -0.05) { n++; front += d }
      if (s > 0.3) { m++; back += d }
      if (s > 0.85) { l++; edge += d }
    }
  for (i = NC; i < LOOP; i++) print (position(i) + position(i + 1)) / 2, of[i] > chord
  print worn, front / n, back / m, edge / l
}
