/* The energy of a rebound among forces: without it, particles that touch each other at a wall would
 * gain or lose energy at each rebound, in steps that resolve their contact well.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

/* The most impacts in one step whose forces are looked at; of more, each is a small share of it. */
static const size_t NOTED_MOST = 32;

/* True if a change of velocity is not across n, to rounding. */
static bool changes_along(const double n[3], const double change[3]) {
  return fabs(aspi_dot(change, n)) > ROUNDING * aspi_length(change);
}

/* Forces that change within a step do work before and after the rebound. Their value at the end of
 * the step is not known yet, so the energy of the normal motion is noted as a linear function of
 * it: v_n^2 = v_n2^2 + e^2 (v_n0^2 + 2 W_1 - v_n1^2) + 2 W_2 = SQUARE + WORK a_n(end), with W_1 and
 * W_2 the works by the trapezoidal rule before and after the contact, for the acceleration linear
 * in time, and e = v_n2/v_n1, not above 1; 0 for a particle that was staying at the wall. Of a wall
 * with one contact only, where the contacts with others leave the normal motion alone. */
void asperity::note_energy(const Flight &flight) {
  const Mover &mover = flight.mover;
  if (!mover.is_ball || !(aspi_dot(flight.a0, flight.a0) > 0))
    return; /* in free flight velocities stay what they are, to the bit */
  if (flight.impacts.size() > NOTED_MOST)
    return;
  for (const Impact &impact : flight.impacts) {
    Wall *wall = impact.wall;
    const WallMemory of = mover.at(*wall);
    const double *n = impact.contact.n;
    bool others = of.status() == Status::RESTING || changes_along(n, flight.settled);
    for (const Impact &other : flight.impacts) {
      double change[3];
      aspi_subtract(other.result.v2, other.v1, change);
      others = others || (&other != &impact && (other.wall == wall || changes_along(n, change)));
    }
    if (others)
      continue;
    double relative[3], leg1[3], leg2[3];
    aspi_subtract(flight.v0, impact.contact.v_wall, relative);
    aspi_subtract(impact.contact.x, flight.x0, leg1);
    aspi_subtract(flight.path.x, impact.contact.x, leg2);
    const double share = impact.elapsed / flight.dt, a0 = aspi_dot(flight.a0, n);
    const double d1 = aspi_dot(leg1, n) - aspi_dot(impact.contact.v_wall, n) * impact.elapsed;
    const double d2 =
        aspi_dot(leg2, n) - aspi_dot(impact.contact.v_wall, n) * (flight.dt - impact.elapsed);
    const double v0 = aspi_dot(relative, n), v1 = -aspi_dot(impact.v1, n),
                 v2 = aspi_dot(impact.result.v2, n);
    const double e = impact.grazes ? 0 : std::min(1.0, v2 / v1);
    of.own().rebound.resize(1);
    Rebound &rebound = of.own().rebound[0];
    rebound.square =
        v2 * v2 + e * e * (v0 * v0 + (2 - share) * a0 * d1 - v1 * v1) + (1 - share) * a0 * d2;
    rebound.work = e * e * share * d1 + (1 + share) * d2;
    aspi_copy(n, rebound.normal);
    aspi_copy(impact.contact.v_wall, rebound.v_wall);
    rebound.shape = static_cast<double>(impact.shape);
    rebound.piece = impact.contact.piece;
    of.set_status(Status::REBOUNDED);
    mover.members(*wall).rebounded.push_back(mover.i);
  }
}

void asperity::balance(Wall &wall, const Movers &movers, int i) {
  const Mover mover(movers, i);
  const Rebound &rebound = mover.at(wall).own().rebound[0];
  const double *n = rebound.normal;
  double v1[3];
  Instant end;
  movers.read(mover, end);
  movers.read_rates(mover, end);
  aspi_subtract(end.v, rebound.v_wall, v1);
  const double now = aspi_dot(v1, n);
  const double square = rebound.square + rebound.work * aspi_dot(end.a, n);
  const double speed = sqrt(std::max(0.0, square));
  const double change = (now < 0 ? -speed : speed) - now;
  const double p[3] = {change * n[0], change * n[1], change * n[2]};
  aspi_add_scaled(end.v, 1, p, end.v);
  movers.write(mover, end.v, end.spin);
  wall.books.add_load(static_cast<size_t>(rebound.shape),
                      mover.load(0, static_cast<int>(rebound.piece), end.x, n, end.x, p, NULL));
}
