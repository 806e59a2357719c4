# The turning drum: where the grains are, their energy over time, and the check of the wall's frame.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1100,920 font 'sans,11'
set output 'output/rotating_drum.png'
set palette defined (0 '#c6dbef', 0.4 '#4292c6', 0.7 '#f16913', 1 '#7f2704')
set cbrange [0:1.5]
unset key; unset grid
set multiplot layout 2,2 title '600 grains in a drum of 100 mm at 200 rpm: three LIGGGHTS runs'
set size ratio -1
set xrange [-56:56]; set yrange [-56:56]
set xlabel 'x / mm'; set ylabel 'z / mm'
set object 1 circle at 0,0 size 50 fs empty border rgb '#444444' lw 1.5
set object 2 circle at 0,0 size 42 arc [60:120] nowedge fs empty border rgb '#888888' lw 1.5
set arrow 1 from 19.5,37.2 to 21.3,36.2 head size 3,25 filled lc rgb '#888888' lw 1.5
set title 'smooth wall, 0.9 s'
unset colorbox
plot 'output/smooth.last' using 1:2:3 with points pt 7 ps 0.45 lc palette
set title 'rough wall, {/Symbol F}_R = 0.1, 0.9 s'
set colorbox
set cblabel 'speed / m s^{-1}'
plot 'output/rough.last' using 1:2:3 with points pt 7 ps 0.45 lc palette
unset object 1; unset object 2; unset arrow 1; unset colorbox
set size noratio
load '../look.gp'
set xrange [0:0.9]; set yrange [0:*]
set xlabel 'time / s'; set ylabel 'mean kinetic energy per mass / m^2 s^{-2}'
set title 'with gravity: energy in the lab'
plot 'output/smooth.heights' using 1:2 with lines ls wall_smooth title 'smooth', \
     'output/rough.heights' using 1:2 with lines ls wall_rough title 'rough'
set xrange [*:*]; set yrange [*:*]
set xlabel '{/Symbol w} · angular momentum gained / m^2 s^{-2}'; set ylabel 'energy gained / m^2 s^{-2}'
set title 'no gravity, no losses, rough wall: each grain, 0 … 0.9 s'
plot x with lines ls guide title 'equal', 'output/frame.motion' using 2:1 with points ls wall_rough pt 7 ps 0.35 title 'grains'
unset multiplot
