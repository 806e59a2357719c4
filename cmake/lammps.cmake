# The side of LAMMPS: its sources, for launcher and plugin, and the plugin. Paths are those in src, or in the folder that is
# installed for the plugin (plugin/CMakeLists.txt).
# SPDX-License-Identifier: GPL-3.0-or-later
set(lammps_sources
  lammps/bodies_lammps.cpp
  lammps/driven_mesh.cpp
  lammps/engine_lammps.cpp
  lammps/fix_wall_rebound.cpp
  lammps/map_file.cpp
  lammps/region_part.cpp
  lammps/region_search.cpp
  lammps/region_shape.cpp)

# The plugin, for LAMMPS with its package PLUGIN: against the headers of that LAMMPS's source tree; and what LAMMPS
# loads of it first, which needs none of them.
if(ASPERITY_LAMMPS_SOURCE)
  add_library(wallreboundplugin MODULE lammps/plugin.cpp)
  add_library(wallreboundstyle MODULE lammps/plugin_style.cpp lammps/library_check.cpp ${lammps_sources})
  add_dependencies(wallreboundplugin wallreboundstyle)
  target_include_directories(wallreboundstyle PRIVATE ${ASPERITY_LAMMPS_SOURCE}/src ${ASPERITY_LAMMPS_SOURCE}/src/RIGID)
  target_link_libraries(wallreboundplugin PRIVATE asperity_flags ${CMAKE_DL_LIBS})
  target_link_libraries(wallreboundstyle PRIVATE asperity_dem asperity_flags MPI::MPI_CXX)
  # Its own functions, also in a LAMMPS that has the style already.
  target_link_options(wallreboundstyle PRIVATE -Wl,-Bsymbolic)
  foreach(part wallreboundplugin wallreboundstyle)
    target_compile_definitions(${part} PRIVATE LAMMPS_${ASPERITY_LAMMPS_SIZES}
      ASPERITY_LAMMPS_VERSION=${ASPERITY_LAMMPS_SOURCE_VERSION})
    set_target_properties(${part} PROPERTIES PREFIX "" CXX_STANDARD 17
      LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
  endforeach()
endif()
