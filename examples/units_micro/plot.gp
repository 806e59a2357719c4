# The coefficients of restitution of both runs over the impact angle: circles si, dots micro.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1000,430 font 'sans,11'
set output 'output/units_micro.png'
set xrange [0:90]
set xtics 15
set xlabel 'impact angle {/Symbol a}_1 / degrees'
# The impacts that lie above or below the axes.
stats 'output/pairs' using ($2 > 2.5) nooutput
beyond_n = STATS_sum
stats 'output/pairs' using ($4 < -1 || $4 > 2) nooutput
beyond_t = STATS_sum
outside(beyond) = sprintf('{/=9 %d of %d impacts lie outside}', beyond, STATS_records)
set multiplot layout 1,2 title 'One case in two systems of units: the same impacts'."\n"
set title outside(beyond_n)
set ylabel 'CoR_N'
set yrange [0:2.5]
plot 'output/pairs' using 1:2 with points ls 1 pt 6 ps 0.7 title 'units si', \
     '' using 1:3 with points ls 2 pt 7 ps 0.35 title 'units micro'
set title outside(beyond_t)
set ylabel 'CoR_T'
set yrange [-1:2]
plot 'output/pairs' using 1:4 with points ls 1 pt 6 ps 0.7 title 'units si', \
     '' using 1:5 with points ls 2 pt 7 ps 0.35 title 'units micro'
unset multiplot
