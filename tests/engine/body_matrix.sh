#!/usr/bin/env bash
# Dumbbells of fix rigid/small that stick, rest and fly, at planes, meshes and regions at rest, that move, turn, and cross
# a periodic edge; on 1, 2 and 4 ranks; in a run that goes on and over a restart; with a wall that comes between the
# runs; and with gravity before and behind the fix of bodies. What is stuck goes with its wall, what rests stays at it,
# nothing passes it, and nothing depends on the ranks.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
source "$here/rigid_scene.sh"
steps=${STEPS:-400}

# 45 dumbbells of spheres of 0.2 mm, by 15: they stick, rest, and fly; some lie across an edge of the box of 4 mm.
awk 'BEGIN { r = 1e-4; printf "b\n\n90 atoms\n1 atom types\n-2e-3 2e-3 xlo xhi\n-2e-3 2e-3 ylo yhi\n-1e-3 5e-3 zlo zhi\n\nAtoms # sphere\n\n"
  for (i = 0; i < 45; i++) { kind = i % 3; a = 0.7 * i; x = (i % 9 - 4) * 4.3e-4; y = (int(i / 9) - 2) * 7.5e-4
    gap = kind == 0 ? 2e-5 * (1 + i % 5) : kind == 1 ? 0 : 4e-4 + 1e-5 * i
    for (s = -1; s <= 1; s += 2) { n++; printf "%d 1 2e-4 2500 %.17g %.17g %.17g\n", n, x + s * r * cos(a), y + s * r * sin(a), r + gap
      v[n] = kind == 0 ? -1 : kind == 2 ? -1.6 : 0 } }
  printf "\nVelocities\n\n"; for (k = 1; k <= n; k++) print k, 0, 0, v[k], 0, 0, 0
  printf "\nMols\n\n"; for (k = 1; k <= n; k++) print k, int((k + 1) / 2) }' > data
ids() { seq 0 44 | awk -v k="$1" '$1 % 3 == k { printf " %d %d", 2 * $1 + 1, 2 * $1 + 2 }'; }
plate 8 1.0526315789473684 1.9e-3 > full.stl # as wide as the box

wall() { # SCENE WHO LAW
  local shape="stl full.stl"
  case $1 in
    plane) shape="zplane 0" ;; move) shape+=" move linear 0.3 0.2 0" ;; edge) shape+=" move linear 2 1 0" ;;
    turn) shape="stl full.stl scale 0.9 move rotate 0 0 0 0 0 1 1e-1" ;; region) shape="region floor" ;;
  esac
  echo "fix $2 $2 wall/rebound $shape rebound $3"
}
scene() { # SCENE WAY [GRAVITY]: WAY is whole, again (over a restart), later (a wall that comes later) or before
  local fall="fix fall all gravity 981 vector 0 0 -1"
  if [ "$2" = again ]; then
    echo "units si
atom_style sphere
atom_modify map array
newton off
comm_modify vel yes cutoff 1e-3
read_restart $1.restart
fix mol all property/atom mol ghost yes"
  else start "$(case $1 in turn | region) echo f f f ;; *) echo p p f ;; esac)" | sed 's/cutoff 3e-3/cutoff 1e-3/'; fi
  [ "${3:-}" != before ] || echo "$fall"
  go_on rigid/small | sed 's/^neighbor .*/neighbor 2e-4 bin/'
  [ "${3:-}" = before ] || echo "$fall"
  [ "$2" = again ] || echo "group glue id$(ids 0)
group hard id$(ids 1)$(ids 2)"
  echo "variable th equal 2*PI*step*dt/1e-1
region floor block -2e-3 2e-3 -2e-3 2e-3 0 1 units box rotate v_th 0 0 0 0 0 1"
  [ "$2" = later ] || wall "$1" glue "constant 0 0"
  wall "$1" hard "constant 0.5 0.5 deposit off"
  echo "timestep 2e-6
dump at all custom $((steps / 2)) $1.$2.at id x y z vx vy vz
dump_modify at sort id format line \"%d %.17g %.17g %.17g %.17g %.17g %.17g\"
thermo $steps"
  [ "$2" != later ] || { echo "run 8"; wall "$1" glue "constant 0 0"; }
  [ "$2" = again ] || echo "run $((steps / 2))"
  [ "$2" != whole ] || echo "write_restart $1.restart"
  echo "run $((steps / 2))
clear"
}
last() { awk '/TIMESTEP/ { n = 0 } NF == 7 && $1 ~ /^[0-9]+$/ { line[++n] = $0 } END { for (k = 1; k <= n; k++) print line[k] }' "$1"; }

# apart A B: how far spheres are apart, at most, in radii, and in how far they move in 100 steps.
apart() { paste -d' ' "$1" "$2" | awk '{ for (k = 2; k <= 7; k++) { d = ($k - $(k + 7)) / (k < 5 ? 1e-4 : 0.5); if (d < 0) d = -d; if (d > most) most = d } } END { printf "%.1g", most }'; }

for s in plane rest move edge turn region; do
  { scene $s whole; scene $s again; scene $s later; } > $s.in
  scene $s before before > $s.before.in
  most=
  for ranks in 1 2 4; do
    engine $ranks $s.in
    for way in whole again later; do
      last $s.$way.at > $s.$way.$ranks
      awk -v scene=$s -v pi=3.14159265358979 -v way=$way '
        function off(a, b) { return a > b ? a - b : b - a }
        function wrong(what) { print $0 ": " what; bad = 1 }
        BEGIN { r = 1e-4; vx["move"] = 0.3; vy["move"] = 0.2; vx["edge"] = 2; vy["edge"] = 1; omega = scene ~ /turn|region/ ? 2 * pi / 1e-1 : 0 }
        { kind = int(($1 - 1) / 2) % 3; n[kind]++; u = vx[scene] - omega * $3; v = vy[scene] + omega * $2
          if ($0 ~ /nan|inf/) wrong("no number")
          if ($4 < r * (1 - 1e-5)) wrong("has passed the wall")
          if (kind == 0 && off($4, r) > 1e-9) wrong("is not where it stuck")
          if (kind == 0 && off($5, u) + off($6, v) + off($7, 0) > 1e-6 + 1e-6 * (off(u, 0) + off(v, 0))) wrong("does not go with its wall, " u " " v)
          if (kind == 1 && (off($4, r) > 1e-7 || off($7, 0) > 1e-4)) wrong("does not rest") }
        END { if (n[0] != 30 || n[1] != 30 || n[2] != 30) { print NR " spheres"; bad = 1 } exit bad }' $s.$way.$ranks > wrong ||
        { head -n 5 wrong; die "$s, $way, $ranks ranks"; }
      most="$most $(apart $s.$way.1 $s.$way.$ranks)"
    done
  done
  engine 1 $s.before.in
  last $s.before.at > $s.before
  restart=$(apart $s.whole.1 $s.again.1) order=$(apart $s.whole.1 $s.before)
  echo "$s: ranks change numbers by$most, a restart by $restart, the order of fixes by $order"
  awk -v most="$most" -v restart="$restart" -v order="$order" 'BEGIN { n = split(most, m, " "); for (k = 1; k <= n; k++) if (m[k] > 1e-6) exit 1; exit n < 9 || restart > 1e-3 || order > 0.02 }' || die "$s"
done
