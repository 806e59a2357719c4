#!/usr/bin/env bash
# The cost of the fix per particle and step, per contact, and in memory, from 10^4 to 10^6 particles on two ranks; and
# on a mesh of 10^5 triangles against one of 200. tests/bench/scale.md goes on from these.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "${BASH_SOURCE[0]}")/engine.sh"
plane='wall/rebound primitive type 2 zplane 0.0 surface rq 5e-6 lambda_c 40e-6'
of() { median < "$1"; }

# The same layer with half and with a tenth of its grains hitting: a contact's cost is the difference, a particle's
# the rest.
for n in 10000 100000 1000000; do
  for round in $(seq $((n < 1000000 ? 3 : 1))); do
    for hits in 0.5 0.1; do
      slab $n $hits
      deck "$plane" 4e-8 50 > $n.$hits.in
      if [ "$n.$hits" = 1000000.0.5 ]; then with=$(peak 2 $n.$hits.in); else engine 2 $n.$hits.in; fi
      fix_seconds $n.$hits.in >> $n.$hits.fix
    done
  done
  contact=$(calc "2e6 * ($(of $n.0.5.fix) - $(of $n.0.1.fix)) / ($(contacts $n.0.5.in) - $(contacts $n.0.1.in))")
  row "... a contact, with its way there, costs the fix" "$contact" "us"
  row "... any other particle, a step" "$(calc "1e9 * (2 * $(of $n.0.1.fix) - 1e-6 * $contact * $(contacts $n.0.1.in)) / ($n * 50)")" "ns"
done
slab 1000000 0.5
deck "" 4e-8 50 > free.in
without=$(peak 2 free.in)
row "10^6 grains, 2 ranks: memory of both" "$(calc "$with / 2 ^ 30")" "GiB" "<=" 4
row "... of it the fix, a particle" "$(calc "($with - $without) / 1e6")" "B"

# Grains on 200 and on 10^5 triangles.
plate() { # cells
  awk -v cells="$1" '
    function vertex(i, j) { printf "vertex %.9g %.9g 0\n", i * 7e-3 / cells - 5e-4, j * 7e-3 / cells - 5e-4 }
    function facet(a, b, c, d, e, f) { print "facet normal 0 0 1\nouter loop"; vertex(a, b); vertex(c, d); vertex(e, f); print "endloop\nendfacet" }
    BEGIN { print "solid p"; for (i = 0; i < cells; i++) for (j = 0; j < cells; j++) { facet(i, j, i + 1, j, i + 1, j + 1); facet(i, j, i + 1, j + 1, i, j + 1) } print "endsolid p" }'
}
mesh='wall/rebound mesh n_meshes 1 meshes plate surface rq 5e-6 lambda_c 40e-6'
for cells in 10 224; do
  plate $cells > $cells.stl
  for round in 1 2 3; do
    for hits in 0.5 0.1; do
      slab 20000 $hits
      deck "$mesh" 4e-8 50 $cells.stl > $cells.$hits.in
      if [ "$round$hits" = 10.5 ]; then peak 2 $cells.$hits.in > $cells.with; else engine 2 $cells.$hits.in; fi
      fix_seconds $cells.$hits.in >> $cells.$hits.fix
    done
  done
  deck "" 4e-8 50 $cells.stl > $cells.free.in
  peak 2 $cells.free.in > $cells.without
  row "... a contact, with its way there, costs the fix" "$(calc "2e6 * ($(of $cells.0.5.fix) - $(of $cells.0.1.fix)) / ($(contacts $cells.0.5.in) - $(contacts $cells.0.1.in))")" "us"
done
more() { calc "$(cat $1.with) - $(cat $1.without)"; }
row "memory of the wall, LIGGGHTS's lists of it and all, a triangle" "$(calc "($(more 224) - $(more 10)) / (2 * (224 ^ 2 - 10 ^ 2))")" "B"
