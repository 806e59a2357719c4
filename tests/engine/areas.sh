#!/usr/bin/env bash
# A measured map as the wall: the log states it, impacts are the same on 1 and 2 ranks, a ground wall deflects what
# flies over it as its lay, in the direction that the script says, would; bad scripts are refused.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
# A ground wall of 0.6 mm squared: grooves 30 um apart, 150 um long, at 30 degrees to the rows.
awk 'BEGIN { srand(3); n = 200; for (k = 0; k < 120; k++) { a[k] = sqrt(-2 * log(1 - rand())) * cos(6.2831853 * rand()) * 1.41421 / 30
      b[k] = sqrt(-2 * log(1 - rand())) * cos(6.2831853 * rand()) * 1.41421 / 150; c[k] = 6.2831853 * rand() }
    print "# Width: 600 um\n# Height: 600 um\n# Value units: um"
    for (j = 0; j < n; j++) for (i = 0; i < n; i++) { x = 3 * i; y = 3 * j; z = 0
      u = y * cos(0.5236) - x * sin(0.5236); v = x * cos(0.5236) + y * sin(0.5236)
      for (k = 0; k < 120; k++) z += cos(a[k] * u + b[k] * v + c[k])
      printf "%.7g%s", 0.387 * z, i < n - 1 ? " " : "\n" } }' > wall.txt
grains 2000 > grains.data
deck() { # surface
  head_of si
  echo "read_data grains.data
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all"
  materials
  echo "fix move all nve/sphere
timestep 1e-8
fix wall all wall/rebound primitive type 2 zplane 0.0 surface $1 rebound constant 1 1 deposit off ledger 400 file \${out}
dump end all custom 400 \${out}.dump id vx vy vz
run 400"
}
deck 'map wall.txt dp_bins 1 lay 1 1 0' > left.in
deck 'map wall.txt dp_bins 1 lay 1 -1 0' > right.in
engine 1 left.in -var out left.csv
engine 2 left.in -var out two.csv
same left.csv two.csv "1 and 2 ranks"
engine 1 right.in -var out right.csv
[ "$(count_rows left.csv)" -ge 2000 ] || die "too few impacts"
grep -q 'map wall.txt (200 x 200 points read, 0 bad' left.in.screen || die "the log does not state the map"
grep -q 'spread traced' left.in.screen || die "a map is not its own law where nothing else is said"
# The grains fly in all directions; which way those that leave lean, against the lay's direction, is that of a Gaussian
# wall with the same lengths.
lean() { awk '/^ITEM: TIMESTEP/ { getline t } /^ITEM: ATOMS/ { on = t == 400; next } /^ITEM/ { on = 0 } on { s += $2 * $3 / ($2 * $2 + $3 * $3); n++ } END { print s / n }' "$1.dump"; }
for way in '1 1 0' '1 -1 0'; do
  deck "rq 2.61e-6 lambda_c 25.2e-6 131e-6 lay $way spread visible isotropic collisions multiple" > gauss.in
  engine 1 gauss.in -var out "gauss${way// /}.csv"
done
awk -v a="$(lean left.csv)" -v b="$(lean right.csv)" -v c="$(lean gauss110.csv)" -v d="$(lean gauss1-10.csv)" \
  'BEGIN { ratio = (b - a) / (d - c); exit !(d - c > 0.02 && ratio > 0.6 && ratio < 1.7) }' ||
  die "lean: $(lean left.csv) $(lean right.csv), Gaussian: $(lean gauss110.csv) $(lean gauss1-10.csv)"

refused() { # surface, words
  deck "$1" > bad.in
  if timeout 60 mpirun -np 1 "$bin/liggghts-asperity" -in bad.in -log none -var out bad.csv < /dev/null > bad.screen 2>&1; then die "accepted: $1"; fi
  grep -qF -- "$2" bad.screen || { tail -n 4 bad.screen; die "'$2' is not in the message of: $1"; }
}
refused 'map wall.txt dp_bins 1' "say which way it lies: 'lay X Y Z'"
refused 'map none.txt' 'none.txt'
printf 'DIGITAL SURF' > closed.sur
refused 'map closed.sur' 'Gwyddion'
