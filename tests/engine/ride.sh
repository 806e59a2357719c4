#!/usr/bin/env bash
# Grains that ride on walls for long: no kick out of nothing in a slow drum or in a shaken box, no row where a grain
# slides over the edges of a flat mesh, and none trapped by a wall that turns. The long runs are LIGGGHTS's: in LAMMPS
# their walls are the same code.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
fastest() { awk 'NF == 2 && $1 ~ /^[0-9]+$/ && $2 > most { most = $2 } END { print most }' fastest.txt; }
watch='variable speed atom sqrt(vx*vx+vy*vy+vz*vz)
compute fastest all reduce max v_speed
fix watch all ave/time 1 1 1 c_fastest file fastest.txt'
screw() { # outlines: a closed tube of K sides about y
  awk -v k=48 -v r=0.04 -v h=0.015 'BEGIN { for (i = 0; i < k; i++) { a = 8 * atan2(1, 1) * i / k; b = 8 * atan2(1, 1) * (i + 1) / k
    x = r * cos(a); z = r * sin(a); u = r * cos(b); w = r * sin(b)
    print x, -h, z, u, -h, w, u, h, w, x, h, z; print 0, -h, 0, x, -h, z, u, -h, w; print 0, h, 0, x, h, z, u, h, w } }'
}

# One grain in a drum that turns at 0.13 m/s, over 1.3e5 steps: not faster than by its fall.
turning=130000
[ $simulator = liggghts ] || turning=20000
screw | stl > drum.stl
{ soft "-0.045 0.045 -0.018 0.018 -0.045 0.045" 0.5 0.5
  echo "1 0 0 -0.02 0 0 0" | put 0.004
  echo "fix fall all gravity 9.81 vector 0 0.1 -1
fix drum all mesh/surface file drum.stl type 1
fix turn all move/mesh mesh drum rotate origin 0. 0. 0. axis 0. 1. 0. period 2.
fix wall all wall/rebound mesh n_meshes 1 meshes drum rebound walton 0.5 0.5 0 deposit off
fix move all nve/sphere
timestep 3e-5
$watch
thermo_style custom step f_wall[6]
thermo $turning
run $turning"; } > drum.in
engine 1 drum.in
echo "drum: largest speed $(fastest) m/s"
awk -v v="$(fastest)" 'BEGIN { exit !(v > 0.1 && v < 0.9) }' || die "a grain in a slow drum gets $(fastest) m/s"
! grep -E '^ +[0-9]+ +[1-9][0-9]* *$' drum.in.screen || die "drum: guarded"

# A box of triangles that is shaken by 1 mm at 20 Hz: no grain is lost, trapped, or faster than it has fallen.
stl > box.stl << END
-0.025 -0.025 0  0.025 -0.025 0  0.025 0.025 0  -0.025 0.025 0
-0.025 -0.025 0.2  0.025 -0.025 0.2  0.025 0.025 0.2  -0.025 0.025 0.2
-0.025 -0.025 0  -0.025 0.025 0  -0.025 0.025 0.2  -0.025 -0.025 0.2
0.025 -0.025 0  0.025 0.025 0  0.025 0.025 0.2  0.025 -0.025 0.2
-0.025 -0.025 0  0.025 -0.025 0  0.025 -0.025 0.2  -0.025 -0.025 0.2
-0.025 0.025 0  0.025 0.025 0  0.025 0.025 0.2  -0.025 0.025 0.2
END
{ soft "-0.06 0.06 -0.06 0.06 -0.06 0.25" 0.5 0.5
  stack 5 5 6 0.0085 0.3 | awk '{ $4 += 0.002; print }' | put 0.004
  echo "fix fall all gravity 9.81 vector 0 0 -1
fix box all mesh/surface file box.stl type 1
fix shake all move/mesh mesh box wiggle amplitude 0. 0. 0.001 period 0.05
fix wall all wall/rebound mesh n_meshes 1 meshes box rebound constant 0.5 0.9 deposit off
fix move all nve/sphere
timestep 3e-5
$watch
variable in atom z>-0.002
compute in all reduce sum v_in
thermo_style custom step f_wall[6] c_in
thermo 15000
run 15000"; } > shake.in
engine 1 shake.in
echo "shaken box: largest speed $(fastest) m/s"
awk -v v="$(fastest)" 'BEGIN { exit !(v > 0.1 && v < 1.6) }' || die "a grain in a shaken box gets $(fastest) m/s"
grep -qE '^ +15000 +0 +150 *$' shake.in.screen || { grep -E '^ +15000 ' shake.in.screen; die "shaken box: guarded, or grains lost"; }

# Grains that come to slide on a flat mesh have the rows of those on a plane.
awk 'BEGIN { n = 7; for (i = 0; i < n; i++) for (j = 0; j < n; j++) { a = 0.1 / n; x = -0.05 + i * a; y = -0.05 + j * a
  print x, y, 0, x + a, y, 0, x + a, y + a, 0, x, y + a, 0 } }' | stl > floor.stl
floor() { # wall
  boundary="p p m" soft "-0.05 0.05 -0.05 0.05 -0.06 0.06" 0 1
  awk 'BEGIN { for (i = 0; i < 49; i++) printf "%d %.9g %.9g 0.0049 1.3 0.7 -0.3\n", i + 1, -0.042 + 0.014 * (i % 7), -0.042 + 0.014 * int(i / 7) }' | put 0.002
  echo "neigh_modify exclude group all all
fix fall all gravity 9.81 vector 0 0 -1
$1 rebound constant 0.5 1 friction 0 deposit off ledger 1000 file rows.csv
fix move all nve/sphere
timestep 1e-5
thermo 100000
run 60000"
}
if [ $simulator = liggghts ]; then
  for kind in plane mesh; do
    wall="fix wall all wall/rebound primitive type 1 zplane 0.0"
    [ $kind = plane ] || wall="fix floor all mesh/surface file floor.stl type 1
fix wall all wall/rebound mesh n_meshes 1 meshes floor"
    floor "$wall" > floor.in
    rm -f rows.csv
    engine 1 floor.in
    mv rows.csv $kind.csv
  done
  [ "$(count_rows plane.csv)" -ge 400 ] || die "only $(count_rows plane.csv) impacts on the plane"
  near plane.csv mesh.csv '1 2 3 6 7 8 10 11 15 16 19' 1e-6
  ! rows mesh.csv | awk -F, '$3 > 0.4' | grep . || die "rows of grains that slide over the edges of a mesh"
fi

# A grain slides around on a cone without friction: it keeps its energy, and is not trapped.
if [ $simulator = lammps ]; then
  cat > cone.in << END
units si
atom_style sphere
atom_modify map array
boundary f f f
comm_modify vel yes
region box block -0.05 0.05 -0.05 0.05 -0.01 0.06 units box
create_box 1 box
region funnel cone z 0 0 0.001 0.041 0 0.04 units box open 1 open 2
fix wall all wall/rebound region funnel rebound constant 0.5 1 friction 0 deposit off
create_atoms 1 single 0.01960 0 0.02001 units box
set atom 1 diameter 2e-3 density 2500
velocity all set 0 0.5 0
fix fall all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
timestep 2e-5
variable e equal 0.5*(vx[1]^2+vy[1]^2+vz[1]^2)+9.81*z[1]
thermo_style custom step v_e f_wall f_wall[6]
thermo 100
run 10000
END
  "$bin/lammps-asperity" -in cone.in -log none > cone.screen 2>&1 || { tail cone.screen; die "a grain on a cone"; }
  awk 'NF == 4 && $1 ~ /^[0-9]+$/ && $1 >= 1000 { n++; if (!e) e = $2; d = ($2 - e) / e; if (d * d > worst * worst) worst = d; hits = $3; guarded = $4 }
    END { printf "cone: energy off by %.2g, %d impacts, %d guarded\n", worst, hits, guarded; exit !(n > 80 && worst * worst < 1e-6 && guarded == 0) }' cone.screen ||
    die "a grain that slides around on a cone"
fi

# A room of LAMMPS that turns with a grain that is pressed against its walls.
[ $simulator = lammps ] || exit 0
for wall in "region room" "stl room.stl move rotate 0 0 0 0 0 1 7.5"; do
  cube 6 | stl > room.stl
  echo "units si
atom_style sphere
boundary f f f
comm_modify vel yes
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
run 4000" > room.in
  "$bin/lammps-asperity" -in room.in -log none > room.screen 2>&1 || { tail room.screen; die "$wall"; }
  echo "${wall%% *} that turns: impacts and guarded $(awk '$1 == 4000 { print $2, $3 }' room.screen)"
  awk '$1 == 4000 && NF == 3 { n++; bad = $2 > 400 || $3 > 0 } END { exit bad || n != 1 }' room.screen || die "$wall: impacts or guarded contacts of a grain that rides"
done
