#!/usr/bin/env bash
# Walls over an area: surface --map.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/cli.sh"

# surface --map: a ground wall of known lay, in three forms that say the same.
awk 'BEGIN { srand(3); n = 90; for (k = 0; k < 400; k++) { a[k] = sqrt(-2 * log(1 - rand())) * cos(6.2831853 * rand()) * sqrt(2) / 20
      b[k] = sqrt(-2 * log(1 - rand())) * cos(6.2831853 * rand()) * sqrt(2) / 5; c[k] = 6.2831853 * rand() }
    print "# Width: 180 um\n# Height: 180 um\n# Value units: um" > "matrix"
    print "x_um,y_um,z_um" > "triples"
    printf "aISO-1.0\nNumPoints = 90\nNumProfiles = 90\nXscale = 2e-6\nYscale = 2e-6\nZscale = 1e-6\n*\n" > "sdf"
    for (j = 0; j < n; j++) for (i = 0; i < n; i++) { x = 2 * i; y = 2 * j; z = 0
      u = x * cos(0.5) + y * sin(0.5); v = y * cos(0.5) - x * sin(0.5)
      for (k = 0; k < 400; k++) z += 0.0707 * cos(a[k] * u + b[k] * v + c[k])
      printf "%.7g%s", z, i < n - 1 ? " " : "\n" > "matrix"; printf "%g,%g,%.7g\n", x, y, z > "triples"; printf "%.7g\n", z > "sdf" }
    print "*" > "sdf" }'
for file in matrix triples sdf; do
  "$asperity" surface surface map $file --dp 2um,20um > $file.out 2> err || die "surface --map $file: $(cat err)"
  cmp <(sed 1,2d $file.out) <(sed 1,2d matrix.out) || die "surface --map $file: other numbers"
done
awk -F, '/^[0-9]/ { if (!($3 > 4 && $3 < 6.5 && $4 > 14 && $4 < 28 && $5 > 23 && $5 < 34 && $8 > 3 * $9)) exit 1; if (n++ && !($8 < last)) exit 1; last = $8 }
  END { if (n != 2) exit 1 }' matrix.out || die "surface --map: $(cat matrix.out)"
draws
"$asperity" surface surface map sdf --dp 2um,20um --plot map.svg > plot.out 2> err || die "surface --map --plot: $(cat err)"
cmp <(sed 1,2d plot.out) <(sed 1,2d matrix.out) && grep -q 'rms contact slope' map.svg || die "surface --map --plot"
grep -q '^# ISO 25178-2, unfiltered: S_q .* S_al .* S_tr ' matrix.out || die "surface --map: parameters"
for option in "x-column 1" "column 2" "row 2" "lambda_s 9um"; do
  refuses 2 "${option% *} does not apply to 'surface map'" -- surface surface map sdf --dp 20um --$option
done
printf 'DSCOMPRESSED' > closed
got=0; "$asperity" surface surface map closed 2> err || got=$?
[ $got = 2 ] && grep -q Gwyddion err || die "surface --map: a closed format: $(cat err)"
