/* The library without an engine: 10 000 quartz grains of 10 um hit a rough steel wall at 100 m/s
 * and 20 degrees; their mean coefficients of restitution. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <asperity.h>
#include <stdio.h>

int main(void) {
  enum { GRAINS = 10000 };
  asp_error error = {ASP_OK, ""};
  asp_surface *surface = asp_surface_create(5e-6, 40e-6, &error); /* R_q, lambda_c in m */
  const asp_material *quartz = asp_materials_find(NULL, "quartz", &error);
  asp_pair *pair = asp_pair_create(quartz, asp_materials_find(NULL, "304-ss", &error), &error);
  asp_wall *wall = asp_wall_create(&error);
  if (!surface || !pair || !wall) {
    fprintf(stderr, "%s\n", error.text);
    return 1;
  }
  asp_wall_set_surface(wall, surface);
  asp_code failed = asp_wall_choose(wall, "spread", "visible", &error);
  failed = failed ? failed : asp_wall_choose(wall, "collisions", "multiple", &error);
  failed = failed ? failed : asp_wall_prepare(wall, &error);

  double v1[3] = {93.97, 0, -34.20}, n[3] = {0, 0, 1}, cor_n = 0, cor_t = 0;
  asp_particle grain = {.d_p = 1e-5, .density = asp_material_get(quartz, "density"), .pair = pair};
  for (uint64_t tag = 1; tag <= GRAINS && !failed; tag++) {
    asp_impact impact;
    asp_wall_impact(wall, &grain, v1, n, &(asp_key){1, asp_key_wall("plate"), tag, 1}, &impact);
    asp_coefficients cor = asp_impact_coefficients(v1, n, &impact);
    cor_n += cor.cor_n / GRAINS;
    cor_t += cor.cor_t / GRAINS;
  }
  if (failed)
    fprintf(stderr, "%s\n", error.text);
  else
    printf("asperity %s: mean CoR_N %.3f, CoR_T %.3f\n", asp_version(), cor_n, cor_t);
  asp_wall_free(wall);
  asp_pair_free(pair);
  asp_surface_free(surface);
  return failed ? 1 : 0;
}
