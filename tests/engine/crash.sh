#!/usr/bin/env bash
# A run that is killed at any moment, and continued from its last whole restart file, leaves the ledger of a run
# that nothing disturbed, byte for byte: 6 kills, on 1 and 2 ranks.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/engine.sh"
kills=${1:-6}
bouncing 300 > grains.data
plate 4 1 3.9e-3 > plate.stl
script() { # beginning
  head_of si; echo "$1
neighbor 8e-4 bin
neigh_modify delay 0 exclude group all all"; materials; echo "fix plate all mesh/surface file plate.stl type 2
fix low all wall/rebound mesh n_meshes 1 meshes plate surface rq 3e-7 lambda_c 90e-6 rebound constant 1 1 deposit off ledger 70 file low.csv
fix high all wall/rebound primitive type 2 zplane 3.8e-4 rebound constant 1 1 deposit off ledger 90 file high.csv
fix move all nve/sphere
timestep 2e-8
restart 300 r.*
run 3000 upto"; }
script 'read_data grains.data' > whole.in
script 'read_restart r.${from}' > rest.in

# start RANKS SCRIPT [options]: in the background; pids are those of the ranks.
start() {
  local ranks=$1 script=$2; shift 2
  if [ "$ranks" = 1 ]; then
    "$program" -in "$script" -log none "$@" > screen 2>&1 &
    job=$! pids=$!
  else
    mpirun -np "$ranks" "$program" -in "$script" -log none "$@" > screen 2>&1 &
    job=$! pids=
    while [ "$(wc -w <<< "$pids")" -lt "$ranks" ] && kill -0 $job 2> /dev/null; do
      pids=$(pgrep -P $job -f "$simulator-asperity -in" | tr '\n' ' ') || true
    done
  fi
}

# The newest restart file that is whole: as long as that of the run on as many ranks that nothing disturbed.
last_restart() {
  local step
  for step in $(find . -name 'r.*' -printf '%f\n' | cut -d. -f2 | sort -rn); do
    if [ "$(stat -c %s "r.$step")" = "$(stat -c %s "../whole/$ranks/r.$step")" ]; then echo "$step"; return; fi
  done
}

state=4711
killed=0 cut=0
for ranks in 1 2; do
  mkdir -p whole/$ranks
  cd whole/$ranks; ln -s ../../*.{in,data,stl} .
  engine $ranks whole.in
  cd ../..
done
for file in low high; do [ "$(wc -c < whole/1/$file.csv)" -gt 100000 ] || die "too few impacts for this test"; done
all=$(stat -c %s whole/1/low.csv)
mkdir run; cd run; ln -s ../*.{in,data,stl} .
for ranks in 1 2; do
  # On a loaded machine a run may be killed too late or too early to tell anything: then there are more of them.
  for ((k = 0; k < kills / 2 || (ranks == 2 && k < 5 * kills && (cut < kills / 2 || killed < kills / 2)); k++)); do
    rm -f r.* low.* high.*
    state=$(((16807 * state + 7) % 2147483647))
    upto=$((all * (150 + state % 800) / 1000)) # behind the first restart file
    start "$ranks" whole.in
    while [ "$(stat -c %s low.csv 2> /dev/null || echo 0)" -lt "$upto" ] && kill -0 $job 2> /dev/null; do sleep "0.00$((state % 3 + 1))"; done
    # shellcheck disable=SC2086
    kill -9 $pids 2> /dev/null && killed=$((killed + 1))
    wait $job 2> /dev/null || true
    from=$(last_restart)
    if [ -n "$from" ]; then
      engine "$ranks" rest.in -var from "$from"
      cut=$((cut + $(grep -c 'cut off' rest.in.screen || true)))
    else
      engine "$ranks" whole.in
    fi
    for file in low high; do same ../whole/1/$file.csv $file.csv "killed at $upto bytes on $ranks ranks, continued from step ${from:-0}"; done
  done
done
cd ..
echo "$killed runs of at least $kills were killed; $cut times rows after the restart file were cut off"
[ "$killed" -ge $((kills / 2)) ] || die "only $killed of $kills runs were killed"
[ "$cut" -ge $((kills / 2)) ] || die "rows were cut off only $cut times"
