/* Error messages of the core; see error.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "base/number.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#define LENGTH_LEAST 1e-100
#define LENGTH_MOST 1e100

const char *asp_code_name(asp_code code) {
  static const char *const names[] = {"ASP_OK",    "ASP_EARG",  "ASP_ENAME", "ASP_ENOMEM",
                                      "ASP_EFILE", "ASP_EDATA", "ASP_ERANGE"};
  return code <= ASP_OK && code >= ASP_ERANGE ? names[-code] : "unknown";
}

asp_code aspi_fail(asp_error *error, asp_code code, const char *format, ...) {
  if (error) {
    error->code = code;
    va_list args;
    va_start(args, format);
    aspi_print_list(error->text, sizeof error->text, format, args);
    va_end(args);
  }
  return code;
}

asp_code aspi_file_fail(const char *path, size_t line, asp_error *error, const char *format, ...) {
  char message[320];
  va_list args;
  va_start(args, format);
  aspi_print_list(message, sizeof message, format, args);
  va_end(args);
  return line > 0 ? aspi_fail(error, ASP_EDATA, "%.200s:%zu: %s", path, line, message)
                  : aspi_fail(error, ASP_EDATA, "%.200s: %s", path, message);
}

void aspi_append(char *text, size_t size, const char *format, ...) {
  size_t used = strlen(text);
  va_list args;
  va_start(args, format);
  aspi_print_list(text + used, size - used, format, args);
  va_end(args);
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

asp_code aspi_check_length(asp_error *error, const char *name, double value) {
  if (value >= LENGTH_LEAST && value <= LENGTH_MOST)
    return ASP_OK;
  return aspi_fail(error, ASP_EARG, "%s is %g; it must be > 0, from %g to %g", name, value,
                   LENGTH_LEAST, LENGTH_MOST);
}

/* Edit distance between two names, ignoring case: insertions, deletions, replacements and swaps of
 * neighbors (Damerau 1964). NAME_MOST for names of that length or longer. */
enum { NAME_MOST = 64 };

static bool is_same(char a, char b) {
  return tolower((unsigned char)a) == tolower((unsigned char)b);
}

static int distance(const char *a, const char *b) {
  size_t across = strlen(b);
  if (strlen(a) >= NAME_MOST || across >= NAME_MOST)
    return NAME_MOST;
  int rows[3][NAME_MOST], i = 0;
  for (int j = 0; j <= (int)across; j++)
    rows[0][j] = j;
  while (a[i++]) {
    int *row = rows[i % 3], *last = rows[(i + 2) % 3], *before = rows[(i + 1) % 3];
    row[0] = i;
    for (int j = 1; j <= (int)across; j++) {
      row[j] = 1 + (last[j] < row[j - 1] ? last[j] : row[j - 1]);
      int replaced = last[j - 1] + !is_same(a[i - 1], b[j - 1]);
      if (i > 1 && j > 1 && is_same(a[i - 1], b[j - 2]) && is_same(a[i - 2], b[j - 1]) &&
          before[j - 2] < replaced)
        replaced = before[j - 2] + 1;
      row[j] = replaced < row[j] ? replaced : row[j];
    }
  }
  return rows[(i - 1) % 3][across];
}

int aspi_word_index(const char *list, const char *word, size_t length, bool exact) {
  int index = 0;
  for (const char *at = list + strspn(list, " "); *at; at += strspn(at, " "), index++) {
    size_t own = strcspn(at, " ");
    if (own == length && (exact ? strncmp : strncasecmp)(at, word, own) == 0)
      return index;
    at += own;
  }
  return -1;
}

bool aspi_nearest_name(const char *name, const char *list, char meant[64]) {
  int length = (int)strlen(name), half = (length + 1) / 2, least = length / 3 + 2;
  least = half < least ? half : least;
  *meant = '\0';
  for (const char *at = list + strspn(list, " "); *at; at += strspn(at, " ")) {
    size_t own = strcspn(at, " ");
    char other[NAME_MOST];
    snprintf(other, sizeof other, "%.*s", (int)own, at);
    int away = distance(name, other);
    if (away < least) {
      strcpy(meant, other);
      least = away;
    }
    at += own;
  }
  return *meant != '\0';
}

asp_code aspi_fail_unknown(asp_error *error, const char *what, const char *name, const char *list) {
  char near[NAME_MOST], meant[NAME_MOST + 20] = "";
  if (aspi_nearest_name(name, list, near))
    snprintf(meant, sizeof meant, " did you mean '%s'?", near);
  return aspi_fail(error, ASP_ENAME, "%s '%.100s' is unknown;%s there are: %s", what, name, meant,
                   list);
}

int aspi_find_name(const char *what, const char *name, int count, const void *records,
                   asp_error *error) {
  char list[400] = "";
  const char *const *const *names = records; /* each pointer is to the name of a record, too */
  for (int i = 0; i < count; i++) {
    if (name && strcasecmp(*names[i], name) == 0)
      return i;
    aspi_append(list, sizeof list, "%s%s", *list ? " " : "", *names[i]);
  }
  aspi_fail_unknown(error, what, name ? name : "", list);
  return -1;
}
