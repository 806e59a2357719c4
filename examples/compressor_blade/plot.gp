# Impacts and deposits on the blade: unrolled maps of both walls, a view of the rough one, and the pressure side's
# impacts over the chord.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1260,764 font 'sans,11'
set output 'output/compressor_blade.png'
unset grid
set palette defined (0 '#f2f2f2', 0.15 '#c6dbef', 0.4 '#6baed6', 0.7 '#2171b5', 1 '#08306b')
set pm3d corners2color c1
set cblabel font ',10'
set multiplot title 'Quartz dust, 1–100 µm, at 150 m/s on a compressor blade: two LIGGGHTS runs without the air'
map_of(k) = k == 0 ? 'smooth' : 'rough'
title_of(k) = k == 0 ? 'smooth wall' : 'rough wall, R_q 5 µm, λ_c 60 µm'

do for [k=0:1] {
  low = k == 0 ? 0.53 : 0.05
  # impacts, unrolled
  set lmargin at screen 0.045; set rmargin at screen 0.29; set bmargin at screen low + 0.03; set tmargin at screen low + 0.315
  set xrange [-0.25:1]; set yrange [0:16]; set cbrange [0:240]
  set xtics 0.25; set ytics 4
  set xlabel '{/*0.9 suction side ←}  position along the chord  {/*0.9 → pressure side}' offset 0,0.4
  set ylabel 'span / mm' offset 1,0
  set title title_of(k).":\nimpacts per mm^2" offset 0,0.6
  set view map
  set colorbox user origin screen 0.298, screen low + 0.03 size screen 0.009, screen 0.285
  unset key
  set cbtics 60 add ('≥ 240' 240)
  splot 'output/'.map_of(k).'.map' using 1:2:6 with pm3d
  # deposits
  set lmargin at screen 0.385; set rmargin at screen 0.63
  unset colorbox; set xrange [-0.25:1.12]; set yrange [-2.2:18.4]
  set title title_of(k).":\ndeposits, size as the grain" offset 0,1.7
  set key at graph 1,1.01 bottom right horizontal samplen 1 width -2 font ',10'
  plot 'output/'.map_of(k).'.deposits' using ($4 == 1 ? $1 : NaN):2:(0.25 + 0.18 * $3) with points pt 6 ps variable lc rgb '#0072b2' title 'first impact', \
       '' using ($4 > 1 ? $1 : NaN):2:(0.25 + 0.18 * $3) with points pt 6 ps variable lc rgb '#d55e00' title 'later impact', \
       keyentry with points pt 6 ps 0.25 + 0.18 * 2 lc rgb '#666666' title '2 µm', \
       keyentry with points pt 6 ps 0.25 + 0.18 * 8 lc rgb '#666666' title '8 µm'
  unset key
}

# The blade, seen from the pressure side
set lmargin at screen 0.66; set rmargin at screen 0.97; set bmargin at screen 0.50; set tmargin at screen 0.90
set view 140, 15, 1.75, 1
set view equal xyz
set xrange [-6.5:6.5]; set yrange [0:16]; set zrange [-4:4]; set cbrange [0:120]
unset border; unset xtics; unset ytics; unset ztics; unset xlabel; unset ylabel
set colorbox user origin screen 0.94, screen 0.58 size screen 0.009, screen 0.3
set title "rough wall, pressure side (span 16 mm, chord 12 mm):\nimpact energy / µJ per mm^2" offset 0,1
set pm3d depthorder
set cbtics 20 add ('≥ 120' 120)
splot 'output/rough.map' using ($1 > -0.005 ? $3 : NaN):4:5:8 with pm3d
unset view

# Over the chord
set border lc rgb '#444444'
unset colorbox
set lmargin at screen 0.71; set rmargin at screen 0.97; set bmargin at screen 0.08; set tmargin at screen 0.405
set xrange [0:1]; set yrange [0:1500]; set xtics 0.25; set ytics 300
set grid lt 1 lc rgb '#e0e0e0' lw 1
set xlabel 'position along the chord, pressure side'; unset ylabel
set title 'pressure side: impacts per 1/20 of the chord'
set key at graph 0.05,0.97 left top Left reverse font ',10'
plot 'output/smooth.chord' using 1:2 with lines ls guide dt 1 title 'first impacts, the same on both', \
     'output/smooth.chord' using 1:3 with linespoints ls wall_smooth title 'later impacts, smooth', \
     'output/rough.chord' using 1:3 with linespoints ls wall_rough title 'later impacts, rough'
unset multiplot
