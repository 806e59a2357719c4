#!/usr/bin/env bash
# Large meshes, whose triangles the ranks share: the same ledger, byte for byte, on 1, 2 and 4 ranks, turning, periodic,
# as a belt, and after a restart.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
# A closed box of 1200 triangles, -10 to 10 mm along each axis.
awk -v n=10 'function at(k) { return -0.01 + 0.02 * k / n }
  function put(axis, side, p, q) { return axis == 0 ? side " " p " " q : axis == 1 ? q " " side " " p : p " " q " " side }
  BEGIN { for (axis = 0; axis < 3; axis++) for (side = -0.01; side < 0.02; side += 0.02) for (i = 0; i < n; i++) for (j = 0; j < n; j++)
    print put(axis, side, at(i), at(j)), put(axis, side, at(i + 1), at(j)), put(axis, side, at(i + 1), at(j + 1)), put(axis, side, at(i), at(j + 1)) }' | stl > box.stl
# A plate of 2048, and 300 grains within the box or above the plate.
awk 'function at(k) { return -0.02 + 0.04 * k / 32 } BEGIN { for (i = 0; i < 32; i++) for (j = 0; j < 32; j++) print at(i), at(j), 0, at(i + 1), at(j), 0, at(i + 1), at(j + 1), 0, at(i), at(j + 1), 0 }' | stl > plate.stl
cloud() { # lowest and highest place
  awk -v state=271828 -v lo="$1" -v hi="$2" -v wide="${3:-0.009}" 'function uniform() { state = (16807 * state) % 2147483647; return state / 2147483647 }
    function any(a, b) { return a + (b - a) * uniform() }
    BEGIN { for (i = 1; i <= 300; i++) printf "%d %.12g %.12g %.12g %.12g %.12g %.12g\n", i, any(-wide, wide), any(-wide, wide), any(lo, hi), any(-9, 9), any(-9, 9), any(-9, 9) }'
}
scene() { # NAME GRAINS MESH STEP STEPS OPTIONS: NAME.in runs it at once, NAME.first.in to a restart, NAME.rest.in from it
  local after="neigh_modify exclude group all all
fix m5 all property/global yieldStress peratomtype 1e6
fix m6 all property/global surfaceEnergy peratomtypepair 1 ${gamma:-0.1}
fix mesh all mesh/surface file $3
fix wall all wall/rebound mesh n_meshes 1 meshes mesh surface rq 2e-6 lambda_c 4e-5 ${law:-rebound constant 1 1 deposit off} ledger 20 file rows.csv
${motion:-}
fix move all nve/sphere
timestep $4
thermo_style custom step atoms f_wall[1] f_wall[2]
thermo 10000"
  soft "-0.02 0.02 -0.02 0.02 -0.02 0.02" | sed 's/^neighbor .*/neighbor 0.001 bin/' > soft
  { cat soft; put 4e-4 <<< "$2"; echo "$after
run $5"; } > "$1.in"
  sed "s/^run .*/run $(($5 * 2 / 5))\nwrite_restart half.restart/" "$1.in" > "$1.first.in"
  { sed 's/^region .*/read_restart half.restart/; /^create_box/d' soft; echo "$after
run $5 upto"; } > "$1.rest.in"
  for ranks in 1 $many; do
    rm -f rows.csv
    engine $ranks "$1.in"
    cp rows.csv "$1.$ranks.csv"
    same "$1.1.csv" "$1.$ranks.csv" "$1 on 1 and $ranks ranks"
  done
  [ "$(count_rows "$1.1.csv")" -gt 100 ] || die "$1: $(count_rows "$1.1.csv") impacts"
  rm -f rows.csv
  engine 2 "$1.first.in"
  engine "$again" "$1.rest.in"
  same "$1.1.csv" rows.csv "$1 after a restart from 2 ranks on $again"
  many=$((6 - many)) again=$((5 - again)) # in turn 4 ranks and 2, and on from 2 with 4 and 1
}
many=4 again=1
inside=$(cloud -0.009 0.009) above=$(cloud 0.001 0.012 0.019)
motion='fix turn all move/mesh mesh mesh rotate origin 0. 0. 0. axis 0. 0.6 0.8 period 0.02' scene turn "$inside" "box.stl type 1" 1e-5 250
boundary='p p f' motion='fix shake all move/mesh mesh mesh wiggle amplitude 0. 0. 0.001 period 0.003
fix top all wall/rebound primitive type 1 zplane 0.013 rebound constant 1 1 deposit off' law='rebound bons deposit freeze' gamma=100 \
  scene periodic "$above" "plate.stl type 1" 2e-5 150
boundary="p p f" law='rebound bons deposit freeze' gamma=100 motion='fix top all wall/rebound primitive type 1 zplane 0.013 rebound constant 1 1 deposit off' \
  scene belt "$above" "plate.stl type 1 surface_vel 0.5 -1.5 0." 2e-5 150

# Where MPI shares no memory, each rank keeps a copy, and the log says so.
rm -f rows.csv
OMPI_MCA_osc=^sm engine 2 turn.in
same turn.1.csv rows.csv "without shared memory"
grep -q "mesh 'mesh': MPI shares no memory here, so each rank keeps a copy" turn.in.screen || die "no word on the copies"
