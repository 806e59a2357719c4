/* Code shared by the LIGGGHTS and LAMMPS fixes, as templates over the engine's classes: Program is
 * the class that has all others, Fix the base class of its fixes. The rest is in each engine's
 * room.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_DEM_WALL_FIX_H
#define ASPERITY_DEM_WALL_FIX_H

#include <stdio.h>
#include <string.h>
#include <string>
#include <vector>

#include "dem/engine.h"
#include "dem/error.h"
#include "dem/text.h"
#include "dem/wall.h"

namespace asperity {

/* The part of Engine that is the same in LIGGGHTS and LAMMPS. */
template <class Program, class Fix> class EngineOf : public Engine {
public:
  typedef Fix FixOfEngine;

  EngineOf(Program *program, Fix *fix) : program_(program), fix_(fix) {}

  MPI_Comm world() const override {
    return program_->world;
  }
  std::string id() const override {
    return fix_->id;
  }
  std::string units() const override {
    return program_->update->unit_style;
  }
  int types() const override {
    return program_->atom->ntypes;
  }
  int dimension() const override {
    return program_->domain->dimension;
  }

  /* Those that may meet walls one by one. */
  Spheres spheres() const {
    const auto *atom = program_->atom;
    Spheres s;
    s.step = program_->update->ntimestep;
    s.dt = program_->update->dt;
    s.n = atom->nlocal;
    s.mask = atom->mask;
    s.type = atom->type;
    s.tag = atom->tag;
    s.tag_bytes = sizeof *atom->tag;
    s.x = atom->x ? atom->x[0] : NULL;
    s.v = atom->v ? atom->v[0] : NULL;
    s.omega = atom->omega_flag && atom->omega ? atom->omega[0] : NULL;
    s.f = atom->f ? atom->f[0] : NULL;
    s.torque = s.omega && atom->torque ? atom->torque[0] : NULL;
    s.radius = atom->radius;
    s.mass = atom->rmass;
    return s;
  }

  Box box() const {
    const auto *domain = program_->domain;
    Box box;
    for (int d = 0; d < 3; d++) {
      box.lo[d] = domain->boxlo[d];
      box.period[d] = domain->periodicity[d] ? domain->prd[d] : 0;
    }
    return box;
  }

  Bounds bounds() const {
    const auto *domain = program_->domain;
    Bounds box;
    for (int d = 0; d < 3; d++) {
      box.lo[d] = domain->triclinic ? domain->boxlo_bound[d] : domain->boxlo[d];
      box.hi[d] = domain->triclinic ? domain->boxhi_bound[d] : domain->boxhi[d];
    }
    return box;
  }

protected:
  Program *program_;
  Fix *fix_;
};

/* The hooks of the fix. Host is an EngineOf, or a class derived from one. */
template <class Host> class WallFix : public Host {
public:
  typedef typename Host::FixOfEngine EngineFix;

  template <class Program>
  WallFix(Program *program, EngineFix *fix) : Host(program, fix), wall(*this) {}

  Wall wall;

  /* Ends the run with an error: of all ranks, or of this one alone in a step. */
  virtual void fail(const std::string &what) const = 0;
  virtual void fail_alone(const std::string &what) const = 0;
  /* Gives the wall the rows of this rank's particles, which may have moved since the last step. */
  virtual void set_rows() = 0;
  /* The engine's bodies. */
  virtual BodySource &bodies() = 0;
  /* Moves the wall to the end of the step. */
  virtual void begin_step() = 0;
  /* What is wrong with a fix that ties particles to bodies; "": nothing. True if a fix changes the
   * size or the shape of the box. */
  virtual std::string body_error(const EngineFix *fix) const = 0;
  virtual bool changes_box(const EngineFix *fix) const = 0;

  Spheres spheres() {
    Spheres s = Host::spheres();
    const BodySource &of = bodies();
    if (!of.any())
      return s;
    masks_.assign(s.mask, s.mask + s.n);
    for (int i = 0; i < s.n; i++)
      if (of.has(i))
        masks_[static_cast<size_t>(i)] = 0;
    s.mask = masks_.data();
    return s;
  }

  /* At the beginning of a run, and after particles have moved between ranks. Collective. */
  void list_bodies(bool begins) {
    if (!leads() || !bodies().any())
      return;
    bodies().list(steppers(), begins);
    body_rows_.reset(Host::spheres(), siblings_.size());
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

  /* Declares the fix's outputs to the engine; call when its wall is known. */
  void set_flags() {
    auto *fix = this->fix_;
    fix->scalar_flag = fix->vector_flag = fix->array_flag = 1;
    fix->size_vector = Books::N_COUNTERS;
    fix->size_array_rows = static_cast<int>(wall.setup.shapes.size());
    fix->size_array_cols = Books::N_TOTALS;
    fix->global_freq = 1;
    fix->extscalar = fix->extvector = fix->extarray = 1;
    fix->restart_global = 1;
    fix->nevery = 1;
    fix->force_reneighbor = deletes();
    fix->next_reneighbor = -1;
    if (Ledger *ledger = wall.books.ledger()) {
      fix->local_flag = 1;
      fix->local_freq = static_cast<int>(ledger->every());
      fix->size_local_rows = 0;
      fix->size_local_cols = ledger->columns();
    }
  }

  /* Before a run. wall_of: gives the WallFix of a fix, or NULL where that is no wall of this style.
   */
  template <class Of> void find_siblings(Of wall_of) {
    const auto *modify = this->program_->modify;
    siblings_.clear();
    for (int i = 0; i < modify->nfix; i++)
      if (WallFix *fix = wall_of(modify->fix[i]))
        siblings_.push_back(fix);
  }

  void check_run() const {
    const auto *update = this->program_->update;
    if (strstr(update->integrate_style, "respa"))
      fail("run_style respa is not supported; it must be run_style verlet");
    if (update->whichflag == 2)
      fail("minimize is not supported: a rebound is an event in time; use run");
  }

  /* Fixes that put particles where they want would carry them through the wall. They may get
   * particles during a run, so each neighbor build looks. Collective. */
  void check_movers() const {
    const auto *modify = this->program_->modify;
    for (int i = 0; i < modify->nfix; i++) {
      const EngineFix *fix = modify->fix[i];
      const std::string style = fix->style, wrong = body_error(fix);
      const std::string name = "fix " + style + " (id " + fix->id + ")";
      const bool is_deform = style.compare(0, 6, "deform") == 0;
      if (!wrong.empty() && shares_particles(fix))
        fail(wrong);
      if (style == "move" && shares_particles(fix))
        fail(name + " moves particles of this wall's group, which cannot rebound; the groups must "
                    "have no particle in common");
      if (style == "recenter")
        fail(name + " shifts particles at the end of a step, past the wall; leave it out");
      if (changes_box(fix) && !(is_deform && this->program_->domain->deform_vremap))
        fail(name + " changes the box and moves particles with it, past the wall; " +
             (is_deform ? "it must be 'remap v', which leaves them where they are"
                        : "the box must keep its size"));
    }
  }

  /* For those who have written `fix wall/gran` so far. */
  static void refuse_model(const Words &words) {
    if (words.is_one_of("model granular hooke hooke/history hertz/history"))
      throw Error("takes no model: '" + std::string(words.rest()[0]) +
                  "' and what is behind it belong to 'fix wall/gran'; here 'rebound' states the "
                  "law");
  }

  void warn_of_no_restart() const {
    this->warn("the restart file has no data of this wall; its impact numbers begin at 1, and no "
               "particle is stuck to it");
  }

  /* Before the fix is taken away, or defined anew: nobody should find out later. Collective. */
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

  /* At the set-up of a run; in the first step of one that has none (`run pre no`), since commands
   * may have changed the groups of particles. */
  void begin_run(bool is_setup) {
    set_rows();
    list_bodies(is_setup);
    attempt([&] {
      wall.begin_run(spheres(), this->fix_->groupbit, this->box());
      wall.free_displaced(spheres(), is_setup ? 0 : this->program_->update->dt);
    });
    has_begun_ = true;
  }

  /* After the forces of a set-up, of which the engine has computed only its own. The last wall does
   * it for all of them. Collective. */
  void push_spheres() {
    if (siblings_.back() != this)
      return;
    for (WallFix *fix : siblings_)
      fix->set_rows();
    push_again(steppers(), spheres());
  }
  void push_bodies() {
    WallFix &first = *siblings_.front();
    if (siblings_.back() != this || !first.bodies().any())
      return;
    if (Bodies *all = first.take_bodies()) {
      push_again(steppers(), *all);
      first.bodies().put(true, this->world());
    }
  }

  /* All contacts of a step; the first wall works them out for all of them. */
  void step() {
    if (!leads())
      return;
    const auto *update = this->program_->update;
    for (WallFix *fix : siblings_)
      if (!fix->has_begun_)
        fix->begin_run(false);
    try {
      const bool grow = particles_grow();
      for (WallFix *fix : siblings_) {
        fix->set_rows();
        fix->wall.set_dt(update->ntimestep - 1, update->dt);
        if (grow)
          fix->wall.stepper.clear_ahead();
        fix->begin_step();
        if (!fix->is_checked_)
          fix->check_use();
      }
      Bodies *all = take_bodies();
      if (all && all->begins) /* the run */
        warn_of_bodies(*all);
      step_walls(steppers(), this->spheres(), all);
    } catch (const std::exception &wrong) {
      fail_alone(message_of(wrong));
    }
    if (bodies().any())
      bodies().put(false, this->world());
    for (WallFix *fix : siblings_) {
      if (!fix->deletes())
        continue;
      int mine = fix->wall.stepper.has_to_delete,
          any; /* all ranks must agree to build lists anew */
      MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, this->program_->world);
      if (any)
        fix->fix_->next_reneighbor = this->program_->update->ntimestep;
    }
  }

  /* Takes away what the wall deletes; returns how many particles, of all ranks. */
  int64_t delete_particles() {
    auto *atom = this->program_->atom;
    if (!deletes())
      return 0;
    set_rows();
    BodySource &of = siblings_.front()->bodies();
    if (of.any())
      of.list_deleted(wall.stepper.body_rows, this->world());
    long long mine = 0, all;
    for (int i = 0; i < atom->nlocal;) {
      if (wall.stepper.rows.status(i) == Status::TO_DELETE || (of.any() && of.is_deleted(i))) {
        atom->avec->copy(atom->nlocal - 1, i, 1);
        atom->nlocal--;
        mine++;
      } else
        i++;
    }
    MPI_Allreduce(&mine, &all, 1, MPI_LONG_LONG, MPI_SUM, this->program_->world);
    if (all > 0 && atom->map_style) {
      atom->nghost = 0;
      atom->map_init();
      atom->map_set();
    }
    return all;
  }

  void hold() {
    set_rows();
    if (!leads())
      return;
    for (WallFix *fix : siblings_)
      fix->set_rows();
    Spheres s = this->spheres();
    Bodies *all = take_bodies();
    s.dt = wall.setup.dt; /* another fix may have changed that of the next step */
    if (all)
      all->dt = s.dt;
    end_walls(steppers(), s, all);
    if (all) {
      bodies().put(true, this->world());
      body_rows_.show(steppers(), *all, this->world());
    }
    for (WallFix *fix : siblings_)
      fix->wall.books.end_loads();
  }

  void end_run() {
    has_begun_ = false;
    attempt([&] { wall.end_run(); });
  }

  bool is_output() const {
    return this->program_->output->next == this->program_->update->ntimestep;
  }

  /* Between two windows of the ledger there are no rows to be read. */
  void end_step() {
    const int64_t now = this->program_->update->ntimestep;
    attempt([&] { wall.end_step(now, is_output()); });
    if (Ledger *ledger = wall.books.ledger()) {
      const bool due = now % ledger->every() == 0;
      this->fix_->array_local = due ? ledger->rows() : NULL;
      this->fix_->size_local_rows = due ? ledger->size() : 0;
    }
  }

  /* The record that an engine gives back does not say how long it is: its first bytes do. */
  void write_record(FILE *file) {
    std::vector<char> record;
    attempt([&] { record = wall.save(); });
    if (this->program_->comm->me != 0)
      return;
    const int size = static_cast<int>(record.size());
    fwrite(&size, sizeof size, 1, file);
    fwrite(record.data(), 1, record.size(), file);
  }

  void restore(const char *record) {
    attempt([&] { wall.restore(record); });
    is_restored_ = true;
  }

  bool deletes() const {
    return wall.setup.model.deposit() == Model::DELETE;
  }

  bool is_restored() const {
    return is_restored_;
  }

protected:
  void warn_of_bodies(const Bodies &all) {
    const size_t saved = is_continued_ ? wall.stepper.body_rows.restored() : 0;
    is_continued_ = false;
    for (const std::string &doubt : doubts_of(all, bodies().remedy(), saved, this->world()))
      this->warn(doubt);
  }

  Bodies *take_bodies() {
    return bodies().any() ? bodies().take(steppers()) : NULL;
  }

  std::vector<Stepper *> steppers() {
    std::vector<Stepper *> all;
    for (WallFix *fix : siblings_)
      all.push_back(&fix->wall.stepper);
    return all;
  }

  bool leads() const {
    return siblings_.front() == this;
  }

  std::vector<WallFix *> siblings_; /* all walls of this style, the first one leads */

private:
  /* True if a particle of any rank is in both groups. */
  bool shares_particles(const EngineFix *fix) const {
    const auto *atom = this->program_->atom;
    int mine = 0, any;
    for (int i = 0; i < atom->nlocal; i++)
      mine |= (atom->mask[i] & fix->groupbit) && (atom->mask[i] & this->fix_->groupbit);
    MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, this->world());
    return any;
  }

  void check_use() {
    const auto *domain = this->program_->domain;
    auto *group = this->program_->group;
    const bool fixed = domain->nonperiodic < 2;
    const Bounds box = this->bounds();
    const int number = this->fix_->igroup;
    is_checked_ = true;
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

  bool has_begun_ = false;   /* begin_run() was called for this run */
  bool is_restored_ = false; /* from a restart file */
  bool is_checked_ = false;  /* check_use() was called, in the first step, in which shapes move */
  bool is_continued_ = true; /* no step yet since a restart */
  std::vector<int> masks_;   /* of the particles, 0 for those of bodies */
  BodyRows body_rows_;       /* of the first wall, for all */
};

/* The functions of a fix that are the same in both engines. */
template <class Fix, class Host> class WallHooks : public Fix {
public:
  using Fix::Fix;

  void setup_pre_exchange() override {
    this->pre_exchange();
  }
  void post_integrate() override {
    wall_fix().step();
  }
  double compute_scalar() override {
    return wall_fix().wall.books.counter(Books::N_IMPACTS);
  }
  double compute_vector(int n) override {
    return wall_fix().wall.books.counter(n);
  }
  double compute_array(int row, int column) override {
    return wall_fix().wall.books.total(static_cast<size_t>(row), column);
  }
  void write_restart(FILE *file) override {
    wall_fix().write_record(file);
  }
  void restart(char *record) override {
    wall_fix().restore(record);
  }

protected:
  virtual WallFix<Host> &wall_fix() = 0;
};

} // namespace asperity

#endif
