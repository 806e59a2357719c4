#!/usr/bin/env bash
# Flights with known answers: where a particle is after a rebound, whatever the step;
# between two planes with several contacts in one step; inside a cylinder; off an edge of a mesh.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
flight() { # walls, particle (x y z, vx vy vz), step, steps
  head_of si
  echo "region box block -0.01 0.01 -0.01 0.01 -0.01 0.01 units box
create_box 2 box
neighbor 1e-3 bin
neigh_modify delay 0"
  materials
  echo "create_atoms 1 single $2 units box
set group all diameter 1e-4 density 2650
velocity all set $3 units box
fix move all nve/sphere
timestep $4
$1
dump d all custom $5 at.txt x y z vx vz
dump_modify d format \"%.15g %.15g %.15g %.15g %.15g\"
run $5"
}
at() { tail -n 1 at.txt; }
ends() { # name, x y z vx vz: to 1e-12 m and 1e-9 m/s
  engine 1 "$1.in"
  at | awk -v want="$2" '
    { split(want, w, " ")
      for (i = 1; i <= 5; i++) { d = $i - w[i]; if (d < 0) d = -d; if (!(d <= (i > 3 ? 1e-9 : 1e-12))) bad = 1 } }
    bad { print "is   " $0; print "want " want } END { exit bad || !NR }' || die "$1"
}
mirror='surface smooth rebound constant 1 1 deposit off'

# Specular plane: 0.3 mm down, then up; contact falls inside a step.
for step in "1e-7 100" "1e-6 10" "3e-6 3"; do
  set -- $step
  n=$(awk -v dt="$1" 'BEGIN { printf "%d", 1e-5 / dt + 0.5 }')
  t=$(awk -v dt="$1" -v n="$n" 'BEGIN { printf "%.15g", n * dt }')
  flight "fix w all wall/rebound primitive type 2 zplane 0.0 $mirror" "0 0 3.5e-4" "10 0 -50" "$1" "$n" > plane.in
  ends plane "$(awk -v t="$t" 'BEGIN { printf "%.15g 0 %.15g 10 50", 10 * t, 5e-5 + 50 * t - 3e-4 }')"
done

# Half the normal speed, nine tenths of the tangential.
flight 'fix w all wall/rebound primitive type 2 zplane 0.0 surface smooth rebound constant 0.5 0.9 deposit off' \
  "0 0 2.5e-4" "10 0 -50" 1e-6 10 > half.in
ends half "$(awk 'BEGIN { printf "%.15g 0 %.15g 9 25", 4e-6 * 10 + 6e-6 * 9, 5e-5 + 6e-6 * 25 }')"

# Two planes 0.15 mm apart, gap 0.05 mm: several contacts in one step of 6 us (0.3 mm of flight).
flight "fix a all wall/rebound primitive type 2 zplane 0.0 $mirror
fix b all wall/rebound primitive type 2 zplane 1.5e-4 $mirror" "0 0 7e-5" "1 0 -50" 6e-6 2 > slot.in
bounced="$(awk 'BEGIN { z = 2e-5 - 50 * 12e-6; z -= 1e-4 * int(z / 1e-4); if (z < 0) z += 1e-4; up = 0; s = (50 * 12e-6 - 2e-5) / 5e-5; k = int(s); r = (s - k) * 5e-5; printf "%.15g 0 %.15g 1 %d", 12e-6, 5e-5 + (k % 2 ? 5e-5 - r : r), k % 2 ? -50 : 50 }')"
ends slot "$bounced"

# The same between two triangles: each is left, and met again in the same step.
facet() { printf '%s\n' "facet normal 0 0 1" "outer loop" "vertex -0.005 -0.005 $1" "vertex 0.005 -0.005 $1" "vertex 0 0.005 $1" endloop endfacet; }
{ echo "solid s"; facet 0; facet 1.5e-4; echo "endsolid s"; } > slot.stl
flight "fix plates all mesh/surface file slot.stl type 2
fix w all wall/rebound mesh n_meshes 1 meshes plates $mirror" "0 0 7e-5" "1 0 -50" 6e-6 2 > facets.in
ends facets "$bounced"

# A plate of two triangles in a periodic box, which is met after one and a half periods.
stl > floor.stl << END
-0.01 -0.01 0  0.01 -0.01 0  0.01 0.01 0  -0.01 0.01 0
END
flight "fix floor all mesh/surface file floor.stl type 2
fix w all wall/rebound mesh n_meshes 1 meshes floor $mirror" "0 0 4.55e-3" "100 0 -15" 2e-7 2000 |
  sed 's/^boundary.*/boundary p p f/' > periods.in
ends periods "0 0 1.55e-3 100 15"

# Inside a cylinder of radius 2 mm along x: a chord at 45 degrees to the wall, four contacts a turn. The
# center moves on a square of half diagonal 1.95 mm.
flight "fix w all wall/rebound primitive type 2 xcylinder 2e-3 0 0 $mirror" "0 0 -1.94e-3" "0 50 50" 1e-6 100 > tube.in
engine 1 tube.in
at | awk '{ r = sqrt($2 * $2 + $3 * $3); exit !(r <= 1.95e-3 * (1 + 1e-9) && r >= 1.95e-3 / sqrt(2) * 0.98) }' ||
  die "tube: left its square"

# A chord at 5 degrees, shorter than the step: the wall is left at first, and met again within it.
flight "fix w all wall/rebound primitive type 2 xcylinder 2e-3 0 0 $mirror" "0 0 -1.949e-3" "0 69.73 6.1" 5.8e-6 1 > chord.in
engine 1 chord.in
at | awk '{ z = -1.949e-3; u = 69.73; w = 6.1; uu = u * u + w * w; b = z * w / uu; r = 1.95e-3
  t = -b + sqrt(b * b + (r * r - z * z) / uu); y = u * t; z += w * t; vn = (u * y + w * z) / r / r
  u -= 2 * vn * y; w -= 2 * vn * z; y += u * (5.8e-6 - t) - $2; z += w * (5.8e-6 - t) - $3; w -= $5
  exit !(y * y + z * z < 1e-24 && w * w < 1e-12) }' || die "chord: not where the wall sends it"

# Steps as long as the cylinder is wide: every chord turns the flight by the same angle.
flight "fix w all wall/rebound primitive type 2 xcylinder 2e-3 0 0 $mirror" "0 3e-4 -2e-4" "0 30 40" 4e-5 20 > long.in
engine 1 long.in
at | awk '{ y = 3e-4; z = -2e-4; u = 30; w = 40; left = 20 * 4e-5; R = 1.95e-3
  for (;;) {
    b = (y * u + z * w) / 2500; t = -b + sqrt(b * b + (R * R - y * y - z * z) / 2500)
    if (t > left) break
    y += u * t; z += w * t; left -= t; n = 2 * (u * y + w * z) / (y * y + z * z); u -= n * y; w -= n * z }
  y += u * left - $2; z += w * left - $3; w -= $5
  exit !(y * y + z * z < 1e-20 && w * w < 1e-10) }' || { at; die "a long step in a cylinder"; }

# A particle that keeps no speed along the normal slides around a cylinder without friction, and does not stop.
flight "fix w all wall/rebound primitive type 2 xcylinder 2e-3 0 0 surface smooth rebound constant 0 1 friction 0 deposit off" "0 0 -1.5e-3" "0 50 -1" 1e-6 200 > slide.in
engine 1 slide.in
at | awk '{ exit !($2 * $2 + $3 * $3 < (1.95e-3 * (1 + 1e-9)) ^ 2 && $2 < 0 && atan2($2, -$3) > -2.3 && atan2($2, -$3) < -2.1) }' ||
  { at; die "slide without friction: not around the cylinder"; }

# With friction it is pressed against the wall by the curve of its path:
# mu takes speed until it rolls at 5/7 of it, after the angle ln(7/5)/mu.
flight "fix w all wall/rebound primitive type 2 xcylinder 2e-3 0 0 surface smooth rebound constant 0 1 friction 0.3 deposit off" "0 0 -1.5e-3" "0 50 -1" 1e-6 200 > slide.in
engine 1 slide.in
at | awk '{ pi = atan2(0, -1); R = 1.95e-3; mu = 0.3; t = (sqrt(1.5e-3 ^ 2 + 2501 * (R ^ 2 - 1.5e-3 ^ 2)) - 1.5e-3) / 2501
  b = 1.5e-3 + t; begin = 50 * t; u = (50 * b - begin) / R
  angle = atan2(begin, b) + log(7 / 5) / mu + 5 / 7 * (u * (2e-4 - t) / R - 0.4 / mu); d = angle - atan2($2, -$3) - 2 * pi
  printf "slides on by %g rad off the closed form\n", d
  exit !($2 * $2 + $3 * $3 < (R * (1 + 1e-9)) ^ 2 && d < 3e-3 && d > -3e-3) }' ||
  { at; die "slide: not around the cylinder"; }

# The edge x = 0 of a plate at z = 0, x > 0, met by a center 30 um outside it.
cat > edge.stl << 'END'
solid e
facet normal 0 0 1
outer loop
vertex 0 -0.005 0
vertex 0.005 -0.005 0
vertex 0 0.005 0
endloop
endfacet
endsolid e
END
flight "fix plate all mesh/surface file edge.stl type 2
fix w all wall/rebound mesh n_meshes 1 meshes plate $mirror" "-3e-5 -1e-3 2.4e-4" "0 0 -50" 1e-6 8 > edge.in
# contact at height h = sqrt(r^2 - 30um^2) = 40 um after 4 us; normal (-0.6, 0, 0.8); v2 = v - 2 (v.n) n
ends edge "$(awk 'BEGIN { vn = -40; vx = -2 * vn * -0.6; vz = -50 - 2 * vn * 0.8; printf "%.15g -0.001 %.15g %.15g %.15g", -3e-5 + vx * 4e-6, 4e-5 + vz * 4e-6, vx, vz }')"
