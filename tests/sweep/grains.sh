#!/usr/bin/env bash
# Grains that touch each other, for long times, in LAMMPS: a bed at rest, a slow drum, a shaken box.
#   tests/sweep/grains.sh bed|drum|shake STEPS STEP SURFACE...    as: drum 1000000 3e-5 rq 100e-6 lambda_c 1e-3
# About 200 grains of 2 mm; LAW: the law of the wall, instead of walton 0.5 0.5 0. Prints the largest speed in the last
# half of the run, and its means of the energy per mass, of the height of the center of mass over the lowest point, and in
# the drum of the angle of the center of mass from below the axis, with standard errors from eight parts.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
bin=${ASPERITY_BIN:-$(dirname "${BASH_SOURCE[0]}")/../../build/bin}
scene=$1 steps=$2 step=$3; shift 3
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
export OMPI_MCA_orte_tmpdir_base=$work
box='block -0.008 0.008 -0.008 0.008 0 0.2 units box'
case $scene in
  bed) region=$box ;;
  drum) region='cylinder y 0 0 0.016 INF INF units box rotate v_turn 0 0 0 0 1 0' ;;
  shake) region="$box move NULL NULL v_up" ;;
esac
cat > "$work/in" << END
units si
atom_style sphere
boundary f $([ $scene = drum ] && echo p || echo f) f
newton off
comm_modify vel yes
region all block -0.02 0.02 -0.008 0.008 -0.02 0.25 units box
create_box 1 all
neighbor 1e-3 bin
pair_style granular
pair_coeff * * hertz/material 5e6 0.5 0.3 tangential mindlin NULL 1.0 0.5 damping tsuji
fix weight all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
variable turn equal 2*PI*step*dt/2
variable up equal 0.001*sin(2*PI*step*dt/0.05)
region wall $region
fix wall all wall/rebound region wall surface $* rebound ${LAW:-walton 0.5 0.5 0} deposit off
lattice sc 2.2e-3
region fill block -0.0075 0.0075 -0.007 0.007 $([ $scene = drum ] && echo -0.011 -0.001 || echo 0.0015 0.012) units box
create_atoms 1 region fill
displace_atoms all random 5e-5 5e-5 5e-5 4711
set group all diameter 2e-3 density 2500
timestep $step
compute speed all property/atom vx vy vz
variable v atom sqrt(vx^2+vy^2+vz^2)
variable e atom 0.5*(vx^2+vy^2+vz^2)
compute most all reduce max v_v
compute mean all reduce ave v_e
variable x equal xcm(all,x)
variable z equal xcm(all,z)
fix tell all ave/time 10 1 10 c_most c_mean v_x v_z file $work/out
thermo 100000
run $steps
END
"$bin/lammps-asperity" -in "$work/in" -log none > "$work/screen" || { tail -n 5 "$work/screen" >&2; exit 1; }
awk -v steps="$steps" -v scene="$scene" 'function tell(what, k,   p, m, q) {
    for (p = 0; p < 8; p++) { m += s[k, p] / n[p] / 8; q += (s[k, p] / n[p]) ^ 2 / 8 }
    printf "; %s %.4g ± %.2g", what, m, sqrt((q - m * m > 0 ? q - m * m : 0) / 7) }
  !/^#/ && 2 * $1 > steps { p = int(16 * ($1 - 1) / steps) - 8; n[p]++; if ($2 > most) most = $2
    s[1, p] += $3; s[2, p] += $5 + (scene == "drum" ? 0.016 : 0); s[3, p] += atan2(-$4, -$5) * 180 / atan2(0, -1) }
  END { printf "%s: largest speed %.3g m/s", scene, most; tell("energy per mass, (m/s)^2", 1); tell("height of the center, m", 2)
    if (scene == "drum") tell("angle of the center, degrees", 3); print "" }' "$work/out"
