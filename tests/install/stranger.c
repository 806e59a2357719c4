/* A program outside the project that uses the installed library. */
#include <asperity.h>
#include <stdio.h>
#include <string.h>

int main(void) {
  asp_error error = {ASP_OK, ""};
  char version[40];
  snprintf(version, sizeof version, "%d.%d.%d", ASP_VERSION_MAJOR, ASP_VERSION_MINOR,
           ASP_VERSION_PATCH);
  if (strcmp(version, asp_version()) != 0)
    return 1;
  asp_surface *surface = asp_surface_create(5e-6, 40e-6, &error);
  const asp_material *quartz = asp_materials_find(NULL, "quartz", &error);
  const asp_material *steel = asp_materials_find(NULL, "304-ss", &error);
  asp_pair *pair = asp_pair_create(quartz, steel, &error);
  asp_wall *wall = asp_wall_create(&error);
  if (!surface || !pair || !wall || asp_pair_set(pair, "friction", 0.4, &error) ||
      asp_pair_set(pair, "surface_energy", ASP_SURFACE_ENERGY, &error) ||
      asp_wall_choose(wall, "spread", "weibull", &error) ||
      asp_wall_choose(wall, "tilt", "isotropic", &error) ||
      asp_wall_set(wall, "temperature", 300, &error)) {
    fprintf(stderr, "%s\n", error.text);
    return 1;
  }
  asp_wall_set_surface(wall, surface);
  if (asp_wall_prepare(wall, &error)) {
    fprintf(stderr, "%s\n", error.text);
    return 1;
  }
  asp_particle grain = {1e-5, asp_material_get(quartz, "density"), pair, {0, 0, 0}};
  double v1[3] = {80, 0, -60}, n[3] = {0, 0, 1};
  asp_impact impact;
  asp_wall_impact(wall, &grain, v1, n, &(asp_key){1, asp_key_wall("stranger"), 1, 1}, &impact);
  printf("asperity %s: v2 = %g %g %g\n", asp_version(), impact.v2[0], impact.v2[1], impact.v2[2]);
  asp_wall_free(wall);
  asp_pair_free(pair);
  asp_surface_free(surface);
  return impact.v2[2] > 0 ? 0 : 1;
}
