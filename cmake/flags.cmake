# Flags of all our own code. No contraction to fused operations, and none carried out before it is known to be needed:
# results, and what traps, do not depend on the compiler's choices.
# SPDX-License-Identifier: GPL-3.0-or-later
add_library(asperity_flags INTERFACE)
target_compile_options(asperity_flags INTERFACE -Wall -Wextra -Wshadow -ffp-contract=off -fno-math-errno
  -fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=
  $<$<COMPILE_LANGUAGE:C>:-pedantic -Wconversion -Wno-sign-conversion> $<$<COMPILE_LANG_AND_ID:C,Clang>:-ftrapping-math>)
target_compile_definitions(asperity_flags INTERFACE $<$<COMPILE_LANGUAGE:C>:_XOPEN_SOURCE=700>)
