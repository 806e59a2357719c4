# Writes the grains as a LIGGGHTS data file: N of quartz, diameters evenly spread in their logarithm from 5
# to 400 um, at 60 m/s and 60 degrees, each to a place of its own on the plane z = 0.
#   awk -f make_grains.awk > grains.data
# SPDX-License-Identifier: GPL-3.0-or-later
BEGIN {
  N = 5000; ROW = 71; PITCH = 6e-4; PI = atan2(0, -1); state = 7
  vx = 60 * cos(PI / 3); vz = -60 * sin(PI / 3)
  print "grains\n\n" N " atoms\n2 atom types\n"
  print "-0.002 0.045 xlo xhi\n-0.002 0.045 ylo yhi\n-0.002 0.003 zlo zhi\n\nAtoms\n"
  for (i = 1; i <= N; i++) {
    state = (16807 * state) % 2147483647
    d = 5e-6 * exp(log(80) * (i - 0.5) / N); t = (0.1 + 0.8 * state / 2147483647) * 8e-6
    k = (1093 * i) % N
    printf "%d 1 %.9g 2650 %.12g %.12g %.12g\n", i, d, PITCH * (k % ROW) - vx * t, PITCH * int(k / ROW), d / 2 - vz * t
  }
  print "\nVelocities\n"
  for (i = 1; i <= N; i++) printf "%d %.12g 0 %.12g 0 0 0\n", i, vx, vz
}
