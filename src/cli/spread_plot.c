/* The picture of `asperity spread`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
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

static void print_density(FILE *gp, const asp_spread_model *model, const aspi_view *view,
                          double from, double to) {
  fprintf(gp, "$density << EOD\n%g 0\n", from);
  for (double angle = from; angle <= to; angle += 0.1)
    fprintf(gp, "%g %g\n", angle, model->density(view, cli_radians(angle)) * ASP_PI / 180);
  fputs("EOD\n", gp);
}

/* A histogram of the samples, one bar a degree from where the law begins, and the density over it.
 */
void cli_spread_plot(const cli_option *option, const asp_spread_model *model, bool shaped,
                     const asp_surface *surface, const aspi_view *view, const double *sample,
                     size_t n) {
  double share[BARS] = {0}, least = 90, most = -90,
         from = beginning(model, shaped, view, sample, n);
  for (size_t i = 0; i < n; i++) {
    int bar = (int)fmax(0, floor(sample[i] - from));
    share[bar < BARS ? bar : BARS - 1] += 1 / (double)n;
    least = fmin(least, sample[i]);
    most = fmax(most, sample[i]);
  }
  char wall[160] = "";
  if (surface)
    snprintf(wall, sizeof wall, "; R_q %.3g µm, λ_c %.3g µm, d_p %.3g µm",
             asp_surface_r_q(surface) * 1e6, asp_surface_lambda_c(surface) * 1e6, view->d_p * 1e6);
  cli_plot *picture = cli_plot_open(option, 800, 500);
  FILE *gp = cli_plot_stream(picture);
  if (cli_plot_title(picture))
    fprintf(gp, "set title '%s'\n", cli_plot_title(picture));
  else
    fprintf(gp, "set title '%s: α_1 = %g°, σ = %.3g°%s'\n",
            cli_plot_label(picture, model->name).text, cli_degrees(view->alpha1),
            cli_degrees(view->sigma), wall);
  cli_plot_set_range(picture, 0, NAN);
  fprintf(gp,
          "set xlabel 'tilt Δα / degrees'\n"
          "set ylabel 'density / (1/degree)'\n"
          "set style fill solid 0.35 noborder\nset boxwidth 1\n"
          "set xrange [%g:%g]\n$bars << EOD\n",
          fmax(from, least - 3) - 2, most + 2);
  for (int i = 0; i < BARS; i++)
    if (share[i] > 0)
      fprintf(gp, "%g %g\n", from + i + 0.5, share[i]);
  fputs("EOD\n", gp);
  if (shaped)
    print_density(gp, model, view, from, most);
  fprintf(gp, "plot $bars with boxes lc rgb '#0072b2' title '%zu samples'", n);
  if (shaped)
    fputs(", $density with lines ls 2 dt 1 title 'density'", gp);
  fputc('\n', gp);
  cli_plot_close(picture);
}
