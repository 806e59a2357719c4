/* Moments of impacts: each rebound is a pair of numbers (x, y); a deposit has none. Means and
 * second moments are taken about a fixed center, so that measured and simulated moments have the
 * same expectation however few impacts there are. Outliers may be cut (Huber 1964).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_MOMENTS_H
#define ASP_ANALYSIS_MOMENTS_H

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

#endif
