#!/usr/bin/env bash
# Grains that roll down a rough slope, in LAMMPS, against spheres over generated walls, computed by geometry alone
# (tests/sweep/rolling.csv; units: gravity and lambda_c): mean speed in the last half of the time, of those that have not
# stopped, over that of the table.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "${BASH_SOURCE[0]}")/engine.sh"

# roll DIMENSIONS SLOPE D DEGREES E MU STEP: mean speed, its standard error, share stopped.
roll() {
  awk -v dim="$1" -v s="$2" -v d="$3" -v a="$4" -v e="$5" -v mu="$6" -v dt="$7" 'BEGIN {
    a *= atan2(0, -1) / 180; time = 300
    half = int(0.475 * time / dt + 0.5); tail = int(0.05 * time / dt + 0.5)
    print "units si\natom_style sphere\nboundary p p f\nnewton off\ncomm_modify vel yes\nregion b block 0 1000 0 1000 -10 10000 units box\ncreate_box 1 b"
    print "region in block 0 1000 0 1000", d / 2, d / 2 + 0.1, "units box\ncreate_atoms 1 random 60 12345 in\nreset_atom_ids sort yes"
    print "set group all diameter", d, "density 1\nset group all z", d / 2 + 0.01, "\nvelocity all set 1.5 0 0\npair_style none\nneighbor 0.05 bin\nneigh_modify exclude group all all"
    printf "fix fall all gravity 1 vector %.17g 0 %.17g\nfix move all nve/sphere\n", sin(a), -cos(a)
    print "fix wall all wall/rebound zplane 0.0 surface rq", s / sqrt(2) "m lambda_c 1m spread visible", (dim == 2 ? "plane" : "isotropic"), "rebound walton", e, mu, 0, "deposit off"
    print "timestep", dt, "\ncompute at all property/atom xu\nthermo 1000000"
    print "run", half, "\ndump a all custom 1 begin.txt id c_at\nrun 0\nundump a\nrun", half, "\ndump a all custom 1 middle.txt id c_at\nrun 0\nundump a\nrun", tail, "\ndump a all custom 1 end.txt id c_at\nrun 0" }' > roll.in
  "$ASPERITY_BIN/lammps-asperity" -in roll.in -log none > roll.screen 2>&1 || { tail -n 5 roll.screen >&2; return 1; }
  awk -v span="$(calc "int(0.475 * 300 / $7 + 0.5) * $7")" '
    FNR == 1 { file++; data = 0 } /^ITEM/ { data = /: ATOMS/; next }
    data && file == 1 { begin[$1] = $2 } data && file == 2 { middle[$1] = $2 }
    data && file == 3 { all++; if ($2 - middle[$1] > 0.2) { v = (middle[$1] - begin[$1]) / span; n++; s += v; q += v * v } }
    END { m = n ? s / n : 0; printf "%.4f %.4f %.3f\n", m, n ? sqrt((q / n - m * m) / n) : 0, 1 - n / all }' begin.txt middle.txt end.txt
}
while IFS=, read -r dim slope d angle e mu truth _ share; do
  for step in 0.5 0.05 0.005; do
    read -r speed error stopped <<< "$(roll $dim $slope $d $angle $e $mu $step)"
    row "$dim-D, slope $slope, d $d, $angle deg, e $e, mu $mu, step $step: $speed +- $error (stopped $stopped, truth $share), over the truth" "$(calc "($truth > 0) ? $speed / $truth : 0")" ""
  done
done < <(sed '/^[#a-z]/d' "$home/tests/sweep/rolling.csv")
