/* The picture of `asperity surface` of a map: the map with its lay and the ellipse of its
 * autocorrelation, a section with the way of two spheres over it, the rms slopes by direction, and
 * the rebound and lateral angles of the map's own law beside those of a Gaussian wall with its
 * numbers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/judge.h"
#include "cli/surface_map.h"
#include "surface/ball.h"

#include <math.h>

enum { PIXELS = 300, SECTION = 600, IMPACTS = 100000 };

/* The flights of the picture come across the lay at this impact angle. */
#define ALPHA1 10.0

static void print_map(FILE *gp, const asp_map *m) {
  size_t by_x = m->columns / PIXELS + 1, by_y = m->rows / PIXELS + 1;
  fputs("$map << EOD\n", gp);
  for (size_t j = 0; j < m->rows; j += by_y) {
    for (size_t i = 0; i < m->columns; i += by_x)
      fprintf(gp, "%g %g %g\n", (double)i * m->step[0] * 1e6, (double)j * m->step[1] * 1e6,
              m->heights[j * m->columns + i] * 1e6);
    fputc('\n', gp);
  }
  fputs("EOD\n", gp);
}

/* Ten of the longer lengths of the middle row, and the lowest points of the spheres on it. */
static void print_section(FILE *gp, const cli_map *m, const double size[2]) {
  const asp_map *map = m->map;
  size_t row = map->rows / 2, count = (size_t)(10 * m->description.lambda_1 / map->step[0]);
  count = count < map->columns ? count : map->columns;
  size_t by = count / SECTION + 1;
  aspi_ball *ball[2];
  asp_error error;
  for (int k = 0; k < 2; k++)
    if (!(ball[k] = aspi_ball_create(map, size[k], &error)))
      cli_fail("%s", error.text);
  fputs("$section << EOD\n", gp);
  for (size_t i = 0; i < count; i += by) {
    fprintf(gp, "%g %g", (double)i * map->step[0] * 1e6,
            map->heights[row * map->columns + i] * 1e6);
    for (int k = 0; k < 2; k++) {
      aspi_touch touch = aspi_ball_touch(ball[k], i, row, false);
      fprintf(gp, " %g %g", (touch.height - size[k] / 2) * 1e6, cli_degrees(atan(touch.p)));
    }
    fputc('\n', gp);
  }
  fputs("EOD\n", gp);
  aspi_ball_free(ball[0]);
  aspi_ball_free(ball[1]);
}

static void print_polar(FILE *gp, const cli_map *m, const cli_map_slopes *rows, size_t count) {
  fputs("$polar << EOD\n", gp);
  for (int k = 0; k <= 360; k += 3) {
    double angle = k * ASP_PI / 180, c = cos(angle - m->description.lay),
           s = sin(angle - m->description.lay);
    fprintf(gp, "%g", angle);
    for (size_t i = 0; i < 2; i++) {
      const cli_map_slopes *r = &rows[i < count ? i : count - 1];
      fprintf(gp, " %g",
              sqrt(c * c * r->rms[1] * r->rms[1] + s * s * r->rms[0] * r->rms[0] +
                   2 * c * s * r->mixed));
    }
    fputc('\n', gp);
  }
  fputs("EOD\n", gp);
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

static void print_angles(FILE *gp, const cli_map *m, double d_p) {
  asp_error error;
  asp_surface *surface = asp_surface_create_map(m->map, true, &error);
  if (!surface)
    cli_fail("%s", error.text);
  aspi_angles own = rebounds(m, surface, d_p, "profile"),
              gauss = rebounds(m, surface, d_p, "visible");
  fputs("$angles << EOD\n", gp);
  for (int i = 0; i < ASPI_ANGLE_BINS; i++)
    fprintf(gp, "%g %g %g %g %g %g\n", i + 0.5, own.rebound[i] / own.n, gauss.rebound[i] / gauss.n,
            i - 89.5, own.lateral[i] / own.n, gauss.lateral[i] / gauss.n);
  fputs("EOD\n", gp);
  asp_surface_free(surface);
}

void cli_map_plot(const cli_option *option, const cli_map *m, const cli_map_slopes *rows,
                  size_t count) {
  const aspi_map_description *d = &m->description;
  double size[2] = {rows[0].d_p, rows[count > 1 ? 1 : 0].d_p};
  double width = (double)m->map->columns * m->map->step[0] * 1e6,
         height = (double)m->map->rows * m->map->step[1] * 1e6, reach = 0.3 * fmin(width, height);
  cli_plot *picture = cli_plot_open(option, 1300, 980);
  FILE *gp = cli_plot_stream(picture);
  print_map(gp, m->map);
  print_section(gp, m, size);
  print_polar(gp, m, rows, count);
  print_angles(gp, m, size[0]);
  if (cli_plot_title(picture))
    fprintf(gp, "set multiplot layout 2,2 title '%s'\n", cli_plot_title(picture));
  else
    fprintf(gp,
            "set multiplot layout 2,2 title '%s: S_q %.3g µm, S_{sk} %.2g, λ_1 %.3g µm, "
            "λ_2 %.3g µm'\n",
            cli_plot_label(picture, m->name).text, d->s_q * 1e6, d->s_sk, d->lambda_1 * 1e6,
            d->lambda_2 * 1e6);
  fprintf(gp,
          "set title 'heights, lay, and 1/e ellipse (x 3)'\nset xlabel 'x / µm'\nset ylabel 'y / "
          "µm'\nset size ratio %g\nset cblabel 'z / µm'\nset xrange [0:%g]\nset yrange [0:%g]\n"
          "set palette defined (0 '#08306b', 0.5 '#f7f7f7', 1 '#7f2704')\nset parametric\n"
          "set trange [0:2*pi]\n",
          height / width, width, height);
  double cx = width / 2, cy = height / 2, c = cos(d->lay), s = sin(d->lay);
  double a = 3e6 * d->lambda_2, b = 3e6 * d->lambda_1;
  fprintf(gp,
          "set arrow 1 from %g,%g to %g,%g nohead lw 2 lc rgb 'black' front\n"
          "plot $map using 1:2:3 with image notitle, %g+%g*cos(t)*%g-%g*sin(t)*%g, "
          "%g+%g*cos(t)*%g+%g*sin(t)*%g with lines lw 2 lc rgb 'black' notitle\n"
          "unset parametric\nunset arrow 1\n",
          cx - reach * c, cy - reach * s, cx + reach * c, cy + reach * s, cx, a, c, b, s, cy, a, s,
          b, c);
  fprintf(
      gp,
      "set size noratio\nset autoscale\nset title 'a section along x, and the lowest points of "
      "spheres on it'\nset xlabel 'x / µm'\nset ylabel 'z / µm'\n"
      "set offsets 0,0,graph 0.3,0\n"
      "plot $section using 1:2 with lines lc rgb '#888888' title 'wall', '' using 1:3 with lines "
      "lw 2 lc rgb '#0072b2' title 'd_p %g µm', '' using 1:5 with lines lw 2 lc rgb '#d55e00' "
      "title 'd_p %g µm'\n",
      size[0] * 1e6, size[1] * 1e6);
  fprintf(
      gp,
      "unset offsets\nset title 'rms contact slope by direction'\nset polar\nset size "
      "square\nunset xlabel\n"
      "unset ylabel\nset grid polar\nset rrange [0:*]\nset xtics axis\nset ytics axis\nunset "
      "rtics\nunset raxis\nunset border\n"
      "plot $polar using 1:2 with lines lw 2 lc rgb '#0072b2' title 'd_p %g µm', '' using 1:3 with "
      "lines lw 2 lc rgb '#d55e00' title 'd_p %g µm'\nunset polar\nset size nosquare\nset border\n"
      "unset grid\nset xtics border\nset ytics border\n",
      size[0] * 1e6, size[1] * 1e6);
  cli_plot_set_range(picture, 0, NAN);
  fprintf(gp,
          "set title 'across the lay at %g degrees, d_p %g µm (dots: Gaussian)'\nset xlabel 'angle "
          "/ degrees'\nset ylabel 'share per degree'\n"
          "set xrange [-45:120]\n"
          "plot $angles using 1:2 with histeps lw 2 lc rgb '#0072b2' title 'rebound angle', "
          "'' using 1:3 with points pt 7 ps 0.5 lc rgb '#0072b2' notitle, "
          "'' using 4:5 with histeps lw 2 lc rgb '#009e73' title 'lateral angle', "
          "'' using 4:6 with points pt 7 ps 0.5 lc rgb '#009e73' notitle\nunset multiplot\n",
          ALPHA1, size[0] * 1e6);
  cli_plot_close(picture);
}
