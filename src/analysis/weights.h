/* Moments of impacts, and their weights in a fit. Each rebound is a pair of numbers (x, y); a
 * deposit has none. Means and second moments are taken about a fixed center, so that measured and
 * simulated moments have the same expectation however few impacts there are. Outliers may be cut
 * (Huber 1964). The weights are the inverse covariance of measured minus simulated moments of a
 * group of impacts, estimated from the measured impacts and the model.
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

/* Center of the moments; values below low or above high count as low or high. */
typedef struct aspi_cloud_frame {
  double center[2], low[2], high[2];
} aspi_cloud_frame;

typedef struct aspi_cloud_moments {
  double rebounds, all;
  double of[MOMENTS];                  /* NAN without rebounds, but for the share of deposits */
  double covariance[MOMENTS][MOMENTS]; /* of one rebound's terms; nothing of the deposits */
} aspi_cloud_moments;

/* A frame about that center, with nothing cut. */
aspi_cloud_frame aspi_cloud_frame_at(double x, double y);

/* Cuts at the median plus and minus `widths` robust standard deviations (1.4826 of the median
 * absolute deviation) of a cloud; `room` has 2 numbers a rebound. */
void aspi_cloud_frame_cut(aspi_cloud_frame *frame, const aspi_cloud *cloud, double widths,
                          double *room);

aspi_cloud_moments aspi_cloud_moments_of(const aspi_cloud *cloud, const aspi_cloud_frame *frame);

/* Measurements at one place or at several close ones: single impacts, or their means. */
typedef struct aspi_group {
  aspi_cloud impacts;           /* xy NULL: means */
  double mean[2], sd[2], se[2]; /* of means: x and y; NAN where not known. Of impacts, the first two
                                   are filled in */
  double n;                     /* impacts; of means 1 where not known */
  bool used[MOMENTS];
  bool by_data; /* the errors of the means are given and taken as they are */
} aspi_group;

/* WEIGHTS_BOTH: a mixture of data and model; WEIGHTS_MODEL: the model alone; WEIGHTS_DATA: the data
 * alone, for a model that does not scatter. */
typedef enum aspi_weights_kind { WEIGHTS_BOTH, WEIGHTS_MODEL, WEIGHTS_DATA } aspi_weights_kind;

typedef struct aspi_weights {
  aspi_cloud_frame frame;
  aspi_cloud_moments data;        /* in that frame */
  int n, of[MOMENTS];             /* the moments that are used */
  double lower[MOMENTS][MOMENTS]; /* Cholesky factor of their covariance */
  double whitened[MOMENTS]
                 [MOMENTS]; /* that covariance without its ridge, by the factor: nearly 1 */
  double log_determinant;
} aspi_weights;

/* Moments of measured impacts or means in a frame, with the covariance of one impact. */
aspi_cloud_moments aspi_group_moments(const aspi_group *group, const aspi_cloud_frame *frame);

/* Sets the weights from the frame and the measured and simulated moments in it; `pooled` is the
 * covariance of all groups' impacts, for groups with few of them. */
void aspi_weights_set(aspi_weights *w, const aspi_group *group, const aspi_cloud_moments *model,
                      double (*pooled)[MOMENTS], aspi_weights_kind kind);

/* Whitens the differences of the used moments: independent, variance 1. */
void aspi_weights_apply(const aspi_weights *w, const double model[MOMENTS], double *out);

#endif
