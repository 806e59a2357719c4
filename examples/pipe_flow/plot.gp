# Profiles over the height: the mean speed of the beads, its rms fluctuation, the mean diameter; measured, with a smooth wall
# and with rough ones.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1400,500 font 'sans,16'
set output 'output/pipe_flow.png'
measured(what) = '< grep ^'.what.', ../data/huber_sommerfeld_1998.csv | tr "," " " | sort -k2g'
name(i) = word('smooth sigma_2.5 sigma_5 sigma_10 table_gas', i)
title_of(i) = i == 1 ? 'smooth' : i == 5 ? 'σ 5°, gas of a table' : 'σ '.word('0 2.5 5 10', i).'°'
color(i) = word('#777777 #9cc3e6 #0072b2 #0b2a55 #009e73', i)
dash(i) = i == 5 ? 4 : 1
drawn = "with lines lw (i == 3 ? 3 : 1.6) dt dash(i) lc rgb color(i)"
set xrange [-1.05:1.05]; set xtics 0.5
set xlabel 'height z/R (bottom: -1)'
set multiplot layout 1,3 margins 0.05,0.99,0.17,0.86 spacing 0.06
set key inside bottom center vertical font ',14' samplen 1.5
set title 'mean speed / (27 m/s)'
set yrange [0.1:1.3]
file = measured('u_p')
eval "plot file using 2:3 with points ls data title 'measured', for [i=1:5] 'output/'.name(i).'.profile' using 1:3 ".drawn. \
  " title title_of(i)"
unset key
set title 'rms fluctuation / (27 m/s)'
set yrange [0:0.35]
file = measured('u_rms')
eval "plot file using 2:3 with points ls data, for [i=1:5] 'output/'.name(i).'.profile' using 1:5 ".drawn
set title 'mean diameter / (40 µm)'
set yrange [0.8:1.25]
file = measured('d')
eval "plot file using 2:3 with points ls data, for [i=1:5] 'output/'.name(i).'.profile' using 1:7 ".drawn
unset multiplot
