/* The pictures of weibull_fit: figures 6 to 9 of the paper.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/plot.h"
#include "weibull_fit.h"

#include <math.h>

/* Figure 7: k and lambda over tau, a color a wall, and the polynomials. */
static void plot_curves(cli_plot *plot, const angle_fit *fits, size_t n, const cli_list *sigmas,
                        const double *k, const double *lambda) {
  for (int q = 0; q < 2; q++) {
    const double *c = q ? lambda : k;
    cli_plot_panel(plot, "α_1 / σ", q ? "λ / σ" : "k");
    cli_plot_axis(plot, 'x', 0, 10);
    for (size_t s = 0; s < sigmas->count; s++) {
      cli_plot_series(plot, CLI_MARKS, "%zu", s % 6 + 1);
      for (size_t i = s * n / sigmas->count; i < (s + 1) * n / sigmas->count; i++)
        if (fits[i].alpha1 <= 10 * fits[i].sigma)
          cli_plot_row(plot, fits[i].alpha1 / fits[i].sigma, q ? fits[i].lambda : fits[i].k);
      cli_plot_end(plot, "σ = %g°", sigmas->values[s]);
    }
    cli_plot_series(plot, CLI_LINE, "reference");
    for (int i = 0; i <= 100; i++) {
      double x = FIT_TAU_END * i / 100;
      cli_plot_row(plot, x, c[0] + x * (c[1] + x * (c[2] + x * (c[3] + x * c[4]))));
    }
    cli_plot_end(plot, "polynomial");
    cli_plot_series(plot, CLI_LINE, "reference dt 2");
    cli_plot_row(plot, FIT_TAU_END, q ? 3.5955 : 3.602);
    cli_plot_row(plot, 10, q ? 3.5955 : 3.602);
    cli_plot_end(plot, "constant");
  }
}

/* Figure 8: divergences over the impact angle, for the first wall. */
static void plot_divergences(cli_plot *plot, const angle_fit *fits, size_t n) {
  double noise = sqrt(FIT_BINS / 2.) / fits[0].n; /* less than that the samples cannot tell */
  cli_plot_panel(plot, "impact angle α_1 / degrees", "D_{KL} of the baseline against the density");
  cli_plot_log(plot, "y");
  cli_plot_axis(plot, 'y', noise / 2, 10);
  for (int m = 0; m < asp_spread_count(); m++) {
    const asp_spread_model *model = asp_spread_at(m);
    if (!cli_fit_judges(model))
      continue;
    cli_plot_series(plot, CLI_LINE, "model_%s", model->name);
    for (size_t i = 0; i < n; i++)
      cli_plot_row(plot, cli_degrees(fits[i].alpha1),
                   fmax(cli_fit_divergence(&fits[i], model), noise));
    cli_plot_end(plot, "%s", model->name);
  }
}

/* One panel: the baseline as bars, densities as lines; a mark where a specular rebound slides. */
static void plot_panel(cli_plot *plot, const angle_fit *f, const char *const *names, int count) {
  aspi_view view = cli_fit_view(f);
  double degree = ASP_PI / 180, step = f->sigma * FIT_REACH / FIT_BINS,
         sigma = cli_degrees(f->sigma), mark = -cli_degrees(f->alpha1) / 2;
  cli_plot_panel(plot, "tilt Δα / degrees", "density / (1/degree)");
  cli_plot_caption(plot, "α_1 = %g°, σ = %g°", cli_degrees(f->alpha1), sigma);
  cli_plot_axis(plot, 'x', -3.5 * sigma, 4 * sigma);
  cli_plot_axis(plot, 'y', 0, NAN);
  if (mark > -3.5 * sigma)
    fprintf(cli_plot_stream(plot),
            "set arrow 1 from %g, graph 0 to %g, graph 1 nohead lc '#999999' dt 3\n"
            "set label 1 '-α_1/2' at %g, graph 0.96 right offset -0.3,0 tc rgb '#666666'\n",
            mark, mark, mark);
  cli_plot_series(plot, CLI_BARS, "model_rejection");
  for (int i = 0; i < FIT_BINS; i += 5) {
    double sum = 0;
    for (int j = 0; j < 5; j++)
      sum += f->count[i + j];
    cli_plot_row(plot, cli_degrees(-f->alpha1 / 2 + (i + 2.5) * step),
                 sum / f->n / (5 * step) * degree);
  }
  cli_plot_end(plot, "baseline");
  for (int m = 0; m < count; m++) {
    const asp_spread_model *model = asp_spread_find(names[m], NULL);
    cli_plot_series(plot, CLI_LINE, "model_%s", names[m]);
    for (int i = -350; i <= 400; i++)
      cli_plot_row(plot, cli_degrees(f->sigma * i / 100),
                   model->density(&view, f->sigma * i / 100) * degree);
    cli_plot_end(plot, "%s", names[m]);
  }
}

void cli_fit_plot(const cli_call *call, const angle_fit *fits, size_t n, const cli_list *sigmas,
                  const double *k, const double *lambda) {
  static const char *const choice[] = {"effective", "truncated", "weibull"};
  unsigned long figure = cli_whole(cli_get(call, "figure"), 6, 9);
  size_t first = n / sigmas->count, panels = first < 3 ? 1 : 3;
  cli_plot *plot;
  if (figure == 7) {
    plot = cli_plot_open(call, 1200, 480, "1,2", "Weibull fits to the baseline");
    plot_curves(plot, fits, n, sigmas, k, lambda);
  } else if (figure == 8) {
    plot = cli_plot_open(call, 800, 480, "1,1", "Models against the baseline, σ = %g°",
                         cli_degrees(fits[0].sigma));
    plot_divergences(plot, fits, first);
  } else {
    plot = cli_plot_open(call, 1200, 480, panels < 3 ? "1,1" : "1,3",
                         "Densities against the baseline");
    for (size_t i = 0; i < panels; i++)
      plot_panel(plot, &fits[i * (first - 1) / 2], choice, figure == 6 ? 1 : 3);
  }
  cli_plot_close(plot);
}
