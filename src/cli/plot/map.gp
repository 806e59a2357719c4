# A map and a particle on it, from the table that `asperity surface` makes for its picture: the heights, the rms contact
# slope in each direction, and a section along x with the lowest points of the particle.
# gnuplot -c map.gp TABLE PICTURE [TITLE [WIDTHxHEIGHT]]
# SPDX-License-Identifier: GPL-3.0-or-later
here = ''; do for [i=1:strlen(ARG0)] { if (ARG0[i:i] eq '/') { here = ARG0[1:i] } }
array given[5] = [ARG1, ARG2, ARG3, ARG4, ARG5]
width = 1300; height = 900
load here.'picture.gp'
above = "at graph 0.5,1 center offset 0,0.7"
i = 0; xx = 0; xy = 0; yy = 0
find(x, y, p, q) = (i = i + 1, xx = xx + p * p, xy = xy + p * q, yy = yy + q * q, y_end = y, x_end = x, 1)
stats table using (find(column('x_um'), column('y_um'), column('slope_x'), column('slope_y'))) nooutput
rms(t) = sqrt((xx * cos(t) ** 2 + 2 * xy * cos(t) * sin(t) + yy * sin(t) ** 2) / i)
set bmargin at screen 0.45 + 60. / height; set rmargin at screen 0.5
set label 1 'heights' @above
set size ratio -1
set xlabel 'x / µm'; set ylabel 'y / µm'; set cblabel 'z / µm'
set palette defined (0 '#08306b', 0.5 '#f7f7f7', 1 '#7f2704')
set xrange [0:x_end]; set yrange [0:y_end]
plot table using (column('x_um')):(column('y_um')):(column('z_um')) with image pixels notitle
set lmargin at screen 0.65; set rmargin at screen right
set label 1 'rms contact slope by direction' @above
set xlabel 'toward x'; set ylabel 'toward y'
most = max(rms(0), max(rms(pi / 2), max(rms(pi / 4), rms(3 * pi / 4)))) * 1.1
set xrange [-most:most]; set yrange [-most:most]
tick = 10 ** floor(log10(most)); set xtics tick * (most < 4 * tick ? 1 : 2); set ytics tick * (most < 4 * tick ? 1 : 2)
set trange [0:2 * pi]
set parametric
plot rms(t) * cos(t), rms(t) * sin(t) with lines ls 1 notitle
unset parametric
set size noratio
set lmargin at screen left; set rmargin at screen right; set tmargin at screen 0.4; set bmargin at screen bottom
set label 1 'a section along x' @above
set xlabel 'x / µm'; set ylabel 'z / µm'; set xtics autofreq; set ytics autofreq
# The row in the middle.
y_mid = NaN; @survey
middle_row(y) = (y_mid = (!is(y_mid) && y >= y_end / 2) ? y : y_mid, 1)
stats table using (middle_row(column('y_um'))) nooutput
section(y, v) = abs(y - y_mid) < 1e-9 * y_end ? v : NaN
set xrange [0:x_end]
if (strlen(range)) { set yrange [low(range):high(range)] } else { set yrange [*:*] }
plot table using (section(column('y_um'), column('x_um'))):(column('z_um')) with lines ls reference title 'wall', \
  table using (section(column('y_um'), column('x_um'))):(column('lowest_um')) with lines ls 1 title 'lowest points of the particle'
unset multiplot
