/* Sustained contact: what a sphere's velocity and spin become while it stays at one wall or at
 * several, by Moreau's rule for a contact that does not end within the step (Moreau 1988; Jean
 * 1999, "The non-smooth contact dynamics method").
 *
 * Each contact i has a normal n, the velocity w of the wall's point, and a friction coefficient mu.
 * From the velocity v and the spin omega that the sphere would have without the contacts, find the
 * impulses per mass p = p_n n + p_t such that
 *
 *   v'     = v + sum p                    u = v' - r omega' x n - w    (velocity of the contact)
 *   omega' = omega - 5/(2 r) sum n x p    0 <= p_n,  u.n >= 0,  p_n (u.n) = 0
 *                                         |p_t| <= mu p_n; p_t opposes u_t where the contact slides
 *
 * One contact is solved in closed form: p_n takes the approach, and p_t = -2/7 u_t, cut at mu p_n,
 * makes the sphere roll. Several are solved one after another until nothing changes.
 *
 * A sphere in a valley of a rough wall is held by the faces around it, whose impulses act on its
 * center: there u = v' - w and |p_t| <= hold p_n, and it loses its spin.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_SUSTAINED_H
#define ASPERITY_DEM_SUSTAINED_H

#include <vector>

namespace asperity {

/* One contact of a sphere that stays at a wall. */
struct Support {
  double n[3]; /* outward unit normal */
  double w[3]; /* velocity of the wall's point; its part along n is what the sphere must keep */
  double friction;
  double hold;      /* tangent of the slope that the valley withstands; 0: there is none */
  double p[3];      /* impulse per mass on the sphere: the result */
  double turn[3];   /* spin that the valley takes, as a change of omega */
  double change[3]; /* of p, by the last sweep */
};

/* Changes v and omega of a sphere of this radius. False where no velocity satisfies all contacts,
 * as between walls that close: then the sphere moves with the mean of the walls' velocities, and
 * the impulses are those that bring it there, shared equally. */
bool solve_supports(std::vector<Support> &supports, double radius, double v[3], double omega[3]);

/* Energy per mass that friction of a solved contact takes from the sphere: impulse times sliding
 * speed. */
double slide_work(const Support &support, double radius, const double v[3], const double omega[3]);

} // namespace asperity

#endif
