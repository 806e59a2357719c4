/* Moments of impacts, and their weights in a fit. Each rebound is a pair of numbers (x, y); a
 * deposit has none. Means and second moments are taken about a fixed center, so that measured and
 * simulated moments have the same expectation however few impacts there are. The weights are the
 * inverse covariance of measured minus simulated moments of a group of impacts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_WEIGHTS_H
#define ASP_ANALYSIS_WEIGHTS_H

#include <stdbool.h>
#include <stddef.h>

enum { MOMENT_X, MOMENT_Y, MOMENT_XX, MOMENT_YY, MOMENT_XY, MOMENT_STUCK, MOMENTS };

typedef struct aspi_cloud {
  double (*xy)[2]; /* of the rebounds */
  size_t rebounds, deposits;
} aspi_cloud;

typedef struct aspi_cloud_moments {
  double rebounds, all;
  double of[MOMENTS];                  /* NAN without rebounds, but for the share of deposits */
  double covariance[MOMENTS][MOMENTS]; /* of one rebound's terms; nothing of the deposits */
} aspi_cloud_moments;

aspi_cloud_moments aspi_cloud_moments_of(const aspi_cloud *cloud, const double center[2]);

/* Measurements at one place or at several close ones: single impacts, or their means. */
typedef struct aspi_group {
  aspi_cloud impacts;           /* xy NULL: means */
  double mean[2], sd[2], se[2]; /* of means: x and y; NAN where not known. Of impacts, the first two
                                   are filled in */
  double n;                     /* impacts; of means 1 where not known */
  bool used[MOMENTS];
  bool by_data; /* the errors of the means are given and taken as they are */
} aspi_group;

typedef struct aspi_weights {
  double center[2];
  aspi_cloud_moments data;           /* about it */
  int n, of[MOMENTS];                /* the moments that are used */
  double lower[MOMENTS][MOMENTS];    /* Cholesky factor of their covariance and a ridge */
  double whitened[MOMENTS][MOMENTS]; /* that covariance, by the factor: nearly 1 */
  double log_determinant;
} aspi_weights;

/* Moments of measured impacts or means about a center, with the covariance of one impact. */
aspi_cloud_moments aspi_group_moments(const aspi_group *group, const double center[2]);

/* Sets the weights from the covariance of the model's impacts. model NULL: from that of the data;
 * `pooled` is then the covariance of all groups' impacts, for groups with few of them. */
void aspi_weights_set(aspi_weights *w, const aspi_group *group, const aspi_cloud_moments *model,
                      double (*pooled)[MOMENTS]);

/* Whitens the differences of the used moments: independent, variance 1. */
void aspi_weights_apply(const aspi_weights *w, const double model[MOMENTS], double *out);

#endif
