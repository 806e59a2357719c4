/* One contact, random draws included, with impact angles from 0 to 90 degrees, of 10 um quartz on
 * Hastelloy X, by spread model over no spread.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "bench.h"
#include "wall/wall.h"

#include <math.h>

enum { ANGLES = 1024 };

static const asp_pair pair = {54.8e9, 200e6, 0.8, 0.3, 7800, 0, 0};
static double v1[ANGLES][3], normal[ANGLES][3];
static asp_particle grain[ANGLES];

typedef struct contact {
  const char *spread;
  double phi_r;
  bool isotropic; /* with tilts in all directions and later hits, as walls have them by default */
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
    asp_wall_impact(c->wall, &grain[k], v1[k], normal[k], &(asp_key){1, 1, at, 1, 0}, &impact);
    c->sum += impact.v2[2];
  }
}

/* The angles in no order, as contacts of a simulation come. */
static void set_contacts(void) {
  for (int i = 0; i < ANGLES; i++) {
    double alpha1 = ((i * 389) % ANGLES + 0.5) / ANGLES * ASP_PI / 2;
    v1[i][0] = 100 * cos(alpha1);
    v1[i][2] = -100 * sin(alpha1);
    normal[i][2] = 1;
    grain[i] = (asp_particle){.d_p = 10e-6, .density = 2650, .pair = &pair};
  }
}

static void make_wall(contact *c) {
  c->surface = asp_surface_create(c->phi_r * 120e-6, 120e-6, NULL);
  aspi_wall_choice choice = aspi_wall_choice_smooth();
  choice.surface = c->surface;
  choice.spread = asp_spread_find(c->spread, NULL);
  choice.isotropic = choice.multiple = c->isotropic;
  choice.sizes = (aspi_sizes){10e-6, 10e-6, 1};
  c->wall = c->surface ? aspi_wall_create(&choice, NULL) : NULL;
  if (!c->wall)
    abort();
}

int main(void) {
  static contact all[] = {
      {.spread = "none", .phi_r = 0.04},    {.spread = "weibull", .phi_r = 0.04},
      {.spread = "weibull", .phi_r = 0.13}, {.spread = "visible", .phi_r = 0.13},
      {.spread = "profile", .phi_r = 0.13}, {.spread = "visible", .phi_r = 0.13, .isotropic = true},
  };
  enum { COUNT = sizeof all / sizeof *all };
  static bench_work works[COUNT];
  set_contacts();
  for (int i = 0; i < COUNT; i++) {
    make_wall(&all[i]);
    works[i] = (bench_work){.run = contacts, .context = &all[i], .each = 1};
  }
  bench_run(works, COUNT, BENCH_ROUNDS);
  for (int i = 0; i < COUNT; i++) {
    char what[80];
    snprintf(what, sizeof what, "one contact, `%s%s` + bons, phi_r %g, over `none`", all[i].spread,
             all[i].isotropic ? " isotropic" : "", all[i].phi_r);
    bench_ratio_row(what, &works[i], &works[0], NULL, 0);
    asp_wall_free(all[i].wall);
    asp_surface_free(all[i].surface);
  }
  return 0;
}
