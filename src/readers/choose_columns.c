/* Columns of a text by their names, by what the user asks for, or by guess; units of length stand
 * in names, in a line of units, or in the header.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "readers/columns.h"
#include "base/error.h"
#include "base/units.h"
#include "readers/head.h"

#include <ctype.h>
#include <string.h>

/* First words of names of positions and heights, of heights that count downward, and of a column
 * that is 0 where the height is none. */
static const char positions[] = "x pos position positions distance dist lateral length travel scan "
                                "weg strecke abstand distancia posicion",
                  heights[] = "z height heights h raw profile depth depths level amplitude "
                              "elevation hoehe tiefe profil altura hauteur profondeur",
                  depths[] = "depth depths tiefe profondeur", marks[] = "valid gueltig valide";

/* ---- names ---- */

static size_t first_word(const char *name) {
  size_t length = 0;
  while (isalpha((unsigned char)name[length]))
    length++;
  return length;
}

static bool is_of(const char *list, const aspi_column *c) {
  return aspi_word_index(list, c->plain, first_word(c->plain), false) >= 0;
}

/* The unit at the end of a name in m, 0 if there is none of length. */
static double unit_in(const aspi_column *c) {
  double unit = 0;
  for (const char *end = c->plain; *end && !(unit > 0); end += *end == '_')
    unit = aspi_unit_meters(end, strlen(end)), end += strcspn(end, "_");
  return unit;
}

static bool is_named(const aspi_columns *r, int at, const char *list) {
  const aspi_column *c = &r->table->column[at];
  const char *mark = strpbrk(c->name, "([{/");
  bool other =
      mark && isalpha((unsigned char)mark[1]) && !(unit_in(c) > 0); /* a unit, of no length */
  return is_of(list, c) && !other;
}

/* The first column with a name of the list that is not `other`; -1: none. */
static int first_of(const aspi_columns *r, const char *list, int other) {
  for (int i = 0; i < r->table->columns; i++)
    if (i != other && is_named(r, i, list))
      return i;
  return -1;
}

/* ---- columns ---- */

static asp_code find_asked(const aspi_columns *r, const char *asked, int *found, asp_error *error) {
  *found = asked ? aspi_table_asked(r->table, asked, r->due) : -1;
  if (!asked || *found >= 0)
    return ASP_OK;
  return aspi_table_fail(r->table, error,
                         "column '%.40s' is asked for; none of the %d columns has that name or "
                         "number",
                         asked, r->due);
}

/* Guesses columns that neither user nor names state. Of two columns without known names the first
 * has positions; if one is named as positions the other has heights. */
static void complete(aspi_columns *r, bool alone) {
  int *x = &r->column[X], *z = &r->column[Z], named = r->table->columns;
  int position = first_of(r, positions, *z), height = first_of(r, heights, *x);
  bool none = position < 0 && height < 0;
  if (named == 0 || (none && r->due <= 2 && !alone)) {
    *x = *x >= 0 || alone ? *x : *z == 0 && r->due > 1 ? 1 : 0;
    *z = *z >= 0 ? *z : alone || *x == 1 ? 0 : 1;
  } else if (alone && r->due == 1) {
    *z = 0;
  }
  *z = *z >= 0 ? *z : height;
  *x = *x < 0 && !alone ? first_of(r, positions, *z) : *x;
  if (*z < 0 && *x >= 0 && r->due == 2 && unit_in(&r->table->column[1 - *x]) > 0)
    *z = 1 - *x;
}

static asp_code find_units(aspi_columns *r, asp_error *error) {
  const aspi_profile_options *o = r->options;
  for (int k = X; k <= Z; k++) {
    int at = r->column[k];
    double own = k < Z ? o->unit_x : o->unit_z,
           factor = k == Z ? aspi_head_length(r->table, ASPI_HEAD_FACTOR, 1) : 0;
    const aspi_column *c = at >= 0 && at < r->table->columns ? &r->table->column[at] : NULL;
    double unit = own > 0 ? own : c && unit_in(c) > 0 ? unit_in(c) : factor;
    unit = !(unit > 0) && k == Z ? r->known_unit : unit;
    r->unit[k] = k < Z && at < 0 ? 1
                 : unit > 0      ? unit
                                 : aspi_head_length(r->table, ASPI_HEAD_UNIT, 1);
    if (!(r->unit[k] > 0) && r->column[Z] < 0)
      return aspi_table_fail(
          r->table, error,
          "no unit of the heights is stated before the first numbers; say which unit of "
          "length they are in (asperity surface --unit um)");
    if (!(r->unit[k] > 0))
      return aspi_table_fail(
          r->table, error,
          "no unit of length is stated of column %d before the first numbers; say which "
          "unit of length the columns are in (asperity surface --unit um)",
          at + 1);
    if (k == Z && c && is_of(depths, c))
      r->unit[k] *= -1;
  }
  return ASP_OK;
}

static asp_code choose_profile(aspi_columns *r, asp_error *error) {
  const aspi_profile_options *o = r->options;
  bool alone = r->step[0] > 0;
  int named = r->table->columns, *x = &r->column[X], *z = &r->column[Z];
  asp_code code = alone ? ASP_OK : find_asked(r, o->x_column, x, error);
  code = code ? code : find_asked(r, o->column, z, error);
  if (code)
    return code;
  if (*x >= 0 && *x == *z)
    return aspi_table_fail(r->table, error, "column %d is asked for as positions and as heights",
                           *x + 1);
  bool by_user = *x >= 0;
  if (*z < 0 && r->due > (alone ? 1 : 2) && named < r->table->count)
    return aspi_table_fail(r->table, error,
                           "%d columns under %d names%s; " ASK_COLUMNS
                           "; a matrix of heights, or x, y and z, is a map (surface map)",
                           r->due, named,
                           r->table->separator == ',' ? " (or " DECIMAL_COMMAS ")" : "");
  if (!alone && r->due == 1)
    return aspi_table_fail(r->table, error,
                           "heights alone of a profile need the step between them (asperity "
                           "surface --step 0.5um)");
  complete(r, alone);
  if (*z < 0 || (*x < 0 && !alone))
    return aspi_table_fail(r->table, error, "no column is named as a %s; " ASK_COLUMNS,
                           *z < 0 ? "height" : "position");
  int y = first_of(r, "y", *z);
  bool both = y >= 0 && !by_user && *x >= 0 && first_of(r, "x", -1) == *x;
  r->column[Y] = both ? y : -1;
  return find_units(r, error);
}

/* True for x, y, z, and red, green, blue as whole numbers to 255, perhaps another one behind. */
static bool has_colors(const aspi_columns *r) {
  double v[7], whole = 0;
  for (int i = 0; i < 6 && r->due >= 6 && r->due <= 7 && r->table->columns == 0; i++)
    if (aspi_table_field(r->table, i, &v[i]) == ASP_WORD_NUMBER)
      whole += i >= 3 ? v[i] >= 0 && v[i] <= 255 && !strpbrk(r->table->fields[i], ".,")
                      : !strpbrk(r->table->fields[i], ".,");
  return whole >= 3 && whole < 6 && strpbrk(r->table->fields[2], ".,");
}

static asp_code choose_map(aspi_columns *r, asp_error *error) {
  int x = first_of(r, "x", -1), y = first_of(r, "y", -1), z = first_of(r, "z", -1);
  z = z < 0 ? first_of(r, heights, -1) : z;
  bool named = x >= 0 && y >= 0 && z >= 0;
  for (int k = X; k <= Z; k++)
    r->column[k] = named ? (const int[]){x, y, z}[k] : r->due == 3 || has_colors(r) ? k : -1;
  return find_units(r, error);
}

asp_code aspi_columns_choose(aspi_columns *r, bool is_map, asp_error *error) {
  asp_code code = is_map ? choose_map(r, error) : choose_profile(r, error);
  r->column[VALID] = r->column[Z] < 0 ? -1 : first_of(r, marks, -1);
  return code;
}
