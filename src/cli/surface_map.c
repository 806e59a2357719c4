/* asperity surface of a map: statistics of a measured map, and the slopes that a sphere of a given
 * size meets on it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"
#include "cli/surface.h"
#include "surface/ball.h"
#include "surface/describe.h"
#include "surface/size_law.h"

#include <math.h>
#include <stdlib.h>

enum { ROWS_AT_ONCE = 16 };

/* The contact slopes of a sphere; see aspi_gradient_describe. */
typedef struct slopes {
  double d_p, rms[2], skewness[2];
} slopes;

/* The dilation of the map by a sphere of each size, all of its points on all cores. */
static void measure(const cli_measured *m, const cli_list *sizes, slopes *all) {
  size_t rows = m->heights->rows, n = m->heights->columns * rows;
  float *z = cli_allocate(n, sizeof *z), *p = cli_allocate(n, sizeof *p),
        *q = cli_allocate(n, sizeof *q);
  cli_progress progress = cli_progress_begin("surface", (double)sizes->count);
  for (size_t i = 0; i < sizes->count; i++) {
    aspi_ball *ball = aspi_ball_create(m->heights, sizes->values[i], &cli_error);
    if (!ball)
      cli_bad_usage("--dp: %s", cli_error.text);
    size_t finished = 0;
#pragma omp parallel for schedule(dynamic)
    for (size_t j = 0; j < rows; j += ROWS_AT_ONCE) {
      size_t end = j + ROWS_AT_ONCE < rows ? j + ROWS_AT_ONCE : rows;
      aspi_ball_rows(ball, j, end, z, p, q);
#pragma omp critical
      cli_progress_show(&progress, (double)i + (double)(finished += end - j) / (double)rows);
    }
    aspi_ball_free(ball);
    all[i].d_p = sizes->values[i];
    aspi_gradient_describe(p, q, n, m->numbers.lay, all[i].rms, all[i].skewness);
  }
  cli_progress_end(&progress);
  free(z);
  free(p);
  free(q);
}

/* A number that there may not be. */
static void print_number(FILE *out, const char *name, double value, const char *unit) {
  if (isfinite(value))
    fprintf(out, ", %s %.6g%s", name, value, unit);
  else
    fprintf(out, ", %s beyond the map", name);
}

/* Prints the description of the map, and a row per size. */
static void print(FILE *out, const cli_measured *m, const slopes *rows, size_t count) {
  const asp_heights_numbers *d = &m->numbers;
  fputs("# map ", out);
  cli_print_comment(out, m->name);
  fprintf(out, ": %s\n# %zu x %zu points, %.6g x %.6g um apart\n", m->report.text,
          m->heights->columns, m->heights->rows, m->heights->step[0] * 1e6,
          m->heights->step[1] * 1e6);
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
      d->lambda_1 * 1e6, d->lambda_2 * 1e6, aspi_degrees(d->lay));
  fputs("dp_um,rq_um,lambda_1_um,lambda_2_um,lay_deg,phi_r,kappa,slope_rms_across,slope_rms_along,"
        "slope_skewness_across,slope_skewness_along\n",
        out);
  for (size_t i = 0; i < count; i++)
    fprintf(out, "%.6g,%.6g,%.6g,%.6g,%.4g,%.6g,%.6g,%.6g,%.6g,%.4g,%.4g\n", rows[i].d_p * 1e6,
            d->s_q * 1e6, d->lambda_1 * 1e6, d->lambda_2 * 1e6, aspi_degrees(d->lay),
            d->s_q / d->lambda_1, aspi_kappa(rows[i].d_p, d->s_q / d->lambda_1, d->lambda_1),
            rows[i].rms[0], rows[i].rms[1], rows[i].skewness[0], rows[i].skewness[1]);
}

/* The heights as SDF in text (ISO 25178-71), for the other commands and the wall's fix. */
static void save(const cli_call *call, const asp_heights *map) {
  FILE *out = cli_file_open(cli_value(call, "save"));
  fprintf(out,
          "aISO-1.0\nManufacID = asperity\nCreateDate = 000000000000\nModDate = 000000000000\n"
          "NumPoints = %zu\nNumProfiles = %zu\nXscale = %.17g\nYscale = %.17g\nZscale = 1e-6\n"
          "Zresolution = -1\nCompression = 0\nDataType = 7\nCheckType = 0\n*\n",
          map->columns, map->rows, map->step[0], map->step[1]);
  for (size_t j = 0; j < map->rows; j++)
    for (size_t i = 0; i < map->columns; i++)
      fprintf(out, "%.9g%c", (double)map->z[j * map->columns + i] * 1e6,
              i + 1 < map->columns ? ' ' : '\n');
  fputs("*\n", out);
  cli_file_close(out);
}

/* The table of the picture: the map, the lowest points of a sphere, and its contact slopes. */
static void plot(const cli_call *call, const asp_heights *map, double d_p) {
  size_t n = map->columns, count = n * map->rows;
  float *z = cli_allocate(count, sizeof *z), *p = cli_allocate(count, sizeof *p),
        *q = cli_allocate(count, sizeof *q);
  aspi_ball *ball = cli_made(aspi_ball_create(map, d_p, &cli_error));
  aspi_ball_rows(ball, 0, map->rows, z, p, q);
  aspi_ball_free(ball);
  FILE *out = cli_plot_open(call);
  fputs("x_um,y_um,z_um,lowest_um,slope_x,slope_y\n", out);
  for (size_t i = 0; i < count; i++)
    fprintf(out, "%.6g,%.6g,%.6g,%.6g,%.5g,%.5g\n", (double)(i % n) * map->step[0] * 1e6,
            (double)(i / n) * map->step[1] * 1e6, (double)map->z[i] * 1e6,
            ((double)z[i] - d_p / 2) * 1e6, (double)p[i], (double)q[i]);
  free(z);
  free(p);
  free(q);
  cli_plot_close(call, out, "map");
}

void cli_surface_map(const cli_call *call, const cli_description *wall, const cli_measured *m,
                     const cli_list *sizes) {
  slopes *rows = cli_allocate(sizes->count, sizeof *rows);
  measure(m, sizes, rows);
  FILE *out = cli_output_open(call, "output", wall->text);
  print(out, m, rows, sizes->count);
  cli_file_close(out);
  if (cli_value(call, "save"))
    save(call, m->heights);
  if (cli_value(call, "plot"))
    plot(call, m->heights, sizes->values[0]);
}
