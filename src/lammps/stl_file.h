/* Triangles from an STL file, text or binary.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_WALL_STL_H
#define ASPERITY_WALL_STL_H

#include <string>
#include <vector>

#include "contact/contact.h"

namespace asperity {

/* All triangles of the file, in its order; those of several solids one after the other. The normals
 * that a file states are not used. Throws an Error that names the file, the line (or, of a binary
 * file, the triangle), what stands there, and what must. */
std::vector<ContactTriangle> read_stl(const std::string &path);

} // namespace asperity

#endif
