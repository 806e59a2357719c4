/* The picture of `asperity trade`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/trade.h"

#include <math.h>
#include <stdlib.h>

/* A model over all angles: its mean cost, and its worst divergence. */
typedef struct point {
  const asp_spread_model *model;
  double cost, worst;
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
      points[m].worst = fmax(points[m].worst, rows[i].rebound.kl);
    }
  }
  qsort(points, models, sizeof *points, by_cost);
}

/* Divergences below what the rays can tell are drawn at that. */
#define NOISE 1e-4

/* Gnuplot's open point types, which can be told apart when they lie on each other. */
static const int marks[] = {4, 6, 8, 10, 12, 14, 1, 2, 3, 15};

void cli_trade_plot(const cli_option *options, const trade_row *rows, size_t n) {
  size_t models = (size_t)asp_spread_count();
  point *points = malloc(models * sizeof *points);
  if (!points)
    cli_fail("out of memory");
  summarise(rows, n, points);
  cli_plot *picture = cli_plot_open(&options[PLOT], 900, 560);
  FILE *gp = cli_plot_stream(picture);
  fprintf(gp,
          "set title 'Wall r_q %s, {/Symbol l}_c %s; particles %s; {/Symbol a}_1 %s degrees'\n"
          "set xlabel 'time per impact / ns (mean over the angles)'\nset logscale xy\n"
          "set ylabel 'D_{KL} of the rebound angle against the geometry (worst angle)'\n"
          "set format y '%%g'\nset yrange [%g:*]\nset offsets graph 0.05, graph 0.05, 0, 0\n"
          "set xtics (20,50,100,200,500,1000,2000,5000)\n"
          "set key outside right center reverse Left samplen 1\n$points << EOD\n",
          cli_plot_label(picture, options[RQ].value).text,
          cli_plot_label(picture, options[LAMBDA_C].value).text,
          cli_plot_label(picture, options[DP].value).text,
          cli_plot_label(picture, options[ANGLES].value).text, 0.5 * NOISE);
  for (size_t i = 0; i < models; i++)
    fprintf(gp, "%g %g\n", points[i].cost, fmax(points[i].worst, NOISE));
  fputs("EOD\n$front << EOD\n", gp);
  double best = INFINITY;
  for (size_t i = 0; i < models; i++)
    if (fmax(points[i].worst, NOISE) < best) {
      best = fmax(points[i].worst, NOISE);
      fprintf(gp, "%g %g\n", points[i].cost, best);
    }
  fputs("EOD\nplot $front with steps lc rgb '#999999' lw 2 dt 2 title 'Pareto front'", gp);
  for (size_t i = 0; i < models; i++)
    fprintf(gp, ", $points every ::%zu::%zu with points ls %zu pt %d ps 1.8 title '%s'", i, i,
            i % 6 + 1, marks[i % (sizeof marks / sizeof *marks)],
            cli_plot_label(picture, asp_spread_name(points[i].model)).text);
  fputc('\n', gp);
  cli_plot_close(picture);
  free(points);
}
