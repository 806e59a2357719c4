/* The picture of `asperity calibrate`: means and standard deviations of both coefficients over the
 * impact angle. Marks are measured; the line in a band is the fitted model.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/calibrate.h"
#include "cli/plot.h"

#include <math.h>

/* One coefficient of one bin; the mean is NAN if there is none. */
typedef struct point {
  double degrees, mean, sd;
} point;

static point measured_in(const aspi_calibration *c, size_t b, int k) {
  double alpha = cli_radians(c->bins[b].degrees), by = k == COR_N ? sin(alpha) : cos(alpha);
  const aspi_group *g = &c->groups[b];
  bool used = g->used[MOMENT_X + k];
  return (point){c->bins[b].degrees, used ? g->mean[k] / by : NAN, used ? g->sd[k] / by : NAN};
}

static point fitted_in(const aspi_calibration *c, size_t b, int k) {
  double mean[COR_BOTH], sd[COR_BOTH];
  aspi_calibration_coefficients(c, b, mean, sd);
  return (point){c->bins[b].degrees, mean[k], sd[k]};
}

static void plot_panel(cli_plot *picture, const aspi_calibration *c, int k) {
  const char *law = asp_rebound_name(asp_wall_rebound(c->wall));
  cli_plot_coefficient(picture, k);
  cli_plot_series(picture, CLI_BAND, "law_%s", law);
  for (size_t b = 0; b < c->n_bins; b++) {
    point p = fitted_in(c, b, k);
    if (isfinite(measured_in(c, b, k).mean))
      cli_plot_row(picture, p.degrees, p.mean, p.sd);
  }
  cli_plot_end(picture, "fitted model, mean ± sd");
  cli_plot_series(picture, CLI_ERRORS, "data");
  for (size_t b = 0; b < c->n_bins; b++) {
    point p = measured_in(c, b, k);
    cli_plot_row(picture, p.degrees, p.mean, p.sd);
  }
  cli_plot_end(picture, "measured, mean ± sd");
}

void cli_calibrate_plot(const cli_option *option, const aspi_calibration *c, const char *data,
                        const char *title) {
  cli_plot *picture = cli_plot_open(option, 1200, 520, "1,2", "%s and the fitted model: %s",
                                    cli_plot_file(data).text, cli_plot_label(title).text);
  for (int k = 0; k < COR_BOTH; k++) {
    bool any = false;
    for (size_t b = 0; b < c->n_bins; b++)
      any = any || isfinite(measured_in(c, b, k).mean);
    if (any)
      plot_panel(picture, c, k);
  }
  cli_plot_close(picture);
}
