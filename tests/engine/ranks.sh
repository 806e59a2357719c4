#!/usr/bin/env bash
# The same ledger, byte for byte, on 1, 2 and 4 ranks, on a plane and on a mesh; as one run or as three; behind `clear` as
# in a script of its own; and the same physics on the mesh as on the plane.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
grains 900 > grains.data
grains 900 1 1 1 777 > others.data
plate 12 1 > plate.stl
mesh='mesh n_meshes 1 meshes plate' plane='primitive type 2 zplane 0.0'
deck() { # DATA WALL LEDGER RUNS
  flying $1
  echo "fix plate all mesh/surface file plate.stl type 2
fix wall all wall/rebound $2 surface rq 10e-6 lambda_c 90e-6 spread weibull isotropic collisions multiple yield_stress 2e8 scatter 0.3 deposit freeze seed 5 ledger 100 file $3
timestep 1e-8"
  printf '%b\n' "$4"
}
deck others.data "$plane" alone.csv 'run 400' > alone.in
{ deck grains.data "$mesh" mesh.csv 'run 400\nclear'
  deck others.data "$plane" others.csv 'run 400\nclear'
  deck grains.data "$plane" plane.csv 'run 400\nclear'
  deck grains.data "$mesh" parts.csv 'run 150\nrun 30\nrun 220'; } > all.in
engine 1 alone.in
for ranks in 1 2 4; do
  engine $ranks all.in
  same mesh.csv parts.csv "one run, and three behind clear, on $ranks ranks"
  for wall in mesh plane others; do
    [ $ranks = 1 ] || same $wall.1.csv $wall.csv "$wall on 1 and $ranks ranks"
    mv $wall.csv $wall.$ranks.csv
  done
done
same alone.csv others.1.csv "a script of its own, and behind clear"
near plane.1.csv mesh.1.csv "tag impact time x y z d_p v1 alpha1_deg delta_alpha_deg tilt_out_deg hits v2 alpha2_deg cor_n cor_t outcome" 1e-6
table a=mesh.1.csv b=plane.1.csv c=alone.csv 'assert len(a) >= 900 and len(b) >= 900 and len(c) >= 900
assert all(r.mesh == 1 and r.triangle >= 0 for r in a) and all(r.mesh == r.triangle == 0 for r in b)
assert all(0 <= r.alpha1_deg <= 90 and 0 <= r.alpha2_deg <= 180 and r.v2 <= r.v1 * (1 + 1e-12) for r in b if r.outcome == 0)' ||
  die "number, mesh and triangle, angles, or speeds of impacts"
