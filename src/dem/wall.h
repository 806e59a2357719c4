/* A rough wall in a simulation: which movers of this rank are at it and when others may come to it,
 * its stuck particles, counters, ledger, and restart data. It does not depend on an engine.
 *
 * A contact is an event on the straight path of a step, found before the forces of that step are
 * computed. The particle continues from there with its new velocity for the rest of the step,
 * through any number of contacts on any number of walls. All walls of a run are computed together.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "asperity_engine.h"
#include "dem/books/books.h"
#include "dem/setup.h"
#include "dem/step/ahead.h"
#include "dem/step/memory.h"
#include "dem/text.h"

namespace asperity {

class Bodies;
class Movers;

/* A stuck mover, and (if was_stopped) its position, velocity and mass when a wall at rest last
 * stopped it. */
struct StuckOne {
  int i;
  bool was_stopped;
  bool is_kept, is_shown; /* its load is among those that the books keep; and shown as such */
  double x[3], v[3], mass;
  asp_removal flow; /* most 0: not drawn yet */
};

/* The particles, or the bodies, of this rank at a wall. */
struct Population {
  Memories &rows;
  Ahead ahead;
  std::vector<StuckOne> stuck;
  std::vector<int> resting, rebounded; /* rebounded: in this step */
  bool any_left;                       /* one of `resting` does not rest any more */

  Population(const Setup &setup, Memories &its, bool are_bodies)
      : rows(its), ahead(setup, its, are_bodies), any_left(false) {}

  /* Lists those of a group that are at the wall, after they have got other indices or groups. */
  void list(const Spheres &spheres, int groupbit);
  /* Resets the states of the last step. */
  void begin_step();
  /* A new run has begun, which may have no deposits. */
  void begin_run(const Setup &setup, const Spheres &spheres);

  size_t bytes() const {
    return rows.bytes() + ahead.bytes() + stuck.capacity() * sizeof(StuckOne);
  }
};

struct Wall {
  /* Numbers of each particle that the engine keeps: a MoverState. */
  static const int N_STATE = sizeof(MoverState) / sizeof(double);
  static const char KEYWORDS[];

  Setup setup; /* what is set up and restored */
  Memories rows;
  BodyMemories body_rows;
  Books books; /* what is counted and written */
  Population grains, bodies;
  bool begins;        /* a run: its first step is to come */
  bool is_rough;      /* in this run */
  bool has_valleys;   /* that hold what rests */
  bool has_flow;      /* that takes deposits away */
  bool has_lay;       /* in two dimensions, too: there the tilt is in the plane */
  bool is_still;      /* no shape moves or measures what sticks to it in this step */
  bool has_to_delete; /* movers of this rank are to be deleted */
  bool is_cut;        /* a mover had too many contacts in a step */
  bool is_passed;     /* a mover may pass it: it closes on one, or goes over one that is stuck */
  double dt_ahead;    /* of the step at whose end what rests was held; 0: unknown */

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

  /* At the beginning of a run: frees stuck movers that a command has moved from where the wall has
   * them, with a warning. moved: for which time the engine has moved all since. Collective. */
  void free_displaced(const Movers &movers, double moved);

  /* Discards what is known of the ways ahead. */
  void clear_ahead() {
    grains.ahead.clear();
    bodies.ahead.clear();
  }

  /* stick.cpp: frees what the flow takes away in this step, moves what is stuck with the wall, and
   * gives it the wall's velocity at the end of the step. */
  void let_go(const Movers &movers);
  void carry_stuck(const Movers &movers);
  void hold_stuck(const Movers &movers);

  /* Movers refer to shapes by numbers, which may differ in another script: from here on a memory
   * names a shape of this wall, or none. */
  static void renumber(const std::vector<int> &shape_now, MoverState &state, Memory &memory);

private:
  void drop_load(StuckOne &at, double share);
  void carry_other(const Movers &movers, StuckOne &at);
  void hold_other(const Movers &movers, StuckOne &at);
  void check_speeds(const Spheres &spheres);
  void warn_of_speeds();
  Settings settings() const;
  void restore_meshes(const WallState &saved);

  double fastest_; /* particle of this rank in this run, in radii per time */
  bool warned_;    /* of speeds */
  bool warned_of_passing_;
  std::vector<int> shape_now_; /* of a restart: the shape, from 1, that is each of the saved ones */
};

/* All contacts of a step of all walls of a run, of grains and of bodies, if there are any. */
void step_walls(const std::vector<Wall *> &walls, const Spheres &spheres, Bodies *bodies = NULL);

/* When a run computes its first forces, which are without the walls: adds those of the walls that
 * hold movers, as the step before has left them. */
void push_again(const std::vector<Wall *> &walls, const Movers &movers);

/* The walls have booked ahead half of a kick that the engine gives what rests. In the first step of
 * a run, and in one of another length, that may be another one: the books follow. Where the script
 * has changed the forces, the walls' old ones are taken back, and the step finds new ones. */
void check_ahead(const std::vector<Wall *> &walls, const Movers &movers);

/* The end of a step, after its forces. What is stuck gets its wall's velocity, walls hold those
 * that rest (end_step.cpp), and one that has rebounded gets its energy. */
void end_walls(const std::vector<Wall *> &walls, Spheres spheres, Bodies *bodies = NULL);

} // namespace asperity
