#!/usr/bin/env bash
# Grains that roll down a rough slope, in LAMMPS, against spheres over generated walls that they have closed, computed
# event by event without a model of the tilt (units: gravity and lambda_c; 16 profiles or 8 surfaces each; slopes rms
# before the closing): mean speed in the last half of the time, of those that have not stopped, over the reference.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "${BASH_SOURCE[0]}")/engine.sh"
# dimensions, slope rms, d, degrees, e, mu, reference: speed, share stopped
reference='2 0.2 4 5 0.5 0.3 1.492 0
2 0.1 4 5 0.5 0.3 4.489 0
2 0.3 4 5 0.5 0.3 0.965 0.50
2 0.2 1 5 0.5 0.3 1.526 0
2 0.2 10 5 0.5 0.3 1.935 0
2 0.2 4 2 0.5 0.3 1.142 0.06
2 0.2 4 3.5 0.5 0.3 1.396 0.06
2 0.2 4 8 0.5 0.3 2.338 0
2 0.2 4 5 0.2 0.3 1.646 0
2 0.2 4 5 0.8 0.3 1.262 0.44
2 0.2 4 5 0.5 0.1 1.494 0
2 0.2 4 5 0.5 0.6 1.486 0
3 0.2 4 5 0.5 0.3 1.384 0
3 0.1 4 5 0.5 0.3 3.655 0
3 0.3 4 5 0.5 0.3 1.036 0.25
3 0.2 1 5 0.5 0.3 1.399 0
3 0.2 2 5 0.5 0.3 1.318 0
3 0.2 4 3.5 0.5 0.3 1.257 0
3 0.2 4 5 0.2 0.3 1.560 0
3 0.2 4 5 0.8 0.3 1.360 0.50
3 0.2 4 5 0.5 0.1 1.403 0'

# roll DIMENSIONS SLOPE D DEGREES E MU STEP: mean speed, its standard error, share stopped.
roll() {
  awk -v dim="$1" -v s="$2" -v d="$3" -v a="$4" -v e="$5" -v mu="$6" -v dt="$7" 'BEGIN {
    a *= atan2(0, -1) / 180; time = dim == 2 ? 400 : 300
    half = int(0.475 * time / dt + 0.5); tail = int(0.05 * time / dt + 0.5)
    print "units si\natom_style sphere\nboundary p p f\nnewton off\ncomm_modify vel yes\nregion b block 0 1000 0 1000 -10", 100 + 20 * d, "units box\ncreate_box 1 b"
    print "region in block 0 1000 0 1000", d / 2, d / 2 + 0.1, "units box\ncreate_atoms 1 random 60 12345 in\nreset_atom_ids sort yes"
    print "set group all diameter", d, "density 1\nset group all z", d / 2 + 0.01, "\nvelocity all set 1.5 0 0\npair_style none\nneighbor 0.05 bin\nneigh_modify exclude group all all"
    printf "fix fall all gravity 1 vector %.17g 0 %.17g\nfix move all nve/sphere\n", sin(a), -cos(a)
    print "fix wall all wall/rebound zplane 0.0 surface rq", s / sqrt(2) "m lambda_c 1m spread visible", (dim == 2 ? "plane" : "isotropic"), "rebound walton", e, mu, 0, "deposit off"
    print "timestep", dt, "\ncompute at all property/atom xu\nthermo 1000000"
    print "run", half, "\ndump a all custom 1 begin.txt id c_at\nrun 0\nundump a\nrun", half, "\ndump a all custom 1 middle.txt id c_at\nrun 0\nundump a\nrun", tail, "\ndump a all custom 1 end.txt id c_at\nrun 0" }' > roll.in
  "$ASPERITY_BIN/lammps-asperity" -in roll.in -log none > roll.screen 2>&1 || { tail -n 5 roll.screen >&2; return 1; }
  awk -v span="$(awk -v dim="$1" -v dt="$7" 'BEGIN { print int(0.475 * (dim == 2 ? 400 : 300) / dt + 0.5) * dt }')" '
    FNR == 1 { file++; data = 0 } /^ITEM/ { data = /: ATOMS/; next }
    data && file == 1 { begin[$1] = $2 } data && file == 2 { middle[$1] = $2 }
    data && file == 3 { all++; if ($2 - middle[$1] > 0.2) { v = (middle[$1] - begin[$1]) / span; n++; s += v; q += v * v } }
    END { m = s / n; printf "%.4f %.4f %.3f\n", m, sqrt((q / n - m * m) / n), 1 - n / all }' begin.txt middle.txt end.txt
}
while read -r dim slope d angle e mu truth share; do
  for step in 0.5 0.05 0.005; do
    read -r speed error stopped <<< "$(roll $dim $slope $d $angle $e $mu $step)"
    row "$dim-D, slope $slope, d $d, $angle deg, e $e, mu $mu, step $step: $speed +- $error (stopped $stopped, reference $share), over the reference" "$(calc "$speed / $truth")" ""
  done
done <<< "$reference"
