# The pressure side of both blades in space, with the impacts of each triangle and what stuck to it.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1200,500 font 'sans,17'
set output 'output/blade.png'
unset border; unset tics; unset grid
set view 52, 24, 1, 1
set view equal xyz
set xrange [-6.2:6.2]; set yrange [-16.5:0.5]; set zrange [-2.5:2.5]
set pm3d depthorder corners2color c1 lighting primary 0.45 specular 0.15
set palette defined (0 '#f4f4f4', 0.25 '#c6dbef', 0.5 '#6baed6', 1 '#08519c')
set cbrange [0:240]
size(d) = 0.45 + 0.09 * d
title_of(k) = k == 1 ? 'smooth wall' : 'rough wall: R_q 5 µm, λ_c 60 µm'
set multiplot
set label 2 'blue: impacts per mm^2 on the pressure side; orange: deposits, larger dots for larger grains' at screen 0.5, 0.06 center
do for [k=1:2] {
  name = 'output/'.word('smooth rough', k)
  set label 1 title_of(k) at screen 0.22 + 0.44 * (k - 1), 0.93 center
  set lmargin at screen 0.0 + 0.44 * (k - 1); set rmargin at screen 0.45 + 0.44 * (k - 1)
  set bmargin at screen 0.08; set tmargin at screen 0.92
  if (k == 1) { unset colorbox } else {
    set colorbox user origin screen 0.91, screen 0.15 size screen 0.012, screen 0.35
    set cbtics 80 add ('≥ 240' 240)
  }
  unset key
  splot name.'.map' using 3:(-$4):(-$5):6 with pm3d
  unset label; unset colorbox
  # a plot of its own: pm3d draws what it sorts by depth over the points
  splot name.'.deposits' using ($1 > 0 ? $5 : NaN):(-$6):(-$7 + 0.05):(size($3)) with points pt 7 ps variable lc rgb '#d55e00'
}
unset multiplot
set label 2 'blue: impacts per mm^2 on the pressure side; orange: deposits, larger dots for larger grains' at screen 0.5, 0.06 center
