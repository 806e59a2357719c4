# Bodies of LAMMPS's fixes rigid and rigid/small, for the engine tests; the scripts are in its language.
# SPDX-License-Identifier: GPL-3.0-or-later
use lammps
program=$bin/lammps-asperity

start() { # [BOUNDARY]: the beginning of a script for the file `data`
  echo "units si
atom_style sphere
atom_modify map array
boundary ${1:-f f f}
newton off
comm_modify vel yes cutoff 3e-3
fix mol all property/atom mol ghost yes
read_data data fix mol NULL Mols"
}
go_on() { # FIX: the rest, but for walls
  echo "neighbor 1e-3 bin
neigh_modify delay 0 exclude group all all
pair_style gran/hooke 1e4 NULL 100 NULL 0.3 0
pair_coeff * *
fix bodies all $1 molecule
compute ke all ke/rigid bodies
compute re all erotate/rigid bodies
thermo_style custom step atoms c_ke c_re
thermo_modify format float %.12g"
}

# rigid_data COUNT "x y z r ...": a data file of bodies of these spheres, turned and placed at random where they fit into
# a box of 40 mm.
rigid_data() {
  awk -v n="$1" -v spheres="$2" '
    function uniform() { state = (16807 * state) % 2147483647; return state / 2147483647 }
    function draw(   k, s, c, sum) { # a rotation by a random quaternion, and a place
      do { sum = 0; for (k = 0; k < 4; k++) { q[k] = 2 * uniform() - 1; sum += q[k] ^ 2 } } while (sum > 1 || sum < 0.01)
      for (k = 0; k < 4; k++) q[k] /= sqrt(sum)
      for (k = 1; k <= 3; k++) at[k] = 0.04 * (uniform() - 0.5)
      for (s = 0; s < count; s++) {
        for (k = 0; k < 3; k++) { c = (k + 1) % 3; side[k] = 2 * (q[1 + c] * p[4 * s + 1 + (k + 2) % 3] - q[1 + (k + 2) % 3] * p[4 * s + 1 + c]) }
        for (k = 0; k < 3; k++) { c = (k + 1) % 3; x[s, k] = at[k + 1] + p[4 * s + 1 + k] + q[0] * side[k] + q[1 + c] * side[(k + 2) % 3] - q[1 + (k + 2) % 3] * side[c]
          if (x[s, k] < p[4 * s + 4] - 0.02 || x[s, k] > 0.02 - p[4 * s + 4]) return 0 } }
      return 1 }
    BEGIN { state = 4711; count = split(spheres, p, " ") / 4
      printf "bodies\n\n%d atoms\n1 atom types\n-0.021 0.021 xlo xhi\n-0.021 0.021 ylo yhi\n-0.021 0.021 zlo zhi\n\nAtoms # sphere\n\n", count * n
      for (i = 0; i < n; i++) { while (!draw()) { }
        for (s = 0; s < count; s++) printf "%d 1 %.17g 2500 %.17g %.17g %.17g\n", count * i + s + 1, 2 * p[4 * s + 4], x[s, 0], x[s, 1], x[s, 2] }
      printf "\nMols\n\n"
      for (i = 0; i < count * n; i++) print i + 1, int(i / count) + 1 }'
}
