/* The filters of instruments; see filter.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_READERS_FILTER_H
#define ASP_READERS_FILTER_H

#include "asperity.h"

/* Lengths in m; 0: that one is left out. They work in this order. */
typedef struct aspi_filters {
  double tip;      /* radius of the stylus */
  double lambda_s; /* shorter waves are taken out, */
  double cutoff;   /* and longer ones (lambda_c of ISO 21920-3, not the correlation length) */
  bool robust;     /* the cut-off is not drawn toward deep valleys and high peaks */
} aspi_filters;

/* Filters heights at equal spacing, in place. ASP_EARG where a length does not fit the profile. */
asp_code aspi_filter(double *heights, size_t points, double spacing, const aspi_filters *filters,
                     asp_error *error);

#endif
