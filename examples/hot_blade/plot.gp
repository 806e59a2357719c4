# The share of impacts that sticks over the temperature, by size and ash; what was measured as a band.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1200,520 font 'sans,15'
set output 'output/hot_blade.png'
set multiplot layout 1,2
set xrange [1000:1600]; set xtics 100
set xlabel 'temperature of gas and particles / K'
set logscale y; set yrange [1e-3:1]; set format y '10^{%L}'
set bmargin 7
set key outside below center horizontal Left reverse samplen 3 font ',13'
# Deposits began at 1233 K, and were up to a tenth of the mass at 1456 K.
set object 1 rectangle from 1233,graph 0 to 1456,0.1 fc rgb '#e69f00' fs transparent solid 0.2 noborder behind
set label 1 "measured, not fitted" at 1344,0.0013 center font ',12' tc rgb '#8a5f00'
sizes = '3 10 30'
do for [ash in 'volcanic dust'] {
  set title (ash eq 'dust' ? 'road dust' : 'volcanic ash').': share that sticks'
  plot for [size in sizes] 'output/law.'.size using 1:2 with lines ls guide lw 1.5 \
         title (size eq '3' ? 'by adhesion alone' : ''), \
       for [k = 1:3] 'output/'.ash.'.'.word(sizes, k) with linespoints ls k title word(sizes, k).' µm'
}
unset multiplot
