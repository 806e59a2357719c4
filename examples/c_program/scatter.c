/* The library without an engine: 10 000 quartz grains of 10 um hit a rough steel wall at 100 m/s
 * and 20 degrees; their mean coefficients of restitution. SPDX-License-Identifier: GPL-3.0-or-later
 */
#include <asperity.h>
#include <stdio.h>

int main(void) {
  enum { GRAINS = 10000 };
  asp_error error;
  asp_wall *wall = asp_wall_from_text("surface rq 5um lambda_c 40um spread visible plane "
                                      "collisions multiple materials quartz 304-ss",
                                      0, 0, &error);
  if (!wall) {
    fprintf(stderr, "%s\n", error.text);
    return 1;
  }
  double v1[3] = {93.97, 0, -34.20}, n[3] = {0, 0, 1}, cor_n = 0, cor_t = 0;
  int rebounds = 0;
  asp_particle grain = {.d_p = 1e-5, .density = 2650};
  for (uint64_t tag = 1; tag <= GRAINS; tag++) {
    asp_impact impact;
    asp_wall_impact(wall, &grain, v1, n, &(asp_key){1, asp_key_wall("plate"), tag, 1, 0}, &impact);
    asp_coefficients cor = asp_impact_coefficients(v1, n, &impact);
    if (impact.outcome == ASP_DEPOSIT) /* it has no coefficients */
      continue;
    rebounds++;
    cor_n += cor.cor_n;
    cor_t += cor.cor_t;
  }
  printf("asperity %s: of %d grains %d rebound, with a mean CoR_N of %.3f and CoR_T of %.3f\n",
         asp_version(), GRAINS, rebounds, cor_n / rebounds, cor_t / rebounds);
  asp_wall_free(wall);
}
