# The two pictures of models.md. From the project's folder: gnuplot src/wall/models.gp
# SPDX-License-Identifier: GPL-3.0-or-later
asperity = "build/bin/asperity "
folder = "src/wall/"
set datafile separator ","
set terminal pngcairo size 900,420 font "sans,12"
set grid lc rgb "#dddddd"
set key right top reverse Left samplen 2

set output folder."models.png"
set xlabel "tilt Δα of the first face (deg)"
set ylabel "probability per degree"
set title "σ = 10°, impact angle α1 = 10°"
pdf(model) = "< ".asperity."spread surface sigma 10 spread ".model." plane --angles 10 --pdf | grep '^[-0-9]'"
plot [-12:40] [0:0.075] \
  pdf("normal")    w l lw 2 lc rgb "#999999" t "normal", \
  pdf("truncated") w l lw 2 lc rgb "#e69f00" t "truncated, rejection", \
  pdf("weibull")   w l lw 2 lc rgb "#d55e00" t "weibull", \
  pdf("effective") w l lw 2 lc rgb "#56b4e9" t "effective, multicollision", \
  pdf("visible")   w l lw 2 lc rgb "#0072b2" t "visible", \
  pdf("profile")   w l lw 2 dt 2 lc rgb "#000000" t "profile"

set output folder."laws.png"
set title "quartz on steel 304, 10 µm, 100 m/s, smooth wall"
law(words) = "< ".asperity."rebound rebound ".words." --map angles | grep -v '^#'"
pair = " materials quartz 304-ss"
set xlabel "impact angle α1 (deg)"
unset key
set multiplot layout 1,2
do for [name in "cor_n cor_t"] {
  set ylabel (name eq "cor_n" ? "CoR_N" : "CoR_T") noenhanced
  plot [0:90] [0:1.05] \
    law("bons".pair)          u "alpha1_deg":name w l lw 2 lc rgb "#0072b2" t "bons", \
    law("thornton_ning".pair) u "alpha1_deg":name w l lw 2 lc rgb "#56b4e9" t "thornton_ning", \
    law("walton 0.9 0.3 0")   u "alpha1_deg":name w l lw 2 lc rgb "#d55e00" t "walton 0.9 0.3 0", \
    law("grant_tabakoff")     u "alpha1_deg":name w l lw 2 lc rgb "#009e73" t "grant_tabakoff", \
    law("forder")             u "alpha1_deg":name w l lw 2 lc rgb "#cc79a7" t "forder"
  set key bottom right noenhanced
  set title " "
}
unset multiplot
