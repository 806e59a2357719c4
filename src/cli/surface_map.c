/* asperity surface of a map: what a measured map is, and which slopes a sphere of a given size
 * finds on it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/surface_map.h"
#include "surface/ball.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS_AT_ONCE = 16 };

cli_map cli_map_read(const char *path, const aspi_profile_options *options) {
  asp_error error;
  cli_map m = {.name = path};
  m.map = aspi_map_read(NULL, path, options, &m.report, &error);
  if (!m.map)
    cli_bad_file(NULL, &error);
  if (aspi_map_describe(m.map, &m.description, &error) ||
      aspi_map_check(m.map, &m.description, 1, &error))
    cli_bad_usage("%s: %s", path, error.text);
  return m;
}

void cli_map_free(cli_map *m) {
  asp_map_free(m->map);
}

/* Buffers for the contacts of one size. */
typedef struct room {
  float *z, *p, *q;
} room;

static void measure_one(const cli_map *m, const room *r, double d_p, cli_map_slopes *row,
                        cli_progress *progress, double done) {
  asp_error error;
  aspi_ball *ball = aspi_ball_create(m->map, d_p, &error);
  if (!ball)
    cli_bad_usage("--dp: %s", error.text);
  size_t rows = m->map->rows, finished = 0;
#pragma omp parallel for schedule(dynamic)
  for (size_t j = 0; j < rows; j += ROWS_AT_ONCE) {
    size_t end = j + ROWS_AT_ONCE < rows ? j + ROWS_AT_ONCE : rows;
    aspi_ball_rows(ball, j, end, r->z, r->p, r->q);
#pragma omp critical
    cli_progress_show(progress, done + (double)(finished += end - j) / (double)rows);
  }
  aspi_ball_free(ball);
  row->d_p = d_p;
  aspi_gradient_describe(r->p, r->q, m->map->columns * rows, m->description.lay, row->rms,
                         row->skewness, &row->mixed);
}

void cli_map_slopes_measure(const cli_map *m, const cli_list *sizes, cli_map_slopes *rows) {
  room r;
  float **const all[] = {&r.z, &r.p, &r.q};
  for (size_t k = 0; k < 3; k++)
    if (!(*all[k] = aspi_map_room(m->map->columns, m->map->rows)))
      cli_fail("out of memory");
  cli_progress progress = cli_progress_begin("surface", (double)sizes->count);
  for (size_t i = 0; i < sizes->count; i++)
    measure_one(m, &r, sizes->values[i], &rows[i], &progress, (double)i);
  cli_progress_end(&progress);
  for (size_t k = 0; k < 3; k++)
    free(*all[k]);
}

/* A number that there may not be. */
static void print_number(FILE *out, const char *name, double value, const char *unit) {
  if (isfinite(value))
    fprintf(out, ", %s %.6g%s", name, value, unit);
  else
    fprintf(out, ", %s beyond the map", name);
}

void cli_map_print(FILE *out, const cli_map *m, const cli_map_slopes *rows, size_t count) {
  const aspi_map_description *d = &m->description;
  fputs("# map ", out);
  cli_print_comment(out, m->name);
  fprintf(out, ": %s\n# %zu x %zu points, %.6g x %.6g um apart\n", m->report.text, m->map->columns,
          m->map->rows, m->map->step[0] * 1e6, m->map->step[1] * 1e6);
  fprintf(out,
          "# ISO 25178-2, unfiltered: S_q %.6g um, S_a %.6g um, S_sk %.4g, S_ku %.4g, S_p %.6g um, "
          "S_v %.6g um, S_z %.6g um, S_dq %.4g",
          d->s_q * 1e6, d->s_a * 1e6, d->s_sk, d->s_ku, d->s_p * 1e6, d->s_v * 1e6, d->s_z * 1e6,
          d->s_dq);
  print_number(out, "S_al", d->s_al * 1e6, " um");
  print_number(out, "S_tr", d->s_tr, "");
  fprintf(
      out,
      "\n# ellipse of the autocorrelation 1/e: lambda_1 %.6g um across the lay, lambda_2 %.6g um "
      "along it, the lay %.4g deg from the rows\n",
      d->lambda_1 * 1e6, d->lambda_2 * 1e6, cli_degrees(d->lay));
  fputs("dp_um,rq_um,lambda_1_um,lambda_2_um,lay_deg,phi_r,kappa,slope_rms_across,slope_rms_along,"
        "slope_skewness_across,slope_skewness_along\n",
        out);
  for (size_t i = 0; i < count; i++)
    fprintf(out, "%.6g,%.6g,%.6g,%.6g,%.4g,%.6g,%.6g,%.6g,%.6g,%.4g,%.4g\n", rows[i].d_p * 1e6,
            d->s_q * 1e6, d->lambda_1 * 1e6, d->lambda_2 * 1e6, cli_degrees(d->lay), d->phi_r,
            sqrt(3) * rows[i].d_p * d->s_q / (d->lambda_1 * d->lambda_1), rows[i].rms[0],
            rows[i].rms[1], rows[i].skewness[0], rows[i].skewness[1]);
}

void cli_map_save(const cli_option *option, const cli_map *m) {
  const asp_map *map = m->map;
  cli_file *file = cli_file_open(strcmp(option->value, "-") == 0 ? "/dev/stdout" : option->value);
  FILE *out = cli_file_stream(file);
  fprintf(out,
          "aISO-1.0\nManufacID = asperity\nCreateDate = 000000000000\nModDate = 000000000000\n"
          "NumPoints = %zu\nNumProfiles = %zu\nXscale = %.17g\nYscale = %.17g\nZscale = 1e-6\n"
          "Zresolution = -1\nCompression = 0\nDataType = 7\nCheckType = 0\n*\n",
          map->columns, map->rows, map->step[0], map->step[1]);
  for (size_t j = 0; j < map->rows; j++)
    for (size_t i = 0; i < map->columns; i++)
      fprintf(out, "%.9g%c", (double)map->heights[j * map->columns + i] * 1e6,
              i + 1 < map->columns ? ' ' : '\n');
  fputs("*\n", out);
  cli_file_close(file);
}
