#!/usr/bin/env bash
# Grains that stick, rest and fly, at meshes at rest, that move, turn, cross a periodic edge, and travel by several
# periods; on any number of ranks; in a run that goes on, and in restarts with the same meshes, with fewer, and with
# another one of the same name. What is stuck goes with its mesh, what rests stays at it, and nothing passes it.
# All scenes of a number of ranks are one script, with `clear` between them. Arguments: numbers of ranks. `matrix.sh
# lammps 1 2 3 4 6 8` with STEPS=200 CELLS=30 is a longer form; beyond, grains leave the plates.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
steps=${STEPS:-100} cells=${CELLS:-6} dt=2e-6
scenes="rest move turn edge periods" ways="same fewer other"

# Two plates, one above the other, that fill a periodic box, or lie within it.
square() { # CELLS HALF: a square plate at z = 0
  awk -v n="$1" -v half="$2" 'function at(k) { return -half + 2 * half * k / n }
    BEGIN { for (i = 0; i < n; i++) for (j = 0; j < n; j++) print at(i), at(j), 0, at(i + 1), at(j), 0, at(i + 1), at(j + 1), 0, at(i), at(j + 1), 0 }' | stl
}
for half in full:2e-3 part:1.2e-3; do # over 1000 triangles: LIGGGHTS shares a mesh of so many among the ranks
  square 24 ${half#*:} > ${half%:*}.fine.stl; square $cells ${half#*:} > ${half%:*}.stl; square $((cells - 2)) ${half#*:} > ${half%:*}.other.stl
done
high=2e-3 r=1e-4
for file in {full,part}{,.other}.stl; do awk -v by=$high '$1 == "vertex" { $4 += by } 1' $file > high.$file; done

# The grains, with what they do and on which plate: 0 the lower one, 1 the upper one.
awk -v high=$high -v r=$r 'function put(what, up, x, y, gap, vz) { printf "%d %.6g %.6g %.6g 0 0 %g %s %d\n", ++n, x, y, up * high + r + gap, vz, what, up }
  BEGIN { for (up = 0; up < 2; up++) for (k = 0; k < 24; k++) {
    x = (k % 6 - 2.5) * 3.1e-4 + 1e-5 * up; y = (int(k / 6) - 1.5) * 4.3e-4
    if (k % 3 == 0) put("sticks", up, x, y, 2e-5 * (k % 5 + 1), -1)
    else if (k % 3 == 1) put("rests", up, x, y, 0, 0)
    else put("flies", up, x, y, 1e-4 + 5e-5 * k, -2.6) } }' > grains.txt
ids() { awk -v what="$1" '$8 ~ what { printf " %d", $1 }' grains.txt; }

# meshes SCENE WAY WHO: the meshes of a wall, and of all their names. A mesh of another style is not continued by LIGGGHTS
# itself, which would put its old triangles in place of the new ones.
meshes() {
  local form=full style=mesh/surface file fine=; case $1 in rest | move | turn) form=part ;; esac
  case "$1 $3" in "turn glue" | "periods glue") fine=.fine ;; esac
  file=$form.stl
  echo "fix low_$3 all mesh/surface/stress file $form$fine.stl type 1"
  [ "$2" != other ] || file=$form.other.stl style=mesh/surface/stress
  [ "$2" = fewer ] || echo "fix high_$3 all $style file high.$file type 1"
  for mesh in low high; do
    [ "$2 $mesh" != "fewer high" ] || continue
    case $1 in
      move) echo "fix drive_${mesh}_$3 all move/mesh mesh ${mesh}_$3 linear 0.3 0.2 0." ;;
      turn) echo "fix drive_${mesh}_$3 all move/mesh mesh ${mesh}_$3 rotate origin 0. 0. 0. axis 0. 0. 1. period 1e-3" ;;
      edge) echo "fix drive_${mesh}_$3 all move/mesh mesh ${mesh}_$3 linear 2. 1. 0." ;;
      periods) echo "fix drive_${mesh}_$3 all move/mesh mesh ${mesh}_$3 linear 20. -12. 0." ;;
    esac
  done
}
wall() { # WAY WHO LAW
  local all="2 meshes low_$2 high_$2"; [ "$1" != fewer ] || all="1 meshes low_$2"
  if [ $simulator = lammps ]; then # a wall for each mesh
    [ "$1" = fewer ] || echo "fix high_$2 $2 wall/rebound mesh n_meshes 1 meshes high_$2 rebound $3"
    all="1 meshes low_$2"
  fi
  echo "fix $2 $2 wall/rebound mesh n_meshes $all rebound $3"
}
scene() { # SCENE WAY: WAY is `on` for the first run, which goes on behind its restart file
  boundary="p p f" soft "-2e-3 2e-3 -2e-3 2e-3 -1e-3 5e-3" |
    if [ "$2" = on ]; then cat; else sed "s/^region .*/read_restart $1.restart/; /^create_box/d"; fi |
    sed 's/^neighbor .*/neighbor 2e-4 bin/; s/^neigh_modify .*/neigh_modify delay 0 exclude group all all/'
  echo "fix m5 all property/global yieldStress peratomtype 1e6
fix m6 all property/global surfaceEnergy peratomtypepair 1 100"
  if [ "$2" = on ]; then
    put 2e-4 < grains.txt
    echo "group glue id$(ids sticks)
group hard id$(ids 'rests|flies')"
  fi
  meshes "$1" "$2" glue; wall "$2" glue "bons deposit freeze"
  meshes "$1" "$2" hard; wall "$2" hard "constant 0.5 0.5 deposit off"
  echo "fix fall all gravity 981. vector 0 0 -1
fix move all nve/sphere
timestep $dt
dump at all custom $steps $1.$2.at id x y z vx vy vz
dump_modify at sort id format \"%d %.17g %.17g %.17g %.17g %.17g %.17g\"
thermo_style custom step f_glue[1] f_glue[2] f_hard[1] f_hard[2]
thermo $steps
run $steps"
  [ "$2" != on ] || echo "write_restart $1.restart
run $steps"
  echo clear
}
for s in $scenes; do for way in on $ways; do scene "$s" "$way"; done; done > all.in

# now FILE: the grains at the end, with what they do: "ID X Y Z VX VY VZ WHAT UP".
now() { awk 'NR == FNR { what[$1] = $8 " " $9; next } /TIMESTEP/ { n = 0 } NF == 7 && $1 ~ /^[0-9]+$/ { line[++n] = $0 " " what[$1] }
  END { for (k = 1; k <= n; k++) print line[k] }' grains.txt "$1"; }
for ranks in "${@:-1}"; do
  engine $ranks all.in
  for s in $scenes; do
    for way in on $ways; do
      now "$s.$way.at" > "$s.$way.$ranks"
      # Of the upper mesh that is gone, or is another one, the stuck remain where they are; without it the others fall.
      # In LAMMPS the upper mesh is a wall of its own: without it the stuck fall, too.
      awk -v lammps=$([ $simulator = lammps ] && echo 1 || echo 0) -v way=$way -v scene=$s -v high=$high -v r=$r -v pi=3.14159265358979 '
        function off(a, b) { return a > b ? a - b : b - a }
        function wrong(what) { print $0 ": " what; bad = 1 }
        BEGIN { vx["move"] = 0.3; vy["move"] = 0.2; vx["edge"] = 2; vy["edge"] = 1; vx["periods"] = 20; vy["periods"] = -12 }
        { up = $9; plate = up * high; lost = up && way == "fewer"; left = up && way == "other"; n[$8]++
          if ($0 ~ /nan|inf/) wrong("no number")
          omega = scene == "turn" ? 2 * pi / 1e-3 : 0
          u = vx[scene] - omega * $3; v = vy[scene] + omega * $2
          if ($8 == "sticks" && !(lost && lammps)) {
            if (off($4, plate + r) > 1e-12) wrong("is not where it stuck")
            if (lost || left) { if (off($5, 0) + off($6, 0) + off($7, 0) > 0) wrong("moves without its mesh") }
            else if (off($5, u) + off($6, v) + off($7, 0) > 1e-8 * (off(u, 0) + off(v, 0))) wrong("does not go with its mesh, " u " " v)
          } else if (lost) { if ($8 != "flies" && !($4 < plate + r - 1e-5)) wrong("does not fall") }
          else if ($8 == "rests" ? off($4, plate + r) > 1e-8 || off($7, 0) > 1e-9 : $4 < plate + r - 1e-12) wrong("is not at its plate") }
        END { if (n["sticks"] != 16 || n["rests"] != 16 || n["flies"] != 16) { print NR " grains"; bad = 1 } exit bad }' "$s.$way.$ranks" > wrong ||
        { head -n 5 wrong; die "$simulator, $s, $way, $ranks ranks"; }
      [ $ranks = 1 ] || same "$s.$way.1" "$s.$way.$ranks" "1 and $ranks ranks"
    done
    same "$s.on.$ranks" "$s.same.$ranks" "a run that goes on and a restart, $s, $ranks ranks"
  done
done

# LIGGGHTS tears a mesh that turns across a periodic edge; the axis may be along the period only.
if [ $simulator = liggghts ]; then
  scene turn on | sed 's/part\.\([a-z.]*\)stl/full.\1stl/' > torn.in
  ! timeout 60 "$program" -in torn.in -log none > torn.screen 2>&1 || die "a mesh that turns across a periodic edge was taken"
  grep -q "ERROR.*mesh 'low_glue' turns and crosses a periodic edge" torn.screen || { tail -n 3 torn.screen; die "no message on a mesh that is torn"; }
fi
