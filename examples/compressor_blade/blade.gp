# The pressure side of both blades in space, with the impacts on each face and what stuck to it.
# SPDX-License-Identifier: GPL-3.0-or-later
picture = 'blade.png'
name(k) = word('smooth rough', k)
title_of(k) = k == 1 ? 'smooth wall' : 'rough wall: R_q 5 µm, λ_c 60 µm'
what = 'blue: impacts per mm^2 on the pressure side; orange: deposits, larger dots for larger grains'
most = 240
light = 0.45
size(d) = 0.45 + 0.09 * d
set view 52, 24, 1, 1
set xrange [-6.2:6.2]; set yrange [-16.5:0.5]; set zrange [-2.5:2.5]
load '../space.gp'
