/* Tables of impacts, as `asperity cor` and the ledger of a wall write them, and of measured
 * coefficients of restitution: a row per impact, or per mean of some. Exits on a file that is none.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "analysis/impacts.h"
#include "base/table.h"
#include "cli/cli.h"

/* Columns. Those of a rebound's velocity are there once for each projection: V2 + ASPI_IN_PLANE.
 * Those from MESH on are of ledgers only. */
enum {
  ALPHA1,
  V1,
  ALPHA2,
  V2 = ALPHA2 + ASPI_PROJECTIONS,
  COR_ALPHA = V2 + ASPI_PROJECTIONS,
  COR_V = COR_ALPHA + ASPI_PROJECTIONS,
  V1_N = COR_V + ASPI_PROJECTIONS,
  V1_T,
  V2_N,
  V2_T,
  POINT,                   /* cor_n, cor_t */
  MEAN = POINT + COR_BOTH, /* and of the rebound's angle, here and below */
  SD = MEAN + ASPI_COMPARED,
  SE = SD + ASPI_COMPARED,
  COUNT = SE + ASPI_COMPARED,
  PSI, /* tangential speed of the contact point before and after, over the normal one before */
  D_P = PSI + 2,
  RADIUS,
  OUTCOME, /* 1 for a deposit, else 0 */
  MESH,
  TRIANGLE,
  KELVIN,
  MASS,
  ERODED,
  DELTA_ALPHA,
  TILT_OUT,
  HITS,
  TAG,
  IMPACT,
  BODY,
  NORMAL, /* three numbers, here and below */
  BEFORE = NORMAL + 3,
  AFTER = BEFORE + 3,
  SPIN = AFTER + 3,
  PLACE = SPIN + 3,
  SCATTER_COLUMNS = PLACE + 3
};

/* A table that is read row by row. For each column: its place in the file (-1: missing) and its
 * unit in SI (angles: degrees; NAN: unknown, as in `units lj`). */
typedef struct cli_scatter {
  aspi_table *table;
  bool is_ledger;
  bool bare_angle;          /* the impact angle has no unit */
  bool has_errors_in_cells; /* means are `0.52 ± 0.07` */
  bool needed[SCATTER_COLUMNS];
  int column_of[SCATTER_COLUMNS];
  int used[SCATTER_COLUMNS], count;  /* those that there are, when rows are read */
  bool from_normal[SCATTER_COLUMNS]; /* angles of the file that are turned */
  double factor[SCATTER_COLUMNS];
} cli_scatter;

/* Opens a table for the columns below `end`. */
cli_scatter cli_scatter_open(const char *path, int end);

/* Takes the columns that the user names: `alpha1=2,v1=speed`, by number or name. */
void cli_scatter_choose(cli_scatter *table, const cli_option *choice);

/* Turns angles that the file counts from the normal, by its name or by the user, into angles from
 * the wall. */
void cli_scatter_turn(cli_scatter *table, const cli_option *from);

/* Takes coefficients as means where there is their scatter or their number. */
void cli_scatter_take_means(cli_scatter *table);

/* Exits, with a hint, unless there is a column, with a number in each row. */
void cli_scatter_need(cli_scatter *table, int column, const char *hint);

/* The numbers of the next row in SI and degrees, NAN if missing; false at the end of the file,
 * which is then closed. */
bool cli_scatter_row(cli_scatter *table, double value[SCATTER_COLUMNS]);

/* Impacts of a model or a simulation, which have coefficients, as `data` has them (NULL: none); and
 * measured data of any form. Sorted by angle, speed, size. Impacts of one group become one row
 * (NULL: a row each); rows of means are never merged. */
aspi_scatter cli_scatter_read_impacts(const char *path, const aspi_scatter *data,
                                      const aspi_grouping *grouping);
aspi_scatter cli_scatter_read_data(const cli_call *call, const char *path,
                                   const aspi_grouping *grouping);

static inline bool cli_scatter_has(const cli_scatter *table, int column) {
  return table->column_of[column] >= 0;
}

/* The columns that give the coefficients, in this order where there are several. */
typedef struct cli_scatter_form {
  bool means, points, components, normal; /* normal: components along the normal alone */
  bool drops;                             /* speeds without angles: along the normal */
  bool psi;                               /* tangents in place of angles */
  aspi_projection ratios, velocities;     /* ASPI_PROJECTIONS: none */
  aspi_projection angles;                 /* alone; the same */
} cli_scatter_form;
cli_scatter_form cli_scatter_find_form(cli_scatter *table);

/* A row of such a table. */
aspi_scatter_row cli_scatter_row_of(const cli_scatter_form *form, const double value[]);

/* Options of a command that reads such data. */
#define SCATTER_OPTIONS                                                                            \
  {"columns", "NAME=N[,...]",                                                                      \
   "columns of DATA by number or name, if its own names do not say: alpha1=2,v1=speed", NULL},     \
  {                                                                                                \
    "from", "wall|normal", "what the angles of DATA are counted from", "wall"                      \
  }

/* The part of a command's help about the columns. */
#define SCATTER_FORMS                                                                              \
  "DATA is CSV (- is standard input). A name may carry its unit: alpha1_deg or alpha1_rad,\n"      \
  "v1_m_s, dp_um (or _mm, _m), also in brackets, or in a line of its own below the names. An\n"    \
  "angle without a unit is in degrees, with a warning, a speed in m/s; a length must have one.\n"  \
  "impact_angle, alpha_in, theta_i are alpha1, rebound_angle, alpha_out, theta_r alpha2_plane,\n"  \
  "v_in and v_out v1 and v2_plane; e_n and e_t are cor_n and cor_t, _std and _sem are _sd and\n"   \
  "_se, radius is half of dp. Titles and `sep=;` may precede the names. The command takes\n"       \
  "these columns, where they are there:\n"                                                         \
  "  impacts  alpha1, v1, alpha2_plane, v2_plane | alpha1, cor_v_plane, cor_alpha_plane |\n"       \
  "           v1_n, v1_t, v2_n, v2_t | v1_n, v2_n | alpha1, cor_n, cor_t |\n"                      \
  "           v1, cor_n (along the normal) | psi1, psi2, cor_n (spheres, without spin) |\n"        \
  "           alpha1, alpha2_plane; with outcome (rebound or deposit), cor_n_se, cor_t_se\n"       \
  "  means    alpha1, cor_n_mean, cor_t_mean | alpha1, alpha2_plane_mean; with n and _sd\n"        \
  "           or _se in place of _mean, or as sd, se behind the mean, or 0.52 ± 0.07 in a cell\n" \
  "           (0.52 (0.07), 0.52(7))\n"                                                            \
  "and v1, dp with either. Give a polynomial by points on it, as means. _plane is the velocity\n"  \
  "in the plane of incidence, as one camera sees it; that in space is alpha2_space (0 to 90\n"     \
  "degrees from the wall), v2_space, cor_v_space and cor_alpha_space.\n"                           \
  "Rebounds that noise put below the wall are mirrored at it.\n"
