# The effect of rough walls on a channel: concentration over the height, and the mean height over time.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1200,480 font 'sans,16'
set output 'output/channel.png'
name(i) = word('smooth phi_0.02 phi_0.05', i)
title_of(i) = i == 1 ? 'smooth' : i == 2 ? 'Φ_R = 0.02' : 'Φ_R = 0.05'
style(i) = i == 1 ? wall_smooth : i == 2 ? wall_rough : wall_rougher
set multiplot layout 1,2
unset key
set yrange [0:1]
set ylabel 'height / channel height'
set logscale x
set xrange [0.3:60]
set label 1 "smooth:\non the floor" at 20,0.18 center
set xlabel 'concentration / its mean, 0.5 … 1 s'
plot 'output/smooth.profile' using 2:1 with points ls wall_smooth ps 1.2, \
     for [i=2:3] 'output/'.name(i).'.profile' using 2:1 with linespoints ls style(i)
unset logscale x
unset label
set key inside right center vertical Left reverse font ',16'
set xrange [0:1]; set yrange [0:20]
set xlabel 'time / s'
set ylabel 'mean height / mm'
plot for [i=1:3] 'output/'.name(i).'.heights' using 1:2 with lines ls style(i) title title_of(i)
unset multiplot
