/* An STL file, read as a stream, a triangle at a time. The format is that of 3D Systems'
 * StereoLithography Interface Specification (1988): text in words, or 80 bytes of any text, the
 * number of triangles, and 50 bytes for each. Normals and colors are not used; the solids of a file
 * are one mesh.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity.h"
#include "contact/contact.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Takes the next triangle; false when out of memory. */
typedef bool aspi_stl_taker(void *to, const ContactTriangle *triangle);

/* Gives the triangles of a file in its order, one or more. ASP_EFILE, ASP_EDATA, ASP_ENOMEM. */
asp_code aspi_stl_read(const char *path, aspi_stl_taker *take, void *to, asp_error *error);

#ifdef __cplusplus
}
#endif
