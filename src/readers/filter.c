/* Filters that instruments apply to a profile before they state a roughness: the stylus tip taken
 * out, the noise filter lambda_s, and the waviness filter (cut-off). They are Gaussian filters of
 * ISO 16610-21. Weights are normalized over the part within the profile, so that its ends are not
 * drawn to zero. A tip of radius r has measured the dilation of the surface; the best estimate of
 * the surface is the erosion of that dilation (Villarrubia 1997).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/read.h"
#include "base/error.h"
#include "surface/rolling.h"

#include <math.h>
#include <stdlib.h>

/* At the cut-off half of an amplitude passes: alpha^2 = ln 2/pi. */
#define ALPHA 0.46971863934982566

/* Subtracts waves beyond the cut-off from the heights, or with `keep` keeps only these. One complex
 * transform filters both: heights in the real part, weights (1 within the profile) in the imaginary
 * one. */
static asp_code filter(double *heights, size_t points, double spacing, double cutoff, bool keep,
                       asp_error *error) {
  size_t n = aspi_power_of_two(points + (size_t)fmin(2 * cutoff / spacing + 2, 1e9));
  double *data = calloc(2 * n, sizeof *data);
  if (!data)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for a filter over %zu points", points);
  for (size_t i = 0; i < points; i++) {
    data[2 * i] = heights[i];
    data[2 * i + 1] = 1;
  }
  aspi_smooth(data, n, spacing, ALPHA * cutoff);
  for (size_t i = 0; i < points; i++) {
    double line = data[2 * i] / data[2 * i + 1];
    heights[i] = keep ? line : heights[i] - line;
  }
  free(data);
  return ASP_OK;
}

/* Erodes what a tip of radius r has dilated: r minus the dilation of the surface upside down. */
static asp_code take_out_tip(double *heights, size_t points, double spacing, double radius,
                             asp_error *error) {
  for (size_t i = 0; i < points; i++)
    heights[i] = -heights[i];
  asp_heights below = {points, 1, {spacing, spacing}, false, heights};
  asp_heights *path = aspi_profile_rolled(&below, 2 * radius, 1, error);
  for (size_t i = 0; path && i < points; i++)
    heights[i] = radius - path->z[i];
  asp_heights_free(path);
  return path ? ASP_OK : ASP_ENOMEM;
}

static asp_code check(const char *name, double length, double least, double most,
                      asp_error *error) {
  if (!(length > 0) || (length >= least && length <= most))
    return ASP_OK;
  return aspi_fail(error, ASP_EARG,
                   "%s is %g m; for this profile it must be %g m (two points) to %g m (its length)",
                   name, length, least, most);
}

asp_code aspi_filter(double *heights, size_t points, double spacing, const aspi_filters *filters,
                     asp_error *error) {
  double least = 2 * spacing, most = (double)points * spacing;
  asp_code code = ASP_OK;
  if ((code = check("tip", filters->tip, 0.5 * spacing, 0.5 * most, error)) ||
      (code = check("lambda_s", filters->lambda_s, least, most, error)) ||
      (code = check("cutoff", filters->cutoff, least, most, error)))
    return code;
  if (filters->lambda_s > 0 && filters->cutoff > 0 && filters->lambda_s >= filters->cutoff)
    return aspi_fail(error, ASP_EARG, "lambda_s is %g m; it must be less than the cutoff, %g m",
                     filters->lambda_s, filters->cutoff);
  if (filters->tip > 0)
    code = take_out_tip(heights, points, spacing, filters->tip, error);
  if (!code && filters->lambda_s > 0)
    code = filter(heights, points, spacing, filters->lambda_s, true, error);
  if (!code && filters->cutoff > 0)
    code = filter(heights, points, spacing, filters->cutoff, false, error);
  return code;
}
