/* Heights that may stand for missing ones; see read.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/read.h"
#include "base/error.h"
#include "base/tolerances.h"

#include <math.h>

/* Heights that instruments write where they have none. */
static const double known[ASP_MISSING_KNOWN] = {-9999,  -999,   -999.9, -9999.9, 9999,  99999,
                                                -99999, 999999, -32768, 32767,   65535, 1e10,
                                                -1e10,  1e30,   -1e30,  1e38};

/* A mark is suspect where it lies this many times the range of all others outside of it. */
#define OFF 10

double aspi_missing_note(aspi_missing *marks, double height, size_t place) {
  if (!isfinite(height) || fabs(height - marks->stated) <= ASPI_ROUNDING_TEXT * fabs(marks->stated))
    return NAN;
  for (int i = 0; i < ASP_MISSING_KNOWN; i++)
    if (fabs(height - known[i]) <= 1e-7 * fabs(known[i])) { /* as single precision has it, too */
      marks->known[i].place = marks->known[i].count++ ? marks->known[i].place : place;
      return height;
    }
  marks->least = marks->count ? fmin(marks->least, height) : height;
  marks->most = marks->count ? fmax(marks->most, height) : height;
  marks->count++;
  return height;
}

asp_code aspi_missing_check(const aspi_missing *m, const char *path, asp_error *error) {
  double range = m->most - m->least;
  for (int i = 0; i < ASP_MISSING_KNOWN && m->count > 0; i++) {
    bool off = known[i] < m->least - OFF * range || known[i] > m->most + OFF * range;
    if (off && m->known[i].count > 0)
      return aspi_fail(error, ASP_EDATA,
                       "%.200s:%zu: height %.10g, %zu times, beside heights of %g to %g: does it "
                       "stand for a missing one? Say so (reader: missing %.10g), or mend the file",
                       path, m->known[i].place, known[i], m->known[i].count, m->least, m->most,
                       known[i]);
  }
  return ASP_OK;
}
