# CoR_N over the impact angle on a smooth and on a rough wall, from the ledgers.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 960,600 font 'sans,15'
set output 'output/flat_plate.png'
if (!exists('engine')) engine = 'LIGGGHTS'
set datafile separator comma
set xrange [0:90]; set xtics 15; set xlabel 'impact angle {/Symbol a}_1 / degrees'
set yrange [0:3]; set ytics 1; set ylabel 'CoR_N = v_{N2} / v_{N1}'
set key inside right top vertical maxrows auto font ',15' spacing 1.3 samplen 2
set title 'Quartz dust, 1–100 µm, at 100 m/s on Hastelloy X ('.engine.')'
each(i) = strcol(1)[1:1] eq '#' || column(19) != 0 ? NaN : column(i)
mean(i) = real(word(strcol(1), i))
stuck = "sprintf('mean; %.0f of %.0f stick', STATS_sum, STATS_records)"
stats 'output/smooth.csv' using (column(19) != 0) every ::1 nooutput
smooth = @stuck
stats 'output/phi_0.13.csv' using (column(19) != 0) every ::1 nooutput
rough = @stuck
plot 'output/phi_0.13.csv' using (each(11)):17 every ::2 with points ls impacts ps 0.25 notitle, \
     'output/smooth.csv' using (each(11)):17 every ::2 with points pt 7 ps 0.25 lc rgb '#bbbbbb' notitle, \
     keyentry with points pt 7 ps 0.9 lc rgb '#bbbbbb' title 'smooth wall: one dot per impact', \
     'output/smooth.mean' using (mean(1)):(mean(2)) with lines ls wall_smooth lw 3 title smooth, \
     keyentry with points ls impacts ps 0.9 title 'rough wall, R_q 15.6 µm, λ_c 120 µm', \
     'output/phi_0.13.mean' using (mean(1)):(mean(2)) with lines ls wall_rough lw 3 title rough
