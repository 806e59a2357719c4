/* One body on its way through a step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_BODY_WAY_H
#define ASPERITY_DEM_BODY_WAY_H

#include <utility>
#include <vector>

#include "dem/step/bodies.h"
#include "dem/step/body_solve.h"

namespace asperity {

/* A sphere of the body at a wall. */
struct Touch {
  size_t wall, shape, sphere;
  Path before;
  Contact contact;
  double approach; /* speed to the wall */
  bool is_low;     /* an impact that is taken as a contact that stays */
  double hold; /* slope that the valley withstands in which the sphere lies; 0: it lies in none */
};

/* The touching sphere as one of a list, with the mass of its body. */
struct TouchingSphere {
  int64_t tag;
  Spheres view;
  TouchingSphere(const Bodies &bodies, const Body &body, const BodySphere &sphere);
};

class Way {
public:
  Way(const std::vector<Stepper *> &walls, Bodies &bodies, size_t number);

  /* All contacts of the step. */
  void go();

  /* body_stick.cpp: moves a body that is stuck to a wall with that for the whole step; false: it is
   * not stuck. And gives it the wall's velocity at the end of the step. */
  bool carry_stuck();
  void hold_stuck();

private:
  void find_near();
  bool find_next();
  void search(const Body &end, double time);
  void check_side();
  void meet(bool all_stay);
  void velocity(double v[3]) const;
  void relative_velocity(const Touch &touch, double u[3]) const;
  double press(const Touch &touch) const;
  bool arrives(const Touch &touch, double &approach) const;

  /* body_impact.cpp */
  asp_particle particle(const Touch &touch, const asp_body &inverse, double lay[3]) const;
  Impact impact_of(const Touch &touch);
  void work_out(const Touch &touch, Impact &impact);
  void apply(const Touch &touch, const Impact &impact);
  void hit(const Touch &touch);
  bool hit_alone(const Touch &touch, const Impact &impact, double &restitution) const;
  void hit_together(const std::vector<Touch> &touches);
  bool sticks(const Touch &touch);
  void point_of(const Touch &touch, BodyPoint &point) const;
  ContactLoad load_of(const Touch &touch, const double change[3], const double turn[3],
                      const double v1[3]) const;
  ContactLoad load_of_point(const Touch &touch, const BodyPoint &point, const double v1[3]) const;

  /* body_stay.cpp */
  void stay(bool in_valleys);
  void add_points();
  void count_stay(const double v1[3]);
  FacePlace *find_face(const Touch &touch, bool &moved) const;
  void meet_face(const Touch &touch);
  asp_key next_key(const Touch &touch);
  const FacePlace &valley(const Touch &touch, FacePlace &face);
  double energy_along(const Touch &touch) const;
  double hold_of(const Touch &touch, double push);
  bool is_low(const Touch &touch, double approach);
  void brake(const Touch &touch, const double change[3], const double turn[3]);
  bool is_ball(const Touch &touch) const;
  void stop_along(const Touch &touch);
  bool graze(const Touch &touch);

  /* body_stick.cpp */
  void stick(const Touch &touch);
  const BodySphere &anchor(const StuckBody &at) const;
  StuckBody held_by(const Touch &touch) const;
  void trap(const Touch &touch);
  void carry(size_t wall, StuckBody &at, double share);
  void give_velocity(size_t wall, const StuckBody &at);

  BodyMemory &memory(size_t wall) const {
    return *bodies_.memory[wall][number_];
  }
  const BodySphere &sphere(const Touch &touch) const {
    return bodies_.spheres[touch.sphere];
  }
  Stepper &wall(const Touch &touch) const {
    return *walls_[touch.wall];
  }
  const asp_wall *law(const Touch &touch) const;
  const Member &shape(const Touch &touch) const {
    return wall(touch).setup.shapes[touch.shape];
  }

  const std::vector<Stepper *> &walls_;
  Bodies &bodies_;
  const size_t number_;
  Body &body_;
  const Body arrival_;  /* without walls */
  double left_, moved_; /* of the step; since the last contact */
  bool is_stuck_;       /* now */
  std::vector<std::pair<size_t, size_t>> near_;
  std::vector<Touch> touches_, overlaps_;
  std::vector<BodyPoint> points_;
};

} // namespace asperity

#endif
