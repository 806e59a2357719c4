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
 * the impulses that they have; where that is slow, as between walls that are nearly opposite, the
 * normal impulses are solved together.
 *
 * A sphere in a valley of a rough wall is held by the faces around it, whose impulses act on its
 * center: there `arm` ends at that, and |p_t| <= hold p_n. A ball loses its spin there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stddef.h>
#include <vector>

#include "contact/vector.h"
#include "dem/step/mover.h"

namespace asperity {

/* A contact of one of the mover's spheres with a wall. */
struct Touch : Contact {
  Wall *wall;
  size_t shape, sphere;
  Path before; /* of the sphere, by which the contact was found */
};

/* A contact that lasts; n is its normal. */
struct Held : Touch {
  Rest *rest;    /* at the end of a step: what the mover remembers of it */
  double w[3];   /* velocity of the wall's point; its part along n is what the mover must keep */
  double arm[3]; /* of a body */
  double friction;
  double hold;      /* tangent of the slope that the valley withstands; 0: there is none */
  double p[3];      /* impulse per mass on the mover: where it begins, and the result */
  double turn[3];   /* change of omega by the result */
  double change[3]; /* of p, by the last sweep */
  double work;      /* energy per mass that friction takes from the mover */
  double k[3][3];   /* of a body: row d is the velocity of the point by the impulse e_d there */

  /* On a path: the normal when it was met last, and at the path's end; along that, the path must
   * move at least at this speed. */
  double n_last[3], n_path[3], least_speed;

  /* Sets what the solve needs, but `work`, without an impulse: n, v_wall and place are known. */
  void set(const Mover &mover, double slope);
};

/* Those of one mover. */
struct HeldList {
  Held *first;
  size_t count;
  HeldList(Held *at, size_t n) : first(at), count(n) {}
  HeldList(std::vector<Held> &all) : first(all.data()), count(all.size()) {}
  Held *begin() const {
    return first;
  }
  Held *end() const {
    return first + count;
  }
};

/* Changes v and omega of a mover. False where no velocity satisfies all contacts, as between walls
 * that close: then it moves with the mean of the walls' velocities, and the impulses are those that
 * bring it there, shared equally. */
bool solve_held(const Mover &mover, HeldList all, double v[3], double omega[3]);

inline void Held::set(const Mover &mover, double slope) {
  const BodySphere &one = mover.sphere[sphere];
  aspi_copy(v_wall, w);
  if (!mover.is_ball) {
    mover.arm(sphere, arm);
    if (!(slope > 0))
      aspi_add_scaled(arm, -one.radius, n, arm);
  }
  friction = wall->setup.model.friction(one.type, wall->setup.shapes[shape].wall_type);
  hold = slope;
  aspi_copy(NONE, p);
}

} // namespace asperity
