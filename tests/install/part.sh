#!/usr/bin/env bash
# As a part of another project asperity configures without engines and without options, has the target that
# find_package gives, and builds no tests. Where a library that it must have is missing, the message names its package.
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
die() { cat "$work/log"; echo "FAILED: $*" >&2; exit 1; }
cat > "$work/CMakeLists.txt" << END
cmake_minimum_required(VERSION 3.25)
project(whole C CXX)
add_subdirectory($source_dir asperity)
add_custom_target(uninstall)
add_executable(user $source_dir/tests/install/user/user.c)
target_link_libraries(user PRIVATE asperity::asperity)
END
# An engine that is no engine: its file would be found, and end the configuration.
echo 'Version LIGGGHTS-PUBLIC 3.7.0, compiled' > "$work/libliggghts.so"
cmake -S "$work" -B "$work/build" -DLIGGGHTS_LIBRARY="$work/libliggghts.so" > "$work/log" 2>&1 || die "configuration"
cmake --build "$work/build" --target help > "$work/log"
grep -q ' asperity_command' "$work/log" || die "it has no command"
! grep -qE ' test_|-asperity$' "$work/log" || die "it builds tests or launchers"
