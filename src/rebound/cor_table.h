/* Tables of coefficients of restitution: internals beyond those in asperity.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_REBOUND_COR_TABLE_H
#define ASP_REBOUND_COR_TABLE_H

#include "asperity.h"

typedef struct aspi_cor_point {
  double speed, alpha1; /* >= 0; 0 to pi/2 */
  double cor_n, cor_t;  /* >= 0; any sign. Together they make no energy */
} aspi_cor_point;

/* A table of points in any order: at least two angles, every angle at every speed, each once. NULL
 * on error: ASP_EARG for a point out of range, ASP_EDATA for two points in one place or a gap. */
asp_cor_table *aspi_cor_table_create(const aspi_cor_point *points, size_t count, asp_error *error);

/* The coefficients at a speed and an impact angle (rad). No allocation, no failure. */
void aspi_cor_table_at(const asp_cor_table *table, double speed, double alpha1, double *cor_n,
                       double *cor_t);

#endif
