# How deep the dust wears the blade: maps of the smooth and of the rough wall, and the pressure side over the chord.
# SPDX-License-Identifier: GPL-3.0-or-later
set term pngcairo size 1260,430 font 'sans,11'
set output 'output/erosion.png'
set border lc rgb '#444444'
set tics nomirror
set palette defined (0 '#f2f2f2', 0.15 '#fee6ce', 0.4 '#fdae6b', 0.7 '#e6550d', 1 '#7f2704')
set pm3d corners2color c1
set multiplot title "Wear of Ti-6Al-4V by quartz dust at 150 m/s, by Oka's law"
do for [k=0:1] {
  left = 0.045 + 0.335 * k
  set lmargin at screen left; set rmargin at screen left + 0.235; set bmargin at screen 0.14; set tmargin at screen 0.82
  set xrange [-0.25:1]; set yrange [0:16]; set cbrange [0:0.5]
  set xtics 0.25; set ytics 4
  set xlabel '{/*0.9 suction side ←}  position along the chord  {/*0.9 → pressure side}' offset 0,0.4
  if (k == 0) { set ylabel 'span / mm' offset 1,0 } else { unset ylabel }
  set title k == 0 ? 'smooth wall: depth / nm' : 'rough wall, by the faces (tilted): depth / nm'
  set view map
  set colorbox user origin screen left + 0.243, screen 0.14 size screen 0.009, screen 0.68
  unset key
  set cbtics 0.1 add ('≥ 0.5' 0.5)
  splot 'output/'.(k == 0 ? 'smooth' : 'tilted').'.worn' using 1:2:3 with pm3d
}
unset colorbox; unset view
set lmargin at screen 0.735; set rmargin at screen 0.985
set xrange [0:1]; set yrange [0:0.6]; set ytics 0.1
set grid lc rgb '#dddddd' lw 0.5
set xlabel 'position along the chord, pressure side'; unset ylabel
set title "mean depth over the span / nm"
set key at graph 0.1,0.97 left top Left reverse font ',10'
plot 'output/smooth.wear' using 1:2 with lines lw 2 lc rgb '#888888' title 'smooth', \
     'output/rough.wear' using 1:2 with linespoints pt 7 ps 0.6 lw 2 lc rgb '#0072b2' title 'rough, mean wall', \
     'output/tilted.wear' using 1:2 with linespoints pt 5 ps 0.6 lw 2 lc rgb '#d55e00' title 'rough, faces (tilted)'
unset multiplot
