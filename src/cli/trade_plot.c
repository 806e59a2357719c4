/* The picture of `asperity trade`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/trade.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A model over all angles: its mean cost, and its worst divergence with the standard error. */
typedef struct point {
  const asp_spread_model *model;
  double cost, worst, se; /* of the worst */
} point;

static int by_cost(const void *a, const void *b) {
  const point *x = a, *y = b;
  return (x->cost > y->cost) - (x->cost < y->cost);
}

static void summarise(const trade_row *rows, size_t n, point *points) {
  size_t models = (size_t)asp_spread_count();
  for (size_t m = 0; m < models; m++) {
    points[m] = (point){.model = rows[m].model};
    for (size_t i = m; i < n; i += models) {
      points[m].cost += rows[i].cost * (double)models / (double)n;
      if (i == m || rows[i].rebound.kl > points[m].worst) {
        points[m].worst = rows[i].rebound.kl;
        points[m].se = rows[i].rebound.se;
      }
    }
  }
  qsort(points, models, sizeof *points, by_cost);
}

/* Divergences below what the rays can tell are drawn at that. */
#define NOISE 1e-4

/* Gnuplot's open point types, which can be told apart when they lie on each other. */
static const int marks[] = {4, 6, 8, 10, 12, 14, 1, 2, 3, 15};

/* The wall in the title. */
static void print_wall(FILE *gp, const cli_plot *picture, const asp_wall *wall, double d_p) {
  const asp_surface *surface = asp_wall_surface(wall);
  const char *file = asp_wall_word(wall, "file");
  if (strcmp(asp_wall_word(wall, "surface"), "sigma") == 0) {
    fprintf(gp, "Wall σ %.4g°", cli_degrees(atan(asp_surface_slope_rms(surface))));
    return;
  }
  fprintf(gp, "Wall %s%sr_q %.3g µm, λ_c %.3g µm; particles %.3g µm",
          file ? cli_plot_label(picture, file).text : "", file ? ", " : "",
          asp_surface_r_q(surface) * 1e6, asp_surface_lambda_c(surface) * 1e6, d_p * 1e6);
}

static void put_title(cli_plot *picture, const asp_wall *wall, double d_p, const trade_row *rows,
                      size_t n) {
  FILE *gp = cli_plot_stream(picture);
  fputs("set title '", gp);
  if (cli_plot_title(picture)) {
    fprintf(gp, "%s'\n", cli_plot_title(picture));
    return;
  }
  print_wall(gp, picture, wall, d_p);
  fputs("; α_1 = ", gp);
  for (size_t i = 0; i < n; i += (size_t)asp_spread_count())
    fprintf(gp, "%s%g", i ? ", " : "", rows[i].angle);
  fputs("°'\n", gp);
}

void cli_trade_plot(const cli_option *options, const cli_description *wall, double d_p,
                    const trade_row *rows, size_t n) {
  size_t models = (size_t)asp_spread_count();
  point *points = cli_allocate(models, sizeof *points);
  summarise(rows, n, points);
  cli_plot *picture = cli_plot_open(&options[PLOT], 900, 560);
  FILE *gp = cli_plot_stream(picture);
  put_title(picture, wall->wall, d_p, rows, n);
  double least = INFINITY;
  for (size_t i = 0; i < models; i++)
    least = fmin(least, fmax(points[i].worst, NOISE));
  cli_plot_set_range(picture, 0.5 * least, NAN);
  fprintf(gp, "%s",
          "set xlabel 'time per impact / ns (mean over the angles)'\nset logscale xy\n"
          "set ylabel 'D_{KL} of the rebound angle against the geometry (worst angle, ± standard "
          "error)'\n"
          "set format y '%g'\nset offsets graph 0.05, graph 0.05, 0, 0\n"
          "set xtics (20,50,100,200,500,1000,2000,5000)\n"
          "set key outside right center reverse Left samplen 1\n$points << EOD\n");
  for (size_t i = 0; i < models; i++)
    fprintf(gp, "%g %g %g %g\n", points[i].cost, fmax(points[i].worst, NOISE),
            fmax(points[i].worst - points[i].se, 0.5 * NOISE),
            fmax(points[i].worst + points[i].se, NOISE));
  fputs("EOD\n$front << EOD\n", gp);
  double best = INFINITY;
  for (size_t i = 0; i < models; i++)
    if (fmax(points[i].worst, NOISE) < best) {
      best = fmax(points[i].worst, NOISE);
      fprintf(gp, "%g %g\n", points[i].cost, best);
    }
  fputs("EOD\nplot $front with steps lc rgb '#999999' lw 2 dt 2 title 'Pareto front'", gp);
  for (size_t i = 0; i < models; i++)
    fprintf(gp, ", $points every ::%zu::%zu with yerrorbars ls %zu dt 1 pt %d ps 1.8 title '%s'", i,
            i, i % 6 + 1, marks[i % (sizeof marks / sizeof *marks)],
            cli_plot_label(picture, asp_spread_name(points[i].model)).text);
  fputc('\n', gp);
  cli_plot_close(picture);
  free(points);
}
