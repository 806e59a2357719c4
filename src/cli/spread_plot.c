/* The picture of `asperity spread`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/plot.h"
#include "cli/spread.h"

#include <math.h>

enum { BARS = 181 };

/* Where the law begins, in degrees: the least angle with a density, to 1e-6; of a law without one
 * the least sample. */
static double beginning(const asp_spread_model *model, bool shaped, const aspi_view *view,
                        const double *sample, size_t n) {
  if (!shaped) {
    double least = sample[0];
    for (size_t i = 1; i < n; i++)
      least = fmin(least, sample[i]);
    return least;
  }
  double above = -90;
  while (above < 90 && !(model->density(view, cli_radians(above)) > 0))
    above += 0.1;
  double below = fmax(-90, above - 0.1);
  while (above - below > 1e-6) {
    double middle = 0.5 * (above + below);
    if (model->density(view, cli_radians(middle)) > 0)
      above = middle;
    else
      below = middle;
  }
  return above;
}

/* A histogram of the samples, one bar a degree from where the law begins, and the density over it.
 */
void cli_spread_plot(const cli_option *option, const asp_spread_model *model, bool shaped,
                     const asp_surface *surface, const aspi_view *view, const double *sample,
                     size_t n) {
  double share[BARS] = {0}, most = -90, from = beginning(model, shaped, view, sample, n);
  for (size_t i = 0; i < n; i++) {
    int bar = (int)fmax(0, floor(sample[i] - from));
    share[bar < BARS ? bar : BARS - 1] += 1 / (double)n;
    most = fmax(most, sample[i]);
  }
  char wall[160] = "";
  if (surface)
    snprintf(wall, sizeof wall, "; R_q %.3g µm, λ_c %.3g µm, d_p %.3g µm",
             asp_surface_r_q(surface) * 1e6, asp_surface_lambda_c(surface) * 1e6, view->d_p * 1e6);
  cli_plot *picture = cli_plot_open(option, 800, 500, "1,1", "%s: α_1 = %g°, σ = %.3g°%s",
                                    cli_plot_label(model->name).text, cli_degrees(view->alpha1),
                                    cli_degrees(view->sigma), wall);
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
