# Writes the dust as a LIGGGHTS data file: 2 x 6000 grains of quartz of 10 um at 100 m/s and 10 degrees, those of odd
# number for the plate at y < 0, the others for that at y > 0, each for a place of its own.   awk -f make_jet.awk > jet.data
# SPDX-License-Identifier: GPL-3.0-or-later
function uniform() { state = (16807 * state) % 2147483647; return state / 2147483647 }
BEGIN {
  N = 12000; ROW = 100; PITCH = 0.1e-3; SPEED = 100; TIME = 8e-6; D = 10e-6
  PI = atan2(0, -1); state = 20200709; angle = 10 * PI / 180
  vx = SPEED * cos(angle); vz = -SPEED * sin(angle)
  print "dust jet\n\n" N " atoms\n2 atom types\n"
  print "-0.015 0.015 xlo xhi\n-0.015 0.015 ylo yhi\n-0.002 0.004 zlo zhi\n\nAtoms\n"
  for (i = 1; i <= N; i++) {
    k = int((i - 1) / 2); t = (0.05 + 0.7 * uniform()) * TIME
    printf "%d 1 %.9g 2650 %.12g %.12g %.12g\n", i, D,
      PITCH * (k % ROW - ROW / 2) - vx * t, (i % 2 ? -0.008 : 0.002) + PITCH * int(k / ROW), D / 2 - vz * t
  }
  print "\nVelocities\n"
  for (i = 1; i <= N; i++) printf "%d %.12g 0 %.12g 0 0 0\n", i, vx, vz
}
