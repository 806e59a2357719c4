/* Roughness along one direction of flight; see roughness.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/roughness.h"
#include "surface/size_law.h"

/* exp(-2.3 a) is negligible from here on. */
#define A_FREE 16.0

/* A lay within this angle (rad) of the normal has no direction on the wall. */
#define NO_LAY 1e-9

aspi_roughness aspi_roughness_of(const asp_wall *wall, const asp_particle *particle, vec n) {
  aspi_roughness rough = {.wall = wall,
                          .particle = particle,
                          .kappa = asp_surface_kappa(wall->surface, particle->d_p),
                          .across = {0, 0, 0}};
  double stretch = aspi_surface_stretch(wall->surface);
  rough.shrink = 1 / (stretch * stretch);
  if (wall->isotropic)
    aspi_surface_sphere_slopes(wall->surface, particle->d_p, rough.slope);
  else
    rough.slope[0] = asp_surface_slope(wall->surface, particle->d_p);
  const double *own = aspi_lay_of(wall, particle);
  if (!own)
    return rough;
  vec lay = load(own), across = cross(lay, n);
  double square = dot(across, across);
  if (square > NO_LAY * NO_LAY * dot(lay, lay))
    rough.across = scaled(across, 1 / sqrt(square));
  return rough;
}

double asp_wall_slope(const asp_wall *wall, double d_p) {
  const asp_particle particle = {.d_p = d_p};
  return wall->surface ? aspi_roughness_of(wall, &particle, (vec){0, 0, 1}).slope[0] : 0;
}

aspi_heading aspi_heading_of(const aspi_roughness *rough, const frame *f) {
  if (!aspi_roughness_has_lay(rough))
    return (aspi_heading){1, 0};
  return (aspi_heading){dot(f->along, rough->across) * f->per_length,
                        dot(cross(f->n, f->along), rough->across) * f->per_length};
}

aspi_heading aspi_heading_turned(aspi_heading from, double x, double y) {
  double length = hypot(x, y);
  if (!(length > 0))
    return from;
  return (aspi_heading){(x * from.cosine + y * from.sine) / length,
                        (x * from.sine - y * from.cosine) / length};
}

aspi_slopes_along aspi_roughness_along(const aspi_roughness *rough, aspi_heading heading) {
  double cc = heading.cosine * heading.cosine, ss = heading.sine * heading.sine;
  double along = cc + ss * rough->shrink, across = ss + cc * rough->shrink;
  if (!(fabs(rough->shrink - 1) > 0))
    along = across = 1;
  aspi_slopes_along s = {.slope = rough->slope[0],
                         .sd = rough->slope[0],
                         .kappa = rough->kappa * along,
                         .kappa_across = rough->kappa * across,
                         .phi_r = asp_surface_phi_r(rough->wall->surface) * sqrt(along)};
  if (!rough->wall->isotropic) {
    if (ss > 0 && fabs(rough->shrink - 1) > 0) /* a disc on the profile along the flight */
      s.slope = aspi_surface_slope_along(rough->wall->surface, rough->particle->d_p, along);
    s.sd = 0;
  } else if (fabs(rough->shrink - 1) > 0) {
    double ratio = rough->slope[1] / rough->slope[0], square = cc + ss * ratio * ratio;
    s.slope = rough->slope[0] * sqrt(square);
    s.beta = (1 - ratio * ratio) * heading.sine * heading.cosine / square;
    s.sd = rough->slope[1] / sqrt(square);
  }
  return s;
}

aspi_valley_table aspi_roughness_valleys(const aspi_roughness *rough, aspi_heading heading) {
  if (!rough->wall->valleys)
    return (aspi_valley_table){0};
  double azimuth = -atan2(heading.sine, heading.cosine);
  return aspi_valleys_at(rough->wall->valleys, rough->particle->d_p,
                         aspi_roughness_has_lay(rough) ? &azimuth : NULL);
}

double aspi_grazing(double a, double kappa) {
  return a < A_FREE ? 1 - 0.19 * tanh(2 * kappa) * exp(-2.3 * a) : 1;
}
