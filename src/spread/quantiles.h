/* Quantiles of a distribution at fixed shares, as one row of a table.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_SPREAD_QUANTILES_H
#define ASP_SPREAD_QUANTILES_H

#include <stddef.h>

/* The shares at the nodes of a row: `cells` of equal width. The first and the last cell are divided
 * into `parts`, for the tails; with parts 0 only the last one is divided, by halving. */
typedef struct aspi_shares {
  int cells, parts, nodes;
} aspi_shares;

#define ASPI_SHARES_NODES(cells, parts) ((cells)-2 + 2 * (parts) + 1)

/* The share at a place along a row, from 0 to nodes - 1. */
double aspi_shares_at(const aspi_shares *shares, double place);

/* Position of a share u: the node before it, 0 to nodes - 2, and the fraction of the step to the
 * next. */
typedef struct aspi_place {
  int node;
  double part;
} aspi_place;

aspi_place aspi_shares_place(const aspi_shares *shares, double u);

/* Linear interpolation of a row of nodes at a place, and at the share u. */
double aspi_quantiles_between(const float *nodes, aspi_place place);
double aspi_quantile(const aspi_shares *shares, const float *nodes, double u);

/* The share of the distribution below a value. */
double aspi_quantiles_below(const aspi_shares *shares, const float *nodes, double value);

/* Values from the least to the largest, and order[], their indices in the arrays of their weights,
 * of sum 1, and bins; total[] is the weight of each bin (bin NULL: all are in bin 0). */
typedef struct aspi_sample {
  const double *value, *weight;
  const size_t *order;
  const unsigned char *bin;
  const double *total;
  size_t n;
} aspi_sample;

enum { ASPI_SAMPLE_BINS = 16 };

/* Fills a row of quantiles for each of `bins` bins (1 to ASPI_SAMPLE_BINS), one after the other. An
 * empty bin gets the row of the bin before it; empty bins at the beginning get the first that is
 * not. */
void aspi_quantiles_fill(const aspi_shares *shares, const aspi_sample *sample, int bins,
                         float *table);

/* Places along impact angles 0 to 90 degrees with nodes at 90 degrees (k/(nodes - 1))^2, which
 * stand closer where the first hits change fast. Negative angles count as 0. */
double aspi_angle_at(int nodes, int node);
aspi_place aspi_angle_place(int nodes, double alpha1);

#endif
