#!/usr/bin/env bash
# A granular gas in equilibrium: elastic grains that do not meet, in a closed box of rough walls, stay uniform and
# isotropic with the default model, and not with the paper's. `equilibrium.sh liggghts long [SPREAD ...]`,
# or lammps, prints the table of tests/sweep/README.md: for each spread the density within 5 % of the box from a wall over
# the mean
# density, of a box of six rough walls, and v_x^2 and v_z^2 of a box whose bottom z alone is rough; each with its
# standard error.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
sigma=20
grains=2000 steps=150
[ "${1:-}" != long ] || { grains=10000 steps=420; }

# Grains of 10 um in a box of 1 mm, at places and directions that are uniform, with 1 m/s.
awk -v n=$grains 'BEGIN { srand(7); print "gas\n\n" n " atoms\n1 atom types\n\n-2e-5 1.02e-3 xlo xhi\n-2e-5 1.02e-3 ylo yhi\n-2e-5 1.02e-3 zlo zhi\n\nAtoms\n"
  for (i = 1; i <= n; i++) print i, 1, 1e-5, 2650, 5e-6 + 9.9e-4 * rand(), 5e-6 + 9.9e-4 * rand(), 5e-6 + 9.9e-4 * rand()
  print "\nVelocities\n"
  for (i = 1; i <= n; i++) { z = 2 * rand() - 1; a = 6.283185307 * rand(); r = sqrt(1 - z * z); print i, r * cos(a), r * sin(a), z, 0, 0, 0 } }' > gas.data

# box MODEL ROUGH: the script of a box whose planes in ROUGH have this spread; the others are smooth.
box() {
  echo "units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
read_data gas.data
neighbor 2e-5 bin
neigh_modify delay 0 exclude group all all
$(springs 0)
fix move all nve/sphere"
  for plane in xlo xhi ylo yhi zlo zhi; do
    place=0; [[ $plane == *lo ]] || place=1e-3
    surface=; [[ " $2 " != *" $plane "* ]] || surface="surface sigma $sigma spread $1"
    echo "fix $plane all wall/rebound primitive type 1 ${plane:0:1}plane $place $surface rebound constant 1 1 deposit off"
  done
  echo "variable near atom (x<5.45e-5)||(x>9.455e-4)||(y<5.45e-5)||(y>9.455e-4)||(z<5.45e-5)||(z>9.455e-4)
variable xx atom vx*vx
variable zz atom vz*vz
compute near all reduce ave v_near
compute xx all reduce ave v_xx
compute zz all reduce ave v_zz
timestep 4e-4
thermo 2
thermo_style custom step c_near c_xx c_zz
run $steps"
}
# states SCREEN: near, v_x^2, v_z^2 over the last two thirds, each with its standard error from eight parts.
states() {
  awk -v steps=$steps '/^ +[0-9]+ +[0-9.e-]+ +[0-9.e-]+ +[0-9.e-]+ *$/ && $1 > steps / 3 { n++; for (i = 1; i <= 3; i++) s[n, i] = $(i + 1) }
    END { scale[1] = 1 - 0.9 ^ 3; scale[2] = scale[3] = 1; parts = 8
      for (i = 1; i <= 3; i++) { m = q = 0
        for (p = 0; p < parts; p++) { a = k = 0
          for (j = int(p * n / parts) + 1; j <= int((p + 1) * n / parts); j++) { a += s[j, i]; k++ }
          a /= k * scale[i]; m += a / parts; q += a * a / parts }
        printf "%.4f %.4f ", m, sqrt((q - m * m) / (parts - 1)) } print "" }' "$1"
}
# closed MODEL: density at the walls of a box of six rough ones. one MODEL: v_x^2 and v_z^2 above one rough wall.
closed() { box "$1" "xlo xhi ylo yhi zlo zhi" > closed.in; engine 1 closed.in; states closed.in.screen | cut -d ' ' -f 1-2; }
one() { box "$1" zlo > one.in; engine 1 one.in; states one.in.screen | cut -d ' ' -f 3-6; }

if [ "${1:-}" = long ]; then
  shift
  [ $# -gt 0 ] || set -- {normal,rejection,truncated,weibull,effective,visible,profile,traced}" isotropic collisions multiple" \
    "visible isotropic collisions single" {weibull,visible}" plane collisions single" "visible plane collisions multiple"
  for model in "$@"; do
    echo "$(closed "$model") $(one "$model")" |
      awk -v what="$model" '{ printf "%-45s density %s +- %s, v_x^2 %s +- %s, v_z^2 %s +- %s\n", what, $1, $2, $3, $4, $5, $6 }'
  done
  exit
fi
default="visible isotropic collisions multiple"
found="$(closed "$default") $(one "$default")"
echo "default: $found"
awk '{ exit !($1 > 0.975 && $1 < 1.025 && $3 / $5 > 0.95 && $3 / $5 < 1.05) }' <<< "$found" || die "the default leaves equilibrium: $found"
found=$(closed "weibull plane collisions single")
echo "the paper's choice: $found"
awk '{ exit !($1 > 1.04) }' <<< "$found" || die "the paper's choice is in equilibrium: $found"
