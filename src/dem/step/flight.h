/* One mover on its way through a step. Its path is straight; along it the velocity changes by what
 * acts on it, so that a contact finds the velocity of its own instant. A body turns on its way: its
 * spheres take straight stretches. A drawing is in the README of dem.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <vector>

#include "dem/step/mover.h"
#include "dem/step/held.h"

namespace asperity {

/* The angle by which a wall's curve may turn a mover that rests at it in a step, rad. */
const double CURVE = 0.1;

/* The angle by which a body turns in a stretch of its path at most, rad. */
const double TURN = 0.1;

struct Flight {
  Mover &mover;
  const double dt;
  const int64_t step;
  Path path;                        /* of the center of mass */
  double begin[3], acceleration[3]; /* the velocity at a time of the path is begin + time a */
  double half[3];                   /* what the engine's second half of the step begins with */
  double spin[3];
  double x0[3], v0[3], a0[3]; /* at the beginning of the step */
  double free[3];             /* a0 without the walls at which it rests */
  bool is_held;               /* by these, until an impact throws it off them */
  bool is_pushed;             /* by walls: its acceleration is not that of `free` */

  /* Of a body. turning, stretch: angular velocity of this stretch of its path, and how long that
   * takes. momentum: angular, per mass. lift: extra angular velocity of the path only, by walls
   * that it follows. */
  double turning[3], stretch, momentum[3], lift[3];
  bool is_undisturbed; /* no wall has changed its way */

  std::vector<Impact> impacts; /* of the step */

  /* Contacts being solved together, those of the path, and velocity and angular momentum before
   * them. */
  std::vector<Held> sustained, along;
  double free_half[3], free_momentum[3];
  double led[3];     /* around a curve by now, beyond the velocity of the middle of the step */
  double settled[3]; /* impulses per mass of those that are over */
  bool squeezed;     /* no velocity satisfies all of them */

  bool searches_all; /* false as long as it meets known faces only, on its known way */
  bool is_apart;     /* from the last contact */
  double way;        /* since the last contact, in radii */

  /* Contacts in a row: the first impact among them, and the spin before. */
  size_t series_begin;
  double series_spin[3];

  /* A mover as the engine has moved it, at the walls of the run. */
  Flight(Mover &mover, const Movers &movers, const Instant &now, const std::vector<Wall *> &walls);

  double elapsed() const {
    return dt - path.left;
  }
  /* Where it is, with this velocity. */
  Moment moment(const double v[3]) const {
    return Moment{path.x, v, spin, free, path.left, dt, step};
  }
  void velocity(double time, double v[3]) const;
  void advance(const Touch &touch, double v[3]);
  void turn(const double before[3], const double after[3], const double n[3]);
  void set_spin(const double to[3]);
  bool has_strayed(const double v[3], double most) const;

  /* How a body turns in the next stretch, by an angle at most; and moves it on. leap: as far as it
   * turns, where no wall is in reach. */
  void aim(double angle);
  void go_on(double time);
  void leap(double time);
  /* Of the spheres of a body from its center of mass, at most. */
  double farthest() const;
  Path path_of(size_t sphere) const;

  Held *find_sustained(const Touch &touch);
  void slide(const Touch &touch, double rises);
  void sustain(const Touch &touch, double hold);
  void settle();
  void wait(const Touch &at);
  void trap();

private:
  void lead_path();
  void ride(const Touch &at, double x[3], double v[3]) const;
  void turn_back();
  void act_along(const double n[3], double ahead[3]) const;
  void turn_alone(double time, double to[3][3]) const;
  void lead(double a[3]) const;
  Held &add_sustained(const Touch &touch, double hold);
  void follow_walls();
  double along_path(const Touch &touch, const double n[3]) const;
  void list_rests(std::vector<Held> &rests) const;
  void share(const double change[3], const double turned[3]);

  const std::vector<Wall *> &walls_;
};

/* Counts the load of a solved contact of a mover at x. */
inline void add_load(const Mover &mover, const double x[3], const Held &held) {
  ContactLoad load = mover.load(held.sphere, held.piece, held.x, held.n, x, held.p,
                                held.hold > 0 ? held.turn : NULL);
  load.dissipated = mover.mass * held.work;
  held.wall->books.add_load(held.shape, load);
}

/* The contact at which a sphere of a mover at x rests, with this velocity and spin; false: it is
 * there no more. off: how far the sphere is in the wall. */
bool find_rest(const Mover &mover, Wall &wall, Rest &rest, const double x[3], const double v[3],
               const double spin[3], double dt, Held &at, double &off);

/* search.cpp: the first contacts of the rest of the path. Where a body turns so far that its
 * spheres may be off straight paths, they are searched by wider spheres, and where those meet a
 * wall in shorter stretches. False: there are none, and the flight is in the last stretch of its
 * path. */
bool find_next(const std::vector<Wall *> &walls, Flight &flight, std::vector<Touch> &touches);

/* meet.cpp: the contacts of one instant, the nth in a row: an impact, several at smooth walls, or
 * all of them are sustained; all_stay: as between walls that close. The number of the one by which
 * the mover has stuck, else -1. slid: set if every contact only slid. */
int meet(Flight &flight, std::vector<Touch> &touches, int nth, bool all_stay, bool &slid);

/* A contact, and the face of the rough wall there. */
struct ContactPoint {
  const Mover &mover;
  const Moment &now;
  Touch &touch;
  Wall &wall;
  const BodySphere &one;
  const WallMemory memory;
  double arm[3];         /* to the touching sphere */
  double v1[3], spin[3]; /* of the mover, relative to the wall: after what it has lost so far */
  double press;          /* acceleration that presses the sphere to the wall; may be negative */
  FacePlace *face;       /* NULL: the wall is smooth */
  bool is_new, moved;    /* a face not met yet; the sphere has come to it along the wall */

  ContactPoint(const Mover &mover, const Moment &now, Touch &touch);
  const asp_wall *law() const;
  /* Of the touching sphere's center. */
  void sphere_velocity(double u[3]) const;
  double approach() const;
  /* The sphere as it is here. lay: room for the wall's lay, if it has one. */
  asp_particle particle(double lay[3]);

  /* An impact here without its result, the `nth` from now on. finish: with the result, its load is
   * known, and it is the mover's next one. */
  Impact impact(double nth = 1) const;
  void finish(Impact &impact) const;

  /* faces.cpp: finds the sphere's face here, or gives it a new one. */
  void find_face(bool stays);
  bool is_low();
  void lose_bounce() const;
  double hold(bool is_sustained);
  void stop_along();
  bool graze(Impact &impact);

private:
  const FacePlace &valley();
  asp_key next_key() const;
  void brake(const double to[3], const double to_spin[3]);
  asp_body core_;
};

/* stick.cpp: a mover sticks at x, with this velocity and spin, and goes with the wall for what is
 * left of the step. */
void freeze(const Touch &touch, const Mover &mover, const Movers &movers, const double x[3],
            const double v[3], const double spin[3], double left);
/* It rests at no other wall any more. */
void leave_rests(const std::vector<Wall *> &walls, const Mover &mover);

/* energy.cpp: notes the energy of the rebounds of a ball on its way; and, at the end of the step,
 * gives it the normal velocity that it has by that, where forces act. */
void note_energy(const Flight &flight);
void balance(Wall &wall, const Movers &movers, int i);

} // namespace asperity
