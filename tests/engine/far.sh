#!/usr/bin/env bash
# Paths of millions of radii in one step end in a short time: one that flies away from a mesh, and one in a closed box,
# whose contacts are cut off with a warning and leave the grain in the box.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
cube 0.05 | stl > box.stl
{ soft "-0.1 0.1 -0.1 0.1 -0.1 0.1" 0 1 | sed 's/^boundary .*/boundary p p p/; s/^atom_modify .*/atom_modify map array sort 0 0/'
  printf '1 0.01 0 0 2e5 1e5 1.7e5\n2 0.08 0.08 0.08 1 0 0\n' | put 0.001
  echo "fix box all mesh/surface file box.stl type 1
fix wall all wall/rebound mesh n_meshes 1 meshes box rebound constant 1 1 friction 0 deposit off
fix move all nve/sphere
timestep 1e-2
thermo_style custom step f_wall
thermo 1
dump at all custom 1 at.txt id x y z
dump_modify at sort id
run 1"; } > far.in
SECONDS=0
TIMEFORMAT=%U
seconds=$( { time engine 1 far.in; } 2>&1 )
echo "a path of 5e6 radii in a step: $seconds s"
awk -v s="$seconds" 'BEGIN { exit !(s < 5) }' || die "a path of 5e6 radii takes $seconds s"
grep -q "more than 10000 contacts in one step" far.in.screen || die "no warning that contacts were cut off"
tail -n 2 at.txt | awk '$1 == 1 { n++; for (k = 2; k <= 4; k++) if ($k * $k > 0.0496 * 0.0496) bad = 1 } END { exit bad || n != 1 }' || { tail -n 2 at.txt; die "the grain has left the box"; }
