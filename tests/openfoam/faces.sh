#!/usr/bin/env bash
# A wall of a million faces: the model takes no memory but that of its fields, six numbers a cell and a boundary face.
# SPDX-License-Identifier: GPL-3.0-or-later
source "$(dirname "$0")/case.sh"
# memory DIR: the most that the solver took, in MB.
memory() {
  (cd "$1"
    icoUncoupledKinematicParcelFoam > log 2>&1 & solver=$!
    while grep VmHWM /proc/$solver/status; do sleep 0.2; done 2> /dev/null
    wait $solver || die "the solver in $1") | awk '{ kb = $2 } END { print kb / 1024 }'
}
box theirs "type rebound; e 1; mu 0;" model=standardWallInteraction cells='1000 1000 1' end=0.1 write=1000
box ours 'walls { ".*" "surface rq 5um lambda_c 40um rebound constant 1 1"; }' cells='1000 1000 1' end=0.1 write=1000
mesh theirs
cp -r theirs/constant/polyMesh ours/constant
a=$(memory theirs) b=$(memory ours)
fields=$(awk 'BEGIN { print 6 * 8 * 3.004e6 / 1024 ^ 2 }') # 10^6 cells, 2.004 10^6 faces of walls
echo "theirs $a MB, ours $b MB, fields $fields MB"
awk -v more="$(awk "BEGIN { print $b - $a }")" -v fields="$fields" 'BEGIN { exit !(more > 0.8 * fields && more < 1.15 * fields) }' || die "the model takes other memory than its fields"
