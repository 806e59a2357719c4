# OpenFOAM, for the patch interaction model: the target OpenFOAM::intermediate, OPENFOAM_API, as 1912 or 13,
# OPENFOAM_CXX_STANDARD, as 11, and OPENFOAM_CLOUDS. Headers by openfoam_headers; libraries of the system or, of another
# OpenFOAM, where its environment has them (FOAM_LIBBIN).
# SPDX-License-Identifier: GPL-3.0-or-later
set(_dir ${CMAKE_BINARY_DIR}/openfoam)
set(_tree ${ASPERITY_OPENFOAM_SOURCE})
if(NOT _tree)
  set(_tree ${_dir}/source)
endif()
if(NOT EXISTS ${_dir}/host OR NOT _tree STREQUAL ASPERITY_OPENFOAM_TREE)
  message(STATUS "OpenFOAM's headers: ${_tree}")
  execute_process(COMMAND ${CMAKE_CURRENT_LIST_DIR}/openfoam_headers ${_dir} ${ASPERITY_OPENFOAM_SOURCE}
    RESULT_VARIABLE _failed)
  if(_failed)
    message(FATAL_ERROR "OpenFOAM's headers were not found, see above")
  endif()
  set(ASPERITY_OPENFOAM_TREE ${_tree} CACHE INTERNAL "Source tree of the headers that are linked")
endif()

file(STRINGS ${_dir}/host _host)
list(GET _host 0 OPENFOAM_API)
list(GET _host 1 OPENFOAM_CXX_STANDARD)
list(GET _host 2 _library)
list(GET _host 3 OPENFOAM_CLOUDS)
separate_arguments(OPENFOAM_CLOUDS)
find_library(OPENFOAM_INTERMEDIATE ${_library} HINTS ENV FOAM_LIBBIN PATHS /usr/lib REQUIRED)
mark_as_advanced(OPENFOAM_INTERMEDIATE)
set(_label $ENV{WM_LABEL_SIZE})
if(NOT _label)
  set(_label 32)
endif()
set(_precision $ENV{WM_PRECISION_OPTION})
if(NOT _precision)
  set(_precision DP)
endif()

file(GLOB_RECURSE _headers LIST_DIRECTORIES true ${_dir}/include/*)
list(FILTER _headers EXCLUDE REGEX "\\.([HC]|txx)$")
add_library(OpenFOAM::intermediate SHARED IMPORTED)
set_target_properties(OpenFOAM::intermediate PROPERTIES
  IMPORTED_LOCATION ${OPENFOAM_INTERMEDIATE}
  INTERFACE_INCLUDE_DIRECTORIES "${_headers}"
  INTERFACE_COMPILE_DEFINITIONS "OPENFOAM=${OPENFOAM_API};WM_${_precision};WM_LABEL_SIZE=${_label};NoRepository")
