/* The diameters that a wall is prepared for; see sizes.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/sizes.h"
#include "base/error.h"

#include <math.h>

double aspi_sizes_at(const aspi_sizes *sizes, int bin) {
  double span = log(sizes->most / sizes->least);
  return sizes->least * exp(span * (sizes->bins > 1 ? bin / (sizes->bins - 1.) : 0.5));
}

/* Where a diameter is among the bins: 0 at the first. */
static double place_of(const aspi_sizes *sizes, double d_p) {
  double span = log(sizes->most / sizes->least);
  if (sizes->bins < 2 || !(span > 0))
    return 0;
  return fmin(fmax(log(d_p / sizes->least) / span, 0), 1) * (sizes->bins - 1);
}

int aspi_sizes_draw(const aspi_sizes *sizes, double d_p, aspi_stream *stream) {
  if (sizes->bins < 2 || !(sizes->most > sizes->least))
    return 0;
  double at = place_of(sizes, d_p), below = floor(at);
  return (int)below + (aspi_stream_uniform(stream) < at - below);
}

int aspi_sizes_nearest(const aspi_sizes *sizes, double d_p) {
  return (int)lround(place_of(sizes, d_p));
}

asp_code aspi_sizes_check(const aspi_sizes *sizes, asp_error *error) {
  asp_code code = aspi_check_length(error, "least d_p", sizes->least);
  if (!code)
    code = aspi_check_length(error, "largest d_p", sizes->most);
  if (!code)
    code = aspi_check_range(error, "largest d_p", "", sizes->most, sizes->least, INFINITY);
  if (!code && !(sizes->bins >= 1 && sizes->bins <= ASP_BINS_MAX))
    code = aspi_fail(error, ASP_EARG, "bins of d_p are %d; they must be 1 to %d", sizes->bins,
                     (int)ASP_BINS_MAX);
  return code;
}
