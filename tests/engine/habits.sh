#!/usr/bin/env bash
# Habits of users of LAMMPS's walls: numbers of each atom for dumps and other fixes, a mesh that fix_modify moves
# and dump image draws, across a restart; LAMMPS's own examples with one line exchanged.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
use lammps
lammps() { # RANKS SCRIPT: a script in LAMMPS's own language
  timeout 100 mpirun -np "$1" "$bin/lammps-asperity" -in "$2" -log none < /dev/null > "$2.screen" 2>&1 ||
    { grep -a ERROR "$2.screen" >&2 || tail -n 3 "$2.screen" >&2; die "$2 on $1 ranks"; }
}
plate 2 1 2e-3 > plate.stl
head=$(cat << 'END'
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
END
)
scene="$head
region box block -0.003 0.003 -0.003 0.003 -0.003 0.003 units box
create_box 2 box
neighbor 2e-5 bin
pair_style none
create_atoms 1 single 1e-3 1e-3 1.05e-4 units box
create_atoms 1 single 5e-4 5e-4 2e-3 units box
set group all diameter 1e-5 density 2650
fix move all nve/sphere
timestep 1e-6"

# Impacts and whether it is stuck, of each atom, also as a variable's and a compute's input.
cat > atoms.in << END
$scene
velocity all set 0 0 -1 units box
fix wall all wall/rebound stl plate.stl type 2 materials quartz hastelloy-x surface_energy 1e4
fix fly all wall/rebound zplane -1e-3 rebound constant 0.5 0.5 deposit off
compute most all reduce max f_wall[1] f_wall[2]
fix state all store/state 1 f_wall[2]
variable stuck atom f_state==1
variable stuck_now equal count(stuck)
group stuck dynamic all var stuck every 1
thermo_style custom step c_most[1] c_most[2] f_wall f_wall[2] v_stuck_now
dump rows all custom 150 rows.txt id f_wall[1] f_wall[2] f_fly[1]
dump_modify rows sort id
run 150
END
for ranks in 1 2; do
  lammps $ranks atoms.in
  [ "$(tail -n 2 rows.txt | tr -s ' \n' ' ;')" = "1 1 1 0;2 0 0 0;" ] || { tail -n 2 rows.txt; die "numbers of each atom"; }
  grep -Eq '^ +150 +1 +1 +1 +1 +1 *$' atoms.in.screen || die "their maxima and the counters: $(grep -E '^ +150 ' atoms.in.screen)"
done

# A plate that takes a stuck particle along: 100 steps to the right at 1 m/s, then up at 2 m/s, and a restart within.
# The numbers of the wall are kept, and in two runs it arrives where one run takes it.
wall='fix wall all wall/rebound stl plate.stl type 2 move linear 1 0 0 materials quartz hastelloy-x surface_energy 1e4 ledger 1 file moved.csv'
up='fix_modify wall move linear 0 0 2'
dump='dump at all custom 1 at.txt id x y z vx vy vz f_wall[1] f_wall[2]
dump_modify at sort id format float %.15g'
printf '%s\nvelocity all set 0 0 -1 units box\n%s\nrun 200\n%s\nrun 50\nwrite_restart half.restart\n%s\nrun 50\n' "$scene" "$wall" "$up" "$dump" > whole.in
printf '%s\nread_restart half.restart\nneighbor 2e-5 bin\npair_style none\nfix move all nve/sphere\ntimestep 1e-6\n%s\n%s\nrun 50\n' "$head" "$wall" "$dump" > half.in
sed -i '/^\(atom_style\|units\|boundary\|newton\)/d' half.in
lammps 2 whole.in; mv at.txt whole.txt; lammps 1 half.in
same <(tail -n 2 whole.txt) <(tail -n 2 at.txt) "a mesh that fix_modify has moved, after a restart"
# It sticks after 100 us (its radius over the plate), so at x = 1 mm; from then on it goes with the plate.
tail -n 2 whole.txt | head -n 1 | awk '{ d = $2 - 1.1e-3; e = $4 - 2.05e-4; exit !(d * d < 1e-22 && e * e < 1e-22 && $5 == 0 && $7 == 2 && $8 == 1 && $9 == 1) }' ||
  { tail -n 2 whole.txt; die "where the plate takes it"; }
refuses() { # LINE WORD...: a line behind the scene ends the run with one error that says these words
  printf '%s\n%s\nrun 1\n' "$scene" "$1" > refused.in; shift
  if timeout 60 "$bin/lammps-asperity" -in refused.in -log none < /dev/null > refused.in.screen 2>&1; then die "not refused: $*"; fi
  for word in "$@"; do grep '^ERROR' refused.in.screen | grep -qF -- "$word" || { tail -n 3 refused.in.screen; die "no word of '$word'"; }; done
}
stl='fix wall all wall/rebound stl plate.stl rebound constant 1 1'
refuses "$stl
fix_modify wall move jump 1" "move is 'jump'" "linear, wiggle or rotate" "fix_wall_rebound.cpp"
refuses "$stl
fix_modify wall energy yes" "fix_modify"
refuses "fix wall all wall/rebound zplane 0 rebound constant 1 1
$up" "for the wall 'stl'" "'shear'"
# Planes in the words of fix wall/gran.
for second in NULL 100; do
  refuses "fix wall all wall/rebound zplane 0 $second rebound constant 1 1" "'$second' stands behind 'zplane 0 type 2'" "a fix of its own"
done

# A picture: the same with and without the plate differ, on one rank or two.
for ranks in 1 2; do
  printf '%s\n%s\ndump d all image 1 picture.%s.*.ppm type type fix wall type 1 0 size 64 64\ndump_modify d pad 1\nrun 0\n' "$scene" "$stl" $ranks > picture.in
  lammps $ranks picture.in
done
same picture.1.0.ppm picture.2.0.ppm "a picture by one rank and by two"
sed 's/ fix wall type 1 0//; s/picture\.2/bare/' picture.in > bare.in; lammps 1 bare.in
cmp -s picture.1.0.ppm bare.0.ppm && die "the plate is not in the picture"
exit 0
