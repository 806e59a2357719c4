/* The picture of `asperity spread`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/spread.h"

#include <math.h>

/* A histogram of the samples, one bar a degree, and the density over it. */
void cli_spread_plot(const cli_option *option, const asp_spread_model *model, const aspi_view *view,
                     const double *sample, size_t n) {
  double share[181] = {0}, most = -90;
  for (size_t i = 0; i < n; i++) {
    share[(int)lround(sample[i]) + 90] += 1 / (double)n;
    most = fmax(most, sample[i]);
  }
  cli_plot *picture = cli_plot_open(option, 800, 500);
  FILE *gp = cli_plot_stream(picture);
  fprintf(gp,
          "set xlabel 'tilt {/Symbol Da} / degrees'\n"
          "set ylabel 'density / (1/degree)'\n"
          "set title '%s: {/Symbol a}_1 = %g°, {/Symbol s} = %.3g°'\n"
          "set style fill solid 0.35 noborder\nset boxwidth 1\nset yrange [0:*]\n$bars << EOD\n",
          cli_plot_label(picture, model->name).text, cli_degrees(view->alpha1),
          cli_degrees(view->sigma));
  for (int i = 0; i <= 180; i++)
    if (share[i] > 0)
      fprintf(gp, "%d %g\n", i - 90, share[i]);
  fputs("EOD\n", gp);
  if (model->density) {
    fputs("$density << EOD\n", gp);
    for (int i = -900; 0.1 * i <= most; i++) {
      double density = model->density(view, cli_radians(0.1 * i)) * ASP_PI / 180;
      if (density > 0)
        fprintf(gp, "%g %g\n", 0.1 * i, density);
    }
    fputs("EOD\n", gp);
  }
  fprintf(gp, "plot $bars with boxes lc rgb '#1f5fa8' title '%zu samples'", n);
  if (model->density)
    fputs(", $density with lines ls 2 title 'density'", gp);
  fputc('\n', gp);
  cli_plot_close(picture);
}
