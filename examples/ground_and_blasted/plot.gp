# Footprints on a screen 10 mm over the plates, and the lateral angles.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1300,780 font 'sans,11'
set output 'output/ground_and_blasted.png'
# Grains that pass the screen beyond the axes.
passed = 'ground blasted'
array beyond[2]
array all[2]
do for [i=1:2] {
  stats 'output/'.word(passed, i).'.foot' using ($1 > 70 || $1 < -10 || $2 > 20 || $2 < -20) nooutput
  beyond[i] = STATS_sum
  all[i] = STATS_records
}
outside(i) = sprintf('{/=9 :  %d of %d grains pass outside}', beyond[i], all[i])
set multiplot layout 2,2 title 'The same jet (10 µm quartz, 100 m/s, 10°) on two plates with R_q 5 µm, {/Symbol l}_c 40 µm: where the grains pass a screen 10 mm over them'
set xlabel 'along the jet / mm'
set ylabel 'to the side / mm'
set xrange [-10:70]
set yrange [-20:20]
set arrow 1 from graph 0.02, graph 0.5 to graph 0.12, graph 0.5 lw 2 lc rgb '#000000' front
set arrow 2 from graph 0.82, graph 0.08 to graph 0.94, graph 0.28 nohead lw 3 lc rgb '#444444' front
set label 2 'lay' at graph 0.95, graph 0.30
set title 'ground, the lay at 45° to the jet'.outside(1)
plot 'output/ground.foot' using 1:2 with points ls 1 pt 7 ps 0.2 notitle
unset arrow 2; unset label 2
set title 'blasted'.outside(2)
plot 'output/blasted.foot' using 1:2 with points ls 3 pt 7 ps 0.2 notitle
unset arrow 1
set title ''
set ylabel 'grains per degree'
set yrange [0:*]
set xlabel 'lateral angle / degrees, to the left of the jet'
set xrange [-30:30]
bin(x) = floor(x) + 0.5
plot 'output/ground.foot' using (bin($4)):(1) smooth frequency with histeps ls 1 title 'ground', \
     'output/blasted.foot' using (bin($4)):(1) smooth frequency with histeps ls 3 title 'blasted'
set xlabel 'rebound angle {/Symbol a}_2 / degrees'
set xrange [0:90]
plot 'output/ground.foot' using (bin($3)):(1) smooth frequency with histeps ls 1 title 'ground', \
     'output/blasted.foot' using (bin($3)):(1) smooth frequency with histeps ls 3 title 'blasted'
unset multiplot
