#!/usr/bin/env bash
# 300 dumbbells in a hopper and, on demand, in a drum with lifters, with smooth walls of equal friction: this wall and
# wall/gran. The means of the fillings agree within 10 % and 3 standard errors. FILLINGS=4 SCENES="hopper drum" is the long
# run.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
fillings=${FILLINGS:-2}
dumbbells() { # BOX FILLING REGION OUTSIDE: 300 of them, of spheres of 3.5 mm, in a region
  soft "$1" 0.3 0.5
  local seed
  seed=$(awk -v k="$2" 'BEGIN { srand(k); n = 10000 + 80000 * rand(); for (n = int(n); ; n++) { for (i = 2; i * i <= n && n % i; i++) ; if (i * i > n) { print n; exit } } }')
  echo "fix t1 all particletemplate/multisphere 15485863 atom_type 1 density constant 2500 nspheres 2 ntry 1000000 spheres -1.75e-3 0 0 1.75e-3 1.75e-3 0 0 1.75e-3 type 1
fix d1 all particledistribution/discrete 32452843 1 t1 1.0
region in $3 units box
fix ins all insert/pack seed $seed distributiontemplate d1 maxattempt 1000 vel constant 0 0 -0.1 insert_every once overlapcheck yes orientation random all_in yes particles_in_region 300 region in
fix move all multisphere
fix fall all gravity 9.81 vector 0 0 -1
compute ke all ke/multisphere
compute re all erotate/multisphere
compute height all reduce ave z
variable below atom z<0
compute below all reduce sum v_below
variable outside atom $4
compute outside all reduce sum v_outside
thermo_style custom step atoms c_ke c_re c_height c_below c_outside
thermo_modify lost ignore norm no
thermo 100"
}
wall() { # KIND ID GEOMETRY
  if [ "$1" = gran ]; then echo "fix $2 all wall/gran model hertz tangential history $3"; else echo "fix $2 all wall/rebound $3 rebound walton 0.5 0.3 0 deposit off"; fi
}
hopper() { # KIND FILLING
  dumbbells "-0.2 0.2 -0.2 0.2 -0.6 0.2" "$2" "cylinder z 0 0 0.026 0.03 0.14" "(z>0.002)*(x*x+y*y>9e-4)"
  echo "fix hopper all mesh/surface file funnel.stl type 1
$(wall $1 w1 "mesh n_meshes 1 meshes hopper")
$(wall $1 plug "primitive type 1 zplane 0.0")
timestep 2e-5
run 7500
unfix plug
run 12500"
}
drum() {
  dumbbells "-0.045 0.045 -0.018 0.018 -0.045 0.045" "$2" "cylinder y 0 0 0.03 -0.0145 0.0145" "(x*x+z*z>1.6e-3)"
  echo "fix drum all mesh/surface file drum.stl type 1
fix turn all move/mesh mesh drum rotate origin 0. 0. 0. axis 0. 1. 0. period 0.6
$(wall $1 w1 "mesh n_meshes 1 meshes drum")
timestep 2.5e-5
run 16000"
}
meshes
awk 'BEGIN { n = 24; for (k = 0; k < n; k++) { a = 8 * atan2(1, 1) * k / n; b = 8 * atan2(1, 1) * (k + 1) / n
    print .018 * cos(a), .018 * sin(a), 0, .018 * cos(b), .018 * sin(b), 0, .03 * cos(b), .03 * sin(b), .03, .03 * cos(a), .03 * sin(a), .03
    print .03 * cos(a), .03 * sin(a), .03, .03 * cos(b), .03 * sin(b), .03, .03 * cos(b), .03 * sin(b), .18, .03 * cos(a), .03 * sin(a), .18 } }' | stl > funnel.stl

# A row a run: the spheres that are left, less those outside, and the compared numbers.
lines() { grep -E '^[ 0-9.e+-]+$' "$1" | awk 'NF == 7'; }
hopper_row='$1 >= 7500 { n++; out[n] = $6; t[n] = $1 * 2e-5 } { all = $2; wrong += $7 }
  END { for (a = 1; a < n && out[a] < 60; a++) ; for (b = a + 1; b < n && out[b] < 420; b++) ; print all - wrong, (out[b] - out[a]) / 2 / (t[b] - t[a]) }'
drum_row='$1 >= 6000 { n++; e += $3 + $4; z += $5; part += $4 / ($3 + $4) } { all = $2; wrong += $7 } END { print all - wrong, e / n, z / n, part / n }'
for ((filling = 1; filling <= fillings; filling++)); do
  for scene in ${SCENES:-hopper}; do
    for kind in gran rebound; do
      run=$scene.$kind.$filling row=${scene}_row
      $scene $kind "$filling" > $run.in
      engine 1 $run.in
      lines $run.in.screen | awk "${!row}" >> $scene.$kind
      tail -n 1 $scene.$kind | sed "s/^/$run: /"
    done
  done
done
compare() { # SCENE NAME...
  paste -d' ' $1.gran $1.rebound | awk -v names="${*:2}" -v scene="$1" '
    { half = NF / 2; n++; if ($1 != 600 || $(1 + half) != 600) { print scene ": spheres are lost or outside: " $0; bad = 1 }
      for (k = 2; k <= half; k++) { g[k] += $k; r[k] += $(k + half); gg[k] += $k ^ 2; rr[k] += $(k + half) ^ 2 } }
    function error(s, q) { return n > 1 && q > s * s / n ? sqrt((q - s * s / n) / (n - 1) / n) : 0 }
    END { split(names, name, " ")
      for (k = 2; k <= half; k++) { a = g[k] / n; b = r[k] / n; se = sqrt(error(g[k], gg[k]) ^ 2 + error(r[k], rr[k]) ^ 2)
        printf "%s: %s %.4g +- %.2g with wall/gran, %.4g +- %.2g with wall/rebound\n", scene, name[k - 1], a, error(g[k], gg[k]), b, error(r[k], rr[k])
        d = b - a; if (d < 0) d = -d; if (d > 0.1 * (a < 0 ? -a : a) + 3 * se) bad = 1 }
      exit bad }' || die "$1: not as with wall/gran"
}
for scene in ${SCENES:-hopper}; do
  [ $scene = drum ] && compare drum energy height rotation || compare hopper bodies/s
done
