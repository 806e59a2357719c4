#!/usr/bin/env bash
# The plugin for LAMMPS by the two lines of cmake/README.md, with an installed asperity in place of this source tree. The
# LAMMPS is $ASPERITY_LAMMPS_TREE, or one of Debian's headers and what they lack. Usage: plugin.sh BUILD VERSION
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
build=$1 version=$2
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
die() { tail -n 30 "$work/log"; echo "FAILED: $*" >&2; exit 1; }
cmake --install "$build" --prefix "$work/prefix" > /dev/null
tree=${ASPERITY_LAMMPS_TREE:-$work/lammps}
if [ "$tree" = "$work/lammps" ]; then
  mkdir -p "$tree/src"
  for file in /usr/include/lammps/* "$root"/src/lammps/debian/*; do [ -e "$tree/src/${file##*/}" ] || ln -s "$file" "$tree/src"; done
  echo "#define LAMMPS_VERSION \"$version\"" > "$tree/src/version.h"
  cat > "$tree/src/lammpsplugin.h" << END
extern "C" {
typedef void *(lammpsplugin_factory2)(void *, int, char **);
typedef struct { const char *version, *style, *name, *info, *author;
  union { lammpsplugin_factory2 *v2; } creator; void *handle; } lammpsplugin_t;
typedef void (*lammpsplugin_regfunc)(lammpsplugin_t *, void *);
}
END
fi
# The two lines, with the prefix and the home folder here.
mapfile -t lines < <(grep -A 1 '^cmake -S /usr/share/asperity/plugin' "$root/cmake/README.md")
[ ${#lines[@]} = 2 ] || die "cmake/README.md has not the two lines"
mkdir -p "$work/home"; ln -s "$tree" "$work/home/lammps"
cd "$work"
for line in "${lines[@]}"; do
  HOME=$work/home CMAKE_PREFIX_PATH=$work/prefix bash -c "${line//\/usr\//$work/prefix/}" > "$work/log" 2>&1 || die "$line"
done
! grep 'warning: ' "$work/log" || die "the compiler warns"
for part in wallreboundplugin wallreboundstyle; do [ -e "plugin/bin/$part.so" ] || die "no $part.so"; done
# It is LAMMPS that has what the plugin does not find elsewhere.
missing=$(ldd -r plugin/bin/wallreboundstyle.so 2>&1 | sed -n 's/^undefined symbol: \([^ \t]*\).*/\1/p' | c++filt | grep -vE 'LAMMPS_NS|^lammps_|^MathExtra::exyz_to_q\(' || true)
[ -z "$missing" ] || { echo "$missing" > "$work/log"; die "the plugin misses functions of its own"; }
