# Measurements and what the laws make of them, from the tables of `asperity compare`.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1960,1180 font 'sans,10'
set output 'output/against_measurements.png'
set datafile separator ','
set xrange [-2:92]
set xtics 15
k = 'cor_n'
y(v) = strcol(1) eq k ? v : NaN
file(set, model) = 'output/'.set.'.'.model.'.csv'
gt = 'grant_tabakoff_1975'
fo = 'forder_1998'
kh = 'kharaz_2001'
# Columns of asperity compare.
angle = 2; mean = 8; sd = 10; measured = 13; measured_sd = 15
set style fill transparent solid 0.2 noborder
set multiplot layout 2,4 title 'Measured coefficients of restitution, and laws with constants as shipped or fitted (see README)'."\n"

set key vertical maxrows 8 font ',9' samplen 2
set xlabel 'impact angle / degrees'
set title 'Grant & Tabakoff 1975, sand on Al 2024' noenhanced
set ylabel 'CoR_N'
set yrange [0:1.2]
plot file(gt, 'fitted_normal') using angle:(y(column(mean) - column(sd))):(y(column(mean) + column(sd))) with filledcurves ls law_bons notitle, \
  file(gt, 'shipped') using angle:(y(column(mean))) with lines ls law_bons dt 3 title 'bons, as shipped, smooth', \
  file(gt, 'fitted_both') using angle:(y(column(mean))) with lines ls law_bons dt 2 title 'bons, fitted to both: σ < 0.17°', \
  file(gt, 'fitted_normal') using angle:(y(column(mean))) with lines ls law_bons title 'bons, fitted to CoR_N: σ < 1.1°; ± sd', \
  file(gt, 'forder') using angle:(y(column(mean))) with lines ls law_table title 'Forder et al. 1998', \
  file(gt, 'thornton_ning') using angle:(y(column(mean))) with lines ls law_thornton_ning title 'thornton_ning, as shipped, smooth' noenhanced, \
  file(gt, 'shipped') using angle:(y(column(measured))):(y(column(measured_sd))) with yerrorbars ls data title 'measured, mean ± sd', \
  '-' using 1:2 with points ls data pt 2 ps 1.6 lw 2 title 'three published sets at 30°'
30,0.43
30,0.55
30,0.63
e
k = 'cor_t'
set ylabel 'CoR_T'
set yrange [0.2:1.2]
plot file(gt, 'fitted_normal') using angle:(y(column(mean) - column(sd))):(y(column(mean) + column(sd))) with filledcurves ls law_bons notitle, \
  file(gt, 'shipped') using angle:(y(column(mean))) with lines ls law_bons dt 3 title 'bons, as shipped, smooth', \
  file(gt, 'fitted_both') using angle:(y(column(mean))) with lines ls law_bons dt 2 title 'bons, fitted to both: σ < 0.17°', \
  file(gt, 'fitted_normal') using angle:(y(column(mean))) with lines ls law_bons title 'bons, fitted to CoR_N: σ < 1.1°; ± sd', \
  file(gt, 'forder') using angle:(y(column(mean))) with lines ls law_table title 'Forder et al. 1998', \
  file(gt, 'thornton_ning') using angle:(y(column(mean))) with lines ls law_thornton_ning title 'thornton_ning, as shipped, smooth' noenhanced, \
  file(gt, 'shipped') using angle:(y(column(measured))):(y(column(measured_sd))) with yerrorbars ls data title 'measured, mean ± sd'

set title 'Kharaz et al. 2001, 5 mm alumina on glass' noenhanced
set yrange [0.5:1.1]
plot file(kh, 'walton') using angle:(y(column(mean))) with lines ls law_walton title 'walton e 0.98, mu 0.092, beta0 0' noenhanced, \
  file(kh, 'walton_compliance') using angle:(y(column(mean))) with lines ls law_walton dt 2 title 'the same, compliance 0.7 (fitted)', \
  file(kh, 'bons') using angle:(y(column(mean))) with lines ls law_bons dt 3 title 'bons with that mu', \
  file(kh, 'bons_fitted') using angle:(y(column(mean))) with lines ls law_bons title 'bons, mu fitted: 0.29', \
  file(kh, 'walton') using angle:(y(column(measured))) with points ls data title 'measured, means'

spins(model) = 'output/kharaz_spin.'.model.'.csv'
curve(model) = 'output/kharaz_spin.'.model.'.curve'
row(kind, quantity, v) = (strcol(1) eq kind && strcol(2) eq quantity) ? v : NaN
set title 'Kharaz et al. 2001: spin after the impact' noenhanced
set ylabel 'spin / rad s^{-1}'
set yrange [0:700]
plot curve('walton') using (90 - $3):(row('curve', 'spin', $5)) with lines ls law_walton title 'walton e 0.98, mu 0.092, beta0 0' noenhanced, \
  curve('walton_compliance') using (90 - $3):(row('curve', 'spin', $5)) with lines ls law_walton dt 2 title 'the same, compliance 0.7 (fitted to CoR_T)', \
  spins('walton') using (90 - $3):(row('experiment', 'spin', $4)) with points ls data title 'experiment', \
  spins('walton') using (90 - $3):(row('reference', 'spin', $4)) with points ls data pt 6 ps 1.1 title 'test 4 of Chung & Ooi; measured or computed not said' noenhanced

set title 'Forder et al. 1998, materials not named' noenhanced
k = 'cor_n'
set ylabel 'CoR_N'
set yrange [0:1.1]
plot file(fo, 'shipped') using angle:(y(column(mean))) with lines ls law_bons dt 3 title 'bons, as shipped, smooth', \
  file(fo, 'fitted') using angle:(y(column(mean))) with lines ls law_bons title 'bons, two constants fitted', \
  file(fo, 'grant_tabakoff') using angle:(y(column(mean))) with lines ls law_grant_tabakoff title 'grant_tabakoff' noenhanced, \
  file(fo, 'thornton_ning') using angle:(y(column(mean))) with lines ls law_thornton_ning title 'thornton_ning, as shipped, smooth' noenhanced, \
  file(fo, 'shipped') using angle:(y(column(measured))) with points ls data title 'measured, polynomial'
k = 'cor_t'
set ylabel 'CoR_T'
set yrange [0.5:1.1]
plot file(fo, 'shipped') using angle:(y(column(mean))) with lines ls law_bons dt 3 title 'bons, as shipped, smooth', \
  file(fo, 'fitted') using angle:(y(column(mean))) with lines ls law_bons title 'bons, two constants fitted', \
  file(fo, 'grant_tabakoff') using angle:(y(column(mean))) with lines ls law_grant_tabakoff title 'grant_tabakoff' noenhanced, \
  file(fo, 'thornton_ning') using angle:(y(column(mean))) with lines ls law_thornton_ning title 'thornton_ning, as shipped, smooth' noenhanced, \
  file(fo, 'shipped') using angle:(y(column(measured))) with points ls data title 'measured, polynomial'

set title 'LaMarche et al. 2022, 3.1 mm glass on acrylic, 179 rebounds' noenhanced
set xlabel 'CoR_N'
set ylabel 'share below'
set xrange [0.6:1.02]
set xtics 0.1
set yrange [0:1]
stats 'output/lamarche.measured' nooutput
n = STATS_records
stats 'output/lamarche.rough' nooutput
m = STATS_records
plot 'output/lamarche.measured' using 1:(($0 + 0.5) / n) with steps ls data title 'measured', \
  'output/lamarche.rough' using 1:(($0 + 0.5) / m) with steps ls law_walton title 'walton, σ 6.2°, e 0.994: same mean and sd', \
  '-' using 1:2 with lines ls law_walton dt 2 title 'walton, smooth, e 0.955'
0.955,0
0.955,1
e
set title 'Kharaz et al. 2001: rebound of the contact point' noenhanced
set xlabel 'impact angle / degrees'
set ylabel 'angle from the normal / degrees'
set xrange [-2:92]
set xtics 15
set yrange [-20:100]
plot curve('walton') using (90 - $3):(row('curve', 'contact_angle_deg', $5)) with lines ls law_walton title 'walton e 0.98, mu 0.092, beta0 0' noenhanced, \
  curve('walton_compliance') using (90 - $3):(row('curve', 'contact_angle_deg', $5)) with lines ls law_walton dt 2 title 'the same, compliance 0.7', \
  spins('walton') using (90 - $3):(row('experiment', 'contact_angle_deg', $4)) with points ls data title 'experiment', \
  spins('walton') using (90 - $3):(row('reference', 'contact_angle_deg', $4)) with points ls data pt 6 ps 1.1 title 'test 4 of Chung & Ooi' noenhanced
unset multiplot
