/* Contacts for an instruction counter: one_impact MODEL PHI_R CONTACTS [isotropic], with impact
 * angles from 0 to 90 degrees; `isotropic`: with tilts in all directions and later hits, as walls
 * have them by default. See bench_instructions.sh.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/wall.h"
#include "surface/heights.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char **argv) {
  if (argc < 4) {
    fprintf(stderr, "usage: one_impact MODEL PHI_R CONTACTS [isotropic]\n");
    return 2;
  }
  asp_error error;
  double r_q = atof(argv[2]) * 120e-6;
  asp_surface *surface = asp_surface_create(r_q, 120e-6, &error);
  asp_heights *profile =
      aspi_profile_generate(r_q, 120e-6, 2e-6, 1 << 12, 1, surface ? &error : NULL);
  aspi_wall_choice choice = aspi_wall_choice_smooth();
  choice.surface = surface;
  choice.heights = profile;
  choice.spread = profile ? asp_spread_find(argv[1], &error) : NULL;
  choice.isotropic = choice.multiple = argc > 4;
  choice.sizes = (aspi_sizes){10e-6, 10e-6, 1};
  asp_wall *wall = choice.spread ? aspi_wall_create(&choice, &error) : NULL;
  if (!wall) {
    fprintf(stderr, "one_impact: %s\n", error.text);
    return 1;
  }
  asp_pair pair = {54.8e9, 200e6, 0.8, 0.3, 7800};
  asp_particle grain = {10e-6, 2650, &pair, {0, 0, 0}, NULL, 0, 0, NULL};
  unsigned contacts = (unsigned)strtoul(argv[3], NULL, 10);
  double n[3] = {0, 0, 1}, sum = 0;
  for (unsigned i = 0; i < contacts; i++) {
    double alpha1 = (i % 90 + 0.5) * ASP_PI / 180;
    double v[3] = {100 * cos(alpha1), 0, -100 * sin(alpha1)};
    asp_impact impact;
    asp_wall_impact(wall, &grain, v, n, &(asp_key){1, 1, i, 1}, &impact);
    sum += impact.v2[2];
  }
  asp_wall_free(wall);
  asp_heights_free(profile);
  asp_surface_free(surface);
  return sum > 0 ? 0 : 1;
}
