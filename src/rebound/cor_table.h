/* Tables of coefficients of restitution.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"

/* Coefficients of restitution over impact angle and speed, as measured or computed by a user: on a
 * full grid of angles and speeds. Between angles a monotone cubic (Steffen 1990), between speeds a
 * straight line, so that nothing overshoots; beyond the ends the end values. From a text file with
 * the columns alpha1_deg, cor_n, cor_t (or cor_n_mean, cor_t_mean), and v1_m_s where it depends on
 * speed. meter_per_second is one m/s in the unit of the speeds of the contacts: 1 for SI. */
typedef struct aspi_cor_table aspi_cor_table;
aspi_cor_table *aspi_cor_table_read(const char *path, double meter_per_second, asp_error *error);
void aspi_cor_table_free(aspi_cor_table *table);
aspi_cor_table *aspi_cor_table_copy(const aspi_cor_table *table); /* NULL when out of memory */

typedef struct aspi_cor_point {
  double speed, alpha1; /* >= 0; 0 to pi/2 */
  double cor_n, cor_t;  /* >= 0; any sign; together they make no energy */
} aspi_cor_point;

/* A table of points in any order: at least two angles, every angle at every speed, each once. NULL
 * on error: ASP_EDATA for two points in one place or a gap. */
aspi_cor_table *aspi_cor_table_create(const aspi_cor_point *points, size_t count, asp_error *error);

/* The coefficients at a speed and an impact angle (rad). No allocation, no failure. */
void aspi_cor_table_at(const aspi_cor_table *table, double speed, double alpha1, double *cor_n,
                       double *cor_t);
