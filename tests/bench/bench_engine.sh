#!/usr/bin/env bash
# The fix in LIGGGHTS: its share of the flat-plate case's instructions; its ledger; one rank
# against two.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "${BASH_SOURCE[0]}")/engine.sh"

# The flat plate as it comes, rough: with its ledger and without.
mkdir output
awk -f "$home/examples/flat_plate/make_plate.awk" > output/plate.stl
awk -f "$home/examples/flat_plate/make_jet.awk" > output/jet.data
sed 's/^run /modify_timing on\nrun /' "$home/examples/flat_plate/in.flat_plate" > csv.in
sed 's/ ledger 2000.*//' csv.in > quiet.in
rough=(-var name plate -var surface "rq 15.6e-6 lambda_c 120e-6")
for round in 1 2 3; do
  for ranks in 2 1; do
    for deck in csv quiet; do
      begun=$(date +%s.%N)
      engine $ranks $deck.in "${rough[@]}"
      calc "$(date +%s.%N) - $begun" >> $deck.$ranks.whole
      fix_seconds $deck.in >> $deck.$ranks.fix
      loop_seconds $deck.in >> $deck.$ranks.loop
    done
  done
done
of() { median < "$1"; }
row "flat plate: the fix, ledger and all, of the run" "$(calc "100 * $(of csv.2.fix) / $(of csv.2.whole)")" "%" "<=" 10
if command -v valgrind > /dev/null; then
  valgrind --tool=callgrind --callgrind-out-file=counts "$bin/liggghts-asperity" -in csv.in -log none "${rough[@]}" > valgrind.screen 2>&1 || { tail -n 5 valgrind.screen >&2; exit 1; }
  callgrind_annotate --inclusive=yes --threshold=100 counts | awk '
    function count() { gsub(",", "", $1); return $1 + 0 }
    /Verlet::run\(/ && !loop { loop = count() }
    /FixWallRebound::(post_integrate|pre_exchange|pre_neighbor|pre_force|end_of_step)\(/ && !seen[$0]++ { fix += count() }
    /Ledger::end_step\(/ && !ledger { ledger = count() }
    END { print 100 * fix / loop, 100 * ledger / loop }' > counted
  row "flat plate: the fix, ledger and all, of the instructions of a step" "$(cut -d ' ' -f 1 counted)" "%" "<=" 5
  row "... printing the ledger" "$(cut -d ' ' -f 2 counted)" "%"
fi
for ranks in 2 1; do
  row "flat plate: the ledger, every impact, of the loop, $ranks rank(s)" "$(calc "100 * ($(of csv.$ranks.fix) - $(of quiet.$ranks.fix)) / $(of csv.$ranks.loop)")" "%" "<=" 10
done
row "flat plate: two ranks over one: the loop" "$(calc "$(of csv.1.loop) / $(of csv.2.loop)")" "x"
row "... the fix" "$(calc "$(of csv.1.fix) / $(of csv.2.fix)")" "x"

# A ledger of 10^6 rows in `asperity compare`.
{ head -n 2 output/plate.csv; for k in {1..50}; do tail -n +3 output/plate.csv; done; } > million.csv
rows=$(($(wc -l < million.csv) - 2))
TIMEFORMAT=%U
for round in 1 2 3; do
  { time "$bin/asperity" compare million.csv "$home/examples/data/grant_tabakoff_1975.csv" > million.out 2> /dev/null; } 2>> compare
done
row "ledger: bytes an impact" "$(calc "$(stat -c %s million.csv) / $rows")" "B"
row "... asperity compare, 10^8 rows, from $rows" "$(calc "1e8 / $rows * $(of compare)")" "s"
