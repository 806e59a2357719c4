# CoR_N and CoR_T over the impact angle: clumps, spheres, and spheres with a lever.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1500,860 font 'sans,11'
set output 'output/crushed_sand.png'
set key samplen 1.5 width -1
set xrange [0:95]
set xtics 15
names = 'clumps spheres lever'
title_of(i) = i == 1 ? '(a) clumps of five spheres' : i == 2 ? '(b) spheres of the same volume' : '(c) spheres, grain lever '.S
set multiplot layout 2,3 title 'Crushed sand, 200 µm, at 20 m/s on a rough plate (R_q 5 µm, {/Symbol l}_c 40 µm): each dot is one grain'."\n"
do for [t=0:1] {
  do for [i=1:3] {
    name = 'output/'.word(names, i)
    set title (t == 0 ? title_of(i) : '')
    set ylabel (t == 0 ? 'CoR_N' : 'CoR_T')
    set xlabel (t == 1 ? 'impact angle {/Symbol a}_1 / degrees' : '')
    set yrange [(t == 0 ? -0.1 : -1):(t == 0 ? 3 : 2)]
    plot name.'.dots' using 1:(column(2 + t)) with points ls impacts ps 0.25 notitle, \
         keyentry with points ls impacts ps 0.8 title 'grains', \
         name.'.mean' using (t == 1 && $1 > 85 ? NaN : $1):(column(3 + 2 * t)):(column(4 + 2 * t)) with yerrorbars ls simulated title 'mean ± sd', \
         'output/clumps.mean' using (t == 1 && $1 > 85 ? NaN : $1):(column(3 + 2 * t)) with lines ls guide title 'clumps'
  }
}
unset multiplot
