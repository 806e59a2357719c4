/* The picture of `asperity spread`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/plot.h"
#include "cli/spread.h"

#include <math.h>

enum { BARS = 181 };

/* A histogram of the samples, one bar a degree from the least one, and the density over it. */
void cli_spread_plot(const cli_option *option, const asp_spread_model *model, bool shaped,
                     const asp_wall *wall, bool sized, const aspi_view *view, const double *sample,
                     size_t n) {
  double share[BARS] = {0}, from = 90, most = -90;
  for (size_t i = 0; i < n; i++)
    from = fmin(from, sample[i]);
  for (size_t i = 0; i < n; i++) {
    int bar = (int)fmax(0, floor(sample[i] - from));
    share[bar < BARS ? bar : BARS - 1] += 1 / (double)n;
    most = fmax(most, sample[i]);
  }
  char size[1700] = "";
  if (sized)
    snprintf(size, sizeof size, "; %s, d_p = %.3g µm", cli_plot_wall(wall).text, view->d_p * 1e6);
  cli_plot *picture = cli_plot_open(option, 800, 500, "1,1", "%s: α_1 = %g°, σ = %.3g°%s",
                                    cli_plot_label(model->name).text, cli_degrees(view->alpha1),
                                    cli_degrees(view->sigma), size);
  cli_plot_panel(picture, "tilt Δα / degrees", "density / (1/degree)");
  cli_plot_axis(picture, 'y', 0, NAN);
  fputs("set boxwidth 1\n", cli_plot_stream(picture));
  cli_plot_series(picture, CLI_BARS, "model_%s", model->name);
  for (int i = 0; i < BARS; i++)
    if (share[i] > 0)
      cli_plot_row(picture, from + i + 0.5, share[i]);
  cli_plot_end(picture, "%zu samples", n);
  cli_plot_series(picture, CLI_LINE, "model_%s", model->name);
  for (double angle = from; shaped && angle <= most; angle += 0.1)
    cli_plot_row(picture, angle, model->density(view, cli_radians(angle)) * ASP_PI / 180);
  cli_plot_end(picture, "%s", shaped ? "density" : "");
  cli_plot_close(picture);
}
