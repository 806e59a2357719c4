/* A map in numbers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SURFACE_MAP_DESCRIBE_H
#define ASP_SURFACE_MAP_DESCRIBE_H

#include "surface/map.h"

/* The parameters are those of ISO 25178-2, of the map as it is, without a filter. */
typedef struct aspi_map_description {
  double s_q, s_a;           /* rms and mean absolute height */
  double s_sk, s_ku;         /* skewness, kurtosis (3 for a normal law) */
  double s_p, s_v, s_z;      /* highest peak, deepest valley, both together */
  double s_dq;               /* rms gradient */
  double s_al, s_tr;         /* shortest way to the autocorrelation 0.2; that over the longest */
  double lambda_1, lambda_2; /* the half axes of the 1/e contour, lambda_1 <= lambda_2 */
  double lay;                /* the direction of the longer one, from x toward y, 0 to pi */
  double phi_r;              /* s_q / lambda_1 */
  bool long_enough;          /* the contours close within the map */
} aspi_map_description;

/* Describes a map; ASP_EDATA when it is constant, or too small for its autocorrelation to fall to
 * 1/e in any direction. Where it falls along some directions only, the ellipse is that of these,
 * and s_tr is not a number. */
asp_code aspi_map_describe(const asp_map *map, aspi_map_description *description, asp_error *error);

/* The rms and the skewness of n gradients p, q to the right of the lay and along it; mixed: the
 * mean of the product of the slopes to the left of it and along it. */
void aspi_gradient_describe(const float *p, const float *q, size_t n, double lay, double rms[2],
                            double skewness[2], double *mixed);

/* ASP_EDATA for what cannot be roughness: noise, and phi_r over its most. */
asp_code aspi_map_check(const asp_map *map, const aspi_map_description *d, double phi_r_most,
                        asp_error *error);

#endif
