# The table of `asperity compare`: CoR_N and CoR_T of the model as boxes (mean ± sd) at each place that was measured, and
# what was measured as marks; of impacts alone, the boxes.
# gnuplot -c compare.gp TABLE PICTURE [TITLE [WIDTHxHEIGHT [FROM:TO]]]
# SPDX-License-Identifier: GPL-3.0-or-later
here = ''; do for [i=1:strlen(ARG0)] { if (ARG0[i:i] eq '/') { here = ARG0[1:i] } }
array given[5] = [ARG1, ARG2, ARG3, ARG4, ARG5]
width = 960; height = 440
load here.'picture.gp'
of(t, v) = strcol('quantity') eq (t ? 'cor_t' : 'cor_n') ? v : NaN
zero(v) = is(v) ? v : 0
# Half the width of a box: not over its neighbor.
half = 1.5; last = NaN
near(a) = (half = a - last > 0 ? min(half, 0.45 * (a - last)) : half, last = a, take(of(0, column('alpha_from_deg'))), \
  take(of(0, column('alpha_to_deg'))))
@survey
stats table using (near(of(0, column('alpha1_deg')))) nooutput
first = least - 2; end = most + 2
set xlabel 'impact angle α_1 / degrees'
from(t) = column('alpha_to_deg') - column('alpha_from_deg') > 2 * half ? column('alpha_from_deg') : column('alpha1_deg') - half
to(t) = column('alpha_to_deg') - column('alpha_from_deg') > 2 * half ? column('alpha_to_deg') : column('alpha1_deg') + half
mean(t) = of(t, column('model_mean')); sd(t) = zero(column('model_sd'))
do for [t=0:1] {
  @survey
  stats table using (take(of(t, column('data_mean')))) nooutput
  has_data = seen
  stats table using (take(of(t, column('model_mean')))) nooutput
  if (seen == has_data) { continue }
  @set_axis
  stats table using (check(of(t, column('data_mean'))), check(of(t, column('model_mean')))) nooutput
  @set_label
  @panel
  set xrange [first:end]
  boxes = "table using (column('alpha1_deg')):(mean(t)):(from(t)):(to(t)):(mean(t) - sd(t)):(mean(t) + sd(t)) ".\
    "with boxxyerror ls simulated fs transparent solid 0.25 noborder notitle, table using (from(t)):(mean(t)): ".\
    "(to(t) - from(t)):(0) with vectors nohead ls simulated title 'model, mean ± sd'"
  marks = "table using (column('alpha1_deg')):(of(t, column('data_mean'))):(zero(column('data_sd'))) ".\
    "with yerrorbars ls data title 'measured, mean ± sd'"
  eval 'plot '.boxes.(has_data ? ', '.marks : '')
  unset key
}
unset multiplot
