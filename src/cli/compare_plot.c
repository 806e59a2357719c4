/* The picture of `asperity compare`: both coefficients over the impact angle, the model as a band,
 * the measurements as points or as means with their standard deviations.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/compare.h"

#include <math.h>

/* The range of a panel: what is measured and the model's band with some room, but no more than
 * CoR_N 0 to 3 and CoR_T -1 to 2; ratios to a vanishing component go far beyond. */
static void print_range(FILE *gp, const comparison *c, int which) {
  double low = 0, high = 1, least = which ? -1 : 0, most = which ? 2 : 3;
  for (size_t i = 0; i < c->count; i++) {
    const compare_bin *b = &c->bins[which][i];
    double sd = isfinite(b->data.sd) ? b->data.sd : 0;
    low = fmin(low, fmin(b->data.mean - sd, b->model.low));
    high = fmax(high, fmax(b->data.mean + sd, b->model.high));
  }
  double room = 0.25 * (high - low);
  fprintf(gp, "set yrange [%g:%g]\n", fmax(least, low - (low < 0 ? room : 0)),
          fmin(most, high + room));
}

static void print_series(FILE *gp, const comparison *c, int which) {
  fprintf(gp, "$model%d << EOD\n", which);
  for (size_t i = 0; i < c->count; i++) {
    const compare_bin *b = &c->bins[which][i];
    if (isfinite(b->model.low))
      fprintf(gp, "%g %g %g %g %g\n", b->middle, b->model.low, b->model.high, b->model.median,
              b->model.mean);
  }
  fprintf(gp, "EOD\n$points%d << EOD\nNaN NaN\n", which);
  for (size_t i = 0; i < c->data.n_points; i++)
    if (isfinite(c->data.points[i].cor[which]))
      fprintf(gp, "%g %g\n", c->data.points[i].degrees, c->data.points[i].cor[which]);
  fprintf(gp, "EOD\n$data%d << EOD\n", which);
  for (size_t i = 0; i < c->count; i++) {
    const compare_bin *b = &c->bins[which][i];
    if (cli_compare_has_data(b))
      fprintf(gp, "%g %g %g\n", b->middle, b->data.mean, isfinite(b->data.sd) ? b->data.sd : 0);
  }
  fputs("EOD\n", gp);
}

static void plot_panel(FILE *gp, const comparison *c, int which) {
  print_series(gp, c, which);
  print_range(gp, c, which);
  fprintf(gp, "set ylabel 'CoR_%c'\nset key %s opaque\nplot ", which ? 'T' : 'N',
          which ? "bottom left" : "top right");
  fprintf(gp,
          "$model%d using 1:2:3 with filledcurves fc rgb '#c6d9ee' title 'model, 5 to 95 %%', "
          "$model%d using 1:5 with lines ls 1 title 'model, mean', "
          "$model%d using 1:4 with lines ls 1 lw 1 dt 2 title 'model, median', ",
          which, which, which);
  fprintf(gp,
          "$points%d with points pt 7 ps 0.35 lc rgb '#e0a080' %s, "
          "$data%d using 1:2:3 with yerrorbars pt 7 ps 0.8 lc rgb '#c8501e' lw 1.5 title "
          "'measured, mean ± sd'\n",
          which, c->data.n_points ? "title 'measured'" : "notitle", which);
}

void cli_compare_plot(const cli_option *option, const comparison *c) {
  cli_plot *picture = cli_plot_open(option, 1200, 520);
  FILE *gp = cli_plot_stream(picture);
  fputs("set multiplot layout 1,2\nset xrange [0:90]\nset xtics 15\n"
        "set xlabel 'impact angle {/Symbol a}_1 / degrees'\n",
        gp);
  for (int which = 0; which < COR_BOTH; which++) {
    bool any = false;
    for (size_t i = 0; i < c->count; i++)
      any = any || (cli_compare_has_data(&c->bins[which][i]) && c->bins[which][i].model.count > 0);
    if (any)
      plot_panel(gp, c, which);
  }
  fputs("unset multiplot\n", gp);
  cli_plot_close(picture);
}
