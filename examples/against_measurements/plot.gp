# Measurements and what the laws make of them, from the tables of `asperity compare`.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1080,1830 font 'sans,11'
set output 'output/against_measurements.png'
set datafile separator ','
set xrange [-2:92]
set xtics 15
set multiplot title 'Measured coefficients of restitution, and laws with constants as shipped or fitted'

# The columns of asperity compare, and its rows of one coefficient.
angle = 2; mean = 8; measured = 13; measured_sd = 15
y(coefficient, v) = strcol(1) eq coefficient ? v : NaN
file(set, model) = 'output/'.set.'.'.model.'.csv'
gt = 'grant_tabakoff_1975'
fo = 'forder_1998'
kh = 'kharaz_2001'
# Panels in two columns and four rows; one key for the upper two rows, one for Kharaz et al.
low(row) = 0.80 - 0.182 * row - (row > 1 ? 0.029 : 0)
panel = 'set lmargin at screen left; set rmargin at screen left + 0.41; set bmargin at screen low(row); set tmargin at screen low(row) + 0.135'
set xlabel 'impact angle / degrees' offset 0,0.4

row = 0; left = 0.075
@panel
set key at screen 0.52,0.977 center top vertical maxrows 2 width 1 font ',11'
set title 'Grant & Tabakoff 1975, sand on Al 2024' noenhanced
set ylabel 'CoR_N'
set yrange [0:1.2]
plot file(gt, 'shipped') using angle:(y('cor_n', column(measured))):(y('cor_n', column(measured_sd))) with yerrorbars ls data title 'measured; ± sd where known', \
  file(gt, 'shipped') using angle:(y('cor_n', column(mean))) with lines ls law_bons dt 3 title 'bons, as shipped', \
  file(gt, 'fitted_normal') using angle:(y('cor_n', column(mean))) with lines ls law_bons title 'bons, fitted', \
  file(gt, 'thornton_ning') using angle:(y('cor_n', column(mean))) with lines ls law_thornton_ning title 'thornton\_ning, as shipped', \
  file(gt, 'forder') using angle:(y('cor_n', column(mean))) with lines ls law_table title 'table: Forder et al.', \
  NaN with lines ls law_grant_tabakoff title 'grant\_tabakoff'
unset key
left = 0.575
@panel
set ylabel 'CoR_T'
plot file(gt, 'shipped') using angle:(y('cor_t', column(measured))):(y('cor_t', column(measured_sd))) with yerrorbars ls data, \
  file(gt, 'shipped') using angle:(y('cor_t', column(mean))) with lines ls law_bons dt 3, \
  file(gt, 'fitted_normal') using angle:(y('cor_t', column(mean))) with lines ls law_bons, \
  file(gt, 'thornton_ning') using angle:(y('cor_t', column(mean))) with lines ls law_thornton_ning, \
  file(gt, 'forder') using angle:(y('cor_t', column(mean))) with lines ls law_table

row = 1; left = 0.075
@panel
set title 'Forder et al. 1998, materials not named' noenhanced
set ylabel 'CoR_N'
plot file(fo, 'shipped') using angle:(y('cor_n', column(measured))) with points ls data, \
  file(fo, 'shipped') using angle:(y('cor_n', column(mean))) with lines ls law_bons dt 3, \
  file(fo, 'fitted') using angle:(y('cor_n', column(mean))) with lines ls law_bons, \
  file(fo, 'thornton_ning') using angle:(y('cor_n', column(mean))) with lines ls law_thornton_ning, \
  file(fo, 'grant_tabakoff') using angle:(y('cor_n', column(mean))) with lines ls law_grant_tabakoff
left = 0.575
@panel
set ylabel 'CoR_T'
plot file(fo, 'shipped') using angle:(y('cor_t', column(measured))) with points ls data, \
  file(fo, 'shipped') using angle:(y('cor_t', column(mean))) with lines ls law_bons dt 3, \
  file(fo, 'fitted') using angle:(y('cor_t', column(mean))) with lines ls law_bons, \
  file(fo, 'thornton_ning') using angle:(y('cor_t', column(mean))) with lines ls law_thornton_ning, \
  file(fo, 'grant_tabakoff') using angle:(y('cor_t', column(mean))) with lines ls law_grant_tabakoff

row = 2; left = 0.075
@panel
set key at screen 0.53,0.587 center top vertical maxrows 2 width 1 font ',11'
set title 'Kharaz et al. 2001, 5 mm alumina on glass' noenhanced
set yrange [0.5:1.1]
plot file(kh, 'walton') using angle:(y('cor_t', column(measured))) with points ls data title 'measured', \
  file(kh, 'walton') using angle:(y('cor_t', column(mean))) with lines ls law_walton title 'walton, as measured', \
  file(kh, 'walton_compliance') using angle:(y('cor_t', column(mean))) with lines ls law_walton dt 2 title 'walton, compliance 0.7 (fitted)', \
  NaN with points ls data pt 6 ps 1.1 title 'test 4 of Chung \& Ooi', \
  file(kh, 'bons') using angle:(y('cor_t', column(mean))) with lines ls law_bons dt 3 title 'bons with that µ', \
  file(kh, 'bons_fitted') using angle:(y('cor_t', column(mean))) with lines ls law_bons title 'bons, µ fitted'
unset key
spins(model) = 'output/kharaz_spin.'.model.'.csv'
curve(model) = 'output/kharaz_spin.'.model.'.curve'
of(kind, quantity, v) = (strcol(1) eq kind && strcol(2) eq quantity) ? v : NaN
left = 0.575
@panel
set title 'Kharaz et al. 2001: spin after the impact' noenhanced
set ylabel 'spin / rad s^{-1}'
set yrange [0:700]
plot curve('walton') using (90 - $3):(of('curve', 'spin', $5)) with lines ls law_walton, \
  curve('walton_compliance') using (90 - $3):(of('curve', 'spin', $5)) with lines ls law_walton dt 2, \
  spins('walton') using (90 - $3):(of('experiment', 'spin', $4)) with points ls data, \
  spins('walton') using (90 - $3):(of('reference', 'spin', $4)) with points ls data pt 6 ps 1.1

row = 3; left = 0.075
@panel
set title 'Kharaz et al. 2001: rebound of the contact point' noenhanced
set ylabel 'angle from the normal / degrees'
set yrange [-20:100]
plot curve('walton') using (90 - $3):(of('curve', 'contact_angle_deg', $5)) with lines ls law_walton, \
  curve('walton_compliance') using (90 - $3):(of('curve', 'contact_angle_deg', $5)) with lines ls law_walton dt 2, \
  spins('walton') using (90 - $3):(of('experiment', 'contact_angle_deg', $4)) with points ls data, \
  spins('walton') using (90 - $3):(of('reference', 'contact_angle_deg', $4)) with points ls data pt 6 ps 1.1
left = 0.575
@panel
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
set label 1 'measured' at 0.84,0.08 right tc rgb '#d55e00'
set label 2 "walton, σ 6.2°, e 0.994:\nsame mean and sd" at 0.865,0.30 right tc rgb '#5e3c99'
set label 3 "walton,\nsmooth,\ne 0.955" at 0.945,0.9 right tc rgb '#5e3c99'
plot 'output/lamarche.measured' using 1:(($0 + 0.5) / n) with steps ls data, \
  'output/lamarche.rough' using 1:(($0 + 0.5) / m) with steps ls law_walton, \
  '-' using 1:2 with lines ls law_walton dt 2
0.955,0
0.955,1
e

row = 4; left = 0.075
@panel
unset label
set title 'Deposits that a flow leaves after 1 s' noenhanced
set xlabel 'friction velocity / m s^{-1}'
set ylabel 'share that remains'
set logscale x
set xrange [0.07:6]
set xtics (0.1, 0.2, 0.5, 1, 2, 5)
set yrange [0:1.1]
set key at screen 0.55,screen low(4) + 0.15 left top Left reverse maxrows 6 font ',11'
gone(set) = 'output/removal.'.set.'.csv'
plot gone('alumina_10um') using 1:2 with points pt 7 ps 0.8 lc rgb '#d55e00' title 'alumina 10 µm on steel, measured', \
  '' using 1:3 with lines lw 2 lc rgb '#d55e00' title 'remove, γ 0.56 J/m²', \
  gone('alumina_20um') using 1:2 with points pt 5 ps 0.8 lc rgb '#5e3c99' title 'alumina 20 µm on steel, measured', \
  '' using 1:3 with lines lw 2 lc rgb '#5e3c99' title 'remove, γ 0.56 J/m²', \
  gone('graphite_11um') using 1:2 with points pt 9 ps 0.9 lc rgb '#009e73' title 'graphite 11 µm, measured', \
  '' using 1:3 with lines lw 2 lc rgb '#009e73' title 'remove, γ 0.15 J/m²'
unset multiplot
