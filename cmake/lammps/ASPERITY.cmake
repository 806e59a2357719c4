# The wall itself is in an installed library: its engine side, asperity_dem, and the core behind it.
# SPDX-License-Identifier: GPL-3.0-or-later
if(PKG_ASPERITY)
  find_package(asperity REQUIRED COMPONENTS dem)
  target_link_libraries(lammps PRIVATE asperity::asperity_dem)
endif()
