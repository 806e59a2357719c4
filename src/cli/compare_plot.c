/* The picture of `asperity compare`: both coefficients over the impact angle, the model as a box
 * for each place that was measured, the measurements as points or as means with their standard
 * deviations. Between and beyond measured angles nothing is drawn. Of impacts alone, a box for each
 * place, and the impacts as points. Keys stand above the panels, and axes end behind the last mark.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/compare.h"

#include <math.h>

/* Half the width of a box, in degrees. */
#define HALF_MOST 1.5
#define HALF_LEAST 0.3

/* Marks of single impacts, at most. */
enum { POINTS_MOST = 5000 };

/* The range of a panel: what is measured and the model's band with some room, but no more than
 * CoR_N 0 to 3 and CoR_T -1 to 2; ratios to a vanishing component go far beyond. */
static void print_range(const cli_plot *picture, const comparison *c, int which, double *bottom,
                        double *top) {
  double low = 0, high = 1, least = which ? -1 : 0, most = which ? 2 : 3;
  for (size_t i = 0; i < c->count; i++) {
    const aspi_sample *d = &c->bins[i].data[which], *m = &c->bins[i].model[which];
    double sd = isfinite(d->sd) ? d->sd : 0;
    low = fmin(low, fmin(d->mean - sd, m->low));
    high = fmax(high, fmax(d->mean + sd, m->high));
  }
  for (size_t i = 0; i < c->data.count; i++) {
    low = fmin(low, c->data.rows[i].cor[which]);
    high = fmax(high, c->data.rows[i].cor[which]);
  }
  low = fmax(least, low);
  high = fmin(most, high);
  double room = 0.04 * (high - low), range[2] = {low - room, high + room};
  cli_plot_range(picture, range);
  cli_plot_set_range(picture, range[0], range[1]);
  *bottom = range[0];
  *top = range[1];
}

/* How much of what was measured the axis cuts off, over a panel. */
static void print_outside(FILE *gp, const comparison *c, int which, double bottom, double top) {
  size_t points = 0, outside = 0;
  for (size_t i = 0; i < c->data.count; i++) {
    double y = c->data.rows[i].cor[which];
    points += isfinite(y);
    outside += isfinite(y) && (y < bottom || y > top);
  }
  if (outside > 0)
    fprintf(gp, "set title '{/=9 %zu of %zu %s%s lie outside}'\n", outside, points,
            c->names[1] ? "measured " : "", c->data.means ? "means" : "impacts");
  else
    fputs("unset title\n", gp);
}

/* The angles of a bin's box: those of its impacts, or around its angle and not over a neighbour. */
static void edges_of(const comparison *c, size_t i, double *left, double *right) {
  const compare_bin *b = &c->bins[i];
  double half = HALF_MOST;
  for (size_t k = i ? i - 1 : i; k <= i + 1 && k < c->count; k++) {
    double apart = fabs(c->bins[k].degrees - b->degrees);
    if (apart > 0)
      half = fmin(half, 0.45 * apart);
  }
  half = fmax(half, HALF_LEAST);
  bool wide = b->end - b->first > 1 && !c->data.means && b->to - b->from > 2 * half;
  *left = wide ? b->from : b->degrees - half;
  *right = wide ? b->to : b->degrees + half;
}

static void print_series(FILE *gp, const comparison *c, int which) {
  fprintf(gp, "$model%d << EOD\nNaN NaN NaN NaN NaN NaN NaN\n", which);
  for (size_t i = 0; i < c->count; i++) {
    const compare_bin *b = &c->bins[i];
    const aspi_sample *m = &b->model[which];
    double left, right;
    edges_of(c, i, &left, &right);
    if (cli_compare_is_drawn(c, b, which))
      fprintf(gp, "%g %g %g %g %g %g %g\n", b->degrees, left, right,
              isfinite(m->low) ? m->low : m->mean, isfinite(m->high) ? m->high : m->mean, m->mean,
              m->median);
  }
  fprintf(gp, "EOD\n$points%d << EOD\nNaN NaN\n", which);
  size_t every = c->names[1] ? 1 : 1 + c->data.count / POINTS_MOST;
  for (size_t i = 0; i < c->data.count && !c->data.means; i += every)
    if (isfinite(c->data.rows[i].cor[which]))
      fprintf(gp, "%g %g\n", c->data.rows[i].degrees, c->data.rows[i].cor[which]);
  fprintf(gp, "EOD\n$data%d << EOD\nNaN NaN NaN\n", which);
  for (size_t i = 0; i < c->count; i++) {
    const compare_bin *b = &c->bins[i];
    const aspi_sample *d = &b->data[which];
    if (isfinite(d->mean))
      fprintf(gp, "%g %g %g\n", b->degrees, d->mean, isfinite(d->sd) ? d->sd : 0);
  }
  fputs("EOD\n", gp);
}

static void plot_panel(cli_plot *picture, const comparison *c, int which) {
  FILE *gp = cli_plot_stream(picture);
  const char *of = c->names[1] ? "model" : "impacts";
  print_series(gp, c, which);
  double bottom, top;
  print_range(picture, c, which, &bottom, &top);
  print_outside(gp, c, which, bottom, top);
  fprintf(gp, "set ylabel 'CoR_%c'\nplot ", which ? 'T' : 'N');
  fprintf(gp,
          "$model%d using 1:6:2:3:4:5 with boxxyerror fs solid noborder fc rgb '#c6d9ee' title "
          "'%s, 5 to 95 %%', "
          "$points%d with points pt 7 ps 0.35 lc rgb '#e0a080' %s, ",
          which, of, which,
          c->data.means ? "notitle"
          : c->names[1] ? "title 'measured'"
                        : "notitle");
  fprintf(gp,
          "$model%d using 2:6:($3-$2):(0) with vectors nohead ls 1 lw 2 title '%s, mean', "
          "$model%d using 2:7:($3-$2):(0) with vectors nohead ls 1 lw 1 dt 2 title '%s, median', "
          "$data%d using 1:2:3 with yerrorbars pt 7 ps 0.8 lc rgb '#c8501e' lw 1.5 %s\n",
          which, of, which, of, which, c->names[1] ? "title 'measured, mean ± sd'" : "notitle");
}

static void print_title(cli_plot *picture, const comparison *c) {
  FILE *gp = cli_plot_stream(picture);
  fputs("set multiplot layout 1,2 title '", gp);
  if (cli_plot_title(picture))
    fputs(cli_plot_title(picture), gp);
  else if (c->names[1])
    fprintf(gp, "model: %s        measured: %s", cli_plot_label(picture, c->names[0]).text,
            cli_plot_label(picture, c->names[1]).text);
  else
    fprintf(gp, "%s: %zu impacts, %zu deposits", cli_plot_label(picture, c->names[0]).text,
            c->impacts.count, c->impacts.deposits);
  fputs("'\nset xrange [-2:92]\nset xtics 15\nset xlabel 'impact angle α_1 / degrees'\n"
        "set key outside above center horizontal maxrows 2\n",
        gp);
}

void cli_compare_plot(const cli_option *option, const comparison *c) {
  cli_plot *picture = cli_plot_open(option, 1200, 560);
  FILE *gp = cli_plot_stream(picture);
  print_title(picture, c);
  for (int which = 0; which < COR_BOTH; which++) {
    bool any = false;
    for (size_t i = 0; i < c->count; i++)
      any = any || cli_compare_is_drawn(c, &c->bins[i], which);
    if (any)
      plot_panel(picture, c, which);
  }
  fputs("unset multiplot\n", gp);
  cli_plot_close(picture);
}
