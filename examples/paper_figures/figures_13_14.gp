# The spread of figures 13 and 14 at 60 to 90 degrees: of tilt alone, and of grains that differ; beside Grant & Tabakoff's.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set datafile separator comma
set term pngcairo size 900,520 font 'sans,13'
set output 'output/figure_13_14_spread.png'
set xlabel 'impact angle / degrees'
set ylabel 'sd of CoR_N'
set xrange [58:92]
set yrange [0:0.2]
set key inside left top maxrows 4
sd(figure, name) = '< grep ^, output/spread_'.figure.'.'.name.'.csv'
plot for [j = 1:3] sd('13', word('tilt scatter lever', j)) using 3:8 with linespoints ls j dt 1 title 'figure 13, '.word('tilt scatter lever', j), \
  for [j = 1:3] sd('14', word('tilt scatter lever', j)) using 3:8 with linespoints ls j dt 2 title 'figure 14, '.word('tilt scatter lever', j), \
  '../data/grant_tabakoff_1975.csv' using 1:3 with points pt 7 lc 'black' title 'sand on aluminum, measured'
