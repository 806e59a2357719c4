/* Every spread model of the registry: density, distribution, quantile and draws against each other,
 * against quadrature, and against other models where theory says that they agree.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "surface/heights.h"

#include "spread/models.h"

#include <float.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_rng.h>
#include <gsl/gsl_sf_erf.h>
#include <stdlib.h>

#define DEGREE (ASP_PI / 180)

static const double sigmas[] = {0.5, 3.24, 10.4, 25, 60, 85};
static const double angles[] = {0, 1e-12, 0.1, 2, 10, 45, 90};

#define COUNT(array) (sizeof(array) / sizeof *(array))

static void *prepare(const asp_spread_model *model, double slope) {
  if (!model->prepare)
    return NULL;
  asp_heights *profile = aspi_profile_generate(slope / sqrt(2), 1, 1 / 32., 8192, 3, NULL);
  aspi_sizes sizes = {0.1, 0.4, 3};
  const aspi_height_field of = {.heights = profile};
  void *data = model->prepare(&of, &sizes, NULL);
  asp_heights_free(profile);
  assert_non_null(data);
  return data;
}

/* What each model has prepared of a profile of each wall, once for all tests. */
enum { MODELS_MOST = 32 };
static void *prepared[MODELS_MOST][COUNT(sigmas)];

static void *prepared_of(int m, size_t s, double slope) {
  assert_true(m < MODELS_MOST);
  if (!prepared[m][s])
    prepared[m][s] = prepare(asp_spread_at(m), slope);
  return prepared[m][s];
}

static int release_all(void **state) {
  (void)state;
  for (int m = 0; m < asp_spread_count(); m++)
    for (size_t s = 0; s < COUNT(sigmas); s++)
      if (prepared[m][s])
        asp_spread_at(m)->release(prepared[m][s]);
  return 0;
}

/* Calls `check` for every model that has what it asks for, on every wall and angle. */
static void for_all(void (*check)(const asp_spread_model *, const aspi_spread_input *)) {
  for (int m = 0; m < asp_spread_count(); m++)
    for (size_t s = 0; s < COUNT(sigmas); s++) {
      const asp_spread_model *model = asp_spread_at(m);
      aspi_spread_input input = aspi_spread_input_of(sigmas[s] * DEGREE, 0);
      input.data = prepared_of(m, s, input.slope);
      input.d_p = 0.3;
      for (size_t a = 0; a < COUNT(angles); a++) {
        input.alpha1 = angles[a] * DEGREE;
        input.kappa = 0.7 * (double)a;
        check(model, &input);
      }
    }
}

typedef struct integrand {
  const asp_spread_model *model;
  const aspi_spread_input *input;
} integrand;

static double density_at(double delta, void *of) {
  const integrand *i = of;
  return i->model->density(i->input, delta);
}

static void fail_at(const asp_spread_model *model, const aspi_spread_input *input, const char *what,
                    double x, double is, double should) {
  print_error("%s, sigma %g, alpha1 %g degrees: %s at %.17g is %.12g, not %.12g\n", model->name,
              input->sigma / DEGREE, input->alpha1 / DEGREE, what, x, is, should);
  fail();
}

static void check_density(const asp_spread_model *model, const aspi_spread_input *input) {
  if (!model->density)
    return;
  gsl_integration_workspace *room = gsl_integration_workspace_alloc(1000);
  integrand of = {model, input};
  gsl_function f = {density_at, &of};
  for (int i = 0; i < 24; i++) {
    double from = ASP_PI / 2 * (i - 12) / 12, to = ASP_PI / 2 * (i - 11) / 12, share, error;
    double reach = 9 * input->sigma;
    from = fmax(fmax(from, -input->alpha1), -reach);
    to = fmin(to, reach);
    if (to <= from)
      continue;
    gsl_integration_qags(&f, from, to, 1e-11, 1e-9, 1000, room, &share, &error);
    double should = model->distribution(input, to) - model->distribution(input, from);
    if (!(fabs(share - should) < (model->geometry ? 1e-6 : 2e-9))) /* a table has nodes */
      fail_at(model, input, "share of a bin", from, share, should);
  }
  gsl_integration_workspace_free(room);
}

TEST(densities_add_up_to_distributions) {
  gsl_set_error_handler_off();
  for_all(check_density);
}

static const double shares[] = {DBL_MIN, 1e-100, 1e-15, 1e-9, 1e-4,   0.0038,   0.004,      0.1,
                                0.3,     0.5,    0.7,   0.95, 0.9999, 1 - 1e-9, 1 - 0x1p-53};

static void check_quantile(const asp_spread_model *model, const aspi_spread_input *input) {
  if (!model->quantile)
    return;
  double last = -ASP_PI / 2;
  for (size_t i = 0; i < COUNT(shares); i++) {
    double delta = model->quantile(input, shares[i]);
    if (!(delta >= last - 4e-16 && delta <= ASP_PI / 2 && isfinite(delta)))
      fail_at(model, input, "quantile", shares[i], delta, last);
    last = delta;
    if (!model->distribution)
      continue;
    double share = model->distribution(input, delta);
    /* near 90 degrees the last bit of delta is much in u */
    double bit = model->density(input, delta) * 4e-16;
    if (model->density && !(fabs(share - shares[i]) < 1e-9 + bit))
      fail_at(model, input, "distribution of quantile", shares[i], share, shares[i]);
  }
}

TEST(quantiles_invert_distributions) {
  for_all(check_quantile);
}

/* Counts in bins against the distribution. As in GSL's tests of its samplers the sample is doubled
 * until the verdict is clear: chi-square below its 99 % point passes, above its 1 - 1e-9 fails. */
enum { BINS = 30 };

static double chi_square(const asp_spread_model *model, const aspi_spread_input *input, size_t n,
                         uint64_t from, double *count, const double *edge) {
  for (uint64_t tag = from; tag < from + n; tag++) {
    aspi_stream stream = aspi_stream_begin(&(asp_key){11, 5, tag, 1, 0});
    double delta;
    int bin = 0;
    if (!aspi_spread_draw(model, input, &stream, &delta))
      fail_at(model, input, "draw", (double)tag, 0, 0);
    while (bin < BINS - 1 && delta > edge[bin])
      bin++;
    count[bin]++;
  }
  double sum = 0, all = (double)(from + n);
  for (int i = 0; i < BINS; i++) {
    double low = i > 0 ? model->distribution(input, edge[i - 1]) : 0;
    double high = i < BINS - 1 ? model->distribution(input, edge[i]) : 1;
    double expected = all * (high - low);
    if (expected > 0)
      sum += (count[i] - expected) * (count[i] - expected) / expected;
    else if (count[i] > 0)
      sum = INFINITY;
  }
  return sum;
}

static void check_draws(const asp_spread_model *model, const aspi_spread_input *input) {
  if (!model->distribution)
    return;
  double count[BINS] = {0}, edge[BINS - 1], reach = fmin(3 * input->sigma, 1.5);
  for (int i = 0; i < BINS - 1; i++)
    edge[i] = -reach + 2 * reach * i / (BINS - 2);
  double good = gsl_cdf_chisq_Qinv(0.01, BINS - 1), bad = gsl_cdf_chisq_Qinv(1e-9, BINS - 1);
  uint64_t have = 0;
  for (size_t n = 4000; have < 2000000; n = have) {
    double chi2 = chi_square(model, input, n, have, count, edge);
    have += n;
    if (chi2 < good)
      return;
    if (chi2 > bad)
      break;
  }
  fail_at(model, input, "chi-square of draws", (double)have, 1, 0);
}

TEST(draws_follow_distributions) {
  for_all(check_draws);
}

/* Faces that a particle flying up can hit, and the rest of the contract there. */
TEST(flights_up) {
  for (int m = 0; m < asp_spread_count(); m++) {
    const asp_spread_model *model = asp_spread_at(m);
    if (!model->covers_rising || model->prepare)
      continue;
    for (size_t s = 0; s < COUNT(sigmas); s++)
      for (double ratio = 0.01; ratio < 30; ratio *= 1.7) {
        aspi_spread_input input = aspi_spread_input_of(sigmas[s] * DEGREE, 0);
        input.alpha1 = -atan(ratio * input.slope);
        double last = -input.alpha1;
        for (double u = 1e-9; u < 1; u += 0.0499) {
          double delta = model->quantile(&input, u);
          assert_true(delta >= last - 1e-15 && delta <= ASP_PI / 2);
          /* the last bits of delta, in the length of the law above -alpha1 */
          double bit = model->density(&input, delta) * 1e-15;
          if (!(fabs(model->distribution(&input, delta) - u) < 1e-9 + bit))
            fail_at(model, &input, "distribution of quantile", u,
                    model->distribution(&input, delta), u);
          last = delta;
        }
      }
  }
}

static double visible_integrand(double x, void *a) {
  return exp(-0.5 * x * x) * (x + *(double *)a);
}

/* The share above x by quadrature, independent of the model's closed forms. */
static double share_above(double a, double x, double *whole) {
  gsl_integration_workspace *room = gsl_integration_workspace_alloc(2000);
  gsl_function f = {visible_integrand, &a};
  double low = fmax(-a, -12), above, error;
  gsl_integration_qag(&f, low, 12, 0, 1e-13, 2000, GSL_INTEG_GAUSS61, room, whole, &error);
  gsl_integration_qag(&f, fmax(x, low), 12, 0, 1e-13, 2000, GSL_INTEG_GAUSS61, room, &above,
                      &error);
  gsl_integration_workspace_free(room);
  return above / *whole;
}

/* By how much the distribution of `visible` at its quantile is off u. */
static double visible_off(double a, double u) {
  const asp_spread_model *visible = asp_spread_find("visible", NULL);
  aspi_spread_input input = {.slope = 0.1, .sigma = atan(0.1), .alpha1 = atan(0.1 * a)};
  double whole, x = tan(visible->quantile(&input, u)) / 0.1;
  return fabs(share_above(a, x, &whole) - (1 - u));
}

TEST(visible_is_accurate_for_every_a) {
  static const double a[] = {0, 1e-12, 1e-6, 1e-3, 0.05, 0.116, 0.3, 0.7, 1,   1.5, 2,
                             3, 4.5,   6,    8,    12,   20,    38,  1e2, 1e4, 1e8, 1e12};
  double worst = 0, worst_tail = 0;
  for (size_t i = 0; i < COUNT(a); i++) {
    for (double u = 0.00137; u < 1; u += 0.00731)
      worst = fmax(worst, visible_off(a[i], u));
    for (double tail = 0.1; tail > 1e-8; tail *= 0.83) {
      worst = fmax(worst, fmax(visible_off(a[i], tail), visible_off(a[i], 1 - tail)));
      worst_tail = fmax(worst_tail, visible_off(a[i], 1 - tail) / tail);
    }
  }
  print_message("visible: worst error %.2g in u, %.2g of 1 - u\n", worst, worst_tail);
  assert_true(worst < 1e-10); /* 1e-9 is promised */
  assert_true(worst_tail < 1e-6);
}

/* The largest distance between two distributions. */
static double distance(const char *one, const char *other, double sigma, double alpha1) {
  const asp_spread_model *a = asp_spread_find(one, NULL), *b = asp_spread_find(other, NULL);
  aspi_spread_input input = aspi_spread_input_of(sigma, alpha1);
  double most = 0;
  for (int i = -400; i <= 400; i++) {
    double delta = i * sigma / 80;
    most = fmax(most, fabs(a->distribution(&input, delta) - b->distribution(&input, delta)));
  }
  return most;
}

TEST(models_agree_where_they_must) {
  assert_near(distance("rejection", "truncated", 0.2, 0.1), 0, 0);
  for (double tau = 0.25; tau < 8; tau *= 2)
    for (double sigma = 0.1; sigma > 1e-4; sigma /= 4)
      assert_near(distance("effective", "visible", sigma, tau * sigma), 0, sigma * sigma);
  static const char *const names[] = {"truncated", "rejection", "effective", "visible"};
  for (size_t i = 0; i < COUNT(names); i++)
    assert_near(distance(names[i], "normal", 1e-5, ASP_PI / 2), 0, 1e-5);
}

static double excess(double delta, void *of) {
  const aspi_spread_input *input = of;
  double p = asp_spread_find("truncated", NULL)->density(input, delta);
  double q = asp_spread_find("weibull", NULL)->density(input, delta);
  return p > 0 && q > 0 ? p * log(p / q) : 0;
}

/* The divergences that the ten coefficients were fitted to, and no step at the boundary angle. */
TEST(weibull_is_the_best_of_its_kind) {
  static const double known[][2] = {{0.25, 0.012}, {1, 0.0155}, {2, 0.020},   {3, 0.022},
                                    {4, 0.018},    {5, 0.011},  {6.25, 0.004}};
  gsl_integration_workspace *room = gsl_integration_workspace_alloc(2000);
  for (size_t i = 0; i < COUNT(known); i++) {
    aspi_spread_input input = aspi_spread_input_of(0.01, known[i][0] * 0.01);
    gsl_function f = {excess, &input};
    double kl, error;
    gsl_integration_qags(&f, -input.alpha1 / 2 + 1e-12, 0.09, 1e-9, 1e-9, 2000, room, &kl, &error);
    assert_near(kl, known[i][1], 0.0006);
  }
  gsl_integration_workspace_free(room);
  const asp_spread_model *weibull = asp_spread_find("weibull", NULL);
  for (double u = 0.001; u < 1; u += 0.01) {
    aspi_spread_input below = aspi_spread_input_of(0.01, 0.0648 - 1e-13), above = below;
    above.alpha1 = 0.0648 + 1e-13;
    assert_near(weibull->quantile(&below, u), weibull->quantile(&above, u), 1e-12);
  }
}

/* A number of 0 to 1, every third crowded toward 0, every third toward 1. */
static double crowded(gsl_rng *rng, int i) {
  double u = gsl_rng_uniform_pos(rng), tail = pow(u, 8);
  return i % 3 == 0 ? u : i % 3 == 1 ? tail : 1 - tail;
}

/* The law with its cut, against the same in long double. */
TEST(weibull_keeps_its_digits) {
  const asp_spread_model *weibull = asp_spread_find("weibull", NULL);
  gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
  for (int i = 0; i < 200000; i++) {
    double u = crowded(rng, i);
    if (!(u > 0 && u < 1))
      continue;
    aspi_spread_input input = aspi_spread_input_of(
        pow(gsl_rng_uniform(rng), 2) * 80 * DEGREE + 0.001, gsl_rng_uniform(rng) * ASP_PI / 2);
    aspi_weibull w = aspi_weibull_at(input.sigma, input.alpha1);
    long double lost = expl(-powl((ASP_DELTA_MOST - w.b) / w.lambda, w.k));
    long double place = powl(-log1pl(u * (lost - 1)), 1.L / w.k);
    double should = fmin((double)(w.b + w.lambda * place), ASP_DELTA_MOST);
    double off = fabs(weibull->quantile(&input, u) - should);
    if (!(off < 1e-14 || off * weibull->density(&input, should) < 2e-16)) /* in delta, or in u */
      fail_at(weibull, &input, "quantile", u, weibull->quantile(&input, u), should);
  }
  gsl_rng_free(rng);
}

/* The normal laws against GSL and the C library's erfc. */
TEST(normal_laws_keep_their_digits) {
  const asp_spread_model *normal = asp_spread_find("normal", NULL);
  const asp_spread_model *truncated = asp_spread_find("truncated", NULL);
  gsl_rng *rng = gsl_rng_alloc(gsl_rng_mt19937);
  for (int i = 0; i < 200000; i++) {
    double u = crowded(rng, i), sigma = 0.01, alpha1 = gsl_rng_uniform(rng) * 0.2;
    if (!(u > 1e-300 && u < 1))
      continue;
    aspi_spread_input input = aspi_spread_input_of(sigma, alpha1);
    double x = u < 0.5 ? gsl_cdf_ugaussian_Pinv(u) : gsl_cdf_ugaussian_Qinv(1 - u);
    assert_near(normal->quantile(&input, u) / sigma, x, 1e-15 + 1e-15 * fabs(x));
    double lost = 0.5 * erfc(alpha1 / 2 / sigma * M_SQRT1_2), p = u + (1 - u) * lost;
    double cut = truncated->quantile(&input, u) / sigma;
    double is = cut < 0 ? 0.5 * erfc(-cut * M_SQRT1_2) : 1 - 0.5 * erfc(cut * M_SQRT1_2);
    assert_near(is, p, 5e-16);
  }
  gsl_rng_free(rng);
}

/* A particle that grazes may be taken to fly up by its last bits, which are much to a wall that is
 * as good as smooth. */
TEST(grazing_upwards) {
  const asp_spread_model *truncated = asp_spread_find("truncated", NULL);
  double last = -1;
  for (double alpha1 = 0.1; alpha1 > -0.1; alpha1 -= 0.001) {
    aspi_spread_input input = aspi_spread_input_of(0.01, alpha1);
    double lowest = truncated->quantile(&input, 1e-12);
    assert_true(lowest > last && truncated->quantile(&input, 0.7) > lowest);
    last = lowest;
  }
}

TEST(flat_walls_have_no_spread) {
  for (int m = 0; m < asp_spread_count(); m++) {
    const asp_spread_model *model = asp_spread_at(m);
    if (model->prepare)
      continue;
    aspi_spread_input input = aspi_spread_input_of(0, 0.3);
    aspi_stream stream = aspi_stream_begin(&(asp_key){1, 1, 1, 1, 0});
    double delta = 1;
    assert_true(aspi_spread_draw(model, &input, &stream, &delta));
    assert_near(delta, 0, 0);
    input = aspi_spread_input_of(1e-300, 0.3);
    assert_true(aspi_spread_draw(model, &input, &stream, &delta));
    assert_near(delta, 0, 1e-290);
  }
}

TEST(unknown_names_list_what_there_is) {
  asp_error error;
  assert_null(asp_spread_find("wiebull", &error));
  assert_int_equal(error.code, ASP_ENAME);
  for (int m = 0; m < asp_spread_count(); m++)
    assert_says(error.text, asp_spread_at(m)->name);
  assert_null(asp_spread_find(NULL, &error));
}

TEST(models_describe_themselves) {
  for (int m = 0; m < asp_spread_count(); m++) {
    const asp_spread_model *model = asp_spread_at(m);
    assert_ptr_equal(asp_spread_find(asp_spread_name(model), NULL), model);
    assert_true(*model->summary && *model->source);
  }
}

int main(void) {
  return run_listed_tests(NULL, release_all);
}
