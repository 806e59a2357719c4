/* What moves and meets walls: a grain, or a rigid body of spheres. A grain is a body of one sphere
 * about its center of mass; such a one is a ball, for which closed forms hold.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "contact/vector.h"
#include "dem/step/bodies.h"
#include "dem/wall.h"

namespace asperity {

/* Contacts are at one wall if the cosine between their normals is larger; at a corner they are not.
 */
const double SAME_WALL = 0.7;

const double NONE[3] = {0, 0, 0};

/* What a mover remembers of one wall. */
class WallMemory {
public:
  WallMemory(Memories &rows, int i, size_t spheres) : rows_(rows), i_(i), spheres_(spheres) {}

  double &impacts() const {
    return rows_.state[i_].impacts;
  }
  Memory &own() const {
    return rows_.own(i_);
  }
  Status status() const {
    return rows_.status(i_);
  }
  void set_status(Status now) const {
    rows_.set_status(i_, now);
  }

  /* The faces at which it rests. */
  std::vector<Rest> &rests() const {
    Memory *of = status() == Status::RESTING ? rows_.find(i_) : NULL;
    return of ? of->rests : NO_RESTS;
  }
  bool rests_at(int64_t sphere, size_t shape, int face) const;
  /* Keeps the faces that press if there are more than it has room for. */
  void rest_at(int64_t sphere, size_t shape, int face) const;
  /* Drops the rests of which the shape is gone; true if there were some. */
  bool drop_gone() const;

  FacePlace *face_of(int64_t sphere, const double n[3]) const;
  /* The place of another face: a new one, or that which was met longest ago. */
  FacePlace &new_face() const;

private:
  static std::vector<Rest> NO_RESTS;

  Memories &rows_;
  const int i_;
  const size_t spheres_;
};

class Mover;

/* A mover at an instant: center of mass, velocity and spin, and the rates of these two by the
 * forces that act on it. */
struct Instant {
  double x[3], v[3], spin[3], a[3], alpha[3];
};

/* A mover where it meets a wall: center of mass, velocity, spin, its acceleration by all but the
 * walls at which it rests, and how much of the step is left. */
struct Moment {
  const double *x, *v, *spin, *free;
  double left, dt;
  int64_t step;
};

/* The grains, or the bodies, of this rank in a step. */
class Movers {
public:
  const Spheres *const grains; /* one of these two is NULL */
  Bodies *const bodies;
  const int64_t step;
  const double dt;

  Movers(const Spheres &of) : grains(&of), bodies(NULL), step(of.step), dt(of.dt) {}
  Movers(Bodies &of) : grains(NULL), bodies(&of), step(of.step), dt(of.dt) {}

  Population &members(Wall &wall) const {
    return bodies ? wall.bodies : wall.grains;
  }
  bool is_stuck(const std::vector<Wall *> &walls, int i) const {
    for (Wall *wall : walls) {
      const Population &of = members(*wall);
      if (!of.stuck.empty() && of.rows.is_stuck(i))
        return true;
    }
    return false;
  }
  /* Each as a sphere that has all of it. */
  Spheres bounds() const {
    return bodies ? bodies->bounds() : *grains;
  }

  void read(const Mover &mover, Instant &now) const; /* not the rates */
  void read_rates(const Mover &mover, Instant &now) const;
  /* Where it is, with its axes; and its velocity and spin. */
  void place(const Mover &mover, const double x[3]) const;
  void write(const Mover &mover, const double v[3], const double spin[3]) const;
  /* Adds accelerations to what acts on it. */
  void push(const Mover &mover, const double a[3], const double alpha[3]) const;

private:
  void read_body(const Mover &mover, Instant &now) const;
  void read_body_rates(const Mover &mover, Instant &now) const;
  void write_body(const Mover &mover, const double v[3], const double spin[3]) const;
  void push_body(const Mover &mover, const double a[3], const double alpha[3]) const;
};

class Mover {
public:
  Mover(const Movers &all, int i);
  Mover(const Mover &) = delete;

  const int i;      /* of the grain, or of the body */
  const Body *body; /* NULL: a grain */
  double mass;
  bool is_ball; /* one sphere about the center of mass */
  const BodySphere *sphere;
  size_t count;      /* of spheres */
  double axes[3][3]; /* now; unit vectors */
  double inverse[6]; /* mass times inverse inertia, now, of a body: xx, yy, zz, xy, xz, yz */

  Population &members(Wall &wall) const {
    return body ? wall.bodies : wall.grains;
  }
  WallMemory at(Wall &wall) const {
    return WallMemory(members(wall).rows, i, count);
  }

  /* The moment of inertia of a ball. */
  double ball_inertia() const {
    return 0.4 * mass * radius_ * radius_;
  }

  /* The number of the sphere with a tag, or how many there are; and the sphere that holds a stuck
   * mover. */
  size_t number_of(double tag) const;
  size_t anchor(const Stuck &at) const;

  /* True if the sphere is centered on the center of mass, within the engine's accuracy. */
  bool is_central(size_t k) const;

  /* From the center of mass to the center of a sphere. */
  void arm(size_t k, double out[3]) const;
  void set_axes(const double to[3][3]);
  void turn(const double omega[3], double time); /* its axes */

  /* Angular velocity from the angular momentum, and back, per mass. */
  void spin_of(const double momentum[3], double spin[3]) const;
  void momentum_of(const double spin[3], double momentum[3]) const;

  /* Energy per mass; and that of the motion along a wall. */
  double energy(const double v[3], const double spin[3]) const;
  double energy_along(const double n[3], const double v[3], const double spin[3]) const;

  /* What an impulse at a point does to the spin: all per mass. And the inverse of the mass that it
   * meets along n, times the mass: 1 at the center. */
  void twist(const double arm[3], const double impulse[3], double spin[3]) const;
  double response(const double arm[3], const double n[3]) const;

  /* The body as the core has it, by one of its spheres. */
  asp_body core_body(const double arm[3]) const;

  /* The load of a sphere's contact, with its center at `center` and that of the mover at x, by the
   * changes of the velocity and of the spin; NULL: the spin that the impulse at the point gives. */
  ContactLoad load(size_t k, int piece, const double center[3], const double n[3],
                   const double x[3], const double change[3], const double turned[3]) const;

private:
  void set_body(const Movers &all);
  double body_energy(const double v[3], const double spin[3]) const;
  void body_momentum(const double spin[3], double momentum[3]) const;

  BodySphere own_; /* of a grain */
  double radius_;
};

inline Mover::Mover(const Movers &all, int which)
    : i(which), body(NULL), is_ball(true), sphere(&own_), count(1) {
  if (const Spheres *s = all.grains) {
    mass = s->mass[i];
    own_ = BodySphere{{0, 0, 0}, s->radius[i], s->type[i], s->mask[i], s->tag_of(i)};
  } else
    set_body(all);
  radius_ = sphere->radius;
}

inline void Mover::momentum_of(const double spin[3], double momentum[3]) const {
  if (!is_ball) {
    body_momentum(spin, momentum);
    return;
  }
  aspi_copy(spin, momentum);
  aspi_scale(0.4 * radius_ * radius_, momentum);
}

inline double Mover::energy(const double v[3], const double spin[3]) const {
  return is_ball ? 0.5 * aspi_dot(v, v) + 0.2 * radius_ * radius_ * aspi_dot(spin, spin)
                 : body_energy(v, spin);
}

inline double Mover::energy_along(const double n[3], const double v[3],
                                  const double spin[3]) const {
  double u[3], turning[3];
  aspi_add_scaled(v, -aspi_dot(v, n), n, u);
  aspi_add_scaled(spin, -aspi_dot(spin, n), n, turning);
  return energy(u, turning);
}

/* The faces that were hit are tilted, and a law may leave the spin alone: the wall gets what the
 * mover has lost. */
inline ContactLoad Mover::load(size_t k, int piece, const double center[3], const double n[3],
                               const double x[3], const double change[3],
                               const double turned[3]) const {
  ContactLoad made;
  made.particle = body ? -1 : i;
  made.piece = piece;
  made.mask = sphere[k].mask;
  aspi_copy(n, made.n);
  aspi_add_scaled(center, -sphere[k].radius, n, made.point);
  aspi_copy(change, made.impulse);
  aspi_scale(-mass, made.impulse);
  aspi_copy(NONE, made.couple);
  made.dissipated = made.eroded = 0;
  if (!turned)
    return made;
  double lever[3], momentum[3];
  aspi_subtract(x, made.point, lever);
  aspi_cross(lever, made.impulse, made.couple);
  momentum_of(turned, momentum);
  aspi_add_scaled(made.couple, -mass, momentum, made.couple);
  return made;
}

inline void Movers::read(const Mover &mover, Instant &now) const {
  if (mover.body) {
    read_body(mover, now);
    return;
  }
  const size_t at = 3 * static_cast<size_t>(mover.i);
  aspi_copy(grains->x + at, now.x);
  aspi_copy(grains->v + at, now.v);
  aspi_copy(grains->omega ? grains->omega + at : NONE, now.spin);
}

inline void Movers::read_rates(const Mover &mover, Instant &now) const {
  if (mover.body) {
    read_body_rates(mover, now);
    return;
  }
  const size_t at = 3 * static_cast<size_t>(mover.i);
  aspi_copy(grains->f + at, now.a);
  aspi_scale(1 / mover.mass, now.a);
  aspi_copy(grains->torque ? grains->torque + at : NONE, now.alpha);
  aspi_scale(1 / mover.ball_inertia(), now.alpha);
}

inline void Movers::write(const Mover &mover, const double v[3], const double spin[3]) const {
  if (mover.body) {
    write_body(mover, v, spin);
    return;
  }
  const size_t at = 3 * static_cast<size_t>(mover.i);
  aspi_copy(v, grains->v + at);
  if (grains->omega)
    aspi_copy(spin, grains->omega + at);
}

inline void Movers::push(const Mover &mover, const double a[3], const double alpha[3]) const {
  if (mover.body) {
    push_body(mover, a, alpha);
    return;
  }
  const size_t at = 3 * static_cast<size_t>(mover.i);
  aspi_add_scaled(grains->f + at, mover.mass, a, grains->f + at);
  if (grains->torque)
    aspi_add_scaled(grains->torque + at, mover.ball_inertia(), alpha, grains->torque + at);
}

/* The product of a symmetric matrix xx, yy, zz, xy, xz, yz. */
void multiply(const double m[6], const double a[3], double out[3]);

} // namespace asperity
