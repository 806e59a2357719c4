/* Bodies that walls have moved; see bodies_lammps.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "bodies_lammps.h"

#include <cmath>
#include <cstring>

#include "atom.h"
#include "domain.h"
#include "lammps.h"
#include "update.h"

#include "body_turn.h"
#include "contact/vector.h"
#include "dem/step/body_motion.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace LAMMPS_NS;
using asperity::Body;
using asperity::text;

/* The largest error, relative, of the velocity that its fix gives a body. */
static const double KEPT = 1e-9;

/* From a body's center to a particle of it, where that is now. */
void BodiesOfLammps::arm_of(int i, const double center[3], double arm[3]) const {
  aspi_subtract(lammps_->atom->x[i], center, arm);
  lammps_->domain->minimum_image(arm[0], arm[1], arm[2]);
}

class BodiesOfLammps::Kick {
public:
  explicit Kick(BodiesOfLammps &bodies)
      : bodies_(bodies), atom_(bodies.lammps_->atom),
        count_(3 * static_cast<size_t>(atom_->nlocal)) {
    if (count_ > 0) {
      force_.assign(atom_->f[0], atom_->f[0] + count_);
      torque_.assign(atom_->torque[0], atom_->torque[0] + count_);
    }
    clear();
  }
  ~Kick() {
    if (count_ > 0) {
      std::copy(force_.begin(), force_.end(), atom_->f[0]);
      std::copy(torque_.begin(), torque_.end(), atom_->torque[0]);
    }
  }

  void clear() {
    if (count_ > 0) {
      std::fill_n(atom_->f[0], count_, 0.);
      std::fill_n(atom_->torque[0], count_, 0.);
    }
  }

  /* A rate of velocity and of angular momentum for a body whose center is there now. */
  void set(size_t b, const double center[3], const double a[3], const double torque[3]) {
    const int i = bodies_.firsts_[b].i;
    double arm[3], couple[3];
    bodies_.arm_of(i, center, arm);
    aspi_subtract(a, bodies_.own_of(bodies_.firsts_[b]), atom_->f[i]);
    aspi_scale(bodies_.before_[b].mass, atom_->f[i]);
    aspi_cross(arm, atom_->f[i], couple);
    aspi_subtract(torque, couple, atom_->torque[i]);
  }

  /* Half a step of velocity; with `move`, the other half and a step of position. */
  void integrate(bool move) {
    for (Fix *fix : bodies_.fixes_)
      fix->final_integrate();
    for (Fix *fix : bodies_.fixes_)
      if (move)
        fix->initial_integrate(0);
    clear();
  }

private:
  BodiesOfLammps &bodies_;
  Atom *atom_;
  size_t count_;
  std::vector<double> force_, torque_;
};

/* The angle by which a body is turned in one integration, at most. */
static const double TURN = 1;

/* How many integrations turn each body to where it must be. */
int BodiesOfLammps::count_turns() const {
  double most = 1;
  for (size_t b = 0; b < bodies_.all.size(); b++) {
    double turn[3];
    if (!bodies_.all[b].is_changed)
      continue;
    asperity::rotation(before_[b].axes, bodies_.all[b].axes, turn);
    most = std::max(most, ceil(aspi_length(turn) / TURN));
  }
  return static_cast<int>(most);
}

/* One of `count` integrations of the bodies, which are as `now` says: the first one takes all of
 * them to their places, each turns them by its share. A body that has met no wall stops meanwhile.
 */
void BodiesOfLammps::integrate(Kick &kick, std::vector<Body> &now, int number, int count) {
  const double dt = lammps_->update->dt;
  for (size_t b = 0; b < now.size(); b++) {
    const Body &to = bodies_.all[b];
    Body next = now[b];
    double turn[3], a[3], torque[3];
    asperity::rotation(now[b].axes, to.axes, turn);
    asperity::turn_by(turn, 1. / (count - number), next.axes);
    aspi_copy(to.x, next.x);
    aspi_subtract(to.x, now[b].x, next.v);
    aspi_scale(1 / dt, next.v);
    if (!momentum_to(now[b], dt, next.axes, next.angular_momentum))
      aspi_copy(to.angular_momentum, next.angular_momentum);
    aspi_subtract(next.v, now[b].v, a);
    aspi_scale(1 / dt, a);
    aspi_subtract(next.angular_momentum, now[b].angular_momentum, torque);
    aspi_scale(1 / dt, torque);
    kick.set(b, now[b].x, a, torque);
    now[b] = next;
  }
  kick.integrate(true);
}

/* Gives bodies that are as `now` says their velocities, by half a step. */
void BodiesOfLammps::accelerate(Kick &kick, const std::vector<Body> &now) {
  const double rate = 2 / lammps_->update->dt;
  for (size_t b = 0; b < now.size(); b++) {
    double a[3], torque[3];
    aspi_subtract(bodies_.all[b].v, now[b].v, a);
    aspi_scale(rate, a);
    aspi_subtract(bodies_.all[b].angular_momentum, now[b].angular_momentum, torque);
    aspi_scale(rate, torque);
    kick.set(b, now[b].x, a, torque);
  }
  kick.integrate(false);
}

void BodiesOfLammps::put() {
  if (!any())
    return;
  int mine[3] = {0, bodies_.any_stuck(), count_turns()}, all[3];
  for (size_t b = 0; b < bodies_.all.size(); b++) {
    const Body &body = bodies_.all[b];
    mine[0] = mine[0] || body.is_changed;
    Memory &memory = memories_[firsts_[b].tag];
    memory.has_axes = 1;
    memcpy(memory.axes, body.axes, sizeof memory.axes);
  }
  MPI_Allreduce(mine, all, 3, MPI_INT, MPI_MAX, lammps_->world);
  is_any_stuck_ = all[1];
  if (!all[0])
    return;
  Kick kick(*this);
  std::vector<Body> now(before_);
  for (int k = 0; k < all[2]; k++)
    integrate(kick, now, k, all[2]);
  accelerate(kick, now);
  std::string wrong;
  for (size_t b = 0; b < now.size() && wrong.empty(); b++)
    wrong = velocity_error(b, now[b]);
  fail_together(wrong);
}

void BodiesOfLammps::put_velocities() {
  Kick kick(*this);
  accelerate(kick, before_);
}

/* A fix with forces of its own adds them each time that it integrates. */
std::string BodiesOfLammps::velocity_error(size_t b, const Body &way) const {
  const Particle &first = firsts_[b];
  const Body &from = before_[b], &to = bodies_.all[b];
  const Atom *atom = lammps_->atom;
  double arm[3], turned[3], off[3];
  arm_of(first.i, to.x, arm);
  aspi_cross(atom->omega[first.i], arm, turned);
  aspi_subtract(atom->v[first.i], turned, off);
  aspi_subtract(off, to.v, off);
  const double speeds = aspi_length(from.v) + aspi_length(way.v) + aspi_length(to.v) +
                        aspi_length(atom->omega[first.i]) * aspi_length(arm);
  /* Bodies at rest have no speed to compare with. */
  const double least = KEPT * atom->radius[first.i] / lammps_->update->dt;
  if (aspi_length(off) > KEPT * (speeds + least))
    return name_of(fix_of(first)) +
           text(" gives the body of particle %lld a velocity that is %g off from what the wall "
                "asked of it; leave out its keywords langevin, force and torque, and keep the "
                "gravity of its keyword gravity as it is",
                (long long)first.tag, aspi_length(off));
  return "";
}
