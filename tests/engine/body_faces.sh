#!/usr/bin/env bash
# Bodies at rough walls: a clump that is a sphere does what a sphere does, and dumbbells lie in the valleys of a wall
# that would let them slide without.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
source "$here/body_scene.sh"

format='modify sort id format "%d %.15g %.15g %.15g %.15g %.15g %.15g"'
wall() { # GROUP FILE
  echo "fix floor $1 wall/rebound primitive type 1 zplane -0.02 surface rq 20e-6 lambda_c 200e-6 rebound walton 0.4 0.3 0 deposit off ledger 1 file $2 columns full
fix g all gravity 9.81 vector 0.1 0 -1
timestep 2e-5"
}

# The second sphere is inside of the first one and meets nothing; the engine's moments of inertia and center of mass are
# sums over random points. Spheres have the odd tags, as the outer spheres of the bodies.
{ velocity="0.05 0.02 -0.3" right=0 bodies 60 random -0.0195 -0.016 "nspheres 2 ntry 1000000 spheres 0 0 0 0.5e-3 0 0 0 0.1e-3"
  wall all body.csv
  echo "run 1
write_dump all custom begin.txt id x y z vx vy vz $format
run 6000
write_dump all custom body.txt id x y z vx vy vz $format"; } > body.in
engine 1 body.in
{ bodies 1 random -0.019 0 | sed '/^fix t1/,/^fix ins/d; /^fix integr/,$d'
  sed '1,/^ITEM: ATOMS/d' begin.txt | awk '
    { print "create_atoms 1 single", $2, $3, $4, "units box"; set = set sprintf("set atom %d vx %s vy %s vz %s\n", $1, $5, $6, $7); if ($1 % 2) odd = odd " " $1 }
    END { print "set group all diameter 1e-3 density 2500"; printf "%s", set; print "group odd id" odd }'
  wall odd sphere.csv
  echo "fix move odd nve/sphere
run 6000
write_dump all custom sphere.txt id x y z vx vy vz $format"; } > sphere.in
engine 1 sphere.in
for n in 1 2; do
  off=$(awk -F, -v n=$n '$2 != n || /^#/ { next } NR == FNR { x[$1] = $27; y[$1] = $28; z[$1] = $29; next }
    $1 in x { k++; s += sqrt((x[$1] - $27) ^ 2 + (y[$1] - $28) ^ 2 + (z[$1] - $29) ^ 2) / $10 } END { print k < 50 ? 1 : s / k }' body.csv sphere.csv)
  echo "impact $n of a body that is a sphere: v2 off by $off of v1"
  awk -v o="$off" -v n=$n 'BEGIN { exit o > 0.002 * n }' || die "impact $n: v2 is off by $off"
done
means() { # FILE: how many have lost their motion, and the mean speed of all
  sed '1,/^ITEM: ATOMS/d' "$1" | awk '$1 % 2 { n++; v += $5; rests += $5 ^ 2 + $6 ^ 2 < 1e-6 } END { print v / n, rests }'
}
read -r a _ < <(means body.txt); read -r b _ < <(means sphere.txt)
grazes() { rows "$1" | awk -F, '$11 < 0.5' | wc -l; }
echo "speed $a ($b), grazing impacts $(grazes body.csv) ($(grazes sphere.csv))"
awk -v a="$a" -v b="$b" -v n="$(grazes body.csv)" -v m="$(grazes sphere.csv)" 'BEGIN { exit !(a > 0.8 * b && a < 1.25 * b && m > 100 && n > 0.7 * m && n < 1.4 * m) }' || die "a body that is a sphere: speed $a ($b), grazing impacts $(grazes body.csv) ($(grazes sphere.csv))"

# Without friction: dumbbells slide down a smooth slope, and most lie still on a rough one. The walls carry the same.
slide() { # NAME SURFACE
  { velocity="0 0 0"; right=0; bodies 20 "constant 1 0 0 0" -0.0199 -0.0170
    echo "fix floor all wall/rebound primitive type 1 zplane -0.02 $2 rebound walton 0.3 0 0 deposit off
fix g all gravity 9.81 vector 0.035 0 -1
variable still atom (vx*vx+vy*vy)<1e-8
compute v all reduce ave vx
compute still all reduce sum v_still
thermo_style custom step atoms c_v f_floor[9] c_still
thermo 4000
timestep 2e-5
run 4000"; } > slide.$1.in
  engine 1 slide.$1.in
  last slide.$1.in.screen
}
read -r _ n smooth f _ < <(slide smooth "surface smooth")
read -r _ _ _ g still < <(slide rough "surface rq 20e-6 lambda_c 200e-6")
echo "on a slope without friction: speed $smooth on a smooth wall, $still of $n spheres lie on a rough one; carried: $f and $g"
awk -v n="$n" -v a="$smooth" -v s="$still" -v f="$f" -v g="$g" 'BEGIN { v = 9.81 * 0.035 * 0.08; exit !(n == 40 && a > 0.98 * v && a < 1.02 * v && s > 0.4 * n && f < 0 && g < 0.8 * f && g > 1.2 * f) }' || die "valleys: speed $smooth, $still of $n lie still, $f and $g"
