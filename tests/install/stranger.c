/* A program outside the project that uses the installed library. */
#include <asperity.h>
#include <stdio.h>

int main(void) {
  asp_wall_spec spec = asp_wall_spec_default();
  asp_surface *surface = asp_surface_create(5e-6, 40e-6, NULL);
  spec.surface = surface;
  spec.spread = "weibull";
  asp_wall *wall = asp_wall_create(&spec, NULL);
  asp_pair pair;
  asp_pair_create(70e9, 0.17, 205e9, 0.32, 200e6, 0.8, 0.3, &pair, NULL);
  asp_particle grain = {1e-5, 2650, &pair};
  double v1[3] = {80, 0, -60}, n[3] = {0, 0, 1};
  asp_impact impact;
  asp_wall_impact(wall, &grain, v1, n, &(asp_key){1, 1, 1, 1}, &impact);
  printf("v2 = %g %g %g\n", impact.v2[0], impact.v2[1], impact.v2[2]);
  asp_wall_free(wall);
  asp_surface_free(surface);
  return impact.v2[2] > 0 ? 0 : 1;
}
