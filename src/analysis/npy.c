/* NumPy arrays; see npy.h. The header is a Python dictionary as numpy.lib.format writes it:
 * {'descr': [('name', '<f8'), ...], 'fortran_order': False, 'shape': (rows,), }
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/npy.h"
#include "base/error.h"

#include <ctype.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#if __BYTE_ORDER__ != __ORDER_LITTLE_ENDIAN__
#error "arrays are read little-endian"
#endif

static const char MAGIC[] = "\x93NUMPY";
enum { MAGIC_SIZE = 6, HEADER_MOST = 1 << 16 };

bool aspi_npy_is(FILE *stream) {
  char first[MAGIC_SIZE];
  bool is =
      fread(first, 1, MAGIC_SIZE, stream) == MAGIC_SIZE && memcmp(first, MAGIC, MAGIC_SIZE) == 0;
  rewind(stream);
  return is;
}

/* Steps over a character and the blanks before it, if it is there. */
static bool take(const char **text, char c) {
  *text += strspn(*text, " \t\n");
  if (**text != c)
    return false;
  ++*text;
  return true;
}

/* 'text' or "text", as much of it as there is room for. */
static bool take_string(const char **text, char *to, size_t room) {
  char quote = '\'';
  if (!take(text, quote) && !take(text, quote = '"'))
    return false;
  const char *end = strchr(*text, quote);
  if (!end)
    return false;
  snprintf(to, room, "%.*s", (int)(end - *text), *text);
  *text = end + 1;
  return true;
}

static bool read_type(aspi_npy_column *column, const char *type) {
  column->kind = type[1];
  column->size = type[1] ? atoi(type + 2) : 0;
  int size = column->size;
  bool known = (size == 4 || size == 8) && strchr("fiu", type[1]);
  known = known || ((size == 1 || size == 2) && strchr("iu", type[1]));
  return known && (*type == '<' || (*type == '|' && size == 1));
}

/* ('name', '<f8') or (('title', 'name'), '<f8') */
static asp_code read_column(aspi_npy *array, const char **text, asp_error *error) {
  char title[ASPI_NPY_TITLE] = "", type[32] = "";
  aspi_npy_column *column = &array->column[array->columns];
  bool good = take(text, '(');
  if (good && take(text, '('))
    good = take_string(text, title, sizeof title) && take(text, ',') &&
           take_string(text, column->name, sizeof column->name) && take(text, ')');
  else
    good = good && take_string(text, column->name, sizeof column->name);
  if (!good || !take(text, ',') || !take_string(text, type, sizeof type) || !take(text, ')'))
    return aspi_fail(error, ASP_EDATA, "%s: its header is not one of a table of numbers",
                     array->path);
  if (!read_type(column, type))
    return aspi_fail(error, ASP_EDATA,
                     "%s: column '%s' is of type '%s'; it must be little-endian whole or "
                     "floating-point numbers, such as <i4 or <f8",
                     array->path, column->name, type);
  column->offset = array->row_size;
  array->row_size += column->size;
  array->columns++;
  if (!*array->title)
    strcpy(array->title, title);
  return ASP_OK;
}

static asp_code read_columns(aspi_npy *array, const char *header, asp_error *error) {
  const char *text = strstr(header, "'descr':");
  text = text ? text + strlen("'descr':") : "";
  if (!take(&text, '['))
    return aspi_fail(error, ASP_EDATA, "%s: a NumPy array, but not one with named columns",
                     array->path);
  while (!take(&text, ']')) {
    if (array->columns == ASPI_NPY_COLUMNS)
      return aspi_fail(error, ASP_EDATA, "%s: more than %d columns", array->path, ASPI_NPY_COLUMNS);
    asp_code code = read_column(array, &text, error);
    if (code)
      return code;
    take(&text, ',');
  }
  return array->columns > 0 ? ASP_OK : aspi_fail(error, ASP_EDATA, "%s: no columns", array->path);
}

static asp_code read_shape(aspi_npy *array, const char *header, asp_error *error) {
  const char *text = strstr(header, "'shape':");
  text = text ? text + strlen("'shape':") : "";
  bool good = take(&text, '(') && isdigit((unsigned char)*text);
  char *end = "";
  if (good)
    array->rows = strtoull(text, &end, 10);
  text = end;
  if (good && take(&text, ',') && take(&text, ')'))
    return ASP_OK;
  return aspi_fail(error, ASP_EDATA, "%s: a NumPy array, but not one with one dimension",
                   array->path);
}

asp_code aspi_npy_open(aspi_npy *array, FILE *stream, const char *path, asp_error *error) {
  *array = (aspi_npy){.stream = stream, .path = path};
  unsigned char first[MAGIC_SIZE + 2] = {0}, length[4] = {0};
  char *header = calloc(1, HEADER_MOST + 1);
  if (!header)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for '%s'", path);
  asp_code code = ASP_OK;
  size_t size = 0;
  bool whole = fread(first, 1, sizeof first, stream) == sizeof first;
  int length_size = first[MAGIC_SIZE] == 1 ? 2 : 4;
  if (whole && (first[MAGIC_SIZE] < 1 || first[MAGIC_SIZE] > 3))
    code = aspi_fail(error, ASP_EDATA, "%s: a NumPy array of version %d; it must be 1 to 3", path,
                     first[MAGIC_SIZE]);
  whole = whole && fread(length, 1, (size_t)length_size, stream) == (size_t)length_size;
  if (whole)
    size = length[0] | (size_t)length[1] << 8 | (size_t)length[2] << 16 | (size_t)length[3] << 24;
  whole = whole && size <= HEADER_MOST && fread(header, 1, size, stream) == size;
  if (!code && !whole)
    code = aspi_fail(error, ASP_EDATA, "%s: a NumPy array whose header is cut short", path);
  if (!code && !(code = read_columns(array, header, error)))
    code = read_shape(array, header, error);
  free(header);
  return code;
}

int aspi_npy_find(const aspi_npy *array, const char *name) {
  for (int i = 0; i < array->columns; i++)
    if (strcmp(array->column[i].name, name) == 0)
      return i;
  return -1;
}

asp_code aspi_npy_next(aspi_npy *array, bool *found, asp_error *error) {
  *found = array->row < array->rows;
  if (!*found)
    return ASP_OK;
  if (fread(array->bytes, 1, (size_t)array->row_size, array->stream) != (size_t)array->row_size)
    return aspi_fail(error, ASP_EDATA, "%s: its header says %llu rows, but it ends in row %llu",
                     array->path, array->rows, array->row + 1);
  array->row++;
  return ASP_OK;
}

double aspi_npy_value(const aspi_npy *array, int index) {
  if (index < 0)
    return NAN;
  const aspi_npy_column *column = &array->column[index];
  const unsigned char *bytes = array->bytes + column->offset;
  uint64_t whole = 0;
  float f4;
  double f8;
  memcpy(&f4, bytes, sizeof f4);
  memcpy(&f8, bytes, sizeof f8);
  memcpy(&whole, bytes, (size_t)column->size);
  if (column->kind == 'f')
    return column->size == 4 ? (double)f4 : f8;
  if (column->kind == 'u')
    return (double)whole;
  int unused = 64 - 8 * column->size; /* bits above the sign */
  return (double)((int64_t)(whole << unused) / ((int64_t)1 << unused));
}
