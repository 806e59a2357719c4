# The table of `asperity trade`: mean time per impact over all angles against the worst D_{KL} of the rebound angle, with
# its standard error. The line joins the models that no other beats in both.
# gnuplot -c trade.gp TABLE PICTURE [TITLE [WIDTHxHEIGHT [FROM:TO]]]
# SPDX-License-Identifier: GPL-3.0-or-later
here = ''; do for [i=1:strlen(ARG0)] { if (ARG0[i:i] eq '/') { here = ARG0[1:i] } }
array given[5] = [ARG1, ARG2, ARG3, ARG4, ARG5]
width = 900; height = 560
load here.'picture.gp'
set tmargin at screen legend - 78. / height
NOISE = 1e-4 # the rays resolve no less
models = ''
stats table using (models = add(models, strcol('model')), column('alpha1_deg')) nooutput
count = words(models)
array cost[count]; array worst[count]; array se[count]; array n[count]
do for [m=1:count] { cost[m] = 0; n[m] = 0; worst[m] = -1; se[m] = 0 }
index_of(name) = words(models[1:strstrt(' '.models, ' '.name.' ') + strlen(name) - 1])
take(m, time, kl, error) = (n[m] = n[m] + 1, cost[m] = cost[m] + time, \
  se[m] = kl > worst[m] ? error : se[m], worst[m] = max(worst[m], kl), kl)
stats table using (take(index_of(strcol('model')), column('ns_per_impact'), column('kl_rebound'), column('kl_rebound_se'))) nooutput
do for [m=1:count] { cost[m] = cost[m] / n[m]; worst[m] = max(worst[m], NOISE) }
best(c, m) = m < 1 ? NaN : better(best(c, m - 1), cost[m] <= c ? worst[m] : NaN)
better(a, b) = !is(a) ? b : !is(b) ? a : min(a, b)
c_least = cost[1]; c_most = cost[1]; least = worst[1]; most = worst[1]
do for [m=2:count] {
  c_least = min(c_least, cost[m]); c_most = max(c_most, cost[m]); least = min(least, worst[m]); most = max(most, worst[m])
}
set xrange [c_least / 1.2:c_most * 1.2]
if (strlen(range)) { set yrange [low(range):high(range)] } else { set yrange [least / 2:most * 2] }
set logscale xy
set xtics (50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000, 50000)
set samples 2000
set xlabel 'mean time per impact / ns'; set ylabel 'worst D_KL of the rebound angle, ± s.e.'
plot best(x, count) with lines ls guide title 'Pareto front', \
  for [m=1:count] '+' using (cost[m]):(worst[m]):(max(worst[m] - se[m], NOISE / 10)):(worst[m] + se[m]) every ::0::0 \
    with yerrorbars ls value('model_'.word(models, m)) dt 1 title word(models, m)
unset multiplot
