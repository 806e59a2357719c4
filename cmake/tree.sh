# What liggghts_tree and lammps_tree share; sourced by them. They set `engine` (its folder in src), `name` (as it calls
# itself), `sources` (what of that folder the tree compiles), `mark` (files that a tree of it has), and the function
# `how_to_build TREE`, which prints the commands.
#
# The engine's side goes into the folder that the tree compiles; the rest is built already, and its headers go into
# folders of their own.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
die() { echo "$engine"_tree": $*" >&2; exit 1; }
[ $# -ge 2 ] || { sed -n '2,/^set /s/^# \{0,1\}//p' "$0" | head -n 7; exit 2; }
action=$1
for file in "${mark[@]}"; do
  [ -f "$2/$file" ] || die "'$2' is not the folder src of a $name source tree (no $file)"
done
tree=$(cd "$2" && pwd)
build=${3:-$home/build}

files=(asperity.h base/ledger_columns.h base/number.h)
for source in "${sources[@]}"; do files+=("${source##*/}"); done
for source in "$home"/src/{dem,contact}/*.h; do files+=("${source#"$home/src/"}"); done
libraries=(libasperity_dem.a libasperity.a)

source_of() {
  case $1 in
  */* | asperity.h) echo "$home/src/$1" ;;
  *) echo "$home/src/$engine/$1" ;;
  esac
}

case $action in
install)
  for library in "${libraries[@]}"; do
    [ -f "$build/src/$library" ] || die "there is no $build/src/$library; run cmake/prepare, or name the build folder"
  done
  mkdir -p "$tree/asperity" "$tree"/{base,contact,dem}
  for file in "${files[@]}"; do
    [ ! -e "$tree/$file" ] || cmp -s "$(source_of "$file")" "$tree/$file" || echo "replaces $file"
    cp "$(source_of "$file")" "$tree/$file"
  done
  for library in "${libraries[@]}"; do cp "$build/src/$library" "$tree/asperity/"; done
  echo "installed into $tree. Build it with"
  how_to_build
  echo "or add these options and libraries to your own makefile."
  ;;
diff)
  for file in "${files[@]}" "${libraries[@]/#/asperity/}"; do
    [ ! -e "$tree/$file" ] || echo "added: $file"
  done
  ;;
remove)
  for file in "${files[@]}"; do rm -f "$tree/$file"; done
  rm -rf "$tree/asperity"
  for folder in base contact dem; do
    [ ! -d "$tree/$folder" ] || rmdir --ignore-fail-on-non-empty "$tree/$folder"
  done
  echo "removed from $tree; the style goes with the next build"
  ;;
*) die "'$action' is not install, diff or remove" ;;
esac
