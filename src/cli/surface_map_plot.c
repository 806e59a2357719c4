/* The picture of `asperity surface` of a map: heights with the lay and the 1/e ellipse of the
 * autocorrelation, a section with the way of two spheres over it, rms contact slopes by direction,
 * and rebound and lateral angles by the map's own table and by a Gaussian wall with its numbers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/judge.h"
#include "cli/plot.h"
#include "cli/surface_map.h"
#include "surface/ball.h"

#include <math.h>

enum { PIXELS = 300, SECTION = 600, IMPACTS = 100000 };

/* The flights of the picture come across the lay at this impact angle. */
#define ALPHA1 10.0

/* ISO 25178-2 calls a surface with a greater texture aspect ratio S_tr isotropic. */
#define S_TR_ISOTROPIC 0.5

/* Along the lay as an arrow, and the ellipse three times as large, where there is a lay. */
static void plot_lay(cli_plot *plot, const aspi_map_description *d, double width, double height) {
  double cx = width / 2, cy = height / 2, reach = 0.3 * fmin(width, height);
  double c = cos(d->lay), s = sin(d->lay), a = 3e6 * d->lambda_2, b = 3e6 * d->lambda_1;
  for (int arrow = 0; arrow < 2; arrow++) {
    cli_plot_series(plot, CLI_LINE, "reference lw 2");
    if (arrow) {
      cli_plot_row(plot, cx - reach * c, cy - reach * s);
      cli_plot_row(plot, cx + reach * c, cy + reach * s);
    } else {
      for (int i = 0; i <= 100; i++) {
        double u = a * cos(2 * ASP_PI * i / 100), v = b * sin(2 * ASP_PI * i / 100);
        cli_plot_row(plot, cx + u * c - v * s, cy + u * s + v * c);
      }
    }
    cli_plot_end(plot, "%s", "");
  }
}

static void plot_heights(cli_plot *plot, const cli_map *map) {
  const asp_map *m = map->map;
  const aspi_map_description *d = &map->description;
  size_t by_x = m->columns / PIXELS + 1, by_y = m->rows / PIXELS + 1;
  double width = (double)m->columns * m->step[0] * 1e6, height = (double)m->rows * m->step[1] * 1e6;
  bool has_lay = !(d->s_tr > S_TR_ISOTROPIC);
  cli_plot_panel(plot, "x / µm", "y / µm");
  cli_plot_place(plot, 0, 0.47, 0.45, 0.48);
  cli_plot_scale(plot, true);
  cli_plot_axis(plot, 'x', 0, width);
  cli_plot_axis(plot, 'y', 0, height);
  if (has_lay)
    cli_plot_caption(plot, "heights, lay, and 1/e ellipse (× 3)");
  else
    cli_plot_caption(plot, "heights; no lay (S_{tr} %.2f)", d->s_tr);
  fputs("set cblabel 'z / µm'\n"
        "set palette defined (0 '#08306b', 0.5 '#f7f7f7', 1 '#7f2704')\n",
        cli_plot_stream(plot));
  cli_plot_series(plot, CLI_IMAGE, "palette");
  for (size_t j = 0; j < m->rows; j += by_y)
    for (size_t i = 0; i < m->columns; i += by_x)
      cli_plot_row(plot, (double)i * m->step[0] * 1e6, (double)j * m->step[1] * 1e6,
                   m->heights[j * m->columns + i] * 1e6);
  cli_plot_end(plot, "%s", "");
  if (has_lay)
    plot_lay(plot, d, width, height);
}

/* Ten of the longer lengths of the middle row, and the lowest points of a sphere on it. */
static void plot_section(cli_plot *plot, const cli_map *m, const double size[2]) {
  const asp_map *map = m->map;
  size_t row = map->rows / 2, count = (size_t)(10 * m->description.lambda_1 / map->step[0]);
  count = count < map->columns ? count : map->columns;
  size_t by = count / SECTION + 1;
  cli_plot_panel(plot, "x / µm", "z / µm");
  cli_plot_place(plot, 0.47, 0.47, 0.53, 0.48);
  cli_plot_scale(plot, false);
  cli_plot_caption(plot, "a section along x, and the lowest points of spheres on it");
  cli_plot_series(plot, CLI_LINE, "reference");
  for (size_t i = 0; i < count; i += by)
    cli_plot_row(plot, (double)i * map->step[0] * 1e6, map->heights[row * map->columns + i] * 1e6);
  cli_plot_end(plot, "wall");
  for (int k = 0; k < 2; k++) {
    asp_error error;
    aspi_ball *ball = aspi_ball_create(map, size[k], &error);
    if (!ball)
      cli_fail("%s", error.text);
    cli_plot_series(plot, CLI_LINE, "%d", k + 1);
    for (size_t i = 0; i < count; i += by) {
      aspi_touch touch = aspi_ball_touch(ball, i, row, false);
      cli_plot_row(plot, (double)i * map->step[0] * 1e6, (touch.height - size[k] / 2) * 1e6);
    }
    cli_plot_end(plot, "d_p %g µm", size[k] * 1e6);
    aspi_ball_free(ball);
  }
}

/* The rms slope in each direction, as the distance from the center. */
static void plot_directions(cli_plot *plot, const cli_map *m, const cli_map_slopes *rows,
                            size_t count) {
  cli_plot_panel(plot, "toward x", "toward y");
  cli_plot_place(plot, 0, 0, 0.33, 0.46);
  cli_plot_scale(plot, true);
  cli_plot_caption(plot, "rms contact slope by direction");
  fprintf(cli_plot_stream(plot), "set xtics %g\n",
          pow(10, floor(log10(2 * fmax(rows[0].rms[0], rows[0].rms[1])))));
  for (size_t i = 0; i < 2; i++) {
    const cli_map_slopes *r = &rows[i < count ? i : count - 1];
    cli_plot_series(plot, CLI_LINE, "%zu", i + 1);
    for (int k = 0; k <= 360; k += 3) {
      double angle = k * ASP_PI / 180, c = cos(angle - m->description.lay),
             s = sin(angle - m->description.lay);
      double rms = sqrt(c * c * r->rms[1] * r->rms[1] + s * s * r->rms[0] * r->rms[0] +
                        2 * c * s * r->mixed);
      cli_plot_row(plot, rms * cos(angle), rms * sin(angle));
    }
    cli_plot_end(plot, "d_p %g µm", r->d_p * 1e6);
  }
}

/* Rebounds across the lay by one model. */
static aspi_angles rebounds(const cli_map *m, asp_surface *surface, double d_p, const char *model) {
  static const double lay[3] = {0, 1, 0};
  aspi_judge_walls of = {.folds = 1, .surface = {surface}, .map = {m->map}, .in_space = true};
  asp_error error;
  asp_wall *wall = aspi_judge_wall(&of, 0, d_p, model, true, &error);
  if (!wall)
    cli_bad_file(NULL, &error);
  aspi_angles all = aspi_judge_rebounds(wall, d_p, lay, ALPHA1, IMPACTS, 1);
  asp_wall_free(wall);
  return all;
}

/* A histogram of angles by the map's table and by a Gaussian wall; it begins at `first` degrees. */
static void plot_angles(cli_plot *plot, const char *x, double first, const double *own,
                        const double *gauss) {
  cli_plot_panel(plot, x, "share per degree");
  cli_plot_place(plot, first < 0 ? 0.66 : 0.33, 0, 0.33, 0.46);
  cli_plot_axis(plot, 'x', first < 0 ? -60 : 0, first < 0 ? 60 : 90);
  cli_plot_axis(plot, 'y', 0, NAN);
  cli_plot_caption(plot, "across the lay at %g degrees", ALPHA1);
  for (int model = 0; model < 2; model++) {
    cli_plot_series(plot, CLI_HISTO, model ? "model_visible" : "model_profile");
    for (int i = 0; i < ASPI_ANGLE_BINS; i++)
      cli_plot_row(plot, first + i + 0.5, (model ? gauss : own)[i] / IMPACTS);
    cli_plot_end(plot, model ? "Gaussian (visible)" : "this map (profile)");
  }
}

void cli_map_plot(const cli_option *option, const cli_map *m, const cli_map_slopes *rows,
                  size_t count) {
  const aspi_map_description *d = &m->description;
  double size[2] = {rows[0].d_p, rows[count > 1 ? 1 : 0].d_p};
  asp_error error;
  asp_surface *surface = asp_surface_create_map(m->map, true, &error);
  if (!surface)
    cli_fail("%s", error.text);
  aspi_angles own = rebounds(m, surface, size[0], "profile"),
              gauss = rebounds(m, surface, size[0], "visible");
  cli_plot *plot = cli_plot_open(
      option, 1300, 980, NULL, "%s: S_q %.3g µm, S_{sk} %.2g, λ_1 %.3g µm, λ_2 %.3g µm",
      cli_plot_file(m->name).text, d->s_q * 1e6, d->s_sk, d->lambda_1 * 1e6, d->lambda_2 * 1e6);
  plot_heights(plot, m);
  plot_section(plot, m, size);
  plot_directions(plot, m, rows, count);
  plot_angles(plot, "rebound angle / degrees", 0, own.rebound, gauss.rebound);
  plot_angles(plot, "lateral angle / degrees", -90, own.lateral, gauss.lateral);
  cli_plot_close(plot);
  asp_surface_free(surface);
}
