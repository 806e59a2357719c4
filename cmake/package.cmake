# The packages of a Debian system, by CPack, in the build that cmake/package makes for them: each component of
# install.cmake but those of pip and LAMMPS, whose license allows none (LICENSING.md), as a package of its name.
# SPDX-License-Identifier: GPL-3.0-or-later
set(CPACK_COMPONENTS_ALL asperity libasperity-dev python3-asperity)
if(ASPERITY_LIGGGHTS)
  list(APPEND CPACK_COMPONENTS_ALL asperity-liggghts)
endif()
if(ASPERITY_OPENFOAM)
  list(APPEND CPACK_COMPONENTS_ALL asperity-openfoam)
endif()

# Python's folder, with the library beside the module.
set(_module lib/python3/dist-packages/asperity)
install(DIRECTORY src/python/asperity DESTINATION lib/python3/dist-packages COMPONENT python3-asperity
  PATTERN __pycache__ EXCLUDE)
file(RELATIVE_PATH _library /${_module} /${CMAKE_INSTALL_LIBDIR}/libasperity.so.${PROJECT_VERSION_MAJOR})
install(CODE "file(CREATE_LINK ${_library}
  \$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${_module}/libasperity.so.${PROJECT_VERSION_MAJOR} SYMBOLIC)"
  COMPONENT python3-asperity)
install(CODE "file(GLOB _pages \$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_MANDIR}/man1/*.1)
  execute_process(COMMAND gzip -9nf \${_pages} COMMAND_ERROR_IS_FATAL ANY)" COMPONENT asperity)

# What each package of Debian has: the licenses of its files, with their texts, and its history.
set(_licenses)
foreach(_name BSD-3-Clause MIT)
  file(READ LICENSES/${_name}.txt _text)
  string(REGEX REPLACE "\n$" "" _text "${_text}")
  string(REGEX REPLACE "\n\n+" "\n.\n" _text "${_text}")
  string(REPLACE "\n" "\n " _text "${_text}")
  string(APPEND _licenses "\nLicense: ${_name}\n ${_text}\n")
endforeach()
file(READ .reuse/dep5 _files)
file(WRITE ${CMAKE_BINARY_DIR}/copyright "${_files}\nLicense: GPL-3.0-or-later\n"
  " On Debian the text is in /usr/share/common-licenses/GPL-3.\n${_licenses}")
string(TIMESTAMP _date "%a, %d %b %Y %H:%M:%S +0000" UTC)
file(WRITE ${CMAKE_BINARY_DIR}/changelog "asperity (${PROJECT_VERSION}) unstable; urgency=medium\n\n"
  "  * What this version can do: /usr/share/doc/asperity/.github/CHANGELOG.md.\n\n"
  " -- ${ASPERITY_PACKAGE}  ${_date}\n")
execute_process(COMMAND gzip -9nkf ${CMAKE_BINARY_DIR}/changelog COMMAND_ERROR_IS_FATAL ANY)
foreach(_package IN LISTS CPACK_COMPONENTS_ALL)
  install(FILES ${CMAKE_BINARY_DIR}/copyright ${CMAKE_BINARY_DIR}/changelog.gz DESTINATION share/doc/${_package}
    COMPONENT ${_package})
endforeach()

function(asperity_package name section depends recommends about)
  string(TOUPPER ${name} key)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_RECOMMENDS "${recommends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_DESCRIPTION
    "Particles that hit a rough wall rebound and scatter by its roughness.\n${about}" PARENT_SCOPE)
endfunction()
set(_own "asperity (= ${PROJECT_VERSION})")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "rough walls for particle simulation")
asperity_package(asperity science "" "gnuplot-nox" "The command computes coefficients of restitution, \
statistics of\nsurfaces and erosion, and compares with measurements.\nWith the library, pages and examples.")
asperity_package(libasperity-dev libdevel "${_own}" "" "Headers of the library for C and C++, files for CMake \
and pkg-config,\nand what a plugin for LAMMPS is built from.")
asperity_package(python3-asperity python "${_own}, python3, python3-numpy" "" "The module for Python computes \
impacts in NumPy arrays, and reads ledgers.")
asperity_package(asperity-liggghts science "${_own}" "openmpi-bin" "The program liggghts-asperity is LIGGGHTS with \
the fix wall/rebound.")
asperity_package(asperity-openfoam science "${_own}, openfoam" "" "The library libasperityWall.so is a patch interaction \
model for clouds\nof OpenFOAM.")

# Byte code that Python makes after the installation must go with it.
set(_scripts ${CMAKE_BINARY_DIR}/python3-asperity)
file(CONFIGURE OUTPUT ${_scripts}/postinst CONTENT "#!/bin/sh\nset -e\n[ \"$1\" != configure ] || py3compile -p python3-asperity\n")
file(CONFIGURE OUTPUT ${_scripts}/prerm CONTENT "#!/bin/sh\nset -e\npy3clean -p python3-asperity\n")
set(CPACK_DEBIAN_PYTHON3-ASPERITY_PACKAGE_CONTROL_EXTRA ${_scripts}/postinst ${_scripts}/prerm)
set(CPACK_DEBIAN_PYTHON3-ASPERITY_PACKAGE_CONTROL_STRICT_PERMISSION ON)
# A library in the linker's folder: who installs it has the linker's cache made anew.
file(WRITE ${CMAKE_BINARY_DIR}/triggers "activate-noawait ldconfig\n")
foreach(_package ASPERITY ASPERITY-OPENFOAM)
  set(CPACK_DEBIAN_${_package}_PACKAGE_CONTROL_EXTRA ${CMAKE_BINARY_DIR}/triggers)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT ${ASPERITY_PACKAGE})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
include(CPack)
