# The look of every picture of this project, for the scripts of the examples (load '../look.gp') and
# for those of the command asperity (share/asperity/plot). A style has a name: `with lines ls model_visible`.
# SPDX-License-Identifier: GPL-3.0-or-later
set grid lt 1 lc rgb '#e0e0e0' lw 1
set border lc rgb '#444444'
set tics nomirror
set key outside above center horizontal Left reverse font ',10' spacing 1.1 samplen 2.5
set errorbars small
# Curves that are no model and no law, in the colors of Okabe and Ito; dashes for print.
set style line 1 lc rgb '#0072b2' lw 2 dt 1 pt 5
set style line 2 lc rgb '#d55e00' lw 2 dt (12,3) pt 7
set style line 3 lc rgb '#009e73' lw 2 dt (6,3) pt 9
set style line 4 lc rgb '#cc79a7' lw 2 dt (12,3,3,3) pt 13
set style line 5 lc rgb '#e69f00' lw 2 dt (3,3) pt 11
set style line 6 lc rgb '#000000' lw 2 dt (18,3,3,3,3,3) pt 1
# Data are marks; what a simulation makes is a line or a band, its single impacts are dots.
data = 7; set style line data lc rgb '#d55e00' lw 1.5 dt 1 pt 7 ps 0.8
data_each = 8; set style line data_each lc rgb '#e9a67a' pt 7 ps 0.35
simulated = 9; set style line simulated lc rgb '#0072b2' lw 2 dt 1 pt 5 ps 0.6
impacts = 10; set style line impacts lc rgb '#9fc5dd' pt 7 ps 0.2
reference = 11; set style line reference lc rgb '#000000' lw 1.5 dt 1 pt 1
guide = 12; set style line guide lc rgb '#999999' lw 2 dt (5,3) pt 1
deposits = 13; set style line deposits lc rgb '#bbbbbb' lw 2 dt 1 pt 5 ps 2
# Walls, from smooth to rough.
wall_smooth = 14; set style line wall_smooth lc rgb '#777777' lw 2 dt 1 pt 7 ps 0.6
wall_rough = 15; set style line wall_rough lc rgb '#0072b2' lw 2 dt 1 pt 5 ps 0.6
wall_rougher = 16; set style line wall_rougher lc rgb '#882255' lw 2 dt 1 pt 9 ps 0.7
# Models of the spread.
model_none = 21; set style line model_none lc rgb '#777777' lw 2 dt (6,3) pt 2 ps 1.5
model_normal = 22; set style line model_normal lc rgb '#a39a00' lw 2 dt (3,3) pt 4 ps 1.5
model_rejection = 23; set style line model_rejection lc rgb '#000000' lw 2 dt 1 pt 1 ps 1.5
model_effective = 24; set style line model_effective lc rgb '#e69f00' lw 2 dt (12,3) pt 6 ps 1.5
model_truncated = 25; set style line model_truncated lc rgb '#009e73' lw 2 dt (12,3,3,3) pt 8 ps 1.5
model_weibull = 26; set style line model_weibull lc rgb '#cc79a7' lw 2 dt 1 pt 10 ps 1.5
model_visible = 28; set style line model_visible lc rgb '#0072b2' lw 2 dt 1 pt 5 ps 1.3
model_profile = 29; set style line model_profile lc rgb '#56b4e9' lw 2 dt 1 pt 9 ps 1.5
model_traced = 30; set style line model_traced lc rgb '#5e3c99' lw 2 dt (18,3,3,3) pt 14 ps 1.5
# Laws of the rebound.
law_bons = 31; set style line law_bons lc rgb '#0072b2' lw 2 dt 1 pt 5
law_constant = 32; set style line law_constant lc rgb '#777777' lw 2 dt (6,3) pt 2
law_grant_tabakoff = 34; set style line law_grant_tabakoff lc rgb '#cc79a7' lw 2 dt (12,3) pt 10
law_table = 35; set style line law_table lc rgb '#e69f00' lw 2 dt 1 pt 6
law_thornton_ning = 36; set style line law_thornton_ning lc rgb '#009e73' lw 2 dt (6,3) pt 8
law_walton = 37; set style line law_walton lc rgb '#5e3c99' lw 2 dt 1 pt 14
