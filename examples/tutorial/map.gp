# Impacts per mm^2 on the triangles of map.awk, and what stuck to them by the ledger.
#   gnuplot map.gp
# SPDX-License-Identifier: GPL-3.0-or-later
set term pngcairo size 1000,600 font 'sans,16'
set output 'map.png'
unset border; unset xtics; unset ytics; unset ztics; unset key
set view 125, 20
set view equal xyz
set pm3d depthorder corners2color c1 lighting primary 0.45 specular 0.15
set palette defined (0 '#f4f4f4', 0.25 '#c6dbef', 0.5 '#6baed6', 1 '#08519c')
set cbtics 20
set cblabel 'impacts per mm^2'
set colorbox user origin screen 0.83,0.2 size screen 0.035,0.6
set datafile separator comma
stats 'impacts.csv' using ($19 > 0) nooutput
set datafile separator
set label sprintf('orange: deposits, %.0f of %.0f impacts', STATS_sum, STATS_records) at screen 0.43, 0.06 center textcolor '#d55e00'
set multiplot
set lmargin at screen 0.02; set rmargin at screen 0.84; set bmargin at screen 0.08; set tmargin at screen 0.98
set xrange [-6.5:6.5]; set yrange [-0.5:16.5]; set zrange [-2.5:2.5]
splot 'map.txt' using 1:2:3:4 with pm3d
unset colorbox; unset label
# plots of their own: what pm3d sorts by depth covers points, and at a thin edge the side that was hit
splot 'map.txt' using 1:2:3:($4 > 0 ? $4 : NaN) with pm3d
set datafile separator comma
splot 'impacts.csv' using (1e3*$6):(1e3*$7):(1e3*$8):($19 > 0 ? 0.9 : 0) with points pt 7 ps variable lc rgb '#d55e00'
unset multiplot
