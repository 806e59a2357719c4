/* Predicts the earliest step in which a body can meet a wall: a body far from all walls is skipped
 * until then, as particles are (ahead.h). It counts as the sphere about its center of mass that has
 * all of it in any position.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_BODY_AHEAD_H
#define ASPERITY_DEM_BODY_AHEAD_H

#include <stddef.h>
#include <stdint.h>
#include <vector>

namespace asperity {

struct Stepper;
struct Body;
struct BodySphere;

class BodyAhead {
public:
  BodyAhead() : now_(0), drift_(0) {}

  /* The next step, of n bodies. */
  void begin_step(const std::vector<Stepper *> &walls, size_t n, double dt);

  /* False if a body cannot meet a wall in this step. */
  bool is_near(const std::vector<Stepper *> &walls, size_t number, const Body &body,
               const BodySphere *spheres, double dt);

private:
  /* A body that is expected at x + k v at the end of the step `from` + k, and near nothing before
   * the step `due`. */
  struct Course {
    int64_t tag, from, due;
    double x[3], v[3], stray;
  };

  int64_t now_;
  double drift_; /* of a wall in a step, at most */
  std::vector<Course> of_;
};

} // namespace asperity

#endif
