# Shared by the benchmarks of the engine: each sources it, and then works in a folder of its own.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
bin=$ASPERITY_BIN
[ -x "$bin/liggghts-asperity" ] || { echo "the fix in LIGGGHTS: not built"; exit 0; }
home=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
cd "$work"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe # the same of Open MPI 5
export OMPI_MCA_orte_tmpdir_base=$work # as in tests/engine/engine.sh

# row WHAT NUMBER UNIT [<=|>= LIMIT]: a line of the table.
row() { awk -v what="$1" -v value="$2" -v unit="$3" -v sign="${4:-}" -v limit="${5:-}" 'BEGIN {
  wanted = sign == "" ? "-" : sign " " limit
  met = sign == "" ? "-" : (sign == "<=" ? value + 0 <= limit + 0 : value + 0 >= limit + 0) ? "yes" : "NO"
  printf "%s\t%.3g %s\t%s\t%s\n", what, value, unit, wanted, met }'; }

# engine RANKS SCRIPT [options]: the screen goes to SCRIPT.screen.
engine() { mpirun -np "$1" "$bin/liggghts-asperity" -in "$2" -log none "${@:3}" > "$2.screen" 2>&1 || { tail -n 5 "$2.screen" >&2; exit 1; }; }

# Seconds of a run's loop and, with modify_timing, of the fix in it: summed over its hooks, mean of the ranks.
loop_seconds() { awk '/^Loop time/ { print $4 }' "$1.screen"; }
fix_seconds() { awk '/^Fix wall wall\/rebound time/ { sub(/.*= */, ""); print $1 }' "$1.screen"; }

least() { sort -g | head -n 1; }
median() { sort -g | awk '{ x[NR] = $1 } END { print x[int((NR + 1) / 2)] }'; }
# Of two files of times, pair by pair.
spread() { paste "$1" "$2" | awk '{ print $1 / $2 }' | sort -g | awk '{ x[NR] = $1 } END { printf "pairs: %.3g to %.3g, median %.3g", x[1], x[NR], x[int((NR + 1) / 2)] }'; }
calc() { awk "BEGIN { printf \"%.12g\n\", $1 }"; }

# peak RANKS SCRIPT: the same, and prints the largest memory of its processes, summed, in bytes.
peak() {
  mpirun -np "$1" "$bin/liggghts-asperity" -in "$2" -log none > "$2.screen" 2>&1 &
  local job=$! pid
  while kill -0 $job 2> /dev/null; do
    for pid in $(pgrep -f "liggghts-asperity -in $2 " || true); do awk -v pid="$pid" '/^Name/ { name = $2 } /^VmHWM/ && name ~ /^liggghts/ { print pid, $2 }' "/proc/$pid/status" 2> /dev/null || true; done
    sleep 0.1
  done > "$2.memory"
  wait $job || { tail -n 5 "$2.screen" >&2; exit 1; }
  awk '$2 > m[$1] { m[$1] = $2 } END { for (p in m) s += m[p]; printf "%.0f\n", 1024 * s }' "$2.memory"
}

# deck WALL STEP STEPS [MESH]: a script for the grains of grains.data: of quartz, on Hastelloy X, that do not meet.
deck() {
  cat << END
units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
hard_particles yes
read_data grains.data
neighbor 2e-5 bin
neigh_modify delay 0 binsize 2e-4 exclude group all all
fix m1 all property/global youngsModulus peratomtype 70e9 205e9
fix m2 all property/global poissonsRatio peratomtype 0.17 0.32
fix m3 all property/global yieldStress peratomtype 200e6 200e6
fix m4 all property/global surfaceEnergy peratomtypepair 2 0.8 0.8 0.8 0.8
fix m5 all property/global coefficientFriction peratomtypepair 2 0.3 0.3 0.3 0.3
fix m6 all property/global coefficientRestitution peratomtypepair 2 0.9 0.9 0.9 0.9
pair_style gran model hertz tangential history
pair_coeff * *
${4:+fix plate all mesh/surface file $4 type 2}
fix move all nve/sphere
${1:+fix wall all $1}
timestep $2
compute ke all ke
thermo_style custom step c_ke ${1:+f_wall}
thermo 100000
modify_timing on
run $3
END
}

# slab N SHARE: grains of 10 um in a layer over z = 0, of which a share hits it within 50 steps of 4e-8 s, at 50 m/s.
slab() {
  awk -v n="$1" -v hits="$2" 'BEGIN { row = int(sqrt(n) + 0.999); side = 4e-5 * row + 1e-3
    print "g\n\n" n " atoms\n2 atom types\n\n-0.001 " side " xlo xhi\n-0.001 " side " ylo yhi\n-0.0005 0.001 zlo zhi\n\nAtoms\n"
    for (i = 1; i <= n; i++) printf "%d 1 1e-5 2650 %.9g %.9g %.9g\n", i, 4e-5 * (i % row), 4e-5 * int(i / row), (i % 10) < 10 * hits ? 6e-6 + 8e-5 * (i % 97) / 97 : 2e-4
    print "\nVelocities\n"; for (i = 1; i <= n; i++) print i, "30 0", (i % 10) < 10 * hits ? -40 : 0, "0 0 0" }' > grains.data
}
contacts() { awk 'NF == 3 && $1 > 0 && $1 + 0 == $1 { n = $3 } END { print n }' "$1.screen"; }
