/* The picture of `asperity compare`: both coefficients over the impact angle, the model as a box
 * (mean ± sd) and a line at each place that was measured, the measurements as marks. Between and
 * beyond measured angles nothing is drawn. Of impacts alone, a box for each place, and the impacts.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/compare.h"
#include "cli/plot.h"

#include <math.h>

/* Half the width of a box, in degrees. */
#define HALF_MOST 1.5
#define HALF_LEAST 0.3

/* Marks of single impacts, at most. */
enum { POINTS_MOST = 5000 };

/* True if a bin is drawn: if it has both, or, of impacts alone, some. */
static bool is_drawn(const aspi_comparison *c, const aspi_compare_bin *b, int which) {
  return c->names[1] ? aspi_compare_has_both(b, which) : b->model.of[which].count > 0;
}

/* The angles of a bin's box: those of its impacts, or around its angle and not over a neighbor. */
static void edges_of(const aspi_comparison *c, size_t i, double *left, double *right) {
  const aspi_compare_bin *b = &c->bins[i];
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

static void plot_model(cli_plot *picture, const aspi_comparison *c, int which) {
  cli_plot_series(picture, CLI_BOX, "simulated");
  for (size_t i = 0; i < c->count; i++) {
    const aspi_sample *m = &c->bins[i].model.of[which];
    double left, right;
    edges_of(c, i, &left, &right);
    if (is_drawn(c, &c->bins[i], which))
      cli_plot_row(picture, left, right, m->mean, m->sd);
  }
  cli_plot_end(picture, "%s, mean ± sd", c->names[1] ? "model" : "impacts");
}

static void plot_data(cli_plot *picture, const aspi_comparison *c, int which) {
  size_t every = c->names[1] ? 1 : 1 + c->data.count / POINTS_MOST;
  cli_plot_series(picture, CLI_MARKS, c->names[1] ? "data_each" : "impacts");
  for (size_t i = 0; i < c->data.count && !c->data.means; i += every)
    cli_plot_row(picture, c->data.rows[i].degrees, c->data.rows[i].cor[which]);
  cli_plot_end(picture, c->data.means ? "" : c->names[1] ? "measured impacts" : "impacts");
  if (!c->names[1])
    return;
  cli_plot_series(picture, CLI_ERRORS, "data");
  for (size_t i = 0; i < c->count; i++)
    cli_plot_row(picture, c->bins[i].degrees, c->bins[i].data.of[which].mean,
                 c->bins[i].data.of[which].sd);
  cli_plot_end(picture, "measured, mean ± sd");
}

static cli_plot *open_picture(const cli_option *option, const aspi_comparison *c) {
  if (c->names[1])
    return cli_plot_open(option, 1200, 520, "1,2", "Model: %s; measured: %s",
                         cli_plot_file(c->names[0]).text, cli_plot_file(c->names[1]).text);
  return cli_plot_open(option, 1200, 520, "1,2", "%s: %zu impacts, %zu deposits",
                       cli_plot_file(c->names[0]).text, c->impacts.count, c->impacts.deposits);
}

void cli_compare_plot(const cli_option *option, const aspi_comparison *c) {
  cli_plot *picture = open_picture(option, c);
  for (int which = 0; which < COR_BOTH; which++) {
    bool any = false;
    for (size_t i = 0; i < c->count; i++)
      any = any || is_drawn(c, &c->bins[i], which);
    if (!any)
      continue;
    cli_plot_coefficient(picture, which);
    if (!c->names[1])
      plot_data(picture, c, which);
    plot_model(picture, c, which);
    if (c->names[1])
      plot_data(picture, c, which);
  }
  cli_plot_close(picture);
}
