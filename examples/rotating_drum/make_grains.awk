# Writes the grains as a LIGGGHTS data file: N of quartz, D meters in diameter, on a grid inside the drum (apart, so that none
# touch), each with SPEED m/s in a random direction.
#   awk -v SEED=1 -v D=1e-3 -v SPEED=0.3 -f make_grains.awk > grains.data
# Its own random numbers (Park & Miller's minimal standard generator, exact in double precision), for
# those of awk differ from one awk to the next.
# SPDX-License-Identifier: GPL-3.0-or-later
function uniform() { state = (16807 * state) % 2147483647; return state / 2147483647 }
BEGIN {
  N = 600; PITCH = 5.2e-3; RADIUS = 50e-3; PI = atan2(0, -1); state = 1850 + (SEED ? SEED : 1)
  print "grains\n\n" N " atoms\n1 atom types\n"
  print "-0.06 0.06 xlo xhi\n-0.025 0.025 ylo yhi\n-0.06 0.06 zlo zhi\n\nAtoms\n"
  for (j = -3; j <= 3; j++)
    for (i = -9; i <= 9; i++)
      for (k = -9; k <= 9; k++)
        if (PITCH * sqrt(i * i + k * k) < RADIUS - 4e-3 && n < N)
          printf "%d 1 %g 2650 %.9g %.9g %.9g\n", ++n, D, PITCH * i, PITCH * j, PITCH * k
  print "\nVelocities\n"
  for (i = 1; i <= N; i++) {
    c = 2 * uniform() - 1; s = sqrt(1 - c * c); w = 2 * PI * uniform()
    printf "%d %.9g %.9g %.9g 0 0 0\n", i, SPEED * s * cos(w), SPEED * c, SPEED * s * sin(w)
  }
  if (n != N) exit 1
}
