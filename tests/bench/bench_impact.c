/* One contact, random draws included, with impact angles from 0 to 90 degrees, of 10 um quartz on
 * Hastelloy X. */
#include "asperity.h"
#include "bench.h"

#include <math.h>

enum { ANGLES = 90 };

static double v1[ANGLES][3];

typedef struct contact {
  const char *spread;
  double phi_r, limit; /* ns; 0: none */
  asp_surface *surface;
  asp_wall *wall;
  unsigned at; /* the next impact */
  double sum;  /* so that no result is left out */
} contact;

static void contacts(void *context, size_t n) {
  static const double normal[3] = {0, 0, 1};
  static const asp_pair pair = {54.8e9, 200e6, 0.8, 0.3};
  static const asp_particle grain = {10e-6, 2650, &pair};
  contact *c = context;
  for (size_t i = 0; i < n; i++) {
    asp_impact impact;
    unsigned at = c->at++;
    asp_wall_impact(c->wall, &grain, v1[at % ANGLES], normal, (asp_key){1, 1, at, 1}, &impact);
    c->sum += impact.v2[2];
  }
}

static void set_velocities(void) {
  for (int i = 0; i < ANGLES; i++) {
    double alpha1 = (i + 0.5) * ASP_PI / 180;
    v1[i][0] = 100 * cos(alpha1);
    v1[i][2] = -100 * sin(alpha1);
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

int main(void) {
  static contact all[] = {
      {.spread = "none", .phi_r = 0.04, .limit = 70},
      {.spread = "weibull", .phi_r = 0.04, .limit = 150},
      {.spread = "weibull", .phi_r = 0.13, .limit = 150},
      {
          .spread = "visible",
          .phi_r = 0.13,
      },
      {.spread = "profile", .phi_r = 0.13, .limit = 150},
  };
  enum { COUNT = sizeof all / sizeof *all };
  static bench_work works[COUNT];
  set_velocities();
  for (int i = 0; i < COUNT; i++) {
    make_wall(&all[i]);
    works[i] = (bench_work){.run = contacts, .context = &all[i], .each = 1};
  }
  bench_run(works, COUNT, BENCH_ROUNDS);
  for (int i = 0; i < COUNT; i++) {
    char what[80];
    snprintf(what, sizeof what, "one contact, `%s` + bons, phi_r %g, over `none`", all[i].spread,
             all[i].phi_r);
    if (i > 0)
      bench_ratio_row(what, &works[i], &works[0], NULL, 0);
    snprintf(what, sizeof what, "one contact, `%s` + bons, phi_r %g, at best", all[i].spread,
             all[i].phi_r);
    if (all[i].limit > 0)
      bench_row(what, 1e9 * bench_least(&works[i]), "ns", "<=", all[i].limit);
    asp_wall_free(all[i].wall);
    asp_surface_free(all[i].surface);
  }
  return 0;
}
