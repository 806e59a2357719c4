/* Faces that have a length, and the valleys between them: the part of a rough wall that matters for
 * contacts in quick succession, or without end.
 *
 * A Gaussian profile crosses its mean height upward once per 2 pi r_q/s (Rice 1944). A face reaches
 * half as far, l = pi r_q/s = (pi/sqrt(2)) lambda_c. A particle that lies between two of them
 * starts to move at a slope of tangent q, of the law of the visible faces at grazing incidence:
 * q/s_eff has the density x exp(-x^2/2). A valley is an arc of a sine with that steepest slope, and
 * crests at Rice's mean distance 2 pi/sqrt(6) lambda_c: their height is 2/sqrt(6) q lambda_c. A
 * sphere on a surface starts over the steeper of FACES_AROUND; across its way the valley has the
 * same shape. Mean and sd of q/s_eff are 1.25 and 0.66 on a profile, 1.62 and 0.60 on a surface.
 * Spheres on generated walls that tilt slowly start at 1.34 to 1.53 (sd 0.70) and at 1.35 to 1.61
 * (0.60 to 0.68). All derived for this project, but for FACES_AROUND, which follows from that
 * comparison.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/size_law.h"
#include "wall/roughness.h"

#include <math.h>

/* Height of a crest over its valley, over q lambda_c. */
#define CREST 0.81649658092772603

/* Faces around a sphere that lies on a surface. */
enum { FACES_AROUND = 2 };

/* The frame of a direction along the wall; across the lay if it has none. */
static aspi_heading heading_along(const aspi_roughness *rough, vec along, vec n) {
  frame f = frame_of(along, n);
  return has_direction(&f) ? aspi_heading_of(rough, &f) : (aspi_heading){1, 0};
}

/* The factor from lengths across the lay to lengths along the heading, by M of the autocovariance
 * exp(-r M r). */
static double stretch(const aspi_roughness *rough, aspi_heading heading) {
  return 1 / sqrt(heading.cosine * heading.cosine + heading.sine * heading.sine * rough->shrink);
}

double asp_wall_face_length(const asp_wall *wall, const asp_particle *particle,
                            const double along[3], const double n[3]) {
  if (!wall->rough)
    return 0;
  double length = asp_surface_face_length(wall->surface, particle->d_p);
  if (!aspi_lay_of(wall, particle) && !wall->valleys)
    return length;
  aspi_roughness rough = aspi_roughness_of(wall, particle, load(n));
  aspi_heading heading = heading_along(&rough, load(along), load(n));
  aspi_valley_table table = aspi_roughness_valleys(&rough, heading);
  return table.faces ? table.face_length : length * stretch(&rough, heading);
}

/* The element of a list whose rank is a share of it, 0 < share < 1. */
static double at_rank(const float *list, size_t n, double share) {
  return list[(size_t)(share * (double)n)];
}

asp_valley asp_wall_valley(const asp_wall *wall, const asp_particle *particle,
                           const double along[3], const double n[3], const asp_key *key) {
  if (!wall->rough)
    return (asp_valley){.start = 0};
  aspi_stream stream = aspi_stream_begin(key);
  aspi_roughness rough = aspi_roughness_of(wall, particle, load(n));
  aspi_heading heading = heading_along(&rough, load(along), load(n));
  aspi_valley_table table = aspi_roughness_valleys(&rough, heading);
  double share = aspi_stream_uniform(&stream), q, height, rise = 0;
  if (wall->isotropic && !(table.starts && wall->has_cross_slope))
    share = pow(share, 1.0 / FACES_AROUND);
  if (table.starts) {
    q = at_rank(table.start, table.starts, share);
    height = at_rank(table.height, table.heights, share);
  } else {
    double lambda = asp_surface_face_length(wall->surface, particle->d_p) / ASPI_FACE_LENGTH *
                    stretch(&rough, heading);
    q = aspi_roughness_along(&rough, heading).slope * sqrt(-2 * log1p(-share));
    height = CREST * q * lambda;
  }
  double place = aspi_stream_uniform(&stream);
  if (wall->isotropic)
    rise = 0.5 * height * (1 - cos(2 * ASP_PI * aspi_stream_uniform(&stream)));
  return (asp_valley){.start = q, .height = height, .place = place, .rise = rise};
}
