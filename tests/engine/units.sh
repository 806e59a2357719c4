#!/usr/bin/env bash
# One case in units si, cgs and micro, and LAMMPS's nano: the same impacts, in each script's own units.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
deck() { # units, length, time, pressure, energy per area
  head_of "$1"
  echo "read_data $1.data
neighbor $(mul 3e-5 "$2") bin
neigh_modify delay 0 exclude group all all"
  materials "$4" "$5"
  echo "fix move all nve/sphere
timestep $(mul 1e-8 "$3")
fix wall all wall/rebound primitive type 2 zplane 0.0 surface rq $(mul 10e-6 "$2") lambda_c $(mul 90e-6 "$2") spread truncated ledger 400 file $1.csv
run 400"
}
# factors from SI: length, velocity, density, time, pressure, energy per area
grains 400 > si.data
grains 400 1e2 1e2 1e-3 > cgs.data
grains 400 1e6 1 1e-3 > micro.data
deck si 1 1 1 1 > si.in
deck cgs 1e2 1 10 1e3 > cgs.in
deck micro 1e6 1e6 1e-3 1e3 > micro.in
systems='cgs micro'
if [ $simulator = lammps ]; then
  grains 400 1e9 1 1e-6 > nano.data
  deck nano 1e9 1e9 1e-6 1e3 > nano.in
  systems='cgs micro nano'
fi
for u in si $systems; do engine 1 $u.in; done
[ "$(count_rows si.csv)" -ge 400 ] || die "si: too few impacts"
rescale() { # file, length, velocity, time: back to SI
  awk -F, -v OFS=, -v OFMT=%.12g -v CONVFMT=%.12g -v l="$2" -v v="$3" -v t="$4" '/^#/ || /^tag/ { print; next }
    { $3 /= t; for (i = 6; i <= 9; i++) $i /= l; $10 /= v; $15 /= v; print }' "$1"
}
rescale cgs.csv 1e2 1e2 1 > cgs.si.csv
rescale micro.csv 1e6 1 1e6 > micro.si.csv
[ $simulator = liggghts ] || rescale nano.csv 1e9 1 1e9 > nano.si.csv
for u in $systems; do near si.csv $u.si.csv "1 2 3 9 10 11 12 14 15 16 17 18 19" 1e-6; done

# Without materials nothing has a unit: lj is what si is.
if [ $simulator = lammps ]; then
  for u in si lj; do
    { head_of $u; echo "read_data si.data
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all
fix move all nve/sphere
timestep 1e-8
fix wall all wall/rebound primitive type 2 zplane 0.0 surface rq 10e-6 lambda_c 90e-6 rebound walton 0.9 0.3 0.1 ledger 400 file plain.$u.csv
run 400"; } > plain.$u.in
    engine 1 plain.$u.in
  done
  same <(rows plain.si.csv) <(rows plain.lj.csv) "units si and lj"
fi
