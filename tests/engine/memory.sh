#!/usr/bin/env bash
# The core's memory runs out while a wall is made: whichever allocation fails, the run ends with one clear error. A
# sample of them, from the first to the last, also on one rank of two; that each is seen in the core is unit/test_memory.c.
# Usage: memory.sh LIBRARY (fail_memory.c)
# SPDX-License-Identifier: GPL-3.0-or-later
library=$1
source "$(dirname "$0")/engine.sh"
{ echo x_um,z_um; awk 'BEGIN { srand(3); for (i = 0; i < 3000; i++) { z = 0.95 * z + rand() - 0.5; print i + 0.3 * sin(i) "," z } }'; } > profile.csv
printf 'alpha1_deg,v1_m_s,cor_n,cor_t\n10,50,0.9,0.8\n80,50,0.3,0.7\n10,150,0.7,0.6\n80,150,0.1,0.5\n' > table.csv
printf 'name,youngs_modulus_pa,poissons_ratio,density_kg_m3,yield_stress_pa\nchalk,5e10,0.2,2000,1e8\n' > own.csv
scene() { # what the walls are
  head_of si
  echo "region box block -0.002 0.002 -0.002 0.002 -0.001 0.002 units box
create_box 2 box
neighbor 1e-4 bin
create_atoms 1 single 0 0 1e-3 units box
set group all diameter 1e-5 density 2650
velocity all set 10 0 -10 units box
fix move all nve/sphere
timestep 1e-7"
  materials
  echo "fix wall all wall/rebound primitive type 2 zplane 0.0 $1
run 1"
}
scene 'surface profile profile.csv dp_bins 2 spread traced rebound table table.csv' > measured.in
scene 'surface rq 1e-5 lambda_c 1e-4 dp_bins 2 spread traced materials chalk hastelloy-x file own.csv' > generated.in

run_with() { # AT SCRIPT: the status of a run whose allocation of that number fails
  status=0
  FAIL_MEMORY_AT=$1 FAIL_MEMORY_COUNT=$PWD/count LD_PRELOAD=$library timeout 100 \
    "$bin/liggghts-asperity" -in "$2" -log none > screen 2>&1 || status=$?
}
for script in measured.in generated.in; do
  run_with 0 $script
  [ $status = 0 ] || { tail screen; die "$script does not run with all its memory"; }
  count=$(cat count)
  [ "$count" -ge 5 ] || die "$script: only $count allocations"
  for at in $(seq 1 6 "$count") "$count"; do
    run_with "$at" $script
    [ $status = 1 ] && [ "$(grep -ac '^ERROR.*out of memory\|^ERROR.*Cannot allocate memory' screen)" = 1 ] ||
      { tail screen; die "$script: allocation $at of $count fails: status $status"; }
  done
  echo "$script: of $count allocations a sixth failed and was told"
done

# On one of two ranks: the other one does not wait for ever.
cat > one.sh << END
[ "\$OMPI_COMM_WORLD_RANK" = 0 ] || export FAIL_MEMORY_AT=\$1 LD_PRELOAD=$library
exec "$bin/liggghts-asperity" -in measured.in -log none
END
for at in 1 $((count / 2)); do
  status=0
  timeout 60 mpirun -np 2 bash one.sh "$at" > screen 2>&1 || status=$?
  [ $status != 0 ] && [ $status != 124 ] && grep -aq 'ERROR.*out of memory' screen ||
    { tail screen; die "memory of the second rank, allocation $at: status $status"; }
done
