/* One wall in a step: which movers of this rank are at it, and when others may come to it.
 *
 * A contact is an event on the straight path of a step, found before the forces of that step are
 * computed. The particle continues from there with its new velocity for the rest of the step,
 * through any number of contacts on any number of walls. All walls of a run are computed together.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_STEPPER_H
#define ASPERITY_DEM_STEPPER_H

#include <vector>

#include "asperity_engine.h"
#include "dem/books/books.h"
#include "dem/setup.h"
#include "dem/step/ahead.h"
#include "dem/step/memory.h"

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

struct Stepper {
  const Setup &setup;
  Books &books;
  Memories rows;
  BodyMemories body_rows;
  Population grains, bodies;
  bool begins;        /* a run: its first step is to come */
  bool is_rough;      /* in this run */
  bool has_valleys;   /* that hold what rests */
  bool has_lay;       /* in two dimensions, too: there the tilt is in the plane */
  bool is_still;      /* no shape moves or measures what sticks to it in this step */
  bool has_to_delete; /* movers of this rank are to be deleted */
  bool is_cut;        /* a mover had too many contacts in a step */
  bool is_passed;     /* a mover may pass it: it closes on one, or goes over one that is stuck */
  double dt_ahead;    /* of the step at whose end what rests was held; 0: unknown */

  Stepper(const Setup &setup, Books &books);

  /* Before a run. shape_now: of a restart, the shape, from 1, that is each of the saved ones, or 0;
   * empty otherwise. */
  void begin_run(const Spheres &spheres, const std::vector<int> &shape_now);

  /* At the beginning of a run: frees stuck movers that a command has moved from where the wall has
   * them, with a warning. moved: for which time the engine has moved all since. Collective. */
  void free_displaced(const Movers &movers, double moved);

  /* Discards what is known of the ways ahead. */
  void clear_ahead() {
    grains.ahead.clear();
    bodies.ahead.clear();
  }

  /* After particles have moved between ranks, or have been put into another order. */
  void reorder(const Spheres &spheres);

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
};

/* All contacts of a step of all walls of a run, of grains and of bodies, if there are any. */
void step_walls(const std::vector<Stepper *> &walls, const Spheres &spheres, Bodies *bodies = NULL);

/* When a run computes its first forces, which are without the walls: adds those of the walls that
 * hold movers, as the step before has left them. */
void push_again(const std::vector<Stepper *> &walls, const Movers &movers);

/* The walls have booked ahead half of a kick that the engine gives what rests. In the first step of
 * a run, and in one of another length, that may be another one: the books follow. Where the script
 * has changed the forces, the walls' old ones are taken back, and the step finds new ones. */
void check_ahead(const std::vector<Stepper *> &walls, const Movers &movers);

/* The end of a step, after its forces. What is stuck gets its wall's velocity, walls hold those
 * that rest (end_step.cpp), and one that has rebounded gets its energy. */
void end_walls(const std::vector<Stepper *> &walls, Spheres spheres, Bodies *bodies = NULL);

} // namespace asperity

#endif
