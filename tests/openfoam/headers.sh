#!/usr/bin/env bash
# Compiles asperityWall for all kinds of clouds against the headers of source trees of OpenFOAM, without their libraries: the
# oldest and the newest that are at hand. Usage: headers.sh TREE...
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
home=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
clouds=$(grep -oE 'basic[A-Za-z]+Cloud' "$home/src/CMakeLists.txt" | sort -u)
[ "$(wc -w <<< "$clouds")" -ge 5 ] || { echo "FAILED: too few kinds of clouds in src/CMakeLists.txt: $clouds"; exit 1; }
for tree; do
  rm -rf "$work/headers"
  "$home/cmake/openfoam_headers" "$work/headers" "$tree"
  api=$(sed -n 's/^api=//p' "$tree/META-INFO/api-info")
  standard=$(grep -ohE -- '-std=[a-z0-9+]+' "$tree/wmake/rules/General/Gcc/c++")
  mapfile -t folders < <(find "$work/headers/include" -mindepth 1 -type d)
  for cloud in $clouds; do
    sed "s/@cloud@/$cloud/" "$home/src/openfoam/cloud.cpp.in" > "$work/$cloud.cpp"
  done
  for source in "$work"/*Cloud.cpp "$home"/src/openfoam/*.cpp; do
    g++ "$standard" -fsyntax-only -Wall -Wextra -Werror "-DOPENFOAM=$api" -DWM_DP -DWM_LABEL_SIZE=32 -DNoRepository \
      -I"$home/src" "${folders[@]/#/-isystem}" "$source" || { echo "FAILED: ${source##*/} in OpenFOAM $api"; exit 1; }
  done
  echo "OpenFOAM $api, $standard: $(wc -w <<< "$clouds") kinds of clouds compile"
done
