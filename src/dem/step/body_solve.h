/* Contacts of a rigid body at several points at once, by Moreau's rule: impulses p at the points,
 * from its velocity and angular momentum, such that for the velocity u of each point relative to
 * the wall
 *
 *   0 <= p_n,  u.n >= 0,  p_n (u.n) = 0,  |p_t| <= mu p_n; p_t opposes u_t where the point slides
 *
 * solved one after another until nothing changes. With all impulses times 1 + e it is the impact of
 * several points: kinetic energy does not grow for e <= 1 (as p.u' <= 0 at each point).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_BODY_SOLVE_H
#define ASPERITY_DEM_BODY_SOLVE_H

#include <vector>

#include "asperity.h"

namespace asperity {

struct BodyPoint {
  double n[3];   /* outward unit normal */
  double w[3];   /* velocity of the wall's point */
  double arm[3]; /* from the center of mass */
  double friction;
  double p[3]; /* impulse on the body: the result */
};

/* The product of a symmetric matrix xx, yy, zz, xy, xz, yz. */
void multiply(const double m[6], const double a[3], double out[3]);

/* Fills the impulses of the points of a body that moves with v and omega, which stay. */
void solve_body(const asp_body &body, const double v[3], const double omega[3],
                std::vector<BodyPoint> &points);

} // namespace asperity

#endif
