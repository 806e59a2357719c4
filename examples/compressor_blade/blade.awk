# The blade, for make_blade.awk and make_dust.awk: a circular-arc camber line with the thickness of a NACA
# 0008 section that closes at the trailing edge, 12 mm chord, 16 mm span (along y), and a twist. In the
# section's own frame x runs along the chord; the pressure side is the lower one (small z).
# section(j) fills PX[i], PZ[i], i = 0 ... LOOP: suction trailing edge, leading edge (i = NC), pressure
# trailing edge, at span j / NS.
# SPDX-License-Identifier: GPL-3.0-or-later
function set_up() {
  PI = atan2(0, -1)
  CHORD = 12e-3; SPAN = 16e-3; THICKNESS = 0.08
  CAMBER = 35 * PI / 180   # how much the camber line turns from leading to trailing edge
  TWIST = 14 * PI / 180    # turn of the section from hub (-half) to tip (+half), about mid-chord
  NC = 36; NS = 20; LOOP = 2 * NC
  RADIUS = CHORD / (2 * sin(CAMBER / 2))
}
function half_thickness(s) {
  return 5 * THICKNESS * CHORD * (0.2969 * sqrt(s) + s * (-0.1260 + s * (-0.3516 + s * (0.2843 - 0.1036 * s))))
}
# Where point i of the loop is along the chord, 0 at the leading edge: negative on the suction side;
# points are closer together there.
function position(i,  s) { s = (i - NC) / NC; return s * (0.4 + 0.6 * (s < 0 ? -s : s)) }
function section(j,  i, s, turn, side, x, z, t, c, w) {
  turn = TWIST * (j / NS - 0.5); c = cos(turn); w = sin(turn)
  for (i = 0; i <= LOOP; i++) {
    s = position(i); side = s < 0 ? 1 : -1; s *= -side
    t = CAMBER * (0.5 - s)   # slope of the camber line; s is its arc length
    x = CHORD / 2 - RADIUS * sin(t) - side * half_thickness(s) * sin(t)
    z = RADIUS * (cos(t) - cos(CAMBER / 2)) + side * half_thickness(s) * cos(t)
    x -= CHORD / 2
    PX[i] = x * c + z * w; PZ[i] = z * c - x * w
  }
}
