# The table of `asperity erosion`: the mass worn off each triangle.
# gnuplot -c erosion.gp TABLE PICTURE [TITLE [WIDTHxHEIGHT [FROM:TO]]]
# SPDX-License-Identifier: GPL-3.0-or-later
here = ''; do for [i=1:strlen(ARG0)] { if (ARG0[i:i] eq '/') { here = ARG0[1:i] } }
array given[5] = [ARG1, ARG2, ARG3, ARG4, ARG5]
width = 800; height = 560
load here.'picture.gp'
meshes = ''
of_triangle(v) = strcol('triangle') eq 'all' ? NaN : (meshes = add(meshes, strcol('mesh')), v)
stats table using (of_triangle(column('eroded_mass_kg'))) nooutput
if (strlen(range)) { set yrange [low(range):high(range)] } else { set yrange [0:*] }
set xlabel 'triangle'; set ylabel 'eroded mass / kg'
set label 1 sprintf('%.4g kg worn off %d triangles', STATS_sum, STATS_records) at graph 1,1 right offset 0,0.7 font ',9'
of(m, v) = (strcol('mesh') eq m && strcol('triangle') ne 'all') ? v : NaN
plot for [i=1:words(meshes)] table using (of(word(meshes, i), column('triangle'))):(column('eroded_mass_kg')) \
  with points ls ((i - 1) % 6 + 1) ps 0.7 title 'mesh '.word(meshes, i)
unset multiplot
