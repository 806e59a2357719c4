/* What a wall is like along one direction; see ground.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/ground.h"
#include "surface/size_law.h"

/* exp(-2.3 a) is nothing from here on. */
#define A_FREE 16.0

/* A lay that is this nearly along the normal has no direction on the wall. */
#define NO_LAY 1e-9

aspi_ground aspi_ground_of(const asp_wall *wall, const asp_particle *particle, vec n) {
  aspi_ground ground = {.wall = wall,
                        .particle = particle,
                        .kappa = asp_surface_kappa(wall->surface, particle->d_p),
                        .across = {0, 0, 0}};
  double stretch = asp_surface_lambda_along(wall->surface) / asp_surface_lambda_c(wall->surface);
  ground.shrink = 1 / (stretch * stretch);
  if (wall->isotropic)
    aspi_surface_sphere_slopes(wall->surface, particle->d_p, ground.slope);
  else
    ground.slope[0] = asp_surface_slope(wall->surface, particle->d_p);
  if (!particle->lay)
    return ground;
  vec lay = load(particle->lay), across = cross(lay, n);
  double square = dot(across, across);
  if (square > NO_LAY * NO_LAY * dot(lay, lay))
    ground.across = scaled(across, 1 / sqrt(square));
  return ground;
}

aspi_heading aspi_heading_of(const aspi_ground *ground, const frame *f) {
  if (!aspi_ground_has_lay(ground))
    return (aspi_heading){1, 0};
  return (aspi_heading){dot(f->along, ground->across) * f->per_length,
                        dot(cross(f->n, f->along), ground->across) * f->per_length};
}

aspi_heading aspi_heading_turned(aspi_heading from, double x, double y) {
  double length = hypot(x, y);
  if (!(length > 0))
    return from;
  return (aspi_heading){(x * from.cosine + y * from.sine) / length,
                        (x * from.sine - y * from.cosine) / length};
}

aspi_slopes_along aspi_ground_slopes(const aspi_ground *ground, aspi_heading heading) {
  double cc = heading.cosine * heading.cosine, ss = heading.sine * heading.sine;
  double along = cc + ss * ground->shrink, across = ss + cc * ground->shrink;
  if (!(fabs(ground->shrink - 1) > 0))
    along = across = 1;
  aspi_slopes_along s = {.slope = ground->slope[0],
                         .sd = ground->slope[0],
                         .kappa = ground->kappa * along,
                         .kappa_across = ground->kappa * across,
                         .phi_r = asp_surface_phi_r(ground->wall->surface) * sqrt(along)};
  if (!ground->wall->isotropic) {
    if (ss > 0 && fabs(ground->shrink - 1) > 0) /* a disc on the profile along the flight */
      s.slope = aspi_surface_slope_along(ground->wall->surface, ground->particle->d_p, along);
    s.sd = 0;
  } else if (fabs(ground->shrink - 1) > 0) {
    double ratio = ground->slope[1] / ground->slope[0], square = cc + ss * ratio * ratio;
    s.slope = ground->slope[0] * sqrt(square);
    s.beta = (1 - ratio * ratio) * heading.sine * heading.cosine / square;
    s.sd = ground->slope[1] / sqrt(square);
  }
  return s;
}

double aspi_grazing(double a, double kappa) {
  return a < A_FREE ? 1 - 0.19 * tanh(2 * kappa) * exp(-2.3 * a) : 1;
}
