/* Templates for the fixes of LIGGGHTS and LAMMPS: code that is the same but uses the engine's own
 * classes, whose headers are included before. Program is the class that has all others, Fix the
 * base class of its fixes. What a wall does in a run is in run.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <stdio.h>
#include <string.h>
#include <algorithm>
#include <string>
#include <vector>

#include "dem/text.h"
#include "dem/run.h"

namespace asperity {

/* The part of Engine that is the same in LIGGGHTS and LAMMPS. Message: a text as the engine's error
 * messages take it. */
template <class Program, class Fix, class Message> class EngineOf : public Engine {
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
  double time() const override {
    const auto *update = program_->update;
    return update->atime + static_cast<double>(update->ntimestep - update->atimestep) * update->dt;
  }
  void warn(const std::string &what) const override {
    if (program_->comm->me == 0)
      program_->error->warning(FLERR, of_fix(what));
  }
  void print(const std::string &what) const override {
    if (program_->comm->me != 0)
      return;
    for (FILE *to : {program_->screen, program_->logfile})
      if (to)
        fprintf(to, "%s\n", what.c_str());
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
  /* A message that names the fix. */
  Message of_fix(const std::string &what) const {
    return Message{"Fix wall/rebound (id " + id() + "): " + what};
  }

  Program *program_;
  Fix *fix_;
};

/* The fix, but for its hooks. Host is an EngineOf, or a class derived from one. */
template <class Host> class WallFix : public WallRun<Host> {
public:
  typedef typename Host::FixOfEngine EngineFix;
  using WallRun<Host>::WallRun;
  using WallRun<Host>::attempt;
  using WallRun<Host>::fail;
  using WallRun<Host>::wall;

  /* What is wrong with a fix that ties particles to bodies; "": nothing. True if a fix changes the
   * size or the shape of the box. */
  virtual std::string body_error(const EngineFix *fix) const = 0;
  virtual bool changes_box(const EngineFix *fix) const = 0;

  /* Checks the atom style; before a run, what the engine has besides; and at its set-up the wall's
   * shapes. The last two are collective and throw an Error. */
  virtual void check_atoms() const = 0;
  virtual void prepare() = 0;
  virtual void set_up_shapes() = 0;

  /* Declares the fix's outputs to the engine; call when its wall is known. */
  void set_flags() {
    auto *fix = this->fix_;
    fix->scalar_flag = fix->vector_flag = fix->array_flag = 1;
    fix->size_vector = Books::N_COUNTERS;
    fix->size_array_rows = static_cast<int>(wall.setup.shapes.size());
    fix->size_array_cols = Books::N_TOTALS;
    fix->global_freq = 1;
    fix->extscalar = fix->extvector = fix->extarray = 1;
    fix->restart_global = fix->restart_peratom = fix->create_attribute = 1;
    fix->peratom_flag = fix->peratom_freq = 1;
    fix->size_peratom_cols = Wall::N_STATE;
    fix->nevery = 1;
    fix->force_reneighbor = this->deletes();
    fix->next_reneighbor = -1;
    if (Ledger *ledger = wall.books.ledger()) {
      fix->local_flag = 1;
      fix->local_freq = static_cast<int>(ledger->every());
      fix->size_local_rows = 0;
      fix->size_local_cols = ledger->columns();
    }
  }

  /* others: the atom style has particles that are no spheres. styles: those to use. */
  void check_particles(bool others, const char *styles) const {
    const auto *atom = this->program_->atom;
    const auto *domain = this->program_->domain;
    if (!atom->radius_flag || !atom->rmass_flag || others)
      fail(text("the atom style is '%s'; particles must be spheres with a radius and a density, by "
                "'atom_style %s'",
                atom->atom_style, styles));
    if (!atom->tag_enable)
      fail("particles have no tags, which the draws depend on; use 'atom_modify id yes'");
    if (domain->triclinic && (domain->xperiodic || domain->yperiodic || domain->zperiodic))
      fail("the box is triclinic and periodic; a periodic box must be orthogonal");
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
      const std::string wrong = body_error(fix);
      const std::string name = std::string("fix ") + fix->style + " (id " + fix->id + ")";
      const std::string style = without_suffix(fix->style);
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
      throw Error("takes no model: '" + std::string(words.left_over()[0]) +
                  "' and what is behind it belong to 'fix wall/gran'; here 'rebound' states the "
                  "law");
  }

  /* Takes away what the wall deletes. */
  void delete_particles() {
    auto *atom = this->program_->atom;
    if (!this->deletes())
      return;
    this->list_deleted();
    long long mine = 0, all;
    for (int i = 0; i < atom->nlocal;) {
      if (this->is_deleted(i)) {
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
    atom->natoms -= all;
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
};

/* The functions of a fix that are the same in both engines. Contacts are worked out in
 * post_integrate, when particles and meshes are where the step has taken them and before the forces
 * are computed there: so that forces, ghosts and neighbor lists see where particles are after their
 * rebounds. */
template <class Fix, class Host> class WallHooks : public Fix {
public:
  using Fix::Fix;

  void init() override {
    WallFix<Host> &own = wall_fix();
    own.walls.clear();
    for (int i = 0; i < this->modify->nfix; i++)
      if (WallHooks *one = dynamic_cast<WallHooks *>(this->modify->fix[i]))
        own.walls.push_back(&one->wall_fix());
    own.check_run();
    own.check_atoms();
    own.attempt([this, &own] {
      own.prepare();
      own.wall.init(this->update->ntimestep, this->update->dt);
    });
  }
  void setup(int) override {
    WallFix<Host> &own = wall_fix();
    own.check_movers();
    own.attempt([&own] { own.set_up_shapes(); });
    own.begin(true);
  }
  void setup_pre_exchange() override {
    wall_fix().delete_particles();
  }
  void pre_exchange() override {
    wall_fix().delete_particles();
  }
  void pre_neighbor() override {
    WallFix<Host> &own = wall_fix();
    own.check_movers();
    own.list_bodies(false);
    own.wall.reorder(own.spheres());
  }
  void post_integrate() override {
    wall_fix().step();
  }
  void end_of_step() override {
    wall_fix().hold();
    wall_fix().end_step();
  }
  void post_run() override {
    wall_fix().end();
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

  /* Numbers of each particle: rows, which engines show, and memories. */
  void grow_arrays(int n) override {
    this->memory->grow(this->array_atom, n, Wall::N_STATE, "wall/rebound:array_atom");
    memories().grow(n);
    wall_fix().wall.set_rows(this->array_atom ? this->array_atom[0] : NULL);
  }
  void copy_arrays(int from, int to, int) override {
    std::copy_n(this->array_atom[from], int{Wall::N_STATE}, this->array_atom[to]);
    memories().copy(from, to);
  }
  void set_arrays(int i) override {
    std::fill_n(this->array_atom[i], int{Wall::N_STATE}, 0.0);
    memories().clear(i);
  }
  int pack_exchange(int i, double *buffer) override {
    std::copy_n(this->array_atom[i], int{Wall::N_STATE}, buffer);
    return Wall::N_STATE + memories().pack(i, buffer + Wall::N_STATE);
  }
  int unpack_exchange(int i, double *buffer) override {
    std::copy_n(buffer, int{Wall::N_STATE}, this->array_atom[i]);
    return Wall::N_STATE + memories().unpack(i, buffer + Wall::N_STATE);
  }
  /* The engines' restart format: the length first, which counts itself. */
  int pack_restart(int i, double *buffer) override {
    const int count = 1 + pack_exchange(i, buffer + 1);
    buffer[0] = count;
    return count;
  }
  void unpack_restart(int i, int nth) override {
    double *saved = this->atom->extra[i];
    for (; nth > 0; nth--)
      saved += static_cast<int>(*saved);
    unpack_exchange(i, saved + 1);
  }
  int size_restart(int i) override {
    double packed[SAVED_MOST];
    return pack_restart(i, packed);
  }
  int maxsize_restart() override {
    return SAVED_MOST;
  }
  double memory_usage() override {
    return wall_fix().wall.bytes() +
           static_cast<double>(this->atom->nmax * sizeof(double) * Wall::N_STATE);
  }

protected:
  static const int SENT_MOST = Wall::N_STATE + PACKED_MOST, SAVED_MOST = 1 + SENT_MOST;

  virtual WallFix<Host> &wall_fix() = 0;

  /* At the end of the fix's constructor, and in its destructor. */
  void add_rows() {
    grow_arrays(this->atom->nmax);
    for (int i = 0; i < this->atom->nlocal; i++)
      set_arrays(i);
    for (int kind : {0, 1}) /* of arrays, and of restart files */
      this->atom->add_callback(kind);
  }
  void remove_rows() {
    for (int kind : {0, 1})
      this->atom->delete_callback(this->id, kind);
    this->memory->destroy(this->array_atom);
  }

private:
  Memories &memories() {
    return wall_fix().wall.rows;
  }
};

} // namespace asperity
