# The spread of the tilt over the grain's diameter, in two LIGGGHTS runs, and sigma as the log states it.
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
plot "< grep -E '^  bin [0-9]+: d_p' output/profile.log | tr -d ," using ($4 * 1e6):6 with lines ls model_profile title '{/Symbol s} of the profile, from the log', \
     'output/profile.sd' with yerrorbars ls model_profile title 'impacts, profile', \
     'output/numbers.sd' with yerrorbars ls model_visible title 'impacts, R_q and {/Symbol l}_c alone'
