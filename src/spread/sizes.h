/* The diameters that a wall is prepared for.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"
#include "base/stream.h"

/* `bins` diameters from least to most at equal ratios; one bin is their geometric mean.
 * 0 < least <= most, 1 <= bins <= ASP_BINS_MAX. */
typedef struct aspi_sizes {
  double least, most;
  int bins;
} aspi_sizes;

/* ASP_OK, or ASP_EARG and a message. */
asp_code aspi_sizes_check(const aspi_sizes *sizes, asp_error *error);

double aspi_sizes_at(const aspi_sizes *sizes, int bin); /* the diameter of a bin */

/* One of the two bins around a diameter, the nearer one more often. */
int aspi_sizes_draw(const aspi_sizes *sizes, double d_p, aspi_stream *stream);

/* The nearest bin. */
int aspi_sizes_nearest(const aspi_sizes *sizes, double d_p);
