# Profiles over the height: the mean speed of the beads, its rms fluctuation, the mean diameter, the concentration; measured,
# with a smooth wall and with rough ones.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1300,900 font 'sans,11'
set output 'output/pipe_flow.png'
measured(what) = '< grep ^'.what.', ../data/huber_sommerfeld_1998.csv | tr "," " " | sort -k2g'
name(i) = word('smooth sigma_2.5 sigma_5 sigma_10 weibull_5 rq_0.5um table_gas', i)
title_of(i) = word('smooth σ_2.5° σ_5° σ_10° σ_5°,_weibull_plane_single R_q_0.5_µm,_λ_c_4_µm σ_5°,_gas_of_a_table', i)
color(i) = word('#777777 #9cc3e6 #0072b2 #0b2a55 #cc79a7 #882255 #009e73', i)
dash(i) = i == 5 || i == 6 ? 2 : i == 7 ? 4 : 1
label(i) = system("echo '".title_of(i)."' | sed 's/\\([Rλ]\\)_\\([qc]\\)/\\1~\\2/g; s/_/ /g; s/~\\(.\\)/_\\1/g'")
profile(i) = 'output/'.name(i).'.profile'
set xrange [-1.05:1.05]
set xlabel 'height z/R (bottom: -1)'
set multiplot layout 2,2 title 'Beads of 40 µm in air at 27 m/s, horizontal pipe of 150 mm: measured (Huber and Sommerfeld 1998) and 20 000 beads in LAMMPS' \
  margins 0.06,0.985,0.07,0.93 spacing 0.08,0.12
set key inside bottom center vertical font ',9' samplen 2
set ylabel 'mean speed / 27 m s^{-1}'
set yrange [0.3:1.3]
plot for [i=1:7] profile(i) using 1:3 with lines lw (i == 3 ? 3 : 1.6) dt dash(i) lc rgb color(i) title label(i), \
  measured('u_gas_rsm') using 2:3 with lines ls reference dt 3 title 'gas of a published simulation', \
  measured('u_p') using 2:3 with points ls data title 'measured'
unset key
set ylabel "rms fluctuation u' / 27 m s^{-1}"
set yrange [0:0.35]
plot for [i=1:7] profile(i) using 1:5 with lines lw (i == 3 ? 3 : 1.6) dt dash(i) lc rgb color(i) notitle, \
  measured('u_rms') using 2:3 with points ls data notitle
set ylabel 'mean diameter / 40 µm'
set yrange [0.8:1.25]
plot for [i=1:7] profile(i) using 1:7 with lines lw (i == 3 ? 3 : 1.6) dt dash(i) lc rgb color(i) notitle, \
  measured('d') using 2:3 with points ls data notitle
set ylabel 'concentration / mean over the slice (not measured)'
set logscale y
set yrange [0.05:30]
plot for [i=1:7] profile(i) using 1:9 with lines lw (i == 3 ? 3 : 1.6) dt dash(i) lc rgb color(i) notitle
unset multiplot
