#!/usr/bin/env bash
# The wall as a plugin of another LAMMPS gives the ledger of lammps-asperity, after `clear` too; in a LAMMPS of another
# version the plugin ends with a message. Skipped where there is no LAMMPS with the package PLUGIN. Usage: plugin.sh PLUGIN
# SPDX-License-Identifier: GPL-3.0-or-later
plugin=$1
source "$(dirname "$0")/engine.sh"
lmp=${ASPERITY_LMP:-$(command -v lmp || true)}
[ -n "$lmp" ] || { echo "no lmp in the path"; exit 77; }
"$lmp" -h 2> /dev/null < /dev/null > help.txt
grep -qw PLUGIN help.txt || { echo "$lmp has no package PLUGIN"; exit 77; }
use lammps
grains 300 > grains.data
plate 4 1 3.9e-3 > plate.stl
script() { # ledger
  head_of si | sed 's/boundary.*/boundary m m f/; s/atom_style.*/atom_style sphere/; s/communicate.*/comm_modify vel yes/; /hard_/d'
  echo "read_data grains.data
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all
fix wall all wall/rebound stl plate.stl type 2 materials quartz hastelloy-x surface rq 10e-6 lambda_c 90e-6 seed 4 ledger 60 file $1
fix move all nve/sphere
timestep 1e-8
run 300"
}
script here.csv > here.in
engine 1 here.in
{ echo "plugin load $plugin"; script first.csv; echo clear; script second.csv; } > there.in
if ! timeout 120 mpirun -np 2 "$lmp" -in there.in -log none > there.screen 2>&1; then
  if grep -q "^ERROR: wallreboundplugin.so: the version of LAMMPS is .*, but it was built for " there.screen; then
    echo "another version of LAMMPS, refused as it must be"; exit 77
  fi
  tail -n 5 there.screen; die "the plugin in $lmp"
fi
for ledger in first second; do same here.csv $ledger.csv "launcher and plugin"; done
