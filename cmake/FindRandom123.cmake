# Finds the header-only library Random123 (Salmon et al. 2011).
# Sets Random123_FOUND and Random123_INCLUDE_DIRS.
# SPDX-License-Identifier: GPL-3.0-or-later
find_path(Random123_INCLUDE_DIR Random123/philox.h)
mark_as_advanced(Random123_INCLUDE_DIR)
if(NOT Random123_INCLUDE_DIR AND Random123_FIND_REQUIRED)
  message(FATAL_ERROR
    "Random123 was not found (no Random123/philox.h). Debian: apt-get install librandom123-dev")
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Random123 DEFAULT_MSG Random123_INCLUDE_DIR)
set(Random123_INCLUDE_DIRS ${Random123_INCLUDE_DIR})
