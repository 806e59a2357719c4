/* The end of a step, after its forces: the walls hold what rests at them, and what has rebounded
 * gets its energy.
 *
 * A mover that rests is held by all of its walls in one solve (held.h), for the whole of the
 * kick from the middle of this step to that of the next, v_free = v + (dt/2) f/m: then its next
 * path ends at the walls. Half of each impulse changes v now. The other half is added to f, so the
 * next half kick of the engine applies it. The impulses warm-start the next solve. A gap or overlap
 * above rounding is closed during the next step. A wall that would have to pull lets go.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <math.h>
#include <algorithm>

#include "asperity_engine.h"
#include "contact/vector.h"

using namespace asperity;

namespace {

typedef std::vector<Wall *> Walls;

/* A mover at the end of a step, as it would be without the walls. */
struct AtEnd : Instant {
  const Mover &mover;
  const Movers &movers;
  const double dt;
  AtEnd(const Mover &one, const Movers &all) : mover(one), movers(all), dt(all.dt) {
    all.read(one, *this);
    all.read_rates(one, *this);
  }
};

/* A wall that holds a mover, and what the mover remembers of it. */
struct Hold {
  Wall *wall;
  Memory *memory;
};

/* The hold of the valley at a rough wall; where the sphere has come to the next face, it hits that.
 * True where it has. */
bool meet_face(AtEnd &now, Touch &touch, double &hold, bool &sticks) {
  const Moment moment = {now.x, now.v, now.spin, now.a, 0, now.dt, now.movers.step};
  Impact impact;
  touch.before =
      Path{{touch.x[0], touch.x[1], touch.x[2]}, {now.v[0], now.v[1], now.v[2]}, 0, now.dt, 0};
  ContactPoint at(now.mover, moment, touch);
  at.press = touch.follow + touch.curve - aspi_dot(now.a, touch.n);
  at.find_face(true);
  hold = at.hold(true);
  if (hold > 0 || !at.moved)
    return false;
  aspi_copy(touch.n, touch.n_end);
  touch.time = touch.chord = touch.approach_speed = 0;
  touch.overlapped = false;
  if (!at.graze(impact))
    return false;
  sticks = impact.result.outcome == ASP_DEPOSIT;
  if (sticks)
    freeze(touch, now.mover, now.movers, now.x, touch.v_wall, impact.result.omega, 0);
  touch.wall->books.count(impact);
  aspi_add_scaled(touch.v_wall, 1, impact.result.v2, now.v);
  aspi_copy(impact.result.omega, now.spin);
  return true;
}

/* What holds a mover; the next one uses the same list. */
class Resting {
public:
  double push[3], twist[3]; /* accelerations by the walls until the middle of the next step */

  /* Changes velocity and spin to those of the end of the step. True: it has stuck. */
  bool hold(const std::vector<Hold> &by, AtEnd &now);

private:
  bool find(const std::vector<Hold> &by, AtEnd &now, const double v[3], const double spin[3],
            bool &sticks);
  void keep(const std::vector<Hold> &by, const AtEnd &now, const double v[3], const double spin[3]);
  void let_pass(AtEnd &now, const double v[3]);
  void drop(Rest &rest) {
    rest.shape = 0;
    any_dropped_ = true;
  }

  std::vector<Held> held_;
  size_t count_;
  bool any_dropped_;
};

/* v, spin: in the middle of the next step, without the walls. False: it has hit a face on its way,
 * and these are others. */
bool Resting::find(const std::vector<Hold> &by, AtEnd &now, const double v[3], const double spin[3],
                   bool &sticks) {
  const Mover &mover = now.mover;
  count_ = 0;
  for (const Hold &one : by)
    for (Rest &rest : one.memory->rests) {
      double off, slope = 0;
      if (held_.size() == count_)
        held_.push_back(Held());
      Held &at = held_[count_];
      if (!find_rest(mover, *one.wall, rest, now.x, v, spin, now.dt, at, off)) {
        drop(rest);
        continue;
      }
      if (one.wall->is_rough && meet_face(now, at, slope, sticks)) {
        if (!sticks)
          drop(rest);
        return false;
      }
      const double radius = mover.sphere[at.sphere].radius;
      double rises = 0.5 * now.dt * (at.follow + at.curve);
      if (!(off < OVERLAP * radius))
        mover.members(*one.wall).ahead.expire(mover.i);
      else if (fabs(off) > TOUCHING * radius)
        rises += off / now.dt;
      at.set(mover, slope);
      if (fabs(rises) > 0)
        aspi_add_scaled(at.w, rises, at.n, at.w);
      count_++;
    }
  for (size_t k = 0; k < count_ && (count_ > 1 || !mover.is_ball); k++)
    aspi_add_scaled(held_[k].p, now.dt, held_[k].rest->push, held_[k].p);
  return true;
}

/* True if the contact carries no load and is opening. */
bool lifts_off(const AtEnd &now, const Held &at, const double v[3], const double spin[3]) {
  double u[3];
  if (aspi_dot(at.p, at.n) > 0)
    return false;
  aspi_subtract(v, at.w, u);
  if (!now.mover.is_ball) {
    double across[3];
    aspi_cross(spin, at.arm, across);
    aspi_add_scaled(u, 1, across, u);
  }
  return aspi_dot(u, at.n) * now.dt > ROUNDING * now.mover.sphere[at.sphere].radius;
}

/* Notes and counts what has held the mover. */
void Resting::keep(const std::vector<Hold> &by, const AtEnd &now, const double v[3],
                   const double spin[3]) {
  const double rate = 1 / now.dt;
  aspi_copy(NONE, push);
  aspi_copy(NONE, twist);
  for (const Held *at = held_.data(); at < held_.data() + count_; at++) {
    Rest &rest = *at->rest;
    if (lifts_off(now, *at, v, spin)) {
      drop(rest);
      continue;
    }
    rest.face = at->face;
    aspi_copy(at->p, rest.push);
    aspi_copy(at->turn, rest.twist);
    aspi_scale(rate, rest.push);
    aspi_scale(rate, rest.twist);
    aspi_add_scaled(push, 1, rest.push, push);
    aspi_add_scaled(twist, 1, rest.twist, twist);
    add_load(now.mover, now.x, *at);
  }
  for (const Hold &one : by) {
    aspi_copy(now.a, one.memory->free);
    if (!any_dropped_ || !now.mover.at(*one.wall).drop_gone())
      continue;
    Population &of = now.mover.members(*one.wall);
    of.ahead.expire(now.mover.i);
    of.any_left = true;
  }
}

/* Between walls that close the mover goes with their mean velocity; the next flight finds out. */
void Resting::let_pass(AtEnd &now, const double v[3]) {
  double p[3];
  aspi_subtract(v, now.v, p);
  aspi_scale(1 / static_cast<double>(count_), p);
  for (size_t k = 0; k < count_; k++) {
    const Held &at = held_[k];
    at.wall->books.add_load(at.shape,
                            now.mover.load(at.sphere, at.piece, at.x, at.n, now.x, p, NONE));
    drop(*at.rest);
  }
  count_ = 0;
  aspi_copy(v, now.v);
}

bool Resting::hold(const std::vector<Hold> &by, AtEnd &now) {
  double v[3], spin[3];
  bool sticks = false;
  any_dropped_ = false;
  do {
    aspi_add_scaled(now.v, 0.5 * now.dt, now.a, v);
    aspi_add_scaled(now.spin, 0.5 * now.dt, now.alpha, spin);
  } while (!find(by, now, v, spin, sticks) && !sticks);
  if (sticks)
    return true;
  if (!solve_held(now.mover, HeldList(held_.data(), count_), v, spin))
    let_pass(now, v);
  keep(by, now, v, spin);
  aspi_add_scaled(now.v, 0.5 * now.dt, push, now.v);
  aspi_add_scaled(now.spin, 0.5 * now.dt, twist, now.spin);
  return false;
}

} // namespace

/* ---- movers ---- */

/* A mover that rests at these walls. */
static void end_one(const Walls &walls, const std::vector<Hold> &by, const Movers &movers, int i,
                    Resting &resting) {
  const Mover mover(movers, i);
  AtEnd now(mover, movers);
  if (resting.hold(by, now)) {
    leave_rests(walls, mover);
    return;
  }
  movers.write(mover, now.v, now.spin);
  movers.push(mover, resting.push, resting.twist);
}

/* Calls act(by, i) for each mover that rests and is not stuck, with the walls that hold it. */
template <class Act> static void for_resting(const Walls &walls, const Movers &movers, Act act) {
  std::vector<Candidate> all;
  std::vector<Hold> by;
  size_t most = 0;
  bool any_stuck = false;
  for (Wall *wall : walls) {
    most += movers.members(*wall).resting.size();
    any_stuck = any_stuck || !movers.members(*wall).stuck.empty();
  }
  all.reserve(most);
  for (size_t w = 0; w < walls.size(); w++) {
    Population &of = movers.members(*walls[w]);
    const auto first = static_cast<std::ptrdiff_t>(all.size());
    const auto new_ones = std::is_sorted_until(of.resting.begin(), of.resting.end());
    std::sort(new_ones, of.resting.end());
    std::inplace_merge(of.resting.begin(), new_ones, of.resting.end());
    for (int i : of.resting)
      if (of.rows.status(i) == Status::RESTING && !(any_stuck && movers.is_stuck(walls, i)))
        all.push_back(Candidate{i, static_cast<int>(w)});
    std::inplace_merge(all.begin(), all.begin() + first, all.end());
  }
  const Candidate *at = all.data(), *const end = at + all.size();
  while (at < end) {
    const int i = at->i;
    by.clear();
    do {
      Wall *wall = walls[static_cast<size_t>(at->wall)];
      by.push_back(Hold{wall, movers.members(*wall).rows.find(i)});
    } while (++at < end && at->i == i);
    act(by, i);
  }
}

static void end_movers(const Walls &walls, const Movers &movers) {
  Resting resting;
  for (Wall *wall : walls) {
    const Population &of = movers.members(*wall);
    wall->hold_stuck(movers);
    for (int i : of.rebounded)
      if (of.rows.status(i) == Status::REBOUNDED)
        balance(*wall, movers, i);
  }
  for_resting(walls, movers,
              [&](const std::vector<Hold> &by, int i) { end_one(walls, by, movers, i, resting); });
}

/* What the walls at which a mover rests add to it until the middle of the next step. */
static void add_up(const std::vector<Hold> &by, double push[3], double twist[3]) {
  aspi_copy(NONE, push);
  aspi_copy(NONE, twist);
  for (const Hold &one : by)
    for (const Rest &rest : one.memory->rests) {
      aspi_add_scaled(push, 1, rest.push, push);
      aspi_add_scaled(twist, 1, rest.twist, twist);
    }
}

void asperity::push_again(const Walls &walls, const Movers &movers) {
  for_resting(walls, movers, [&](const std::vector<Hold> &by, int i) {
    double push[3], twist[3];
    add_up(by, push, twist);
    movers.push(Mover(movers, i), push, twist);
  });
}

/* Books a part of a mover's kicks, times which are the walls' again. */
static void book_ahead(const std::vector<Hold> &by, const Movers &movers, const Mover &mover,
                       const Instant &now, double time) {
  for (const Hold &one : by)
    for (Rest &rest : one.memory->rests) {
      Held at;
      double off, p[3], turned[3];
      find_rest(mover, *one.wall, rest, now.x, now.v, now.spin, movers.dt, at, off);
      aspi_copy(rest.push, p);
      aspi_copy(rest.twist, turned);
      aspi_scale(time, p);
      aspi_scale(time, turned);
      if (at.sphere < mover.count && at.shape < one.wall->setup.shapes.size())
        one.wall->books.add_load(at.shape,
                                 mover.load(at.sphere, at.piece, at.x, at.n, now.x, p, turned));
    }
}

/* True if two accelerations are the same, to the rounding of what is summed up in them. */
static bool is_same(const double a[3], const double b[3], const double push[3]) {
  double off[3];
  aspi_subtract(a, b, off);
  return !(aspi_length(off) > ROUNDING * (aspi_length(b) + aspi_length(push)));
}

void asperity::check_ahead(const Walls &walls, const Movers &movers) {
  const double before = walls[0]->dt_ahead, dt = movers.dt;
  if (!walls[0]->begins && !(before < dt) && !(before > dt))
    return;
  for_resting(walls, movers, [&](const std::vector<Hold> &by, int i) {
    Mover mover(movers, i);
    Instant now, start;
    double push[3], twist[3], free[3];
    add_up(by, push, twist);
    movers.read(mover, now);
    movers.read_rates(mover, now);
    start = now;
    aspi_add_scaled(now.x, -dt, now.v, start.x);
    aspi_subtract(now.a, push, free);
    if (is_same(free, by[0].memory->free, push)) {
      if (before < dt || before > dt)
        book_ahead(by, movers, mover, start, 0.5 * (dt - before));
      return;
    }
    book_ahead(by, movers, mover, start, -0.5 * before);
    if (!is_same(now.a, by[0].memory->free, push)) {
      aspi_add_scaled(now.v, -0.5 * dt, push, now.v);
      aspi_add_scaled(now.x, -0.5 * dt * dt, push, now.x);
      aspi_add_scaled(now.spin, -0.5 * dt, twist, now.spin);
      if (mover.body)
        mover.turn(twist, -0.5 * dt * dt);
      movers.place(mover, now.x);
      movers.write(mover, now.v, now.spin);
      aspi_scale(-1, push);
      aspi_scale(-1, twist);
      movers.push(mover, push, twist);
    }
    for (const Hold &one : by) {
      for (Rest &rest : one.memory->rests) {
        aspi_copy(NONE, rest.push);
        aspi_copy(NONE, rest.twist);
      }
      movers.members(*one.wall).ahead.watch(i);
    }
  });
}

void asperity::end_walls(const Walls &walls, Spheres spheres, Bodies *bodies) {
  if (!(spheres.dt > 0)) /* what rests is held as in the last step that had a length */
    spheres.dt = walls[0]->dt_ahead;
  for (Wall *wall : walls) {
    wall->books.begin_end();
    wall->dt_ahead = spheres.dt;
  }
  end_movers(walls, spheres);
  if (!bodies)
    return;
  bodies->dt = spheres.dt;
  for (Body &body : bodies->all)
    body.is_changed = false;
  end_movers(walls, *bodies);
}
