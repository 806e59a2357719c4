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
size(d) = 0.2 + 0.07 * d
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
  set title title_of(k).":\ndeposits, size as the grain" offset 0,2.1
  set key at graph 1,1.01 bottom right vertical maxrows 2 samplen 1 width -2 spacing 1.25 font ',10'
  plot 'output/'.map_of(k).'.deposits' using ($4 == 1 ? $1 : NaN):2:(size($3)) with points pt 6 ps variable lc rgb '#0072b2' title 'first impact', \
       '' using ($4 > 1 ? $1 : NaN):2:(size($3)) with points pt 6 ps variable lc rgb '#d55e00' title 'later impact', \
       for [d in "2 10 50"] keyentry with points pt 6 ps size(d) lc rgb '#666666' title d.' µm'
  unset key
}

# The blade's sections, and the flow
set lmargin at screen 0.71; set rmargin at screen 0.97; set bmargin at screen 0.765; set tmargin at screen 0.905
set xrange [-8:8]; set yrange [-2.4:2.8]; set xtics 4; set ytics 2
set size ratio -1
set xlabel 'x / mm' offset 0,0.6; set ylabel 'z / mm' offset 0,0
set title 'blade at hub (light), mid-span, tip (dark); flow' offset 0,-0.4
set arrow 1 from -7.8,-2.2 to -5.6,-1.29 head size 0.4,25 filled lc rgb '#888888' lw 2
section(span) = sprintf("< awk '$4 == %g { print $3, $5; next } !NF' output/rough.map", span)
plot section(0) using 1:2 with lines lw 2 lc rgb '#9cc3e6' notitle, \
     section(8) using 1:2 with lines lw 2 lc rgb '#0072b2' notitle, \
     section(16) using 1:2 with lines lw 2 lc rgb '#0b2a55' notitle
unset arrow 1; set size noratio

# Impact energy, unrolled
set lmargin at screen 0.71; set rmargin at screen 0.925; set bmargin at screen 0.415; set tmargin at screen 0.64
set xrange [-0.25:1]; set yrange [0:16]; set cbrange [0:120]
set xtics 0.25; set ytics 4
set xlabel 'position along the chord' offset 0,0.4; set ylabel 'span / mm' offset 0,0
set title "rough wall: impact energy / µJ per mm^2"
set view map
set colorbox user origin screen 0.933, screen 0.415 size screen 0.009, screen 0.225
set cbtics 30 add ('≥ 120' 120)
splot 'output/rough.map' using 1:2:8 with pm3d
unset view

# Over the chord
set border lc rgb '#444444'
unset colorbox
set lmargin at screen 0.71; set rmargin at screen 0.97; set bmargin at screen 0.08; set tmargin at screen 0.29
set xrange [0:1]; set yrange [0:1500]; set xtics 0.25; set ytics 300
set grid lt 1 lc rgb '#e0e0e0' lw 1
set xlabel 'position along the chord, pressure side' offset 0,0; unset ylabel
set title 'pressure side: impacts per 1/20 of the chord'
set key at graph 0.05,0.97 left top Left reverse maxrows auto spacing 1.1 samplen 2 width 0 font ',10'
plot 'output/smooth.chord' using 1:2 with lines ls guide dt 1 title 'first impacts, the same on both', \
     'output/smooth.chord' using 1:3 with linespoints ls wall_smooth title 'later impacts, smooth', \
     'output/rough.chord' using 1:3 with linespoints ls wall_rough title 'later impacts, rough'
unset multiplot
