# The table of `asperity compare`: CoR_N and CoR_T of the model as a line with a band (mean ± sd) at the places that were
# measured, and what was measured as marks on top; of impacts alone, the line.
# gnuplot -c compare.gp TABLE PICTURE [TITLE [WIDTHxHEIGHT [FROM:TO]]]
# SPDX-License-Identifier: GPL-3.0-or-later
here = ''; do for [i=1:strlen(ARG0)] { if (ARG0[i:i] eq '/') { here = ARG0[1:i] } }
array given[5] = [ARG1, ARG2, ARG3, ARG4, ARG5]
width = 960; height = 440
load here.'picture.gp'
of(t, v) = strcol('quantity') eq (t ? 'cor_t' : 'cor_n') ? v : NaN
zero(v) = is(v) ? v : 0
# A line with a band where each angle stands once; else, of several speeds or sizes, a mark for each of them.
once = 1; last = NaN
near(a) = (once = is(a) && a <= last ? 0 : once, last = is(a) ? a : last, take(of(0, column('alpha_from_deg'))), \
  take(of(0, column('alpha_to_deg'))))
@survey
stats table using (near(of(0, column('alpha1_deg')))) nooutput
first = least - 2; end = most + 2
set xlabel 'impact angle α_1 / degrees'
mean(t) = of(t, column('model_mean')); sd(t) = zero(column('model_sd'))
data_mean(t) = of(t, column('data_mean')); data_sd(t) = zero(column('data_sd'))
with_ends(v, d) = take(v - d) && take(v + d)
do for [t=0:1] {
  @survey
  stats table using (take(data_mean(t))) nooutput
  has_data = seen
  stats table using (take(mean(t))) nooutput
  if (seen == has_data) { continue }
  count = seen
  stats table using (with_ends(data_mean(t), data_sd(t))) nooutput
  stats table using (with_ends(mean(t), sd(t))) nooutput
  @set_axis
  seen = count
  stats table using (check_bar(data_mean(t) - data_sd(t), data_mean(t) + data_sd(t)), \
    check_bar(mean(t) - sd(t), mean(t) + sd(t))) nooutput
  @set_label
  @panel
  set xrange [first:end]
  angle = "table using (column('alpha1_deg')):"
  model = once ? angle."(mean(t) - sd(t)):(mean(t) + sd(t)) with filledcurves ls simulated fs transparent solid 0.2 noborder ".\
    "notitle, ".angle."(mean(t)) with linespoints ls simulated title 'model, mean ± sd'" : \
    angle."(mean(t)):(sd(t)) with yerrorbars ls simulated title 'model, mean ± sd'"
  marks = angle."(data_mean(t)):(data_sd(t)) with yerrorbars ls data title 'measured, mean ± sd'"
  eval 'plot '.model.(has_data ? ', '.marks : '')
  unset key
}
unset multiplot
