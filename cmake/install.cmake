# Files of `cmake --install`: library, header, command, launchers, plugins, the files by which CMake
# and pkg-config find the library, pages and examples. Components are named as the packages (package.cmake).
# SPDX-License-Identifier: GPL-3.0-or-later
set(CMAKE_INSTALL_DEFAULT_COMPONENT_NAME asperity)
install(TARGETS asperity EXPORT asperityTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libasperity-dev
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} NAMELINK_COMPONENT libasperity-dev
  PUBLIC_HEADER DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT libasperity-dev)
if(NOT BUILD_SHARED_LIBS) # without libasperity.so, which the linker would take in place of libasperity.a
  install(TARGETS asperity_shared LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} NAMELINK_SKIP)
endif()
install(DIRECTORY src/python DESTINATION ${CMAKE_INSTALL_LIBDIR}/asperity COMPONENT pip PATTERN __pycache__ EXCLUDE)
install(TARGETS asperity_command RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(ASPERITY_LIGGGHTS)
  install(TARGETS liggghts-asperity RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT asperity-liggghts)
endif()
if(ASPERITY_LAMMPS)
  install(TARGETS lammps-asperity RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT lammps)
endif()

if(TARGET asperityWall)
  install(TARGETS asperityWall LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT asperity-openfoam)
endif()

# What LAMMPS loads, both in one folder.
if(TARGET wallreboundplugin)
  install(TARGETS wallreboundplugin wallreboundstyle LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT lammps)
endif()

install(DIRECTORY ${CMAKE_BINARY_DIR}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1
  OPTIONAL FILES_MATCHING PATTERN "*.1")
install(DIRECTORY src/cli/plot DESTINATION ${CMAKE_INSTALL_DATADIR}/asperity)
install(FILES examples/look.gp DESTINATION ${CMAKE_INSTALL_DATADIR}/asperity/plot)
install(FILES src/cli/asperity.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions
  RENAME asperity)

# Pages and examples in the folders that they have here, so that their links hold.
file(GLOB_RECURSE _pages CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} src/*.md src/*.rst
  src/*.png src/*.svg cmake/*.md .github/*.md tests/bench/*.md
  tests/sweep/*.md)
foreach(_page IN LISTS _pages ITEMS README.md LICENSE CITATION.cff
    LICENSES/BSD-3-Clause.txt LICENSES/MIT.txt cmake/Random123.LICENSE)
  get_filename_component(_folder ${_page} DIRECTORY)
  install(FILES ${_page} DESTINATION ${CMAKE_INSTALL_DOCDIR}/${_folder})
endforeach()
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DOCDIR} USE_SOURCE_PERMISSIONS
  PATTERN output EXCLUDE)

# What the plugin for LAMMPS is built from, which only its users may build (LICENSING.md).
set(_plugin ${CMAKE_INSTALL_DATADIR}/asperity/plugin)
install(DIRECTORY src/base src/contact src/dem src/lammps DESTINATION ${_plugin} COMPONENT libasperity-dev
  FILES_MATCHING PATTERN "*.h" PATTERN "*.cpp" PATTERN "*/contact/*.c" PATTERN "*/base/error.c" PATTERN "*/base/number.c"
  PATTERN debian EXCLUDE)
install(FILES cmake/plugin/CMakeLists.txt DESTINATION ${_plugin} COMPONENT libasperity-dev)
install(FILES cmake/dem.cmake cmake/flags.cmake cmake/lammps.cmake cmake/lammps_version.cmake DESTINATION ${_plugin}/cmake
  COMPONENT libasperity-dev)
unset(_plugin)

# What a program links besides: nothing with the shared library.
set(ASPERITY_DEPENDENCIES)
set(ASPERITY_PC_REQUIRES)
if(NOT BUILD_SHARED_LIBS)
  set(ASPERITY_DEPENDENCIES GSL)
  set(ASPERITY_PC_REQUIRES "Requires: gsl")
  if(ASPERITY_X3P)
    set(ASPERITY_DEPENDENCIES GSL libzip EXPAT)
    set(ASPERITY_PC_REQUIRES "Requires: gsl, libzip, expat")
  endif()
endif()
set(_package ${CMAKE_INSTALL_LIBDIR}/cmake/asperity)
install(EXPORT asperityTargets NAMESPACE asperity:: DESTINATION ${_package} COMPONENT libasperity-dev)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/asperityConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/asperityConfig.cmake INSTALL_DESTINATION ${_package})
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/asperityConfigVersion.cmake
  COMPATIBILITY SameMajorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/asperityConfig.cmake ${CMAKE_CURRENT_LIST_DIR}/Findlibzip.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/asperityConfigVersion.cmake DESTINATION ${_package} COMPONENT libasperity-dev)
unset(_package)

# The .pc file finds the prefix from where it lies, so that `cmake --install --prefix` may move it.
file(RELATIVE_PATH ASPERITY_PC_TO_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
configure_file(${CMAKE_CURRENT_LIST_DIR}/asperity.pc.in ${CMAKE_CURRENT_BINARY_DIR}/asperity.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/asperity.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT libasperity-dev)

if(PROJECT_IS_TOP_LEVEL)
  add_custom_target(uninstall
    COMMAND ${CMAKE_COMMAND} -DMANIFEST=${CMAKE_BINARY_DIR}/install_manifest.txt
      -P ${CMAKE_CURRENT_LIST_DIR}/uninstall.cmake
    COMMENT "Taking away what was installed" VERBATIM)
endif()
