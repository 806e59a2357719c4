#!/usr/bin/env bash
# The description that calibrate ends with, pasted as it is into a script of LIGGGHTS and one of LAMMPS and behind cor:
# the ledgers of both are equal to the byte, and they and cor have the scatter that was fitted.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
shopt -s extglob
truth='surface sigma 7 rebound bons friction 0.22 yield_stress 320MPa surface_energy 0.5 materials quartz hastelloy-x'
at='--angles 20:80:20 --speed 80 --dp 10um'
"$bin/asperity" cor $truth $at --samples 250 -o data
"$bin/asperity" calibrate data ${truth//@(7|0.22|320MPa)/fit} --speed 80 --samples 1000 > fit 2> err
description=$(sed -n 's/^# description, in SI units: //p' fit)
[[ $description == *"surface sigma "[67].*" rebound bons "*" friction 0.2"*" surface_energy 0.5 "* ]] || die "fit: $(cat fit err)"

# 1000 grains at the data's angles and speed.
awk -v n=1000 'BEGIN { pi = atan2(0, -1)
  printf "grains\n\n%d atoms\n2 atom types\n\n-2e-3 6e-3 xlo xhi\n-2e-3 6e-3 ylo yhi\n-5e-4 1.5e-3 zlo zhi\n\nAtoms\n\n", n
  for (i = 1; i <= n; i++) { a = 20 * (1 + i % 4) * pi / 180; vx[i] = 80 * cos(a); vz[i] = -80 * sin(a); t = 1e-6
    printf "%d 1 1e-5 2650 %.15g %.15g %.15g\n", i, 1e-4 * (i % 32) - vx[i] * t, 1e-4 * int(i / 32), 5e-6 - vz[i] * t }
  printf "\nVelocities\n\n"
  for (i = 1; i <= n; i++) printf "%d %.15g 0 %.15g 0 0 0\n", i, vx[i], vz[i] }' > grains.data
{ head_of si | sed 's/boundary.*/boundary m m m/'
  echo "read_data ../grains.data
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all"
  materials
  echo "fix move all nve/sphere
timestep 1e-8
fix low all wall/rebound primitive type 2 zplane 0.0 $description ledger 300 file low.csv
run 300"
} > fitted.in
for each in liggghts lammps; do
  mkdir $each
  (use $each; cd $each; cp ../fitted.in .; engine 1 fitted.in)
  [ "$(count_rows $each/low.csv)" = 1000 ] || die "$each: $(count_rows $each/low.csv) impacts"
done
same liggghts/low.csv lammps/low.csv "one description in both engines"

"$bin/asperity" cor $description $at --samples 250 -o cor.csv
for impacts in lammps/low.csv cor.csv; do
  "$bin/asperity" compare $impacts data | tail -n 1 | awk -F, '{ exit !($1 == "score" && $17 < 1 + 3 * $18) }' || die "$impacts is not the scatter that was fitted: $(cat fit)"
done

# Another friction would be seen.
"$bin/asperity" cor ${description/friction 0.2/friction 0.3} $at --samples 250 -o other.csv
"$bin/asperity" compare other.csv data | tail -n 1 | awk -F, '{ exit !($17 > 1 + 3 * $18) }' || die "another friction passes"
