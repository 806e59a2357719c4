/* A part of a wall for the contact search: a plane, a cylinder, a mesh. An engine may add shapes of
 * its own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <math.h>
#include <stddef.h>
#include <algorithm>
#include <vector>

#include "asperity_engine.h"
#include "contact/tolerances.h"
#include "contact/vector.h"
#include "dem/shapes/motion.h"

namespace asperity {

/* A straight piece of a particle's way in a step dt: from x, with v, for the time `left`; then a
 * `rest` of the step is to come. */
struct Path {
  double x[3], v[3], left, dt, rest;
  double share() const { /* of the step that is over */
    return 1 - (left + rest) / dt;
  }
};

/* The first contact of a path with a shape. */
struct Contact {
  double time;           /* since the beginning of the path */
  double x[3];           /* of the center then, moved out of the wall where it overlapped */
  double n[3];           /* outward unit normal, from the wall to the center */
  double n_end[3];       /* what it has become at the end of the path, as the wall turns */
  double v_wall[3];      /* of the point that is touched */
  double follow;         /* acceleration along n that keeps the center at the moving wall */
  double curve;          /* the same in a hollow of the wall, as the center moves along it */
  double chord;          /* mean speed along n, by that, on a chord to the end of the path */
  double approach_speed; /* mean speed along -n over the rest of the path as it was searched */
  int piece;             /* number of the triangle; 0 for a shape of one piece */
  int face;        /* the piece, or where a shape of one piece has several faces, which of them */
  bool overlapped; /* the particle was in the wall already */
};

/* The mean speed across a circle's tangent on a chord of it, from the acceleration v^2/rho of a
 * motion along it, where the way along the tangent is that of a speed v in a time. */
inline double chord_speed(double curve, double v, double time) {
  const double rho = v * v / curve, way = std::min(v * time, rho);
  return time > 0 && rho > 0 && curve > 0 ? way * way / (rho + sqrt(rho * rho - way * way)) / time
                                          : 0;
}

/* Position of a stuck particle, as numbers for restart files from which the shape can find it
 * again. `at` is the center in the frame of the shape. */
struct Place {
  int piece;
  double at[3];
};

/* The way of a sphere of radius `reach`, growing by `widen` a step, whose center moves from x by v
 * a step, for `most` steps. It makes no difference which of the first `least` ones is its last. */
struct Course {
  double x[3], v[3], reach, widen, least, most;
};

/* Faces of a shape. */
struct FaceList {
  int count, face[3];
  bool has(int other) const {
    for (int k = 0; k < count; k++)
      if (face[k] == other)
        return true;
    return false;
  }
};

/* What stands between a center and a face, in the frame of the part that has the face: a plane, n.x
 * = at, with the face behind it; or a ball within which the face does not come. */
struct Barrier {
  double n[3], at; /* of a ball the center, and its radius */
  bool is_ball;
  int shape, part;

  double distance(const double x[3]) const {
    if (!is_ball)
      return aspi_dot(n, x) - at;
    double arm[3];
    aspi_subtract(x, n, arm);
    return at - aspi_length(arm);
  }
};

/* Those of one shape. */
struct Barriers {
  const Barrier *first, *last;
  const Barrier *begin() const {
    return first;
  }
  const Barrier *end() const {
    return last;
  }
};

struct BarrierList {
  enum { MOST = 4 };
  int count;
  Barrier all[MOST];

  /* A new one; NULL if there is no room. */
  Barrier *add() {
    if (count == MOST)
      return NULL;
    all[count] = Barrier();
    return &all[count++];
  }
  /* Those behind each other that are of one shape, from this one on. */
  Barriers of(int first) const {
    int last = first;
    while (last < count && all[last].shape == all[first].shape)
      last++;
    return Barriers{all + first, all + last};
  }
};

/* Impulse of one contact on one piece of a wall. */
struct ContactLoad {
  int particle; /* -1: a body */
  int piece;
  int mask;          /* of its groups */
  double n[3];       /* outward unit normal; 0 for what is stuck, which is held in any direction */
  double point[3];   /* where it acts */
  double impulse[3]; /* on the wall */
  double couple[3];  /* angular momentum to the wall beyond that of the impulse at the point */
  double dissipated; /* energy */
  double eroded;     /* mass of the wall */
};

class Shape {
public:
  virtual ~Shape() {}

  /* Distance that a point of the shape moves in this step of length dt, at most. One that slides
   * along itself stands still. */
  virtual double travel(double) const {
    return 0;
  }

  /* Lower bound of the number of steps in which a sphere on this course cannot meet the shape where
   * that is at the end of this step. The faces at which it stays do not count. */
  virtual double clear(const Course &course, const FaceList &stays) const = 0;

  /* Adds barriers between a center and all faces that are nearer than `reach` at the end of this
   * step, but for those at which it stays. False if there are too many, or the shape has none. */
  virtual bool separate(const double[3], double, const FaceList &, BarrierList &) const {
    return false;
  }

  /* How far a sphere that moves straight in this step, as find() searches it, keeps from what is
   * behind all of these barriers, at least; it meets nothing where that is not negative. */
  virtual double gap(const Barriers &all, const double from[3], const double to[3],
                     double radius) const {
    return least_gap(all, from, to) - apart(radius);
  }

  /* True if the shape looks the same to a particle before and after it crosses the periodic edge of
   * the box along an axis. */
  virtual bool repeats(int) const {
    return false;
  }

  /* True if the shape cannot stand where the box is periodic along an axis: a particle that leaves
   * on one side of the shape would come back on its other side. */
  virtual bool bars(int) const {
    return false;
  }

  /* The first contact of the path at or before `latest`. */
  virtual bool find(const Path &path, double radius, double latest, Contact &contact) const = 0;

  /* The contact of a center that stays at a face and moves with v, at the end of the step: fills
   * what is not 0 of n, v_wall, follow and curve; the face, or where the center has left it, the
   * next one in its plane; and the distance. False if that is larger than `reach`. */
  virtual bool under(int face, const double x[3], const double v[3], double reach, Contact &at,
                     double &distance) const = 0;

  /* True if stuck particles do not move in this step. */
  virtual bool is_still() const {
    return false;
  }

  /* Stores the position of a particle that sticks at this contact of the path; and, after it has
   * been carried for the time dt, gives its place and velocity at the end of the step. */
  virtual void stick(const Path &, const Contact &contact, Place &place) const {
    place.piece = contact.piece;
    aspi_copy(contact.x, place.at);
  }
  virtual void carry(Place &place, double radius, double dt, double x[3], double v[3]) const = 0;

  /* Turns the axes of what sticks at a place as the shape turns from a share of the step of length
   * dt to its end, and gives the angular velocity then. */
  virtual void turn(const Place &, double, double, double[3][3], double omega[3]) const {
    std::fill(omega, omega + 3, 0.0);
  }

  /* The direction of a lay at a contact of the path; it turns with the shape. `lay_kind` is what
   * the shape can have. */
  virtual asp_lay_kind lay_kind() const {
    return ASP_LAY_VECTOR;
  }
  /* True if the shape, as far as this rank has it, is flat and a direction is its normal. */
  virtual bool is_across(const double[3]) const {
    return false;
  }
  virtual void lay(const asp_lay &lay, const Path &, const Contact &, double direction[3]) const {
    for (int d = 0; d < 3; d++)
      direction[d] = lay.vector[d];
  }

  /* take() is called for each contact where `measures`. */
  virtual bool measures() const {
    return false;
  }
  virtual void take(const ContactLoad &) {}

  /* State that a continued run needs of a shape that has moved; empty if it has not. */
  virtual std::vector<double> motion_record() const {
    return std::vector<double>();
  }
  virtual void restore_motion(const std::vector<double> &) {}

  virtual size_t bytes() const {
    return sizeof *this;
  }

protected:
  /* So far from a face a search finds no contact. */
  static double apart(double radius) {
    return (1 + 2 * AT_ONCE) * radius;
  }

  static double least_gap(const Barriers &all, const double from[3], const double to[3]) {
    double least = HUGE_VAL;
    for (const Barrier &one : all)
      least = std::min(least, std::min(one.distance(from), one.distance(to)));
    return least;
  }
  static bool are_parallel(const double a[3], const double b[3]) {
    double across[3];
    aspi_cross(a, b, across);
    return aspi_length(across) <= GRAZING * aspi_length(a) * aspi_length(b);
  }
};

} // namespace asperity
