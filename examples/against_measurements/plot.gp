# Measurements and what the laws make of them, from the tables of `asperity compare`.
# SPDX-License-Identifier: GPL-3.0-or-later
set term pngcairo size 1960,900 font 'sans,10'
set output 'output/against_measurements.png'
set datafile separator ','
set grid lc rgb '#dddddd' lw 0.5
set border lc rgb '#444444'
set tics nomirror
set xrange [0:91]
set xtics 15
k = 'cor_n'
y(v) = strcol(1) eq k ? v : NaN
file(set, model) = 'output/'.set.'.'.model.'.csv'
gt = 'grant_tabakoff_1975'
fo = 'forder_1998'
kh = 'kharaz_2001'
grey = '#777777'
blue = '#1f5fa8'
green = '#2a8a57'
violet = '#8a4fa8'
set style fill transparent solid 0.25 noborder
set multiplot layout 2,4 title 'Measured coefficients of restitution, and laws with constants as shipped or fitted (see README)' margins 0.035,0.99,0.07,0.92 spacing 0.04,0.12

set xlabel 'impact angle / degrees'
set key top right opaque samplen 2 font ',9'
set title 'Grant & Tabakoff 1975, sand on Al 2024' noenhanced
set ylabel 'CoR_N'
set yrange [0:2.5]
plot file(gt, 'fitted_normal') using 18:(y($8)):(y($9)) with filledcurves fc rgb green notitle, \
  file(gt, 'shipped') using 18:(y($5)) with lines lw 2 dt 2 lc rgb grey title 'bons, as shipped, smooth', \
  file(gt, 'fitted_both') using 18:(y($5)) with lines lw 2 lc rgb blue title 'bons, fitted to both: σ < 0.17°', \
  file(gt, 'fitted_normal') using 18:(y($5)) with lines lw 2 lc rgb green title 'bons, fitted to CoR_N: σ < 1.1°; 5 to 95 %', \
  file(gt, 'forder') using 18:(y($5)) with lines lw 1.5 dt 4 lc rgb violet title 'Forder et al. 1998', \
  file(gt, 'thornton_ning') using 18:(y($5)) with lines lw 1.5 dt 3 lc rgb '#b0902a' title 'thornton_ning, as shipped, smooth' noenhanced, \
  file(gt, 'shipped') using 18:(y($11)):(y($12)) with yerrorbars pt 7 ps 0.7 lc rgb '#c8501e' title 'measured, mean ± sd', \
  '-' using 1:2 with points pt 2 ps 1.6 lw 2 lc rgb '#aa3333' title 'three published sets at 30°'
30,0.43
30,0.55
30,0.63
e
k = 'cor_t'
set ylabel 'CoR_T'
set yrange [-1:2.6]
set key bottom left
plot file(gt, 'fitted_normal') using 18:(y($8)):(y($9)) with filledcurves fc rgb green notitle, \
  file(gt, 'shipped') using 18:(y($5)) with lines lw 2 dt 2 lc rgb grey title 'bons, as shipped, smooth', \
  file(gt, 'fitted_both') using 18:(y($5)) with lines lw 2 lc rgb blue title 'bons, fitted to both: σ < 0.17°', \
  file(gt, 'fitted_normal') using 18:(y($5)) with lines lw 2 lc rgb green title 'bons, fitted to CoR_N: σ < 1.1°; 5 to 95 %', \
  file(gt, 'forder') using 18:(y($5)) with lines lw 1.5 dt 4 lc rgb violet title 'Forder et al. 1998', \
  file(gt, 'thornton_ning') using 18:(y($5)) with lines lw 1.5 dt 3 lc rgb '#b0902a' title 'thornton_ning, as shipped, smooth' noenhanced, \
  file(gt, 'shipped') using 18:(y($11)):(y($12)) with yerrorbars pt 7 ps 0.7 lc rgb '#c8501e' title 'measured, mean ± sd'

set key top right
set title 'Kharaz et al. 2001, 5 mm alumina on glass' noenhanced
set yrange [0.4:1.4]
plot file(kh, 'walton') using 18:(y($5)) with lines lw 2 lc rgb green title 'walton e 0.98, mu 0.092, beta0 0' noenhanced, \
  file(kh, 'walton_compliance') using 18:(y($5)) with lines lw 2 lc rgb blue title 'the same, compliance 0.7 (fitted)', \
  file(kh, 'bons') using 18:(y($5)) with lines lw 2 dt 2 lc rgb grey title 'bons with that mu', \
  file(kh, 'bons_fitted') using 18:(y($5)) with lines lw 1.5 dt 4 lc rgb violet title 'bons, mu fitted: 0.29', \
  file(kh, 'walton') using 18:(y($11)) with points pt 7 ps 0.9 lc rgb '#c8501e' title 'measured, means'

spins(model) = 'output/kharaz_spin.'.model.'.csv'
curve(model) = 'output/kharaz_spin.'.model.'.curve'
row(kind, quantity, v) = (strcol(1) eq kind && strcol(2) eq quantity) ? v : NaN
set title 'Kharaz et al. 2001: spin after the impact' noenhanced
set ylabel 'spin / rad s^{-1}'
set yrange [0:900]
set key top left Left reverse
plot curve('walton') using (90 - $3):(row('curve', 'spin', $5)) with lines lw 2 lc rgb green title 'walton e 0.98, mu 0.092, beta0 0' noenhanced, \
  curve('walton_compliance') using (90 - $3):(row('curve', 'spin', $5)) with lines lw 2 lc rgb blue title 'the same, compliance 0.7 (fitted to CoR_T)', \
  spins('walton') using (90 - $3):(row('experiment', 'spin', $4)) with points pt 7 ps 0.9 lc rgb '#c8501e' title 'experiment', \
  spins('walton') using (90 - $3):(row('reference', 'spin', $4)) with points pt 6 ps 1.1 lc rgb '#c8501e' title 'test 4 of Chung & Ooi; measured or computed not said' noenhanced
set key top right noreverse Right

set title 'Forder et al. 1998, materials not named' noenhanced
k = 'cor_n'
set ylabel 'CoR_N'
set yrange [0:1.5]
plot file(fo, 'shipped') using 18:(y($5)) with lines lw 2 dt 2 lc rgb grey title 'bons, as shipped, smooth', \
  file(fo, 'fitted') using 18:(y($5)) with lines lw 2 lc rgb blue title 'bons, two constants fitted', \
  file(fo, 'grant_tabakoff') using 18:(y($5)) with lines lw 1.5 dt 4 lc rgb violet title 'grant_tabakoff' noenhanced, \
  file(fo, 'thornton_ning') using 18:(y($5)) with lines lw 1.5 dt 3 lc rgb '#b0902a' title 'thornton_ning, as shipped, smooth' noenhanced, \
  file(fo, 'shipped') using 18:(y($11)) with points pt 7 ps 0.7 lc rgb '#c8501e' title 'measured, polynomial'
k = 'cor_t'
set ylabel 'CoR_T'
set yrange [0.4:1.5]
plot file(fo, 'shipped') using 18:(y($5)) with lines lw 2 dt 2 lc rgb grey title 'bons, as shipped, smooth', \
  file(fo, 'fitted') using 18:(y($5)) with lines lw 2 lc rgb blue title 'bons, two constants fitted', \
  file(fo, 'grant_tabakoff') using 18:(y($5)) with lines lw 1.5 dt 4 lc rgb violet title 'grant_tabakoff' noenhanced, \
  file(fo, 'thornton_ning') using 18:(y($5)) with lines lw 1.5 dt 3 lc rgb '#b0902a' title 'thornton_ning, as shipped, smooth' noenhanced, \
  file(fo, 'shipped') using 18:(y($11)) with points pt 7 ps 0.7 lc rgb '#c8501e' title 'measured, polynomial'

set title 'LaMarche et al. 2022, 3.1 mm glass on acrylic, 179 rebounds' noenhanced
set xlabel 'CoR_N'
set ylabel 'share below'
set xrange [0.6:1.02]
set xtics 0.1
set yrange [0:1]
set key top left Left reverse noopaque
stats 'output/lamarche.measured' nooutput
n = STATS_records
stats 'output/lamarche.rough' nooutput
m = STATS_records
plot 'output/lamarche.measured' using 1:(($0 + 0.5) / n) with steps lw 2 lc rgb '#c8501e' title 'measured', \
  'output/lamarche.rough' using 1:(($0 + 0.5) / m) with steps lw 2 lc rgb blue title 'walton, σ 6.2°, e 0.994: same mean and sd', \
  '-' using 1:2 with lines lw 2 dt 2 lc rgb grey title 'walton, smooth, e 0.955'
0.955,0
0.955,1
e
set title 'Kharaz et al. 2001: rebound of the contact point' noenhanced
set xlabel 'impact angle / degrees'
set ylabel 'angle from the normal / degrees'
set xrange [0:91]
set xtics 15
set yrange [-20:100]
set key top right noreverse Right
plot curve('walton') using (90 - $3):(row('curve', 'contact_angle_deg', $5)) with lines lw 2 lc rgb green title 'walton e 0.98, mu 0.092, beta0 0' noenhanced, \
  curve('walton_compliance') using (90 - $3):(row('curve', 'contact_angle_deg', $5)) with lines lw 2 lc rgb blue title 'the same, compliance 0.7', \
  spins('walton') using (90 - $3):(row('experiment', 'contact_angle_deg', $4)) with points pt 7 ps 0.9 lc rgb '#c8501e' title 'experiment', \
  spins('walton') using (90 - $3):(row('reference', 'contact_angle_deg', $4)) with points pt 6 ps 1.1 lc rgb '#c8501e' title 'test 4 of Chung & Ooi' noenhanced
unset multiplot
