/* The motion of a rigid body within a step: the screw from its frame at the beginning to its frame
 * at the end. Positions are interpolated along the screw. Velocities change linearly by the
 * difference of those at the two ends, and their mean is the screw's. This is exact for a steady
 * turn and of second order in the step otherwise, even where an engine integrates positions from
 * velocities to first order only.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

namespace asperity {

/* world = turn * local + shift */
struct Frame {
  double turn[3][3], shift[3];
  Frame(); /* world and local frame are the same */
  void to_world(const double local[3], double world[3]) const;
  void to_local(const double world[3], double local[3]) const;
  void to_world_direction(const double local[3], double world[3]) const; /* without the shift */
  bool is_world() const;                                                 /* to the bit */
};

/* The velocity of a point x of the shape is angular x x + linear. */
struct Twist {
  double angular[3], linear[3];
  Twist();
  void velocity(const double x[3], double v[3]) const;
};

/* The turn by an angle about an axis (a unit vector) through a point, and that at a rate. */
Frame turn_about(const double point[3], const double axis[3], double angle);
Twist twist_about(const double point[3], const double axis[3], double rate);

/* Throws an Error if a wall turns by more than a quarter of a turn in a step: then its way there is
 * not known. */
void check_turn(const char *kind, const char *name, double angle);

class Motion {
public:
  Motion();

  /* Puts the shape to rest where it is. */
  void rest();

  /* Puts it to `frame`, as at the beginning of a run, before a step that moves it if `goes_on`. */
  void settle(const Frame &frame, bool goes_on);

  /* The next step, of length dt: from where the shape is to `end`, where it has the velocity
   * `twist`.
   */
  void advance(const Frame &end, const Twist &twist, double dt);

  /* The velocity at the end of the step before, for a run that continues one. */
  void set_last(const Twist &twist);
  const Twist &last() const {
    return end_velocity_;
  }

  bool moves() const {
    return moves_;
  }

  /* True if the local frame equals the world's, to the bit, throughout the step. */
  bool in_world() const {
    return in_world_;
  }
  const Frame &end() const {
    return end_;
  }

  const Frame &start() const {
    return moves_ ? start_ : end_;
  }

  /* Of the whole step, times its duration. */
  const Twist &screw() const {
    return screw_;
  }

  /* At the share s (0 to 1) of the step. */
  Frame frame_at(double s) const;
  void velocity(double s, const double x[3], double v[3]) const;

  /* The acceleration of a point that moves through x with the velocity v and keeps its distance
   * from a plane of the shape, as far as it counts along the plane's normal: with V and omega the
   * shape's velocity at x and its angular velocity, dV/dt + omega x (2 v - V). */
  void acceleration(double s, const double x[3], const double v[3], double a[3]) const;

  /* Turns axes, the rows, from the share s of the step to its end. omega: the angular velocity
   * there. */
  void turn(double s, double axes[3][3], double omega[3]) const;

private:
  Frame screwed(double s) const;
  Twist twist_at(double s) const;

  Frame begin_, end_;
  Frame start_; /* screwed(0) */
  Twist screw_; /* of the whole step, times its duration */
  Twist end_velocity_;
  Twist start_velocity_, gain_; /* so that the mean is the screw's, and what is added in the step */
  double dt_;
  bool moves_, has_last_, in_world_;
};

} // namespace asperity
