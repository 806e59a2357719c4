# The turning drum: where the grains are, and their energy over time.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1400,480 font 'sans,16'
set output 'output/rotating_drum.png'
set palette defined (0 '#c6dbef', 0.4 '#4292c6', 0.7 '#f16913', 1 '#7f2704')
set cbrange [0:1.5]
unset key; unset grid
set multiplot layout 1,3 margins 0.07,0.972,0.17,0.85 spacing 0.12
set size ratio -1
set xrange [-56:56]; set yrange [-56:56]
set xtics 40; set ytics 40
set xlabel 'x / mm'; set ylabel 'z / mm'
set object 1 circle at 0,0 size 50 lw 1.5 fs empty border rgb '#444444'
set object 2 circle at 0,0 size 42 arc [60:120] nowedge lw 1.5 fs empty border rgb '#888888'
set arrow 1 from 19.5,37.2 to 21.3,36.2 head size 3,25 filled lc rgb '#888888' lw 1.5
unset colorbox
set title 'smooth wall, 0.9 s'
plot 'output/smooth.last' using 1:2:3 with points pt 7 ps 0.5 lc palette
set title 'rough wall; color: speed / (m/s)'
set colorbox user origin screen 0.637, screen 0.17 size screen 0.007, screen 0.68
set cbtics 0.5
plot 'output/rough.last' using 1:2:3 with points pt 7 ps 0.5 lc palette
unset object; unset arrow; unset colorbox
set size noratio
set grid
set key inside right top vertical Left reverse font ',16'
set xrange [0:0.9]; set yrange [0:*]
set xtics 0.3; set ytics auto
set xlabel 'time / s'
set title 'energy per mass / (m^2/s^2)'; unset ylabel
plot 'output/smooth.heights' using 1:2 with lines ls wall_smooth title 'smooth', \
     'output/rough.heights' using 1:2 with lines ls wall_rough title 'rough'
unset multiplot
