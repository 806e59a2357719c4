# The hopper: where the grains are 0.12 s after it was opened, in a view along y, and how many are out over time.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1200,560 font 'sans,16'
set output 'output/hopper.png'
set palette defined (0 '#c6dbef', 0.4 '#4292c6', 0.7 '#f16913', 1 '#7f2704')
set cbrange [0:0.8]
set cblabel 'speed / (m/s)'
unset key; unset grid
set bmargin 4
set multiplot layout 1,2
set size ratio -1
set xtics 10
set xrange [-22:22]; set yrange [-30:32]
set xlabel 'x / mm'; set ylabel 'z / mm'
set arrow from 6.5,0 to 20,20 nohead lc rgb '#444444' lw 2
set arrow from -6.5,0 to -20,20 nohead lc rgb '#444444' lw 2
set arrow from 20,20 to 20,32 nohead lc rgb '#444444' lw 2
set arrow from -20,20 to -20,32 nohead lc rgb '#444444' lw 2
set style fill solid 0.9 border rgb '#ffffff'
set title 'rough wall, 0.12 s'
plot 'output/rough.at' using 1:($2 > -29 ? $2 : NaN):(1.0):3 with circles lc palette
unset arrow
set size noratio
set grid
set key inside right bottom vertical Left reverse font ',16'
set xtics 0.1
set xrange [0:0.27]; set yrange [0:520]
set xlabel 'time / s'; unset ylabel
set title 'grains out'
plot 'output/smooth.out' using 1:2 with lines ls wall_smooth dt 2 title 'smooth, no friction', \
     'output/friction.out' using 1:2 with lines ls wall_smooth title 'smooth, friction 0.3', \
     'output/rough.out' using 1:2 with lines ls wall_rough title 'rough, friction 0.3'
unset multiplot
