#!/usr/bin/env bash
# Loads on a wall: its momentum is the one that the particles lose, to rounding, on a mesh that turns, with particles that
# fall, rebound, roll and stick; the same force and torque in both engines and on any number of ranks; energies, impulses and
# torques are those of the rows; what grains lose that hit and slide dissipates; the force of each grain is its share.
# GRAINS=2500 STEPS=8000 loads.sh makes over 10^5 impacts.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
grains=${GRAINS:-100} steps=${STEPS:-1000}
cube 0.3 | stl > box.stl # that turns, with grains in it
cloud=$(awk -v n="$grains" -v state=4711 'function uniform() { state = (16807 * state) % 2147483647; return 2 * state / 2147483647 - 1 }
  BEGIN { for (i = 1; i <= n; i++) printf "%d %.9g %.9g %.9g %.9g %.9g %.9g\n", i, 0.25 * uniform(), 0.25 * uniform(), 0.25 * uniform(), 3 * uniform(), 3 * uniform(), 3 * uniform() }')
scene() { # LAW LEDGER
  soft "-0.6 0.6 -0.6 0.6 -0.6 0.6" | sed 's/^neigh_modify .*/neigh_modify delay 0 exclude group all all/; s/^neighbor .*/neighbor 0.02 bin/'
  put <<< "$cloud"
  echo "fix m5 all property/global yieldStress peratomtype 1e5
fix m6 all property/global surfaceEnergy peratomtypepair 1 5
fix box all mesh/surface file box.stl type 1
fix turn all move/mesh mesh box rotate origin 0.01 0.0 0.0 axis 0.2 0.3 1. period 1.7
fix wall all wall/rebound mesh n_meshes 1 meshes box surface rq 2e-4 lambda_c 2e-3 $1 erosion dnv density 7800 face tilted torque_about 0.1 0.2 -0.1 ledger 500 file $2 columns full
fix fall all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
timestep 2e-4
$(pictures $steps at.txt "vx vy vz")
thermo_style custom step f_wall[7] f_wall[8] f_wall[9] f_wall[10] f_wall[11] f_wall[12] f_wall[13] f_wall[1] f_wall[14] f_wall[2] f_wall[1][1] f_wall[1][8] f_wall[1][7] f_wall[1][5] f_wall[1][6]
thermo_modify format float %.17g
thermo 1
run $steps"
}
cat > common.py << END
m, n, steps, dt = 2500 * 4 * pi / 3 * 64e-9, $grains, $steps, 2e-4
def given(log, k): # force or torque times time
    return [fsum(row[i] * dt for row in log[1:]) for i in range(k, k + 3)]
END
for law in walton bons; do
  case $law in walton) words="rebound walton 0.9 0.3 0.2 deposit off" ;; bons) words="rebound bons" ;; esac
  scene "$words" \${out} > $law.in
  for run in liggghts.1 liggghts.2 lammps.1; do
    use ${run%.*}
    engine ${run#*.} $law.in -var out $law.$run.csv
    mv $law.in.screen $law.$run.log
    { cat common.py; echo "
lost = [m * fsum(x[k] - y[k] for x, y in zip(at(a, 0), at(a, steps))) - (n * m * 9.81 * steps * dt if k == 3 else 0) for k in (1, 2, 3)]
taken = fsum(abs(row[k]) * dt for row in log[1:] for k in (1, 2, 3))
assert all(abs(x - y) < 1e-13 * taken for x, y in zip(given(log, 1), lost)), (given(log, 1), lost, taken)
assert log[-1][8] > 0 and ('$law' == 'walton' or log[-1][10] > 0)
for row in log: # of the whole wall, and of its mesh
    assert row[8] == row[11] and row[9] == row[12] and near(row[7], row[13], 1e-12)
for row, first in zip(log[:500], first):
    scale = hypot(*row[3:5], 1)
    assert all(abs(x - y) <= 1e-8 * hypot(x, scale if k < 6 else 0) for k, (x, y) in enumerate(zip(row[1:10], first[1:10]))), (row, first)"; } > now.py
    table a=at.txt log=$law.$run.log first=$law.liggghts.1.log < now.py || die "loads: $law, $run"
  done
done
same walton.liggghts.1.csv walton.liggghts.2.csv "full rows on two ranks"
"$bin/asperity" compare walton.liggghts.1.csv -o compared > compare.out 2>&1 || die "compare does not read a full ledger: $(cat compare.out)"

# The dissipated energy, the impulses and the torque are those of the rows. Where grains only hit, they are all.
use liggghts
scene "rebound walton 0.9 0.3 0.2 deposit off" free.csv | sed '/^fix fall/d' > free.in
engine 2 free.in
{ cat common.py; cat << 'END'; } > now.py
energy = normal = along = worn = 0
torque, size = [0, 0, 0], 0
for r in rows:
    v1, v2, w1, w2, p, n = (tuple(r[name + x] for x in "xyz") for name in ("v1", "v2", "omega1", "omega2", "impulse_", "n"))
    square = lambda v: sum(x * x for x in v)
    inertia = r.mass * r.d_p ** 2 / 10
    energy += 0.5 * r.mass * (square(v1) - square(v2)) + 0.5 * inertia * (square(w1) - square(w2))
    assert all(abs(x - r.mass * (a - b)) < 1e-8 for x, a, b in zip(p, v1, v2)), r
    j = -sum(x * y for x, y in zip(p, n))
    normal, along, worn = normal + j, along + hypot(*(x + j * y for x, y in zip(p, n))), worn + r.eroded_mass
    x, y, z = r.x - 0.1, r.y - 0.2, r.z + 0.1
    for k, value in enumerate((y * p[2] - z * p[1], z * p[0] - x * p[2], x * p[1] - y * p[0])):
        torque[k] += value + inertia * (w1[k] - w2[k])
    size += hypot(*p)
end = log[-1]
assert end[8] == len(rows) > 0
for is_, want in (end[7], energy), (end[14], normal), (end[15], along), (end[9], worn):
    assert want > 0 and near(is_, want, 1e-8), (is_, want)
assert all(abs(x - y) < 1e-9 * size and x for x, y in zip(given(log, 4), torque)), (given(log, 4), torque)
END
table rows=free.csv log=free.in.screen < now.py || die "energies, impulses or torques of the rows"

# Grains that slide until they roll: what they lose is what dissipates; the force of each is its share of the wall's, and acts
# where the grain touches. A third one flies.
for engine in liggghts lammps; do
  use $engine
  { soft "-0.1 0.9 -0.1 0.1 -0.001 0.05" 0.3 0.5 | sed 's/^neigh_modify .*/neigh_modify delay 0 exclude group all all/'
    printf '1 0 0 0.004 1 0.2 0\n2 0 0.05 0.006 0.8 -0.3 -0.5\n' | put
    echo "fix wall all wall/rebound primitive type 1 zplane 0.0 rebound walton 0.5 0.3 0 deposit off
fix move all nve/sphere
region above block -1 1 -1 1 0.02 1 units box
create_atoms 1 single 0 0.08 0.04 units box
set region above diameter 0.008 density 2500
fix fall all gravity 9.81 vector 0 0 -1
compute spin all erotate/sphere
compute z all reduce sum z
compute force all reduce sum f_wall[3] f_wall[4] f_wall[5]
thermo_style custom step ke c_spin c_z f_wall[13] c_force[1] c_force[2] c_force[3] f_wall[7] f_wall[8] f_wall[9]
thermo_modify format float %.17g norm no
thermo 1
timestep 2e-4
$(pictures 800 at.txt "x y z f_wall[5] f_wall[6] f_wall[7] f_wall[8]")
run 400
thermo 50
run 400"; } > slide.in
  engine 2 slide.in
  { cat common.py; cat << 'END'; } > now.py
first = None
for row in log:
    e = row[1] + row[2] + m * 9.81 * row[3] + row[4]
    first = first or e
    assert abs(e - first) < 5e-4 * first, row
    assert all(near(x, y, 1e-12) for x, y in zip(row[5:8], row[8:11])), row
assert log[-1][4] > 0.3 * first and sum(row[5] != 0 for row in log) > 100 and sum(row[7] != 0 for row in log) > 300
for row in at(a, 800):
    force, x, y, z = row[4:8]
    assert row.id == 3 and not (force or x or z) or row.id < 3 and near(force, -9.81 * m, 1e-6) and dist((x, y, z), (row.x, row.y, 0)) < 1e-5, row
END
  table log=slide.in.screen a=at.txt < now.py || die "$engine: what grains lose that slide, or their shares of the force"
done
