/* One step, and the contacts in it.
 *
 * The engine has moved each mover straight, with the velocity of the middle of the step (a drawing
 * is in the README of dem). A mover that can meet a wall is taken back to the beginning of the step
 * and flies through it: the first contact on its path is an impact, by the wall's law, or is
 * sustained, by Moreau's rule (held.h); then it goes on with its new velocity, through any
 * number of contacts on any number of walls (meet.cpp).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

namespace {

/* Contacts are in a row if they are NEAR each other. After SERIES of them for each sphere, as
 * between closing walls, all are taken as sustained. After twice as many the search ends for this
 * step: the mover goes with its walls. */
const int SERIES = 16;

/* Contacts of one mover in one step, at most. */
const int CONTACTS_MOST = 10000;

typedef std::vector<Wall *> Walls;

} // namespace

/* From here on all walls are searched; predictions are void. */
static void search_all(const Walls &walls, Flight &flight) {
  if (flight.searches_all)
    return;
  flight.searches_all = true;
  for (Wall *wall : walls)
    flight.mover.members(*wall).ahead.expire(flight.mover.i);
}

/* All contacts of one mover in this step. near: the walls that it may touch on its known way. True
 * if any of them changes its way, which sliding along walls where it rests does not; stuck: where
 * it has stuck. */
static bool fly(const Walls &walls, const Walls &near, Flight &flight, double most, Touch &stuck) {
  const Mover &mover = flight.mover;
  const int series_most = SERIES * static_cast<int>(mover.count);
  const double known_way[3] = {flight.path.v[0], flight.path.v[1], flight.path.v[2]};
  std::vector<Touch> touches;
  Touch last = Touch();
  bool only_slid = true;
  int series = 0, all = 0, by = -1;
  stuck.wall = NULL;
  while (by < 0 && !flight.squeezed && series < 2 * series_most && all < CONTACTS_MOST &&
         find_next(flight.searches_all ? walls : near, flight, touches)) {
    flight.way += touches[0].time * aspi_length(touches[0].before.v) / mover.sphere->radius;
    flight.is_apart = flight.way > NEAR;
    flight.way = 0;
    if (all == 0 || flight.is_apart) {
      series = 0;
      flight.along.clear();
      flight.series_begin = flight.impacts.size();
      aspi_copy(flight.spin, flight.series_spin);
    }
    series++;
    all++;
    last = touches[0];
    bool slid;
    by = meet(flight, touches, series, series > series_most, slid);
    only_slid = only_slid && slid;
    if (!slid || flight.has_strayed(known_way, most))
      search_all(walls, flight);
  }
  bool stands = mover.is_ball; /* a body on walls that move takes the path that was searched */
  if (!stands)
    stands =
        std::all_of(walls.begin(), walls.end(), [](const Wall *wall) { return wall->is_still; });
  if (only_slid && (stands || all == 0) && series < 2 * series_most)
    return false;
  const bool in_row = series == 2 * series_most;
  if (by < 0 && (flight.squeezed || in_row || all == CONTACTS_MOST)) {
    const bool bounced = flight.impacts.size() > flight.series_begin;
    const bool is_trapped = flight.squeezed || (mover.is_ball && in_row && bounced);
    if (is_trapped || mover.is_ball)
      last.wall->books.count_guarded();
    last.wall->is_passed = last.wall->is_passed || flight.squeezed;
    last.wall->is_cut = last.wall->is_cut || all == CONTACTS_MOST;
    search_all(walls, flight);
    if (is_trapped && !flight.sustained.empty())
      flight.trap();
    else
      flight.wait(last);
  }
  flight.settle();
  if (by >= 0)
    stuck = touches[static_cast<size_t>(by)];
  return true;
}

/* All contacts of a mover. */
static void fly_one(const Walls &walls, const Walls &near, const Movers &movers, int i) {
  const Spheres *grains = movers.grains;
  if (!grains && movers.bodies->all[static_cast<size_t>(i)].is_guided)
    return;
  Mover mover(movers, i);
  Instant now;
  movers.read(mover, now);
  movers.read_rates(mover, now);
  Flight flight(mover, movers, now, walls);
  Touch stuck;
  const double most = grains ? Ahead::bend(grains->radius[i]) / movers.dt : 0;
  if (!fly(walls, grains ? near : walls, flight, most, stuck))
    return;
  for (const Impact &impact : flight.impacts)
    impact.wall->books.count(impact);
  if (stuck.wall) {
    double v[3]; /* what the impact has left it */
    aspi_subtract(flight.half, flight.begin, v);
    aspi_add_scaled(v, 1, stuck.v_wall, v);
    freeze(stuck, mover, movers, flight.path.x, v, flight.impacts.back().result.omega,
           flight.path.left);
    leave_rests(walls, mover);
    return;
  }
  if (flight.path.left > 0)
    flight.leap(flight.path.left);
  movers.place(mover, flight.path.x);
  movers.write(mover, flight.half, flight.spin);
  note_energy(flight);
}

/* Notes walls that go over the center of a sphere that is stuck to another wall. */
static void pass_stuck(const Walls &near, const Movers &movers, int i) {
  const Mover mover(movers, i);
  Instant now;
  movers.read(mover, now);
  for (Wall *wall : near) {
    if (wall->is_still || movers.members(*wall).rows.is_stuck(i))
      continue;
    for (const Member &member : wall->setup.shapes)
      for (size_t k = 0; k < mover.count; k++) {
        Path path;
        Contact contact;
        if (!(mover.sphere[k].mask & wall->setup.groupbit))
          continue;
        mover.arm(k, path.x);
        aspi_add_scaled(path.x, 1, now.x, path.x);
        aspi_add_scaled(path.x, -movers.dt, now.v, path.x);
        aspi_copy(now.v, path.v);
        path.left = path.dt = movers.dt;
        path.rest = 0;
        if (member.shape->find(path, NEAR * mover.sphere[k].radius, movers.dt, contact)) {
          wall->books.count_guarded();
          wall->is_passed = true;
        }
      }
  }
}

/* Stuck movers go with their wall, then the few others that may touch a wall are searched. */
static void step_movers(const Walls &walls, const Movers &movers) {
  std::vector<Candidate> near;
  Walls near_walls;
  check_ahead(walls, movers);
  const Spheres all = movers.bounds();
  for (size_t w = 0; w < walls.size(); w++) {
    Population &of = movers.members(*walls[w]);
    const auto first = static_cast<std::ptrdiff_t>(near.size());
    of.begin_step();
    walls[w]->let_go(movers);
    walls[w]->carry_stuck(movers);
    of.ahead.find_near(all, static_cast<int>(w), near);
    std::inplace_merge(near.begin(), near.begin() + first, near.end());
  }
  if (!(movers.dt > 0)) /* nothing goes anywhere */
    return;
  for (size_t k = 0; k < near.size();) {
    const int i = near[k].i;
    near_walls.clear();
    for (; k < near.size() && near[k].i == i; k++)
      if (near_walls.empty() || near_walls.back() != walls[near[k].wall])
        near_walls.push_back(walls[near[k].wall]);
    if (movers.is_stuck(walls, i))
      pass_stuck(near_walls, movers, i);
    else
      fly_one(walls, near_walls, movers, i);
  }
}

void asperity::step_walls(const Walls &walls, const Spheres &spheres, Bodies *bodies) {
  for (Wall *wall : walls)
    wall->books.begin_step(spheres.step);
  step_movers(walls, spheres);
  if (bodies) {
    step_movers(walls, *bodies);
    bodies->begins = false;
  }
  for (Wall *wall : walls)
    wall->begins = false;
}
