#!/usr/bin/env bash
# LAMMPS's reference logs beside the examples: the thermo tables of a run on 1 and 4 ranks are those of the log.
#   logs.sh lammps             compares
#   logs.sh lammps --write     writes the logs anew
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
folder=$(cd "$here/../../examples/flat_plate" && pwd)
mkdir output
awk -f "$folder/make_plate.awk" > output/plate.stl
awk -f "$folder/make_jet.awk" > output/jet.data
table() { awk '/^Step / { on = 1 } /^Loop time/ { on = 0 } on { $1 = $1; print }' "$1"; }
for ranks in 1 4; do
  log=log.29Sep2021.flat_plate.g++.$ranks
  mpirun -np $ranks "$bin/lammps-asperity" -in "$folder/in.flat_plate.lammps" -var name plate \
    -var surface "rq 15.6e-6 lambda_c 120e-6" -log $log > screen 2>&1 || { tail -n 3 screen; die "$ranks ranks"; }
  if [ "${1:-}" = --write ]; then cp $log "$folder"; continue; fi
  [ "$(table $log | wc -l)" -ge 10 ] || die "$log has no table"
  diff <(table "$folder/$log") <(table $log) || die "not the numbers of examples/flat_plate/$log"
done
