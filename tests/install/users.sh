#!/usr/bin/env bash
# Programs in C and in C++ use an installed asperity that was moved to another prefix: by find_package, and by
# pkg-config. The static library needs GSL, libzip and Expat, from prefixes that CMake is told of; of a user of the
# shared one nothing is asked, even where they cannot be found. Usage: users.sh PREFIX static|shared
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
die() { cat "$work/log"; echo "FAILED: $*" >&2; exit 1; }
cp -r "$1" "$work/moved"
pc=$(find "$work/moved" -name asperity.pc -printf %h)
version=$(PKG_CONFIG_PATH=$pc pkg-config --modversion asperity)
libraries=$(dirname "$pc")
export LD_LIBRARY_PATH=$libraries
ran() { "$1" > "$work/log" 2>&1 && grep -q "^asperity $version: slope 0\.[1-9]" "$work/log" || die "$1"; }

# A second prefix with what the static library needs, in the place of the system's.
mkdir -p "$work/needs/lib" "$work/needs/include"
for header in gsl zip.h zipconf.h expat.h expat_external.h; do
  for folder in /usr/include "/usr/include/$(gcc -print-multiarch)"; do
    [ ! -e "$folder/$header" ] || ln -sfn "$folder/$header" "$work/needs/include/$header"
  done
done
for library in gsl gslcblas zip expat; do
  file=$(gcc -print-file-name="lib$library.so")
  [ "$file" = "lib$library.so" ] || ln -s "$file" "$work/needs/lib/"
done

for language in C CXX; do
  options=(-DLANGUAGE=$language "-DCMAKE_PREFIX_PATH=$work/moved;$work/needs" -DPKG_CONFIG_EXECUTABLE=/bin/false)
  if [ "$2" = shared ]; then options+=(-DCMAKE_DISABLE_FIND_PACKAGE_GSL=ON -DCMAKE_DISABLE_FIND_PACKAGE_libzip=ON); fi
  cmake -S "$here/user" -B "$work/$language" "${options[@]}" > "$work/log" 2>&1 || die "find_package in $language"
  cmake --build "$work/$language" --verbose > "$work/log" 2>&1 || die "build by find_package in $language"
  link=$(grep -e '-o user ' "$work/log")
  ! grep -qE -- ' -l(gsl|gslcblas|zip|expat)( |$)' <<< "$link" || die "a library without its folder in: $link"
  if [ "$2" = static ]; then grep -q "$work/needs/lib/libgsl.so" <<< "$link" || die "another GSL than the one told in: $link"; fi
  [ "$2" != shared ] || ! grep -qE 'libgsl|libzip|libexpat' <<< "$link" || die "a user of the shared library links $link"
  ran "$work/$language/user"
done

[ "$2" != shared ] || export PKG_CONFIG_LIBDIR=$pc # which has no other library
for compiler in "gcc -std=c99" "g++ -std=c++98 -x c++ -Wno-long-long"; do
  flags=$(PKG_CONFIG_PATH=$pc pkg-config --cflags --libs asperity)
  # shellcheck disable=SC2086
  $compiler -pedantic -Wall -Wextra -Werror -c "$here/user/user.c" -o "$work/user.o" $flags > "$work/log" 2>&1 &&
    ${compiler%% *} "$work/user.o" -o "$work/user" $flags -lm > "$work/log" 2>&1 || die "$compiler by pkg-config"
  ran "$work/user"
done
