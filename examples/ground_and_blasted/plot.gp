# Footprints on a screen 10 mm over the plates.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1200,480 font 'sans,16'
set output 'output/ground_and_blasted.png'
set multiplot layout 1,2
set xlabel 'along the jet / mm'
set ylabel 'to the side / mm'
set xrange [-10:70]; set yrange [-20:20]
set ytics 10
set arrow 1 from graph 0.02, graph 0.5 to graph 0.12, graph 0.5 lw 2 lc rgb '#000000' front
set arrow 2 from graph 0.80, graph 0.08 to graph 0.92, graph 0.28 nohead lw 3 lc rgb '#444444' front
set label 2 'lay' at graph 0.93, graph 0.30
set title 'ground, the lay at 45° to the jet'
plot 'output/ground.foot' using 1:2 with points ls 1 pt 7 ps 0.25 notitle
unset arrow 2; unset label 2
set title 'blasted'
plot 'output/blasted.foot' using 1:2 with points ls 3 pt 7 ps 0.25 notitle
unset multiplot
