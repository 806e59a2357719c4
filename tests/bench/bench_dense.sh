#!/usr/bin/env bash
# Dense scenes: grains that lie on walls, with this wall over the engine's own wall/gran of equal friction. A bed of
# 2160 grains in a box (planes; 5600 and 89 600 triangles), a drum, a hopper, a shaken box. Each settles on wall/gran
# into a restart file, from which both walls go on. User CPU without the set-up (a run of no steps), the shortest of
# ten rounds (ROUNDS) in pairs and their spread, and, where valgrind is, the instructions of the first tenth of the
# steps; where perf is, what takes the time. LAMMPS has no wall/gran for triangles: planes or a region of the same shape
# stand for it.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "${BASH_SOURCE[0]}")/engine.sh"
source "$home/tests/engine/scenes.sh"
meshes
for cells in 20 80; do # a box of 0.1 x 0.1 x 0.15, open above: 14 cells^2 triangles
  awk -v n=$cells 'function side(ox, oy, oz, ux, uy, vx, vy, vz, m,   i, j) { for (i = 0; i < n; i++) for (j = 0; j < m; j++) {
      corner(ox, oy, oz, ux, uy, vx, vy, vz, i, j); corner(ox, oy, oz, ux, uy, vx, vy, vz, i + 1, j)
      corner(ox, oy, oz, ux, uy, vx, vy, vz, i + 1, j + 1); corner(ox, oy, oz, ux, uy, vx, vy, vz, i, j + 1); print "" } }
    function corner(ox, oy, oz, ux, uy, vx, vy, vz, i, j) { i *= 0.1 / n; j *= 0.1 / n; printf "%.9g %.9g %.9g ", ox + i * ux + j * vx, oy + i * uy + j * vy, oz + j * vz }
    BEGIN { r = 0.05; side(-r, -r, 0, 1, 0, 0, 1, 0, n); side(-r, -r, 0, 1, 0, 0, 0, 1, 1.5 * n); side(-r, r, 0, 1, 0, 0, 0, 1, 1.5 * n)
      side(-r, -r, 0, 0, 1, 0, 0, 1, 1.5 * n); side(r, -r, 0, 0, 1, 0, 0, 1, 1.5 * n) }' | stl > bed$((14 * cells * cells)).stl
done

law='rebound walton 0.5 0.5 0 deposit off'
gran='hertz/material 5e6 0.5 0.3 tangential mindlin NULL 1.0 0.5 damping tsuji' # as `soft` in LAMMPS's words
# shape_WALL: the geometry in LAMMPS's words; its motion is that of the mesh.
shape_drum='variable turn equal 2*PI*step*dt/0.6
region wall cylinder y 0 0 0.04 -0.015 0.015 units box rotate v_turn 0 0 0 0 1 0'
shape_hopper='region funnel cone z 0 0 0.015 0.04 0 0.0091 units box open 1 open 2
region above cylinder z 0 0 0.04 0.0091 0.15 units box open 1
region wall union 2 funnel above'
shape_shake='variable up equal 0.001*sin(2*PI*step*dt/0.05)
region wall block -0.025 0.025 -0.025 0.025 0 0.2 units box move NULL NULL v_up'
move_drum='fix turn all move/mesh mesh wall rotate origin 0. 0. 0. axis 0. 1. 0. period 0.6'
move_shake='fix shake all move/mesh mesh wall wiggle amplitude 0. 0. 0.001 period 0.05'
file_drum=drum file_hopper=hopper file_shake=box

walls() { # ENGINE SCENE KIND SHAPE: the fixes
  local side n=0 move=move_$2 file=file_$2 shape=shape_$2
  case $4 in
    planes)
      for side in 'zplane 0.0' 'xplane -0.05' 'xplane 0.05' 'yplane -0.05' 'yplane 0.05'; do
        [ $3 = gran ] && echo "fix side$((++n)) all wall/gran model hertz tangential history primitive type 1 $side" ||
          echo "fix side$((++n)) all wall/rebound primitive type 1 $side $law"
      done ;;
    region)
      echo "${!shape}"
      [ $3 = gran ] && echo "fix wall all wall/gran/region granular $gran region wall" || echo "fix wall all wall/rebound region wall $law" ;;
    *)
      printf 'fix wall all mesh/surface file %s.stl type 1\n%s\n' "$([ $4 = mesh ] && echo ${!file} || echo bed$4)" "${!move:-}"
      [ $3 = gran ] && echo "fix meet all wall/gran model hertz tangential history mesh n_meshes 1 meshes wall" ||
        echo "fix meet all wall/rebound mesh n_meshes 1 meshes wall $law" ;;
  esac
}

grains_bed() { stack 12 12 15 0.0083 0.05; }
grains_drum() { stack 10 6 3 0.0046 0.1 | awk '{ $4 -= 0.018; print }'; }
grains_hopper() { stack 11 11 5 0.0046 0.1 | awk '$2 * $2 + $3 * $3 < 6.4e-4 { $1 = ++n; $4 += 0.013; print }'; }
grains_shake() { stack 5 5 5 0.0085 0.3 | awk '{ $4 += 0.002; print }'; }
declare -A diameter=([bed]=0.008 [drum]=0.004 [hopper]=0.004 [shake]=0.008) step=([bed]=4e-5 [drum]=2.5e-5 [hopper]=2e-5 [shake]=4e-5)
declare -A settling=([bed]=6000 [drum]=8000 [hopper]=6000 [shake]=4000) steps=([bed]=800 [drum]=12000 [hopper]=6000 [shake]=16000)

scene() { # ENGINE SCENE KIND SHAPE STEPS [settle]: a script in the engine's language
  local settle=${6:-} from="/^region box/d; s/^create_box.*/read_restart $1.$2.settled/"
  { soft "-0.06 0.06 -0.06 0.06 -0.6 0.25" 0.5 0.5 | if [ "$settle" ]; then cat; else sed "$from"; fi
    [ -z "$settle" ] || grains_$2 | put ${diameter[$2]}
    echo "fix fall all gravity 9.81 vector 0 0 -1"
    walls $1 $2 $3 $4
    [ "$settle$2" != settlehopper ] || echo "fix plug all wall/gran model hertz tangential history primitive type 1 zplane 0.0"
    printf '%s\n' "fix move all nve/sphere" "timestep ${step[$2]}" "thermo 100000" "thermo_modify lost ignore norm no" "run $5"
    [ -z "$settle" ] || echo "write_restart $1.$2.settled"
  } | if [ $1 = lammps ]; then awk -v into=constants -f "$home/tests/engine/to_lammps.awk"; else cat; fi
}

compared=() # ENGINE SCENE SHAPE, that of wall/gran, what, and what is wanted
for which in liggghts lammps; do
  [ -x "$bin/$which-asperity" ] || continue
  own=$([ $which = liggghts ] && echo mesh || echo region)
  compared+=("$which bed planes planes 1.2")
  for cells in 20 80; do
    n=$((14 * cells * cells))
    compared+=("$which bed $n $([ $which = liggghts ] && echo $n || echo planes) $([ $which = liggghts ] && echo 1.2 || { [ $n = 5600 ] && echo 1.5 || echo 2; })")
  done
  compared+=("$which drum $own $own $([ $which = liggghts ] && echo 1.5 || echo 1.3)" "$which hopper $own $own 1.3" "$which shake $own $own 1.2")
done

run_of() { "$bin/$1-asperity" -in "$2" -log none < /dev/null > "$2.screen" 2>&1 || { tail -n 5 "$2.screen" >&3; exit 1; }; }
exec 3>&2 # what fails while it is timed
for line in "${compared[@]}"; do
  read -r which scene shape other wanted <<< "$line"
  if [ ! -f $which.$scene.settled ]; then
    scene $which $scene gran $([ $scene = bed ] && echo planes || echo $other) ${settling[$scene]} settle > settle.in
    run_of $which settle.in
  fi
  scene $which $scene gran $other ${steps[$scene]} > $which.$scene.gran.$other.in
  scene $which $scene rebound $shape ${steps[$scene]} > $which.$scene.rebound.$shape.in
done

TIMEFORMAT=%U
for script in *.*.*.*.in; do sed 's/^run .*/run 0/' $script > $script.0; done
for ((round = 1; round <= ${ROUNDS:-10}; round++)); do
  for line in "${compared[@]}"; do
    read -r which scene shape other wanted <<< "$line"
    for script in $which.$scene.{rebound.$shape,gran.$other}.in; do
      { time run_of $which $script; } 2>> $which.$scene.$shape.${script#*.*.}.user
      { time run_of $which $script.0; } 2>> $script.0.user
    done
  done
done
instructions() { # of a tenth of the steps, in the loop
  awk '/^run/ { $2 = int($2 / 10) } { print }' "$1" > count.in
  valgrind --tool=callgrind --callgrind-out-file=counts --toggle-collect='LAMMPS_NS::Verlet::run(int)' \
    "$bin/${1%%.*}-asperity" -in count.in -log none < /dev/null > count.screen 2>&1 || { tail -n 5 count.screen >&2; exit 1; }
  awk '/Collected/ { print $NF }' count.screen
}
shares() { # of the time of a script's run, in %
  perf record -e cpu-clock -F 5000 -o perf.data "$bin/${1%%.*}-asperity" -in "$1" -log none < /dev/null > perf.screen 2>&1 || return 0
  perf report -i perf.data --stdio --no-children -F overhead,sym 2> /dev/null | awk '
    /tree_clear|tree_meet|sweep_|triangle_find|nearest_point|Shape::(meet|clear|find)|add_feet|Search::|curve|surface_/ { sum["searches"] += $1; next }
    /Motion::|Frame::|find_image|fastest/ { sum["moving walls"] += $1 }
    /end_movers|solve_held|::sweep|add_load/ { sum["end of step"] += $1 }
    /Pair|surfacesIntersect/ { sum["pair forces"] += $1 }
    END { for (what in sum) printf "; %s %.0f %%", what, sum[what] }'
}
cpu() { awk -v set_up="$(least < $2.0.user)" '{ print $1 - set_up }' $1.user > $1.cpu; }
command -v valgrind > /dev/null && for script in *.*.*.*.in; do instructions $script > $script.count; done
for line in "${compared[@]}"; do
  read -r which scene shape other wanted <<< "$line"
  here=$which.$scene.rebound.$shape.in there=$which.$scene.gran.$other.in
  pair=$which.$scene.$shape counted='' shares=''
  cpu $pair.rebound.$shape.in $here
  cpu $pair.gran.$other.in $there
  [ ! -f $here.count ] || counted="; instructions $(calc "int(100 * $(cat $here.count) / $(cat $there.count) + 0.5) / 100") x"
  command -v perf > /dev/null && shares=$(shares $here)
  row "$which, $scene, $shape$([ $shape = $other ] || echo " over $other"): wall/rebound over wall/gran" \
    "$(calc "$(least < $pair.rebound.$shape.in.cpu) / $(least < $pair.gran.$other.in.cpu)")" \
    "x ($(spread $pair.rebound.$shape.in.cpu $pair.gran.$other.in.cpu)$counted$shares)" "<=" $wanted
done
