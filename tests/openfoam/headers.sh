#!/usr/bin/env bash
# Compiles asperityWall for all kinds of clouds against the headers of source trees of OpenFOAM, without their libraries: the
# oldest and the newest that are at hand. Usage: headers.sh TREE...
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
home=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
for tree; do
  rm -rf "$work"/*
  "$home/cmake/openfoam_headers" "$work/headers" "$tree"
  { read -r api; read -r standard; read -r _; read -r clouds; } < "$work/headers/host"
  [ "$(wc -w <<< "$clouds")" = 5 ] || { echo "FAILED: kinds of clouds: $clouds"; exit 1; }
  mapfile -t folders < <(find "$work/headers/include" -mindepth 1 -type d)
  for cloud in $clouds; do
    sed "s/@cloud@/$cloud/" "$home/src/openfoam/cloud.cpp.in" > "$work/$cloud.cpp"
  done
  for source in "$work"/*Cloud.cpp "$home"/src/openfoam/*.cpp; do
    g++ "-std=c++$standard" -fsyntax-only -Wall -Wextra -Werror "-DOPENFOAM=$api" -DWM_DP -DWM_LABEL_SIZE=32 -DNoRepository \
      -I"$home/src" "${folders[@]/#/-isystem}" "$source" || { echo "FAILED: ${source##*/} in OpenFOAM $api"; exit 1; }
  done
  echo "OpenFOAM $api, C++$standard: 5 kinds of clouds compile"
done
