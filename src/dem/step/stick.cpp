/* Movers stuck to a wall, and how they move with it. A body is held as a whole by the sphere that
 * has stuck, and turns with the wall; a particle does not spin there.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/flight.h"

#include <math.h>
#include <string.h>
#include <algorithm>

#include "contact/vector.h"
#include "dem/text.h"

using namespace asperity;

/* ---- its place ---- */

/* Where the wall has the center of the sphere that sticks, after what is left of the step: the
 * periodic image that is nearest to `near`. */
static void follow(const Wall &wall, Stuck &at, const double near[3], double radius, double left,
                   double dt, bool is_body, double x[3]) {
  if (at.shape >= 1) {
    const Shape &shape = *wall.setup.shapes[static_cast<size_t>(at.shape) - 1].shape;
    Place place = {static_cast<int>(at.piece), {at.at[0], at.at[1], at.at[2]}};
    if (is_body)
      shape.turn(place, 1 - left / dt, dt, at.axes, at.omega);
    shape.carry(place, radius, left, x, at.v);
    at.piece = place.piece;
    aspi_copy(place.at, at.at);
  } else {
    aspi_copy(at.at, x);
    aspi_copy(NONE, at.v);
    aspi_copy(NONE, at.omega);
  }
  wall.setup.box.bring_near(near, x);
}

static Stuck &note(const Touch &touch, const Mover &mover) {
  Wall &wall = *touch.wall;
  Population &of = mover.members(wall);
  Place place;
  wall.setup.shapes[touch.shape].shape->stick(touch.before, touch, place);
  const bool deletes = wall.setup.model.deposit() == Model::DELETE;
  of.any_left = true;
  of.rows.set_status(mover.i, deletes ? Status::TO_DELETE : Status::STUCK);
  wall.has_to_delete = wall.has_to_delete || deletes;
  of.stuck.push_back(StuckOne{mover.i, false, false, false, {}, {}, 0, {}});
  Stuck &to = of.rows.stuck(mover.i);
  to = Stuck();
  to.sphere = static_cast<double>(mover.sphere[touch.sphere].tag);
  to.shape = static_cast<double>(touch.shape) + 1;
  to.piece = place.piece;
  to.face = touch.face;
  aspi_copy(place.at, to.at);
  return to;
}

/* ---- how it moves ---- */

/* Gives a stuck mover, which is shifted in its place, the velocity of its wall, with the load that
 * holds it. */
static void hold_one(Wall &wall, const Stuck &at, const Movers &movers, const Mover &mover,
                     const double shift[3]) {
  Instant now;
  double change[3], turn[3], center[3], swing[3];
  movers.read(mover, now);
  aspi_subtract(at.v, now.v, change);
  aspi_subtract(at.omega, now.spin, turn);
  if (!(aspi_dot(change, change) + aspi_dot(turn, turn) > 0))
    return;
  movers.write(mover, at.v, at.omega);
  if (!(at.shape >= 1))
    return;
  const size_t anchor = mover.anchor(at);
  mover.arm(anchor, center);
  aspi_add_scaled(center, 1, now.x, center);
  ContactLoad load =
      mover.load(anchor, static_cast<int>(at.piece), center, NONE, now.x, change, turn);
  aspi_cross(shift, now.v, swing);
  aspi_add_scaled(load.couple, -mover.mass, swing, load.couple);
  wall.books.add_load(static_cast<size_t>(at.shape) - 1, load);
}

/* Puts a stuck mover where its wall has it at the end of the step. */
static void carry(Wall &wall, const Movers &movers, int i, double left) {
  Stuck &at = movers.members(wall).rows.stuck(i);
  Mover mover(movers, i);
  Instant now;
  double arm[3], x[3], off[3];
  const size_t anchor = mover.anchor(at);
  movers.read(mover, now);
  mover.arm(anchor, arm);
  aspi_add_scaled(now.x, 1, arm, off);
  follow(wall, at, off, mover.sphere[anchor].radius, left, movers.dt, mover.body, x);
  if (mover.body) {
    mover.set_axes(at.axes);
    mover.arm(anchor, arm);
    aspi_subtract(x, arm, x);
    aspi_cross(at.omega, arm, off);
    aspi_subtract(at.v, off, at.v); /* that of the center of mass */
  }
  movers.place(mover, x);
  aspi_subtract(x, now.x, off);
  hold_one(wall, at, movers, mover, off);
}

void asperity::freeze(const Touch &touch, const Mover &mover, const Movers &movers,
                      const double x[3], const double v[3], const double spin[3], double left) {
  movers.place(mover, x);
  movers.write(mover, v, spin);
  Stuck &at = note(touch, mover);
  if (mover.body)
    memcpy(at.axes, mover.axes, sizeof at.axes);
  carry(*touch.wall, movers, mover.i, left);
}

void asperity::leave_rests(const std::vector<Wall *> &walls, const Mover &mover) {
  for (Wall *wall : walls) {
    if (mover.at(*wall).status() != Status::RESTING)
      continue;
    mover.at(*wall).set_status(Status::FREE);
    mover.members(*wall).any_left = true;
  }
}

void Wall::free_displaced(const Movers &movers, double moved) {
  Population &of = movers.members(*this);
  int mine = 0, all;
  for (const StuckOne &one : of.stuck) {
    Stuck at = of.rows.stuck(one.i);
    const Mover mover(movers, one.i);
    const size_t anchor = mover.anchor(at);
    const double radius = mover.sphere[anchor].radius;
    Instant now;
    double x[3], on_wall[3];
    movers.read(mover, now);
    mover.arm(anchor, x);
    aspi_add_scaled(x, 1, now.x, x);
    aspi_add_scaled(x, -moved, now.v, x);
    follow(*this, at, x, radius, 0, movers.dt, false, on_wall);
    aspi_subtract(on_wall, x, on_wall);
    if (!(aspi_length(on_wall) > DISPLACED * radius))
      continue;
    of.rows.forget(one.i);
    mine++;
  }
  if (mine > 0)
    of.list(movers.bounds(), setup.groupbit);
  MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_SUM, setup.engine.world());
  if (all > 0)
    setup.engine.warn(text("stuck %s that a command has moved from their place: %d; they are free",
                           movers.bodies ? "bodies" : "particles", all));
}

/* True if two vectors are the same to the bit. */
static inline bool is_same(const double a[3], const double b[3]) {
  return memcmp(a, b, 3 * sizeof *a) == 0;
}

/* True if velocity and mass equal those of the last step: the load can be reused. */
static inline bool comes_again(const StuckOne &at, const Spheres &s) {
  const size_t row = 3 * static_cast<size_t>(at.i);
  return is_same(s.v + row, at.v) && memcmp(s.mass + at.i, &at.mass, sizeof at.mass) == 0 &&
         (!s.omega || is_same(s.omega + row, NONE));
}

static inline void stop(const StuckOne &at, const Spheres &s) {
  aspi_copy(NONE, s.v + 3 * static_cast<size_t>(at.i));
}

static inline void put_back(const StuckOne &at, const Spheres &s) {
  aspi_copy(at.x, s.x + 3 * static_cast<size_t>(at.i));
  stop(at, s);
}

/* Ends the load of a particle after this share of a step. */
void Wall::drop_load(StuckOne &at, double share) {
  if (at.is_kept) {
    books.drop_load(at.i, at.x, at.v, at.mass, at.is_shown ? share : 1);
    rows.stuck(at.i).is_kept = 0;
  }
  at.was_stopped = at.is_kept = at.is_shown = false;
}

/* One that is not as it was in the last step; where it was stopped, it may begin to be. */
void Wall::carry_other(const Movers &movers, StuckOne &at) {
  if (!is_still || !at.was_stopped || at.is_kept || !comes_again(at, *movers.grains)) {
    drop_load(at, 0);
    carry(*this, movers, at.i, movers.dt);
    return;
  }
  books.keep_load(at.i, at.x, at.v, at.mass);
  at.is_kept = true;
  rows.stuck(at.i).is_kept = 1;
  put_back(at, *movers.grains);
}

void Wall::hold_other(const Movers &movers, StuckOne &at) {
  const Spheres *s = movers.grains;
  if (at.is_kept && comes_again(at, *s)) {
    books.show_kept(at.i);
    at.is_shown = true;
    stop(at, *s);
    return;
  }
  drop_load(at, 0.5);
  const Stuck &place = movers.members(*this).rows.stuck(at.i);
  if (s) {
    at.was_stopped = is_still && is_same(place.v, NONE);
    aspi_copy(s->x + 3 * static_cast<size_t>(at.i), at.x);
    aspi_copy(s->v + 3 * static_cast<size_t>(at.i), at.v);
    at.mass = s->mass[at.i];
  }
  hold_one(*this, place, movers, Mover(movers, at.i), NONE);
}

/* If a stuck particle has the same velocity and mass at the ends of two steps, its load is
 * unchanged: the books keep it, and only x and v are reset. At the beginning of the next step, the
 * forces are those of the end of the last one: its velocity tells. */
void Wall::carry_stuck(const Movers &movers) {
  const Spheres *s = movers.grains;
  bool still = true;
  for (const Member &member : setup.shapes)
    still = still && member.shape->is_still() && !member.shape->measures();
  is_still = still;
  for (StuckOne &at : movers.members(*this).stuck)
    if (still && at.is_shown && is_same(s->v + 3 * static_cast<size_t>(at.i), at.v))
      put_back(at, *s);
    else
      carry_other(movers, at);
  if (s)
    books.add_kept_loads();
}

void Wall::hold_stuck(const Movers &movers) {
  const Spheres *s = movers.grains;
  for (StuckOne &at : movers.members(*this).stuck)
    if (at.is_shown && comes_again(at, *s))
      stop(at, *s);
    else
      hold_other(movers, at);
  if (s)
    books.add_kept_loads();
}

/* ---- removal ---- */

/* Draws the adhesion of a deposit, and when it ends, by the next key of its draws. */
static asp_removal draw_removal(const Setup &setup, const Mover &mover, const Stuck &place,
                                double draws) {
  const BodySphere &one = mover.sphere[mover.anchor(place)];
  const size_t shape = static_cast<size_t>(place.shape) - 1;
  const asp_key key = {setup.model.seed(), setup.stay_key, static_cast<uint64_t>(one.tag),
                       static_cast<uint32_t>(draws + 1), 0};
  if (!(place.shape >= 1))
    return {0, 1, {}};
  return setup.model.removal(one.type, setup.shapes[shape].wall_type, 2 * one.radius, key);
}

/* The face at which a deposit rests: it may have gone to another triangle, on the same side. */
static int face_now(const Member &member, const Stuck &at) {
  const int face = static_cast<int>(at.face), piece = static_cast<int>(at.piece);
  return member.pieces == 0 ? face : face < 0 ? ~piece : piece;
}

/* A deposit that the flow takes away rests at the wall, and does not stick again before it has left
 * it. */
void Wall::let_go(const Movers &movers) {
  Population &of = movers.members(*this);
  if (of.stuck.empty() || !has_flow)
    return;
  size_t kept = 0;
  for (StuckOne &at : of.stuck) {
    Memory &memory = of.rows.own(at.i);
    Stuck &place = of.rows.stuck(at.i);
    if (!(at.flow.most > 0))
      at.flow = draw_removal(setup, Mover(movers, at.i), place, memory.draws);
    place.removal += at.flow.rate * movers.dt;
    if (place.removal <= at.flow.most) {
      of.stuck[kept++] = at;
      continue;
    }
    const Stuck was = place;
    memory.draws++;
    drop_load(at, 0);
    of.rows.set_status(at.i, Status::FREE);
    if (was.shape >= 1) {
      const Mover mover(movers, at.i);
      const size_t shape = static_cast<size_t>(was.shape) - 1;
      of.resting.push_back(at.i);
      mover.at(*this).rest_at(mover.sphere[mover.anchor(was)].tag, shape,
                              face_now(setup.shapes[shape], was));
    }
    of.ahead.watch(at.i);
  }
  of.stuck.resize(kept);
}
