# The outer wall in space: how deep the dust wears it, and what stuck.
# SPDX-License-Identifier: GPL-3.0-or-later
picture = 'bend.png'
name(k) = word('smooth measured', k)
title_of(k) = k == 1 ? 'smooth wall' : 'measured wall: R_q 8 µm, λ_c 50 µm'
what = 'outer wall, flow from the right; blue: wear / µm per kg of dust; orange: one deposit in 20'
most = 1
size(d) = 0.2 + 0.02 * d
set view 38, 45, 1, 1
set xrange [-150:60]; set yrange [-160:50]; set zrange [-25:80]
light = 0.1
load '../space.gp'
