/* Error messages of the core; see error.h. */
#include "base/error.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define LENGTH_LEAST 1e-100
#define LENGTH_MOST 1e100

asp_code aspi_fail(asp_error *error, asp_code code, const char *format, ...) {
  if (error) {
    error->code = code;
    va_list args;
    va_start(args, format);
    vsnprintf(error->text, sizeof error->text, format, args);
    va_end(args);
  }
  return code;
}

asp_code aspi_check_range(asp_error *error, const char *name, const char *unit, double value,
                          double least, double most) {
  if (isfinite(value) && value >= least && value <= most)
    return ASP_OK;
  const char *space = *unit ? " " : "";
  if (isinf(most))
    return aspi_fail(error, ASP_EARG, "%s is %g%s%s; it must be a finite number >= %g%s%s", name,
                     value, space, unit, least, space, unit);
  return aspi_fail(error, ASP_EARG, "%s is %g%s%s; it must be %g to %g%s%s", name, value, space,
                   unit, least, most, space, unit);
}

asp_code aspi_check_positive(asp_error *error, const char *name, const char *unit, double value) {
  if (isfinite(value) && value > 0)
    return ASP_OK;
  return aspi_fail(error, ASP_EARG, "%s is %g%s%s; it must be a finite number > 0", name, value,
                   *unit ? " " : "", unit);
}

asp_code aspi_check_length(asp_error *error, const char *name, double value) {
  if (value >= LENGTH_LEAST && value <= LENGTH_MOST)
    return ASP_OK;
  return aspi_fail(error, ASP_EARG, "%s is %g; it must be > 0, from %g to %g", name, value,
                   LENGTH_LEAST, LENGTH_MOST);
}

int aspi_find_name(const char *what, const char *name, int count, const char *(*name_at)(int),
                   asp_error *error) {
  char list[320] = "";
  for (int i = 0; i < count; i++) {
    if (name && strcmp(name_at(i), name) == 0)
      return i;
    size_t used = strlen(list);
    snprintf(list + used, sizeof list - used, " %s", name_at(i));
  }
  aspi_fail(error, ASP_ENAME, "%s '%s' is unknown; there are:%s", what, name ? name : "", list);
  return -1;
}
