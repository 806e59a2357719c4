/* Contacts that last: what the velocity and the spin of a mover become while it stays at one wall
 * or at several, by Moreau's rule for a contact that does not end within the step (Moreau 1988;
 * Jean 1999, "The non-smooth contact dynamics method").
 *
 * Each contact has a normal n, the velocity w of the wall's point, and a friction coefficient mu.
 * From the velocity v and the spin omega that the mover would have without the contacts, find the
 * impulses per mass p = p_n n + p_t such that, with `arm` from the center of mass to the contact,
 *
 *   v'     = v + sum p                     u = v' + omega' x arm - w   (velocity of the contact)
 *   omega' = omega + m I^-1 sum arm x p    0 <= p_n,  u.n >= 0,  p_n (u.n) = 0
 *                                          |p_t| <= mu p_n, against u_t where it slides
 *
 * One contact of a ball is solved in closed form: p_n takes the approach, and p_t = -2/7 u_t, cut
 * at mu p_n, makes the ball roll. Several are solved one after another until nothing changes, from
 * the impulses that they have.
 *
 * A sphere in a valley of a rough wall is held by the faces around it, whose impulses act on its
 * center: there `arm` ends at that, and |p_t| <= hold p_n. A ball loses its spin there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_SUPPORTS_H
#define ASPERITY_DEM_SUPPORTS_H

#include <stddef.h>
#include <vector>

#include "dem/step/mover.h"

namespace asperity {

struct Support {
  double n[3];   /* outward unit normal */
  double w[3];   /* velocity of the wall's point; its part along n is what the mover must keep */
  double arm[3]; /* of a body */
  double friction;
  double hold;      /* tangent of the slope that the valley withstands; 0: there is none */
  double p[3];      /* impulse per mass on the mover: where it begins, and the result */
  double turn[3];   /* spin that the valley takes, as a change of omega */
  double change[3]; /* of p, by the last sweep */
  double k[3][3];   /* of a body: row d is the velocity of the point by the impulse e_d there */
};

/* Those of one mover. */
struct Supports {
  Support *first;
  size_t count;
  Supports(Support *at, size_t n) : first(at), count(n) {}
  Supports(std::vector<Support> &all) : first(all.data()), count(all.size()) {}
  Support *begin() const {
    return first;
  }
  Support *end() const {
    return first + count;
  }
};

/* Changes v and omega of a mover. False where no velocity satisfies all contacts, as between walls
 * that close: then it moves with the mean of the walls' velocities, and the impulses are those that
 * bring it there, shared equally. */
bool solve_supports(const Mover &mover, const Supports &supports, double v[3], double omega[3]);

/* The change of the spin by a solved contact. */
void twist_of(const Mover &mover, const Support &support, double twist[3]);

/* Energy per mass that friction of a solved contact takes from the mover: impulse times sliding
 * speed. */
double slide_work(const Mover &mover, const Support &support, const double v[3],
                  const double omega[3]);

} // namespace asperity

#endif
