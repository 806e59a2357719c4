# The pressure side over the chord: impacts, and how deep the dust wears it.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1200,480 font 'sans,16'
set output 'output/compressor_blade.png'
set multiplot layout 1,2
set xrange [0:1]; set xtics 0.25
set xlabel 'position along the chord, pressure side'
set key inside left top vertical Left reverse spacing 1.1 samplen 2 font ',15'
set yrange [0:1500]
set title 'impacts per 1/20 of the chord'
plot 'output/smooth.chord' using 1:2 with lines ls guide dt 1 title 'first impacts, the same on both', \
     'output/smooth.chord' using 1:3 with linespoints ls wall_smooth title 'later impacts, smooth', \
     'output/rough.chord' using 1:3 with linespoints ls wall_rough title 'later impacts, rough'
set yrange [0:0.7]
set title "wear / nm"
plot 'output/tilted.band' using 1:2:3 with filledcurves fc '#c0c0c0' fs transparent solid 0.5 noborder title 'tilted, R_q ± 20 %', \
     'output/smooth.wear' using 1:2 with lines ls wall_smooth title 'smooth', \
     'output/rough.wear' using 1:2 with lines ls wall_rough title 'rough, mean wall', \
     'output/tilted.wear' using 1:2 with lines ls wall_rougher title 'rough, faces (tilted)'
unset multiplot
