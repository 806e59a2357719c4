# Writes beads as a LAMMPS data file: N of them, spread evenly over a pipe of radius R, with diameters of a log-normal law
# of mean D and sd of the logarithm SPREAD, cut at 15 and 85 um, at the speed U along x.
#   awk -f make_beads.awk -v N=20000 -v R=0.075 -v D=40e-6 -v SPREAD=0.3 -v U=25 > beads.data
# Its own random numbers (Park & Miller's minimal standard generator, exact in double precision), for those of awk differ
# from one awk to the next.
# SPDX-License-Identifier: GPL-3.0-or-later
function uniform() { state = (16807 * state) % 2147483647; return state / 2147483647 }
function normal() { return sqrt(-2 * log(uniform())) * cos(2 * PI * uniform()) }
BEGIN {
  DENSITY = 2500; LENGTH = 0.2; state = 1998; PI = atan2(0, -1)
  print "beads\n\n" N " atoms\n1 atom types\n"
  printf "0 %g xlo xhi\n%g %g ylo yhi\n%g %g zlo zhi\n\nAtoms\n\n", LENGTH, -1.05 * R, 1.05 * R, -1.05 * R, 1.05 * R
  for (i = 1; i <= N; i++) {
    do d = D * exp(SPREAD * normal() - SPREAD * SPREAD / 2); while (d < 15e-6 || d > 85e-6)
    r = 0.998 * R * sqrt(uniform()); phi = 2 * PI * uniform()
    printf "%d 1 %.9g %d %.9g %.9g %.9g\n", i, d, DENSITY, LENGTH * uniform(), r * cos(phi), r * sin(phi)
  }
  print "\nVelocities\n"
  for (i = 1; i <= N; i++) print i, U, 0, 0, 0, 0, 0
}
