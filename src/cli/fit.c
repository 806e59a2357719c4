/* asperity fit: the paper's own route to its Weibull law. Sample the baseline (routines 1 to 3, the
 * model `rejection`) many times per impact angle, fit k and lambda to each sample, take means, and
 * lay polynomials of fourth degree through them up to the boundary angle e = 6.48 sigma. Over
 * alpha1/sigma all walls fall on one curve (fig. 7), which the code keeps as ten numbers. The
 * samples also judge every density (fig. 6, 8, 9). */
#include "cli/cli.h"
#include "spread/models.h"

#include <gsl/gsl_multifit.h>
#include <gsl/gsl_vector.h>
#include <math.h>
#include <stdlib.h>

enum { SIGMA, ANGLES, RUNS, SAMPLES, SEED, FIGURE, OUTPUT, PLOT, N };

enum { BINS = 600, DEGREE = 4 };

/* Bins reach from -alpha1/2 up over this many sigma. */
#define REACH 12.0

/* tau of the paper's boundary angle e. */
#define TAU_END 6.48

/* One wall at one angle. */
typedef struct angle_fit {
  double sigma, alpha1; /* rad */
  double count[BINS];   /* of all runs, by (delta + alpha1/2)/sigma */
  double n;
  double k, k_sd, lambda, lambda_sd; /* mean and sd over the runs; lambda over sigma */
} angle_fit;

static aspi_view view_of(const angle_fit *f) {
  return aspi_view_of(f->sigma, f->alpha1);
}

static double place_of(int bin) {
  return (bin + 0.5) * REACH / BINS;
}

/* The derivative of the likelihood in k, its root the fit: sum y^k ln y / sum y^k - 1/k - mean ln y
 * (and lambda^k = mean y^k). Also its own derivative. */
static double score(const double *count, double n, double mean_log, double k, double *slope,
                    double *power) {
  double s0 = 0, s1 = 0, s2 = 0;
  for (int i = 0; i < BINS; i++) {
    if (!(count[i] > 0))
      continue;
    double l = log(place_of(i)), p = count[i] * exp(k * l);
    s0 += p;
    s1 += p * l;
    s2 += p * l * l;
  }
  *power = s0 / n;
  *slope = s2 / s0 - s1 / s0 * (s1 / s0) + 1 / (k * k);
  return s1 / s0 - 1 / k - mean_log;
}

/* Maximum likelihood, which is least D_KL from the sample; Newton's method, which converges from
 * any k here because the score rises everywhere. */
static void fit_weibull(const double *count, double n, double *k, double *lambda) {
  double mean_log = 0, slope, power = 1;
  for (int i = 0; i < BINS; i++)
    mean_log += count[i] * log(place_of(i)) / n;
  *k = 1.5;
  for (int i = 0; i < 40; i++) {
    double step = score(count, n, mean_log, *k, &slope, &power) / slope;
    *k = fmax(*k - step, *k / 2);
    if (fabs(step) < 1e-10)
      break;
  }
  score(count, n, mean_log, *k, &slope, &power);
  *lambda = pow(power, 1 / *k);
}

static void sample(const angle_fit *f, size_t samples, asp_key key, double *count) {
  const asp_spread_model *baseline = asp_spread_find("rejection", NULL);
  aspi_view view = view_of(f);
  aspi_stream stream = aspi_stream_begin(&key);
  for (int i = 0; i < BINS; i++)
    count[i] = 0;
  for (size_t i = 0; i < samples; i++) {
    double delta;
    aspi_spread_draw(baseline, &view, &stream, &delta);
    int bin = (int)((delta + f->alpha1 / 2) / f->sigma * (BINS / REACH));
    count[bin < BINS ? bin : BINS - 1]++;
  }
}

static void add(double x, int run, double *mean, double *square) {
  double step = x - *mean;
  *mean += step / (run + 1);
  *square += step * (x - *mean);
}

static void fit_angle(angle_fit *f, int runs, size_t samples, uint32_t seed, uint64_t tag) {
  for (int run = 0; run < runs; run++) {
    double count[BINS], k, lambda;
    asp_key key = {seed, asp_key_wall("fit"), tag, (uint32_t)run + 1};
    sample(f, samples, key, count);
    fit_weibull(count, (double)samples, &k, &lambda);
    add(k, run, &f->k, &f->k_sd);
    add(lambda, run, &f->lambda, &f->lambda_sd);
    for (int i = 0; i < BINS; i++)
      f->count[i] += count[i];
  }
  f->n = (double)samples * runs;
  f->k_sd = runs > 1 ? sqrt(f->k_sd / (runs - 1)) : 0;
  f->lambda_sd = runs > 1 ? sqrt(f->lambda_sd / (runs - 1)) : 0;
}

/* Whether a model is a density over delta of its own, one that the baseline's samples can judge. */
static bool judged(const asp_spread_model *model) {
  return model->density && model->quantile && !model->prepare && !model->escape;
}

/* D_KL of the samples against a model's law, less the samples' bias. A bin that the model does not
 * reach counts as 1e-9. */
static double divergence(const angle_fit *f, const asp_spread_model *model) {
  aspi_view view = view_of(f);
  double sum = 0, bins = 0, step = f->sigma * REACH / BINS, low = 0;
  for (int i = 0; i < BINS; i++) {
    double high = model->distribution(&view, -f->alpha1 / 2 + (i + 1) * step);
    if (i == 0)
      low = model->distribution(&view, -f->alpha1 / 2);
    if (f->count[i] > 0) {
      double p = f->count[i] / f->n;
      sum += p * log(p / fmax(high - low, 1e-9));
      bins++;
    }
    low = high;
  }
  return sum - (bins - 1) / (2 * f->n);
}

/* Coefficients of a polynomial through k or lambda over tau, by least squares. */
static void fit_polynomial(const angle_fit *fits, size_t n, bool lambda, double *c) {
  size_t used = 0;
  for (size_t i = 0; i < n; i++)
    used += fits[i].alpha1 <= TAU_END * fits[i].sigma;
  if (used <= DEGREE)
    cli_bad_usage("--angles: %zu of them are below e = 6.48 sigma; a fit needs more than %d", used,
                  (int)DEGREE);
  gsl_matrix *x = gsl_matrix_alloc(used, DEGREE + 1),
             *cov = gsl_matrix_alloc(DEGREE + 1, DEGREE + 1);
  gsl_vector *y = gsl_vector_alloc(used);
  gsl_vector_view out = gsl_vector_view_array(c, DEGREE + 1);
  gsl_multifit_linear_workspace *room = gsl_multifit_linear_alloc(used, DEGREE + 1);
  if (!x || !cov || !y || !room)
    cli_fail("out of memory");
  for (size_t i = 0, row = 0; i < n; i++) {
    double tau = fits[i].alpha1 / fits[i].sigma;
    if (fits[i].alpha1 > TAU_END * fits[i].sigma)
      continue;
    for (size_t j = 0; j <= DEGREE; j++)
      gsl_matrix_set(x, row, j, pow(tau, (double)j));
    gsl_vector_set(y, row++, lambda ? fits[i].lambda : fits[i].k);
  }
  double chi2;
  gsl_multifit_linear(x, y, &out.vector, cov, &chi2, room);
  gsl_multifit_linear_free(room);
  gsl_matrix_free(x);
  gsl_matrix_free(cov);
  gsl_vector_free(y);
}

static double polynomial(const double *c, double tau) {
  double sum = 0;
  for (int j = DEGREE; j >= 0; j--)
    sum = sum * tau + c[j];
  return sum;
}

static void print(FILE *out, const angle_fit *fits, size_t n, const double *k,
                  const double *lambda) {
  for (int q = 0; q < 2; q++) {
    fprintf(out, "# %s =", q ? "lambda/sigma" : "k");
    for (int j = 0; j <= DEGREE; j++)
      fprintf(out, " %+.6f tau^%d", q ? lambda[j] : k[j], j);
    fputc('\n', out);
  }
  fputs("sigma_deg,alpha1_deg,tau,k,k_sd,lambda_over_sigma,lambda_over_sigma_sd,k_polynomial,"
        "lambda_polynomial",
        out);
  for (int m = 0; m < asp_spread_count(); m++)
    if (judged(asp_spread_at(m)))
      fprintf(out, ",kl_%s", asp_spread_at(m)->name);
  fputc('\n', out);
  for (size_t i = 0; i < n; i++) {
    const angle_fit *f = &fits[i];
    double tau = f->alpha1 / f->sigma;
    fprintf(out, "%g,%g,%.6g,%.6f,%.6f,%.6f,%.6f,", cli_degrees(f->sigma), cli_degrees(f->alpha1),
            tau, f->k, f->k_sd, f->lambda, f->lambda_sd);
    if (tau <= TAU_END)
      fprintf(out, "%.6f,%.6f", polynomial(k, tau), polynomial(lambda, tau));
    else
      fputc(',', out);
    for (int m = 0; m < asp_spread_count(); m++)
      if (judged(asp_spread_at(m)))
        fprintf(out, ",%.6f", divergence(f, asp_spread_at(m)));
    fputc('\n', out);
  }
}

/* Figure 7: k and lambda over tau, a colour a wall, and the polynomials. */
static void plot_curves(FILE *gp, const angle_fit *fits, size_t n, const cli_list *sigmas,
                        const double *k, const double *lambda) {
  fputs("set multiplot layout 1,2\nset xlabel '{/Symbol a}_1 / {/Symbol s}'\nset xrange [0:10]\n"
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
    fprintf(gp, "set ylabel '%s'\nplot ", q ? "{/Symbol l} / {/Symbol s}" : "k");
    for (size_t s = 0; s < sigmas->count; s++)
      fprintf(gp,
              "$wall%zu using 1:%d with points ls %zu pt %zu ps 0.8 title '{/Symbol s} = %g°', ", s,
              q + 2, s % 6 + 1, 4 + 2 * (s % 5), sigmas->values[s]);
    fprintf(gp, "[0:%g] %.8g+x*(%.8g+x*(%.8g+x*(%.8g+x*%.8g))) lc 'black' lw 1.5 ", TAU_END, c[0],
            c[1], c[2], c[3], c[4]);
    fprintf(gp, "title 'polynomial', [%g:10] %g lc 'black' dt 2 lw 1.5 title 'constant'\n", TAU_END,
            q ? 3.5955 : 3.602);
  }
}

/* Figure 8: divergences over the impact angle, for the first wall. */
static void plot_divergences(FILE *gp, const angle_fit *fits, size_t n) {
  double noise = sqrt(BINS / 2.) / fits[0].n; /* less than that the samples cannot tell */
  fputs("$kl << EOD\n", gp);
  for (size_t i = 0; i < n; i++) {
    fprintf(gp, "%g", cli_degrees(fits[i].alpha1));
    for (int m = 0; m < asp_spread_count(); m++)
      if (judged(asp_spread_at(m)))
        fprintf(gp, " %g", fmax(divergence(&fits[i], asp_spread_at(m)), noise));
    fputc('\n', gp);
  }
  fprintf(gp,
          "EOD\nset xlabel 'impact angle {/Symbol a}_1 / degrees'\nset logscale y\n"
          "set ylabel 'D_{KL} of the baseline against the density'\nset format y '10^{%%T}'\n"
          "set yrange [%g:10]\nset key top right\nset title '{/Symbol s} = %g°'\nplot ",
          noise / 2, cli_degrees(fits[0].sigma));
  for (int m = 0, column = 2; m < asp_spread_count(); m++)
    if (judged(asp_spread_at(m))) {
      fprintf(gp, "$kl using 1:%d with lines ls %d dt %d title '%s', ", column,
              (column - 2) % 6 + 1, column > 5 ? 3 : 1, asp_spread_at(m)->name);
      column++;
    }
  fputc('\n', gp);
}

/* One panel: the baseline as bars, densities as lines; a mark where a specular rebound slides. */
static void plot_panel(FILE *gp, const angle_fit *f, const char *const *names, int count) {
  aspi_view view = view_of(f);
  double degree = ASP_PI / 180, step = f->sigma * REACH / BINS;
  fputs("$bars << EOD\n", gp);
  for (int i = 0; i < BINS; i += 5) {
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
  fprintf(gp,
          "set title '{/Symbol a}_1 = %g°, {/Symbol s} = %g°'\nset xrange [%g:%g]\n"
          "set arrow 1 from %g, graph 0 to %g, graph 1 nohead lc '#999999' dt 3\n"
          "set label 1 '-{/Symbol a}_1/2' at %g, graph 0.96 right offset -0.3,0 tc '#666666'\n"
          "plot $bars with boxes lc rgb '#cccccc' title 'baseline'",
          cli_degrees(f->alpha1), cli_degrees(f->sigma), -3.5 * cli_degrees(f->sigma),
          4 * cli_degrees(f->sigma), -cli_degrees(f->alpha1) / 2, -cli_degrees(f->alpha1) / 2,
          -cli_degrees(f->alpha1) / 2);
  for (int m = 0; m < count; m++)
    fprintf(gp, ", $line%d with lines ls %d title '%s'", m, m + 1, names[m]);
  fputc('\n', gp);
}

static void plot_densities(FILE *gp, const angle_fit *fits, size_t n, const char *const *names,
                           int count) {
  fputs("set xlabel 'tilt {/Symbol Da} / degrees'\nset ylabel 'density / (1/degree)'\n"
        "set style fill solid 1 noborder\nset yrange [0:*]\nset key top right\n",
        gp);
  fprintf(gp, "set multiplot layout 1,%d\n", n < 3 ? 1 : 3);
  for (size_t i = 0; i < (n < 3 ? 1 : 3); i++)
    plot_panel(gp, &fits[n < 3 ? 0 : i * (n - 1) / 2], names, count);
}

static void plot(const cli_option *options, const angle_fit *fits, size_t n, const cli_list *sigmas,
                 const double *k, const double *lambda) {
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

static void fit_all(angle_fit *fits, size_t n, int runs, size_t samples, uint32_t seed) {
  cli_progress progress = cli_progress_begin("sampling", (double)n);
  double done = 0;
#pragma omp parallel for schedule(dynamic)
  for (size_t i = 0; i < n; i++) {
    fit_angle(&fits[i], runs, samples, seed, i);
#pragma omp critical
    cli_progress_show(&progress, ++done);
  }
  cli_progress_end(&progress);
}

static int run(int argc, char **argv) {
  cli_option options[N + 1] = {
      [SIGMA] = {"sigma", "DEGREES", "walls, as sigma = atan(s_eff): a list or from:to:step", "10"},
      [ANGLES] = {"angles", "DEGREES", "impact angles: a list or from:to:step", "1:90:1"},
      [RUNS] = {"runs", "N", "samples per angle that are fitted one by one", "100"},
      [SAMPLES] = {"samples", "N", "draws in each of them", "100000"},
      [SEED] = {"seed", "N", "seed of the draws", "1"},
      [FIGURE] = {"figure", "6|7|8|9", "which of the paper's figures --plot draws", "7"},
      [OUTPUT] = {"output", "FILE", "write there instead of to the screen", NULL},
      [PLOT] = {"plot", "FILE", "draw the figure; .png, .svg or .pdf", NULL},
  };
  cli_parse(&cli_fit, argc, argv, options, false);
  cli_list sigmas = cli_numbers(&options[SIGMA], 0.01, 80), angles = cli_angles(&options[ANGLES]);
  int runs = (int)cli_whole(&options[RUNS], 1, 100000);
  size_t samples = cli_whole(&options[SAMPLES], 1000, 100000000), n = sigmas.count * angles.count;
  angle_fit *fits = calloc(n, sizeof *fits);
  if (!fits)
    cli_fail("out of memory");
  for (size_t i = 0; i < n; i++) {
    fits[i].sigma = cli_radians(sigmas.values[i / angles.count]);
    fits[i].alpha1 = cli_radians(angles.values[i % angles.count]);
  }
  double k[DEGREE + 1], lambda[DEGREE + 1];
  fit_all(fits, n, runs, samples, (uint32_t)cli_whole(&options[SEED], 0, UINT32_MAX));
  fit_polynomial(fits, n, false, k);
  fit_polynomial(fits, n, true, lambda);
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, &options[SEED]);
  print(cli_output_stream(output), fits, n, k, lambda);
  cli_output_close(output);
  if (options[PLOT].value)
    plot(options, fits, n, &sigmas, k, lambda);
  free(fits);
  return 0;
}

const cli_command cli_fit = {
    .name = "fit",
    .summary = "the paper's route to its Weibull law, from the sampled baseline",
    .detail =
        "Samples the rejection routines, fits k and lambda per angle, and polynomials of fourth\n"
        "degree in tau = alpha1/sigma up to tau = 6.48 (as comments). A row per wall and angle,\n"
        "with D_KL of the samples against every density. Figures: 6 the effective law at small\n"
        "angles, 7 k and lambda, 8 D_KL over the angle, 9 densities at three angles.\n",
    .run = run,
};
