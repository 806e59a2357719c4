# Finds the LIGGGHTS library and its headers, as Debian's packages liggghts and libliggghts-dev have
# them. Sets LIGGGHTS_FOUND, LIGGGHTS_VERSION (such as "LIGGGHTS-PUBLIC 3.8.0", read from the library)
# and the imported target LIGGGHTS::liggghts. Hints: LIGGGHTS_ROOT.
#
# The development package lacks five generated headers; a fix needs them only to exist, so they are
# made empty in the build folder.
# SPDX-License-Identifier: GPL-3.0-or-later
find_path(LIGGGHTS_INCLUDE_DIR fix_wall_gran.h PATH_SUFFIXES liggghts)
find_library(LIGGGHTS_LIBRARY liggghts)
mark_as_advanced(LIGGGHTS_INCLUDE_DIR LIGGGHTS_LIBRARY)

if(EXISTS "${LIGGGHTS_LIBRARY}") # a build folder may remember one that was removed
  file(STRINGS ${LIGGGHTS_LIBRARY} LIGGGHTS_VERSION LIMIT_COUNT 1
    REGEX "LIGGGHTS-[A-Za-z]+ [0-9]+\\.[0-9]+\\.[0-9]+")
  string(REGEX MATCH "LIGGGHTS-[A-Za-z]+ [0-9]+\\.[0-9]+\\.[0-9]+" LIGGGHTS_VERSION
    "${LIGGGHTS_VERSION}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LIGGGHTS
  REQUIRED_VARS LIGGGHTS_LIBRARY LIGGGHTS_INCLUDE_DIR LIGGGHTS_VERSION
  REASON_FAILURE_MESSAGE "Debian: apt-get install liggghts libliggghts-dev libopenmpi-dev openmpi-bin. Elsewhere: set LIGGGHTS_ROOT. Or build the core and the command alone with -DASPERITY_LIGGGHTS=OFF")

if(LIGGGHTS_FOUND AND NOT TARGET LIGGGHTS::liggghts)
  set(_made ${CMAKE_BINARY_DIR}/liggghts_headers)
  foreach(_name surface normal tangential cohesion rolling)
    if(NOT EXISTS ${LIGGGHTS_INCLUDE_DIR}/style_${_name}_model.h)
      file(WRITE ${_made}/style_${_name}_model.h "")
    endif()
  endforeach()
  add_library(LIGGGHTS::liggghts UNKNOWN IMPORTED)
  set_target_properties(LIGGGHTS::liggghts PROPERTIES
    IMPORTED_LOCATION ${LIGGGHTS_LIBRARY}
    INTERFACE_INCLUDE_DIRECTORIES "${LIGGGHTS_INCLUDE_DIR};${_made}")
  unset(_made)
endif()
