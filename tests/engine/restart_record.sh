#!/usr/bin/env bash
# What a wall continues from a restart file: of each mesh what it took itself, whatever the order and number of
# meshes now; nothing of another geometry; and nothing of bytes that are damaged.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
bouncing 200 > grains.data
plate 4 1 3.9e-3 > plate.stl
plate 2 1 3.9e-3 > coarse.stl

# script BEGINNING WALL STEPS [REST] > FILE: a run, and at its end the impacts of the wall and of the meshes.
meshes='fix lo all mesh/surface file plate.stl type 2
fix hi all mesh/surface file plate.stl type 2 move 0 0 3.8e-4
fix new all mesh/surface file coarse.stl type 2 move 0 0 4.5e-4'
plane='primitive type 2 zplane 0.0'
script() {
  head_of si; echo "$1
neighbor 1e-4 bin
neigh_modify delay 0 exclude group all all"; materials; echo "${4:-$meshes}
fix w all wall/rebound $2 rebound constant 1 1 deposit off
fix move all nve/sphere
timestep 2e-8
variable one equal f_w[1][1]
variable two equal \"f_w[${5:-1}][1]\"
thermo_style custom step f_w v_one v_two
thermo_modify lost ignore format float %.12g
thermo 10000
${6:-}
run $3"
}
# last SCRIPT: all impacts, and those of the first and the second mesh.
last() { grep -E '^ +[0-9]+ +[0-9]+ +[0-9]+ +[0-9]+ *$' "$1.screen" | tail -n 1 | awk '{ print $2, $3, $4 }'; }
says() { grep -aE "WARNING.*id w\): $1" "$2.screen" | grep -qF -- "$3" || { grep -a WARNING "$2.screen"; die "no warning '$1 $3' in $2"; }; }
silent() { ! grep -aE "WARNING.*id w\): (not continued|the script differs)" "$1.screen" || die "a warning of what did not change"; }
both='mesh n_meshes 2 meshes lo hi'
{ script 'read_data grains.data' "$both" 1000 "$meshes" 2; echo 'write_restart both.restart'; } > both.in
{ script 'read_data grains.data' "$plane" 1000; echo 'write_restart plane.restart'; } > plane.in
engine 2 both.in; engine 2 plane.in
read -r all lo hi <<< "$(last both.in)"
[ "$lo" -gt 50 ] && [ "$hi" != "$lo" ] && [ "$all" = $((lo + hi)) ] || die "impacts: $all, $lo and $hi"
read -r on_plane _ _ <<< "$(last plane.in)"
[ "$on_plane" -gt 50 ] || die "$on_plane impacts on the plane"

# continued NAME RESTART WALL EXPECTED [MESHES [ROW]]: the impacts after the restart, before another step.
continued() {
  script "read_restart $2" "$3" 0 "${5:-$meshes}" "${6:-1}" > "$1.in"
  engine 2 "$1.in"
  [ "$(last "$1.in")" = "$4" ] || die "$1: $(last "$1.in"), and it must be $4"
}
vtk='dump first all mesh/vtk 1 first.vtk output face'
map_sum() { awk '/^impacts 1/ { on = 1; next } /[a-z]/ { on = 0 } on { for (i = 1; i <= NF; i++) sum += $i } END { print sum + 0 }' "$1"; }

continued same both.restart "$both" "$all $lo $hi" "$meshes" 2
silent same.in
script 'read_restart both.restart' 'mesh n_meshes 2 meshes hi lo' 0 "$meshes" 2 "$vtk hi id impacts
dump second all mesh/vtk 1 second.vtk output face lo id impacts" > swapped.in
engine 2 swapped.in
[ "$(last swapped.in)" = "$all $hi $lo" ] || die "swapped: $(last swapped.in), and it must be $all $hi $lo"
[ "$(map_sum first.vtk) $(map_sum second.vtk)" = "$hi $lo" ] || die "maps: $(map_sum first.vtk) $(map_sum second.vtk), and they must be $hi $lo"
says 'the script differs' swapped.in 'geometry mesh hi lo, was mesh lo hi'
! grep -a 'not continued' swapped.in.screen || die "swapped meshes are continued"
continued fewer both.restart 'mesh n_meshes 1 meshes hi' "$all $hi $hi"
says 'not continued' fewer.in "the $lo impacts of mesh 'lo', which is not one of this wall"
continued more both.restart 'mesh n_meshes 3 meshes new lo hi' "$all 0 $lo" "$meshes" 2
says 'the script differs' more.in 'geometry mesh new lo hi, was mesh lo hi'
continued coarse both.restart "$both" "$all 0 $hi" "fix lo all mesh/surface/stress file coarse.stl type 2
fix hi all mesh/surface file plate.stl type 2 move 0 0 3.8e-4" 2
says 'not continued' coarse.in "the $lo impacts of mesh 'lo', which had 32 triangles and has 8"
continued mesh plane.restart 'mesh n_meshes 1 meshes lo' "$on_plane 0 0"
says 'not continued' mesh.in "the $on_plane impacts of the primitive wall"
says 'the script differs' mesh.in 'geometry mesh lo, was primitive type 2 zplane 0'
continued plane both.restart "$plane" "$all 0 0"
says 'not continued' plane.in "the $lo impacts of mesh 'lo', which is not one of this wall; the $hi impacts of mesh 'hi'"
continued moved plane.restart 'primitive type 2 zplane 1e-9' "$on_plane $on_plane $on_plane"
says 'the script differs' moved.in 'zplane 1e-09, was primitive type 2 zplane 0'

# A restart file that is written before the first step has what the one before had.
{ sed '/^run 0/d' same.in; echo 'write_restart again.restart'; } > rewrite.in
engine 2 rewrite.in
continued again again.restart "$both" "$all $lo $hi" "$meshes" 2
sed "s|^run 0|$vtk lo id impacts\nrun 0|" again.in > again_map.in
engine 2 again_map.in
[ "$(map_sum first.vtk)" = "$lo" ] || die "the map of a file that is written at once: $(map_sum first.vtk), and it must be $lo"

# What is stuck to a mesh stays with it where its number is another: one that moves takes it along.
stuck() { # BEGINNING MESHES STEPS
  script "$1" "mesh n_meshes 2 meshes $2" "$3" "$meshes
fix drive all move/mesh mesh hi linear 10. 0. 0." |
    sed 's/^fix w.*/fix w all wall\/rebound mesh n_meshes 2 meshes '"$2"' rebound bons deposit freeze/'
  echo "dump end all custom 1 end.txt id x vx f_rebound_w[2] z
dump_modify end sort id format \"%d %.10g %.10g %.0f %.10g\"
run 0"
}
stuck 'read_data grains.data' 'lo hi' 1000 | sed 's/^run 0/run 0\nwrite_restart stuck.restart/' > stuck.in
sed -i 's/ 0.8 0.8 0.8 0.8/ 5000 5000 5000 5000/' stuck.in
on() { awk 'NF == 5 && $4 == 1 { $5 = 1 + ($5 > 1.9e-4); print }' end.txt | sort -n; } # and the number of the mesh
engine 2 stuck.in; on > before
stuck 'read_restart stuck.restart' 'hi lo' 1000 | sed 's/ 0.8 0.8 0.8 0.8/ 5000 5000 5000 5000/' > turned.in
engine 2 turned.in; on > after
[ "$(awk '$5 == 1' before | wc -l)" -gt 20 ] && [ "$(awk '$5 == 2' before | wc -l)" -gt 20 ] || die "too little is stuck"
join before after | awk '{ moved = $6 - $2; bad += ($5 == 1 && !(moved == 0 && $9 == 1)) || ($5 == 2 && !(moved > 1.9e-4 && moved < 2.1e-4 && $9 == 2)) } END { exit bad || !NR }' ||
  { join before after | head -n 5; die "what is stuck is on another mesh"; }

# Damaged: a byte in any part of the record; and a file that is cut within it, which LIGGGHTS itself refuses.
at=$(grep -abo asp-wall both.restart | cut -d: -f1)
length=$(od -An -tu4 -j $((at - 4)) -N 4 both.restart | tr -d ' ')
[ "$length" -gt 500 ] || die "the record has $length bytes"
sed 's/both.restart/bad.restart/' same.in > bad.in
bad() { # WHAT
  if timeout 60 "$program" -in bad.in -log none > bad.screen 2>&1; then die "$1: taken"; fi
  grep -a 'ERROR.*id w' bad.screen | grep -qE "the restart file's record of this wall .*damaged" || { tail -n 3 bad.screen; die "$1: no message"; }
}
for part in 0 8 12 16 24 28 32 60 $((length / 3)) $((length / 2)) $((length - 1)); do
  perl -0777 -pe "substr(\$_, $((at + part)), 1) ^= 'A'" both.restart > bad.restart
  [ "$(cmp -l both.restart bad.restart | wc -l)" = 1 ] || die "this test flips no byte"
  bad "byte $part of $length"
done
head -c $((at + length / 2)) both.restart > bad.restart
if timeout 60 "$program" -in bad.in -log none > bad.screen 2>&1; then die "a file that is cut was taken"; fi
grep -aq ERROR bad.screen || die "a file that is cut: no message"
