# The table of `asperity cor --capture`: the share that sticks over diameter and speed.
# gnuplot -c capture.gp TABLE PICTURE [TITLE [WIDTHxHEIGHT]]
# SPDX-License-Identifier: GPL-3.0-or-later
here = ''; do for [i=1:strlen(ARG0)] { if (ARG0[i:i] eq '/') { here = ARG0[1:i] } }
array given[5] = [ARG1, ARG2, ARG3, ARG4, ARG5]
width = 800; height = 600
load here.'picture.gp'
stats table using (column('alpha1_deg')) nooutput
set label 1 sprintf(STATS_min < 90 ? 'impact angle %g°' : 'normal impact, %g°', STATS_min) at graph 0.5,1 center offset 0,0.7
stats table using (column('v1_m_s')) nooutput
rows = int(STATS_records); first = STATS_min
stats table using (column('v1_m_s') == first ? 1 : NaN) nooutput
sizes = int(STATS_records)
array size[rows]; array speed[rows]
i = 0
stats table using (i = i + 1, size[i] = column('dp_um'), speed[i] = column('v1_m_s'), 1) nooutput
# Edges of a cell between values in equal ratios; `step` rows further is the next value.
size_at(i, k) = (i + k >= 1 && i + k <= rows && size[i + k] * k > size[i] * k) ? size[i + k] : NaN
speed_at(i, k) = (i + k * sizes >= 1 && i + k * sizes <= rows) ? speed[i + k * sizes] : NaN
to(a, b, c) = is(b) ? sqrt(a * b) : is(c) ? a * sqrt(a / c) : NaN
wide = 1.1
# Cells reach under the next ones, so that no seams show.
OVER = 1.05
other(v, a, k) = is(v) ? v : a * wide ** k
size_edge(i, k) = other(to(size[i], size_at(i, k), size_at(i, -k)), size[i], k)
speed_edge(i, k) = other(to(speed[i], speed_at(i, k), speed_at(i, -k)), speed[i], k)
set logscale xy
set xrange [size_edge(1, -1):size_edge(rows, 1)]
set yrange [speed_edge(1, -1):speed_edge(rows, 1)]
if (sizes < 10) { set xtics (size[1]); do for [i=2:sizes] { set xtics add (size[i]) } }
if (rows / sizes < 10) { set ytics (speed[1]); do for [i=1:rows:sizes] { set ytics add (speed[i]) } }
set rmargin at screen 1 - 110. / width
set palette defined (0 '#fcfdbf', 0.3 '#fb8861', 0.65 '#b63679', 1 '#3b0f70')
set cbrange [0:1]; set cblabel 'share that sticks'
set xlabel 'diameter d_p / µm'; set ylabel 'impact speed v_1 / (m/s)'
i = 0
plot table using (i = i + 1, size[i]):(speed[i]):(size_edge(i, -1)):(size_edge(i, 1) * OVER):(speed_edge(i, -1)): \
  (speed_edge(i, 1) * OVER):(column('capture_share')) with boxxyerror fs solid noborder lc palette notitle
unset multiplot
