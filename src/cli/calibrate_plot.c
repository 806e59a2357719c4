/* The picture of `asperity calibrate`: means and standard deviations of both coefficients over the
 * impact angle, measured and of the fitted model.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/calibrate.h"

#include <math.h>
#include <stdlib.h>

typedef struct point {
  double mean[COR_BOTH], sd[COR_BOTH];
} point;

/* What was measured in a bin. */
static point measured_in(const calibration *c, size_t b) {
  double alpha = cli_radians(c->bins[b].degrees), by[COR_BOTH] = {sin(alpha), cos(alpha)};
  const aspi_group *g = &c->groups[b];
  point p;
  for (int k = 0; k < COR_BOTH; k++) {
    p.mean[k] = g->used[MOMENT_X + k] ? g->mean[k] / by[k] : NAN;
    p.sd[k] = g->used[MOMENT_X + k] && g->sd[k] > 0 ? g->sd[k] / by[k] : 0;
  }
  return p;
}

static void print_panel(cli_plot *picture, const point *data, const point *model,
                        const calibration *c, int k) {
  const char *names[] = {"$data", "$model"};
  const point *of[] = {data, model};
  FILE *gp = cli_plot_stream(picture);
  for (int s = 0; s < 2; s++) {
    fprintf(gp, "%s%d << EOD\nNaN NaN NaN\n", names[s], k);
    for (size_t b = 0; b < c->n_bins; b++)
      if (isfinite(data[b].mean[k]) && isfinite(of[s][b].mean[k]))
        fprintf(gp, "%g %g %g\n", c->bins[b].degrees + (s ? 0.5 : -0.5), of[s][b].mean[k],
                isfinite(of[s][b].sd[k]) ? of[s][b].sd[k] : 0);
    fputs("EOD\n", gp);
  }
  fprintf(gp,
          "set ylabel 'CoR_%c'\n"
          "plot $data%d using 1:2:3 with yerrorbars pt 7 ps 0.8 lc rgb '#c8501e' lw 1.5 title "
          "'measured, mean ± sd', "
          "$model%d using 1:2:3 with yerrorbars ls 1 pt 5 ps 0.6 lw 1.5 title 'fitted model'\n",
          k ? 'T' : 'N', k, k);
}

void cli_calibrate_plot(const cli_option *option, const calibration *c, const char *data,
                        const char *title) {
  point *is = cli_allocate(c->n_bins, sizeof *is);
  point *fitted = cli_allocate(c->n_bins, sizeof *fitted);
  bool any[COR_BOTH] = {false, false};
  for (size_t b = 0; b < c->n_bins; b++) {
    is[b] = measured_in(c, b);
    calibrate_coefficients(c, b, fitted[b].mean, fitted[b].sd);
    for (int k = 0; k < COR_BOTH; k++)
      any[k] = any[k] || isfinite(is[b].mean[k]);
  }
  cli_plot *picture = cli_plot_open(option, 1200, 560);
  const char *named = cli_plot_title(picture);
  FILE *gp = cli_plot_stream(picture);
  fprintf(gp,
          "set multiplot layout 1,2 title '%s%s%s'\nset xrange [-2:92]\nset xtics 15\n"
          "set xlabel 'impact angle α_1 / degrees'\n"
          "set key outside above center horizontal\nset offsets 0,0,graph 0.04,graph 0.04\n",
          named ? named : cli_plot_label(picture, data).text, named ? "" : ":  ",
          named ? "" : cli_plot_label(picture, title).text);
  cli_plot_set_range(picture, NAN, NAN);
  for (int k = 0; k < COR_BOTH; k++)
    if (any[k])
      print_panel(picture, is, fitted, c, k);
  fputs("unset multiplot\n", gp);
  cli_plot_close(picture);
  free(is);
  free(fitted);
}
