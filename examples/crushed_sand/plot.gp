# CoR_N over the impact angle: clumps, spheres, and spheres with a lever.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1400,480 font 'sans,16'
set output 'output/crushed_sand.png'
set key inside right top vertical Left reverse samplen 1.5 font ',15'
set xrange [0:95]; set yrange [-0.1:3]
set xtics 15
set xlabel 'impact angle α_1 / degrees'
set ylabel 'CoR_N'
title_of(i) = i == 1 ? 'clumps of five spheres' : i == 2 ? 'spheres of the same volume' : 'spheres, grain lever '.S
set multiplot layout 1,3
do for [i=1:3] {
  name = 'output/'.word('clumps spheres lever', i)
  set title title_of(i)
  plot name.'.dots' using 1:2 with points ls impacts ps 0.25 notitle, \
       keyentry with points ls impacts ps 0.8 title 'grains', \
       name.'.mean' using 1:3:4 with yerrorbars ls simulated title 'mean ± sd', \
       'output/clumps.mean' using 1:3 with lines ls guide title 'mean of clumps'
}
unset multiplot
