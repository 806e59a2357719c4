#!/usr/bin/env bash
# Habits of users of LAMMPS's walls: numbers of each atom for dumps and other fixes; planes in the words of fix wall/gran.
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

refuses() { # LINE WORD...: a line behind the scene ends the run with one error that says these words
  printf '%s\n%s\nrun 1\n' "$scene" "$1" > refused.in; shift
  if timeout 60 "$bin/lammps-asperity" -in refused.in -log none < /dev/null > refused.in.screen 2>&1; then die "not refused: $*"; fi
  for word in "$@"; do grep '^ERROR' refused.in.screen | grep -qF -- "$word" || { tail -n 3 refused.in.screen; die "no word of '$word'"; }; done
}
# Planes in the words of fix wall/gran.
for second in NULL 100; do
  refuses "fix wall all wall/rebound zplane 0 $second rebound constant 1 1" "'$second' stands behind 'zplane 0 type 2'" "a fix of its own"
done
