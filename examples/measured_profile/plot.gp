# The spread of the tilt over the grain's diameter, in two LIGGGHTS runs, and the sd of the slope angles of the profile.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 800,520 font 'sans,11'
set output 'output/in_liggghts.png'
set logscale x
set xrange [4:500]
set yrange [0:*]
set xlabel 'diameter / µm'
set ylabel 'standard deviation of {/Symbol Da} / degrees'
set title '5 000 grains at 60° on the blade: LIGGGHTS ledger'
plot "< grep -E '^[0-9]' output/slopes.csv | tr , ' '" using 1:9 with lines ls model_profile title 'slope angles of the profile, asperity surface', \
     'output/profile.sd' with yerrorbars ls model_profile title 'impacts, profile', \
     'output/numbers.sd' with yerrorbars ls model_visible title 'impacts, R_q and {/Symbol l}_c alone'
