#!/usr/bin/env bash
# LAMMPS's reference logs beside the example for its examples/PACKAGES: the thermo tables of a run on 1 and 4 ranks are those of the log.
#   logs.sh lammps             compares
#   logs.sh lammps --write     writes the logs anew
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
folder=$(cd "$here/../../cmake/lammps/examples" && pwd)
cp "$folder"/{in.dust,plate.stl} .
table() { awk '/^Step / { on = 1 } /^Loop time/ { on = 0 } on { $1 = $1; print }' "$1"; }
for ranks in 1 4; do
  log=log.29Sep2021.dust.g++.$ranks
  mpirun -np $ranks "$bin/lammps-asperity" -in in.dust -log $log > screen 2>&1 || { tail -n 3 screen; die "$ranks ranks"; }
  if [ "${1:-}" = --write ]; then cp $log "$folder"; continue; fi
  [ "$(table $log | wc -l)" -ge 10 ] || die "$log has no table"
  diff <(table "$folder/$log") <(table $log) || die "not the numbers of cmake/lammps/examples/$log"
done
