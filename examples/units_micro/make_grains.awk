# Writes 600 grains of quartz as a LIGGGHTS data file, in units si or micro: diameters from 3 to 60 um, 20 to
# 120 m/s, 2 to 88 degrees, each on its way to a place of its own on the plane z = 0, within 3 us.
#   awk -v UNITS=micro -f make_grains.awk > micro.data
# Its own random numbers (Park & Miller's minimal standard generator, exact in double precision), for
# those of awk differ from one awk to the next.
# SPDX-License-Identifier: GPL-3.0-or-later
function uniform() { state = (16807 * state) % 2147483647; return state / 2147483647 }
BEGIN {
  # micro: length um, time us, mass pg. So a speed in m/s is the same number in um/us, and 1 kg/m^3 = 1e-3 pg/um^3.
  metre = UNITS == "micro" ? 1e6 : 1
  metre_per_second = 1
  kg_per_m3 = UNITS == "micro" ? 1e-3 : 1
  N = 600; ROW = 25; PITCH = 1e-4; PI = atan2(0, -1); state = 12345
  print "grains, units " UNITS "\n\n" N " atoms\n2 atom types\n"
  printf "%.9g %.9g xlo xhi\n%.9g %.9g ylo yhi\n%.9g %.9g zlo zhi\n\nAtoms\n\n", -1e-3 * metre, 4e-3 * metre,
    -1e-3 * metre, 4e-3 * metre, -5e-4 * metre, 1.5e-3 * metre
  for (i = 1; i <= N; i++) {
    d = 3e-6 * exp(3 * uniform()); v = 20 + 100 * uniform()
    a = (2 + 86 * uniform()) * PI / 180; t = (0.1 + 2.9 * uniform()) * 1e-6
    vx[i] = v * cos(a); vz[i] = -v * sin(a)
    printf "%d 1 %.15g %.15g %.15g %.15g %.15g\n", i, d * metre, 2650 * kg_per_m3,
      (PITCH * (i % ROW) - vx[i] * t) * metre, PITCH * int(i / ROW) * metre, (d / 2 - vz[i] * t) * metre
  }
  print "\nVelocities\n"
  for (i = 1; i <= N; i++) printf "%d %.15g 0 %.15g 0 0 0\n", i, vx[i] * metre_per_second, vz[i] * metre_per_second
}
