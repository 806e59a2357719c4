# Figures 6 to 9 of the paper, from the tables of weibull_fit (output/7.csv, output/8.csv) and of asperity spread.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set datafile separator comma
set term pngcairo noenhanced size 1200,480 font 'sans,11'

# The baseline's samples as a histogram in bins of half a degree, and densities over it.
bin(v) = 0.5 * floor(2 * v) + 0.25
table(model, angle) = 'output/9_'.model.'_'.angle.'.csv'
do for [figure in "6 9"] {
  models = figure eq '6' ? 'effective' : 'effective truncated weibull'
  set output 'output/figure_'.figure.'.png'
  set multiplot layout 1,3 title "Densities against the baseline\n"
  set xlabel 'tilt Δα / degrees'; set ylabel 'density / (1/degree)'
  set xrange [-3.5 * sigma:4 * sigma]; set yrange [0:*]
  do for [angle in "1 45 90"] {
    set title sprintf('α_1 = %s°, σ = %.4g°', angle, sigma)
    set arrow 1 from -angle / 2., graph 0 to -angle / 2., graph 1 nohead lc rgb '#999999' dt 3
    plot table('rejection', angle) using (bin(column('delta_alpha_deg'))):(2e-5) smooth frequency \
        with boxes ls model_rejection fs solid 0.35 noborder title 'baseline', \
      for [m in models] table(m, angle) using 'delta_alpha_deg':'density_per_deg' \
        with lines ls value('model_'.m) title m
  }
  unset multiplot
}
unset arrow 1; unset title

set output 'output/figure_7.png'
set multiplot layout 1,2 title "Weibull fits to the baseline\n"
set xlabel 'α_1 / σ'; set xrange [0:10]; set yrange [*:*]
at(s, v) = column('sigma_deg') == s ? v : NaN
do for [q in "k lambda"] {
  set ylabel q eq 'k' ? 'k' : 'λ / σ'
  plot for [s=5:15:5] 'output/7.csv' using 'tau':(at(s, column(q eq 'k' ? 'k' : 'lambda_over_sigma'))) \
      with points ls (s / 5) ps 0.6 title sprintf('σ = %d°', s), \
    'output/7.csv' using 'tau':(at(5, column(q.'_polynomial'))) with lines ls reference title 'polynomial', \
    x > 6.48 ? (q eq 'k' ? 3.602 : 3.5955) : NaN with lines ls reference dt 2 title 'constant'
}
unset multiplot

set term pngcairo noenhanced size 800,480 font 'sans,11'
set output 'output/figure_8.png'
noise = 2e-6 # less than that the samples cannot tell
set title sprintf("Models against the baseline, σ = %.4g°\n", sigma)
set xlabel 'impact angle α_1 / degrees'; set ylabel 'D_KL of the baseline against the density'
set xrange [0:90]; set yrange [noise / 2:10]; set logscale y; set format y '%g'
plot for [m in "normal effective truncated weibull"] 'output/8.csv' \
  using 'alpha1_deg':(column('kl_'.m) > noise ? column('kl_'.m) : noise) with lines ls value('model_'.m) title m
