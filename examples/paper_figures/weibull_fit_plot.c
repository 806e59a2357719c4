/* The pictures of weibull_fit: figures 6 to 9 of the paper.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "weibull_fit.h"

#include <math.h>

/* Figure 7: k and lambda over tau, a colour a wall, and the polynomials. */
static void plot_curves(FILE *gp, const angle_fit *fits, size_t n, const cli_list *sigmas,
                        const double *k, const double *lambda) {
  fputs("set multiplot layout 1,2 title 'Weibull fits to the baseline (figure 7 of the paper)'\n"
        "set xlabel 'α_1 / σ'\nset xrange [0:10]\n"
        "set key bottom right\n",
        gp);
  for (size_t s = 0; s < sigmas->count; s++) {
    fprintf(gp, "$wall%zu << EOD\n", s);
    for (size_t i = s * n / sigmas->count; i < (s + 1) * n / sigmas->count; i++)
      fprintf(gp, "%g %g %g\n", fits[i].alpha1 / fits[i].sigma, fits[i].k, fits[i].lambda);
    fputs("EOD\n", gp);
  }
  for (int q = 0; q < 2; q++) {
    const double *c = q ? lambda : k;
    fprintf(gp, "set ylabel '%s'\nplot ", q ? "λ / σ" : "k");
    for (size_t s = 0; s < sigmas->count; s++)
      fprintf(gp, "$wall%zu using 1:%d with points ls %zu pt %zu ps 0.8 title 'σ = %g°', ", s,
              q + 2, s % 6 + 1, 4 + 2 * (s % 5), sigmas->values[s]);
    fprintf(gp, "[0:%g] %.8g+x*(%.8g+x*(%.8g+x*(%.8g+x*%.8g))) lc 'black' lw 1.5 ", FIT_TAU_END,
            c[0], c[1], c[2], c[3], c[4]);
    fprintf(gp, "title 'polynomial', [%g:10] %g lc 'black' dt 2 lw 1.5 title 'constant'\n",
            FIT_TAU_END, q ? 3.5955 : 3.602);
  }
}

/* Figure 8: divergences over the impact angle, for the first wall. */
static void plot_divergences(FILE *gp, const angle_fit *fits, size_t n) {
  double noise = sqrt(FIT_BINS / 2.) / fits[0].n; /* less than that the samples cannot tell */
  fputs("$kl << EOD\n", gp);
  for (size_t i = 0; i < n; i++) {
    fprintf(gp, "%g", cli_degrees(fits[i].alpha1));
    for (int m = 0; m < asp_spread_count(); m++)
      if (cli_fit_judges(asp_spread_at(m)))
        fprintf(gp, " %g", fmax(cli_fit_divergence(&fits[i], asp_spread_at(m)), noise));
    fputc('\n', gp);
  }
  fprintf(gp,
          "EOD\nset xlabel 'impact angle α_1 / degrees'\nset logscale y\n"
          "set ylabel 'D_{KL} of the baseline against the density'\nset format y '10^{%%T}'\n"
          "set yrange [%g:10]\nset key top right\nset title 'σ = %g°'\nplot ",
          noise / 2, cli_degrees(fits[0].sigma));
  for (int m = 0, column = 2; m < asp_spread_count(); m++)
    if (cli_fit_judges(asp_spread_at(m))) {
      fprintf(gp, "$kl using 1:%d with lines ls %d title '%s', ", column, (column - 2) % 6 + 1,
              asp_spread_at(m)->name);
      column++;
    }
  fputc('\n', gp);
}

/* One panel: the baseline as bars, densities as lines; a mark where a specular rebound slides. */
static void plot_panel(FILE *gp, const angle_fit *f, const char *const *names, int count) {
  aspi_view view = cli_fit_view(f);
  double degree = ASP_PI / 180, step = f->sigma * FIT_REACH / FIT_BINS;
  fputs("$bars << EOD\n", gp);
  for (int i = 0; i < FIT_BINS; i += 5) {
    double sum = 0;
    for (int j = 0; j < 5; j++)
      sum += f->count[i + j];
    fprintf(gp, "%g %g\n", cli_degrees(-f->alpha1 / 2 + (i + 2.5) * step),
            sum / f->n / (5 * step) * degree);
  }
  fputs("EOD\n", gp);
  for (int m = 0; m < count; m++) {
    const asp_spread_model *model = asp_spread_find(names[m], NULL);
    fprintf(gp, "$line%d << EOD\n", m);
    for (int i = -400; i <= 400; i++)
      fprintf(gp, "%g %g\n", cli_degrees(f->sigma * i / 100),
              model->density(&view, f->sigma * i / 100) * degree);
    fputs("EOD\n", gp);
  }
  double sigma = cli_degrees(f->sigma), mark = -cli_degrees(f->alpha1) / 2;
  fprintf(gp,
          "set title 'α_1 = %g°, σ = %g°'\nset xrange [%g:%g]\n"
          "unset arrow 1\nunset label 1\n",
          cli_degrees(f->alpha1), sigma, -3.5 * sigma, 4 * sigma);
  if (mark > -3.5 * sigma)
    fprintf(gp,
            "set arrow 1 from %g, graph 0 to %g, graph 1 nohead lc '#999999' dt 3\n"
            "set label 1 '-α_1/2' at %g, graph 0.96 right offset -0.3,0 tc '#666666'\n",
            mark, mark, mark);
  fputs("plot $bars with boxes lc rgb '#cccccc' title 'baseline'", gp);
  for (int m = 0; m < count; m++)
    fprintf(gp, ", $line%d with lines ls %d title '%s'", m, m + 1, names[m]);
  fputc('\n', gp);
}

static void plot_densities(FILE *gp, const angle_fit *fits, size_t n, const char *const *names,
                           int count) {
  fputs("set xlabel 'tilt Δα / degrees'\nset ylabel 'density / (1/degree)'\n"
        "set style fill solid 1 noborder\nset yrange [0:*]\n"
        "set key left center Left reverse samplen 1.5\n", /* the first panel has room there */
        gp);
  fprintf(gp, "set multiplot layout 1,%d\n", n < 3 ? 1 : 3);
  for (size_t i = 0; i < (n < 3 ? 1 : 3); i++) {
    plot_panel(gp, &fits[n < 3 ? 0 : i * (n - 1) / 2], names, count);
    fputs("unset key\n", gp);
  }
}

void cli_fit_plot(const cli_option *options, const angle_fit *fits, size_t n,
                  const cli_list *sigmas, const double *k, const double *lambda) {
  static const char *const shadow[] = {"effective"};
  static const char *const choice[] = {"effective", "truncated", "weibull"};
  unsigned long figure = cli_whole(&options[FIGURE], 6, 9);
  cli_plot *picture = cli_plot_open(&options[PLOT], figure == 8 ? 800 : 1200, 480);
  FILE *gp = cli_plot_stream(picture);
  size_t first = n / sigmas->count;
  if (figure == 7)
    plot_curves(gp, fits, n, sigmas, k, lambda);
  else if (figure == 8)
    plot_divergences(gp, fits, first);
  else if (figure == 6)
    plot_densities(gp, fits, first, shadow, 1);
  else
    plot_densities(gp, fits, first, choice, 3);
  cli_plot_close(picture);
}
