/* A wall as its command and a restart file set it up: its shapes, its law, the box and the clock.
 * Nothing here changes within a step but the shapes, which move.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "dem/engine.h"
#include "dem/model.h"
#include "dem/shapes/shape.h"

namespace asperity {

/* A shape of a wall. */
struct Member {
  std::unique_ptr<Shape> shape;
  std::string name; /* of a mesh; empty for a shape of one piece */
  int wall_type;
  size_t pieces; /* triangles, numbered from 0; 0: one piece */
};

/* The time of the ledger: an engine's own may begin anew after a restart. dt 0: not set yet. */
struct Clock {
  double time, step, dt;
};

struct Setup {
  const Engine &engine;
  Model model;
  std::string geometry; /* the words of the command before the description */
  std::vector<Member> shapes;
  uint32_t key, stay_key;     /* of the draws: of impacts, and of particles that stay at the wall */
  bool interlocks;            /* valleys hold particles */
  std::string temperature_of; /* the engine's name of the particles' temperatures; "": none */
  const double *temperatures; /* in this step; NULL: none */
  int groupbit;
  Box box;
  Clock clock;
  double dt; /* of the run; 0: there is none yet */

  explicit Setup(const Engine &engine);

  /* By the wall's own clock, which restarts and reset_timestep do not disturb. */
  double time(double step) const {
    return clock.time + (step - clock.step) * clock.dt;
  }
  void set_clock(int64_t step, double dt);

  /* They may have moved since the last step. */
  void find_temperatures() {
    temperatures = temperature_of.empty() ? NULL : engine.numbers(temperature_of);
  }
  /* Of a particle of this rank, K; 0: unknown. */
  double temperature(int i) const {
    return temperatures ? temperatures[i] : model.temperature();
  }

  /* Throws an Error if bodies cannot hit this wall. */
  void check_bodies() const;

  /* True if all shapes look the same to a particle that has crossed a periodic edge of the box. */
  bool repeats() const;
};

} // namespace asperity
