#!/usr/bin/env bash
# Elastic bodies in a closed rough box: rods of two spheres spin about two axes, bodies of three spheres about three, so
# that E_rot/E_trans becomes 2/3 and 1; and the density of the rods' centers up to the walls is that of a random draw.
# STEPS=28000 gives 10^6 impacts of each.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
[ $simulator = lammps ] || source "$here/body_scene.sh"
[ $simulator = liggghts ] || source "$here/rigid_scene.sh"
count=1000 step=4e-4 steps=${STEPS:-2000} # 37 impacts a step
begin() { # SPHERES
  if [ $simulator = liggghts ]; then
    velocity="0.5 -0.8 -1.2" wide=0.02
    bodies $count random -0.02 0.02 "nspheres $(($(wc -w <<< "$1") / 4)) ntry 300000 spheres $1" | sed 's/overlapcheck yes/overlapcheck no/'
    closed surface sigma 10 rebound constant 1 1 deposit off
  else
    rigid_data $count "$1" > data
    start | sed 's/ cutoff .*/ cutoff 0.03/'; go_on rigid/small; echo "velocity all set 0.5 -0.8 -1.2"
    for plane in x y z; do for at in lo hi; do
      echo "fix $plane$at all wall/rebound ${plane}plane $([ $at = lo ] && echo -)0.02 surface sigma 10 rebound constant 1 1 deposit off"
    done; done
  fi
}
gas() { # NAME SPHERES
  { begin "$2"
    echo "variable all equal f_xlo+f_xhi+f_ylo+f_yhi+f_zlo+f_zhi
thermo_style custom step c_ke c_re v_all
timestep $step
thermo $((steps / 100))
dump at all custom $((steps / 50)) $1.at id x y z
run $steps"; } > $1.in
  TIMEOUT=3000 engine 1 $1.in
  # The first fifth is the way to equilibrium; standard errors by ten blocks of the rest.
  grep -E '^ +[0-9]+ +[0-9.e+-]+ +[0-9.e+-]+ +[0-9.e+-]+ *$' $1.in.screen | awk -v all=$steps '
    $2 > 0 && $3 > 0 { if (!first) first = $2 + $3; drift = ($2 + $3) / first - 1; n = $4; if ($1 > all / 5) { k = int(($1 / all - 0.2) / 0.08); if (k > 9) k = 9; e[k] += $2; r[k] += $3 } }
    END { for (k = 0; k < 10; k++) { q = r[k] / e[k]; s += q / 10; t += q * q / 10 } printf "%.5f %.5f %d %.2g\n", s, sqrt((t - s * s) / 9), n, drift }'
}
read -r ratio error impacts drift < <(gas rods "-8e-3 0 0 4e-3 8e-3 0 0 4e-3")
echo "rods: $impacts impacts, E_rot/E_trans $ratio +- $error (2/3), energy off by $drift"
awk -v r="$ratio" -v e="$error" -v d="$drift" 'BEGIN { d *= d; r = r - 2 / 3; exit r * r > (4 * e + 0.002) ^ 2 || d > 1e-3 }' || die "rods"

# In the second half of the run, the density of the rods' centers over the distance from the walls, against positions and axes drawn at random, of which those
# stay that fit into the box.
awk -v half=0.016 -v a=0.008 '
  function bin(x,   k) { x = x < 0 ? -x : x; k = int(8 * x / half); return k > 7 ? 7 : k }
  /^ITEM: TIMESTEP/ { getline; step = $1; frame++ } /^ITEM:/ { next }
  NF == 4 && frame > 25 { seen[frame, $1] = 1; for (k = 2; k <= 4; k++) at[frame, $1, k] = $k; if ($1 > most) most = $1; last = frame }
  END {
    srand(7); pi = atan2(0, -1)
    while (m < 400000) { c = 2 * rand() - 1; s = sqrt(1 - c * c); f = 2 * pi * rand(); u[1] = s * cos(f); u[2] = s * sin(f); u[3] = c; ok = 1
      for (k = 1; k <= 3; k++) { p[k] = half * (2 * rand() - 1); d = a * (u[k] < 0 ? -u[k] : u[k]) + (p[k] < 0 ? -p[k] : p[k]); if (d > half) ok = 0 }
      if (ok) { m++; for (k = 1; k <= 3; k++) should[bin(p[k])]++ } }
    for (f = 26; f <= last; f++) { b = int((f - 26) * 8 / (last - 25)); for (i = 1; i < most; i += 2) if (((f, i) in seen) && ((f, i + 1) in seen)) for (k = 2; k <= 4; k++) { n[b]++; of[b, bin(0.5 * (at[f, i, k] + at[f, i + 1, k]))]++ } }
    for (k = 0; k < 8; k++) { x = y = 0; for (b = 0; b < 8; b++) { q = of[b, k] / n[b] / (should[k] / (3 * m)); x += q / 8; y += q * q / 8 }
      e = sqrt((y - x * x) / 7 + 1 / should[k]); printf "%s%.3f +- %.3f", k ? ", " : "density from the middle to the walls over that of a random draw: ", x, e; if ((x - 1) ^ 2 > (4 * e + 0.01) ^ 2) bad = 1 }
    print ""; exit bad }' rods.at || die "the density at the walls"

read -r ratio error impacts drift < <(gas threes "-6e-3 -4e-3 0 3e-3 8e-3 -4e-3 0 3e-3 0 8e-3 0 3e-3")
echo "bodies of three spheres: $impacts impacts, E_rot/E_trans $ratio +- $error (1), energy off by $drift"
awk -v r="$ratio" -v e="$error" -v d="$drift" 'BEGIN { d *= d; r = r - 1; exit r * r > (4 * e + 0.003) ^ 2 || d > 1e-3 }' || die "bodies of three spheres"
