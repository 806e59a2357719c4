/* weibull_fit: the paper's own route to its Weibull law. Sample the baseline (routines 1 to 3, the
 * model `rejection`) many times per impact angle, fit k and lambda to each sample, take means, and
 * lay polynomials of fourth degree through them up to the boundary angle e = 6.48 sigma. Over
 * alpha1/sigma all walls fall on one curve (fig. 7), which the code keeps as ten numbers. The
 * samples also judge every density (fig. 6, 8, 9).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/running.h"
#include "cli/cli.h"
#include "spread/models.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit.h>
#include <gsl/gsl_vector.h>
#include <math.h>
#include <stdlib.h>

enum { FIT_BINS = 600, FIT_DEGREE = 4 };

/* Bins reach from -alpha1/2 up over this many sigma. */
#define FIT_REACH 12.0

/* tau of the paper's boundary angle e. */
#define FIT_TAU_END 6.48

/* One wall at one angle. */
typedef struct angle_fit {
  double sigma, alpha1;   /* rad */
  double count[FIT_BINS]; /* of all runs, by (delta + alpha1/2)/sigma */
  double n;
  double k, k_sd, lambda, lambda_sd; /* mean and sd over the runs; lambda over sigma */
} angle_fit;

/* The wall as a model looks at it. */
static aspi_spread_input view_of(const angle_fit *f) {
  return aspi_spread_input_of(f->sigma, f->alpha1);
}

static double place_of(int bin) {
  return (bin + 0.5) * FIT_REACH / FIT_BINS;
}

/* The derivative of the likelihood in k, its root the fit: sum y^k ln y / sum y^k - 1/k - mean ln y
 * (and lambda^k = mean y^k). Also its own derivative. */
static double score(const double *count, double n, double mean_log, double k, double *slope,
                    double *power) {
  double s0 = 0, s1 = 0, s2 = 0;
  for (int i = 0; i < FIT_BINS; i++) {
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
  for (int i = 0; i < FIT_BINS; i++)
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
  aspi_spread_input view = view_of(f);
  aspi_stream stream = aspi_stream_begin(&key);
  for (int i = 0; i < FIT_BINS; i++)
    count[i] = 0;
  for (size_t i = 0; i < samples; i++) {
    double delta;
    aspi_spread_draw(baseline, &view, &stream, &delta);
    int bin = (int)((delta + f->alpha1 / 2) / f->sigma * (FIT_BINS / FIT_REACH));
    count[bin < FIT_BINS ? bin : FIT_BINS - 1]++;
  }
}

static void fit_angle(angle_fit *f, int runs, size_t samples, uint32_t seed, uint64_t tag) {
  aspi_running all_k = {0, 0, 0}, all_lambda = {0, 0, 0};
  for (int run = 0; run < runs; run++) {
    double count[FIT_BINS], k, lambda;
    asp_key key = {seed, asp_key_wall("fit"), tag, (uint32_t)run + 1, 0};
    sample(f, samples, key, count);
    fit_weibull(count, (double)samples, &k, &lambda);
    aspi_running_add(&all_k, k);
    aspi_running_add(&all_lambda, lambda);
    for (int i = 0; i < FIT_BINS; i++)
      f->count[i] += count[i];
  }
  f->n = (double)samples * runs;
  f->k = all_k.mean;
  f->k_sd = aspi_running_sd(&all_k);
  f->lambda = all_lambda.mean;
  f->lambda_sd = aspi_running_sd(&all_lambda);
}

/* True if a model has its own density over delta, so that the baseline's samples can judge it. */
static bool judges(const asp_spread_model *model) {
  return model->density && model->quantile && !model->prepare;
}

/* D_KL of the samples against a model's law, less the samples' bias. A bin that the model does not
 * reach counts as 1e-9. */
static double divergence(const angle_fit *f, const asp_spread_model *model) {
  aspi_spread_input view = view_of(f);
  double sum = 0, bins = 0, step = f->sigma * FIT_REACH / FIT_BINS, low = 0;
  for (int i = 0; i < FIT_BINS; i++) {
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
    used += fits[i].alpha1 <= FIT_TAU_END * fits[i].sigma;
  if (used <= FIT_DEGREE)
    cli_bad_usage("--angles: %zu of them are below e = 6.48 sigma; a fit needs more than %d", used,
                  (int)FIT_DEGREE);
  gsl_matrix *x = gsl_matrix_alloc(used, FIT_DEGREE + 1),
             *cov = gsl_matrix_alloc(FIT_DEGREE + 1, FIT_DEGREE + 1);
  gsl_vector *y = gsl_vector_alloc(used);
  gsl_vector_view out = gsl_vector_view_array(c, FIT_DEGREE + 1);
  gsl_multifit_linear_workspace *room = gsl_multifit_linear_alloc(used, FIT_DEGREE + 1);
  if (!x || !cov || !y || !room)
    cli_fail("out of memory");
  for (size_t i = 0, row = 0; i < n; i++) {
    double tau = fits[i].alpha1 / fits[i].sigma;
    if (fits[i].alpha1 > FIT_TAU_END * fits[i].sigma)
      continue;
    for (size_t j = 0; j <= FIT_DEGREE; j++)
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
  for (int j = FIT_DEGREE; j >= 0; j--)
    sum = sum * tau + c[j];
  return sum;
}

static void print(FILE *out, const angle_fit *fits, size_t n, const double *k,
                  const double *lambda) {
  for (int q = 0; q < 2; q++) {
    fprintf(out, "# %s =", q ? "lambda/sigma" : "k");
    for (int j = 0; j <= FIT_DEGREE; j++)
      fprintf(out, " %+.6f tau^%d", q ? lambda[j] : k[j], j);
    fputc('\n', out);
  }
  fputs("sigma_deg,alpha1_deg,tau,k,k_sd,lambda_over_sigma,lambda_over_sigma_sd,k_polynomial,"
        "lambda_polynomial",
        out);
  for (int m = 0; m < asp_spread_count(); m++)
    if (judges(asp_spread_at(m)))
      fprintf(out, ",kl_%s", asp_spread_at(m)->name);
  fputc('\n', out);
  for (size_t i = 0; i < n; i++) {
    const angle_fit *f = &fits[i];
    double tau = f->alpha1 / f->sigma;
    fprintf(out, "%g,%g,%.6g,%.6f,%.6f,%.6f,%.6f,", aspi_degrees(f->sigma), aspi_degrees(f->alpha1),
            tau, f->k, f->k_sd, f->lambda, f->lambda_sd);
    if (tau <= FIT_TAU_END)
      fprintf(out, "%.6f,%.6f", polynomial(k, tau), polynomial(lambda, tau));
    else
      fputc(',', out);
    for (int m = 0; m < asp_spread_count(); m++)
      if (judges(asp_spread_at(m)))
        fprintf(out, ",%.6f", divergence(f, asp_spread_at(m)));
    fputc('\n', out);
  }
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

static const cli_option options[] = {
    {"sigma", "DEGREES", "walls, as sigma = atan(s_eff): a list or from:to:step", "10"},
    {"angles", "DEGREES", "impact angles: a list or from:to:step", "1:90:1"},
    {"runs", "N", "samples per angle that are fitted one by one", "100"},
    {"samples", "N", "draws in each of them", "100000"},
    {"seed", "N", "seed of the draws", "1"},
    {.name = NULL}};

static const cli_command command = {
    .name = "weibull_fit",
    .summary = "the paper's route to its Weibull law, from the sampled baseline",
    .detail =
        "Samples the rejection routines, fits k and lambda per angle, and polynomials of fourth\n"
        "degree in tau = alpha1/sigma up to tau = 6.48 (as comments). A row per wall and angle,\n"
        "with D_KL of the samples against every density.\n",
    .options = options,
};

int main(int argc, char **argv) {
  gsl_set_error_handler_off();
  const cli_call call = cli_parse(&command, argc, argv);
  cli_list sigmas = cli_values(cli_get(&call, "sigma"), "degrees", 0.01, 80),
           angles = cli_angles(cli_get(&call, "angles"));
  int runs = (int)cli_whole(cli_get(&call, "runs"), 1, 100000);
  size_t samples = cli_whole(cli_get(&call, "samples"), 1000, 100000000),
         n = sigmas.count * angles.count;
  angle_fit *fits = cli_allocate(n, sizeof *fits);
  for (size_t i = 0; i < n; i++) {
    fits[i].sigma = aspi_radians(sigmas.values[i / angles.count]);
    fits[i].alpha1 = aspi_radians(angles.values[i % angles.count]);
  }
  double k[FIT_DEGREE + 1], lambda[FIT_DEGREE + 1];
  fit_all(fits, n, runs, samples, (uint32_t)cli_whole(cli_get(&call, "seed"), 0, UINT32_MAX));
  fit_polynomial(fits, n, false, k);
  fit_polynomial(fits, n, true, lambda);
  FILE *out = cli_output_open(&call, "output", NULL);
  print(out, fits, n, k, lambda);
  cli_file_close(out);
  return 0;
}
