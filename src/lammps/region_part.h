/* A region of LAMMPS that is no union or intersection, as a rigid body: its position and velocity
 * within a step, and the nearest points of its faces. LAMMPS has its displacement and its angle at
 * the end of each step, by variables; in between they are taken as linear in time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <vector>

#include "pointers.h"
#include "dem/shapes/motion.h"
#include "dem/shapes/shape.h"

namespace LAMMPS_NS {

/* The nearest point of a face. */
struct RegionFoot {
  double distance, n[3]; /* unit, from the face to the point */
  double hollow;         /* radius of a face that is hollow toward the point; 0 for others */
  bool inside;           /* seen from inside of the part */
  bool convex;           /* the face lies entirely behind its tangent plane */
  bool wrong_side;       /* the face does not act on this side */
  bool hidden;           /* within another part */
  int part, face;
};

class RegionPart {
public:
  /* number: of the part in its region, from 0. */
  RegionPart(class Region *region, int number);

  Region *region() const {
    return region_;
  }
  bool moves() const {
    return moves_;
  }
  const asperity::Motion &motion() const {
    return motion_;
  }

  /* At the beginning of a run, and at the end of each step: what LAMMPS has. settle: how far a face
   * within a box has moved since the last step, which is 0 where the run continues one. */
  double settle(const double box[2][3]);
  void advance(double dt);

  /* The distance that a face within a box moves in this step, at most; and the angular speed. */
  double travel(const double box[2][3]) const;
  double turn_speed() const;

  /* Turns the ends of a straight way in this step into those that the part sees; how far the way is
   * off a straight line then, at most. */
  double see(double from[3], double to[3]) const;

  /* The speed of a path relative to the part, at most; `most`: of any two points. */
  double fastest(const asperity::Path &path, double most) const;

  /* Puts the part to where it is at a share of the step; there it is when it is asked for what
   * follows. */
  void set_share(double share) const;

  /* True if a point is within the part, whatever its side. */
  bool has(const double x[3]) const;

  /* Appends the feet of a point that are nearer than `reach`: of each face, from inside, or one of
   * the whole part, from outside. */
  void add_feet(const double x[3], double reach, std::vector<RegionFoot> &feet) const;

  /* Motion::acceleration() at the end of the step, of what the next one is expected to do. */
  void end_acceleration(const double x[3], const double v[3], double a[3]) const;

  /* What a run that continues this one must know, N_RECORD numbers; none before the first step. */
  enum { N_RECORD = 8 };
  void append_record(std::vector<double> &record) const;
  void restore(const double *record);

private:
  /* A displacement, and an angle about the part's axis; or their rates. */
  struct Pose {
    enum { COUNT = 4 };
    double shift[3], angle;
    double &operator[](int k) {
      return k < 3 ? shift[k] : angle;
    }
    double operator[](int k) const {
      return k < 3 ? shift[k] : angle;
    }
  };
  Pose pose() const;
  asperity::Frame frame_of(const Pose &pose) const;
  asperity::Twist twist_of(const Pose &at, const Pose &rate) const;
  double way(const double box[2][3], const asperity::Frame &from, const asperity::Frame &to) const;

  Region *region_;
  int number_;
  bool moves_;
  double origin_[3], axis_[3]; /* of its turn: a point and a unit vector */
  bool is_round_;              /* about that axis: it looks the same however far it has turned */
  Pose pose_, rate_;           /* at the end of the step, and in its mean */
  asperity::Twist to_come_;    /* acceleration at its end beyond that in the step */
  bool has_rate_;
  double dt_;
  asperity::Motion motion_;
  mutable asperity::Frame frame_; /* where it is */
};

} // namespace LAMMPS_NS
