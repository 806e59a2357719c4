#!/usr/bin/env bash
# Regions of LAMMPS as walls: where a wall can be said in another way too, as a plane, a cylinder or a mesh, the same
# impacts; in closed rooms of every style nobody is lost, however long the step is; rooms that move and turn, and what
# sticks to them; restarts.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
use lammps
grains 400 > grains.data
plate 1 1 2.9e-3 > plate.stl
physics='type 2 materials quartz hastelloy-x surface rq 10e-6 lambda_c 90e-6 spread weibull isotropic collisions multiple seed 5'

# scene NAME WALL [RUN]: grains that fly, and a wall low.
scene() {
  { boundary='m m m' flying ${data:-grains.data}
    echo "timestep ${dt:-1e-8}
$2
thermo_style custom step f_low f_low[2]
${3:-run 400}"; } > "$1.in"
}
# pair TEXT WALL OTHER [TOLERANCE [KEYWORDS [LEAST]]]: the same impacts by either, at least so many; each third time the
# other flies on two ranks.
pairs=0
pair() {
  scene one "$2 $physics ${5:-} ledger 100 file one.csv"
  scene other "$3 $physics ${5:-} ledger 100 file other.csv"
  engine 1 one.in
  engine $((pairs++ % 3 ? 1 : 2)) other.in
  [ "$(count_rows one.csv)" -ge "${6:-100}" ] || die "$1: only $(count_rows one.csv) impacts"
  near one.csv other.csv 'tag impact time x y z v1 alpha1_deg delta_alpha_deg v2 alpha2_deg outcome' "${4:-1e-9}" || die "$1"
}
plane='fix low all wall/rebound zplane 0'
region() { printf '%s\n' "$@" 'fix low all wall/rebound region r'; }
pair 'a plane' "$plane" "$(region 'region r plane 0 0 0 0 0 1')"
pair 'a block' "$plane" "$(region 'region r block EDGE EDGE EDGE EDGE 0 EDGE units box')"
pair 'a block as an obstacle' "$plane" "$(region 'region r block EDGE EDGE EDGE EDGE INF 0 units box side out')"
pair 'a prism' "$plane" "$(region 'region r prism -9e-3 9e-3 -9e-3 9e-3 0 8e-3 0 0 0 units box')"
pair 'a union' "$plane" "$(region 'region a block EDGE 1e-3 EDGE EDGE 0 EDGE units box' 'region b block 0.5e-3 EDGE EDGE EDGE 0 EDGE units box' 'region r union 2 a b')"
pair 'an intersection' "$plane" "$(region 'region a plane 0 0 0 0 0 1' 'region b plane 0 0 -1e-5 0 0 1' 'region r intersect 2 a b')"
pair 'a cylinder' 'fix low all wall/rebound zcylinder 5e-4 1e-3 1e-3' "$(region 'region r cylinder z 1e-3 1e-3 5e-4 INF INF units box open 1')" 1e-6 'deposit off' 12
pair 'a pipe' 'fix low all wall/rebound xcylinder 1.4e-3 1e-3 1.39e-3' "$(region 'region r cylinder x 1e-3 1.39e-3 1.4e-3 INF INF units box')" 1e-6 'deposit off'

# Plates that move and turn: as a mesh by its formula, as a region by variables. The last one is defined late, when its
# variable is not 0.
moves() { # TEXT, VARIABLES, REGION'S MOTION, MESH'S MOTION [TOLERANCE]
  pair "$1" "$2
region r plane 0 0 ${6:-0} 0 0 1 $3
fix low all wall/rebound region r" "${7:-}
fix low all wall/rebound stl plate.stl move $4" "${5:-1e-6}"
}
moves 'a plate that moves' 'variable z equal 3*time' 'move NULL NULL v_z' 'linear 0 0 3'
moves 'a plate that oscillates' 'variable z equal 2e-6*sin(2*PI*time/2e-6)' 'move NULL NULL v_z' 'wiggle 0 0 2e-6 2e-6' 1e-2
moves 'a plate that turns' 'variable a equal 2000*time' 'rotate v_a 0 0 0 0 1 0' "rotate 0 0 0 0 1 0 $(awk 'BEGIN { printf "%.17g", 2 * atan2(0, -1) / 2000 }')" 1e-4
moves 'a plate that is defined late' 'run 100
variable z equal 3*time' 'move NULL NULL v_z' 'linear 0 0 3' 1e-6 -3e-6 'run 100'

# Stuck particles move along, and a run continued from a restart file has the ledger of an undisturbed one.
turning='variable a equal 0.02*sin(2*PI*step*dt/1e-5)
variable z equal 2e-6*sin(2*PI*step*dt/2e-6)
region r plane 0 0 0 0 0 1 move NULL NULL v_z rotate v_a 0 0 0 0 1 0
fix low all wall/rebound region r'
last=$(pictures 400 end.txt)
whole() { # the step before the restart file
  scene whole "$turning $physics deposit freeze surface_energy 20 ledger 100 file out.csv
$last" "run $1
write_restart half.restart
run $((400 - $1))"
  engine 2 whole.in
}
whole 130
# Between an impact and the step before it, so that the first step afterwards has one.
half=$(rows out.csv | awk -F, '$3 > 1.3e-6 && int($3 / 1e-8) % 2 && !n++ { print int($3 / 1e-8) }')
whole "$half"
mv out.csv whole.csv; mv end.txt whole.end
# On the plate: at a radius above it, and with the speed of the point below.
table a=whole.end rows=whole.csv 'radius = {row.tag: row.d_p / 2 for row in rows if row.outcome == 1 and row.time < 3.9e-6}
assert len(radius) > 20
t = 400e-8
a_t, z, w, up = 0.02 * sin(2e5 * pi * t), 2e-6 * sin(1e6 * pi * t), 0.02 * 2e5 * pi * cos(2e5 * pi * t), 2 * pi * cos(1e6 * pi * t)
for row in at(a, 400):
    if row.id in radius:
        vx, vz = w * (row.z - z), up - w * row.x
        assert abs(row.x * sin(a_t) + (row.z - z) * cos(a_t) - radius[row.id]) < 1e-11, row
        assert dist(row[4:7], (vx, 0, vz)) < 1e-3 * (1 + hypot(vx, vz)) and abs(row.vy) < 1e-10, (row, vx, vz)' || die "what sticks is not on its plate"
data=half.restart scene rest "$turning $physics deposit freeze surface_energy 20 ledger 100 file out.csv
$last" "run $((400 - half))"
for ranks in 1 2; do
  whole "$half"
  engine $ranks rest.in
  same whole.csv out.csv "a moving region, restarted on $ranks ranks"
  same <(tail -n 400 whole.end) <(tail -n 400 end.txt) "places, restarted on $ranks ranks"
done
# Each run predicts anew for how many steps a particle is clear of a region: runs of one step have the impacts of one
# run. With parts that are hidden, hollow, obstacles, that move and turn, and some that a particle meets from outside.
anew() { # NAME, REGIONS, LEAST
  scene one "$2
fix low all wall/rebound region r $physics deposit off ledger 100 file one.csv" 'run 300'
  sed 's/^run 300/run 300 every 1 NULL/; s/one\.csv/other.csv/' one.in > other.in
  engine 1 one.in
  engine 1 other.in
  [ "$(count_rows one.csv)" -ge "$3" ] || die "$1: only $(count_rows one.csv) impacts"
  same <(rows one.csv) <(rows other.csv) "$1 in runs of one step"
}
dt=2e-8
anew 'a union' 'region a cylinder z 1e-3 1e-3 6e-4 -1e-3 2e-5 units box
region b block EDGE EDGE EDGE EDGE 0 EDGE units box
region r union 2 a b' 100
anew 'an obstacle that moves and turns' 'variable a equal 3000*time
variable z equal 2e-6*sin(2*PI*time/2e-6)
region a sphere 1e-3 1e-3 -2e-4 4e-4 side out units box move NULL NULL v_z
region b block 2e-4 18e-4 2e-4 18e-4 INF 0 side out units box rotate v_a 1e-3 1e-3 0 0 0 1
region r intersect 2 a b' 100
dt=
# Closed rooms, a mirror as the wall, steps of half a diameter to fifty: all stay in, at their speed.
room() { # NAME STEPS REGIONS: the last region is r; `stay` counts who is in it
  { head_of si
    echo "region box block -1.1e-3 1.1e-3 -1.1e-3 1.1e-3 -1.1e-3 1.1e-3 units box
create_box 2 box
$3
create_atoms 1 random 200 4712 r units box
set group all diameter 2e-5 density 2650
variable vx atom random(-60,60,11)
variable vy atom random(-60,60,12)
variable vz atom random(-60,60,13)
velocity all set v_vx v_vy v_vz
neighbor 3e-5 bin
neigh_modify delay 0 exclude group all all
fix move all nve/sphere
fix low all wall/rebound region r type 2 rebound constant 1 1 deposit off
variable stay equal count(all,r)
thermo_style custom step f_low v_stay ke
thermo_modify format float %.12g
thermo 1000000"
    for timestep in 2e-7 1e-6 2e-5; do echo "timestep $timestep
run $2"; done; } > "$1.in"
  engine 2 "$1.in"
  table a="$1.in.screen" 'assert a[-1][1] >= 2000 and all(row[2] == 200 and near(row[3], a[0][3], 1e-9) for row in a)' || die "$1"
}
room block 120 'region r block -1e-3 1e-3 -8e-4 8e-4 -1e-3 9e-4 units box'
room cylinder 120 'region r cylinder z 0 0 1e-3 -1e-3 1e-3 units box'
room cone 120 'region r cone z 0 0 2e-4 1e-3 -1e-3 1e-3 units box'
room prism 120 'region r prism -5e-4 5e-4 -5e-4 5e-4 -1e-3 1e-3 3e-4 2e-4 1e-4 units box'
room sphere 120 'region r sphere 0 0 0 1e-3 units box'
room intersection 100 'region a sphere 0 0 0 1e-3 units box
region b cylinder x 0 0 2e-4 INF INF side out units box
region r intersect 2 a b'
room hopper 100 'region a cone z 0 0 2e-4 1e-3 -2e-4 1e-3 units box
region b cylinder z 0 0 2e-4 -1e-3 -2e-4 units box
region r union 2 a b'

# A room that only moves, whose angle LAMMPS leaves unset: with new memory full of any bits.
{ head_of si
  echo "region box block -0.1 0.1 -0.1 0.1 -0.1 0.1 units box
create_box 2 box
region fill block -0.02 0.02 -0.02 0.02 0.01 0.1 units box
create_atoms 1 random 100 4711 fill
set group all diameter 1e-3 density 2500
neighbor 2e-3 bin
neigh_modify delay 0 exclude group all all
fix fall all gravity 9.81 vector 0 0 -1
variable up equal 0.001*sin(2*PI*step*dt/0.05)
region r block -0.025 0.025 -0.025 0.025 0 0.12 units box move NULL NULL v_up
fix wall all wall/rebound region r rebound walton 0.5 0.5 0 deposit off
fix move all nve/sphere
timestep 4e-5
thermo_style custom step atoms f_wall
run 4000"; } > moving.in
for bits in 1 165; do
  MALLOC_PERTURB_=$bits engine 1 moving.in
  table a=moving.in.screen 'assert a[-1][1] == 100 and a[-1][2] > 100' || die "a room that moves, with memory of $bits"
done

# A room that turns round every second step, by more than the grains' size, keeps them; one whose variables depend on
# step*dt stands elsewhere after the command timestep, which gives a warning; no wall may turn by 115 degrees in a step.
shaken() { # LINES MOTION
  { head_of si
    echo "region box block -0.05 0.05 -0.05 0.05 -0.05 0.05 units box
create_box 2 box
region fill block -0.008 0.008 -0.008 0.008 -0.008 0.008 units box
create_atoms 1 random 60 4711 fill
set group all diameter 1e-3 density 2500
velocity all create 1 4711
neighbor 5e-3 bin
neigh_modify delay 0 exclude group all all
fix move all nve/sphere
variable x equal 0.003*sin(2*PI*step/4)
variable a equal 2*step
region r block -0.01 0.01 -0.01 0.01 -0.01 0.01 units box $2
fix low all wall/rebound region r type 2 rebound constant 0.8 1 deposit off
variable stay equal count(all,r)
thermo_style custom step f_low v_stay
timestep 1e-4
$1"; }
}
shaken 'thermo 100
run 401
timestep 2e-4
run 1' 'move v_x NULL NULL' > shaken.in
engine 1 shaken.in
table a=shaken.in.screen 'assert all(row[2] == 60 for row in a) and a[-1][1] > 1000' || die 'a room that is shaken'
! grep -q 'stands .* from where' shaken.in.screen || die 'a warning of a region that stands where it was'
sed 's,step/4,step*dt/4e-4,; s/401/1/' shaken.in > elsewhere.in
engine 1 elsewhere.in
grep -q 'the region stands 0.003 from where the last step' elsewhere.in.screen || die 'no warning of a region that stands elsewhere'
# A mesh that variables move, too: in one program, and behind a restart.
sed 's,^region r block.*,variable v equal 0,; s,region r type 2,stl plate.stl type 2 move variable v_x NULL NULL v_v NULL NULL,
  s/count(all,r)/count(all)/' elsewhere.in > mesh.in
sed 's/^timestep 2e-4/write_restart mid.bin/' mesh.in > whole.in
sed '/^region box/,/^velocity/d; s/^neighbor/read_restart mid.bin\n&/; s/^timestep 1e-4/timestep 2e-4/' mesh.in > again.in
for one in mesh whole again; do engine 1 $one.in; done
! grep -q 'stands .* from where' whole.in.screen || die 'a warning of a mesh that stands where it was'
for one in mesh again; do
  [ "$(grep -c 'the mesh stands 0.003 from where the last step' $one.in.screen)" = 1 ] || die "no warning of a mesh that stands elsewhere: $one"
done
shaken 'run 1' 'rotate v_a 0 0 0 0 0 1' > turned.in
refuses 1 turned.in "region 'r' turns by 114.6 degrees in a step"
