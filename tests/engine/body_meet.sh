#!/usr/bin/env bash
# What bodies of fix multisphere meet besides plates at rest: meshes that turn and shake, periodic edges, a restart, an
# insert/stream, and delete_atoms; on 1, 2 and 4 ranks.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
source "$here/body_scene.sh"

rough="surface rq 5e-6 lambda_c 40e-6 rebound walton 0.7 0.3 0 deposit off"
# Periodic edges: a mesh as wide as the box, and a plane, on any number of ranks.
boundary="p p f" heights="-0.0195 0.005" velocity="1.1 0.7 -0.5" poured 60 edges.bin
stl <<< "-0.021 -0.021 -0.02  0.021 -0.021 -0.02  0.021 0.021 -0.02  -0.021 0.021 -0.02" > floor.stl
edges() { # RANKS GEOMETRY
  { from_restart edges.bin
    echo "fix plate all mesh/surface file floor.stl type 1
fix floor all wall/rebound $2 $rough ledger 1 file edges.csv columns full
fix g all gravity 9.81 vector 0.1 0 -1
timestep 2e-5
run 1500"; } > edges.in
  engine "$1" edges.in
  rows edges.csv | cut -d, -f 1-3,6-
}
edges 1 "mesh n_meshes 1 meshes plate" > mesh.1
edges 4 "mesh n_meshes 1 meshes plate" > mesh.4
edges 2 "primitive type 1 zplane -0.02" > plane.2
[ "$(wc -l < mesh.1)" -gt 40 ] || die "periodic edges: $(wc -l < mesh.1) impacts"
same mesh.1 mesh.4 "a periodic mesh on 4 ranks"; same mesh.1 plane.2 "a periodic mesh and a plane"

# A closed box that turns, or shakes, with 40 bodies: after whole turns all are inside, and none was trapped.
wide=0.009 heights="-0.009 0.009" velocity="0.3 -0.2 0.4" poured 40 cube.bin
cube 0.011 | stl > cube.stl
cube() { # NAME RANKS MOTION STEP STEPS
  { from_restart cube.bin
    echo "fix cube all mesh/surface file cube.stl type 1
fix move all move/mesh mesh cube $3
fix walls all wall/rebound mesh n_meshes 1 meshes cube $rough ledger 1 file $1.csv columns full
fix g all gravity 9.81 vector 0 0 -1
variable out atom (x>0.01051)||(y>0.01051)||(z>0.01051)||(x<-0.01051)||(y<-0.01051)||(z<-0.01051)
compute out all reduce sum v_out
thermo_style custom step atoms c_out f_walls[6]
timestep $4
run $5"; } > cube.in
  engine "$2" cube.in
  rows $1.csv > $1.$2
  last cube.in.screen | awk '{ print $2, $3, $4 }'
}
turn="rotate origin 0 0 0 axis 1 2 3 period 0.02"
[ "$(cube turn 1 "$turn" 2e-5 1000)" = "80 0 0" ] || die "a turning box: $(last cube.in.screen)"
cube turn 2 "$turn" 2e-5 1000 > turn.out
same turn.1 turn.2 "a turning box on 2 ranks"
read -r atoms _ < <(cube far 1 "$turn" 1e-3 20)
[ "$atoms" = 80 ] || die "a turning box at long steps: $(last cube.in.screen)"
read -r atoms _ trapped < <(cube shake 2 "wiggle amplitude 0.004 0.003 0.002 period 0.02" 2e-5 600)
[ "$atoms $trapped" = "80 0" ] || die "a shaken box: $(last cube.in.screen)"

# LIGGGHTS loses bodies across a periodic edge as it reads a restart file.
floor="fix floor all wall/rebound primitive type 1 zplane -0.02 rebound constant 1 1
timestep 2e-5"
lose() {
  { bodies 200 random -0.012 0.019; echo "$floor
run 400
write_restart lost.bin"; } > made.in
  engine 1 made.in
  { from_restart lost.bin; echo "$floor
run 1"; } > lost.in
  engine 2 lost.in
}
boundary="p p f" wide=0.021 velocity="1.1 0.7 0" lose
grep -q "the restart file has 200 bodies, and 19. are left" lost.in.screen || die "lost bodies: $(grep WARN lost.in.screen)"

# Bodies of an insert/stream meet no wall until they are released.
stl <<< "-0.01 -0.01 0.015  0.01 -0.01 0.015  0.01 0.01 0.015" > face.stl
stream() { # HEIGHT of the floor
  bodies 1 random -0.012 0.019 | sed '/^fix ins /d'
  echo "fix face all mesh/surface/planar file face.stl type 1
fix ins all insert/stream seed 123457 distributiontemplate d1 nparticles 100 particlerate 20000 vel constant 0 0 -1 overlapcheck yes orientation random insertion_face face extrude_length 0.005
fix floor all wall/rebound primitive type 1 zplane $1 rebound walton 0.5 0.3 0 deposit freeze ledger 1 file stream.csv columns full
fix g all gravity 9.81 vector 0 0 -1
timestep 2e-5
run 1200"
}
stream 0.01 > stream.in
engine 2 stream.in
table a=stream.csv 'first = {row.body: row for row in reversed(a)}
assert len(first) == 100 and all(row.v1z <= -0.9 for row in first.values())' || die "a stream"

# delete_atoms takes away whole bodies, and what they remember.
{ from_restart cube.bin; echo "fix floor all wall/rebound primitive type 1 zplane -0.02 rebound constant 0 0 deposit freeze
fix g all gravity 98.1 vector 0 0 -1
region half block INF 0 INF INF INF INF units box
timestep 2e-5
run 1200
delete_atoms region half
thermo_style custom step atoms c_ke f_floor[2]
run 800"; } > half.in
engine 2 half.in
read -r _ atoms ke deposits < <(last half.in.screen)
[ $((atoms % 2)) = 0 ] && [ "$atoms" -gt 20 ] && [ "$atoms" -lt 80 ] && [ "$ke" = 0 ] && [ "$deposits" -ge "$((atoms / 2))" ] || die "deleted bodies: $(last half.in.screen)"
