/* The walls of a run, as their fixes drive them: what needs none of the engine's classes
 * (wall_fix.h). All walls of a run are computed together, for a particle may meet two of them in
 * one step: the first wall leads.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stdio.h>
#include <exception>
#include <string>
#include <vector>

#include "dem/error.h"
#include "dem/step/mover.h"

namespace asperity {

/* The part of a wall's fix that needs no engine. The first wall of a run drives all of them. */
class WallRun {
public:
  Wall wall;
  std::vector<WallRun *> walls; /* all of this style */

  explicit WallRun(const Engine &engine);
  virtual ~WallRun() {}

  /* At the beginning of a run, and after particles have moved between ranks. Collective. */
  void list_bodies(bool begins);

  /* At the set-up of a run; in the first step of one that has none (`run pre no`), since commands
   * may have changed the groups of particles. Collective. */
  void begin(bool is_setup);

  /* After the forces of a set-up, of which the engine has computed only its own: adds those of the
   * walls. The last wall does it for all of them. Collective. */
  void push_spheres();
  void push_bodies();

  /* All contacts of a step, and its end after the forces; the first wall does both for all of them.
   * Collective. */
  void step();
  void hold();
  void end();

  /* True if the wall deletes what sticks; and whether this particle is to be deleted now, after
   * list_deleted(), which is collective. */
  bool deletes() const {
    return wall.setup.model.deposit() == Model::DELETE;
  }
  void list_deleted();
  bool is_deleted(int i);

  /* Those of list_bodies() that may meet walls one by one. */
  Spheres spheres() const;

  /* The record that an engine gives back does not say how long it is: its first bytes do. */
  void write_record(FILE *file);
  void restore(const char *record);

  void warn_of_no_restart() const;
  /* Tells what is lost when the fix is removed or redefined. Collective. */
  void report_loss() const;

  /* An Error is thrown on all ranks; any other exception may be local, so abort. */
  template <class Action> void attempt(Action action) const {
    try {
      action();
    } catch (const OutOfMemory &wrong) {
      fail_alone(message_of(wrong));
    } catch (const Error &wrong) {
      fail(message_of(wrong));
    } catch (const std::exception &wrong) {
      fail_alone(message_of(wrong));
    }
  }

protected:
  /* Ends the run with an error: of all ranks, or of this one alone in a step. */
  virtual void fail(const std::string &what) const = 0;
  virtual void fail_alone(const std::string &what) const = 0;

  virtual Spheres all_spheres() const = 0;
  virtual Box box() const = 0;
  virtual int group_bit() const = 0;
  virtual BodySource &bodies() = 0;
  /* Moves the wall to the end of the step. */
  virtual void begin_step() = 0;
  /* Wall::check_use(), in the first step, in which shapes move. Collective. */
  virtual void check_use() = 0;
  /* True if a fix has changed the size of particles since the contacts of the step before. */
  virtual bool particles_grow() const = 0;
  /* Has the engine build its lists in this step, and delete what is to be deleted before. */
  virtual void renew_lists() = 0;

private:
  bool leads() const {
    return walls.front() == this;
  }
  std::vector<Wall *> all_walls() const;
  Bodies *take_bodies();
  void warn_of_lost(const Bodies &all);

  /* begin() was called for this run, which has steps (a rerun has none); check_use() was called */
  bool has_begun_, has_steps_, is_checked_;
  /* Of the first wall, for all: groups of the particles, 0 for those of bodies; empty if there are
   * no bodies. */
  std::vector<int> masks_;
  BodyRows body_rows_;
};

} // namespace asperity
