# A wall in space, from the table that `asperity map` makes for its picture, in blocks: width, height, label, end of the
# color bar (0: the largest value); pixels (place, value, gray and opacity of what shades it); dots (place, diameter in um);
# how many dots are seen, and how many there are; the directions of x, y, z, and a length.
# gnuplot -c faces.gp TABLE PICTURE [TITLE [WIDTHxHEIGHT]]
# SPDX-License-Identifier: GPL-3.0-or-later
here = ''; do for [i=1:strlen(ARG0)] { if (ARG0[i:i] eq '/') { here = ARG0[1:i] } }
array given[5] = [ARG1, ARG2, ARG3, ARG4, ARG5]
width = 1100; height = 800
load here.'picture.gp'
stats table index 0 using (w = $1, h = $2, label_of = strcol(3), most = $4, 1) nooutput
stats table index 3 using (seen = $1, all = $2, 1) nooutput
largest = 0
if (seen > 0) { stats table index 2 using (largest = is($3) ? max(largest, $3) : largest, 1) nooutput }
array right[4]; array up[4]; array name[4]; k = 0
stats table index 4 using (k = k + 1, right[k] = $1, up[k] = $2, name[k] = strcol(3), 1) nooutput
unset border; unset tics; unset grid; unset key
set lmargin at screen 0.02; set rmargin at screen 1 - 130. / width
set bmargin at screen 70. / height; set tmargin at screen 1 - (20. * lines + 20) / height
set size ratio -1
set xrange [0:w]; set yrange [0:h]
set palette defined (0 '#f4f4f4', 0.25 '#c6dbef', 0.5 '#6baed6', 1 '#08519c')
stats table index 1 using 3 nooutput
most = most > 0 ? most : STATS_max > 0 ? STATS_max : 1
set cbrange [0:most]; set cblabel label_of
set colorbox user origin screen 1 - 110. / width, screen 0.3 size screen 18. / width, screen 0.4
set cbtics
# Dots get smaller where there are many.
dot(d) = (0.25 + 0.75 * d / largest) * (seen > 300 ? max(0.35, sqrt(300. / seen)) : 1)
if (all > 0) { set label 1 sprintf('orange: deposits, larger dots for larger grains; %.0f of %.0f in sight', seen, all) at screen 0.5, screen 22. / height center }
# x, y and z, then the length.
px = 1. / width; py = 1. / height; cx = 1 - 70 * px; cy = 130 * py
do for [k=1:3] {
  set arrow k from screen cx, cy to screen cx + 34 * px * right[k], cy + 34 * py * up[k] size screen 0.006, 20 lc rgb '#444444' front
  if (right[k] ** 2 + up[k] ** 2 > 0.1) { set label 1 + k name[k] at screen cx + 46 * px * right[k], cy + 46 * py * up[k] center front }
}
set arrow 4 from first w - right[4], screen 44 * py to first w, screen 44 * py heads size screen 0.004, 90 lw 2 lc rgb '#444444' front
set label 5 name[4] at first w - right[4] / 2, screen 54 * py center front
dots = seen > 0 ? ", '' index 2 using 1:2:(dot($3)) with points pt 7 ps variable lc rgb '#d55e00'" : ''
eval "plot table index 1 using 1:2:3 with image, '' index 1 using 1:2:4:4:4:5 with rgbalpha".dots
unset multiplot
