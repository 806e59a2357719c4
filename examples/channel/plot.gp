# The effect of rough walls on a channel: concentration, fluctuation and speed over the height, and
# the mean height over time.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1100,820 font 'sans,11'
set output 'output/channel.png'
name(i) = word('smooth phi_0.02 phi_0.05', i)
title_of(i) = i == 1 ? 'smooth' : i == 2 ? '{/Symbol F}_R = 0.02' : '{/Symbol F}_R = 0.05'
style(i) = i == 1 ? wall_smooth : i == 2 ? wall_rough : wall_rougher
set multiplot layout 2,2 title 'Glass beads of 200 µm in a channel 30 mm high, gas at 10 m/s, gravity: three LIGGGHTS runs'."\n"
set yrange [0:1]
set ylabel 'height / channel height'
set logscale x
set xrange [0.1:60]
set label 1 'smooth:' at 20,0.13 center tc rgb '#666666' font ',10'
set label 2 'on the floor' at 20,0.08 center tc rgb '#666666' font ',10'
set xlabel 'concentration / mean concentration, 0.5 … 1 s'
plot 'output/smooth.profile' using 2:1 with points ls wall_smooth ps 0.8 title 'smooth', \
     for [i=2:3] 'output/'.name(i).'.profile' using 2:1 with linespoints ls style(i) title title_of(i)
unset logscale x
unset label
set xrange [0:*]
set xlabel 'root mean square of v_z / m s^{-1}, 0.5 … 1 s'
plot for [i=1:3] 'output/'.name(i).'.profile' using 3:1 with linespoints ls style(i) title title_of(i)
set xrange [0:10.5]
set xlabel 'mean of v_x / m s^{-1}, 0.5 … 1 s'
plot for [i=1:3] 'output/'.name(i).'.profile' using 4:1 with linespoints ls style(i) title title_of(i)
set xrange [0:1]; set yrange [0:20]
set xlabel 'time / s'
set ylabel 'mean height / mm'
plot for [i=1:3] 'output/'.name(i).'.heights' using 1:2 with lines ls style(i) title title_of(i)
unset multiplot
