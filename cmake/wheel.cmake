# The target `wheel`: a file for pip in the build folder, with a library that has GSL and Expat inside. Nothing else is
# built of it; it is not there without the static libraries (Debian's libgsl-dev and libexpat1-dev have them).
# SPDX-License-Identifier: GPL-3.0-or-later
set(_libraries gsl gslcblas)
if(ASPERITY_X3P)
  list(APPEND _libraries expat)
endif()
set(_static)
foreach(_name IN LISTS _libraries)
  find_library(ASPERITY_STATIC_${_name} lib${_name}.a)
  mark_as_advanced(ASPERITY_STATIC_${_name})
  if(NOT ASPERITY_STATIC_${_name} OR NOT CMAKE_OBJCOPY)
    message(STATUS "No target wheel: lib${_name}.a was not found")
    return()
  endif()
  set(_copy ${CMAKE_BINARY_DIR}/wheel/lib${_name}.a)
  add_custom_command(OUTPUT ${_copy} VERBATIM
    COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/wheel
    COMMAND ${CMAKE_OBJCOPY} --redefine-sym stdout=asperity_stdout --redefine-sym stderr=asperity_stderr
      ${ASPERITY_STATIC_${_name}} ${_copy})
  list(APPEND _static ${_copy})
endforeach()

add_library(asperity_wheel SHARED EXCLUDE_FROM_ALL $<TARGET_OBJECTS:asperity_core> ${CMAKE_CURRENT_LIST_DIR}/wheel.c
  ${_static})
target_link_libraries(asperity_wheel PRIVATE asperity_flags ${_static} m)
if(ASPERITY_X3P)
  target_link_libraries(asperity_wheel PRIVATE libzip::zip)
endif()
get_target_property(_shared asperity_shared ALIASED_TARGET)
if(NOT _shared)
  set(_shared asperity_shared)
endif()
target_link_options(asperity_wheel PRIVATE -Wl,--gc-sections -s $<TARGET_PROPERTY:${_shared},LINK_OPTIONS>)
set_target_properties(asperity_wheel PROPERTIES OUTPUT_NAME asperity VERSION ${PROJECT_VERSION}
  SOVERSION ${PROJECT_VERSION_MAJOR} LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/wheel)
add_custom_target(wheel
  COMMAND ${CMAKE_CURRENT_LIST_DIR}/wheel $<TARGET_SONAME_FILE:asperity_wheel> ${CMAKE_BINARY_DIR} VERBATIM)
