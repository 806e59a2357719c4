# From the triangles' depth of erosion in a mesh/vtk file to the quadrilaterals of the blade's surface, for gnuplot
# (position along the chord, negative on the suction side; span / mm; depth / nm), in the file `map`; the mean depth
# over the chord of the pressure side, in the file `chord`; and a line of numbers.
#   awk -f blade.awk -f wear.awk -v name=smooth -v map=smooth.worn -v chord=smooth.wear smooth.30000.vtk
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN { set_up() }
$1 == "CELL_DATA" { cells = $2; next }
cells && NF == 4 && $2 == 1 { now = $1; at = 0; next }
cells && now { for (k = 1; k <= NF; k++) value[now, at++] = $k }
END {
  for (c = 0; c < cells; c++) depth[int(value["meshid", c] / 2)] += value["erosion_depth", c] / 2 * 1e9
  for (j = 0; j < NS; j++)
    for (i = 0; i < LOOP; i++) {
      d = depth[j * LOOP + i]; s = (position(i) + position(i + 1)) / 2
      print position(i), SPAN * j / NS * 1e3, d "\n" position(i + 1), SPAN * j / NS * 1e3, d "\n" > map
      print position(i), SPAN * (j + 1) / NS * 1e3, d "\n" position(i + 1), SPAN * (j + 1) / NS * 1e3, d "\n\n" > map
      of[i] += d / NS; nose = s < 0.05 && s > -0.05
      if (d > most) most = d
      if (nose) { n++; front += d } else if (s > 0.3) { m++; back += d }
    }
  for (i = NC; i < LOOP; i++) print (position(i) + position(i + 1)) / 2, of[i] > chord
  printf "wear, %-6s  nose %5.2f nm, pressure side behind 30 %% of the chord %6.3f nm, deepest %5.2f nm\n", name, front / n, back / m, most
}
