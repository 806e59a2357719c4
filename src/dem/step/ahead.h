/* Predicts the earliest step in which a particle can meet a wall. Most particles are too far away
 * for many steps and are skipped until then.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <vector>

#include "dem/setup.h"
#include "dem/step/screen.h"

namespace asperity {

/* A particle that may touch a wall in this step, which has this number among those of the run. */
struct Candidate {
  int i, wall;
  bool operator<(const Candidate &other) const {
    return i < other.i || (i == other.i && wall < other.wall);
  }
};

class Ahead {
public:
  /* Bodies are the spheres that have all of them. */
  Ahead(const Setup &setup, const Memories &rows, bool are_bodies);

  void begin_run() {
    most_ = 0;
    clear();
  }

  /* Discards all predictions, as after radii have changed; what is near stays so. */
  void clear();

  /* Discards predictions of atoms that changed index, and all of them if a wall does not repeat
   * periodically. */
  void reorder(const Spheres &spheres);

  /* Lists the particles that may touch this wall in this step. */
  void find_near(const Spheres &spheres, int number, std::vector<Candidate> &near);

  bool is_near(int i) const {
    return due_[i] <= now_;
  }
  void expire(int i) {
    due_[i] = 0;
  }
  /* Takes one as near for some steps: what it rests at has not held it yet. */
  void watch(int i);

  /* How far sustained contacts may bend the way of a particle within a step. */
  static double bend(double radius);

  size_t bytes() const;

private:
  float stray(const Spheres &spheres, int i) const;
  void note_velocity(const Spheres &spheres, int i);
  bool look(const Spheres &spheres, int i);
  FaceList faces(const Spheres &spheres, int i, size_t shape) const;
  int steps_clear(const Spheres &spheres, int i) const;
  bool is_wide(const Spheres &spheres, int i, int steps) const;
  enum class Screened { NONE, FAILS, HOLDS };
  Screened screen(const Spheres &spheres, int i, Screen &made) const;
  void check_screens(const Spheres &spheres, int number, std::vector<Candidate> &near);

  const Setup &setup_;
  const Memories &rows_;
  const bool are_bodies_;
  int now_; /* steps are counted from the beginning of the run */
  /* Earliest step in which each particle may touch a face it is not resting on. If negative: treat
   * it as near until step -due. */
  std::vector<int> due_;
  std::vector<float> v_;             /* rows of three */
  std::vector<float> stray_, least_; /* by which its velocity may differ; and of each block */
  std::vector<int64_t> tag_;         /* of whom this is */
  double travel_, most_;             /* of a shape in this step, and in any, at most */
  std::vector<Screen> screens_;
};

} // namespace asperity
