/* What a tilt costs: every spread model, one quantile at a time, and as a contact draws it, against
 * samplers of other libraries; and how the cost moves with the impact angle. On several walls: from
 * sigma = 5.7 degrees on, `weibull` must reckon with its cut at the steepest face.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "asperity_internal.h"
#include "bench.h"
#include "peers.h"
#include "spread/models.h"
#include "surface/heights.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <string.h>

/* So many inputs that no branch predictor learns them, and what a step of a simulation may have. */
enum { INPUTS = 1 << 16, MODELS_MAX = 16 };

/* Ratios of alpha1 to sigma, three a decade, and the rounds over them. */
enum { PLACES = 13, PLACE_ROUNDS = 51 };

/* Impact angles evenly spread over 0 to 4 sigma, as many contacts with one wall have them, and
 * uniform u. */
typedef struct inputs {
  double sigma, alpha1[INPUTS], u[INPUTS];
  gsl_rng *rng;
} inputs;

/* A work's context: a model on a wall. */
typedef struct sampler {
  const asp_spread_model *model;
  const inputs *in;
  aspi_spread_input input;
  bool one_angle; /* that of the input; otherwise those of the inputs */
  const bench_pinv *pinv;
  size_t at;  /* the next input */
  double sum; /* so that no result is left out */
} sampler;

static size_t next(sampler *s) {
  size_t at = s->at++ % INPUTS;
  if (!s->one_angle)
    s->input.alpha1 = s->in->alpha1[at];
  return at;
}

static void quantiles(void *context, size_t n) {
  sampler *s = context;
  for (size_t i = 0; i < n; i++) {
    size_t at = next(s);
    s->sum += s->model->quantile(&s->input, s->in->u[at]);
  }
}

/* As a contact does it, its own stream included. */
static void draws(void *context, size_t n) {
  sampler *s = context;
  for (size_t i = 0; i < n; i++) {
    aspi_stream stream = aspi_stream_begin(&(asp_key){1, 1, next(s), 1, 0});
    double delta;
    aspi_spread_draw(s->model, &s->input, &stream, &delta);
    s->sum += delta;
  }
}

/* With the generator that the rejection loop of `ziggurat` has. */
static void quantiles_gsl_uniform(void *context, size_t n) {
  sampler *s = context;
  for (size_t i = 0; i < n; i++)
    s->sum += s->model->quantile(&s->input, gsl_rng_uniform_pos(s->in->rng));
}

static void gsl_weibull(void *context, size_t n) {
  sampler *s = context;
  for (size_t i = 0; i < n; i++)
    s->sum += gsl_ran_weibull(s->in->rng, s->in->sigma, bench_shape(i));
}

static void gsl_ziggurat(void *context, size_t n) {
  sampler *s = context;
  for (size_t i = 0; i < n; i++)
    s->sum += gsl_ran_gaussian_ziggurat(s->in->rng, s->in->sigma);
}

static void gsl_tail(void *context, size_t n) {
  sampler *s = context;
  for (size_t i = 0; i < n; i++)
    s->sum += gsl_ran_gaussian_tail(s->in->rng, s->in->sigma, s->in->sigma);
}

static void gsl_uniform(void *context, size_t n) {
  sampler *s = context;
  for (size_t i = 0; i < n; i++)
    s->sum += gsl_rng_uniform_pos(s->in->rng);
}

/* The rejection loop with GSL's fastest normal numbers, at tau = 1. */
static void ziggurat_loop(void *context, size_t n) {
  sampler *s = context;
  double sigma = s->in->sigma, delta;
  for (size_t i = 0; i < n; i++) {
    do
      delta = gsl_ran_gaussian_ziggurat(s->in->rng, sigma);
    while (delta <= -0.5 * sigma);
    s->sum += delta;
  }
}

static void std_weibull(void *context, size_t n) {
  sampler *s = context;
  double sigma = s->in->sigma;
  bench_std_weibull(&sigma, n);
}

static void std_normal(void *context, size_t n) {
  sampler *s = context;
  double sigma = s->in->sigma;
  bench_std_normal(&sigma, n);
}

static void first_uniform(void *context, size_t n) {
  sampler *s = context;
  for (size_t i = 0; i < n; i++) {
    aspi_stream stream = aspi_stream_begin(&(asp_key){1, 1, s->at++, 1, 0});
    s->sum += aspi_stream_uniform(&stream);
  }
}

static void next_uniform(void *context, size_t n) {
  sampler *s = context;
  aspi_stream stream = aspi_stream_begin(&(asp_key){1, 1, s->at++, 1, 0});
  for (size_t i = 0; i < n; i++)
    s->sum += aspi_stream_uniform(&stream);
}

/* The unit of them all comes first. */
static const struct peer {
  const char *name;
  void (*run)(void *sampler, size_t n);
} peers[] = {
    {"gsl_ran_weibull", gsl_weibull},
    {"gsl_ran_gaussian_ziggurat", gsl_ziggurat},
    {"gsl_ran_gaussian_tail beyond one sd", gsl_tail},
    {"std::weibull_distribution", std_weibull},
    {"std::normal_distribution", std_normal},
    {"random numbers alone: the first of a stream", first_uniform},
    {"random numbers alone: the next of a stream", next_uniform},
    {"random numbers alone: GSL's mt19937", gsl_uniform},
    {"random numbers alone: std::mt19937_64", bench_std_uniform},
};

enum { PEERS = sizeof peers / sizeof *peers, WORKS_MAX = 2 * MODELS_MAX + PEERS + 8 };

/* Works of one bench_run and their contexts. */
typedef struct room {
  int count;
  bench_work works[WORKS_MAX];
  sampler samplers[WORKS_MAX];
} room;

static bench_work *add(room *r, void (*run)(void *, size_t), const sampler *s) {
  if (r->count == WORKS_MAX)
    abort();
  bench_work *work = &r->works[r->count];
  r->samplers[r->count] = *s;
  *work = (bench_work){.run = run, .context = &r->samplers[r->count], .each = 1};
  r->count++;
  return work;
}

/* What the models need of a Gaussian profile with this rms slope; smaller particles than 0.1
 * correlation lengths follow it. */
static void prepare(inputs *in, void *data[MODELS_MAX]) {
  aspi_sizes sizes = {0.05, 0.5, 16};
  asp_heights *profile =
      aspi_profile_generate(tan(in->sigma) / sqrt(2), 1, 1 / 128., 1 << 16, 1, NULL);
  const aspi_height_field of = {.heights = profile};
  for (int i = 0; i < asp_spread_count(); i++) {
    const asp_spread_model *model = asp_spread_at(i);
    data[i] = profile && model->prepare ? model->prepare(&of, &sizes, NULL) : NULL;
    if (model->prepare && !data[i])
      abort();
  }
  asp_heights_free(profile);
}

static void release(void *data[MODELS_MAX]) {
  for (int i = 0; i < asp_spread_count(); i++)
    if (data[i])
      asp_spread_at(i)->release(data[i]);
}

static sampler sampler_at(const inputs *in, int model, void *const *data) {
  aspi_spread_input input = aspi_spread_input_of(in->sigma, in->sigma);
  input.d_p = 0.1;
  input.data = data[model];
  return (sampler){.model = asp_spread_at(model), .in = in, .input = input};
}

static void set_wall(inputs *in, double sigma_degrees) {
  in->sigma = sigma_degrees * ASP_PI / 180;
  for (int i = 0; i < INPUTS; i++) {
    in->alpha1[i] = fmin(4 * in->sigma, ASP_PI / 2) * gsl_rng_uniform_pos(in->rng);
    in->u[i] = gsl_rng_uniform_pos(in->rng);
  }
}

/* The works of a model; NULL where it has none. */
typedef struct ways {
  const bench_work *quantile, *draw;
} ways;

static void model_row(const char *name, const char *wall, const ways *w, const bench_work *unit) {
  const bench_work *all[] = {w->quantile, w->draw};
  char ratios[80] = "", times[80] = "";
  for (int i = 0; i < 2; i++) {
    size_t r = strlen(ratios), t = strlen(times);
    const char *comma = i ? ", " : "";
    if (all[i]) {
      snprintf(ratios + r, sizeof ratios - r, "%s%.2g", comma, bench_ratio(all[i], unit));
      snprintf(times + t, sizeof times - t, "%s%.3g", comma, 1e9 * bench_time(all[i]));
    } else {
      snprintf(ratios + r, sizeof ratios - r, "%s-", comma);
      snprintf(times + t, sizeof times - t, "%s-", comma);
    }
  }
  printf("`%s`, %s: quantile, draw, over gsl_ran_weibull\t%s x (%s ns)\t-\t-\n", name, wall, ratios,
         times);
}

/* The ways of the model of that name. */
static const ways *way(const ways *all, const char *name) {
  for (int i = 0; i < asp_spread_count(); i++)
    if (strcmp(asp_spread_at(i)->name, name) == 0)
      return &all[i];
  abort();
}

#ifdef ASP_BENCH_PINV
static void pinv_quantiles(void *context, size_t n) {
  sampler *s = context;
  for (size_t i = 0; i < n; i++)
    s->sum += bench_pinv_quantile(s->pinv, s->in->u[s->at++ % INPUTS]);
}

static void pinv_set_ups(void *context, size_t n) {
  sampler *s = context;
  for (size_t i = 0; i < n; i++)
    bench_pinv_free(bench_pinv_create(s->model, &s->input));
}

/* PINV at one impact angle, the only one its table is good for. */
static void compare_pinv(const char *name, const char *wall, const sampler *model) {
  static room r;
  r.count = 0;
  sampler s = *model;
  s.one_angle = true;
  bench_pinv *pinv = bench_pinv_create(s.model, &s.input);
  if (!pinv) {
    printf("UNU.RAN's PINV of `%s`, %s: its set-up fails\t-\t-\t-\n", name, wall);
    return;
  }
  s.pinv = pinv;
  const bench_work *ours = add(&r, quantiles, &s), *theirs = add(&r, pinv_quantiles, &s);
  const bench_work *set_up = add(&r, pinv_set_ups, &s);
  bench_run(r.works, r.count, BENCH_ROUNDS);
  char what[120];
  snprintf(what, sizeof what, "`%s` over UNU.RAN's PINV at one angle, %s", name, wall);
  bench_ratio_row(what, ours, theirs, NULL, 0);
  snprintf(what, sizeof what, "set-up of PINV for one angle over `%s`, %s", name, wall);
  bench_ratio_row(what, set_up, ours, NULL, 0);
  bench_pinv_free(pinv);
}
#endif

/* PINV beside the two laws in closed form that the fix is mostly used with. */
static void pinv_rows(const inputs *in, void *const *data, const char *wall) {
#ifdef ASP_BENCH_PINV
  for (int i = 0; i < asp_spread_count(); i++) {
    sampler s = sampler_at(in, i, data);
    if (strcmp(s.model->name, "weibull") == 0 || strcmp(s.model->name, "visible") == 0)
      compare_pinv(s.model->name, wall, &s);
  }
#else
  (void)in, (void)data;
  printf("UNU.RAN's PINV, %s: not built in, for want of libunuran-dev\t-\t-\t-\n", wall);
#endif
}

/* The two ways to ask a model, where it has them. */
static ways add_ways(room *r, const sampler *s) {
  bool inverts = s->model->quantile;
  return (ways){inverts ? add(r, quantiles, s) : NULL, add(r, draws, s)};
}

/* All models and their peers on one wall; the peers' rows but once. */
static void compare(inputs *in, double sigma, bool first) {
  static room r;
  void *data[MODELS_MAX];
  ways all[MODELS_MAX];
  const bench_work *peer[PEERS];
  char wall[40], what[120];
  snprintf(wall, sizeof wall, "sigma %g deg", sigma);
  set_wall(in, sigma);
  prepare(in, data);
  r.count = 0;
  for (int i = 0; i < PEERS; i++)
    peer[i] = add(&r, peers[i].run, &(sampler){.in = in});
  for (int i = 0; i < asp_spread_count(); i++) {
    sampler s = sampler_at(in, i, data);
    all[i] = add_ways(&r, &s);
  }
  sampler at_one = sampler_at(in, (int)(way(all, "truncated") - all), data);
  at_one.one_angle = true;
  const bench_work *cut = add(&r, quantiles_gsl_uniform, &at_one);
  const bench_work *loop = add(&r, ziggurat_loop, &at_one);
  bench_run(r.works, r.count, BENCH_ROUNDS);

  snprintf(what, sizeof what, "`truncated` with its uniform over the ziggurat loop, %s", wall);
  bench_ratio_row(what, cut, loop, NULL, 0);
  for (int i = 0; i < asp_spread_count(); i++)
    model_row(asp_spread_at(i)->name, wall, &all[i], peer[0]);
  for (int i = 1; first && i < PEERS; i++) {
    snprintf(what, sizeof what, "%s, over gsl_ran_weibull", peers[i].name);
    bench_ratio_row(what, peer[i], peer[0], NULL, 0);
  }
  pinv_rows(in, data, wall);
  release(data);
}

/* The dearest and the cheapest of a model's places on one wall. */
typedef struct span {
  double ratio, sigma; /* dearest over cheapest; degrees */
  double most, least;  /* ns */
  double most_at, least_at;
} span;

static span span_of(const bench_work *works, const double *tau, int count, double sigma) {
  int most = 0, least = 0;
  for (int k = 1; k < count; k++) {
    most = bench_time(&works[k]) > bench_time(&works[most]) ? k : most;
    least = bench_time(&works[k]) < bench_time(&works[least]) ? k : least;
  }
  return (span){bench_ratio(&works[most], &works[least]), sigma,     1e9 * bench_time(&works[most]),
                1e9 * bench_time(&works[least]),          tau[most], tau[least]};
}

/* How a model's cost moves with alpha1/sigma, on one wall; angles end at 90 degrees. */
static span cost_over_angles(const inputs *in, int model, void *const *data, double sigma) {
  static room r;
  double tau[PLACES];
  r.count = 0;
  for (int k = 0; k < PLACES; k++) {
    tau[k] = pow(10, k / 3. - 2);
    sampler s = sampler_at(in, model, data);
    s.one_angle = true;
    s.input.alpha1 = tau[k] * in->sigma;
    if (s.input.alpha1 <= ASP_PI / 2)
      add(&r, s.model->quantile ? quantiles : draws, &s);
  }
  bench_run(r.works, r.count, PLACE_ROUNDS);
  return span_of(r.works, tau, r.count, sigma);
}

static void span_row(const asp_spread_model *model, const span *s) {
  char what[120], unit[120];
  snprintf(what, sizeof what, "`%s` over alpha1/sigma 0.01 to 100: dearest over cheapest",
           model->name);
  snprintf(unit, sizeof unit, "x (%.3g ns at %.3g / %.3g ns at %.3g, sigma %g)", s->most,
           s->most_at, s->least, s->least_at, s->sigma);
  if (!model->quantile) /* of a random number of steps */
    printf("%s\t%.3g %s\t-\t-\n", what, s->ratio, unit);
  else
    bench_row(what, s->ratio, unit, "<=", 2);
}

/* Sigma 0.8 degrees, where alpha1/sigma = 100 is an angle, and a wall where it ends at 8.6. */
static void angles(inputs *in) {
  const double sigma[] = {0.8, 10.4};
  span worst[MODELS_MAX] = {{0}};
  for (int w = 0; w < 2; w++) {
    void *data[MODELS_MAX];
    set_wall(in, sigma[w]);
    prepare(in, data);
    for (int i = 0; i < asp_spread_count(); i++) {
      span s = cost_over_angles(in, i, data, sigma[w]);
      if (s.ratio > worst[i].ratio)
        worst[i] = s;
    }
    release(data);
  }
  for (int i = 0; i < asp_spread_count(); i++)
    span_row(asp_spread_at(i), &worst[i]);
}

int main(void) {
  static inputs in;
  in.rng = gsl_rng_alloc(gsl_rng_mt19937);
  if (!in.rng || asp_spread_count() > MODELS_MAX)
    return 1;
  compare(&in, 5, true);
  compare(&in, 10.4, false);
  angles(&in);
  gsl_rng_free(in.rng);
  return 0;
}
