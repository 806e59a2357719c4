# The target asperity_dem, shared by the walls of all engines: C++11 with MPI, nothing of an engine in it. Paths are those
# in src, or in the folder that is installed for the plugin (plugin/CMakeLists.txt).
# SPDX-License-Identifier: GPL-3.0-or-later

# base: in a shared library the core keeps it to itself.
add_library(asperity_dem STATIC
  base/error.c
  base/number.c
  contact/stl.c
  contact/tree.c
  contact/tree_sweep.c
  contact/triangle.c
  dem/books/books.cpp
  dem/books/ledger.cpp
  dem/books/ledger_file.cpp
  dem/books/record.cpp
  dem/engine.cpp
  dem/model.cpp
  dem/model_report.cpp
  dem/setup.cpp
  dem/shapes/mesh.cpp
  dem/shapes/mesh_carry.cpp
  dem/shapes/mesh_images.cpp
  dem/shapes/motion.cpp
  dem/shapes/node_tree.cpp
  dem/shapes/primitive.cpp
  dem/step/ahead.cpp
  dem/step/bodies.cpp
  dem/step/end_step.cpp
  dem/step/energy.cpp
  dem/step/faces.cpp
  dem/step/flight.cpp
  dem/step/meet.cpp
  dem/step/memory.cpp
  dem/step/mover.cpp
  dem/step/screen.cpp
  dem/step/search.cpp
  dem/step/contact_point.cpp
  dem/step/step.cpp
  dem/step/population.cpp
  dem/step/stick.cpp
  dem/step/sustained.cpp
  dem/step/held.cpp
  dem/text.cpp
  dem/wall.cpp)
# Position-independent for a plugin, but nothing in it is replaced at run time: calls may be inlined. The files of a
# step are compiled as one for the same reason.
set_target_properties(asperity_dem PROPERTIES POSITION_INDEPENDENT_CODE ON UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
target_compile_options(asperity_dem PRIVATE -fno-semantic-interposition)
set_source_files_properties(dem/step/ahead.cpp dem/step/end_step.cpp dem/step/energy.cpp dem/step/faces.cpp
  dem/step/flight.cpp dem/step/mover.cpp dem/shapes/primitive.cpp dem/step/screen.cpp dem/step/search.cpp dem/step/contact_point.cpp
  dem/step/meet.cpp dem/step/step.cpp dem/step/sustained.cpp dem/step/held.cpp dem/books/books.cpp PROPERTIES UNITY_GROUP step)
target_link_libraries(asperity_dem PUBLIC asperity MPI::MPI_CXX PRIVATE asperity_flags)
