/* Measured coefficients of restitution; see measured.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/measured.h"
#include "base/csv.h"
#include "base/error.h"
#include "base/quantity.h"
#include "base/units.h"
#include "cli/cli.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Degrees below this, all of them, may be radians. */
#define RADIANS_MOST 1.6

/* Noise puts no rebound farther below the wall than this, in degrees. */
#define BELOW_MOST 20

/* Kind of quantity in a column; "" is a coefficient. */
#define RATIO ""
#define ANGLE "degrees"
#define SPEED "speed"
#define LENGTH "length"
#define WORD "word"
enum {
  ALPHA1,
  V1,
  ALPHA2,
  V2,
  V1_N,
  V1_T,
  V2_N,
  V2_T,
  COR_V,
  COR_ALPHA,
  POINT,
  MEAN = POINT + COR_BOTH,
  SD = MEAN + COR_BOTH,
  SE = SD + COR_BOTH,
  COUNT = SE + COR_BOTH,
  D_P,
  OUTCOME,
  N_COLUMNS
};

static const struct {
  const char *name, *kind;
} columns[N_COLUMNS] = {
    [ALPHA1] = {"alpha1", ANGLE},   [V1] = {"v1", SPEED},
    [ALPHA2] = {"alpha2", ANGLE},   [V2] = {"v2", SPEED},
    [V1_N] = {"v1_n", SPEED},       [V1_T] = {"v1_t", SPEED},
    [V2_N] = {"v2_n", SPEED},       [V2_T] = {"v2_t", SPEED},
    [COR_V] = {"cor_v", RATIO},     [COR_ALPHA] = {"cor_alpha", RATIO},
    [POINT] = {"cor_n", RATIO},     [POINT + COR_T] = {"cor_t", RATIO},
    [MEAN] = {"cor_n_mean", RATIO}, [MEAN + COR_T] = {"cor_t_mean", RATIO},
    [SD] = {"cor_n_sd", RATIO},     [SD + COR_T] = {"cor_t_sd", RATIO},
    [SE] = {"cor_n_se", RATIO},     [SE + COR_T] = {"cor_t_se", RATIO},
    [COUNT] = {"n", RATIO},         [D_P] = {"dp", LENGTH},
    [OUTCOME] = {"outcome", WORD},
};

/* Other beginnings of names. */
static const struct {
  const char *other, *name;
} aliases[] = {{"e_n", "cor_n"},
               {"e_t", "cor_t"},
               {"impact_angle", "alpha1"},
               {"aufprallwinkel", "alpha1"},
               {"auftreffwinkel", "alpha1"},
               {"impact_velocity", "v1"},
               {"impact_speed", "v1"},
               {"aufprallgeschwindigkeit", "v1"},
               {"auftreffgeschwindigkeit", "v1"},
               {"particle_diameter", "dp"},
               {"diameter", "dp"},
               {"partikeldurchmesser", "dp"},
               {"durchmesser", "dp"}};

/* More than half of the coefficients beyond this are per cent. */
#define RATIO_MOST 5

/* Positions of the columns in the file, -1 if absent; their units; and, for columns of a rebound,
 * the view that they are of. */
typedef struct layout {
  int at[N_COLUMNS];
  double factor[N_COLUMNS];
  aspi_measured_view view[N_COLUMNS];
} layout;

/* A name in small letters, Greek ones and signs written out, all others as single underscores:
 * `α1 [°]` and `alpha_1 (deg)` are alpha1_deg. */
static void plain(const char *name, char *to, size_t size) {
  static const char *const written[][2] = {{"\xce\xb1", "alpha"}, {"\xc2\xb0", "_deg"},
                                           {"\xc2\xb5", "u"},     {"\xce\xbc", "u"},
                                           {"%", "_percent"},     {"\xb0", "_deg"}};
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
  for (size_t i = 0; i < sizeof aliases / sizeof *aliases; i++) {
    size_t length = strlen(aliases[i].other), own = strlen(aliases[i].name);
    if (strncmp(to, aliases[i].other, length) != 0 || (to[length] && to[length] != '_') ||
        own + strlen(to + length) >= size)
      continue;
    memmove(to + own, to + length, strlen(to + length) + 1);
    memcpy(to, aliases[i].name, own);
    return;
  }
}

static bool is_kind(int column, const char *kind) {
  return strcmp(columns[column].kind, kind) == 0;
}

/* The factor of a column's unit, which is written as `plain` does, m/s as m_s: -1 for one that is
 * not read, 0 for no unit. */
static double factor_of(int column, const char *unit) {
  const aspi_unit *u;
  char name[80];
  size_t n = 0;
  for (; unit[n] && n + 1 < sizeof name; n++)
    name[n] = (char)(unit[n] == '_' ? '/' : unit[n]);
  for (size_t i = 0; (u = aspi_unit_at(i)) != NULL; i++)
    if ((!(u->factor > 0) || is_kind(column, u->kind)) && aspi_unit_is(u, name, n, false))
      return u->factor > 0 ? u->factor * pow(10, u->exponent) : -1;
  return 0;
}

/* True if a name is that of a column, with a view where it is of a rebound's speed or angle, with a
 * unit of its kind or none (factor 0); with another unit factor is below 0. `stated`: the file has
 * a unit in brackets. */
static bool is_column(const char *name, int column, bool stated, double *factor,
                      aspi_measured_view *view) {
  static const char *const views[] = {"_plane", "_space"};
  size_t length = strlen(columns[column].name);
  bool pure = is_kind(column, RATIO) || is_kind(column, WORD);
  if (strncmp(name, columns[column].name, length) != 0 || (name[length] && name[length] != '_'))
    return false;
  *view = ASPI_MEASURED_EITHER;
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
  return stated && strncmp(unit, "mean", 4) != 0 && unit[0] != 's';
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

static void find_columns(const aspi_csv *csv, const char *path, layout *l) {
  for (int c = 0; c < N_COLUMNS; c++) {
    l->at[c] = -1;
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
    if (l->at[c] >= 0)
      check_unit(path, csv->names[l->at[c]], c, &l->factor[c]);
  }
}

static bool has(const layout *l, int column) {
  return l->at[column] >= 0;
}

static bool has_components(const layout *l) {
  return has(l, V1_N) && has(l, V1_T) && has(l, V2_N) && has(l, V2_T);
}

/* Finds out if the columns are those of impacts or of means. */
static asp_code find_form(const aspi_csv *csv, const layout *l, bool *means, asp_error *error) {
  bool points = has(l, POINT) || has(l, POINT + COR_T) || has_components(l) ||
                (has(l, COR_V) && has(l, COR_ALPHA)) ||
                (has(l, ALPHA2) && has(l, V2) && has(l, V1));
  *means = has(l, MEAN) || has(l, MEAN + COR_T);
  if (!has(l, ALPHA1) && !has_components(l))
    return aspi_csv_need(csv, "alpha1_deg", error) < 0 ? ASP_EDATA : ASP_OK;
  if (points != *means)
    return ASP_OK;
  return aspi_text_fail(&csv->text, csv->text.line, error,
                        "%s; impacts are columns alpha1,v1,alpha2,v2 or v1_n,v1_t,v2_n,v2_t or "
                        "cor_v,cor_alpha or cor_n,cor_t, means are cor_n_mean,cor_n_sd,cor_t_mean,"
                        "cor_t_sd",
                        points ? "both points and means" : "neither points nor means");
}

static asp_code read_numbers(const aspi_csv *csv, const layout *l, double *value,
                             asp_error *error) {
  for (int c = 0; c < N_COLUMNS; c++) {
    bool missing, angle = is_kind(c, ANGLE);
    double full = (c == ALPHA2 ? 180 : 90) * (1 + 1e-9) / l->factor[c];
    double least = c == ALPHA2 ? -BELOW_MOST / l->factor[c] : angle || c >= SD ? 0 : -1e15;
    full = c == ALPHA2 && l->view[c] == ASPI_MEASURED_SPACE ? full / 2 : full;
    value[c] = NAN;
    if (!has(l, c) || is_kind(c, WORD))
      continue;
    asp_code code = aspi_csv_number(csv, l->at[c], least, angle ? full : 1e15, &value[c],
                                    c == ALPHA1 ? NULL : &missing, error);
    if (code)
      return code;
    value[c] *= l->factor[c];
  }
  return ASP_OK;
}

/* The coefficients of the components of both velocities. */
static void of_components(double n1, double t1, double n2, double t2, aspi_measured_row *row) {
  double n = fabs(n1), t = fabs(t1);
  row->degrees = cli_degrees(atan2(n, t));
  row->v1 = hypot(n, t);
  row->cor[COR_N] = n > 0 ? n2 / n : NAN;
  row->cor[COR_T] = t > 1e-12 * n ? t2 / t1 : NAN;
}

static aspi_measured_row row_of(const layout *l, const double *v, bool means) {
  double a1 = cli_radians(v[ALPHA1]), a2 = cli_radians(v[ALPHA2]);
  aspi_measured_row row = {
      .degrees = fmin(90, v[ALPHA1]), .v1 = v[V1], .d_p = v[D_P], .n = v[COUNT]};
  for (int k = 0; k < COR_BOTH; k++) {
    row.cor[k] = means ? v[MEAN + k] : v[POINT + k];
    row.sd[k] = v[SD + k];
    row.se[k] = v[SE + k];
  }
  if (means || has(l, POINT) || has(l, POINT + COR_T))
    return row;
  if (has_components(l))
    of_components(v[V1_N], v[V1_T], fabs(v[V2_N]), v[V2_T], &row);
  else if (has(l, COR_V) && has(l, COR_ALPHA))
    of_components(sin(a1), cos(a1), v[COR_V] * sin(v[COR_ALPHA] * a1),
                  v[COR_V] * cos(v[COR_ALPHA] * a1), &row);
  else
    of_components(v[V1] * sin(a1), v[V1] * cos(a1), v[V2] * sin(a2), v[V2] * cos(a2), &row);
  if (!has_components(l))
    row.v1 = v[V1];
  if (row.degrees >= 90 - 1e-9)
    row.cor[COR_T] = NAN;
  return row;
}

/* Reads the outcome of a row: a word, or a ledger's number. */
static asp_code read_outcome(const aspi_csv *csv, const layout *l, aspi_measured_row *row,
                             asp_error *error) {
  static const struct {
    const char *word;
    bool deposit;
  } words[] = {{"rebound", false}, {"rebounded", false}, {"deposit", true}, {"deposited", true},
               {"deleted", true},  {"stuck", true},      {"sticks", true},  {"0", false},
               {"1", true},        {"2", true}};
  if (!has(l, OUTCOME)) {
    row->deposit = !(fabs(row->cor[COR_N]) > 0) && !isnan(row->cor[COR_N]);
    return ASP_OK;
  }
  const char *word = csv->fields[l->at[OUTCOME]];
  for (size_t i = 0; i < sizeof words / sizeof *words; i++)
    if (strcasecmp(words[i].word, word) == 0) {
      row->deposit = words[i].deposit;
      return ASP_OK;
    }
  return aspi_text_fail(&csv->text, csv->text.line, error,
                        "outcome is '%.40s'; it must be rebound or deposit (or stuck, or 0 or 1)",
                        word);
}

static int by_place(const void *left, const void *right) {
  const aspi_measured_row *a = left, *b = right;
  if (a->degrees < b->degrees || a->degrees > b->degrees)
    return a->degrees < b->degrees ? -1 : 1;
  if (a->v1 < b->v1 || a->v1 > b->v1)
    return a->v1 < b->v1 ? -1 : 1;
  return (a->d_p > b->d_p) - (a->d_p < b->d_p);
}

static void add(aspi_measured *data, aspi_measured_row row) {
  if ((data->count & (data->count - 1)) == 0) {
    size_t room = data->count ? 2 * data->count : 1;
    data->rows = realloc(data->rows, room * sizeof *data->rows);
    if (!data->rows)
      cli_fail("out of memory for %zu rows", data->count);
  }
  data->rows[data->count++] = row;
}

/* Sets the view: the velocity in the plane, if coefficients or components are given. */
static asp_code find_view(const aspi_csv *csv, const layout *l, aspi_measured *data,
                          asp_error *error) {
  bool ratios = has(l, COR_V) && has(l, COR_ALPHA);
  int speed = ratios ? COR_V : V2, angle = ratios ? COR_ALPHA : ALPHA2;
  data->view = ASPI_MEASURED_PLANE;
  if (data->means || has(l, POINT) || has(l, POINT + COR_T) || has_components(l))
    return ASP_OK;
  if (l->view[speed] != l->view[angle])
    return aspi_text_fail(
        &csv->text, csv->text.line, error,
        "columns '%s' and '%s' are not of the same velocity; both must be of that "
        "in the plane of incidence, or of that in space",
        csv->names[l->at[speed]], csv->names[l->at[angle]]);
  data->view = l->view[speed];
  return ASP_OK;
}

/* Mirrors a rebound below the wall at it; false: it is left out. */
static bool keep_above(aspi_measured_row *row, bool folds, size_t *below) {
  if (!(row->cor[COR_N] < 0))
    return true;
  row->cor[COR_N] = -row->cor[COR_N];
  (*below)++;
  return folds;
}

static asp_code read_rows(aspi_csv *csv, const layout *l, aspi_measured *data, size_t *below,
                          asp_error *error) {
  for (bool found;;) {
    double value[N_COLUMNS];
    asp_code code;
    if ((code = aspi_csv_row(csv, &found, error)) || !found ||
        (code = read_numbers(csv, l, value, error)))
      return code;
    aspi_measured_row row = row_of(l, value, data->means);
    if (!data->means && (code = read_outcome(csv, l, &row, error)))
      return code;
    if (row.deposit)
      row.cor[COR_N] = row.cor[COR_T] = NAN;
    if (isnan(row.degrees))
      return aspi_text_fail(&csv->text, csv->text.line, error,
                            "the impact angle is missing; v1_n and v1_t, or alpha1, must be there");
    if (data->means || keep_above(&row, data->folds, below))
      add(data, row);
  }
}

/* Exits where the coefficients are per cent. */
static void check_ratios(const aspi_measured *data, const char *path) {
  size_t all = 0, large = 0;
  for (size_t i = 0; i < data->count; i++)
    for (int k = 0; k < COR_BOTH; k++) {
      all += !isnan(data->rows[i].cor[k]);
      large += fabs(data->rows[i].cor[k]) > RATIO_MOST;
    }
  if (2 * large > all)
    cli_bad_usage("%s: %zu of %zu coefficients are over %d, which look like per cent; they must be "
                  "numbers such as 0.5",
                  path, large, all, RATIO_MOST);
}

aspi_measured cli_measured_read(const char *path, const cli_option *options) {
  aspi_measured data = {.folds = cli_choice(&options[MEASURED_BELOW]) == 0};
  layout l;
  size_t below = 0;
  asp_error error;
  aspi_csv *csv = aspi_csv_open(path, &error);
  cli_must(csv, &error);
  find_columns(csv, path, &l);
  cli_must(!find_form(csv, &l, &data.means, &error) && !find_view(csv, &l, &data, &error) &&
               !read_rows(csv, &l, &data, &below, &error),
           &error);
  if (options[MEASURED_VIEW].value) {
    int view = cli_choice(&options[MEASURED_VIEW]);
    if (data.view != ASPI_MEASURED_EITHER)
      cli_bad_usage("--view is '%s'; the columns of %s say it themselves",
                    options[MEASURED_VIEW].value, path);
    data.view = view ? ASPI_MEASURED_SPACE : ASPI_MEASURED_PLANE;
  }
  if (below > 0)
    cli_warn("%s: %zu rebounds are below the wall, as by noise; they are %s", path, below,
             data.folds ? "mirrored at it (--below drop leaves them out)" : "left out");
  data.has_speed = has(&l, V1) || has_components(&l);
  data.has_size = has(&l, D_P);
  data.has_outcome = has(&l, OUTCOME);
  aspi_csv_close(csv);
  if (data.count == 0)
    cli_bad_usage("%s: no row of data", path);
  check_ratios(&data, path);
  double most = 0;
  for (size_t i = 0; i < data.count; i++)
    most = fmax(most, data.rows[i].degrees);
  if (has(&l, ALPHA1) && most < RADIANS_MOST)
    cli_warn("%s: all impact angles are below %g degrees, which look like radians", path,
             RADIANS_MOST);
  cli_measured_sort(&data);
  return data;
}

void cli_measured_sort(aspi_measured *data) {
  qsort(data->rows, data->count, sizeof *data->rows, by_place);
}

void cli_measured_need_view(const char *path, aspi_measured *data, bool matters) {
  if (data->view == ASPI_MEASURED_EITHER && matters)
    cli_bad_usage(
        "%s: are speed and angle of rebounds those in the plane of incidence, as one camera "
        "sees them, or those in space? Name the columns v2_plane, alpha2_plane or "
        "v2_space, alpha2_space (cor_v, cor_alpha alike), or give --view plane or --view "
        "space",
        path);
  if (data->view == ASPI_MEASURED_EITHER)
    data->view = ASPI_MEASURED_PLANE;
}
