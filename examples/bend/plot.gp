# What dust does in the bend: maps of wear and deposits on the outer wall, their means over its width, and how fast the
# grains leave.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1260,860 font 'sans,11'
set output 'output/bend.png'
set multiplot title 'Quartz dust of 1–100 µm in air at 30 m/s in a bend of 90°, by OpenFOAM: the outer wall, unrolled'
set palette defined (0 '#f2f2f2', 0.15 '#fee6ce', 0.4 '#fdae6b', 0.7 '#e6550d', 1 '#7f2704')
set style fill solid 1 noborder
set cblabel font ',10'
unset key; unset grid
set arrow 1 from 0,graph 0 to 0,graph 1 nohead lc rgb '#444444' front
set arrow 2 from 196.35,graph 0 to 196.35,graph 1 nohead lc rgb '#444444' front
name(k) = k == 0 ? 'smooth' : 'measured'
wall(k) = k == 0 ? 'smooth wall' : 'measured wall, R_q 8 µm, λ_c 50 µm'
set xrange [-250:396]; set yrange [-25:25]; set xtics -200,100,300; set ytics -20,20,20
do for [k=0:1] {
  top = 0.955 - 0.235 * k
  set bmargin at screen top - 0.165; set tmargin at screen top - 0.035
  set lmargin at screen 0.05; set rmargin at screen 0.45
  set colorbox user origin screen 0.458, screen top - 0.165 size screen 0.009, screen 0.13
  if (k == 1) { set xlabel 'way along the outer wall / mm; the bend is between the lines' offset 0,0.4 }
  set ylabel 'across / mm' offset 1,0
  set title wall(k).': wear / µm per kg of dust' offset 0,-0.5
  set cbrange [0:1]; set cbtics 0.25 add ('≥ 1' 1)
  plot 'output/'.name(k).'.map' using 1:2:3:4:5 with boxxyerror fc palette
  set lmargin at screen 0.55; set rmargin at screen 0.94
  set colorbox user origin screen 0.948, screen top - 0.165 size screen 0.009, screen 0.13
  unset ylabel
  set title wall(k).': deposits / kg per m^2 and kg of dust' offset 0,-0.5
  set cbrange [0:16]; set cbtics 4 add ('≥ 16' 16)
  plot 'output/'.name(k).'.map' using 1:2:3:4:6 with boxxyerror fc palette
}
unset colorbox
set grid lt 1 lc rgb '#e0e0e0' lw 1
set bmargin at screen 0.08; set tmargin at screen 0.40
set key at graph 0.02,0.97 left top Left reverse font ',10' samplen 1.5
set ytics auto
set xlabel 'way along the outer wall / mm' offset 0,0.4
do for [k=0:1] {
  set lmargin at screen 0.045 + 0.34 * k; set rmargin at screen 0.31 + 0.34 * k
  set yrange [0:k == 0 ? 1.1 : 22]
  set title k == 0 ? 'mean wear over the width / µm per kg' : 'mean deposits over the width / kg per m^2 and kg'
  plot 'output/smooth.profile' using 1:(column(2 + k)) with lines ls wall_smooth title 'smooth', \
    'output/rough.profile' using 1:(column(2 + k)) with lines ls wall_rough title 'R_q 2 µm, λ_c 50 µm', \
    'output/measured.profile' using 1:(column(2 + k)) with lines ls wall_rougher title 'measured'
}
unset arrow
set lmargin at screen 0.735; set rmargin at screen 0.985
set logscale x 2; set xrange [1:100]; set xtics (1, 2, 5, 10, 20, 50, 100); set yrange [18:36]
set xlabel 'diameter / µm'
set title 'speed along the duct at its end / (m/s)'
set key at graph 0.03,0.03 left bottom
plot 'output/smooth.speeds' using 1:2:3 with yerrorlines ls wall_smooth title 'smooth', \
  'output/rough.speeds' using 1:2:3 with yerrorlines ls wall_rough title 'R_q 2 µm, λ_c 50 µm', \
  'output/measured.speeds' using 1:2:3 with yerrorlines ls wall_rougher title 'measured'
unset multiplot
