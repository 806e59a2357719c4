#!/usr/bin/env bash
# Grains that stay on a wall roll, slide and ride as closed forms have it, whatever the step and the kind of wall, and
# write no rows: on slopes less and more steep than tan a = 3.5 mu, with speeds and spins of their own, on belts, on
# walls that move away with them, inside a cylinder. The long runs of small steps are LIGGGHTS's, and in LAMMPS those of
# its own kind of wall, as the rolling is the same code.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
rayleigh_time=4.896e-4 # of soft()'s grains of 8 mm
stl <<< "-0.5 -0.1 0  1.5 -0.1 0  1.5 0.1 0  -0.5 0.1 0" > floor.stl
laws="rebound walton 0.5 0.3 0"

down() { awk -v a="$1" 'BEGIN { a *= atan2(0, -1) / 180; printf "%.17g 0 %.17g", sin(a), -cos(a) }'; }
spin() { # ID WX WY WZ
  if [ $simulator = lammps ]; then echo "set atom $1 omega $2 $3 $4"
  else echo "set atom $1 omegax $2 omegay $3 omegaz $4"; fi
}
wall() { # kind: its lines
  local end="$laws deposit off ledger 1000 file roll.csv"
  case $1 in
    plane) echo "fix wall all wall/rebound primitive type 1 zplane 0.0 $end" ;;
    belt) echo "fix wall all wall/rebound primitive type 1 zplane 0.0 shear x 0.3 $end" ;;
    mesh | lift) echo "fix floor all mesh/surface file floor.stl type 1"
      [ "$1" = mesh ] || echo "fix push all move/mesh mesh floor linear 0.3 0. 5."
      echo "fix wall all wall/rebound mesh n_meshes 1 meshes floor $end" ;;
    region) echo "region r block INF INF INF INF 0 INF units box
fix wall all wall/rebound region r $end" ;;
  esac
}
# Three grains: at rest, with a speed, with a spin; of the wall's velocity if it lifts.
scene() { # kind, slope in degrees, step, steps
  local up=0
  [ "$1" != lift ] || up=5
  soft "-0.5 1.5 -0.1 0.1 -0.02 2" 0.3 0.5 | sed 's/^neighbor .*/neighbor 0.02 bin/'
  put << END
1 0 -0.05 0.004 0 0 $up
2 0 0 0.004 0.2 0 $up
3 0 0.05 0.004 0 0 $up
END
  spin 3 0 50 0
  echo "neigh_modify exclude group all all
fix fall all gravity 9.81 vector $(down "$2")
$(wall "$1")
fix move all nve/sphere
timestep $3
thermo 1000000
thermo_style custom step f_wall[6]
dump at all custom $4 at.txt id x z vx vz omegay
dump_modify at sort id format \"%d %.17g %.17g %.17g %.17g %.17g\"
run $4"
}
# The closed form: v and r w along the slope from (v0, r w0), relative to a wall with velocity V.
closed='function go(t, v, s, V,   g, mu, a, n, sign, u, stop) {
    a = slope * atan2(0, -1) / 180; g = 9.81 * sin(a); n = 9.81 * cos(a); mu = 0.3; x = 0; v -= V
    while (t > 1e-12) {
      u = v - s; sign = u > 1e-12 ? 1 : u < -1e-12 ? -1 : g > 3.5 * mu * n ? 1 : 0
      if (sign == 0) { x += v * t + 5 / 14 * g * t * t; v += 5 / 7 * g * t; s = v; break }
      stop = -u / (g - 3.5 * mu * n * sign); if (!(stop > 0) || stop > t) stop = t
      x += v * stop + (g - mu * n * sign) / 2 * stop * stop; v += (g - mu * n * sign) * stop; s += 2.5 * mu * n * sign * stop; t -= stop }
    end_v = v + V; end_s = s }'
kinds="plane mesh belt lift"
[ $simulator = liggghts ] || kinds="$kinds region"
time=0.1
for kind in $kinds; do
  shares="0.001 0.2"
  [ $simulator = liggghts ] || [ $kind = region ] || shares=0.2
  for slope in 0 20 60; do
    for share in $shares; do
      step=$(mul $share $rayleigh_time)
      steps=$(awk -v t=$time -v dt="$step" 'BEGIN { printf "%d", t / dt }')
      scene $kind $slope "$step" "$steps" > roll.in
      rm -f roll.csv
      engine 1 roll.in
      [ "$(count_rows roll.csv)" = 0 ] || die "$kind, $slope degrees, $share of the Rayleigh time: rows of grains that stay"
      ! grep -E '^ +[0-9]+ +[1-9][0-9]* *$' roll.in.screen || die "$kind, $slope degrees: guarded"
      tail -n 3 at.txt | awk -v kind=$kind -v slope=$slope -v dt="$step" -v n="$steps" -v share=$share "$closed"'
        { V = kind == "belt" || kind == "lift" ? 0.3 : 0; W = kind == "lift" ? 5 : 0; t = n * dt
          go(t, $1 == 2 ? 0.2 : 0, $1 == 3 ? 0.2 : 0, V)
          x += V * t; scale = 1e-3 * (1 + 2 * share)
          bad = off($4, end_v, scale, 0.05) || off($6 * 0.004, end_s, scale, 0.05) || off($2, x, 2 * scale, 0.005) || off($5, W, 1e-12, 1) || off($3, 0.004 + W * t, 1e-9, 0.004)
          if (bad) { print "grain " $1 ": x " $2 ", v " $4 ", r w " $6 * 0.004 ", z " $3 ", vz " $5 "; wanted " x, end_v, end_s; wrong = 1 } }
        function off(is, want, tolerance, scale) { d = is - want; if (d < 0) d = -d; if (want < 0) want = -want; return !(d <= tolerance * (want > scale ? want : scale)) }
        END { exit wrong || NR != 3 }' > wrong || { cat wrong; die "$kind, a slope of $slope degrees, $share of the Rayleigh time"; }
    done
  done
done

# Inside a cylinder a grain that rolls down from 60 degrees keeps its energy, and comes to the other side as high.
for share in $([ $simulator = lammps ] || echo 0.001) 0.05; do
  step=$(mul $share $rayleigh_time)
  { soft "-0.1 0.1 -0.1 0.1 -0.1 0.1" 0.3 0.5 | sed 's/^neighbor .*/neighbor 0.02 bin/'
    awk 'BEGIN { a = atan2(0, -1) / 3; printf "1 0 %.17g %.17g 0 0 0\n", 0.046 * sin(a), -0.046 * cos(a) }' | put
    echo "fix fall all gravity 9.81 vector 0 0 -1
fix wall all wall/rebound primitive type 1 xcylinder 0.05 0 0 rebound walton 0.5 1.0 0 deposit off ledger 1000 file roll.csv
fix move all nve/sphere
timestep $step
thermo 1000000
variable e atom 0.7*(vy*vy+vz*vz)+9.81*z
variable r atom sqrt(y*y+z*z)
dump at all custom $(awk -v dt="$step" 'BEGIN { printf "%d", 0.005 / dt }') at.txt id y v_e v_r
dump_modify at format \"%d %.17g %.17g %.17g\"
run $(awk -v dt="$step" 'BEGIN { printf "%d", 1 / dt }')"; } > tube.in
  rm -f roll.csv
  engine 1 tube.in
  [ "$(count_rows roll.csv)" = 0 ] || die "a grain that rolls in a tube writes $(count_rows roll.csv) rows"
  awk -v share=$share 'NF == 4 && $1 == 1 { n++; if (n == 1) first = $3; d = ($3 - first) / (9.81 * 0.023); if (d < 0) d = -d; if (d > worst) worst = d
      off = $4 / 0.046 - 1; if (off < 0) off = -off; if (off > gap) gap = off; if ($2 < least) least = $2 }
    END { printf "in a tube at %g of the Rayleigh time: energy off by at most %.2g of the height, distance by %.2g, the other side at %.6f of the first\n", share, worst, gap, -least / (0.046 * sin(atan2(0, -1) / 3))
      exit !(n > 190 && worst < 1e-3 && gap < 1e-5 && -least > 0.0398 * 0.998) }' at.txt || die "a grain in a tube"
done
