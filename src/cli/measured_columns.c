/* Columns of measured coefficients; see measured_columns.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/measured_columns.h"
#include "base/error.h"
#include "base/number.h"
#include "base/quantity.h"
#include "base/units.h"
#include "cli/cli.h"

#include <ctype.h>
#include <limits.h>
#include <math.h>
#include <string.h>

/* Kind of quantity in a column; "" is a coefficient. */
#define RATIO ""
#define ANGLE "degrees"
#define SPEED "speed"
#define LENGTH "length"
#define WORD "word"
#define OF_MASS "mass"

/* Noise puts no rebound farther below the wall than this, in degrees. */
#define BELOW_MOST 20

/* What stands before the name of the units in a ledger's comment. */
#define UNITS "; units "

static const struct {
  const char *name, *kind;
} columns[MEASURED_COLUMNS] = {
    [ALPHA1] = {"alpha1", ANGLE},
    [V1] = {"v1", SPEED},
    [ALPHA2] = {"alpha2", ANGLE},
    [V2] = {"v2", SPEED},
    [V1_N] = {"v1_n", SPEED},
    [V1_T] = {"v1_t", SPEED},
    [V2_N] = {"v2_n", SPEED},
    [V2_T] = {"v2_t", SPEED},
    [COR_V] = {"cor_v", RATIO},
    [COR_ALPHA] = {"cor_alpha", RATIO},
    [POINT] = {"cor_n", RATIO},
    [POINT + COR_T] = {"cor_t", RATIO},
    [MEAN] = {"cor_n_mean", RATIO},
    [MEAN + COR_T] = {"cor_t_mean", RATIO},
    [SD] = {"cor_n_sd", RATIO},
    [SD + COR_T] = {"cor_t_sd", RATIO},
    [SE] = {"cor_n_se", RATIO},
    [SE + COR_T] = {"cor_t_se", RATIO},
    [COUNT] = {"n", RATIO},
    [D_P] = {"dp", LENGTH},
    [RADIUS] = {"radius", LENGTH},
    [OUTCOME] = {"outcome", WORD},
    [DELTA_ALPHA] = {"delta_alpha_deg", ANGLE},
    [COR_V_SPACE] = {"cor_v_space", RATIO},
    [MESH] = {"mesh", RATIO},
    [TRIANGLE] = {"triangle", RATIO},
    [MASS] = {"mass", OF_MASS},
    [ERODED] = {"eroded_mass", OF_MASS},
};

/* Other beginnings of names. */
static const struct {
  const char *others, *name;
} aliases[] = {{"e_n", "cor_n"},
               {"e_t", "cor_t"},
               {"impact_angle", "alpha1"},
               {"impact_velocity impact_speed", "v1"},
               {"particle_diameter diameter", "dp"},
               {"particle_radius", "radius"},
               {"cor_n_std cor_n_stdev", "cor_n_sd"},
               {"cor_t_std cor_t_stdev", "cor_t_sd"},
               {"cor_n_sem", "cor_n_se"},
               {"cor_t_sem", "cor_t_se"}};

/* A name in small letters, the signs of units written out, all others as single underscores:
 * `alpha_1 [°]` is alpha1_deg. */
static void plain(const char *name, char *to, size_t size) {
  static const char *const written[][2] = {
      {"\xc2\xb0", "_deg"}, {"\xc2\xb5", "u"}, {"\xce\xbc", "u"}, {"%", "_percent"}};
  size_t n = 0;
  for (const char *c = name; *c && n + 8 < size;) {
    bool found = false;
    for (size_t i = 0; i < sizeof written / sizeof *written && !found; i++) {
      size_t length = strlen(written[i][0]);
      if (strncmp(c, written[i][0], length) != 0)
        continue;
      const char *as = written[i][1] + (*written[i][1] == '_' && n > 0 && to[n - 1] == '_');
      n += (size_t)snprintf(to + n, size - n, "%s", as);
      c += length;
      found = true;
    }
    if (found)
      continue;
    if (isalnum((unsigned char)*c))
      to[n++] = (char)tolower((unsigned char)*c);
    else if (n > 0 && to[n - 1] != '_')
      to[n++] = '_';
    c++;
  }
  while (n > 0 && to[n - 1] == '_')
    n--;
  to[n] = '\0';
  if (strncmp(to, "alpha_", 6) == 0 && isdigit((unsigned char)to[6]))
    memmove(to + 5, to + 6, strlen(to + 6) + 1);
  if (strncmp(to, "d_p", 3) == 0)
    memmove(to + 1, to + 2, strlen(to + 2) + 1);
  for (size_t length = 1; length <= strlen(to); length++)
    for (size_t i = 0; i < sizeof aliases / sizeof *aliases; i++) {
      size_t own = strlen(aliases[i].name), rest = strlen(to + length);
      if ((rest > 0 && to[length] != '_') || own + rest >= size ||
          aspi_word_index(aliases[i].others, to, length, true) < 0)
        continue;
      memmove(to + own, to + length, rest + 1);
      memcpy(to, aliases[i].name, own);
      break;
    }
}

/* True if a name is a column's name, alone or with a unit or the like behind it. */
static bool begins_with(const char *name, int column) {
  size_t length = strlen(columns[column].name);
  return strncmp(name, columns[column].name, length) == 0 && (!name[length] || name[length] == '_');
}

static bool is_kind(int column, const char *kind) {
  return strcmp(columns[column].kind, kind) == 0;
}

/* The factor of a column's unit, which is written as `plain` does, m/s as m_s: -1 for one that is
 * not read, 0 for no unit. */
static double factor_of(int column, const char *unit) {
  char name[80];
  size_t n = 0;
  for (; unit[n] && n + 1 < sizeof name; n++)
    name[n] = (char)(unit[n] == '_' ? '/' : unit[n]);
  const aspi_unit *u = aspi_unit_find(columns[column].kind, name, n, false);
  if (!u)
    return aspi_unit_find("unread", name, n, false) ? -1 : 0;
  return u->factor * pow(10, u->exponent);
}

/* True if a name is that of a column, with a view where it is of a rebound's speed or angle, with a
 * unit of its kind or none (factor 0); with another unit factor is below 0. `stated`: the file has
 * a unit in brackets. */
static bool is_column(const char *name, int column, bool stated, double *factor,
                      aspi_measured_view *view) {
  static const char *const views[] = {"_plane", "_space"};
  size_t length = strlen(columns[column].name);
  bool pure = is_kind(column, RATIO) || is_kind(column, WORD);
  *view = ASPI_MEASURED_EITHER;
  if (column >= DELTA_ALPHA) {
    *factor = !is_kind(column, OF_MASS);
    return strcmp(name, columns[column].name) == 0;
  }
  if (!begins_with(name, column))
    return false;
  for (int c = 0; c < DELTA_ALPHA; c++)
    if (strlen(columns[c].name) > length && begins_with(name, c))
      return false;
  if (column == ALPHA2 || column == V2 || column == COR_V || column == COR_ALPHA)
    for (int i = 0; i < 2; i++)
      if (strncmp(name + length, views[i], strlen(views[i])) == 0) {
        *view = (aspi_measured_view)i;
        length += strlen(views[i]);
        break;
      }
  *factor = pure;
  if (!name[length] || (pure && strcmp(name + length, "_1") == 0))
    return true;
  const char *unit = name + length + 1;
  *factor = factor_of(column, unit);
  if (*factor > 0 || column == COUNT)
    return *factor > 0;
  if (*factor < 0)
    return true;
  *factor = -1;
  return stated;
}

/* The unit of a column; exits where it is another one than there may be, or one is missing. */
static void check_unit(const char *path, const char *name, int column, double *factor) {
  const char *own = columns[column].name;
  char list[120];
  aspi_quantity_units(columns[column].kind, list, sizeof list);
  if (*factor < 0)
    cli_bad_usage("%s: the unit of column '%s' is none that is read; for %s it must be %s", path,
                  name, own, *list ? list : "none, as a coefficient is a number such as 0.5");
  if (*factor > 0)
    return;
  *factor = 1;
  if (is_kind(column, LENGTH))
    cli_bad_usage("%s: the unit of column '%s' is not stated; name it %s_um, %s_mm or %s_m", path,
                  name, own, own, own);
  if (is_kind(column, ANGLE))
    cli_warn("%s: the unit of column '%s' is not stated; it is taken as degrees (name it %s_deg "
             "or %s_rad)",
             path, name, own, own);
}

/* The unit of a ledger's column that has none in its name: of the units in the first comment, else
 * of SI. */
static double ledger_unit(const aspi_csv *csv, int column) {
  static const struct {
    const char *name;
    double length, speed, mass;
  } units[] = {{"si", 1, 1, 1},
               {"cgs", 1e-2, 1e-2, 1e-3},
               {"micro", 1e-6, 1, 1e-15},
               {"nano", 1e-9, 1, 1e-21}};
  const char *named = strstr(csv->comment, UNITS);
  named = named ? named + strlen(UNITS) : "si";
  for (size_t i = 0; i < sizeof units / sizeof *units; i++)
    if (strlen(units[i].name) == strcspn(named, ";") &&
        strncmp(units[i].name, named, strlen(units[i].name)) == 0)
      return is_kind(column, LENGTH)    ? units[i].length
             : is_kind(column, SPEED)   ? units[i].speed
             : is_kind(column, OF_MASS) ? units[i].mass
                                        : 1;
  return is_kind(column, LENGTH) || is_kind(column, SPEED) || is_kind(column, OF_MASS) ? NAN : 1;
}

static void find_column(const aspi_csv *csv, const char *path, int c, cli_columns *l) {
  for (int i = 0; i < csv->columns; i++) { /* of several, the most specific one */
    char name[80];
    double factor;
    aspi_measured_view view;
    plain(csv->names[i], name, sizeof name);
    if (!is_column(name, c, strpbrk(csv->names[i], "[(") != NULL, &factor, &view) ||
        (l->at[c] >= 0 && l->view[c] < view))
      continue;
    if (l->at[c] >= 0 && l->view[c] == view)
      cli_bad_usage("%s: columns %d and %d, '%s' and '%s', are both %s; there must be one", path,
                    l->at[c] + 1, i + 1, csv->names[l->at[c]], csv->names[i], columns[c].name);
    l->at[c] = i;
    l->factor[c] = factor;
    l->view[c] = view;
  }
  if (l->at[c] < 0)
    return;
  if (l->is_ledger && !(fabs(l->factor[c]) > 0))
    l->factor[c] = ledger_unit(csv, c);
  else
    check_unit(path, csv->names[l->at[c]], c, &l->factor[c]);
}

void cli_columns_find(const aspi_csv *csv, const char *path, uint32_t wanted, cli_columns *l) {
  l->is_ledger = strstr(csv->comment, UNITS) || aspi_csv_find(csv, "tilt_out_deg") >= 0;
  for (int c = 0; c < MEASURED_COLUMNS; c++) {
    l->at[c] = -1;
    if (wanted & COLUMN_BIT(c))
      find_column(csv, path, c, l);
  }
}

/* Reads an outcome: a word, or the number of a ledger. */
static asp_code read_outcome(const aspi_csv *csv, int column, double *deposit, asp_error *error) {
  static const char *const words[] = {"rebound rebounded",
                                      "deposit deposited deleted stuck sticks"};
  const char *word = csv->fields[column];
  char *end;
  double number = aspi_number(word, &end);
  const bool is_number = end > word && !*end;
  for (int i = 0; i < 2; i++)
    if (is_number ? number >= i && number <= 2 * i
                  : aspi_word_index(words[i], word, strlen(word), false) >= 0) {
      *deposit = i;
      return ASP_OK;
    }
  return aspi_text_fail(&csv->text, csv->text.line, error,
                        "outcome is '%.40s'; it must be rebound or deposit (or stuck, or 0 or 1)",
                        word);
}

asp_code cli_columns_row(const aspi_csv *csv, const cli_columns *l, uint32_t needed,
                         double value[MEASURED_COLUMNS], asp_error *error) {
  asp_code code = ASP_OK;
  for (int c = 0; c < MEASURED_COLUMNS && !code; c++) {
    bool missing, angle = is_kind(c, ANGLE), both = c == DELTA_ALPHA;
    double full = (c == ALPHA2 && l->view[c] != ASPI_MEASURED_SPACE ? 180 : 90) * (1 + 1e-9);
    double least = c == ALPHA2 ? -BELOW_MOST : both ? -full : angle || c >= SD ? 0 : -1e15;
    value[c] = NAN;
    if (l->at[c] < 0)
      continue;
    if (c == OUTCOME)
      code = read_outcome(csv, l->at[c], &value[c], error);
    else
      code = aspi_csv_number(csv, l->at[c], angle ? least / l->factor[c] : least,
                             angle                        ? full / l->factor[c]
                             : c == MESH || c == TRIANGLE ? INT_MAX
                                                          : 1e15,
                             &value[c], needed & COLUMN_BIT(c) ? NULL : &missing, error);
    if (c != OUTCOME)
      value[c] *= l->factor[c];
  }
  return code;
}

void cli_warn_radians(const char *path, double most) {
  if (most < CLI_RADIANS_MOST)
    cli_warn("%s: all impact angles are below %g degrees, which look like radians", path,
             CLI_RADIANS_MOST);
}
