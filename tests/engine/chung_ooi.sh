#!/usr/bin/env bash
# Test 4 of Chung & Ooi 2011 in the engine: spheres of aluminum oxide (5 mm, e 0.98, mu 0.092) hit glass at 3.9 m/s
# and 5 to 85 degrees from the normal. CoR_T as the reference has it (see tests/unit/test_chung_ooi.c).
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
cat > reference << END
10.16 0.687
14.99 0.624
20.06 0.616
25.05 0.634
30.12 0.684
35.03 0.737
40.02 0.781
50 0.845
59.98 0.893
69.96 0.932
80.02 0.966
85.01 0.983
END
{ head_of si
  echo "region box block -0.1 0.2 -0.1 0.1 -0.001 0.1 units box
create_box 2 box
neighbor 1e-3 bin
neigh_modify delay 0 exclude group all all"
  awk '{ a = $1 * 3.14159265359 / 180; print NR, 0.01 * (NR - 9), 0, 0.003, 3.9 * sin(a), 0, -3.9 * cos(a) }' reference | put 0.005
  materials
  echo "fix move all nve/sphere
fix wall all wall/rebound primitive type 2 zplane 0.0 rebound walton 0.98 0.092 0 compliance 0.8 deposit off ledger 100 file out.csv
timestep 2e-5
run 100"; } > run.in
engine 1 run.in
[ "$(count_rows out.csv)" = 12 ] || die "$(count_rows out.csv) impacts of 12 spheres"
rows out.csv | sort -t, -k1,1n | cut -d, -f18 | paste -d' ' reference - > both
awk '{ d = $3 - $2; if (d < 0) d = -d; if (!(d <= 0.005)) { print; bad = 1 } } END { exit bad || NR != 12 }' both || die "CoR_T is not the reference's: $(cat both)"
