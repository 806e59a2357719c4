# Samples of `asperity spread`, as a histogram in bins of a third of their sd, at most a degree; of --pdf, the density.
# gnuplot -c spread.gp TABLE PICTURE [TITLE [WIDTHxHEIGHT [FROM:TO]]]
# SPDX-License-Identifier: GPL-3.0-or-later
here = ''; do for [i=1:strlen(ARG0)] { if (ARG0[i:i] eq '/') { here = ARG0[1:i] } }
array given[5] = [ARG1, ARG2, ARG3, ARG4, ARG5]
width = 800; height = 500
load here.'picture.gp'
stats table using (column('delta_alpha_deg')) nooutput
wide = max(STATS_stddev / 3, 1e-6); wide = min(wide, 1)
share = 1. / STATS_records / wide
set xrange [STATS_min - wide:STATS_max + wide]
samples_text = sprintf('%d samples', STATS_records)
@set_y
set xlabel 'tilt Δα / degrees'; set ylabel 'density / (1/degree)'
columns = 0
stats table using (columns = valid(2) ? 2 : columns, 1) nooutput
set boxwidth wide
if (columns > 1) {
  plot table using (column('delta_alpha_deg')):2 with lines ls simulated title 'density'
} else {
  plot table using (middle(column('delta_alpha_deg'), wide)):(share) smooth frequency with boxes ls simulated \
    fs solid 0.35 noborder title samples_text
}
unset multiplot
