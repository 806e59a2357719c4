# What the outer wall keeps along its way, and how fast the grains leave.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1200,480 font 'sans,16'
set output 'output/along.png'
set multiplot layout 1,2
set key inside left top vertical Left reverse font ',15' samplen 1.5
set xlabel 'way along the outer wall / mm'
set xrange [-100:350]; set yrange [0:24]; set xtics 100
set arrow 1 from 0,graph 0 to 0,graph 0.7 nohead lc rgb '#444444'
set arrow 2 from 196.35,graph 0 to 196.35,graph 0.7 nohead lc rgb '#444444'
set label 1 'bend' at 98,1 center
set title 'deposits / kg per m^2 and kg of dust'
plot 'output/smooth.profile' using 1:3 with lines ls wall_smooth title 'smooth', \
  'output/rough.profile' using 1:3 with lines ls wall_rough title 'R_q 2 µm, λ_c 50 µm', \
  'output/measured.profile' using 1:3 with lines ls wall_rougher title 'measured'
unset arrow; unset label
set logscale x 2; set xrange [1:100]; set xtics (1, 2, 5, 10, 20, 50, 100); set yrange [18:36]
set xlabel 'diameter / µm'
set title 'speed along the duct at its end / (m/s)'
unset key
plot 'output/smooth.speeds' using 1:2:3 with yerrorlines ls wall_smooth, \
  'output/rough.speeds' using 1:2:3 with yerrorlines ls wall_rough, \
  'output/measured.speeds' using 1:2:3 with yerrorlines ls wall_rougher
unset multiplot
