/* Clumps of spheres: a file of spheres, the mass and inertia of what they cover, and one of them
 * in a random position above a wall.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_CLUMP_H
#define ASP_ANALYSIS_CLUMP_H

#include "asperity.h"

/* Lengths over the diameter of the sphere of the same volume; the center of mass is 0. */
typedef struct aspi_clump {
  int count;
  double (*centers)[3], *d;
  double inertia[6]; /* over density times that diameter to the fifth: xx, yy, zz, xy, xz, yz */
} aspi_clump;

/* Reads a file with the columns x, y, z, d, in any one unit. Where spheres overlap, what they cover
 * counts once (quadrature over 400 x 400 lines, within some 1e-4). */
aspi_clump *aspi_clump_read(const char *path, asp_error *error);
void aspi_clump_free(aspi_clump *clump);

/* The clump of volume pi/6 d_p^3, turned at random by the key, as it touches the wall z = 0:
 * the body, and the diameter of its lowest sphere. */
asp_body aspi_clump_turned(const aspi_clump *clump, double d_p, double density, const asp_key *key,
                           double *d);

#endif
