# Measurements and what the laws make of them, from the tables of `asperity compare`: sand, single spheres, deposits.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1200,520 font 'sans,15'
set datafile separator ','
set xrange [-2:92]
set xtics 15
set xlabel 'impact angle / degrees'
set key vertical Left reverse font ',14' samplen 2

# The columns of asperity compare, and its rows of one coefficient.
angle = 2; mean = 8; measured = 13; measured_sd = 15
y(coefficient, v) = strcol(1) eq coefficient ? v : NaN
gt(model) = 'output/grant_tabakoff_1975.'.model.'.csv'
kh(model) = 'output/kharaz_2001.'.model.'.csv'

set output 'output/against_measurements.png'
set multiplot layout 1,2 title 'Grant \& Tabakoff 1975, sand on Al 2024'
set yrange [0:1.2]
do for [i=1:2] {
  of = word('cor_n cor_t', i)
  set ylabel word('CoR_N CoR_T', i)
  if (i == 1) { set key inside right top } else { unset key }
  plot gt('shipped') using angle:(y(of, column(measured))):(y(of, column(measured_sd))) with yerrorbars ls data title 'measured ± sd', \
    gt('shipped') using angle:(y(of, column(mean))) with lines ls law_bons dt 3 title 'bons, as shipped', \
    gt('fitted_normal') using angle:(y(of, column(mean))) with lines ls law_bons title 'bons, fitted', \
    gt('thornton_ning') using angle:(y(of, column(mean))) with lines ls law_thornton_ning title 'thornton\_ning', \
    gt('forder') using angle:(y(of, column(mean))) with lines ls law_table title 'table: Forder et al.'
}
unset multiplot

set output 'output/spheres.png'
set multiplot layout 1,2 title 'Kharaz et al. 2001, 5 mm alumina on glass'
set ylabel 'CoR_T'
set yrange [0.5:1.1]
set key inside left bottom
plot kh('walton') using angle:(y('cor_t', column(measured))) with points ls data title 'measured', \
  kh('walton') using angle:(y('cor_t', column(mean))) with lines ls law_walton title 'walton, as measured', \
  kh('walton_compliance') using angle:(y('cor_t', column(mean))) with lines ls law_walton dt 2 title '… compliance 0.7', \
  kh('bons') using angle:(y('cor_t', column(mean))) with lines ls law_bons dt 3 title 'bons with that µ', \
  kh('bons_fitted') using angle:(y('cor_t', column(mean))) with lines ls law_bons title 'bons, µ fitted'
spins(model) = 'output/kharaz_spin.'.model.'.csv'
curve(model) = 'output/kharaz_spin.'.model.'.curve'
of(kind, quantity, v) = (strcol(1) eq kind && strcol(2) eq quantity) ? v : NaN
set ylabel 'spin after the impact / rad s^{-1}'
set key inside left top
set yrange [0:700]
plot spins('walton') using (90 - $3):(of('experiment', 'spin', $4)) with points ls data notitle, \
  spins('walton') using (90 - $3):(of('reference', 'spin', $4)) with points ls data pt 6 ps 1.1 title 'test 4 of Chung \& Ooi', \
  curve('walton') using (90 - $3):(of('curve', 'spin', $5)) with lines ls law_walton notitle, \
  curve('walton_compliance') using (90 - $3):(of('curve', 'spin', $5)) with lines ls law_walton dt 2 notitle
unset multiplot

set output 'output/scatter.png'
set multiplot layout 1,2
set title 'LaMarche et al. 2022, 3.1 mm glass on acrylic'
set xlabel 'CoR_N'
set ylabel 'share below'
set xrange [0.6:1.02]
set xtics 0.1
set yrange [0:1]
set key inside left top
stats 'output/lamarche.measured' nooutput
n = STATS_records
stats 'output/lamarche.rough' nooutput
m = STATS_records
plot 'output/lamarche.measured' using 1:(($0 + 0.5) / n) with steps ls data title 'measured', \
  'output/lamarche.rough' using 1:(($0 + 0.5) / m) with steps ls law_walton title 'walton, σ 6.2°, e 0.994', \
  '-' using 1:2 with lines ls law_walton dt 2 title 'walton, smooth, e 0.955'
0.955,0
0.955,1
e
set title 'Deposits that a flow leaves after 1 s'
set xlabel 'friction velocity / m s^{-1}'
set ylabel 'share that remains'
set logscale x
set xrange [0.07:6]
set xtics (0.1, 0.2, 0.5, 1, 2, 5)
set yrange [0:1.1]
set key inside right top
gone(set) = 'output/removal.'.set.'.csv'
plot gone('alumina_10um') using 1:2 with points pt 7 ps 0.8 lc rgb '#d55e00' title 'alumina 10 µm', \
  '' using 1:3 with lines lw 2 lc rgb '#d55e00' title 'remove', \
  gone('alumina_20um') using 1:2 with points pt 5 ps 0.8 lc rgb '#5e3c99' title 'alumina 20 µm', \
  '' using 1:3 with lines lw 2 lc rgb '#5e3c99' title 'remove', \
  gone('graphite_11um') using 1:2 with points pt 9 ps 0.9 lc rgb '#009e73' title 'graphite 11 µm', \
  '' using 1:3 with lines lw 2 lc rgb '#009e73' title 'remove'
unset multiplot
