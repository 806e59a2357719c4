# Bodies of LIGGGHTS's fix multisphere, for the engine tests.
# SPDX-License-Identifier: GPL-3.0-or-later

# bodies COUNT ORIENTATION LOW HIGH [SPHERES]: the beginning of a script with dumbbells of 1 mm spheres in a cube of 40
# mm, inserted between two heights; they do not meet each other.
bodies() {
  soft "-0.021 0.021 -0.021 0.021 -0.021 0.021" 0
  echo "neighbor 1e-3 bin
neigh_modify exclude group all all
fix t1 all particletemplate/multisphere 15485863 atom_type 1 density constant 2500 ${5:-nspheres 2 ntry 2000000 spheres 0 0 0 0.5e-3 1e-3 0 0 0.5e-3} type 1
fix d1 all particledistribution/discrete 32452843 1 t1 1.0
region in block -${wide:-0.018} ${right:-${wide:-0.018}} -${wide:-0.018} ${wide:-0.018} $3 $4 units box
fix ins all insert/pack seed 123457 distributiontemplate d1 vel constant ${velocity:-0 0 -1.5} insert_every once overlapcheck yes orientation $2 all_in yes particles_in_region $1 region in
fix integr all multisphere
compute ke all ke/multisphere
compute re all erotate/multisphere
thermo_style custom step atoms c_ke c_re"
}
closed() { # WORDS: six walls
  for plane in x y z; do for at in -0.02 0.02; do
    echo "fix ${plane}${at#-0.02} all wall/rebound primitive type 1 ${plane}plane $at $*"
  done; done | sed 's/^fix \(.\) /fix \1lo /; s/^fix \(.\)0.02 /fix \1hi /'
}
last() { grep -E '^ +[0-9]+ +[0-9]+ +[0-9.e+-]+ ' "$1" | tail -n 1; }

# The engine inserts by rank: poured COUNT FILE writes bodies to a restart file, from_restart FILE begins a script with
# them, for the same ones on any number of ranks.
poured() {
  { bodies "$1" random ${heights:--0.012 0.019}; echo "timestep 2e-5
run 1
write_restart $2"; } > make.in
  engine 1 make.in
}
from_restart() {
  bodies 1 random -0.012 0.019 | sed "/^region box/d; s/^create_box.*/read_restart $1/; /^fix ins /d; /^fix d1 /d; /^fix t1 /d; /^region in /d"
}
