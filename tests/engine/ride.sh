#!/usr/bin/env bash
# Grains that ride on walls for long. LIGGGHTS: no row where a grain slides over the edges of a flat mesh. LAMMPS: none is
# trapped on a cone or in a room that turns, and a grain without friction keeps its energy.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
if [ $simulator = liggghts ]; then # the rows of grains that come to slide on a plane, and on a mesh
  awk 'BEGIN { n = 7; for (i = 0; i < n; i++) for (j = 0; j < n; j++) { a = 0.1 / n; x = -0.05 + i * a; y = -0.05 + j * a
    print x, y, 0, x + a, y, 0, x + a, y + a, 0, x, y + a, 0 } }' | stl > floor.stl
  for kind in "primitive type 1 zplane 0.0" "mesh n_meshes 1 meshes floor"; do
    { boundary="p p m" soft "-0.05 0.05 -0.05 0.05 -0.06 0.06" 0 1
      awk 'BEGIN { for (i = 0; i < 49; i++) printf "%d %.9g %.9g 0.0049 1.3 0.7 -0.3\n", i + 1, -0.042 + 0.014 * (i % 7), -0.042 + 0.014 * int(i / 7) }' | put 0.002
      echo "neigh_modify exclude group all all
fix fall all gravity 9.81 vector 0 0 -1
fix floor all mesh/surface file floor.stl type 1
fix wall all wall/rebound $kind rebound constant 0.5 1 friction 0 deposit off ledger 1000 file ${kind%% *}.csv
fix move all nve/sphere
timestep 1e-5
thermo 100000
run 60000"; } > floor.in
    engine 1 floor.in
  done
  near primitive.csv mesh.csv 'tag impact time x y z v1 alpha1_deg v2 alpha2_deg outcome' 1e-6
  table a=mesh.csv 'assert len(a) >= 400 and not any(row.time > 0.4 for row in a)' || die "rows of grains that slide over the edges of a mesh"
  exit
fi

program=$bin/lammps-asperity
head='units si
atom_style sphere
atom_modify map array
boundary f f f
comm_modify vel yes'
cat > cone.in << END
$head
region box block -0.05 0.05 -0.05 0.05 -0.01 0.06 units box
create_box 1 box
region funnel cone z 0 0 0.001 0.041 0 0.04 units box open 1 open 2
fix wall all wall/rebound region funnel rebound constant 0.5 1 friction 0 deposit off
create_atoms 1 single 0.0195957 0 0.02001 units box
set atom 1 diameter 2e-3 density 2500
velocity all set 0 0.5 0
fix fall all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
timestep 2e-5
variable e equal 0.5*(vx[1]^2+vy[1]^2+vz[1]^2)+9.81*z[1]
thermo_style custom step v_e f_wall[6]
thermo 100
run 10000
END
engine 1 cone.in
table a=cone.in.screen 'a = a[10:]
assert len(a) > 80 and all(near(row[1], a[0][1], 1e-3) and row[2] == 0 for row in a)' || die "a grain that slides around on a cone"

# A room that turns with a grain that is pressed against its walls.
cube 6 | stl > room.stl
for wall in "region room" "stl room.stl move rotate 0 0 0 0 0 1 7.5"; do
  cat > room.in << END
$head
region box block -10 10 -10 10 -10 10 units box
create_box 1 box
create_atoms 1 single 3 -5.5 0 units box
set group all diameter 1 density 1
neighbor 0.3 bin
timestep 0.005
variable theta equal step*0.0041887902
region room block -6 6 -6 6 -6 6 units box rotate v_theta 0 0 0 0 0 1
fix wall all wall/rebound $wall rebound walton 0.5 0.5 0 deposit off
fix move all nve/sphere
thermo_style custom step f_wall f_wall[6]
thermo 4000
run 4000
END
  engine 1 room.in
  table a=room.in.screen 'assert a[-1][0] == 4000 and a[-1][1] <= 400 and a[-1][2] == 0, a' || die "$wall: a grain that rides"
done
