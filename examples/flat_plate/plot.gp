# CoR_N and CoR_T over the impact angle (Altmeppen et al. 2020, figures 13 and 14), from the ledgers.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1500,860 font 'sans,11'
set output 'output/flat_plate.png'
if (!exists('engine')) engine = 'LIGGGHTS'
set datafile separator comma
set xrange [0:90]
set xtics 15
names = 'smooth phi_0.04 phi_0.13'
title_of(i) = i == 1 ? 'smooth wall' : i == 2 ? 'rough wall, {/Symbol F}_R = 0.04' : 'rough wall, {/Symbol F}_R = 0.13'
# Impacts that lie above or below the axes, in per cent of the rebounds.
low(t) = t == 0 ? 0 : -1
high(t) = t == 0 ? 3 : 2
array outside[6]
do for [i=1:3] {
  do for [t=0:1] {
    stats 'output/'.word(names, i).'.csv' using (strcol(1)[1:1] eq '#' || column(19) != 0 ? NaN : \
      column(17 + t) < low(t) || column(17 + t) > high(t) ? 100. : 0.) nooutput
    outside[2 * i - 1 + t] = STATS_mean
  }
}
set multiplot layout 2,3 title 'Quartz dust, 1–100 µm, at 100 m/s on Hastelloy X: three '.engine.' runs; what sticks is left out'."\n"
do for [t=0:1] {
  do for [i=1:3] {
    name = 'output/'.word(names, i)
    set title (t == 0 ? title_of(i).'{/=9 :  ' : '{/=9 ').sprintf('%.1f %% of the rebounds lie outside}', outside[2 * i - 1 + t])
    set ylabel (t == 0 ? 'CoR_N' : 'CoR_T')
    set xlabel (t == 1 ? 'impact angle {/Symbol a}_1 / degrees' : '')
    set yrange [low(t):high(t)]
    plot name.'.csv' using (strcol(1)[1:1] eq '#' || column(19) != 0 ? NaN : $11):(column(17 + t)) \
           every ::2 with points ls impacts ps 0.15 notitle, \
         keyentry with points ls impacts ps 0.8 title 'impacts', \
         name.'.mean' using (real(word(strcol(1), 1))):(real(word(strcol(1), 2 + 2*t)) - real(word(strcol(1), 3 + 2*t))):(real(word(strcol(1), 2 + 2*t)) + real(word(strcol(1), 3 + 2*t))) \
           with filledcurves ls (i == 1 ? wall_smooth : simulated) fs transparent solid 0.2 noborder title '± sd', \
         name.'.mean' using (real(word(strcol(1), 1))):(real(word(strcol(1), 2 + 2*t))) \
           with lines ls (i == 1 ? wall_smooth : simulated) title 'mean', \
         'output/bons.csv' using (strcol(10) eq 'rebound' ? $3 : NaN):(column(8 + t)) \
           with lines ls model_none lw 2.5 title 'smooth, d_p = 10 µm'
  }
}
unset multiplot
