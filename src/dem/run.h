/* The walls of a run, as their fixes drive them. All walls of a run are computed together, for a
 * particle may meet two of them in one step: the first wall drives all of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stdio.h>
#include <string.h>
#include <exception>
#include <string>
#include <vector>

#include "dem/error.h"
#include "dem/step/mover.h"
#include "dem/text.h"

namespace asperity {

/* What a wall's fix does in a run. Host is an EngineOf (wall_fix.h), or a class derived from one.
 */
template <class Host> class WallRun : public Host {
public:
  typedef typename Host::FixOfEngine EngineFix;

  Wall wall;
  std::vector<WallRun *> walls; /* all of this style */

  template <class Program>
  WallRun(Program *program, EngineFix *fix)
      : Host(program, fix), wall(static_cast<const Engine &>(*this)), has_begun_(false),
        has_steps_(false), is_checked_(false) {}

  /* At the beginning of a run, and after particles have moved between ranks. Collective. */
  void list_bodies(bool begins) {
    if (!leads())
      return;
    masks_.clear();
    if (!bodies().any())
      return;
    const Spheres s = Host::spheres();
    bodies().list(all_walls(), begins);
    body_rows_.reset(s, walls.size());
    for (int i = 0; i < s.n; i++)
      masks_.push_back(bodies().has(i) ? 0 : s.mask[i]);
  }

  /* At the set-up of a run; in the first step of one that has none (`run pre no`), since commands
   * may have changed the groups of particles. Collective. */
  void begin(bool is_setup) {
    list_bodies(is_setup);
    attempt([this, is_setup] {
      const Spheres all = spheres();
      wall.begin_run(all, this->fix_->groupbit, this->box());
      wall.free_displaced(all, is_setup ? 0 : all.dt);
    });
    has_begun_ = true;
    has_steps_ = false;
  }

  /* After the forces of a set-up, of which the engine has computed only its own: adds those of the
   * walls. The last wall does it for all of them. Collective. */
  void push_spheres() {
    if (walls.back() == this)
      push_again(all_walls(), spheres());
  }
  void push_bodies() {
    Bodies *all = walls.back() == this ? walls.front()->take_bodies() : NULL;
    if (!all)
      return;
    for (Wall *each : all_walls()) /* all walls are where this run finds them */
      each->free_displaced(*all, 0);
    push_again(all_walls(), *all);
    walls.front()->bodies().put(true, this->world());
  }

  /* All contacts of a step, and its end after the forces; the first wall does both for all of them.
   * Collective. */
  void step() {
    if (!leads())
      return;
    for (WallRun *each : walls)
      if (!each->has_begun_)
        each->begin(false);
    try {
      const bool grow = particles_grow();
      const Spheres now = spheres();
      for (WallRun *each : walls) {
        each->has_steps_ = true;
        each->wall.set_dt(now.step - 1, now.dt);
        if (grow)
          each->wall.clear_ahead();
        each->begin_step();
        each->wall.setup.find_temperatures();
        if (!each->is_checked_)
          each->check_use();
        each->is_checked_ = true;
      }
      Bodies *all = take_bodies();
      if (all && all->begins) /* the run */
        warn_of_lost(*all);
      step_walls(all_walls(), now, all);
    } catch (const std::exception &wrong) {
      fail_alone(message_of(wrong));
    }
    if (bodies().any())
      bodies().put(false, this->world());
    for (WallRun *each : walls) {
      int mine = each->wall.has_to_delete, any; /* all ranks must agree */
      if (!each->deletes())
        continue;
      MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, this->world());
      if (any) /* lists are built in this step, and before that it is deleted */
        each->fix_->next_reneighbor = this->program_->update->ntimestep;
    }
  }
  void hold() {
    if (!has_steps_)
      fail("rerun is not supported: a rebound is an event in time; use run");
    if (!leads())
      return;
    Bodies *all = NULL;
    try {
      Spheres s = spheres();
      all = take_bodies();
      s.dt = wall.setup.dt; /* another fix may have changed that of the next step */
      if (all)
        all->dt = s.dt;
      end_walls(all_walls(), s, all);
    } catch (const std::exception &wrong) {
      fail_alone(message_of(wrong));
    }
    if (all) {
      bodies().put(true, this->world());
      body_rows_.show(all_walls(), *all, this->world());
    }
    for (WallRun *each : walls)
      each->wall.books.end_loads();
  }
  void end() {
    has_begun_ = false;
    attempt([this] { wall.end_run(); });
  }

  /* True if the wall deletes what sticks; and whether this particle is to be deleted now, after
   * list_deleted(), which is collective. */
  bool deletes() const {
    return wall.setup.model.deposit() == Model::DELETE;
  }
  void list_deleted() {
    BodySource &of = walls.front()->bodies();
    if (of.any())
      of.list_deleted(wall.body_rows, this->world());
  }
  bool is_deleted(int i) {
    const BodySource &of = walls.front()->bodies();
    return wall.rows.status(i) == Status::TO_DELETE || (of.any() && of.is_deleted(i));
  }

  /* Those of list_bodies() that may meet walls one by one. */
  Spheres spheres() const {
    Spheres s = Host::spheres();
    const std::vector<int> &masks = walls.front()->masks_;
    if (!masks.empty())
      s.mask = masks.data();
    return s;
  }

  /* The record that an engine gives back does not say how long it is: its first bytes do. */
  void write_record(FILE *file) {
    std::vector<char> record;
    attempt([&] { record = wall.save(); });
    if (this->rank() != 0)
      return;
    const int size = static_cast<int>(record.size());
    fwrite(&size, sizeof size, 1, file);
    fwrite(record.data(), 1, record.size(), file);
  }
  void restore(const char *record) {
    attempt([this, record] { wall.restore(record); });
  }

  void warn_of_no_restart() const {
    this->warn("the restart file has no data of this wall; its impact numbers begin at 1, and no "
               "particle is stuck to it");
  }
  /* Tells what is lost when the fix is removed or redefined. Collective. */
  void report_loss() const {
    const double stuck = wall.stuck(), impacts = wall.books.counter(Books::N_IMPACTS);
    const std::string counts = text("its counts, of %.0f impacts, end with it", impacts);
    if (stuck > 0)
      this->warn(text("%.0f particles that are stuck to this wall are free from here on, also at a "
                      "wall that takes its place; ",
                      stuck) +
                 counts);
    else if (impacts > 0)
      this->print("fix " + this->id() + " wall/rebound: the wall is taken away; " + counts);
  }

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
  /* Ends the run with an error: of all ranks, or of this one alone in a step. */
  void fail(const std::string &what) const {
    this->program_->error->all(FLERR, this->of_fix(what));
  }
  void fail_alone(const std::string &what) const {
    this->program_->error->one(FLERR, this->of_fix(what));
  }

protected:
  virtual BodySource &bodies() = 0;
  /* Moves the wall to the end of the step. */
  virtual void begin_step() = 0;

private:
  bool leads() const {
    return walls.front() == this;
  }
  std::vector<Wall *> all_walls() const {
    std::vector<Wall *> all;
    for (WallRun *each : walls)
      all.push_back(&each->wall);
    return all;
  }
  Bodies *take_bodies() {
    return bodies().any() ? bodies().take(all_walls()) : NULL;
  }

  void warn_of_lost(const Bodies &all) {
    const size_t saved = wall.body_rows.take_restored();
    long long mine = static_cast<long long>(all.all.size()), now;
    MPI_Allreduce(&mine, &now, 1, MPI_LONG_LONG, MPI_SUM, this->world());
    if (now < static_cast<long long>(saved))
      this->warn(text("the restart file has %zu bodies, and %lld are left; the engine lost the "
                      "others when it read the file",
                      saved, now));
  }

  /* In the first step, in which shapes move. Collective. */
  void check_use() {
    const auto *domain = this->program_->domain;
    auto *group = this->program_->group;
    const bool fixed = domain->nonperiodic < 2;
    const Bounds box = this->bounds();
    const int number = this->fix_->igroup;
    const bool empty = number > 0 && this->program_->atom->natoms > 0 && group->count(number) < 1;
    wall.check_use(fixed ? &box : NULL, empty ? group->names[number] : NULL);
  }

  /* True if a fix has changed the size of particles since the contacts of the step before. */
  bool particles_grow() const {
    const auto *modify = this->program_->modify;
    for (int i = 0; i < modify->nfix; i++) {
      const auto *fix = modify->fix[i];
      if (strncmp(fix->style, "adapt", 5) == 0 && fix->nevery > 0 &&
          (this->program_->update->ntimestep - 1) % fix->nevery == 0)
        return true;
    }
    return false;
  }

  /* begin() was called for this run, which has steps (a rerun has none); check_use() was called */
  bool has_begun_, has_steps_, is_checked_;
  /* Of the first wall, for all: groups of the particles, 0 for those of bodies; empty if there are
   * no bodies. */
  std::vector<int> masks_;
  BodyRows body_rows_;
};

} // namespace asperity
