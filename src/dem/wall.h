/* A rough wall in a simulation: the contacts of its particles in each step, its stuck particles,
 * counters, ledger, and restart data. It does not depend on an engine.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_WALL_H
#define ASPERITY_DEM_WALL_H

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "dem/books/books.h"
#include "dem/text.h"
#include "dem/setup.h"
#include "dem/step/mover.h"

namespace asperity {

struct Wall {
  /* Numbers of each particle that the engine keeps: a MoverState. */
  static const int N_STATE = sizeof(MoverState) / sizeof(double);
  static const char KEYWORDS[];

  Setup setup;     /* what is set up and restored */
  Books books;     /* what is counted and written */
  Stepper stepper; /* what steps */

  explicit Wall(const Engine &engine);

  /* Adds a shape, of atoms of wall_type, with `pieces` triangles numbered from 0 (0: one piece),
   * and a name by which restart files refer to it. */
  void add_shape(std::unique_ptr<Shape> shape, int wall_type, size_t pieces,
                 const std::string &name);

  /* Reads the rest of the command. geometry: the words before it, for messages. own: if the next
   * word is a keyword of this engine alone, one of own_words, reads it and what belongs to it. */
  void parse(Words &words, const std::string &geometry, const std::string &own_words = "",
             const std::function<bool(Words &)> &own = nullptr);

  /* Before a run, and at its beginning, when all particles are where they belong; collective. */
  void init(int64_t step, double dt);
  void begin_run(const Spheres &spheres, int groupbit, const Box &box);

  /* In a step: warns of what makes no sense. box: that of the particles, NULL where it grows with
   * them; empty_group: the name of the wall's group if it has no particles, or NULL. Collective. */
  void check_use(const Bounds *box, const char *empty_group);

  /* The rows of this rank's particles, N_STATE each. */
  void set_rows(double *state);

  /* After particles have moved between ranks, or have been put into another order. */
  void reorder(const Spheres &spheres);

  /* The ledger's windows, and warnings at output; collective. */
  void end_step(int64_t step, bool output);
  void end_run();

  /* The length of the steps from here on. */
  void set_dt(int64_t step, double dt);

  double stuck() const; /* how many particles are, now; collective */
  double worn_density(size_t shape) const;
  double bytes() const;

  /* Saves and restores the wall's restart data, on rank 0; restore before init(). Collective. Both
   * throw an Error if they fail. */
  std::vector<char> save();
  void restore(const char *record);
  bool is_restored() const { /* before the first run */
    return !shape_now_.empty();
  }

private:
  void check_speeds(const Spheres &spheres);
  void warn_of_speeds();
  Settings settings() const;
  void restore_meshes(const WallState &saved);

  double fastest_; /* particle of this rank in this run, in radii per time */
  bool warned_;    /* of speeds */
  bool warned_of_passing_;
  std::vector<int> shape_now_; /* of a restart: the shape, from 1, that is each of the saved ones */
};

} // namespace asperity

#endif
