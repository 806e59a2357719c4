/* One contact, random draws included, with impact angles from 0 to 90 degrees, of 10 um quartz on
 * Hastelloy X: one at a time, and in batches. */
#include "asperity.h"
#include "bench.h"

#include <math.h>

enum { ANGLES = 1024 };

static const asp_pair pair = {54.8e9, 200e6, 0.8, 0.3};
static double v1[ANGLES][3], normal[ANGLES][3];
static asp_particle grain[ANGLES];

typedef struct contact {
  const char *spread;
  double phi_r, limit, batch_limit; /* ns; 0: none */
  asp_surface *surface;
  asp_wall *wall;
  unsigned at; /* the next impact */
  double sum;  /* so that no result is left out */
} contact;

static void contacts(void *context, size_t n) {
  contact *c = context;
  for (size_t i = 0; i < n; i++) {
    asp_impact impact;
    unsigned at = c->at++, k = at % ANGLES;
    asp_wall_impact(c->wall, &grain[k], v1[k], normal[k], &(asp_key){1, 1, at, 1}, &impact);
    c->sum += impact.v2[2];
  }
}

/* n batches. */
static void batches(void *context, size_t n) {
  static asp_key key[ANGLES];
  static asp_impact impact[ANGLES];
  contact *c = context;
  for (size_t i = 0; i < n; i++) {
    for (int k = 0; k < ANGLES; k++)
      key[k] = (asp_key){1, 1, c->at++, 1};
    asp_wall_impact_n(c->wall, ANGLES, grain, (const double(*)[3])v1, (const double(*)[3])normal,
                      key, impact);
    c->sum += impact[0].v2[2];
  }
}

/* The angles in no order, as contacts of a simulation come. */
static void set_contacts(void) {
  for (int i = 0; i < ANGLES; i++) {
    double alpha1 = ((i * 389) % ANGLES + 0.5) / ANGLES * ASP_PI / 2;
    v1[i][0] = 100 * cos(alpha1);
    v1[i][2] = -100 * sin(alpha1);
    normal[i][2] = 1;
    grain[i] = (asp_particle){10e-6, 2650, &pair};
  }
}

static void make_wall(contact *c) {
  asp_wall_spec spec = asp_wall_spec_default();
  spec.surface = c->surface = asp_surface_create(c->phi_r * 120e-6, 120e-6, NULL);
  spec.spread = c->spread;
  spec.sizes = (asp_sizes){10e-6, 10e-6, 1};
  c->wall = asp_wall_create(&spec, NULL);
  if (!c->surface || !c->wall)
    abort();
}

static void print(const contact *c, const bench_work *one, const bench_work *many,
                  const bench_work *none) {
  char what[80];
  snprintf(what, sizeof what, "one contact, `%s` + bons, phi_r %g", c->spread, c->phi_r);
  char at_best[128], over[128], batch[128], batch_over[128];
  snprintf(over, sizeof over, "%s, over `none`", what);
  snprintf(at_best, sizeof at_best, "%s, at best", what);
  snprintf(batch, sizeof batch, "%s, in batches, at best", what);
  snprintf(batch_over, sizeof batch_over, "%s, over the same in batches", what);
  if (one != none)
    bench_ratio_row(over, one, none, NULL, 0);
  bench_ratio_row(batch_over, one, many, NULL, 0);
  if (c->limit > 0)
    bench_row(at_best, 1e9 * bench_least(one), "ns", "<=", c->limit);
  if (c->batch_limit > 0)
    bench_row(batch, 1e9 * bench_least(many), "ns", "<=", c->batch_limit);
}

int main(void) {
  static contact all[] = {
      {.spread = "none", .phi_r = 0.04, .limit = 70, .batch_limit = 20},
      {.spread = "weibull", .phi_r = 0.04, .limit = 70, .batch_limit = 20},
      {.spread = "weibull", .phi_r = 0.13, .limit = 70, .batch_limit = 20},
      {.spread = "visible", .phi_r = 0.13},
      {.spread = "profile", .phi_r = 0.13, .limit = 50},
  };
  enum { COUNT = sizeof all / sizeof *all };
  static bench_work works[2 * COUNT];
  set_contacts();
  for (int i = 0; i < COUNT; i++) {
    make_wall(&all[i]);
    works[i] = (bench_work){.run = contacts, .context = &all[i], .each = 1};
    works[COUNT + i] = (bench_work){.run = batches, .context = &all[i], .each = ANGLES};
  }
  bench_run(works, 2 * COUNT, BENCH_ROUNDS);
  for (int i = 0; i < COUNT; i++) {
    print(&all[i], &works[i], &works[COUNT + i], &works[0]);
    asp_wall_free(all[i].wall);
    asp_surface_free(all[i].surface);
  }
  return 0;
}
