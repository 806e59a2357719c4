#!/usr/bin/env bash
# The module asperity beside the built library: where no program is in the path, and so no compiler; where the library
# is missing, or one of another version; installed by pip without network, from the source tree and from an installed
# prefix, which pip leaves as they were, and as a wheel. Usage: module.sh BUILD [install]: what pip installs, in place of the rest
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
build=$(cd "$1" && pwd)
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source_dir=$(cd "$here/../../src/python" && pwd)
python=${ASPERITY_PYTHON:-/usr/bin/python3}
library=$(echo "$build"/lib*/libasperity.so.1)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
die() { echo "FAILED: $*" >&2; exit 1; }
mkdir "$work/empty"

# run MODULES TESTS [NAME=VALUE ...]: the tests with the module of that folder, and no program in the path.
all= one=Walls.test_arrays_are_single_impacts
run() {
  local modules=$1 tests=$2; shift 2
  env -i PATH="$work/empty" ASPERITY_BIN="$build/bin" PYTHONPATH="$modules" PYTHONDONTWRITEBYTECODE=1 "$@" \
    "$python" "$here/test_asperity.py" $tests > "$work/log" 2>&1 || { cat "$work/log"; die "the module of $modules"; }
  grep -q '^Ran [1-9]' "$work/log" || { cat "$work/log"; die "no tests ran"; }
}
import() { env -i PATH="$work/empty" PYTHONPATH="$source_dir" PYTHONDONTWRITEBYTECODE=1 "$@" "$python" -c 'import asperity' 2>&1; }

version=$(sed -n 's/^__version__ = "\(.*\)"/\1/p' "$source_dir/asperity/__init__.py")
if [ "${2:-}" != install ]; then
run "$source_dir" "$all" ASPERITY_LIBRARY="$library"
! import ASPERITY_LIBRARY=/no/library > "$work/log" || die "imported without a library"
grep -q 'libasperity.so.1 is not there.*looked at /no/library' "$work/log" || { cat "$work/log"; die "a missing library"; }
sed "s/$version\x00/8.8.8\x00/" "$library" > "$work/other.so"
! import ASPERITY_LIBRARY="$work/other.so" > "$work/log" || die "imported with a library of another version"
grep -q "is asperity 8.8.8, and the module $version" "$work/log" || { cat "$work/log"; die "a library of another version"; }
exit
fi

"$python" -m pip --version > /dev/null 2>&1 || die "no pip: apt-get install python3-pip"
# install FOLDER [NAME=VALUE ...]: with pip, and the tests with what it installed.
install() {
  local from=$1 before after; shift
  before=$(find "$from" | sort)
  env PIP_ROOT_USER_ACTION=ignore PIP_DISABLE_PIP_VERSION_CHECK=1 "$@" "$python" -m pip install --quiet --no-index --no-deps \
    --no-build-isolation --target "$work/site" "$from" > "$work/log" 2>&1 || { cat "$work/log"; die "pip install $from"; }
  after=$(find "$from" | sort)
  [ "$before" = "$after" ] || die "pip left something in $from: $after"
  [ -e "$work/site/asperity-$version.dist-info" ] || die "pip installed no version $version: $(ls "$work/site")"
}
install "$source_dir" ASPERITY_LIBRARY="$library"
run "$work/site" "$one"
rm -r "$work/site"
cmake --install "$build" --prefix "$work/prefix" > /dev/null
installed=$(find "$work/prefix" -path '*/asperity/python')
run "$installed" "$one"
install "$installed"
rm -r "$work/prefix"
run "$work/site" "$one"

# The wheel, in an environment that has nothing else but NumPy: for any Python 3, with all that it needs and Linux has not.
cmake --build "$build" --target wheel > "$work/log" 2>&1 || { cat "$work/log"; die "the target wheel"; }
wheel=$(echo "$build/asperity-$version"-py3-none-manylinux_2_*.whl)
[ "$(stat -c %s "$wheel")" -le 3000000 ] || die "the wheel has $(stat -c %s "$wheel") bytes"
"$python" -m venv --without-pip --system-site-packages "$work/venv"
"$python" -m pip --python "$work/venv/bin/python" install --quiet --no-index --no-deps "$wheel" > "$work/log" 2>&1 ||
  { cat "$work/log"; die "pip install of the wheel"; }
module=$(dirname "$(find "$work/venv" -name py.typed)")
for name in $(readelf -d "$module"/*.so* | sed -n 's/.*(NEEDED).*\[\(.*\)\]$/\1/p'); do
  [ -e "$module/$name" ] || [[ $name =~ ^(lib[cmz]\.so|ld-linux) ]] || die "the wheel has no $name"
done
grep -rlq 'D. E. Shaw' "$module"/../asperity-*.dist-info || die "the wheel has no license of what is compiled in"
python=$work/venv/bin/python
run "" "$one"
