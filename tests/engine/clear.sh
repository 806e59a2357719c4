#!/usr/bin/env bash
# `clear` in a script leaves the fix style known: what is run after it is what a script of its own would run,
# on a mesh and on a plane, as often as it is cleared.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
grains 200 > grains.data
grains 100 1 1 1 777 > others.data
plate 4 1 3.9e-3 > plate.stl
scene() { # data, wall, ledger
  head_of si | sed 's/boundary.*/boundary m m f/'
  echo "read_data $1
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all"
  materials
  echo "fix plate all mesh/surface file plate.stl type 2
fix wall all wall/rebound $2 surface rq 10e-6 lambda_c 90e-6 rebound bons deposit freeze seed 4 ledger 100 file $3
fix move all nve/sphere
timestep 2e-8
run 300"
}
mesh='mesh n_meshes 1 meshes plate' plane='primitive type 2 zplane 0.0'
scene grains.data "$mesh" alone1.csv > alone1.in
scene others.data "$plane" alone2.csv > alone2.in
{ scene grains.data "$mesh" first.csv; echo clear
  scene others.data "$plane" second.csv; echo clear
  scene grains.data "$mesh" third.csv; } > cleared.in
for ranks in 1 2; do
  engine $ranks alone1.in
  engine $ranks alone2.in
  engine $ranks cleared.in
  [ "$(count_rows alone1.csv)" -gt 100 ] && [ "$(count_rows alone2.csv)" -gt 50 ] || die "too few impacts for this test"
  same <(rows alone1.csv) <(rows first.csv) "the script before clear, $ranks ranks"
  same <(rows alone2.csv) <(rows second.csv) "the script after clear, $ranks ranks"
  same <(rows alone1.csv) <(rows third.csv) "the script after the second clear, $ranks ranks"
done
