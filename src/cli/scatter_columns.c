/* The columns of tables of impacts: names, units and rows; see scatter.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/scatter.h"
#include "base/error.h"
#include "base/number.h"
#include "base/units.h"
#include "base/tolerances.h"

#include <limits.h>
#include <string.h>

/* Kind of quantity in a column; "" is a coefficient. */
#define RATIO ""
#define ANGLE "degrees"
#define SPEED "speed"
#define LENGTH "length"
#define OF_MASS "mass"
#define RATE "rate"

/* Angles may be rounded, and noise puts no rebound farther below the wall than this, in degrees. */
#define RIGHT_ANGLE (90 * (1 + ASPI_ROUNDING_TEXT))
#define BELOW_MOST 20

/* A larger number is a mistake. */
#define LARGE 1e15

/* Text before the name of the units in a ledger's comment. */
#define UNITS "; units "

#define VECTOR(AT, X, Y, Z, KIND)                                                                  \
  [AT] = {X, KIND, -LARGE, LARGE}, [AT + 1] = {Y, KIND, -LARGE, LARGE},                            \
  [AT + 2] = {Z, KIND, -LARGE, LARGE}

/* Plain names (aspi_plain); the first one is shown. */
static const struct {
  const char *names, *kind;
  double least, most;
} columns[SCATTER_COLUMNS] = {
    [ALPHA1] = {"alpha1 alpha_1 impact_angle alpha_in alpha_i angle_in ang_in incidence_angle "
                "incident_angle alpha alpha_impact theta_in theta_i theta beta_1 angle_from_normal "
                "angle_of_incidence auftreffwinkel aufprallwinkel",
                ANGLE, 0, RIGHT_ANGLE},
    [V1] = {"v1 impact_velocity impact_speed v_in vin v_i u_i v_imp velocity speed v "
            "auftreffgeschwindigkeit",
            SPEED, 0, LARGE},
    [ALPHA2 + ASPI_IN_PLANE] = {"alpha2_plane alpha_2_plane rebound_angle alpha_out alpha_r "
                                "alpha_re angle_out ang_out ang_re "
                                "theta_out theta_r beta_2",
                                ANGLE, -BELOW_MOST, 2 * RIGHT_ANGLE},
    [ALPHA2 + ASPI_IN_SPACE] = {"alpha2_space alpha_2_space", ANGLE, -BELOW_MOST, RIGHT_ANGLE},
    [V2 + ASPI_IN_PLANE] = {"v2_plane v_out vout v_r rebound_velocity rebound_speed", SPEED, 0,
                            LARGE},
    [V2 + ASPI_IN_SPACE] = {"v2_space v2", SPEED, 0, LARGE}, /* v2: as a ledger has it */
    [COR_ALPHA + ASPI_IN_PLANE] = {"cor_alpha_plane", RATIO, -LARGE, LARGE},
    [COR_ALPHA + ASPI_IN_SPACE] = {"cor_alpha_space", RATIO, -LARGE, LARGE},
    [COR_V + ASPI_IN_PLANE] = {"cor_v_plane", RATIO, 0, LARGE},
    [COR_V + ASPI_IN_SPACE] = {"cor_v_space", RATIO, 0, LARGE},
    [V1_N] = {"v1_n", SPEED, -LARGE, LARGE},
    [V1_T] = {"v1_t", SPEED, -LARGE, LARGE},
    [V2_N] = {"v2_n", SPEED, -LARGE, LARGE},
    [V2_T] = {"v2_t", SPEED, -LARGE, LARGE},
    [POINT] = {"cor_n e_n en e cor epsilon_n e_normal restitution coefficient_of_restitution",
               RATIO, -LARGE, LARGE},
    [POINT + COR_T] = {"cor_t e_t et epsilon_t e_tangential", RATIO, -LARGE, LARGE},
    [MEAN] = {"cor_n_mean e_n_mean", RATIO, -LARGE, LARGE},
    [MEAN + COR_T] = {"cor_t_mean e_t_mean", RATIO, -LARGE, LARGE},
    [MEAN + REBOUND_ANGLE] = {"alpha2_plane_mean alpha2_mean rebound_angle_mean", ANGLE,
                              -BELOW_MOST, 2 * RIGHT_ANGLE},
    [SD] = {"cor_n_sd cor_n_std e_n_sd e_n_std", RATIO, 0, LARGE},
    [SD + COR_T] = {"cor_t_sd cor_t_std e_t_sd e_t_std", RATIO, 0, LARGE},
    [SD + REBOUND_ANGLE] = {"alpha2_plane_sd alpha2_sd rebound_angle_sd rebound_angle_std", ANGLE,
                            0, RIGHT_ANGLE},
    [SE] = {"cor_n_se cor_n_sem e_n_se e_n_sem", RATIO, 0, LARGE},
    [SE + COR_T] = {"cor_t_se cor_t_sem e_t_se e_t_sem", RATIO, 0, LARGE},
    [SE + REBOUND_ANGLE] = {"alpha2_plane_se alpha2_se rebound_angle_se rebound_angle_sem", ANGLE,
                            0, RIGHT_ANGLE},
    [COUNT] = {"n count number_of_impacts anzahl", RATIO, 0, LARGE},
    [PSI] = {"psi1 psi_1 psi_i", RATIO, 0, LARGE},
    [PSI + 1] = {"psi2 psi_2 psi_r", RATIO, -LARGE, LARGE},
    [D_P] = {"dp d_p diameter particle_diameter", LENGTH, 0, LARGE},
    [RADIUS] = {"radius particle_radius", LENGTH, 0, LARGE},
    [OUTCOME] = {"outcome", RATIO, 0, 0},
    [MESH] = {"mesh", RATIO, 0, INT_MAX},
    [TRIANGLE] = {"triangle", RATIO, 0, INT_MAX},
    [KELVIN] = {"temperature", "K", 0, LARGE},
    [MASS] = {"mass", OF_MASS, 0, LARGE},
    [ERODED] = {"eroded_mass", OF_MASS, 0, LARGE},
    [DELTA_ALPHA] = {"delta_alpha", ANGLE, -RIGHT_ANGLE, RIGHT_ANGLE},
    [TILT_OUT] = {"tilt_out", ANGLE, -RIGHT_ANGLE, RIGHT_ANGLE},
    [HITS] = {"hits", RATIO, 0, INT_MAX},
    [TAG] = {"tag", RATIO, 0, LARGE},
    [IMPACT] = {"impact", RATIO, 0, UINT32_MAX},
    [BODY] = {"body", RATIO, 0, LARGE},
    VECTOR(NORMAL, "nx", "ny", "nz", RATIO),
    VECTOR(BEFORE, "v1x", "v1y", "v1z", SPEED),
    VECTOR(AFTER, "v2x", "v2y", "v2z", SPEED),
    VECTOR(SPIN, "omega1x", "omega1y", "omega1z", RATE),
    VECTOR(PLACE, "x", "y", "z", LENGTH),
};

/* ---- names and units ---- */

/* The column whose name is the longest beginning of a plain name, -1 if none, and the rest of the
 * name. */
static int find_column(const char *name, const char **rest) {
  for (size_t length = strlen(name); length > 0; length--)
    for (int c = 0; c < SCATTER_COLUMNS && (!name[length] || name[length] == '_'); c++)
      if (aspi_word_index(columns[c].names, name, length, true) >= 0) {
        *rest = name + length + (name[length] == '_');
        return c;
      }
  return -1;
}

/* The name of a column that is the mean, scatter or error of another one: `Mittelwert e_n` as
 * e_n_mean, `sd` behind e_n as e_n_sd. */
static void full_name(const char *plain, const char *before, char name[ASP_PLAIN_MOST]) {
  static const char *const words[][2] = {
      {"mean", "mean average avg mittelwert moyenne"},
      {"sd", "sd std s_d stdev std_dev standard_deviation standardabw standardabweichung"},
      {"se", "se sem s_e std_err standard_error standardfehler"}};
  snprintf(name, ASP_PLAIN_MOST, "%s", plain);
  for (int i = 0; i < 3; i++)
    for (size_t length = strlen(plain); length > 0; length--)
      if ((!plain[length] || plain[length] == '_') &&
          aspi_word_index(words[i][1], plain, length, true) >= 0) {
        const char *of = plain[length] ? plain + length + 1 : before;
        snprintf(name, ASP_PLAIN_MOST, "%.70s_%s", of, words[i][0]);
        return;
      }
}

/* The unit behind a column's name in SI, m/s written as m_s: 0 where none is stated, NAN if it is
 * not read, -1 if it is no unit but a part of another name. `stated`: the file has it in brackets.
 */
static double factor_of(const char *kind, const char *unit, bool stated) {
  char name[80];
  size_t n = 0;
  if (!*unit || (!*kind && strcmp(unit, "1") == 0))
    return *kind ? 0 : 1;
  for (; unit[n] && n + 1 < sizeof name; n++)
    name[n] = (char)(unit[n] == '_' ? '/' : unit[n]);
  const aspi_unit *u = aspi_unit_find(kind, name, n, false);
  if (u)
    return u->factor * pow(10, u->exponent);
  return stated || aspi_unit_find("unread", name, n, false) ? NAN : -1;
}

/* The unit of a ledger's column that has none in its name: of the units in the first comment, else
 * of SI; NAN if they have no size. */
static double ledger_unit(const char *header, const char *kind) {
  static const asp_units styles[] = {{"si", 1, 1, 1, {0}},
                                     {"cgs", 1e2, 1e3, 1, {0}},
                                     {"micro", 1e6, 1e15, 1e6, {0}},
                                     {"nano", 1e9, 1e21, 1e9, {0}}};
  const char *named = strstr(header, UNITS);
  named = named ? named + strlen(UNITS) : "si";
  if (!*kind || strcmp(kind, ANGLE) == 0)
    return 1;
  for (size_t i = 0; i < sizeof styles / sizeof *styles; i++)
    if (strlen(styles[i].name) == strcspn(named, ";\n") &&
        strncmp(styles[i].name, named, strlen(styles[i].name)) == 0)
      return 1 / aspi_quantity_factor(kind, &styles[i]);
  return NAN;
}

/* The unit of a column by its name; exits where it is not read, or one is missing. */
static double unit_of(cli_scatter *t, int place, int column, double factor) {
  const char *kind = columns[column].kind, *name = t->table->column[place].name;
  const char *path = t->table->text.path;
  const int own = (int)strcspn(columns[column].names, " ");
  char list[120];
  aspi_quantity_units(kind, list, sizeof list);
  if (isnan(factor))
    cli_bad_usage("%s: the unit of column '%s' is not read; it must be %s", path, name,
                  *list ? list : "none, as a coefficient is a number such as 0.5");
  if (factor > 0)
    return factor;
  if (t->is_ledger)
    return ledger_unit(t->table->header, kind);
  if (strcmp(kind, LENGTH) == 0)
    cli_bad_usage("%s: the unit of column '%s' is not stated; name it %.*s_um, _mm or _m", path,
                  name, own, columns[column].names);
  if (strcmp(kind, ANGLE) == 0 && column == ALPHA1)
    t->bare_angle = true;
  if (strcmp(kind, ANGLE) == 0)
    cli_warn("%s: the unit of column '%s' is not stated; it is taken as degrees (name it %.*s_deg "
             "or _rad)",
             path, name, own, columns[column].names);
  return 1;
}

void cli_scatter_choose(cli_scatter *t, const cli_option *choice) {
  char *list = cli_copy(choice->value), *item;
  while ((item = aspi_text_field(&list, ',')) != NULL) {
    char *name = aspi_text_field(&item, '=');
    const char *rest;
    int c = name ? find_column(name, &rest) : -1;
    int place = item ? aspi_table_asked(t->table, item, t->table->columns) : -1;
    if (c < 0 || *rest || place < 0)
      cli_bad_usage(
          "--%s is '%s'; it must be names of columns, each with a number from 1 to %d or a "
          "name of %s: alpha1=2,v1=3",
          choice->name, choice->value, t->table->columns, t->table->text.path);
    double factor = -1;
    for (const char *at = t->table->column[place].plain; *at && !(factor > 0); at += *at == '_') {
      factor = factor_of(columns[c].kind, at, false);
      at += strcspn(at, "_");
    }
    for (int other = 0; other < SCATTER_COLUMNS; other++)
      t->column_of[other] = t->column_of[other] == place ? -1 : t->column_of[other];
    t->column_of[c] = place;
    t->factor[c] = unit_of(t, place, c, factor > 0 ? factor : *columns[c].kind ? 0 : 1);
  }
}

void cli_scatter_turn(cli_scatter *t, const cli_option *from) {
  static const int angles[] = {ALPHA1, ALPHA2 + ASPI_IN_PLANE, ALPHA2 + ASPI_IN_SPACE,
                               MEAN + REBOUND_ANGLE};
  bool chosen = from && cli_choice(from) == 1;
  for (int i = 0; i < 4; i++) {
    int place = t->column_of[angles[i]];
    const char *name = place >= 0 ? t->table->column[place].plain : "";
    t->from_normal[angles[i]] = chosen || strstr(name, "normal");
    if (from && !chosen && strncmp(name, "theta", 5) == 0)
      cli_warn("%s: the angles of column '%s' are taken from the wall; --from normal turns those "
               "from its normal",
               t->table->text.path, t->table->column[place].name);
  }
  if (chosen && (t->column_of[COR_ALPHA] >= 0 || t->column_of[COR_ALPHA + ASPI_IN_SPACE] >= 0))
    cli_bad_usage("--from is 'normal'; cor_alpha is a ratio of angles from the wall");
}

cli_scatter cli_scatter_open(const char *path, int end) {
  cli_scatter t = {.table = cli_made(aspi_table_open(NULL, path, 0, &cli_error))};
  t.is_ledger = strstr(t.table->header, UNITS) || aspi_table_find(t.table, "tilt_out_deg") >= 0;
  for (int c = 0; c < SCATTER_COLUMNS; c++)
    t.column_of[c] = -1;
  const char *before = "";
  for (int i = 0; i < t.table->columns; i++) {
    const aspi_column *column = &t.table->column[i];
    char name[ASP_PLAIN_MOST];
    const char *rest;
    full_name(column->plain, before, name);
    int c = find_column(name, &rest);
    if (c >= POINT && c < SD) /* of a coefficient or its mean, for `sd` behind it */
      before = c == POINT || c == MEAN ? "cor_n" : c == MEAN + REBOUND_ANGLE ? "alpha2" : "cor_t";
    double factor = c >= 0 && c < end ? factor_of(columns[c].kind, rest, column->bracketed) : -1;
    if (factor < 0)
      continue;
    if (t.column_of[c] >= 0)
      cli_bad_usage("%s: columns %d and %d, '%s' and '%s', are the same; there must be one", path,
                    t.column_of[c] + 1, i + 1, t.table->column[t.column_of[c]].name, column->name);
    t.column_of[c] = i;
    t.factor[c] = unit_of(&t, i, c, factor);
  }
  cli_scatter_turn(&t, NULL);
  return t;
}

void cli_scatter_need(cli_scatter *t, int column, const char *hint) {
  char name[40];
  snprintf(name, sizeof name, "%.*s", (int)strcspn(columns[column].names, " "),
           columns[column].names);
  if (t->column_of[column] < 0) {
    aspi_table_need(t->table, name, &cli_error);
    cli_bad_usage("%s%s", cli_error.text, hint);
  }
  if (isnan(t->factor[column]))
    cli_bad_usage("%s: '%s' is in a ledger's units, which have no size in SI", t->table->text.path,
                  name);
  t->needed[column] = true;
}

/* ---- rows ---- */

/* Reads an outcome: a word, or the number of a ledger. */
static double outcome_of(const aspi_table *table, const char *word) {
  static const char *const words[] = {"rebound rebounded",
                                      "deposit deposited deleted stuck sticks"};
  char *end;
  double number = aspi_number(word, &end);
  bool is_number = end > word && !*end;
  for (int i = 0; i < 2; i++)
    if (is_number ? number >= i && number <= 2 * i
                  : aspi_word_index(words[i], word, strlen(word), false) >= 0)
      return i;
  cli_bad_usage("%s:%zu: outcome is '%.40s'; it must be rebound or deposit (or stuck, or 0 or 1)",
                table->text.path, table->text.line, word);
}

/* Cuts `0.52 ± 0.07`, `0.52 (0.07)` or `0.523(7)` behind the first number; returns the second one,
 * NAN if there is none. */
static double cut_error(char *field) {
  char *mark = strpbrk(field, "(+\xC2\xB1"), *number, *end;
  double error,
      decimals = mark ? (double)strcspn(field, " (") - (double)strcspn(field, ".,") - 1 : 0;
  if (!mark || mark == field)
    return NAN;
  number = mark + strspn(mark, "(+/-\xC2\xB1 ");
  end = number + strcspn(number, ")");
  *end = '\0';
  if (aspi_text_number(number, false, &error) != ASP_WORD_NUMBER)
    return NAN;
  bool last_digits = *mark == '(' && !strpbrk(number, ".,") && decimals > 0;
  *mark = '\0';
  return last_digits ? error * pow(10, -decimals) : error;
}

/* True if the first row has a mean with its scatter in a cell. */
static bool has_error(const cli_scatter *t, int column) {
  char copy[ASP_PLAIN_MOST];
  int at = t->column_of[column];
  if (at < 0 || !t->table->has_row || at >= t->table->count)
    return false;
  snprintf(copy, sizeof copy, "%s", t->table->fields[at]);
  return !isnan(cut_error(copy));
}

void cli_scatter_take_means(cli_scatter *t) {
  bool means = cli_scatter_has(t, COUNT), in_cells = false;
  for (int k = 0; k < COR_BOTH; k++) {
    in_cells = in_cells || has_error(t, POINT + k) || has_error(t, MEAN + k);
    means = means || in_cells || cli_scatter_has(t, SD + k);
  }
  for (int k = 0; k < COR_BOTH && means; k++)
    if (cli_scatter_has(t, POINT + k) && !cli_scatter_has(t, MEAN + k)) {
      t->column_of[MEAN + k] = t->column_of[POINT + k];
      t->factor[MEAN + k] = 1;
      t->column_of[POINT + k] = -1;
    }
  t->has_errors_in_cells = in_cells;
  if (in_cells)
    cli_warn("%s: the second numbers in the cells of means are taken as standard deviations",
             t->table->text.path);
}

bool cli_scatter_row(cli_scatter *t, double value[SCATTER_COLUMNS]) {
  bool found, missing;
  cli_must(!aspi_table_row(t->table, &found, &cli_error));
  for (int c = 0, first = t->count == 0; c < SCATTER_COLUMNS && first; c++)
    if (t->column_of[c] >= 0)
      t->used[t->count++] = c;
  for (int c = 0; c < SCATTER_COLUMNS; c++)
    value[c] = NAN;
  for (int k = 0; k < t->count && found; k++) {
    int c = t->used[k];
    double factor = strcmp(columns[c].kind, ANGLE) == 0 ? t->factor[c] : 1;
    double in_cell = t->has_errors_in_cells && c >= MEAN && c < SD
                         ? cut_error(t->table->fields[t->column_of[c]])
                         : NAN;
    if (!isnan(in_cell) && !cli_scatter_has(t, SD + c - MEAN))
      value[SD + c - MEAN] = in_cell;
    if (c == OUTCOME)
      value[c] = outcome_of(t->table, t->table->fields[t->column_of[c]]);
    else
      cli_must(!aspi_table_number(t->table, t->column_of[c], columns[c].least / factor,
                                  columns[c].most / factor, &value[c],
                                  t->needed[c] ? NULL : &missing, &cli_error));
    value[c] *= t->factor[c];
    value[c] = t->from_normal[c] ? 90 - value[c] : value[c];
  }
  if (!found)
    aspi_table_close(t->table);
  return found;
}
