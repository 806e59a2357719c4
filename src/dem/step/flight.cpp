/* The path of a particle within a step, and its sustained contacts; see
 * flight.h and sustained.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

namespace {

/* Two contacts are one where the cosine between their normals differs from 1 by less; on one face,
 * which may be curved, by less than TURNED. */
const double SAME = 1e-9, TURNED = 0.01;

/* Relative rounding of sums. */
const double EPSILON = 1e-12;

} // namespace

Flight::Flight(const Spheres &s, int particle, Lists &lists)
    : spheres(s), i(particle), radius(s.radius[i]), mass(s.mass[i]), events(lists.events),
      sustained(lists.sustained), supports(lists.supports), along(lists.along), settled(),
      squeezed(false), known(lists.known), searches_all(false), is_apart(false), series_begin(0) {
  events.clear();
  known.clear();
  const double *x = s.x + 3 * static_cast<size_t>(i), *v = s.v + 3 * static_cast<size_t>(i);
  path.left = path.dt = s.dt;
  aspi_copy(v, path.v);
  aspi_copy(v, half);
  for (int d = 0; d < 3; d++)
    spin[d] = s.omega ? s.omega[3 * static_cast<size_t>(i) + d] : 0;
  aspi_add_scaled(x, -s.dt, v, path.x);
  aspi_copy(s.f + 3 * static_cast<size_t>(i), acceleration);
  aspi_scale(1 / mass, acceleration);
  aspi_copy(path.x, x0);
  aspi_add_scaled(v, -0.5 * s.dt, acceleration, v0);
  aspi_copy(v0, begin);
  aspi_copy(acceleration, a0);
}

/* At a time since the beginning of the path. */
void Flight::velocity(double time, double v[3]) const {
  aspi_add_scaled(begin, time, acceleration, v);
}

/* Moves the particle on to a contact. v: its velocity there. */
void Flight::advance(const Contact &contact, double v[3]) {
  velocity(contact.time, v);
  aspi_copy(contact.x, path.x);
  path.left = std::max(0.0, path.left - contact.time);
  aspi_copy(v, begin);
}

/* Along a direction, the mean of what acts for the rest of the step. */
void Flight::act_along(const double n[3], double ahead[3]) const {
  aspi_add_scaled(ahead, 0.5 * path.left * aspi_dot(a0, n) - aspi_dot(ahead, n), n, ahead);
}

/* The path from where it has come to, by a contact that has changed the velocity there. Its mean
 * velocity differs from that at its beginning: along n by what acts for the rest of the step, and
 * across it by as much as before, so that a particle which loses nothing along the wall ends where
 * it would have without the wall. The walls at which it stayed hold it no more. */
void Flight::turn(const double before[3], const double after[3], const double n[3]) {
  double ahead[3], held[3];
  aspi_subtract(acceleration, a0, held);
  const double by = aspi_length(held);
  aspi_copy(a0, acceleration);
  aspi_subtract(path.v, before, ahead);
  if (by > 0) {
    aspi_scale(1 / by, held);
    act_along(held, ahead);
  }
  act_along(n, ahead);
  aspi_add_scaled(after, 0.5 * path.dt - elapsed(), a0, half);
  aspi_copy(after, begin);
  aspi_add_scaled(after, 1, ahead, path.v);
}

/* True if the path differs from that at the beginning of the step by more than this velocity. */
bool Flight::has_strayed(double most) const {
  double change[3];
  aspi_subtract(path.v, spheres.v + 3 * static_cast<size_t>(i), change);
  return !(aspi_dot(change, change) <= most * most);
}

/* ---- sustained contacts -----------------------------------------------------------------------
 */

/* Faces of a flat mesh count as one. */
bool Flight::Sustained::is_at(const Stepper *other, size_t other_shape, const Contact &now) const {
  return wall == other && shape == other_shape &&
         aspi_dot(n, now.n) > 1 - (contact.face == now.face ? TURNED : SAME);
}

Flight::Sustained *Flight::find_sustained(const Stepper *wall, size_t shape,
                                          const Contact &contact) {
  for (Sustained &one : sustained)
    if (one.is_at(wall, shape, contact))
      return &one;
  return NULL;
}

/* Adds a sustained contact to those of this place, and solves all of them. One that is there
 * already is met again because the path is straight, and only the path changes. */
void Flight::sustain(Stepper *wall, size_t shape, const Contact &contact, double hold) {
  const double speed = aspi_length(path.v) + aspi_length(contact.v_wall);
  const double least_speed = aspi_dot(path.v, contact.n_end) +
                             (1 + ROUNDING) * std::max(0.0, contact.closing) + EPSILON * speed;
  if (Sustained *one = find_sustained(wall, shape, contact)) {
    one->least_speed = least_speed;
    aspi_copy(contact.n, one->n);
    aspi_copy(contact.n_end, one->n_end);
  } else
    add_sustained(wall, shape, contact, least_speed, hold);
  follow_walls();
}

void Flight::add_sustained(Stepper *wall, size_t shape, const Contact &contact, double least_speed,
                           double hold) {
  if (is_apart)
    settle();
  if (sustained.empty()) {
    aspi_copy(half, free_half);
    aspi_copy(spin, free_spin);
  }
  sustained.push_back(Sustained{wall,
                                shape,
                                contact,
                                least_speed,
                                {contact.n[0], contact.n[1], contact.n[2]},
                                {contact.n_end[0], contact.n_end[1], contact.n_end[2]}});
  supports.push_back(Support());
  Support &s = supports.back();
  aspi_copy(contact.n, s.n);
  aspi_add_scaled(contact.v_wall, 0.5 * path.left * contact.follow, contact.n, s.w);
  s.friction = wall->setup.model.friction(spheres.type[i], wall->setup.shapes[shape].wall_type);
  s.hold = hold;

  double before[3];
  aspi_copy(half, before);
  aspi_copy(free_half, half);
  aspi_copy(free_spin, spin);
  squeezed = !solve_supports(supports, radius, half, spin) || squeezed;
  for (int d = 0; d < 3; d++)
    path.v[d] += half[d] - before[d];
}

/* Makes the path follow the walls as the search finds them, which differs slightly from the
 * velocities at one instant. The push against the walls must not speed the particle up along
 * them, and at this instant it moves along them. */
void Flight::follow_walls() {
  aspi_copy(a0, acceleration);
  for (const Sustained &one : sustained) {
    const Contact &contact = one.contact;
    const double push = contact.follow + contact.curve - aspi_dot(acceleration, contact.n);
    aspi_add_scaled(acceleration, std::max(0.0, push), contact.n, acceleration);
  }
  if (sustained.size() == 1) {
    const double *n = sustained[0].n_end, less = sustained[0].least_speed - aspi_dot(path.v, n);
    aspi_add_scaled(path.v, std::max(0.0, less), n, path.v);
  } else {
    double none[3] = {0, 0, 0};
    along.resize(sustained.size());
    for (size_t k = 0; k < sustained.size(); k++) {
      along[k].friction = along[k].hold = 0;
      aspi_copy(sustained[k].n_end, along[k].n);
      aspi_copy(sustained[k].n_end, along[k].w);
      aspi_scale(sustained[k].least_speed, along[k].w);
    }
    solve_supports(along, radius, path.v, none);
  }
  aspi_add_scaled(half, elapsed() - 0.5 * spheres.dt, acceleration, begin);
  for (const Sustained &one : sustained) {
    const Contact &contact = one.contact;
    aspi_add_scaled(begin, aspi_dot(contact.v_wall, contact.n) - aspi_dot(begin, contact.n),
                    contact.n, begin);
  }
}

/* Ends the contacts of this place: the walls take their impulses, and remember that the particle
 * rests on them until the end of the step. */
void Flight::settle() {
  for (size_t k = 0; k < sustained.size(); k++) {
    const Sustained &one = sustained[k];
    const Support &s = supports[k];
    double u[3];
    aspi_subtract(free_half, one.contact.v_wall, u);
    ContactLoad load(spheres, i, one.contact.piece, one.contact.x, s.n, s.p, u);
    load.dissipated = mass * slide_work(s, radius, half, spin);
    if (s.hold > 0)
      load.set_couple(spheres, i, one.contact.x, s.turn);
    one.wall->books.add_load(one.shape, load);
    aspi_add_scaled(settled, 1, s.p, settled);
    one.wall->keep_resting(i, one.shape, one.contact);
  }
  sustained.clear();
  supports.clear();
}

/* Load of a particle that has stuck or was trapped: its change of velocity over the step, less the
 * part of its other contacts. This is the load until it moves with its wall. */
void Flight::give_rest(Stepper *wall, size_t shape, const Contact &contact,
                       const double end[3]) const {
  const double none[3] = {0, 0, 0};
  double rest[3];
  aspi_subtract(end, v0, rest);
  aspi_add_scaled(rest, -0.5 * spheres.dt, a0, rest);
  aspi_subtract(rest, settled, rest);
  for (const Event &event : events)
    for (int d = 0; d < 3; d++)
      rest[d] -= event.result.v2[d] - event.v1[d];
  wall->books.add_load(shape, ContactLoad(spheres, i, contact.piece, contact.x, none, rest, none));
}

/* The walls leave no room: the particle goes with them, in their middle, and none of the impacts in
 * this place has happened. */
void Flight::trap() {
  const double share = 1.0 / static_cast<double>(sustained.size());
  for (size_t k = series_begin; k < events.size(); k++)
    events[k].wall->rows.state[i].impacts--;
  events.resize(series_begin);
  aspi_copy(series_spin, spin);
  for (int d = 0; d < 3; d++) {
    path.x[d] = path.v[d] = 0;
    for (const Sustained &one : sustained) {
      path.x[d] += share * one.contact.x[d];
      path.v[d] += share * one.contact.v_wall[d];
    }
    half[d] = path.v[d];
  }
}
