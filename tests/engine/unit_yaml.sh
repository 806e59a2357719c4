#!/usr/bin/env bash
# LAMMPS's unit tests of the fix (cmake/lammps/tests/*.yaml), run by its launcher as LAMMPS's test_fix_timestep runs them,
# without r-RESPA: eight steps, then the last four again from a restart file, must give the numbers that the files state.
# Usage: unit_yaml.sh lammps
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
folder=$here/../../cmake/lammps/tests
key() { sed -n "s/^$2: //p" "$1"; }
block() { awk -v key="$2:" '$1 == key { in_it = 1; next } /^[^ ]/ { in_it = 0 } in_it' "$1"; }
final() { # FILE: positions, velocities, and the fix's scalar and vector, in digits that say all
  echo "variable sums string \"\$(f_test:%.17g)$(printf ' $(f_test[%d]:%%.17g)' {1..20})\"
print \"\${sums}\" file $1.sums
write_dump all custom $1.atoms id x y z vx vy vz modify sort id format float %.17g
variable sums delete"
}
tests=0
for yaml in "$folder"/*.yaml; do
  name=$(basename "$yaml" .yaml)
  again="$(block "$yaml" post_commands)
timestep $(key "$yaml" timestep)"
  { echo "variable input_dir index $folder"
    cat "$folder/$(key "$yaml" input_file)" "$folder/$(key "$yaml" input_coeffs)"
    echo "$again
run 0 post no
run 4 post no
write_restart $name.restart
run 4 post no
$(final first)
clear
read_restart $name.restart
$again
run 4 post no
$(final again)"; } > "$name.in"
  "$bin/lammps-asperity" -in "$name.in" -log none < /dev/null > "$name.screen" 2>&1 || { tail -n 3 "$name.screen"; die "$name"; }
  epsilon=$(key "$yaml" epsilon)
  for run in first again; do
    # id x y z vx vy vz of each atom, then the sums
    { join <(block "$yaml" run_pos | sort) <(block "$yaml" run_vel | sort)
      echo "$(key "$yaml" global_scalar) $(block "$yaml" global_vector | cut -d ' ' -f 4-)"; } > stated
    { sed '1,/^ITEM: ATOMS/d' $run.atoms; cat $run.sums; } > found
    [ "$(wc -l < found)" -gt "$(key "$yaml" natoms)" ] || die "$name: $(wc -l < found) lines"
    paste -d ' ' stated found | awk -v epsilon="$epsilon" '
      { half = NF / 2
        for (i = 1; i <= half; i++) { d = $i - $(i + half); m = $i < 0 ? -$i : $i + 0
          if ((d < 0 ? -d : d) > epsilon * (m ? m : 1)) { print "line " NR ", number " i ": stated " $i ", found " $(i + half); bad = 1 } }
      } END { exit bad || int(half) != half }' > differ || { head -n 5 differ; die "$name, $run run"; }
  done
  tests=$((tests + 1))
done
[ "$tests" -ge 3 ] || die "only $tests unit tests"
