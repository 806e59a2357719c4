/* Heights that may stand for missing ones; see read.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/read.h"
#include "base/error.h"

#include <math.h>

/* Heights that instruments write where they have none. */
static const double known[ASP_MISSING_KNOWN] = {-9999,  -999,   -999.9, -9999.9, 9999,  99999,
                                                -99999, 999999, -32768, 32767,   65535, 1e10,
                                                -1e10,  1e30,   -1e30,  1e38};

/* A known mark is suspect where it lies this many times the range of all others outside of it. */
#define KNOWN_OFF 10

/* A value that recurs at an end of the range is suspect where it is this many times the range of
 * the others away from them, and no more than this part of all. */
#define OTHER_OFF 3
#define OTHER_PART 0.25

enum { RECURS = 3 };

/* `sign` 1: the low end; -1: the high one, which is the low end of the heights upside down. */
static void note_end(aspi_range_end *end, double height, double sign, size_t place) {
  if (end->met.count == 0 || sign * height < sign * end->value) {
    end->next = end->met.count == 0 ? sign * INFINITY : end->value;
    end->value = height;
    end->met = (aspi_missing_value){1, place};
  } else if (!(sign * height > sign * end->value)) {
    end->met.count++;
  } else if (sign * height < sign * end->next) {
    end->next = height;
  }
}

double aspi_missing_note(aspi_missing *marks, double height, size_t place) {
  if (!isfinite(height) || fabs(height - marks->stated) <= 1e-9 * fabs(marks->stated))
    return NAN;
  for (int i = 0; i < ASP_MISSING_KNOWN; i++) {
    double off = fabs(height - known[i]), size = fabs(known[i]);
    if (off <= 1e-7 * size) { /* as single precision has it, too */
      marks->known[i].place = marks->known[i].count++ ? marks->known[i].place : place;
      return height;
    }
    marks->near[i] += off <= 0.01 * size;
  }
  marks->count++;
  note_end(&marks->low, height, 1, place);
  note_end(&marks->high, height, -1, place);
  return height;
}

/* A value at an end of the range that recurs; the others reach from its neighbor to the far end.
 */
static bool is_off(const aspi_missing *m, const aspi_range_end *end, double far) {
  double gap = fabs(end->value - end->next), range = fabs(far - end->next);
  return end->met.count >= RECURS && (double)end->met.count <= OTHER_PART * (double)m->count &&
         isfinite(gap) && range > 0 && gap > OTHER_OFF * range;
}

static asp_code fail(const char *path, aspi_missing_value met, double value, double least,
                     double most, asp_error *error) {
  return aspi_fail(error, ASP_EDATA,
                   "%.200s:%zu: height %.10g, %zu times, beside heights of %g to %g: does it stand "
                   "for a missing one? Say so (reader: missing %.10g), or mend the "
                   "file",
                   path, met.place, value, met.count, least, most, value);
}

asp_code aspi_missing_check(const aspi_missing *m, const char *path, asp_error *error) {
  double least = m->low.value, most = m->high.value, range = most - least;
  for (int i = 0; i < ASP_MISSING_KNOWN && m->count > 0; i++) {
    bool off = known[i] < least - KNOWN_OFF * range || known[i] > most + KNOWN_OFF * range;
    bool often = m->known[i].count >= RECURS && m->known[i].count > m->near[i];
    if (m->known[i].count > 0 && (off || often))
      return fail(path, m->known[i], known[i], least, most, error);
  }
  if (is_off(m, &m->low, most))
    return fail(path, m->low.met, m->low.value, m->low.next, most, error);
  if (is_off(m, &m->high, least))
    return fail(path, m->high.met, m->high.value, least, m->high.next, error);
  return ASP_OK;
}
