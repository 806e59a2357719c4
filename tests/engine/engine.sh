# Shared by the engine tests: each sources it. They run the real launchers in a folder of their own and compare
# numbers, not log text. ASPERITY_BIN is the folder of the binaries (build/bin where it is not set). A test that is
# for either engine is called with its name, liggghts (the default) or lammps; its scripts are in LIGGGHTS's language,
# which to_lammps.awk turns into that of LAMMPS.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
bin=$(cd "${ASPERITY_BIN:-$here/../../build/bin}" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
source "$here/scenes.sh"
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe # the same of Open MPI 5
# One process without mpirun starts no daemon, and ranks of one machine look for no network: twice as fast a start.
export OMPI_MCA_ess_singleton_isolated=1 OMPI_MCA_pml=ob1 OMPI_MCA_btl=self,vader
# Runs that share Open MPI's session folder make and remove it under each other: some then fail at their start.
export OMPI_MCA_orte_tmpdir_base=$work
# mpirun would wait a second for the ranks of a run that ends with an error.
export OMPI_MCA_odls_base_sigkill_timeout=0

# use ENGINE: its launcher, as $program. That of LAMMPS gets the script in its own language: a copy for each rank, of
# which the first one's counts.
use() {
  simulator=$1
  program=$bin/liggghts-asperity
  [ $simulator = lammps ] || return 0
  program=$work/.lammps
  cat > "$program" << END
#!/usr/bin/env bash
set -e
rank=\${OMPI_COMM_WORLD_RANK:-0}
copy=\$2.lammps.\$rank
into=constants
[ "\$1" = -in ]
[ "\$rank" = 0 ] || into=/dev/null
awk -v into="\$into" -f "$here/to_lammps.awk" "\$2" > "\$copy"
shift 2
exec "$bin/lammps-asperity" -in "\$copy" "\$@"
END
  chmod +x "$program"
}
use liggghts
case ${1:-} in liggghts | lammps) use "$1"; shift ;; esac

die() { echo "FAILED: $*" >&2; exit 1; }

# table NAME=FILE... CODE: checks tables, as tests/table.py tells.
python=${ASPERITY_PYTHON:-/usr/bin/python3} # not what a manager of versions puts before it: ten processes a start
table() { "$python" -S "$here/../table.py" "$@"; }

# engine RANKS SCRIPT [options]: runs a script; the screen goes to SCRIPT.screen, from the first rank itself: what passes
# through mpirun may be cut in a line, or lost at the end. What is said beside it follows.
engine() {
  local ranks=$1 script=$2 ended=0; shift 2
  local launch=()
  [ "$ranks" = 1 ] || launch=(mpirun -np "$ranks")
  rm -f "$script.screen"
  timeout "${TIMEOUT:-300}" "${launch[@]}" "$program" -in "$script" -log none -screen "$script.screen" "$@" < /dev/null > "$script.beside" 2>&1 || ended=$?
  cat "$script.beside" >> "$script.screen"
  [ $ended = 0 ] || { tail -n 15 "$script.screen" >&2; die "$script on $ranks ranks"; }
}

# refuses RANKS SCRIPT WORD...: it ends with one error, which has the words. OPTIONS are the engine's.
refuses() {
  local ranks=$1 script=$2 launch=() word; shift 2
  [ "$ranks" = 1 ] || launch=(mpirun -np "$ranks")
  # shellcheck disable=SC2086
  ! timeout 60 "${launch[@]}" "$program" -in "$script" -log none ${OPTIONS:-} < /dev/null > "$script.screen" 2>&1 || die "$script was accepted: $*"
  local errors
  mapfile -t errors < <(grep -a '^ERROR' "$script.screen")
  [ ${#errors[@]} = 1 ] || { tail "$script.screen"; die "${#errors[@]} messages on $ranks ranks, not one: $*"; }
  for word; do [[ ${errors[0]} == *"$word"* ]] || { echo "${errors[0]}"; die "'$word' is not in the message"; }; done
  ! grep -aqi -e 'segmentation' -e 'signal 11' "$script.screen" || die "crash: $*"
}

same() { cmp "$1" "$2" || die "$1 and $2 differ: $3"; }

# near A B COLUMNS TOLERANCE: columns of two ledgers, by their names or numbers, agree row by row to a relative tolerance.
near() {
  table a="$1" b="$2" "
assert a and len(a) == len(b)
for x, y in zip(a, b):
    for k in '$3'.split():
        k = int(k) - 1 if k.isdigit() else k
        assert near(x[k], y[k], $4, 1e-6) or isnan(x[k]) and isnan(y[k]), (k, x, y)" || die "$1 and $2 differ"
}

rows() { grep -v -e '^#' -e '^tag' "$1"; }
count_rows() { rows "$1" | wc -l; }

# check_rows FILE CONDITION TEXT: a condition, in Python, holds for every row r of a ledger, and there are rows.
check_rows() {
  table a="$1" "assert a
for r in a:
    assert $2, r" || die "$3"
}

# materials [YOUNG YIELD GAMMA]: quartz (type 1) on Hastelloy X (type 2), with what unit factors say.
materials() {
  local pa=${1:-1} jm2=${2:-1}
  cat << END
fix m1 all property/global youngsModulus peratomtype $(mul 70e9 "$pa") $(mul 205e9 "$pa")
fix m2 all property/global poissonsRatio peratomtype 0.17 0.32
fix m3 all property/global yieldStress peratomtype $(mul 200e6 "$pa") $(mul 200e6 "$pa")
fix m4 all property/global surfaceEnergy peratomtypepair 2 $(mul 0.8 "$jm2") $(mul 0.8 "$jm2") $(mul 0.8 "$jm2") $(mul 0.8 "$jm2")
fix m5 all property/global coefficientFriction peratomtypepair 2 0.3 0.3 0.3 0.3
fix m6 all property/global coefficientRestitution peratomtypepair 2 0.9 0.9 0.9 0.9
pair_style gran model hertz tangential history
pair_coeff * *
END
}

mul() { [ "$2" = 1 ] && echo "$1" || awk -v a="$1" -v b="$2" 'BEGIN { printf "%.15g", a * b }'; }

# head_of UNITS LENGTH: the beginning of a script; LENGTH is the unit's factor to meters.
head_of() {
  cat << END
units ${1:-si}
atom_style granular
boundary f f f
newton off
communicate single vel yes
hard_particles yes
END
}

# flying FILE: the beginning of a script of grains that do not meet, of a data or restart file, in UNITS and their
# factors PA and JM2 of `materials`, with a BOUNDARY.
flying() {
  head_of "${units:-si}" | sed "s/^boundary.*/boundary ${boundary:-f f f}/"
  echo "$([[ $1 == *restart ]] && echo read_restart || echo read_data) $1
neighbor $(mul 3e-5 "${length:-1}") bin
neigh_modify delay 0 exclude group all all
fix move all nve/sphere"
  materials "${pa:-1}" "${jm2:-1}"
}

# pictures STEPS [FILE [COLUMNS]]: the lines of a dump.
pictures() {
  echo "dump at all custom $1 ${2:-at.txt} id ${3:-x y z vx vy vz}
dump_modify at sort id format \"%d$(printf ' %%.17g%.0s' ${3:-x y z vx vy vz})\""
}

# grains N [LENGTH VELOCITY DENSITY SEED]: a data file of grains over the plane z = 0, each of its own size
# (3 to 60 um), speed (20 to 120 m/s), angle (1 to 89 degrees) and azimuth, that reach it within 3 us at
# places of their own. LENGTH, VELOCITY and DENSITY turn SI into the script's units.
grains() {
  awk -v n="$1" -v length_="${2:-1}" -v velocity="${3:-1}" -v density="${4:-1}" -v state="${5:-12345}" '
    function uniform() { state = (16807 * state) % 2147483647; return state / 2147483647 }
    BEGIN {
      pi = atan2(0, -1); row = int(sqrt(n) + 0.999)
      side = row * 1e-4
      printf "grains\n\n%d atoms\n2 atom types\n\n", n
      split("x y z", axis, " ")
      for (k = 1; k <= 3; k++)
        printf "%.15g %.15g %slo %shi\n", (k < 3 ? -2e-3 : -5e-4) * length_, (k < 3 ? side + 2e-3 : 1.5e-3) * length_, axis[k], axis[k]
      print "\nAtoms\n"
      for (i = 1; i <= n; i++) {
        d = 3e-6 * exp(3 * uniform()); v = 20 + 100 * uniform(); a = (1 + 88 * uniform()) * pi / 180
        w = 2 * pi * uniform(); t = (0.1 + 2.9 * uniform()) * 1e-6
        vx[i] = v * cos(a) * cos(w); vy[i] = v * cos(a) * sin(w); vz[i] = -v * sin(a)
        printf "%d 1 %.15g %.15g %.15g %.15g %.15g\n", i, d * length_, 2650 * density,
          (1e-4 * (i % row) - vx[i] * t) * length_, (1e-4 * int(i / row) - vy[i] * t) * length_, (d / 2 - vz[i] * t) * length_
      }
      print "\nVelocities\n"
      for (i = 1; i <= n; i++) printf "%d %.15g %.15g %.15g 0 0 0\n", i, vx[i] * velocity, vy[i] * velocity, vz[i] * velocity
    }'
}

# bouncing N: a data file of N grains between the planes z = 0 and z = 3.8e-4 that go up and down.
bouncing() {
  awk -v n="$1" 'BEGIN {
    printf "grains\n\n%d atoms\n2 atom types\n\n-4e-3 6e-3 xlo xhi\n-4e-3 6e-3 ylo yhi\n-5e-4 1e-3 zlo zhi\n\nAtoms\n\n", n
    for (i = 1; i <= n; i++) printf "%d 1 %g 2650 %g %g %g\n", i, 1e-5 + i * 1e-7, 1e-4 * (i % 18), 1e-4 * int(i / 18), 1e-4 + (i * 37 % 100) * 2e-6
    printf "\nVelocities\n\n"
    for (i = 1; i <= n; i++) printf "%d 0 0 %g 0 0 0\n", i, (i % 3 ? 1 : -1) * (30 + i * 53 % 97) }'
}

# plate CELLS LENGTH: an STL plate under all of them, in the plane z = 0.
plate() {
  awk -v cells="$1" -v lo="$(mul -1.9e-3 "${2:-1}")" -v hi="$(mul "${3:-5e-3}" "${2:-1}")" '
    function vertex(i, j) { printf "vertex %.12g %.12g 0\n", lo + i * (hi - lo) / cells, lo + j * (hi - lo) / cells }
    function facet(a, b, c, d, e, f) { print "facet normal 0 0 1\nouter loop"; vertex(a, b); vertex(c, d); vertex(e, f); print "endloop\nendfacet" }
    BEGIN { print "solid p"; for (i = 0; i < cells; i++) for (j = 0; j < cells; j++) { facet(i, j, i + 1, j, i + 1, j + 1); facet(i, j, i + 1, j + 1, i, j + 1) } print "endsolid p" }'
}
