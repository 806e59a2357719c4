# Impacts of `asperity cor`, or of a wall's ledger: CoR_N and CoR_T over the impact angle, with mean and sd in bins of two
# degrees; of a single angle, how often they are (Altmeppen et al. 2020, figures 13 and 14).
# gnuplot -c cor.gp TABLE PICTURE [TITLE [WIDTHxHEIGHT [FROM:TO]]]
# SPDX-License-Identifier: GPL-3.0-or-later
here = ''; do for [i=1:strlen(ARG0)] { if (ARG0[i:i] eq '/') { here = ARG0[1:i] } }
array given[5] = [ARG1, ARG2, ARG3, ARG4, ARG5]
width = 960; height = 440
load here.'picture.gp'
POINTS = 20000.; BIN = 2; BINS = 46; LEAST = 10
array n[BINS]; array total[BINS]; array squares[BINS]; array angles[BINS]
name(t) = t ? 'cor_t' : 'cor_n'
bin(a) = int(a / BIN) + 1
count(a, y) = (is(a) && is(y)) ? (n[bin(a)] = n[bin(a)] + 1, total[bin(a)] = total[bin(a)] + y, \
  squares[bin(a)] = squares[bin(a)] + y * y, angles[bin(a)] = angles[bin(a)] + a, y) : NaN
mean(i) = n[i] >= LEAST ? total[i] / n[i] : NaN # of fewer impacts none
sd(i) = n[i] >= LEAST ? sqrt(max(0, squares[i] - n[i] * mean(i) ** 2) / (n[i] - 1)) : NaN
stats table using (column('alpha1_deg')) nooutput
from = STATS_min; to = STATS_max
single = to - from < 0.01
hits = STATS_records
stats table using (stuck = stuck + (strcol('outcome') ne 'rebound' && strcol('outcome') ne '0'), column('alpha1_deg')) nooutput
thin = int(STATS_records / POINTS) + 1
@set_stuck
if (single) { set label 2 offset 0,1.9 } # above the mean
do for [t=0:1] {
  do for [i=1:BINS] { n[i] = 0; total[i] = 0; squares[i] = 0; angles[i] = 0 }
  @survey
  stats table using (take(count(column('alpha1_deg'), column(name(t))))) nooutput
  if (seen == 0) { continue }
  @panel
  if (single) {
    share = 1. / seen
    stats table using (column(name(t))) nooutput
    wide = max(max((most - least) / 40, STATS_stddev / 3), 1e-6)
    room = max(wide, STATS_stddev > 1e-6 ? 0 : 0.05)
    set label 1 sprintf('α_1 = %g°: ', from).(room > wide ? sprintf('all %.3g', STATS_mean) : seen < LEAST ? \
      sprintf('%d rebounds', seen) : sprintf('mean %.3g ± %.2g', STATS_mean, STATS_stddev)) at graph 0.5,1 center offset 0,0.7
    set xlabel cor(t); set ylabel 'share of the rebounds'; set xrange [least - room:most + room]
    @set_y
    set boxwidth wide
    if (room > wide) {
      set yrange [0:1]
      set arrow 1 from STATS_mean,0 to STATS_mean,1 nohead ls simulated
      plot 0 notitle
      unset arrow 1
    } else {
      plot table using (middle(column(name(t)), wide)):(part(column(name(t)), share)) smooth frequency \
        with boxes ls simulated fs solid 0.35 noborder notitle
    }
  } else {
    @set_axis
    stats table using (check(column(name(t)))) nooutput
    @set_label
    means = sum [i=1:BINS] (n[i] >= LEAST)
    set xlabel 'impact angle α_1 / degrees'
    set xrange [from - 0.03 * (to - from):to + 0.03 * (to - from)]
    dots = "table using (column('alpha1_deg')):(column(name(t))) every thin with points ls impacts notitle, ".\
      "keyentry with points ls impacts ps 0.8 title (thin > 1 ? sprintf('impacts, one of %d', thin) : 'impacts')"
    curve = "n using (angles[$1] / n[$1]):(mean($1) - sd($1)):(mean($1) + sd($1)) ".\
      "with filledcurves ls simulated fs transparent solid 0.2 noborder notitle, ".\
      "n using (angles[$1] / n[$1]):(mean($1)) with lines ls simulated title 'mean ± sd'"
    eval 'plot '.dots.(means > 0 ? ', '.curve : '')
  }
  unset key; unset label 2
}
@set_all_stuck
unset multiplot
