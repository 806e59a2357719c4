/* The roughness that a particle of one size meets along one direction of flight: rms slopes along
 * and across the flight, and their correlation. The heights are Gaussian with the autocovariance
 * r_q^2 exp(-x^2/lambda_1^2 - y^2/lambda_2^2), x across the lay and y along it. A particle in
 * straight flight along t stays in one plane, so its first hit is a first hit on a profile with
 * that direction's lambda; and for every autocovariance of elliptic contours the cross slope q is
 * beta p plus a normal number that does not depend on the profile (derived for this project).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "wall/frame.h"
#include "wall/wall.h"

typedef struct aspi_roughness {
  const asp_wall *wall;
  const asp_particle *particle;
  double slope[2]; /* rms, across the lay and along it */
  double kappa;    /* across the lay */
  double shrink;   /* (lambda_1/lambda_2)^2 */
  vec across;      /* unit vector along the wall and across its lay; 0 where it has none */
} aspi_roughness;

/* The lay at a contact; NULL: there is none. */
static inline const double *aspi_lay_of(const asp_wall *wall, const asp_particle *particle) {
  return particle->lay || !wall->has_lay ? particle->lay : wall->lay;
}

/* For a contact at a point of unit normal n. */
aspi_roughness aspi_roughness_of(const asp_wall *wall, const asp_particle *particle, vec n);

static inline bool aspi_roughness_has_lay(const aspi_roughness *rough) {
  return dot(rough->across, rough->across) > 0;
}

/* A direction of flight by its angle psi from t to the axis across the lay, counted toward b. */
typedef struct aspi_heading {
  double cosine, sine;
} aspi_heading;

aspi_heading aspi_heading_of(const aspi_roughness *rough, const frame *f);

/* The heading of a velocity with components x along t and y along b of a flight with heading
 * `from`.
 */
aspi_heading aspi_heading_turned(aspi_heading from, double x, double y);

/* Along a heading: the rms slope along the flight, and q = beta p + sd N(0,1) across it; kappa by
 * the curvatures along and across the flight; r_q over the correlation length along it. */
typedef struct aspi_slopes_along {
  double slope, beta, sd, kappa, kappa_across, phi_r;
} aspi_slopes_along;

aspi_slopes_along aspi_roughness_along(const aspi_roughness *rough, aspi_heading heading);

/* The valleys and faces along a heading; of a Gaussian wall an empty table. */
aspi_valley_table aspi_roughness_valleys(const aspi_roughness *rough, aspi_heading heading);

/* Factor on the sd of a slope at the first hit of a sphere with tan(alpha1) = a s. The sphere rests
 * on summits, and a grazing one on the highest of these: 1 - 0.19 tanh(2 kappa) exp(-2.3 a) (fitted
 * for this project to dilations of isotropic surfaces, phi_r 0.05 and 0.125, kappa 0.05 to 4). */
double aspi_grazing(double a, double kappa);
