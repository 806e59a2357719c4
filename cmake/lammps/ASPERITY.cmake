# The wall itself is in an installed library: its engine side, asperity_dem, and the core behind it.
# SPDX-License-Identifier: GPL-3.0-or-later
if(PKG_ASPERITY)
  find_package(asperity REQUIRED COMPONENTS dem)
  if(BUILD_MPI AND asperity_MPI_STUBS)
    message(FATAL_ERROR "This asperity is for a LAMMPS without MPI: build it without ASPERITY_MPI_STUBS")
  elseif(NOT BUILD_MPI AND NOT asperity_MPI_STUBS)
    message(FATAL_ERROR "This asperity is for a LAMMPS with MPI; for BUILD_MPI=off build and install it with "
      "-DASPERITY_MPI_STUBS=${LAMMPS_SOURCE_DIR}/STUBS -DASPERITY_LIGGGHTS=OFF -DASPERITY_LAMMPS=OFF -DASPERITY_TESTS=OFF")
  endif()
  target_link_libraries(lammps PRIVATE asperity::asperity_dem)
endif()
