/* The picture of `asperity trade`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/plot.h"
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

static void summarize(const trade_row *rows, size_t n, point *points) {
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

/* Divergences below this are drawn at this value: the rays resolve no less. */
#define NOISE 1e-4

void cli_trade_plot(const cli_option *options, const cli_description *wall, double d_p,
                    const trade_row *rows, size_t n) {
  size_t models = (size_t)asp_spread_count();
  point *points = cli_allocate(models, sizeof *points);
  summarize(rows, n, points);
  char most[40] = "", size[40] = "";
  if (n > models)
    snprintf(most, sizeof most, " … %g", rows[n - 1].angle);
  if (strcmp(asp_wall_word(wall->wall, "surface"), "sigma") != 0)
    snprintf(size, sizeof size, "; d_p = %.3g µm", d_p * 1e6);
  cli_plot *picture = cli_plot_open(&options[PLOT], 900, 560, "1,1", "%s%s; α_1 = %g%s°",
                                    cli_plot_wall(wall->wall).text, size, rows[0].angle, most);
  cli_plot_panel(picture, "mean time per impact / ns", "worst D_{KL} of the rebound angle, ± s.e.");
  cli_plot_log(picture, "xy");
  double least = INFINITY, best = INFINITY;
  for (size_t i = 0; i < models; i++)
    least = fmin(least, fmax(points[i].worst, NOISE));
  cli_plot_axis(picture, 'y', 0.5 * least, NAN);
  fputs("set xtics (20,50,100,200,500,1000,2000,5000,10000,20000,50000,100000)\n",
        cli_plot_stream(picture));
  cli_plot_series(picture, CLI_STAIRS, "guide");
  for (size_t i = 0; i < models; i++)
    if (fmax(points[i].worst, NOISE) < best) {
      best = fmax(points[i].worst, NOISE);
      cli_plot_row(picture, points[i].cost, best);
    }
  cli_plot_end(picture, "Pareto front");
  for (size_t i = 0; i < models; i++) {
    const char *name = asp_spread_name(points[i].model);
    cli_plot_series(picture, CLI_ERRORS, "model_%s", name);
    cli_plot_row(picture, points[i].cost, fmax(points[i].worst, NOISE), points[i].se);
    cli_plot_end(picture, "%s", cli_plot_label(name).text);
  }
  cli_plot_close(picture);
  free(points);
}
