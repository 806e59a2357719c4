# Finds the LAMMPS library and its headers, as Debian's package liblammps-dev has them. Sets
# LAMMPS_FOUND, LAMMPS_VERSION (such as "29 Sep 2021", read from the library), LAMMPS_VERSION_NUMBER
# (20210929) and the imported target LAMMPS::lammps. Hints: LAMMPS_ROOT.
#
# Debian's packages lack headers that the others include or a fix needs; src/lammps/debian has
# what stands in for them.
# SPDX-License-Identifier: GPL-3.0-or-later
include(${CMAKE_CURRENT_LIST_DIR}/lammps_version.cmake)

find_path(LAMMPS_INCLUDE_DIR fix.h PATH_SUFFIXES lammps)
find_library(LAMMPS_LIBRARY lammps)
mark_as_advanced(LAMMPS_INCLUDE_DIR LAMMPS_LIBRARY)

if(EXISTS "${LAMMPS_LIBRARY}") # a build folder may remember one that was removed
  file(STRINGS ${LAMMPS_LIBRARY} LAMMPS_VERSION LIMIT_COUNT 1
    REGEX "Parallel Simulator - [0-9]+ [A-Z][a-z]+ [0-9]+")
  if(LAMMPS_VERSION MATCHES "Parallel Simulator - ([0-9]+ [A-Z][a-z]+ [0-9]+)")
    set(LAMMPS_VERSION ${CMAKE_MATCH_1})
    asperity_date_number("${LAMMPS_VERSION}" LAMMPS_VERSION_NUMBER)
  endif()
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LAMMPS
  REQUIRED_VARS LAMMPS_LIBRARY LAMMPS_INCLUDE_DIR LAMMPS_VERSION
  REASON_FAILURE_MESSAGE "Debian: apt-get install liblammps-dev libopenmpi-dev openmpi-bin. Elsewhere: set LAMMPS_ROOT. Or build without it with -DASPERITY_LAMMPS=OFF")

if(LAMMPS_FOUND AND NOT TARGET LAMMPS::lammps)
  set(_headers ${LAMMPS_INCLUDE_DIR})
  if(NOT EXISTS ${LAMMPS_INCLUDE_DIR}/atom_vec.h)
    list(APPEND _headers ${PROJECT_SOURCE_DIR}/src/lammps/debian)
  endif()
  add_library(LAMMPS::lammps UNKNOWN IMPORTED)
  set_target_properties(LAMMPS::lammps PROPERTIES
    IMPORTED_LOCATION ${LAMMPS_LIBRARY}
    INTERFACE_COMPILE_DEFINITIONS LAMMPS_SMALLBIG
    INTERFACE_INCLUDE_DIRECTORIES "${_headers}")
  unset(_headers)
endif()
