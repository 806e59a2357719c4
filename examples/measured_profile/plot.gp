# The spread of the tilt over the grain's diameter, in two LIGGGHTS runs, and sigma as the log states it.
# SPDX-License-Identifier: GPL-3.0-or-later
set term pngcairo size 800,520 font 'sans,11'
set output 'output/in_liggghts.png'
set grid lc rgb '#dddddd' lw 0.5
set border lc rgb '#444444'
set tics nomirror
set logscale x
set xrange [4:500]
set yrange [0:*]
set xlabel 'diameter / µm'
set ylabel 'standard deviation of {/Symbol Da} / degrees'
set title '5 000 grains at 60° on the blade: LIGGGHTS ledger'
set key bottom left
plot "< grep -E '^  bin [0-9]+: d_p' output/profile.log | tr -d ," using ($4 * 1e6):6 with lines lw 2 lc rgb '#1f5fa8' title '{/Symbol s} of the bins, profile', \
     'output/profile.sd' with yerrorbars pt 7 lc rgb '#1f5fa8' title 'impacts, profile', \
     'output/numbers.sd' with yerrorbars pt 5 lc rgb '#c8501e' title 'impacts, R_q and {/Symbol l}_c only'
