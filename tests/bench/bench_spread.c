/* What a tilt costs: nanoseconds per quantile of every model, and the ratios that are promised.
 * Times are the least of many short runs, so that other work on the machine hardly shows; ratios
 * come from one run. Usage: bench_spread [sigma in degrees]. */
#include "asperity.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

enum { N = 4096, REPEATS = 200 };

/* Impact angles evenly spread over 0 to 4 sigma, as many contacts with one wall have them, and
 * uniform u. */
typedef struct inputs {
  double sigma, alpha1[N], u[N], delta[N];
  asp_view view;
  gsl_rng *rng;
} inputs;

static double seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

typedef void (*work)(inputs *in, const asp_spread_model *model);

/* Nanoseconds per item. */
static double time_of(work run, inputs *in, const asp_spread_model *model) {
  double least = INFINITY;
  for (int i = 0; i < REPEATS; i++) {
    double begun = seconds();
    run(in, model);
    least = fmin(least, seconds() - begun);
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

static void report(const char *what, double ratio, double allowed, bool least) {
  bool kept = least ? ratio >= allowed : ratio <= allowed;
  printf("%-58s %6.2f (%s %g)%s\n", what, ratio, least ? ">=" : "<=", allowed,
         kept ? "" : "  MISSED");
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

int main(int argc, char **argv) {
  static inputs in;
  in.sigma = (argc > 1 ? atof(argv[1]) : 5) * ASP_PI / 180;
  in.rng = gsl_rng_alloc(gsl_rng_mt19937);
  in.view = asp_view_create(in.sigma, 0);
  in.view.d_p = 0.3;
  for (int i = 0; i < N; i++) {
    in.alpha1[i] = fmin(4 * in.sigma, ASP_PI / 2) * gsl_rng_uniform_pos(in.rng);
    in.u[i] = gsl_rng_uniform_pos(in.rng);
  }
  double gsl = time_of(gsl_weibull, &in, NULL), loop = time_of(ziggurat, &in, NULL);
  printf("sigma %g degrees\n%-16s %10s %10s\n", in.sigma * 180 / ASP_PI, "model", "ns", "batch ns");
  printf("%-16s %10.1f\n%-16s %10.1f\n", "gsl_ran_weibull", gsl, "ziggurat loop", loop);
  double weibull = 0, visible = 0, profile = 0, truncated = 0, weibull_n = 0, visible_n = 0;
  for (int i = 0; i < asp_spread_count(); i++) {
    const asp_spread_model *model = asp_spread_at(i);
    if (!model->quantile)
      continue;
    in.view.data = model->prepare ? prepare(model) : NULL;
    double one = time_of(quantiles, &in, model), many = time_of(batch, &in, model);
    printf("%-16s %10.1f %10.1f\n", model->name, one, many);
    if (model == asp_spread_find("weibull", NULL))
      weibull = one, weibull_n = many;
    if (model == asp_spread_find("visible", NULL))
      visible = one, visible_n = many;
    if (model == asp_spread_find("profile", NULL))
      profile = one;
    if (model == asp_spread_find("truncated", NULL))
      truncated = time_of(truncated_at_one, &in, model);
    if (model->release)
      model->release((void *)in.view.data);
  }
  report("weibull / gsl_ran_weibull", weibull / gsl, 1.2, false);
  report("truncated with its uniform / ziggurat loop, tau = 1", truncated / loop, 1, false);
  report("visible / weibull", visible / weibull, 1.5, false);
  report("profile / weibull", profile / weibull, 0.5, false);
  report("weibull / its batch", weibull / weibull_n, 3, true);
  report("visible / its batch", visible / visible_n, 3, true);
  gsl_rng_free(in.rng);
  return 0;
}
