/* What a tilt costs: nanoseconds per quantile of every model, and the ratios that are promised, on
 * two walls (from sigma = 5.7 degrees on, `weibull` must reckon with its cut at the steepest face).
 * Times are the least of many short runs, so that other work on the machine hardly shows; ratios
 * come from one run. */
#include "asperity.h"
#include "bench.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdlib.h>

enum { N = 4096, REPEATS = 200 };

/* Impact angles evenly spread over 0 to 4 sigma, as many contacts with one wall have them, and
 * uniform u. */
typedef struct inputs {
  double sigma, alpha1[N], u[N], delta[N];
  asp_view view;
  gsl_rng *rng;
} inputs;

typedef void (*work)(inputs *in, const asp_spread_model *model);

/* Nanoseconds per item. */
static double time_of(work run, inputs *in, const asp_spread_model *model) {
  double least = INFINITY;
  for (int i = 0; i < REPEATS; i++) {
    double begun = bench_seconds();
    run(in, model);
    least = fmin(least, bench_seconds() - begun);
  }
  return 1e9 * least / N;
}

static void quantiles(inputs *in, const asp_spread_model *model) {
  asp_view view = in->view;
  for (int i = 0; i < N; i++) {
    view.alpha1 = in->alpha1[i];
    in->delta[i] = model->quantile(&view, in->u[i]);
  }
}

static void gsl_weibull(inputs *in, const asp_spread_model *model) {
  (void)model;
  for (int i = 0; i < N; i++)
    in->delta[i] = gsl_ran_weibull(in->rng, in->sigma, 1.4 + in->u[i]);
}

/* The rejection loop with GSL's fastest normal numbers at tau = 1. */
static void ziggurat(inputs *in, const asp_spread_model *model) {
  (void)model;
  for (int i = 0; i < N; i++)
    do
      in->delta[i] = gsl_ran_gaussian_ziggurat(in->rng, in->sigma);
    while (in->delta[i] <= -0.5 * in->sigma);
}

static void truncated_at_one(inputs *in, const asp_spread_model *model) {
  asp_view view = in->view;
  view.alpha1 = in->sigma;
  for (int i = 0; i < N; i++)
    in->delta[i] = model->quantile(&view, gsl_rng_uniform_pos(in->rng));
}

static void batch(inputs *in, const asp_spread_model *model) {
  asp_spread_quantile_n(model, &in->view, N, in->alpha1, in->u, in->delta);
}

static void *prepare(const asp_spread_model *model) {
  asp_sizes sizes = {0.1, 1, 16};
  asp_profile *profile = asp_profile_create(0.125, 1, 1 / 128., 131072, 1, NULL);
  void *data = profile ? model->prepare(profile, &sizes, NULL) : NULL;
  asp_profile_free(profile);
  if (!data)
    exit(1);
  return data;
}

/* Times of the models that the promises are about. */
typedef struct times {
  double gsl, loop, weibull, weibull_n, visible, visible_n, profile, truncated;
} times;

static void measure(inputs *in, const asp_spread_model *model, times *t) {
  in->view.data = model->prepare ? prepare(model) : NULL;
  double one = time_of(quantiles, in, model), many = time_of(batch, in, model);
  printf("quantile of %s, sigma %g degrees\t%.3g ns, in a batch %.3g ns\t\t\n", model->name,
         in->sigma * 180 / ASP_PI, one, many);
  if (model == asp_spread_find("weibull", NULL))
    t->weibull = one, t->weibull_n = many;
  if (model == asp_spread_find("visible", NULL))
    t->visible = one, t->visible_n = many;
  if (model == asp_spread_find("profile", NULL))
    t->profile = one;
  if (model == asp_spread_find("truncated", NULL))
    t->truncated = time_of(truncated_at_one, in, model);
  if (model->release)
    model->release((void *)in->view.data);
}

static void wall(inputs *in, double sigma) {
  in->sigma = sigma * ASP_PI / 180;
  in->view = asp_view_create(in->sigma, 0);
  in->view.d_p = 0.3;
  for (int i = 0; i < N; i++) {
    in->alpha1[i] = fmin(4 * in->sigma, ASP_PI / 2) * gsl_rng_uniform_pos(in->rng);
    in->u[i] = gsl_rng_uniform_pos(in->rng);
  }
  times t = {time_of(gsl_weibull, in, NULL), time_of(ziggurat, in, NULL), 0, 0, 0, 0, 0, 0};
  for (int i = 0; i < asp_spread_count(); i++)
    if (asp_spread_at(i)->quantile)
      measure(in, asp_spread_at(i), &t);
  bench_row("weibull over gsl_ran_weibull", t.weibull / t.gsl, "", "<=", 1.2);
  bench_row("truncated with its uniform over the ziggurat loop", t.truncated / t.loop, "", "<=", 1);
  bench_row("visible over weibull", t.visible / t.weibull, "", "<=", 1.5);
  bench_row("profile over weibull", t.profile / t.weibull, "", "<=", 0.5);
  bench_row("weibull over its batch", t.weibull / t.weibull_n, "", ">=", 3);
  bench_row("visible over its batch", t.visible / t.visible_n, "", ">=", 3);
}

int main(void) {
  static inputs in;
  in.rng = gsl_rng_alloc(gsl_rng_mt19937);
  wall(&in, 5);
  wall(&in, 10.4);
  double begun = bench_seconds();
  asp_spread_find("profile", NULL)->release(prepare(asp_spread_find("profile", NULL)));
  bench_row("profile: its table of 64 angles by 16 sizes", bench_seconds() - begun, "s", "<=", 2);
  gsl_rng_free(in.rng);
  return 0;
}
