/* The end of a step, after its forces: what stays at a wall, and the energy of what has rebounded.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

/* A particle that has stayed at a wall is still there at the end of the step if its center is
 * within this many radii. */
static const double REACH = 1.01;

/* Cosine of the largest angle between the normals of a curved wall at both ends of a step. */
static const double CURVED = 0.98;

/* Cosine below which two directions are at right angles. */
static const double ACROSS = 1e-9;

/* Of more faces than there is room for, the last ones are kept. */
void Stepper::keep_resting(int i, size_t shape, const Contact &contact) {
  RestingPlace &at = rows.place[i].resting;
  if (rows.status(i) != Status::RESTING) {
    at = RestingPlace();
    rows.set_status(i, Status::RESTING);
    touching.push_back(i);
  }
  size_t k = 0;
  while (k < at.FACES && at.shape[k] > 0 &&
         !(static_cast<size_t>(at.shape[k]) == shape + 1 &&
           static_cast<int>(at.face[k]) == contact.face))
    k++;
  if (k == at.FACES) {
    std::copy(at.shape + 1, at.shape + k, at.shape);
    std::copy(at.face + 1, at.face + k, at.face);
    k--;
  }
  at.shape[k] = static_cast<double>(shape) + 1;
  at.face[k] = contact.face;
  for (int d = 0; d < 3; d++)
    at.normal[d] = fabs(contact.curve) > 0 ? contact.n[d] : 0;
}

/* A curved wall only turns a velocity, from the normal that it had to n: gives back what the
 * projection takes of its tangential part. */
static void turn_along(const double from[3], const double n[3], const double v_wall[3],
                       double v[3]) {
  double across[3], u[3];
  const double cosine = aspi_dot(from, n);
  if (!(cosine > CURVED)) /* not curved, or an impact has turned it, too */
    return;
  aspi_add_scaled(from, -cosine, n, across);
  const double sine = aspi_length(across);
  if (!(sine > 0))
    return;
  aspi_subtract(v, v_wall, u);
  aspi_add_scaled(v, aspi_dot(u, across) / (sine * sine) * (1 / cosine - 1), across, v);
}

/* By the same rule as within the step, with the walls as they are at its end. */
static void hold_resting(const std::vector<Stepper *> &walls, const Spheres &s, int i) {
  struct At {
    Stepper *wall;
    size_t shape;
    int face;
  };
  static thread_local std::vector<At> at;
  static thread_local std::vector<Support> supports;
  at.clear();
  supports.clear();
  double *v = s.v + 3 * static_cast<size_t>(i), spin[3] = {0, 0, 0}, before[3], turned[3];
  const double *x = s.x + 3 * static_cast<size_t>(i), *from = NULL;
  if (s.omega)
    aspi_copy(s.omega + 3 * static_cast<size_t>(i), spin);
  for (Stepper *wall : walls) {
    const RestingPlace &resting = wall->rows.place[i].resting;
    from = resting.normal;
    for (size_t k = 0; k < resting.FACES && resting.shape[k] > 0; k++) {
      const At here = {wall, static_cast<size_t>(resting.shape[k]) - 1,
                       static_cast<int>(resting.face[k])};
      const Member &member = wall->setup.shapes[here.shape];
      supports.emplace_back();
      Support &support = supports.back();
      if (!member.shape->under(here.face, x, REACH * s.radius[i], support.n, support.w)) {
        supports.pop_back();
        continue;
      }
      support.friction = wall->setup.model.friction(s.type[i], member.wall_type);
      support.hold = hold_at_end(*wall, s, i, support, spin);
      at.push_back(here);
    }
  }
  if (supports.empty())
    return;
  aspi_copy(v, before);
  if (supports.size() == 1)
    turn_along(from, supports[0].n, supports[0].w, v);
  aspi_subtract(v, before, turned);
  solve_supports(supports, s.radius[i], v, spin);
  if (s.omega)
    aspi_copy(spin, s.omega + 3 * static_cast<size_t>(i));
  for (size_t k = 0; k < at.size(); k++) {
    double u[3];
    aspi_subtract(before, supports[k].w, u);
    const double slid = slide_work(supports[k], s.radius[i], v, spin);
    if (k == 0)
      aspi_add_scaled(supports[0].p, 1, turned, supports[0].p);
    ContactLoad load(s, i, at[k].face < 0 ? ~at[k].face : at[k].face, x, supports[k].n,
                     supports[k].p, u);
    load.dissipated = s.mass[i] * slid;
    if (supports[k].hold > 0)
      load.set_couple(s, i, x, supports[k].turn);
    at[k].wall->books.add_load(at[k].shape, load);
  }
}

/* ---- the energy of a rebound ------------------------------------------------------------------
 */

/* True if a change of velocity is not across n, to rounding. */
static bool changes_along(const double n[3], const double change[3]) {
  return fabs(aspi_dot(change, n)) > ACROSS * aspi_length(change);
}

/* A force that changes within a step, as that of another particle, does its work before and after a
 * rebound on two legs of the path. What it is at the end of the step is not known yet; so the
 * energy of the normal motion is noted as a linear function of it: v_n^2 = v_n2^2 + e^2 (v_n0^2 + 2
 * W_1 - v_n1^2) + 2 W_2 = SQUARE + WORK a_n(end), with W_1 and W_2 the works by the trapezoidal
 * rule before and after the contact, for the acceleration linear in time, and e = v_n2/v_n1, not
 * above 1; 0 for a particle that was staying at the wall. Of a wall with one contact only, where
 * the contacts with others leave the normal motion alone. */
void asperity::note_energy(const Flight &flight) {
  const Spheres &s = flight.spheres;
  const double *x = s.x + 3 * static_cast<size_t>(flight.i);
  if (!(aspi_dot(flight.a0, flight.a0) > 0))
    return; /* in free flight velocities stay what they are, to the bit */
  for (const Event &event : flight.events) {
    Stepper *wall = event.wall;
    const double *n = event.contact.n;
    bool others =
        wall->rows.status(flight.i) == Status::RESTING || changes_along(n, flight.settled);
    for (const Event &other : flight.events) {
      double change[3];
      aspi_subtract(other.result.v2, other.v1, change);
      others = others || (&other != &event && (other.wall == wall || changes_along(n, change)));
    }
    if (others)
      continue;
    double relative[3], leg1[3], leg2[3];
    aspi_subtract(flight.v0, event.contact.v_wall, relative);
    aspi_subtract(event.contact.x, flight.x0, leg1);
    aspi_subtract(x, event.contact.x, leg2);
    const double share = event.elapsed / s.dt, a0 = aspi_dot(flight.a0, n);
    const double d1 = aspi_dot(leg1, n) - aspi_dot(event.contact.v_wall, n) * event.elapsed;
    const double d2 =
        aspi_dot(leg2, n) - aspi_dot(event.contact.v_wall, n) * (s.dt - event.elapsed);
    const double v0 = aspi_dot(relative, n), v1 = -aspi_dot(event.v1, n),
                 v2 = aspi_dot(event.result.v2, n);
    const double e = event.grazes ? 0 : std::min(1.0, v2 / v1);
    ReboundPlace &rebound = wall->rows.place[flight.i].rebound;
    rebound.square =
        v2 * v2 + e * e * (v0 * v0 + (2 - share) * a0 * d1 - v1 * v1) + (1 - share) * a0 * d2;
    rebound.work = e * e * share * d1 + (1 + share) * d2;
    aspi_copy(n, rebound.normal);
    aspi_copy(event.contact.v_wall, rebound.v_wall);
    rebound.shape = static_cast<double>(event.shape);
    rebound.piece = event.contact.piece;
    wall->rows.set_status(flight.i, Status::REBOUNDED);
    wall->touching.push_back(flight.i);
  }
}

/* The end of a step with a rebound: the normal velocity by its energy. Without it, particles that
 * touch each other at a wall would gain or lose energy at each rebound, in steps that resolve their
 * contact well. */
static void balance(const Stepper &wall, const Spheres &s, int i) {
  const ReboundPlace &rebound = wall.rows.place[i].rebound;
  const double *n = rebound.normal, *f = s.f + 3 * static_cast<size_t>(i);
  double *v = s.v + 3 * static_cast<size_t>(i), v1[3];
  aspi_subtract(v, rebound.v_wall, v1);
  const double now = aspi_dot(v1, n);
  const double square = rebound.square + rebound.work * aspi_dot(f, n) / s.mass[i];
  const double speed = sqrt(std::max(0.0, square));
  const double change = (now < 0 ? -speed : speed) - now, none[3] = {0, 0, 0};
  const double p[3] = {change * n[0], change * n[1], change * n[2]};
  aspi_add_scaled(v, 1, p, v);
  wall.books.add_load(static_cast<size_t>(rebound.shape),
                      ContactLoad(s, i, static_cast<int>(rebound.piece),
                                  s.x + 3 * static_cast<size_t>(i), n, p, none));
}

/* ---- all particles ----------------------------------------------------------------------------
 */

void asperity::hold_particles(const std::vector<Stepper *> &walls, const Spheres &s) {
  static thread_local std::vector<Near> resting;
  static thread_local std::vector<Stepper *> held_by;
  resting.clear();
  for (size_t w = 0; w < walls.size(); w++) {
    Stepper *wall = walls[w];
    wall->books.expire();
    wall->hold_stuck(s);
    const auto first = static_cast<std::ptrdiff_t>(resting.size());
    for (int i : wall->touching)
      if (wall->rows.status(i) == Status::RESTING)
        resting.push_back(Near{i, static_cast<int>(w)});
      else if (wall->rows.status(i) == Status::REBOUNDED)
        balance(*wall, s, i);
    std::inplace_merge(resting.begin(), resting.begin() + first, resting.end());
  }
  for (size_t k = 0; k < resting.size();) {
    const int i = resting[k].i;
    held_by.clear();
    for (; k < resting.size() && resting[k].i == i; k++)
      held_by.push_back(walls[resting[k].wall]);
    hold_resting(held_by, s, i);
  }
}
