#!/usr/bin/env bash
# The same ledger, byte for byte, on 1, 2 and 4 ranks, on a plane and on a mesh; as one run or as two; and
# the same physics on the mesh as on the plane.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
grains 900 > grains.data
plate 12 1 > plate.stl
deck() { # wall, runs
  head_of si
  echo 'read_data grains.data
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all'
  materials
  echo 'fix plate all mesh/surface file plate.stl type 2
fix move all nve/sphere
timestep 1e-8'
  echo "fix wall all wall/rebound $1 surface rq 10e-6 lambda_c 90e-6 spread weibull isotropic collisions multiple deposit freeze seed 5 ledger 100 file \${out}"
  printf '%b\n' "$2"
}
deck 'primitive type 2 zplane 0.0' 'run 400' > plane.in
deck 'mesh n_meshes 1 meshes plate' 'run 400' > mesh.in
deck 'mesh n_meshes 1 meshes plate' 'run 150\nrun 30\nrun 220' > parts.in
for wall in plane mesh; do
  for ranks in 1 2 4; do engine $ranks $wall.in -var out $wall.$ranks.csv; done
  [ "$(count_rows $wall.1.csv)" -ge 900 ] || die "$wall: $(count_rows $wall.1.csv) impacts of 900 grains"
  same $wall.1.csv $wall.2.csv "1 and 2 ranks"
  same $wall.1.csv $wall.4.csv "1 and 4 ranks"
done
engine 2 parts.in -var out parts.csv
same mesh.1.csv parts.csv "one run and three"
near plane.1.csv mesh.1.csv "1 2 3 6 7 8 9 10 11 12 13 14 15 16 17 18 19" 1e-6
check_rows mesh.1.csv '$4 == 1 && $5 >= 0' "mesh and triangle are named"
check_rows plane.1.csv '$4 == 0 && $5 == 0' "a primitive wall has mesh 0 and triangle 0"
check_rows plane.1.csv '$11 >= 0 && $11 <= 90 && $16 >= 0 && $16 <= 180 && $15 <= $10 * (1 + 1e-12)' "angles and energy"
