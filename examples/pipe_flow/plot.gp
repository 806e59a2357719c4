# Profiles over the height: the mean speed of the beads, its root mean square, the mean diameter, the concentration; measured,
# with a smooth wall and with rough ones. The bands are the measured profile plus and minus the least error of the published
# simulations.
# SPDX-License-Identifier: GPL-3.0-or-later
set term pngcairo size 1300,900 font 'sans,11'
set output 'output/pipe_flow.png'
set grid lc rgb '#dddddd' lw 0.5
set border lc rgb '#444444'
set tics nomirror
measured(what) = '< grep ^'.what.', ../data/huber_sommerfeld_1998.csv | tr "," " " | sort -k2g'
name(i) = word('smooth sigma_2.5 sigma_5 sigma_10 weibull_5 rq_0.5um table_gas', i)
title_of(i) = word('smooth σ_2.5° σ_5° σ_10° σ_5°,_weibull_plane_single R_q_0.5_µm,_λ_c_4_µm σ_5°,_gas_of_a_table', i)
colour(i) = word('#888888 #9cc3e6 #1f5fa8 #0b2a55 #2a8a57 #8a4fa8 #c8961e', i)
dash(i) = i == 5 || i == 6 ? 2 : i == 7 ? 4 : 1
label(i) = system("echo '".title_of(i)."' | sed 's/\\([Rλ]\\)_\\([qc]\\)/\\1~\\2/g; s/_/ /g; s/~\\(.\\)/_\\1/g'")
profile(i) = 'output/'.name(i).'.profile'
set xrange [-1:1]
set xlabel 'height z/R (bottom: -1)'
set style fill solid 0.18 noborder
set multiplot layout 2,2 title 'Beads of 40 µm in air at 27 m/s, horizontal pipe of 150 mm: measured (Huber and Sommerfeld 1998) and 20 000 beads in LAMMPS' \
  margins 0.06,0.985,0.07,0.93 spacing 0.08,0.12
set key bottom center font ',9' samplen 2
set ylabel 'mean speed / 27 m s^{-1}'
set yrange [0.3:1.3]
plot measured('u_p') using 2:($3 - 0.038):($3 + 0.038) with filledcurves lc rgb '#c8501e' title 'measured ± 0.038, the best published simulation', \
  for [i=1:7] profile(i) using 1:3 with lines lw (i == 3 ? 3 : 1.6) dt dash(i) lc rgb colour(i) title label(i), \
  measured('u_gas_rsm') using 2:3 with lines lw 1 dt 3 lc rgb '#000000' title 'gas of a published simulation', \
  measured('u_p') using 2:3 with points pt 7 ps 0.9 lc rgb '#c8501e' title 'measured'
set nokey
set label 1 'band: ± 0.085' at graph 0.5,0.93 center tc rgb '#c8501e' font ',9'
set ylabel 'root mean square of the speed / 27 m s^{-1}'
set yrange [0:0.42]
plot measured('u_rms') using 2:($3 - 0.085):($3 + 0.085) with filledcurves lc rgb '#c8501e' notitle, \
  for [i=1:7] profile(i) using 1:5 with lines lw (i == 3 ? 3 : 1.6) dt dash(i) lc rgb colour(i) notitle, \
  measured('u_rms') using 2:3 with points pt 7 ps 0.9 lc rgb '#c8501e' notitle
set label 1 'band: ± 0.043' at graph 0.5,0.93 center tc rgb '#c8501e' font ',9'
set ylabel 'mean diameter / 40 µm'
set yrange [0.75:1.35]
plot measured('d') using 2:($3 - 0.043):($3 + 0.043) with filledcurves lc rgb '#c8501e' notitle, \
  for [i=1:7] profile(i) using 1:7 with lines lw (i == 3 ? 3 : 1.6) dt dash(i) lc rgb colour(i) notitle, \
  measured('d') using 2:3 with points pt 7 ps 0.9 lc rgb '#c8501e' notitle
unset label 1
set ylabel 'concentration / mean over the slice (not measured)'
set logscale y
set yrange [0.05:30]
plot for [i=1:7] profile(i) using 1:9 with lines lw (i == 3 ? 3 : 1.6) dt dash(i) lc rgb colour(i) notitle
unset multiplot
