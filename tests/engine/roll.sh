#!/usr/bin/env bash
# Grains that stay on a wall roll, slide and ride as closed forms have it, whatever the law, the step and the kind of wall,
# and write no rows: on slopes less and more steep than tan a = 3.5 mu, with speeds and spins of their own, on belts, on
# walls that move away with them. A grain that bounces under gravity rises as high after 1000 bounces as at first.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
stl <<< "-0.5 -0.1 0  1.5 -0.1 0  1.5 0.1 0  -0.5 0.1 0" > floor.stl
down() { awk -v a="$1" 'BEGIN { a *= atan2(0, -1) / 180; printf "%.17g 0 %.17g", sin(a), -cos(a) }'; }
wall() { # KIND LAW
  local end="rebound $2 deposit off ledger 1000 file roll.csv"
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
scene() { # KIND DEGREES STEP LAW MU
  local up=0 steps=$(awk -v dt="$3" 'BEGIN { printf "%d", 0.1 / dt }')
  [ "$1" != lift ] || up=5
  soft "-0.5 1.5 -0.1 0.1 -0.02 2" "$5" 0.5 | sed "s/^neighbor .*/neighbor 0.02 bin/; $([ "$5" != 0 ] || echo '/coefficientFriction/d; s/tangential history/tangential off/')"
  echo "fix m5 all property/global yieldStress peratomtype 1e5"
  put << END
1 0 -0.05 0.004 0 0 $up
2 0 0 0.004 0.2 0 $up
3 0 0.05 0.004 0 0 $up
END
  if [ $simulator = lammps ]; then echo "set atom 3 omega 0 50 0"; else echo "set atom 3 omegay 50"; fi
  echo "neigh_modify exclude group all all
fix fall all gravity 9.81 vector $(down "$2")
$(wall "$1" "$4")
fix move all nve/sphere
timestep $3
thermo 1000000
thermo_style custom step f_wall[6]
$(pictures "$steps" "roll:$1:$2:$3:${4%% *}:$5" "x z vx vz omegay")
run $steps
clear"
}
kinds="plane mesh belt lift"
[ $simulator = liggghts ] || kinds="$kinds region"
step() { mul "$1" $rayleigh; } # a share of the Rayleigh time
for kind in $kinds; do
  for slope in 0 20 60; do
    for share in $([ $simulator = lammps ] && [ $kind != region ] || echo 0.001) 0.2; do scene $kind $slope $(step $share) "walton 0.5 0.3 0" 0.3; done
  done
done > all.in
for kind in plane mesh; do # what no law has a word on is the script's
  scene $kind 30 1e-4 "constant 0.5 0.9" 0.3
  scene $kind 30 1e-4 "constant 0.5 1" 0
  scene $kind 30 1e-4 bons 0.2
done >> all.in
engine 1 all.in
[ "$(count_rows roll.csv)" = 0 ] || die "rows of grains that stay"
cat > closed.py << 'END'
import glob
def go(t, v, s, belt, slope, mu): # x, v and r w along the slope from (0, v, s), relative to a wall with velocity `belt`
    g, n, x, v = 9.81 * sin(slope), 9.81 * cos(slope), belt * t, v - belt
    while t > 1e-12:
        u = v - s
        sign = copysign(1, u) if abs(u) > 1e-12 else 1 if g > 3.5 * mu * n else 0
        if not sign: # it rolls
            x, v = x + v * t + 5 / 14 * g * t * t, v + 5 / 7 * g * t
            s = v
            break
        change, pull = g - 3.5 * mu * n * sign, g - mu * n * sign
        stop = -u / change if u * change < 0 and -u / change < t else t
        x, v, s, t = x + v * stop + pull / 2 * stop ** 2, v + pull * stop, s + 2.5 * mu * n * sign * stop, t - stop
    return x, v + belt, s
names = glob.glob("roll:*")
for name in names:
    kind, slope, dt, law, mu = name.split(":")[1:]
    slope, dt, mu, belt, lift = radians(float(slope)), float(dt), float(mu), 0.3 * (kind in ("belt", "lift")), 5 * (kind == "lift")
    rows = read(name)[-3:]
    for row in rows:
        t = row.step * dt
        x, v, s = go(t, 0.2 * (row.id == 2), 0.2 * (row.id == 3), belt, slope, mu)
        share = 1e-6 if law != "walton" and row.id == 1 else 1e-3 * (1 + 2 * dt / 4.896e-4)
        assert near(row.vx, v, share, 0.05) and near(row.omegay * 0.004, s, share, 0.05) and near(row.x, x, 2 * share, 0.005), (name, row, x, v, s)
        assert near(row.vz, lift, 1e-12, 1) and near(row.z, 0.004 + lift * t, 1e-9), (name, row)
    assert len(rows) == 3, name
assert len(names) == {"liggghts": 30, "lammps": 24}[simulator], len(names)
guarded = [row[1] for row in read("all.in.screen")]
assert len(guarded) >= len(names) and not any(guarded), guarded
END
{ echo "simulator = '$simulator'"; cat closed.py; } > now.py
table < now.py || die "grains that roll"

# Single grains that bounce 1000 times on a mesh, and between walls that gravity is aslant to. The path between bounces is
# exact, so that the energy is the same at every step.
plate 1 1 0.02 > plate.stl
bounces() { # GRAVITY WALLS
  soft "-0.03 0.03 -0.03 0.03 -0.03 0.03" | sed 's/^neighbor .*/neighbor 0.02 bin/'
  printf '1 0.01 0.01 0.0123 0 0 0\n2 0.003 0.008 0.009 0 0 -0.2\n' | put 0.002
  echo "neigh_modify exclude group all all
fix fall all gravity 9.81 vector $1
$2
fix move all nve/sphere
timestep 1e-3
$(pictures 100)
thermo_style custom step f_low
thermo 90000
run 90000"
}
elastic='rebound constant 1 1 deposit off'
plane() { echo "fix $1 all wall/rebound primitive type 1 $2 $elastic"; }
for gravity in "0 0 -1" "0.3 0.1 -1"; do
  walls="fix plate all mesh/surface file plate.stl type 1
fix low all wall/rebound mesh n_meshes 1 meshes plate $elastic"
  [ "$gravity" = "0 0 -1" ] || walls="$(plane low "zplane 0.0"; plane side "xplane 0.015"; plane back "yplane 0.02")"
  bounces "$gravity" "$walls" > bounces.in
  engine 1 bounces.in
  table a=at.txt log=bounces.in.screen "
down = (${gravity// /, })
g = [9.81 * x / hypot(*down) for x in down]
for id in 1, 2:
    energy = [sum(0.5 * v * v - y * x for x, v, y in zip(row[1:4], row[4:7], g)) for row in a if row.id == id]
    assert len(energy) > 900 and max(abs(e - energy[0]) for e in energy) < 1e-9
assert log[-1][1] >= 1800" || die "energy of bouncing grains, gravity $gravity"
done
