# Writes the dust as a LIGGGHTS data file: N grains of quartz, diameters log-normal from 1 to 100 um with
# median 10 um, 150 m/s, all in one direction. Each is on a straight line to a place of its own on the side
# of the blade that the flow sees, and starts so that it arrives after 2 to 18 % of the run.
#   awk -v SEED=1 -f blade.awk -f make_dust.awk > dust.data
# Its own random numbers (Park & Miller's minimal standard generator, exact in double precision), for
# those of awk differ from one awk to the next.
# SPDX-License-Identifier: GPL-3.0-or-later
function uniform() { state = (16807 * state) % 2147483647; return state / 2147483647 }
function normal() { return sqrt(-2 * log(uniform())) * cos(2 * PI * uniform()) }
function diameter(  d) {
  do d = 10e-6 * exp(log(100) / 5 * normal()); while (d < 1e-6 || d > 100e-6)
  return d
}
# Distance along the flow from the line through the origin across it to the first point of the present
# section that a line at offset h meets; "" where it passes by.
function first_touch(h,  i, a, b, s, best) {
  best = ""
  for (i = 0; i < LOOP; i++) {
    a = H[i] - h; b = H[i + 1] - h
    if (a * b >= 0) continue
    s = L[i] + (L[i + 1] - L[i]) * a / (a - b)
    if (best == "" || s < best) best = s
  }
  return best
}
BEGIN {
  set_up()
  N = 16000; SPEED = 150; TIME = 96e-6; FLOW = 22.5 * PI / 180; state = 20200708 + (SEED ? SEED : 1)
  ux = cos(FLOW); uz = sin(FLOW)
  print "dust\n\n" N " atoms\n2 atom types\n"
  print "-0.014 0.014 xlo xhi\n-0.001 0.017 ylo yhi\n-0.012 0.010 zlo zhi\n\nAtoms\n"
  rows = 400 # lines of the span, each with its own section
  for (row = 0; row < rows; row++) {
    y = 0.002 + 0.996 * (row + 0.5) / rows
    section(y * NS)
    low = 1; high = -1
    for (i = 0; i <= LOOP; i++) {
      L[i] = PX[i] * ux + PZ[i] * uz; H[i] = PZ[i] * ux - PX[i] * uz
      if (H[i] < low) low = H[i]
      if (H[i] > high) high = H[i]
    }
    per_row = N / rows
    for (k = 0; k < per_row; k++) {
      do {
        h = low + (high - low) * (k + uniform()) / per_row
        s = first_touch(h)
      } while (s == "")
      d = diameter()
      s -= d / 2 + SPEED * TIME * (0.02 + 0.16 * uniform())
      id++
      printf "%d 1 %.9g 2650 %.12g %.12g %.12g\n", id, d, s * ux - h * uz, y * SPAN, s * uz + h * ux
    }
  }
  print "\nVelocities\n"
  for (i = 1; i <= N; i++) printf "%d %.12g 0 %.12g 0 0 0\n", i, SPEED * ux, SPEED * uz
}
