# The two pictures of models.md. From the project's folder: gnuplot src/wall/models.gp
# SPDX-License-Identifier: GPL-3.0-or-later
asperity = "build/bin/asperity "
folder = "src/wall/"
set datafile separator ","
set terminal pngcairo size 900,460 font "sans,12"
load "examples/look.gp"

set output folder."models.png"
set xlabel "tilt Δα of the first face / degrees"
set ylabel "probability per degree"
set title "σ = 10°, impact angle {/Symbol a}_1 = 10°"
pdf(model) = "< ".asperity."spread surface sigma 10 spread ".model." plane --angles 10 --pdf | grep '^[-0-9]'"
plot [-30:40] [0:0.075] \
  pdf("normal")    w l ls model_normal t "normal", \
  pdf("truncated") w l ls model_truncated t "truncated, rejection", \
  pdf("weibull")   w l ls model_weibull t "weibull", \
  pdf("effective") w l ls model_effective t "effective", \
  pdf("visible")   w l ls model_visible t "visible", \
  pdf("profile")   w l ls model_profile t "profile"

set output folder."laws.png"
unset title
law(words) = "< ".asperity."cor rebound ".words." --samples 1 --angles 0.5:90:0.5 | grep -v -e '^#' -e deposit"
pair = " materials quartz 304-ss"
set xlabel "impact angle {/Symbol a}_1 / degrees"
set key noenhanced maxrows 3
set multiplot layout 1,2 title "quartz on steel 304, 10 µm, 100 m/s, smooth wall\n"
do for [name in "cor_n cor_t"] {
  set ylabel (name eq "cor_n" ? "CoR_N" : "CoR_T")
  plot [0:90] [0:1.05] \
    law("bons".pair)          u "alpha1_deg":name w l ls law_bons t "bons", \
    law("thornton_ning".pair) u "alpha1_deg":name w l ls law_thornton_ning t "thornton_ning", \
    law("walton 0.9 0.3 0")   u "alpha1_deg":name w l ls law_walton t "walton 0.9 0.3 0", \
    law("grant_tabakoff")     u "alpha1_deg":name w l ls law_grant_tabakoff t "grant_tabakoff", \
    law("table examples/data/forder_1998.csv") u "alpha1_deg":name w l ls law_table t "table forder_1998.csv"
}
unset multiplot
