# Figures 10 to 12 of the paper, and all combinations over kappa, from output/doe.csv (asperity surface).
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set datafile separator comma
set term pngcairo size 1300,1000 font 'sans,11'
set output 'output/figures_10_11_12.png'
set multiplot layout 2,2
rows = "< grep '^[0-9]' output/doe.csv"
set title 'Over Φ_R at d_p = 40 µm (fig. 10)'
set xlabel 'Φ_R'
set ylabel 'variance of Δα / deg²'
plot for [l in "40 80 120 240 360 400"] rows using ($1 == 40 && $3 == l + 0 ? $4 : NaN):($9 ** 2) with points pt 7 ps 0.8 title 'λ_c = '.l.' µm'
set title 'Over d_p (fig. 11)'
set xlabel 'd_p / µm'
set logscale y
plot for [w in "'25 40' '15 40' '15 80' '10 120' '20 400'"] rows using (sprintf('%g %g', $2, $3) eq w ? $1 : NaN):($9 ** 2) with points pt 7 ps 0.5 title 'R_q, λ_c = '.w.' µm'
set title 'Over Φ_R and d_p/λ_c (fig. 12)'
set xlabel 'Φ_R'
set ylabel 'd_p / λ_c'
set logscale xycb
set cblabel 'variance of Δα / deg²'
plot rows using 4:($1 / $3):($9 ** 2) with points pt 7 ps 0.6 palette notitle
unset logscale
set title 'Every combination over κ'
set xlabel 'κ = √3 d_p R_q / λ_c²'
set ylabel 's_{eff} / s'
set logscale x
set xrange [0.001:20]
set yrange [0:1.1]
set cblabel 'Φ_R'
plot rows using 5:($6 / (sqrt(2) * $4)):4 with points pt 7 ps 0.3 palette title 'generated profiles', \
  (1 + 0.92 * x ** 3) ** (-1. / 6) with lines lw 2 lc 'black' title 'closed form, Φ_R ≤ 0.25'
unset multiplot
