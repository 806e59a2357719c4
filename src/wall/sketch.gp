# One contact: mean wall, face, tilt and angles. From the project's folder: gnuplot src/wall/sketch.gp
# SPDX-License-Identifier: GPL-3.0-or-later
set term svg size 900,400 font 'sans,17' background '#ffffff'
set output 'src/wall/sketch.svg'
unset border; unset tics; unset key; unset colorbox
set xrange [-5:5]; set yrange [-1.15:3.29]; set size ratio -1
set lmargin 0; set rmargin 0; set tmargin 0; set bmargin 0
set angles degrees
blue = '#0072b2'; red = '#d55e00'; gray = '#777777'
rad = 57.29578
wall(x) = 0.5 * sin(rad * 0.65 * x) + 0.1 * (1 - cos(rad * 1.9 * x))
tilt = 18; alpha1 = 26; alpha2 = 56; r = 0.45
cx = -r * sin(tilt); cy = r * cos(tilt)        # the center; it touches the wall at 0, 0
arc(a, b, s, x, y) = sprintf('set object circle at %g,%g size %g arc [%g:%g] nowedge fs empty border lc rgb "#555555" front', x, y, s, a, b)
# mean wall, face
set arrow from -4.9,0 to 4.9,0 nohead dt (10,6) lw 1.5 lc rgb gray front
set label 'mean wall' at 4.9,-0.22 right textcolor rgb gray front
set arrow from -1.6*cos(tilt),-1.6*sin(tilt) to 2*cos(tilt),2*sin(tilt) nohead lw 3 lc rgb red front
set label 'face' at 2*cos(tilt)+0.08,2*sin(tilt)-0.02 left textcolor rgb red front
set label '{/Symbol D}α' at 1.4,0.19 left front
eval arc(0, tilt, 1.3, 0, 0)
# particle and its paths
set object circle at cx,cy size r fs transparent solid 0.25 fc rgb blue
set arrow from cx-4*cos(alpha1),cy+4*sin(alpha1) to cx,cy lw 3 lc rgb blue head size 0.25,18 filled front
set arrow from cx,cy to cx+2.6*cos(alpha2),cy+2.6*sin(alpha2) lw 3 lc rgb blue head size 0.25,18 filled front
set label 'v_1' at cx-3.1*cos(alpha1),cy+3.1*sin(alpha1)+0.25 textcolor rgb blue front
set label 'v_2' at cx+2.6*cos(alpha2)+0.1,cy+2.6*sin(alpha2)-0.1 textcolor rgb blue front
set arrow from cx-2.4,cy to cx+1.9,cy nohead dt (3,4) lc rgb gray front
set label 'α_1' at cx-1.95,cy+0.38 center front
eval arc(180 - alpha1, 180, 1.6, cx, cy)
set label 'α_2' at cx+1.3,cy+0.42 left front
eval arc(0, alpha2, 1.15, cx, cy)
# n and t of the mean wall
set arrow from 3.6,1.6 to 3.6,2.6 lw 2 head size 0.18,20 filled front
set arrow from 3.6,1.6 to 4.6,1.6 lw 2 head size 0.18,20 filled front
set label 'n' at 3.4,2.5 right front
set label 't' at 4.65,1.8 left front
plot wall(x) with filledcurves y1=-1.15 fc rgb '#dddddd', wall(x) with lines lw 2 lc rgb '#444444'
