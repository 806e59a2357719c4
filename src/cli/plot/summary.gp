# The table of `asperity cor --summary`: mean and sd of CoR_N and CoR_T over the impact angle, of one angle over the
# diameter or the speed; a line for each wall condition.
# gnuplot -c summary.gp TABLE PICTURE [TITLE [WIDTHxHEIGHT [FROM:TO]]]
# SPDX-License-Identifier: GPL-3.0-or-later
here = ''; do for [i=1:strlen(ARG0)] { if (ARG0[i:i] eq '/') { here = ARG0[1:i] } }
array given[5] = [ARG1, ARG2, ARG3, ARG4, ARG5]
width = 960; height = 440
load here.'picture.gp'
over = 'alpha1_deg'; label = 'impact angle α_1 / degrees'
@survey; stats table using (take(column(over))) nooutput
if (!(most > least)) { over = 'dp_um'; label = 'diameter d_p / µm'; @survey; stats table using (take(column(over))) nooutput }
if (!(most > least)) { over = 'v1_m_s'; label = 'impact speed v_1 / (m/s)'; @survey; stats table using (take(column(over))) nooutput }
room = most > least ? 0.03 * (most - least) : 0.1 * most
from = least - room; to = most + room
# A group: the diameter and the speed, as written, without what is on the axis.
group(d, v) = (over eq 'dp_um' ? '' : d).','.(over eq 'v1_m_s' ? '' : v)
groups = ''
stats table using (groups = add(groups, group(strcol('dp_um'), strcol('v1_m_s'))), column('alpha1_deg')) nooutput
hits = 0
stats table using (hits = hits + column('impacts'), stuck = stuck + column('impacts') * column('capture_share'), 1) nooutput
part_of(g, k) = k == 1 ? g[1:strstrt(g, ',') - 1] : g[strstrt(g, ',') + 1:*]
text(g) = (strlen(part_of(g, 1)) ? part_of(g, 1).' µm ' : '').(strlen(part_of(g, 2)) ? part_of(g, 2).' m/s' : '')
with_group(g, v) = group(strcol('dp_um'), strcol('v1_m_s')) eq g ? v : NaN
name(t) = t ? 'cor_t' : 'cor_n'
mean_of(t) = column(name(t).'_mean'); sd_of(t) = is(column(name(t).'_sd')) ? column(name(t).'_sd') : 0
set xlabel label
@set_stuck
do for [t=0:1] {
  @survey
  stats table using (take(column(name(t).'_mean'))) nooutput
  if (seen == 0) { continue }
  @panel
  @set_axis
  stats table using (check_bar(mean_of(t) - sd_of(t), mean_of(t) + sd_of(t))) nooutput
  @set_label
  set ylabel cor(t).', mean ± sd'; set xrange [from:to]
  plot for [i=1:words(groups)] table using (column(over)):(with_group(word(groups, i), column(name(t).'_mean'))):(column(name(t).'_sd')) \
    with yerrorlines ls ((i - 1) % 6 + 1) ps 0.7 title text(word(groups, i))
  unset key; unset label 2
}
@set_all_stuck
unset multiplot
