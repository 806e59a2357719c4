/* Rigid bodies of spheres in a step: what engines give, and what a body remembers. How a body
 * moves and meets walls is what a grain does (mover.h, flight.h); its spheres take straight
 * stretches of path between which it turns by a tenth of a radian at most.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <mpi.h>
#include <unordered_map>
#include <utility>
#include <vector>

#include "dem/wall.h"

namespace asperity {

struct BodySphere {
  double arm[3]; /* from the center of mass, along the body's axes */
  double radius;
  int type, mask;
  int64_t tag;
};

/* A body at the end of a step without walls; the velocities are those of the middle of the step. */
struct Body {
  int64_t tag; /* from 0 */
  double mass, inertia[3];
  double axes[3][3]; /* unit vectors of the principal axes */
  double x[3], v[3], angular_momentum[3], acceleration[3], torque[3];
  size_t first, count; /* its spheres */
  bool is_guided;      /* its engine moves it along a given way: it meets no wall */
  bool is_changed;     /* by contacts */
  double reach;        /* radius of the sphere about its center of mass that has all of it */
  int mask;            /* of all groups of its spheres */
};

/* The bodies of this rank. */
class Bodies {
public:
  int64_t step; /* this one; before the first of a run, that */
  double dt;
  bool begins; /* the run, with this step */
  std::vector<Body> all;
  std::vector<BodySphere> spheres;

  Bodies() : step(0), dt(0), begins(true) {}

  /* Each as the sphere about its center of mass that has all of it; valid until the next call. */
  Spheres bounds();

private:
  std::vector<double> x_, v_, reach_;
  std::vector<int> mask_;
  std::vector<int64_t> tag_;
};

/* Turns axes by an angular velocity. */
void turn_by(const double omega[3], double time, double axes[3][3]);

/* Turns the axes of a free body: exactly where two moments are equal, else by turns one after
 * another (as Dullweber, Leimkuhler & McLachlan 1997), by which the energy does not drift. The
 * angular momentum stays. */
void turn_free(const double inertia[3], const double momentum[3], double time, double axes[3][3]);

/* Moves a free body straight, and turns it. */
void advance(Body &body, double time);

/* Angular velocity from angular momentum, and back. */
void spin_of(const Body &body, double omega[3]);
void momentum_of(const Body &body, const double omega[3], double momentum[3]);

/* What the spheres of bodies show of a wall, which are on any rank: the impacts and the state of
 * their body. */
class BodyRows {
public:
  /* After particles or bodies have moved between ranks. */
  void reset(const Spheres &spheres, size_t walls);
  /* Collective. */
  void show(const std::vector<Wall *> &walls, const Bodies &bodies, MPI_Comm world);

private:
  std::unordered_map<int64_t, int> place_; /* of the particles of this rank, by tag */
  std::vector<std::vector<MoverState>> shown_;
};

/* An engine's bodies. Of the walls of a run, the first one's are used for all; where there are
 * none, only any() is called. */
class BodySource {
public:
  virtual ~BodySource() {}
  virtual bool any() const = 0;
  /* True for a particle of a body: it meets no wall alone. */
  virtual bool has(int i) const = 0;
  /* At the beginning of a run, and after particles have moved between ranks. Collective. */
  virtual void list(const std::vector<Wall *> &walls, bool begins) = 0;
  /* Those of this rank after the first half of a step, or at its end. Collective. Throws an Error.
   */
  virtual Bodies *take(const std::vector<Wall *> &walls) = 0;
  /* Gives back those that have changed, with their particles; at the end of a step only velocities
   * and forces change. Collective. */
  void put(bool is_end, MPI_Comm world);
  /* Lists the bodies of all ranks that a wall deletes; collective. True for a particle of one. */
  void list_deleted(const Memories &rows, MPI_Comm world);
  bool is_deleted(int i) const;

protected:
  /* A sphere, and the number of its body on this rank. */
  typedef std::pair<size_t, BodySphere> Found;
  /* Lists each sphere once, in the order of their tags, for the same sums on any number of ranks.
   */
  void set_spheres(std::vector<Found> &found);

  Bodies bodies_;

private:
  /* The engine's name of a body of this rank, and of that of a particle: it has none below 1. */
  virtual double name_of(size_t b) const = 0;
  virtual double name_at(int i) const = 0;
  virtual void write(size_t b, bool is_end) = 0;
  virtual void set_particles(bool is_end) = 0;

  std::vector<double> deleted_; /* names of bodies */
};

/* After bodies have moved between ranks, or have got other numbers, and at the beginning of a run:
 * their memories of the walls come along. Collective. */
void claim_bodies(const std::vector<Wall *> &walls, Bodies &bodies, MPI_Comm world);

} // namespace asperity
