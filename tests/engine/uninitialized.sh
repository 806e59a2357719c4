#!/usr/bin/env bash
# Walls of every shape, at rest and moving, with grains that stick, rest and fly, and with bodies: valgrind sees no use
# of a number that nobody has set. What the engines and MPI do with theirs is not looked at.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
source "$here/body_scene.sh"
command -v valgrind > /dev/null || { echo "no valgrind"; exit 77; }
mkdir checked
for name in liggghts lammps; do
  cat > checked/$name-asperity << END
#!/usr/bin/env bash
exec valgrind --leak-check=no --error-exitcode=9 --suppressions="$work/others" "$bin/$name-asperity" "\$@"
END
  chmod +x checked/$name-asperity
done
for library in 'liblammps*' 'libliggghts*' 'libmpi*' 'libopen-*' 'mca_*' 'libpmix*' 'libhwloc*' 'libevent*' 'libvtk*'; do
  for kind in Cond Value4 Value8; do printf '{\n others\n Memcheck:%s\n obj:*/%s\n}\n' $kind "$library"; done
done > others
bin=$work/checked
use $simulator

meshes
scene() { # WALL [LINES [HEIGHT]]: the first grain comes down hard, the second one flies by, the third one rests
  soft "-0.05 0.05 -0.05 0.05 -0.05 0.25"
  printf '%s\n' "1 0 0 ${3:-0.00401} 0 0 -30" "2 0.01 0 ${3:-0.00401} 3 0 0" "3 0 0.01 ${3:-0.00401} 0 0 0" | put
  echo "fix fly all nve/sphere
fix fall all gravity 9.81 vector 0 0 -1
${2:-}
fix wall all wall/rebound $1 surface sigma 5 materials quartz yield_stress 1e4 surface_energy 30 ledger 10 file rows
timestep 1e-5
run 40
clear"
}
plate='fix plate all mesh/surface file box.stl type 1'
turns="$plate
fix drive all move/mesh mesh plate rotate origin 0. 0. 0. axis 0. 0. 1. period 1e-2"
{
  scene 'primitive type 1 zplane 0'
  scene 'primitive type 1 ycylinder 0.04 0 0' '' -0.03598
  scene 'mesh n_meshes 1 meshes plate' "$plate"
  scene 'mesh n_meshes 1 meshes plate' "$turns"
} > shapes.in
engine 1 shapes.in
falls='fix wall all wall/rebound primitive type 1 zplane -0.02 surface sigma 5 rebound walton 0.9 0.3 0 ledger 10 file rows
timestep 1e-4
run 200'
if [ $simulator = lammps ]; then
  { scene 'region room' 'region room block -0.03 0.03 -0.03 0.03 0 0.1 units box'
    scene 'region room' $'variable a equal 100*time\nregion room cone z 0 0 0.03 0.04 0 0.04 units box rotate v_a 0 0 0 0 0 1'
    scene 'region room' $'variable d equal 0.1*time\nregion room block -0.03 0.03 -0.03 0.03 0 0.1 units box move v_d NULL NULL'
  } > regions.in
  engine 1 regions.in
  source "$here/rigid_scene.sh"
  rigid_data 4 '0.5e-3 0 0 1e-3  -0.5e-3 0 0 1e-3' > data
  { start; go_on rigid/small; echo "velocity all set 0 0 -1.5
${falls/primitive type 1 /}"; } > bodies.in
else
  { bodies 4 random -0.018 -0.012; echo "$falls"; } > bodies.in
fi
engine 1 bodies.in
[ "$(count_rows rows)" -ge 2 ] || die "only $(count_rows rows) impacts of bodies"
