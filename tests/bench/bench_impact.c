/* One contact, random draws included: best of 25 rounds over impact angles from 0 to 90 degrees. */
#include "asperity.h"
#include "bench.h"

#include <math.h>

enum { ANGLES = 90, ROUNDS = 25, CONTACTS = 100000 };

/* ns a contact of 10 um quartz on Hastelloy X with phi_r = r_q/lambda_c. */
static double contact(const char *spread, double phi_r) {
  asp_surface *surface = asp_surface_create(phi_r * 120e-6, 120e-6, NULL);
  asp_wall_spec spec = asp_wall_spec_default();
  spec.surface = surface;
  spec.spread = spread;
  spec.sizes = (asp_sizes){10e-6, 10e-6, 1};
  asp_wall *wall = asp_wall_create(&spec, NULL);
  asp_pair pair = {54.8e9, 200e6, 0.8, 0.3};
  asp_particle grain = {10e-6, 2650, &pair};
  double v[ANGLES][3], n[3] = {0, 0, 1}, best = INFINITY, sum = 0;
  for (int i = 0; i < ANGLES; i++) {
    double alpha1 = (i + 0.5) * ASP_PI / 180;
    v[i][0] = 100 * cos(alpha1);
    v[i][1] = 0;
    v[i][2] = -100 * sin(alpha1);
  }
  for (int round = 0; round < ROUNDS; round++) {
    double begun = bench_seconds();
    for (unsigned i = 0; i < CONTACTS; i++) {
      asp_impact impact;
      asp_wall_impact(wall, &grain, v[i % ANGLES], n, (asp_key){1, 1, i, 1}, &impact);
      sum += impact.v2[2];
    }
    best = fmin(best, (bench_seconds() - begun) / CONTACTS * 1e9);
  }
  asp_wall_free(wall);
  asp_surface_free(surface);
  return sum > 0 ? best : NAN;
}

int main(void) {
  bench_row("one contact, none + bons", contact("none", 0.04), "ns", "<=", 70);
  bench_row("one contact, weibull + bons, phi_r 0.04", contact("weibull", 0.04), "ns", "<=", 150);
  bench_row("one contact, weibull + bons, phi_r 0.13", contact("weibull", 0.13), "ns", "<=", 150);
  bench_row("one contact, profile table + bons, phi_r 0.13", contact("profile", 0.13), "ns",
            "<=", 150);
  return 0;
}
