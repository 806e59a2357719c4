/* Heights that may stand for missing ones; see read.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/tolerances.h"
#include "readers/read.h"

#include <math.h>

/* Marks that instruments write for missing heights. */
static const double known[] = {999,   999.9, 9999,  9999.9, 99999, 999999,
                               32767, 32768, 65535, 1e10,   1e30,  1e38};

/* A height this many ranges of all others away from them may be a mark. */
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
  } else if (fabs(height) > fabs(m->mark)) {
    m->mark = height;
    m->line = line;
  }
  return height;
}

asp_code aspi_missing_check(const aspi_missing *m, const char *path, asp_error *error) {
  double range = m->most - m->least;
  bool off = m->mark < m->least - OFF * range || m->mark > m->most + OFF * range;
  if (m->count == 0 || !(fabs(m->mark) > 0) || !off)
    return ASP_OK;
  return aspi_file_fail(path, m->line, error,
                        "height %.10g beside heights of %g to %g: is it a mark for a missing "
                        "height? If so: asperity surface --missing %.10g",
                        m->mark, m->least, m->most, m->mark);
}
