# Writes the dust as a LIGGGHTS data file: N particles of quartz, diameters log-normal from 1 to 100 um
# with median 10 um, 100 m/s, impact angles evenly spread from 2 to 88 degrees. Each flies toward a
# place of its own on the plate, so that no two meet, and reaches it after 5 to 75 % of the run.
#   awk -f make_jet.awk > jet.data
# Its own random numbers (Park & Miller's minimal standard generator, exact in double precision), for
# those of awk differ from one awk to the next.
# SPDX-License-Identifier: GPL-3.0-or-later
function uniform() { state = (16807 * state) % 2147483647; return state / 2147483647 }
function normal() { return sqrt(-2 * log(uniform())) * cos(2 * PI * uniform()) }
function diameter(  d) {
  do d = 10e-6 * exp(log(100) / 5 * normal()); while (d < 1e-6 || d > 100e-6)
  return d
}
BEGIN {
  N = 20164; ROW = 142; PITCH = 0.4e-3; MARGIN = 1.6e-3; SPEED = 100; TIME = 8e-6
  PI = atan2(0, -1); state = 20200709
  print "dust jet\n\n" N " atoms\n2 atom types\n"
  print "-0.005 0.065 xlo xhi\n-0.005 0.065 ylo yhi\n-0.002 0.004 zlo zhi\n\nAtoms\n"
  for (i = 1; i <= N; i++) {
    angle = (2 + 86 * (i - 0.5) / N) * PI / 180
    d = diameter(); t = (0.05 + 0.7 * uniform()) * TIME
    vx[i] = SPEED * cos(angle); vz[i] = -SPEED * sin(angle)
    k = (7919 * i) % N # a place that has nothing to do with the angle
    printf "%d 1 %.9g 2650 %.12g %.12g %.12g\n", i, d,
      MARGIN + PITCH * (k % ROW) - vx[i] * t, MARGIN + PITCH * int(k / ROW), d / 2 - vz[i] * t
  }
  print "\nVelocities\n"
  for (i = 1; i <= N; i++) printf "%d %.12g 0 %.12g 0 0 0\n", i, vx[i], vz[i]
}
