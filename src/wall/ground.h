/* What a rough wall is like for a particle of one size that flies along one direction: rms slopes,
 * and how those along the flight and across it hang together. The heights are Gaussian with the
 * autocovariance r_q^2 exp(-x^2/lambda_1^2 - y^2/lambda_2^2), x across the lay and y along it. A
 * particle in straight flight along t stays in one plane, so that its first hit is that on a
 * profile with the lambda of that direction; and for every autocovariance of elliptic contours the
 * cross slope q is beta p plus a normal number that does not depend on the profile (derived for
 * this project).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_IMPACT_GROUND_H
#define ASP_IMPACT_GROUND_H

#include "wall/frame.h"
#include "wall/wall.h"

typedef struct aspi_ground {
  const asp_wall *wall;
  const asp_particle *particle;
  double slope[2]; /* rms, across the lay and along it */
  double kappa;    /* across the lay */
  double shrink;   /* (lambda_1/lambda_2)^2 */
  vec across;      /* unit vector along the wall and across its lay; 0 where it has none */
} aspi_ground;

/* For a contact at a point of unit normal n. */
aspi_ground aspi_ground_of(const asp_wall *wall, const asp_particle *particle, vec n);

static inline bool aspi_ground_has_lay(const aspi_ground *ground) {
  return dot(ground->across, ground->across) > 0;
}

/* A direction of flight by its angle psi from t to the axis across the lay, counted towards b. */
typedef struct aspi_heading {
  double cosine, sine;
} aspi_heading;

aspi_heading aspi_heading_of(const aspi_ground *ground, const frame *f);

/* That of a velocity with the parts x along t and y along b, of a flight with the heading `from`.
 */
aspi_heading aspi_heading_turned(aspi_heading from, double x, double y);

/* Along a heading: the rms slope along the flight, and q = beta p + sd N(0,1) across it; kappa by
 * the curvatures along and across the flight; r_q over the correlation length along it. */
typedef struct aspi_slopes_along {
  double slope, beta, sd, kappa, kappa_across, phi_r;
} aspi_slopes_along;

aspi_slopes_along aspi_ground_slopes(const aspi_ground *ground, aspi_heading heading);

/* What is left of the sd of a slope at the first hit of a sphere that comes in at the slope a s: it
 * rests on summits, and at grazing flight on the highest of these, 1 - 0.19 tanh(2 kappa) exp(-2.3
 * a) (fitted for this project to dilations of isotropic surfaces, phi_r 0.05 and 0.125, kappa 0.05
 * to 4). */
double aspi_grazing(double a, double kappa);

#endif
