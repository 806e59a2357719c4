/* asperity surface of a map: what a measured map is, and which slopes a sphere of a given size
 * finds on it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/plot.h"
#include "cli/surface.h"
#include "surface/ball.h"
#include "surface/describe.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS_AT_ONCE = 16 };

/* A measured map, what was done to it, and what it is. */
typedef struct measured {
  asp_map *map;
  aspi_profile_report report;
  aspi_map_description description;
  const char *name;
} measured;

/* The contact slopes of a sphere; see aspi_gradient_describe. */
typedef struct slopes {
  double d_p, rms[2], skewness[2], mixed;
} slopes;

/* Reads and describes a map, in meters. */
static measured read_map(const char *path, const aspi_profile_options *options) {
  asp_error error;
  measured m = {.name = path};
  m.map = aspi_map_read(NULL, path, options, &m.report, &error);
  cli_must(m.map, &error);
  if (aspi_map_describe(m.map, &m.description, &error) ||
      aspi_map_check(m.map, &m.description, 1, &error))
    cli_bad_usage("%s: %s", path, error.text);
  return m;
}

/* The dilation of the map by a sphere of each size, all of its points on all cores. */
static void measure(const measured *m, const cli_list *sizes, slopes *all) {
  size_t rows = m->map->rows, n = m->map->columns * rows;
  float *z = cli_allocate(n, sizeof *z), *p = cli_allocate(n, sizeof *p),
        *q = cli_allocate(n, sizeof *q);
  cli_progress progress = cli_progress_begin("surface", (double)sizes->count);
  for (size_t i = 0; i < sizes->count; i++) {
    asp_error error;
    aspi_ball *ball = aspi_ball_create(m->map, sizes->values[i], &error);
    if (!ball)
      cli_bad_usage("--dp: %s", error.text);
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
    aspi_gradient_describe(p, q, n, m->description.lay, all[i].rms, all[i].skewness, &all[i].mixed);
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
static void print(FILE *out, const measured *m, const slopes *rows, size_t count) {
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

/* The heights as SDF in text (ISO 25178-71), for the other commands and the wall's fix. */
static void save(const cli_call *call, const asp_map *map) {
  FILE *out = cli_file_open(cli_value(call, "save"));
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
  cli_file_close(out);
}

/* ---- the picture ---- */

enum { PIXELS = 300, SECTION = 600 };

/* ISO 25178-2 calls a surface with a greater texture aspect ratio S_tr isotropic. */
#define S_TR_ISOTROPIC 0.5

/* Along the lay as an arrow, and the ellipse three times as large, where there is a lay. */
static void plot_lay(cli_plot *picture, const aspi_map_description *d, double width,
                     double height) {
  double cx = width / 2, cy = height / 2, reach = 0.3 * fmin(width, height);
  double c = cos(d->lay), s = sin(d->lay), a = 3e6 * d->lambda_2, b = 3e6 * d->lambda_1;
  for (int arrow = 0; arrow < 2; arrow++) {
    cli_plot_series(picture, CLI_LINE, "reference lw 2");
    if (arrow) {
      cli_plot_row(picture, cx - reach * c, cy - reach * s);
      cli_plot_row(picture, cx + reach * c, cy + reach * s);
    } else {
      for (int i = 0; i <= 100; i++) {
        double u = a * cos(2 * ASP_PI * i / 100), v = b * sin(2 * ASP_PI * i / 100);
        cli_plot_row(picture, cx + u * c - v * s, cy + u * s + v * c);
      }
    }
    cli_plot_end(picture, "%s", "");
  }
}

static void plot_heights(cli_plot *picture, const measured *map) {
  const asp_map *m = map->map;
  const aspi_map_description *d = &map->description;
  size_t by_x = m->columns / PIXELS + 1, by_y = m->rows / PIXELS + 1;
  double width = (double)m->columns * m->step[0] * 1e6, height = (double)m->rows * m->step[1] * 1e6;
  bool has_lay = !(d->s_tr > S_TR_ISOTROPIC);
  cli_plot_panel(picture, "x / µm", "y / µm");
  cli_plot_place(picture, 0, 0.45, 0.55, 0.5);
  cli_plot_scale(picture, true);
  cli_plot_axis(picture, 'x', 0, width);
  cli_plot_axis(picture, 'y', 0, height);
  if (has_lay)
    cli_plot_caption(picture, "heights, lay, and 1/e ellipse (× 3)");
  else
    cli_plot_caption(picture, "heights; no lay (S_{tr} %.2f)", d->s_tr);
  fputs("set cblabel 'z / µm'\n"
        "set palette defined (0 '#08306b', 0.5 '#f7f7f7', 1 '#7f2704')\n",
        cli_plot_stream(picture));
  cli_plot_series(picture, CLI_IMAGE, "palette");
  for (size_t j = 0; j < m->rows; j += by_y)
    for (size_t i = 0; i < m->columns; i += by_x)
      cli_plot_row(picture, (double)i * m->step[0] * 1e6, (double)j * m->step[1] * 1e6,
                   m->heights[j * m->columns + i] * 1e6);
  cli_plot_end(picture, "%s", "");
  if (has_lay)
    plot_lay(picture, d, width, height);
}

/* Ten of the longer lengths of the middle row, and the lowest points of a sphere on it. */
static void plot_section(cli_plot *picture, const measured *m, const double size[2]) {
  const asp_map *map = m->map;
  size_t row = map->rows / 2, count = (size_t)(10 * m->description.lambda_1 / map->step[0]);
  count = count < map->columns ? count : map->columns;
  size_t by = count / SECTION + 1;
  cli_plot_panel(picture, "x / µm", "z / µm");
  cli_plot_place(picture, 0, 0, 1, 0.42);
  cli_plot_scale(picture, false);
  cli_plot_caption(picture, "a section along x, and the lowest points of spheres on it");
  cli_plot_series(picture, CLI_LINE, "reference");
  for (size_t i = 0; i < count; i += by)
    cli_plot_row(picture, (double)i * map->step[0] * 1e6,
                 map->heights[row * map->columns + i] * 1e6);
  cli_plot_end(picture, "wall");
  for (int k = 0; k < 2; k++) {
    asp_error error;
    aspi_ball *ball = aspi_ball_create(map, size[k], &error);
    if (!ball)
      cli_fail("%s", error.text);
    cli_plot_series(picture, CLI_LINE, "%d", k + 1);
    for (size_t i = 0; i < count; i += by) {
      aspi_touch touch = aspi_ball_touch(ball, i, row, false);
      cli_plot_row(picture, (double)i * map->step[0] * 1e6, (touch.height - size[k] / 2) * 1e6);
    }
    cli_plot_end(picture, "d_p %g µm", size[k] * 1e6);
    aspi_ball_free(ball);
  }
}

/* The rms slope in each direction, as the distance from the center. */
static void plot_directions(cli_plot *picture, const measured *m, const slopes *rows,
                            size_t count) {
  cli_plot_panel(picture, "toward x", "toward y");
  cli_plot_place(picture, 0.6, 0.45, 0.4, 0.5);
  cli_plot_scale(picture, true);
  cli_plot_caption(picture, "rms contact slope by direction");
  double most = fmax(rows[0].rms[0], rows[0].rms[1]), tick = pow(10, floor(log10(most)));
  fprintf(cli_plot_stream(picture), "set xtics %g\n", most < 4 * tick ? tick : 2 * tick);
  for (size_t i = 0; i < 2; i++) {
    const slopes *r = &rows[i < count ? i : count - 1];
    cli_plot_series(picture, CLI_LINE, "%zu", i + 1);
    for (int k = 0; k <= 360; k += 3) {
      double angle = k * ASP_PI / 180, c = cos(angle - m->description.lay),
             s = sin(angle - m->description.lay);
      double rms = sqrt(c * c * r->rms[1] * r->rms[1] + s * s * r->rms[0] * r->rms[0] +
                        2 * c * s * r->mixed);
      cli_plot_row(picture, rms * cos(angle), rms * sin(angle));
    }
    cli_plot_end(picture, "d_p %g µm", r->d_p * 1e6);
  }
}

/* The picture of the first two sizes: heights with the lay and the 1/e ellipse of the
 * autocorrelation, rms contact slopes by direction, and a section with the way of two spheres over
 * it. */
static void plot(const cli_call *call, const measured *m, const slopes *rows, size_t count) {
  const aspi_map_description *d = &m->description;
  double size[2] = {rows[0].d_p, rows[count > 1 ? 1 : 0].d_p};
  cli_plot *picture = cli_plot_open(
      call, 1300, 900, NULL, "%s: S_q %.3g µm, S_{sk} %.2g, λ_1 %.3g µm, λ_2 %.3g µm",
      cli_plot_file(m->name).text, d->s_q * 1e6, d->s_sk, d->lambda_1 * 1e6, d->lambda_2 * 1e6);
  plot_heights(picture, m);
  plot_directions(picture, m, rows, count);
  plot_section(picture, m, size);
  cli_plot_close(picture);
}

void cli_surface_map(const cli_call *call, const cli_description *wall,
                     const aspi_profile_options *options, const cli_list *sizes) {
  measured m = read_map(asp_description_word(wall->words, "file"), options);
  const double *step = m.map->step;
  double sides[2] = {(double)m.map->columns * step[0], (double)m.map->rows * step[1]};
  cli_surface_check(m.name, "map", &m.report, fmax(step[0], step[1]), fmin(sides[0], sides[1]),
                    m.description.lambda_2, sizes);
  slopes *rows = cli_allocate(sizes->count, sizeof *rows);
  measure(&m, sizes, rows);
  FILE *out = cli_output_open(call, "output", wall->text);
  print(out, &m, rows, sizes->count);
  cli_file_close(out);
  if (cli_value(call, "save"))
    save(call, m.map);
  if (cli_value(call, "plot"))
    plot(call, &m, rows, sizes->count);
}
