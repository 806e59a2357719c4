# Two walls in space, side by side: the color of a face tells `what` hit it, dots are grains that stuck. Set before it is
# loaded: picture, name(k) and title_of(k) of wall k = 1, 2, what, most (end of the color bar), light (the share of it that
# has a direction), size(d) of a dot, ranges and view. output/NAME.faces has the corners of each face as a grid of two by
# two (x y z value), output/NAME.stuck the dots (x y z d), large ones first.
# SPDX-License-Identifier: GPL-3.0-or-later
load '../look.gp'
set term pngcairo size 1200,500 font 'sans,18'
set output 'output/'.picture
unset border; unset tics; unset grid; unset key
set view equal xyz
set pm3d depthorder corners2color c1 lighting primary light specular 0.15
set palette defined (0 '#f4f4f4', 0.25 '#c6dbef', 0.5 '#6baed6', 1 '#08519c')
set cbrange [0:most]
set multiplot
do for [k=1:2] {
  left = 0.44 * (k - 1)
  set label 1 title_of(k) at screen left + 0.22, 0.93 center
  if (k == 1) { set label 2 what at screen 0.5, 0.06 center }
  set lmargin at screen left; set rmargin at screen left + 0.45; set bmargin at screen 0.08; set tmargin at screen 0.92
  if (k == 1) { unset colorbox } else {
    set colorbox user origin screen 0.905, screen 0.2 size screen 0.012, screen 0.4
    set cbtics most * 0.25 add (sprintf('≥ %g', most) most)
  }
  splot 'output/'.name(k).'.faces' using 1:2:3:4 with pm3d
  unset label; unset colorbox
  # a plot of its own: pm3d draws what it sorts by depth over the points
  splot 'output/'.name(k).'.stuck' using 1:2:3:(size($4)) with points pt 7 ps variable lc rgb '#d55e00'
}
unset multiplot
