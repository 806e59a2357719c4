/* A region of LAMMPS that is no union or intersection, as a rigid body: its position and velocity
 * within a step, and the nearest points of its faces. LAMMPS has its displacement and its angle at
 * the end of each step, by variables; in between they are taken as linear in time.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_REGION_PART_H
#define LMP_REGION_PART_H

#include <vector>

#include "pointers.h"
#include "dem/shapes/motion.h"
#include "dem/shapes/shape.h"

namespace LAMMPS_NS {

/* A displacement, and an angle about the part's axis; or their rates. */
struct RegionPose {
  double shift[3], angle;
};

/* The nearest point of a face. */
struct RegionFoot {
  double distance, n[3]; /* unit, from the face to the point */
  double hollow;         /* radius of a face that is hollow toward the point; 0 for others */
  bool inside;           /* seen from inside of the part */
  bool behind;           /* all of the face is behind the plane across the foot */
  bool across;           /* seen from the side from which it is not touched */
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

  /* At the beginning of a run, and at the end of each step: what LAMMPS has. */
  void settle();
  void advance(double dt);

  /* The motion in this step; the distance by which a point within a box moves apart from `from` in
   * it, at most; and the mean angular speed. */
  double travel(const double lo[3], const double hi[3]) const;
  double turn_speed() const;

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

  /* From the place in the region as it was defined to that at a share of the step, and back. */
  void to_world(double share, double x[3]) const;
  void to_local(double share, double x[3]) const;

  /* A vector that turns with the region; axes turned from a share of the step to its end, and the
   * angular velocity there. */
  void turn_vector(double share, double vector[3]) const;
  void turn(double share, double axes[3][3], double omega[3]) const;

  /* The velocity of a point of the region; and the acceleration that keeps a point which moves
   * through x with the velocity v at its face (see asperity::Motion). */
  void velocity(double share, const double x[3], double v[3]) const;
  void acceleration(double share, const double x[3], const double v[3], double a[3]) const;

  /* The mean velocities of the last step, for a run that continues one. */
  const RegionPose *rate() const {
    return has_rate_ ? &rate_ : NULL;
  }
  void set_rate(const RegionPose &rate);

private:
  RegionPose pose(double share) const;
  RegionPose rate_at(double share) const;
  asperity::Frame frame_at(double share) const;
  void velocity_by(const RegionPose &rate, double share, const double x[3], double v[3]) const;

  Region *region_;
  int number_;
  bool moves_;
  double origin_[3], axis_[3]; /* of its turn: a point and a unit vector */
  RegionPose before_, now_, rate_, last_rate_;
  double dt_;
  bool has_rate_, has_last_;
  asperity::Frame begin_, end_;
  mutable asperity::Frame frame_; /* where it is */
};

} // namespace LAMMPS_NS

#endif
