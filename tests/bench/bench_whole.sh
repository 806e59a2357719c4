#!/usr/bin/env bash
# Whole loops: the jet of the flat plate, 20 164 grains, 2000 steps, 1 rank, with a wall over the same run without one;
# this wall and the engines' own. The shortest of ten interleaved rounds each, since other work on the machine makes rounds
# longer only, and by up to a third; and the spread of the rounds.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "${BASH_SOURCE[0]}")/engine.sh"
mkdir output
awk -f "$home/examples/flat_plate/make_jet.awk" > output/jet.data
for cells in 20 224; do
  sed "s/CELLS = 20/CELLS = $cells/" "$home/examples/flat_plate/make_plate.awk" | awk -f - > $cells.stl
done
law='materials quartz hastelloy-x surface rq 15.6e-6 lambda_c 120e-6 seed 1'

# Lines that make a wall, by engine and name.
walls_lammps=(none plane 800 100352 region gran_plane gran_region)
lammps_none=''
lammps_plane="fix wall all wall/rebound zplane 0.0 type 2 $law"
lammps_800="fix wall all wall/rebound stl 20.stl type 2 $law"
lammps_100352="fix wall all wall/rebound stl 224.stl type 2 $law"
room='region room block -1 1 -1 1 0 1 units box'
lammps_region="$room
fix wall all wall/rebound region room type 2 $law"
lammps_gran_plane='fix wall all wall/gran hooke/history 1.0 NULL 1e3 NULL 0.3 1 zplane 0.0 NULL'
lammps_gran_region="$room
fix wall all wall/gran/region hooke/history 1.0 NULL 1e3 NULL 0.3 1 region room"
walls_liggghts=(none 800 100352 gran_800)
mesh() { echo "fix plate all mesh/surface file $1.stl type 2"; }
liggghts_none=''
liggghts_800="$(mesh 20)
fix wall all wall/rebound mesh n_meshes 1 meshes plate $law"
liggghts_100352="$(mesh 224)
fix wall all wall/rebound mesh n_meshes 1 meshes plate $law"
liggghts_gran_800="$(mesh 20)
fix wall all wall/gran model hertz tangential history mesh n_meshes 1 meshes plate"

deck_of() { # ENGINE WALL: the example's script with another wall
  local name=$1_$2
  sed "$([ "$1" = lammps ] || echo '/^fix plate/d;')/^fix wall/,/ledger/d; s/ f_wall.*//; s/^thermo .*/thermo 2000/" \
    "$home/examples/flat_plate/in.flat_plate$([ "$1" = liggghts ] || echo .lammps)" > "$name.in"
  printf '%s\n' "${!name}" > wall
  sed -i '/^fix move/r wall' "$name.in"
}
declare -A wanted=([lammps_plane]=1.25 [lammps_800]=1.3 [lammps_100352]=1.4 [lammps_region]=1.25 [liggghts_800]=1.02 [liggghts_100352]=1.05)
for which in lammps liggghts; do
  [ -x "$bin/$which-asperity" ] || continue
  declare -n walls=walls_$which
  for round in {1..10}; do
    for wall in "${walls[@]}"; do
      name=${which}_$wall
      deck_of $which "$wall"
      mpirun -np 1 "$bin/$which-asperity" -in "$name.in" -log none > "$name.in.screen" 2>&1 || { tail -n 5 "$name.in.screen" >&2; exit 1; }
      loop_seconds "$name.in" >> "$name.loop"
    done
  done
  row "$which, the jet's loop without a wall" "$(least < ${which}_none.loop)" s
  for wall in "${walls[@]:1}"; do
    case $wall in gran_*) what="... its own wall/gran, ${wall#gran_}" ;; [0-9]*) what="... $wall triangles" ;; *) what="... $wall" ;; esac
    limit=${wanted[${which}_$wall]:-}
    row "$what, over that without" "$(calc "$(least < "${which}_$wall.loop") / $(least < ${which}_none.loop)")" \
      "x ($(spread "${which}_$wall.loop" ${which}_none.loop))" ${limit:+"<=" "$limit"}
  done
done
