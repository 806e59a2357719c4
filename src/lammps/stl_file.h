/* Triangles from an STL file, text or binary.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_LAMMPS_STL_H
#define ASPERITY_LAMMPS_STL_H

#include <functional>
#include <string>

#include "contact/contact.h"

namespace asperity {

/* Calls `take` for each triangle of the file, in its order; those of several solids one after the
 * other. The normals that a file states are not used. Throws an Error that names the file, the line
 * (or, of a binary file, the triangle), what stands there, and what must. */
void read_stl(const std::string &path, const std::function<void(const ContactTriangle &)> &take);

} // namespace asperity

#endif
