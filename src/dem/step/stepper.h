/* One wall in a step: which particles of this rank are at it, and when others may come to it.
 *
 * A contact is an event on the straight path of a step, found before the forces of that step are
 * computed. The particle continues from there with its new velocity for the rest of the step,
 * through any number of contacts on any number of walls. All walls of a run are computed together.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_STEPPER_H
#define ASPERITY_DEM_STEPPER_H

#include <vector>

#include "dem/books/books.h"
#include "dem/setup.h"
#include "dem/step/ahead.h"
#include "dem/step/particle_state.h"

namespace asperity {

/* A stuck particle. If a wall at rest stopped it here in the half of a step before: where, and the
 * velocity and mass it had. */
struct StuckParticle {
  int i;
  bool was_stopped;
  bool is_kept; /* its load is among those that the books keep */
  double x[3], v[3], mass;
};

struct Stepper {
  const Setup &setup;
  Books &books;
  ParticleRows rows;
  Ahead ahead;
  std::vector<StuckParticle> stuck;
  bool is_in_step;           /* between carry_stuck() and hold_stuck() */
  bool is_still;             /* no shape moves or measures what sticks to it in this step */
  std::vector<int> touching; /* grains that rest, or have rebounded in this step */
  bool has_to_delete;        /* particles of this rank are to be deleted */
  bool is_cut;               /* a particle had too many contacts in a step */

  Stepper(const Setup &setup, Books &books);

  /* Before a run. shape_now: of a restart, the shape, from 1, that is each of the saved ones, or 0;
   * empty otherwise. */
  void begin_run(const Spheres &spheres, const std::vector<int> &shape_now);

  /* After particles have moved between ranks, or have been put into another order. */
  void reorder(const Spheres &spheres);

  /* Resets the states of the last step, moves stuck particles, and lists the particles that may
   * meet this wall, which has this number among those of the run; the list stays sorted. */
  void begin_step(const Spheres &spheres, int number, std::vector<Near> &near);

  /* stick.cpp: notes where the particle has stuck, and takes it along with the wall for the rest of
   * the step; gives stuck particles their wall's velocity at the end of a step. */
  void stick(const Spheres &spheres, int i, double left, size_t shape, const Path &before,
             const Contact &contact);
  void hold_stuck(const Spheres &spheres);

private:
  void renumber(const Spheres &spheres, const std::vector<int> &shape_now);
  void carry_stuck(const Spheres &spheres);
  void drop_load(StuckParticle &at, double share);
  void carry(const Spheres &spheres, int i, double dt);
};

/* All contacts of a step of all walls of a run. */
void step_walls(const std::vector<Stepper *> &walls, const Spheres &spheres);

/* The end of a step, after its forces. A stuck particle gets its wall's velocity, walls hold those
 * that rest (end_step.cpp), and one that has rebounded gets its energy. */
void end_walls(const std::vector<Stepper *> &walls, const Spheres &spheres);

} // namespace asperity

#endif
