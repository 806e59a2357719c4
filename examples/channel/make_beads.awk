# Writes the beads as a LIGGGHTS data file: N glass beads of 200 um, spread evenly over a channel 30 mm high,
# at the gas's speed, with a little velocity of their own.
#   awk -v SEED=1 -f make_beads.awk > beads.data
# Its own random numbers (Park & Miller's minimal standard generator, exact in double precision), for
# those of awk differ from one awk to the next.
# SPDX-License-Identifier: GPL-3.0-or-later
function uniform() { state = (16807 * state) % 2147483647; return state / 2147483647 }
BEGIN {
  N = 800; D = 200e-6; HEIGHT = 30e-3; LENGTH = 40e-3; WIDTH = 20e-3; SPEED = 10; state = 1998 + (SEED ? SEED : 1)
  print "beads\n\n" N " atoms\n1 atom types\n"
  printf "0 %g xlo xhi\n0 %g ylo yhi\n%g %g zlo zhi\n\nAtoms\n\n", LENGTH, WIDTH, -1e-3, HEIGHT + 1e-3
  for (i = 1; i <= N; i++)
    printf "%d 1 %.9g 2500 %.9g %.9g %.9g\n", i, D, LENGTH * uniform(), WIDTH * uniform(),
      D + (HEIGHT - 2 * D) * uniform()
  print "\nVelocities\n"
  for (i = 1; i <= N; i++)
    printf "%d %.9g %.9g %.9g 0 0 0\n", i, SPEED, uniform() - 0.5, 2 * uniform() - 1
}
