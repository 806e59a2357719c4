# A profile and a particle on it, from the table that `asperity surface` makes for its picture: the profile, where
# the particle bridges the most, and its tilts (Altmeppen et al. 2020, figures 3 and 4).
# gnuplot -c profile.gp TABLE PICTURE [TITLE [WIDTHxHEIGHT [FROM:TO]]]
# SPDX-License-Identifier: GPL-3.0-or-later
here = ''; do for [i=1:strlen(ARG0)] { if (ARG0[i:i] eq '/') { here = ARG0[1:i] } }
array given[5] = [ARG1, ARG2, ARG3, ARG4, ARG5]
width = 960; height = 900
load here.'picture.gp'
POINTS = 5000.
set ylabel 'z / µm'
upper(k) = k == 0 ? top : k == 1 ? 0.72 * top : 0.36 * top
lower(k) = k == 2 ? bottom : upper(k + 1) + 75. / height
place = 'set tmargin at screen upper(k); set bmargin at screen lower(k)'
above = "at graph 0.5,1 center offset 0,0.7"
# The particle: center less lowest point, which is on the closing.
deepest = -1; i = 0
size(x, closed, center) = (i = i + 1, d = (i == 1 ? 1e300 : d), d = min(d, 2 * (center - closed)), \
  step = x - x_end, x_end = x, 1)
find(x, z, closed, center) = (x >= d / 2 && x <= x_end - d / 2 && closed - z > deepest) ? \
  (deepest = closed - z, x_deep = x, c_deep = center, 1) : 1
x_end = 0
stats table using (size(column('x_um'), column('closed_um'), column('center_um'))) nooutput
stats table using (find(column('x_um'), column('z_um'), column('closed_um'), column('center_um'))) nooutput
k = 0; @place
set label 1 sprintf('profile, heights stretched%s', i > POINTS ? sprintf('; one of %d points', i / POINTS + 1) : '') @above
set xlabel 'x / mm'; set xrange [0:x_end / 1000]
plot table using (column('x_um') / 1000):(column('z_um')) every int(i / POINTS) + 1 with lines ls reference lw 0.7 notitle

# To scale: 4 diameters, or more where the heights or the points of the profile need it.
k = 1; @place
half = min(max(2 * d, 4 * step), x_end / 2)
shape = (right - left) * width / ((upper(1) - lower(1)) * height)
inside(x, v) = abs(x - x_mid) <= half ? v : NaN
do for [turn=1:3] {
  x_mid = max(half, min(x_end - half, x_deep))
  @survey
  stats table using (take(inside(column('x_um'), column('z_um'))) + take(inside(column('x_um'), column('center_um')))) nooutput
  most = max(most, c_deep + d / 2)
  half = min(max(half, 0.55 * shape * (most - least)), x_end / 2)
}
y_mid = (least + most) / 2
set label 1 sprintf(deepest > 0.01 * d ? 'where a particle of %.3g µm bridges the most, to scale' : \
  'a particle of %.3g µm touches the profile, to scale: it bridges nothing', d) @above
set xlabel 'x / µm'; set xrange [x_mid - half:x_mid + half]
set yrange [y_mid - half / shape:y_mid + half / shape]
set object 1 circle at x_deep,c_deep size d / 2 front lw 2 fs empty border rgb '#009e73'
plot table using (column('x_um')):(inside(column('x_um'), column('closed_um'))) with lines ls 1 lw 4 title 'closing', \
  table using (column('x_um')):(inside(column('x_um'), column('z_um'))) with lines ls reference title 'profile', \
  table using (column('x_um')):(inside(column('x_um'), column('center_um'))) with lines ls 2 lw 1 title 'path of the center', \
  keyentry with lines ls 3 dt 1 title 'particle', \
  keyentry with boxes ls simulated fs solid 0.35 noborder title 'tilts', keyentry with lines ls guide title 'normal distribution'
unset object 1; unset key

k = 2; @place; @survey
stats table using (column('tilt_deg')) nooutput
mean = STATS_mean; sd = STATS_stddev; wide = sd / 4
set label 1 sprintf('tilts: mean %.2f°, sd %.2f°', mean, sd) @above
set xlabel 'tilt / degrees'; set ylabel 'density / (1/degree)'
set xrange [-4.5 * sd:4.5 * sd]
set boxwidth wide
@set_y
share = 1. / wide / STATS_records
plot table using (middle(column('tilt_deg'), wide)):(part(column('tilt_deg'), share)) smooth frequency \
    with boxes ls simulated fs solid 0.35 noborder notitle, \
  exp(-((x - mean) / sd) ** 2 / 2) / (sd * sqrt(2 * pi)) with lines ls guide notitle
unset multiplot
