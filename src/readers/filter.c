/* The noise filter lambda_s of instruments: a Gaussian filter of ISO 16610-21. Weights are
 * normalized over the part within the profile, so that its ends are not drawn to zero.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "readers/read.h"
#include "surface/heights.h"

#include <math.h>
#include <stdlib.h>

/* At the cut-off half of an amplitude passes: alpha^2 = ln 2/pi. */
#define ALPHA 0.46971863934982566

/* One complex transform filters both: heights in the real part, weights (1 within the profile) in
 * the imaginary one. */
asp_code aspi_filter(double *heights, size_t points, double spacing, double lambda_s,
                     asp_error *error) {
  double least = 2 * spacing, most = (double)points * spacing;
  if (!(lambda_s >= least && lambda_s <= most))
    return aspi_fail(error, ASP_EARG,
                     "lambda_s is %g m; for this profile it must be %g m (two points) to %g m (its "
                     "length)",
                     lambda_s, least, most);
  size_t n = aspi_power_of_two(points + (size_t)fmin(2 * lambda_s / spacing + 2, 1e9));
  double *data = calloc(2 * n, sizeof *data);
  if (!data)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a filter over %zu points", points);
  for (size_t i = 0; i < points; i++) {
    data[2 * i] = heights[i];
    data[2 * i + 1] = 1;
  }
  aspi_smooth(data, n, spacing, ALPHA * lambda_s);
  for (size_t i = 0; i < points; i++)
    heights[i] = data[2 * i] / data[2 * i + 1];
  free(data);
  return ASP_OK;
}
