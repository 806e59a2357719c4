#!/usr/bin/env bash
# Loads on a wall: its momentum is the one that the particles lose, to rounding, on a mesh that turns,
# with particles that fall, rebound, roll and stick; a bed at rest presses with its weight; the same force and torque
# in both engines and on any number of ranks; the torque is the angular momentum that grains lose; what dissipates is the
# energy that grains lose that hit and slide; the sums of meshes and triangles are those of the whole wall.
# GRAINS=2500 STEPS=8000 loads.sh makes over 10^5 impacts.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
grains=${GRAINS:-100} steps=${STEPS:-1000}
numbers() { grep -E '^ +[0-9]+( +[-+.0-9e]+)+ *$' "$1"; }

# Grains in a box that turns.
stl > box.stl << END
-0.3 -0.3 -0.3  0.3 -0.3 -0.3  0.3 0.3 -0.3  -0.3 0.3 -0.3
-0.3 -0.3 0.3  0.3 -0.3 0.3  0.3 0.3 0.3  -0.3 0.3 0.3
-0.3 -0.3 -0.3  0.3 -0.3 -0.3  0.3 -0.3 0.3  -0.3 -0.3 0.3
-0.3 0.3 -0.3  0.3 0.3 -0.3  0.3 0.3 0.3  -0.3 0.3 0.3
-0.3 -0.3 -0.3  -0.3 0.3 -0.3  -0.3 0.3 0.3  -0.3 -0.3 0.3
0.3 -0.3 -0.3  0.3 0.3 -0.3  0.3 0.3 0.3  0.3 -0.3 0.3
END
cloud=$(awk -v n="$grains" -v state=4711 'function uniform() { state = (16807 * state) % 2147483647; return 2 * state / 2147483647 - 1 }
  BEGIN { for (i = 1; i <= n; i++) printf "%d %.9g %.9g %.9g %.9g %.9g %.9g\n", i, 0.25 * uniform(), 0.25 * uniform(), 0.25 * uniform(), 3 * uniform(), 3 * uniform(), 3 * uniform() }')
scene() { # law
  soft "-0.6 0.6 -0.6 0.6 -0.6 0.6" | sed 's/^neigh_modify .*/neigh_modify delay 0 exclude group all all/; s/^neighbor .*/neighbor 0.02 bin/'
  put <<< "$cloud"
  echo "fix m5 all property/global yieldStress peratomtype 1e5
fix m6 all property/global surfaceEnergy peratomtypepair 1 5
fix box all mesh/surface file box.stl type 1
fix turn all move/mesh mesh box rotate origin 0.01 0.0 0.0 axis 0.2 0.3 1. period 1.7
fix wall all wall/rebound mesh n_meshes 1 meshes box $1 erosion dnv density 7800 face tilted torque_about 0.1 0.2 -0.1 ledger 500 file rows.csv columns full
fix fall all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
timestep 2e-4
dump at all custom $steps at.txt id vx vy vz
dump_modify at sort id format \"%d %.17g %.17g %.17g\"
thermo_style custom step f_wall[7] f_wall[8] f_wall[9] f_wall[10] f_wall[11] f_wall[12] f_wall[13] f_wall[1] f_wall[1][1] f_wall[1][7] f_wall[2] f_wall[14] f_wall[1][8]
thermo_modify format float %.17g
thermo 1
run $steps"
}
mass=$(awk 'BEGIN { printf "%.17g", 2500 * 4 * atan2(0, -1) / 3 * 64e-9 }')
for law in "surface rq 2e-4 lambda_c 2e-3 rebound walton 0.9 0.3 0.2 deposit off" "surface rq 2e-4 lambda_c 2e-3 rebound bons"; do
  name=${law#*rebound }; name=${name%% *}
  scene "$law" > $name.in
  for engine in liggghts lammps; do
    use $engine
    for ranks in 1 2; do
      [ $ranks = 1 ] || [ $engine = liggghts ] || continue
      engine $ranks $name.in
      numbers $name.in.screen > $name.$engine.$ranks
      mv rows.csv $name.$engine.$ranks.csv
      awk -v m="$mass" -v n="$grains" -v steps="$steps" 'NF == 4 && $1 ~ /^[0-9]+$/ { seen[$1]++
            for (k = 2; k <= 4; k++) p[k] += (seen[$1] == 1 ? m : -m) * $k }
          END { printf "%.17g %.17g %.17g\n", p[2], p[3], p[4] - n * m * 9.81 * steps * 2e-4 }' at.txt > lost
      awk 'NR > 1 { for (k = 2; k <= 4; k++) { p[k] += $k * 2e-4; all += $k < 0 ? -$k * 2e-4 : $k * 2e-4 } } END { printf "%.17g %.17g %.17g %.17g %d %d\n", p[2], p[3], p[4], all, $9, $12 }' $name.$engine.$ranks |
        paste -d' ' lost - > balance
      awk -v name="$name" -v engine=$engine -v ranks=$ranks '{ for (k = 1; k <= 3; k++) { d = $k - $(k + 3); if (d < 0) d = -d; if (d > worst) worst = d }
        printf "%s, %s, %d ranks: %d impacts, %d deposits; momentum to %.2g of what the wall has taken\n", name, engine, ranks, $8, $9, worst / $7; exit !(worst < 1e-13 * $7 && $8 > 0) }' balance ||
        die "$name: the grains lose $(cut -d' ' -f1-3 balance), the wall gets $(cut -d' ' -f4- balance)"
    done
  done
done

# Both engines, and ranks, have the same numbers; those of the mesh are those of the wall.
for name in walton bons; do
  for other in liggghts.2 lammps.1; do
    paste -d' ' $name.liggghts.1 $name.$other | awk 'NR <= 500 { for (k = 2; k <= 11; k++) { d = $k - $(k + 14); s = $k * $k; if (k < 8) s += $4 * $4 + $5 * $5 + 1; if (d * d > 1e-16 * s) { print k, $0; exit 1 } } }' ||
      die "$name: liggghts.1 and $other differ"
  done
  awk '{ if ($9 != $10 || $13 != $14 || ($8 - $11) ^ 2 > 1e-24 * $8 ^ 2) exit 1 } END { exit !($8 > 0) }' $name.liggghts.1 || die "$name: the array and the vector differ"
done

# The dissipated energy, the impulses and the torque are those of the rows. Where grains only hit, they are all.
energies() { # ledger
  rows "$1" | awk -F, '{ n++; worn += $39; e += 0.5 * $20 * ($24 ^ 2 + $25 ^ 2 + $26 ^ 2 - $27 ^ 2 - $28 ^ 2 - $29 ^ 2) + $20 * $9 ^ 2 / 20 * ($30 ^ 2 + $31 ^ 2 + $32 ^ 2 - $33 ^ 2 - $34 ^ 2 - $35 ^ 2)
      for (k = 0; k < 3; k++) { d = $(36 + k) - $20 * ($(24 + k) - $(27 + k)); if (d * d > 1e-16) exit 1 }
      j = -($36 * $21 + $37 * $22 + $38 * $23); normal += j; along += sqrt(($36 + j * $21) ^ 2 + ($37 + j * $22) ^ 2 + ($38 + j * $23) ^ 2) }
    END { printf "%.12g %.12g %d %.12g %.12g\n", e, normal, n, worn, along }'
}
scene "surface rq 2e-4 lambda_c 2e-3 rebound walton 0.9 0.3 0.2 deposit off" |
  sed '/^fix fall/d; s/ f_wall.2. / f_wall[1][5] /; s/^thermo_style .*/& f_wall[1][6]/; s/rows.csv/free.csv/' > free.in
engine 2 free.in
numbers free.in.screen | tail -n 1 | paste -d' ' - <(energies free.csv) | awk '{ printf "dissipated: %s, by the rows %s; normal impulse %s, %s; tangential %s, %s; eroded %s, %s\n", $8, $16, $12, $17, $15, $20, $13, $19
  exit !($18 == $9 && $8 > 0 && ($8 / $16 - 1) ^ 2 < 1e-16 && ($12 / $17 - 1) ^ 2 < 1e-16 && ($15 / $20 - 1) ^ 2 < 1e-16 && $13 > 0 && ($13 / $19 - 1) ^ 2 < 1e-16) }' || die "energies of the rows"
# A row has what the grain's orbital momentum loses, and its spin.
numbers free.in.screen | awk 'NR > 1 { for (k = 5; k <= 7; k++) t[k] += $k * 2e-4 } END { printf "%.12g %.12g %.12g\n", t[5], t[6], t[7] }' |
  paste -d' ' - <(rows free.csv | awk -F, '{ x = $6 - 0.1; y = $7 - 0.2; z = $8 + 0.1; inertia = $20 * $9 ^ 2 / 10
      t += y * $38 - z * $37 + inertia * ($30 - $33); u += z * $36 - x * $38 + inertia * ($31 - $34); v += x * $37 - y * $36 + inertia * ($32 - $35); all += sqrt($36 ^ 2 + $37 ^ 2 + $38 ^ 2) }
    END { printf "%.12g %.12g %.12g %.12g\n", t, u, v, all }') |
  awk '{ print "torque times time:", $1, $2, $3 ", by the rows", $4, $5, $6; for (k = 1; k <= 3; k++) if (!(($k - $(k + 3)) ^ 2 < 1e-18 * $7 ^ 2)) exit 1; exit !($1 && $2 && $3) }' ||
  die "the torque of the rows"
same walton.liggghts.1.csv walton.liggghts.2.csv "full rows on two ranks"
"$bin/asperity" compare free.csv -o free.txt > compare.out 2>&1 || die "compare does not read a full ledger: $(cat compare.out)"

# A grain that slides until it rolls, and one that drops and does: what they lose is what dissipates.
{ soft "-0.1 0.9 -0.1 0.1 -0.001 0.05" 0.3 0.5 | sed 's/^neigh_modify .*/neigh_modify delay 0 exclude group all all/'
  printf '1 0 0 0.004 1 0.2 0\n2 0 0.05 0.006 0.8 -0.3 -0.5\n' | put
  echo "fix wall all wall/rebound primitive type 1 zplane 0.0 rebound walton 0.5 0.3 0 deposit off
fix move all nve/sphere
fix fall all gravity 9.81 vector 0 0 -1
compute spin all erotate/sphere
compute z all reduce sum z
thermo_style custom step ke c_spin c_z f_wall[13]
thermo_modify format float %.17g norm no
thermo 50
timestep 2e-4
run 800"; } > slide.in
engine 1 slide.in
numbers slide.in.screen | awk -v m="$mass" '{ e = $2 + $3 + m * 9.81 * $4; if (NR == 1) first = e; d = (first - e - $5) / first; if (d < 0) d = -d; if (d > worst) worst = d }
  END { printf "slid: lost %.6g, dissipated %.6g; to %.2g of the energy\n", first - e, $5, worst; exit !(NR == 17 && $5 > 0.3 * first && worst < 5e-4) }' || die "what grains lose that slide"

# The force of each grain is its share of the wall's, and acts where the grain touches: two that roll, one that flies.
for engine in liggghts lammps; do
  use $engine
  { sed '/^compute z/d; /^thermo/d; /^run/d' slide.in
    printf 'region above block -1 1 -1 1 0.02 1 units box\ncreate_atoms 1 single 0 0.08 0.04 units box\nset region above diameter 0.008 density 2500\n'
    echo "compute force all reduce sum f_rebound_wall[3] f_rebound_wall[4] f_rebound_wall[5]
thermo_style custom step c_force[1] f_wall[7] c_force[2] f_wall[8] c_force[3] f_wall[9]
thermo_modify format float %.17g
thermo 1
dump at all custom 800 at.txt id x y z f_rebound_wall[5] f_rebound_wall[6] f_rebound_wall[7] f_rebound_wall[8]
dump_modify at sort id format \"%d %.12g %.12g %.12g %.12g %.12g %.12g %.12g\"
run 800"; } | if [ $engine = lammps ]; then sed 's/f_rebound_wall/f_wall/g; s/format "/format line "/'; else cat; fi > shares.in
  engine 2 shares.in
  numbers shares.in.screen | awk 'NF == 7 { rows++; for (k = 2; k < 7; k += 2) { d = $k - $(k + 1); if (d * d > 1e-24 * $(k + 1) ^ 2) exit 1; any[k] += $k != 0 } } END { exit !(rows > 790 && any[2] > 100 && any[6] > 300) }' ||
    die "$engine: the forces of grains are not the wall's"
  awk -v m="$mass" '/^ITEM/ { on = /: ATOMS/; picture += on; next } on && picture == 2 { n++
      if ($1 == 3 ? $5 || $6 || $8 : ($5 / m / -9.81 - 1) ^ 2 > 1e-12 || ($6 - $2) ^ 2 + ($7 - $3) ^ 2 > 1e-10 || $8 ^ 2 > 1e-16) { print; exit 1 } } END { exit n != 3 }' at.txt ||
    die "$engine: the force or the place of a grain"
done

# A bed presses with its weight on all of its walls together.
soft "-0.031 0.031 -0.031 0.031 -0.001 0.2" 0.3 0.5 > bed.in
{ stack 6 6 2 0.0095 0.3 | put
  while read -r name plane; do
    echo "fix $name all wall/rebound primitive type 1 $plane rebound constant 0.5 0.9 deposit off"
  done <<< "floor zplane 0.0
left xplane -0.03
right xplane 0.03
front yplane -0.03
back yplane 0.03"
  echo "timestep 5e-5
fix fall all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
thermo_style custom step f_floor[9] f_left[9] f_right[9] f_front[9] f_back[9] f_left[7] f_right[7]
thermo_modify format float %.17g
thermo 100000
run 8000
thermo 1
run 2000"; } >> bed.in
for engine in liggghts lammps; do
  use $engine
  engine 1 bed.in
  numbers bed.in.screen | awk -v w="$(awk -v m="$mass" 'BEGIN { print 72 * m * 9.81 }')" -v engine=$engine '$1 > 8000 { n++; floor += $2; f += $2 + $3 + $4 + $5 + $6; side += $7; other += $8 }
    END { printf "%s: the bed of %.4f N presses with %.6f of it, the floor carries %.3f, sides %.3g %.3g\n", engine, w, f / n / -w, floor / n / -w, side / n / w, other / n / w
      d = f / n / -w - 1; exit !(n > 1999 && d * d < 1e-6 && side < 0 && other > 0) }' || die "$engine: the weight of the bed"
done
