/* Heights that may stand for missing ones; see read.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/read.h"
#include "base/error.h"
#include "base/tolerances.h"

#include <math.h>

/* Heights that instruments write where they have none. */
static const double known[] = {999,   999.9, 9999,  9999.9, 99999, 999999,
                               32767, 32768, 65535, 1e10,   1e30,  1e38};

/* A mark is suspect where it lies this many times the range of all others outside of it. */
#define OFF 10

static bool is_known(double height) {
  for (size_t i = 0; i < sizeof known / sizeof *known; i++)
    if (fabs(fabs(height) - known[i]) <= 1e-7 * known[i]) /* as single precision has it, too */
      return true;
  return false;
}

double aspi_missing_note(aspi_missing *m, double height, size_t line) {
  if (!isfinite(height) || fabs(height - m->stated) <= ASPI_ROUNDING_TEXT * fabs(m->stated))
    return NAN;
  if (!is_known(height)) {
    m->least = m->count ? fmin(m->least, height) : height;
    m->most = m->count ? fmax(m->most, height) : height;
    m->count++;
  } else if (m->marks == 0 || fabs(height) > fabs(m->mark)) {
    m->mark = height;
    m->marks = 1;
    m->line = line;
  } else {
    m->marks += fabs(height - m->mark) <= 0;
  }
  return height;
}

asp_code aspi_missing_check(const aspi_missing *m, const char *path, asp_error *error) {
  double range = m->most - m->least;
  bool off = m->mark < m->least - OFF * range || m->mark > m->most + OFF * range;
  if (m->count == 0 || m->marks == 0 || !off)
    return ASP_OK;
  return aspi_fail(error, ASP_EDATA,
                   "%.200s:%zu: height %.10g, %zu times, beside heights of %g to %g: does it stand "
                   "for a missing one? Say so (asperity surface --missing %.10g), or mend the file",
                   path, m->line, m->mark, m->marks, m->least, m->most, m->mark);
}
