#!/usr/bin/env bash
# Walls at rest give no energy: elastic grains that touch each other keep theirs between walls of this fix as
# between those of wall/gran, at any step that resolves their contacts; a bed settles; a grain that bounces
# under gravity rises as high after 1000 bounces as at first. In LAMMPS one run of each kind: the walls are the same code.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"

# between KIND: planes, as "STYLE POSITION" words, of KIND gran or rebound.
between() {
  local kind=$1 k=0; shift
  while [ $# -gt 0 ]; do
    k=$((k + 1))
    case $kind in
      gran) echo "fix w$k all wall/gran model hertz tangential history primitive type 1 $1 $2" ;;
      rebound) echo "fix w$k all wall/rebound primitive type 1 $1 $2 rebound constant ${law:-1 1} deposit off" ;;
    esac
    shift 2
  done
}
# numbers SCREEN: the rows of its thermo output.
numbers() { grep -E '^ +[0-9]+( +[-+.0-9e]+)+ *$' "$1"; }
# kept SCREEN: of each column, its maximum over the last tenth of the steps over its first value.
kept() {
  numbers "$1" | awk '
    NR == 1 { for (i = 2; i <= NF; i++) first[i] = $i }
    { step[NR] = $1; for (i = 2; i <= NF; i++) value[NR, i] = $i; last = $1; columns = NF }
    END { for (i = 2; i <= columns; i++) { most = 0
        for (n = 1; n <= NR; n++) if (step[n] > 0.9 * last && value[n, i] > most) most = value[n, i]
        printf "%s%.6f", (i > 2 ? " " : ""), most / first[i] } print "" }'
}

# Four pairs of elastic grains without friction, each pair between the same two planes, 10^5 steps.
pairs() { # kind, share of the Rayleigh time
  soft "-0.001 0.018 -0.02 0.14 -0.02 0.02" 0 1 | sed 's/tangential history/tangential no_history/'
  put << END
1 0.0045 0 0 0.5 0 0
2 0.0126 0 0 -0.3 0 0
3 0.0041 0.03 0 0.7 0 0
4 0.0127 0.03 0 0 0 0
5 0.0045 0.06 0 0.1 0 0
6 0.0128 0.06 0 -0.45 0 0
7 0.0042 0.09 0 -0.2 0 0
8 0.0129 0.09 0 0.9 0 0
END
  for k in 1 2 3 4; do echo "group p$k id $((2 * k - 1)) $((2 * k))
compute k$k p$k ke"; done
  between "$1" xplane 0.0 xplane 0.017 | sed 's/tangential history/tangential no_history/'
  echo "timestep $(mul "$2" $rayleigh)
fix move all nve/sphere
thermo_style custom step c_k1 c_k2 c_k3 c_k4
thermo 37
run 100000"
}
for share in $([ $simulator = lammps ] || echo 0.01 0.04) 0.08 $([ $simulator = lammps ] || echo 0.2); do
  for kind in gran rebound; do
    pairs $kind $share > pairs.$kind.in
    engine 1 pairs.$kind.in
    kept pairs.$kind.in.screen > $kind.kept
  done
  echo "pairs of grains at $share of the Rayleigh time: wall/gran $(cat gran.kept), wall/rebound $(cat rebound.kept)"
  paste -d' ' gran.kept rebound.kept | awk -v share=$share '
    { for (i = 1; i <= 4; i++) if ($i > worst) worst = $i
      tolerance = share < 0.05 ? 0.03 : 0.5
      for (i = 5; i <= 8; i++) if (share < 0.1 ? !($i > 1 - tolerance && $i < 1 + tolerance) : !($i < 2 * worst)) exit 1 }' ||
    die "pairs of grains at $share of the Rayleigh time do not keep their energy"
done

# An elastic gas in a box, of 125 grains.
box="zplane 0.0 zplane 0.06 xplane -0.03 xplane 0.03 yplane -0.03 yplane 0.03"
gas() { # share of the Rayleigh time, steps, tolerance against wall/gran
  for kind in gran rebound; do
    { soft "-0.031 0.031 -0.031 0.031 -0.001 0.061" 0 1
      stack 5 5 5 0.0115 0.5 | put
      between $kind $box
      echo "timestep $(mul "$1" $rayleigh)
fix move all nve/sphere
thermo_style custom step ke
thermo_modify norm no
thermo 37
run $2"; } | sed 's/tangential history/tangential no_history/' > gas.$kind.in
    engine 1 gas.$kind.in
    kept gas.$kind.in.screen > $kind.kept
  done
  echo "a gas at $1 of the Rayleigh time: wall/gran $(cat gran.kept), wall/rebound $(cat rebound.kept)"
  paste -d' ' gran.kept rebound.kept | awk -v tolerance="$3" '{ d = $2 / $1 - 1; exit !(d < tolerance && d > -tolerance) }' ||
    die "a gas does not keep its energy"
}
[ $simulator = lammps ] || gas 0.04 20000 0.03
gas 0.08 20000 0.05
[ $simulator = lammps ] || gas 0.2 20000 0.5

# A bed settles as it does on wall/gran's walls; in LAMMPS rest.sh has one.
for kind in $([ $simulator = lammps ] || echo gran rebound); do
  { soft "-0.031 0.031 -0.031 0.031 -0.001 0.2" 0.3 0.5
    stack 6 6 5 0.0095 0.3 | put
    law="0.9 1" between $kind zplane 0.0 xplane -0.03 xplane 0.03 yplane -0.03 yplane 0.03
    echo "timestep 5e-5
fix fall all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
thermo_style custom step ke
thermo_modify norm no
thermo 100
run 40000"; } > bed.$kind.in
  engine 1 bed.$kind.in
  numbers bed.$kind.in.screen | awk '$1 > 36000 && $2 > most { most = $2 } END { print most }' > $kind.kept
done
# A grain that rolls on slowly, which nothing but its neighbors stops, makes the last digits of both a matter of chance.
if [ $simulator = liggghts ]; then
  echo "kinetic energy of a bed: wall/gran $(cat gran.kept) J, wall/rebound $(cat rebound.kept) J"
  awk '{ exit !($1 < 1e-9) }' rebound.kept || die "a bed does not settle"
fi

# Single grains that bounce 1000 times on a plane, on a mesh, and between two walls that gravity is aslant to. The
# path between bounces is exact, so that the energy is the same at every step.
plate 1 1 0.02 > plate.stl
bounces() { # gravity, walls
  { soft "-0.03 0.03 -0.03 0.03 -0.03 0.03" | sed 's/^neighbor .*/neighbor 0.02 bin/'
    echo "1 0.01 0.01 0.0123 0 0 0
2 0.003 0.008 0.009 0 0 -0.2" | put 0.002
    echo "neigh_modify exclude group all all
fix fall all gravity 9.81 vector $1
$2
fix move all nve/sphere
timestep 1e-3
variable n equal sqrt(($(set -- $1; echo "$1*$1+$2*$2+$3*$3")))
variable e atom 0.5*(vx*vx+vy*vy+vz*vz)-9.81/v_n*($(set -- $1; echo "$1*x+$2*y+$3*z"))
dump e all custom 100 energy.txt id v_e
dump_modify e sort id format \"%d %.15g\"
thermo_style custom step f_low
thermo 90000
run 90000"; } > bounces.in
  engine 1 bounces.in
  numbers bounces.in.screen | tail -n 1 | awk '$2 < 1800 { print "only " $2 " bounces"; exit 1 }' || die "too few bounces"
  awk 'NF == 2 && $1 ~ /^[12]$/ && $2 ~ /^[-0-9.e+]+$/ {
      if (!($1 in first)) first[$1] = $2
      d = $2 - first[$1]; if (d < 0) d = -d; if (d > worst) worst = d; n++ }
    END { print "energy changes by at most " worst " J/kg"; exit !(n > 1000 && worst < 1e-9) }' energy.txt || die "energy of bouncing grains, $2"
}
elastic='rebound constant 1 1 deposit off'
[ $simulator = lammps ] || bounces "0 0 -1" "fix low all wall/rebound primitive type 1 zplane 0.0 $elastic"
bounces "0 0 -1" "fix plate all mesh/surface file plate.stl type 1
fix low all wall/rebound mesh n_meshes 1 meshes plate $elastic"
[ $simulator = lammps ] || bounces "0.3 0.1 -1" "fix low all wall/rebound primitive type 1 zplane 0.0 $elastic
fix side all wall/rebound primitive type 1 xplane 0.015 $elastic
fix back all wall/rebound primitive type 1 yplane 0.02 $elastic"
