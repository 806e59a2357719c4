/* Results of contacts at a wall: its counters, force and torque, the sums of its shapes and
 * triangles, and its ledger. Every load comes through add_load().
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "contact/vector.h"
#include "dem/books/ledger.h"
#include "dem/books/record.h"
#include "dem/text.h"
#include "dem/setup.h"
#include "dem/step/memory.h"

namespace asperity {

struct Wall;

/* An impact that is to be counted. */
struct Impact {
  Wall *wall;
  size_t shape;
  Contact contact;
  double v1[3];     /* relative to the wall */
  double omega1[3]; /* before the impact */
  double time;      /* of the ledger */
  double elapsed;   /* of the step */
  bool grazes;      /* the mover was resting at the wall */
  asp_key key;
  asp_impact result;
  ContactLoad load;
  double mass, d_p;   /* of the mover, and of the sphere */
  double temperature; /* of the particle, K; 0: unknown */
  int64_t step;
  int64_t body;    /* number of the body that the particle is part of, from 1; 0: none */
  double lever[3]; /* from the body's center of mass to the particle's center */
};

class Books {
public:
  enum Counter {
    N_IMPACTS,
    N_DEPOSITS,
    DEPOSITED_MASS,
    N_LATER_HITS,
    N_CAPPED,
    N_GUARDED,
    FORCE,              /* on the wall, in the last step that has ended: three numbers */
    TORQUE = FORCE + 3, /* the torque about the point of `torque_about` */
    DISSIPATED = TORQUE + 3,
    ERODED,
    IMPULSE,                       /* on the wall so far: three numbers */
    ANGULAR_IMPULSE = IMPULSE + 3, /* that of the torque */
    N_COUNTERS = ANGULAR_IMPULSE + 3
  };

  /* Sums of each piece of a shape, in the order in which count() and add_load() fill them. A shape
   * has totals of them all, with its deposits as the second number. */
  enum Sum {
    SUM_IMPACTS,
    SUM_MASS,
    SUM_ENERGY,
    SUM_NORMAL,     /* impulses on the wall along the normal */
    SUM_TANGENTIAL, /* and the lengths of those across it */
    SUM_DISSIPATED,
    SUM_ERODED, /* mass of the wall */
    N_SUMS
  };
  static const char *const SUM_NAMES[N_SUMS];
  enum Total { SHAPE_DEPOSITS = 1, N_TOTALS = N_SUMS + 1 };

  /* rows: what this rank's particles remember. */
  Books(const Setup &setup, Memories &rows);

  /* A shape of the setup, after it was added there. */
  void add_shape();

  /* Reads one of the books' own keywords and its values, if one comes next. */
  bool parse(Words &words);
  std::string torque_about() const;

  /* At the beginning of a run: opens the ledger's file; collective. */
  void init();
  void begin_run();

  /* After particles have changed places: how many there are. */
  void reorder(int n);

  /* Until end_loads(), FORCE and TORQUE are those of the step before; until begin_end(), the forces
   * of particles are. */
  void begin_step(int64_t step);
  void begin_end();
  void end_loads();
  bool is_in_step() const {
    return is_in_step_;
  }
  /* An impact, with its load. */
  void count(const Impact &impact);
  void add_load(size_t shape, const ContactLoad &load);

  /* keep_load: repeats this load of a stuck particle, at x, from v, with this mass, in every half
   * step. drop_load: stops repeating it; `share` of the current step has passed. show_kept: the
   * particle's force, in the first step at its end. add_kept_loads: adds all repeated loads once.
   */
  void keep_load(int i, const double x[3], const double v[3], double mass);
  void drop_load(int i, const double x[3], const double v[3], double mass, double share);
  void show_kept(int i) {
    aspi_scale(2, rows_.state[i].force);
  }
  void add_kept_loads() {
    add_impulses(kept_);
  }
  void count_guarded() {
    counters_[N_GUARDED]++;
  }
  /* Voids the numbers of all ranks that are kept; call when this rank's may have changed. */
  void expire() {
    numbers_.clear();
  }

  /* The ledger's windows; collective. */
  void end_step(int64_t step);
  void end_run();

  Ledger *ledger() const {
    return ledger_.get();
  }

  /* Sums over the ranks; collective. All of them are summed up at once, when the first is asked
   * for after a change. */
  double counter(int k) const;
  double total(size_t shape, int k) const;
  std::vector<double> sums(size_t shape) const; /* N_SUMS each piece, on all ranks */
  /* Shows them some pieces at a time: their first one, and theirs. */
  void show_sums(size_t shape,
                 const std::function<void(size_t, const std::vector<double> &)> &show) const;

  size_t bytes() const;

  /* For a restart file, and from one; before init(). A mesh's totals and sums are restored where
   * the mesh is still there. */
  void save(WallState &state);
  void restore(const WallState &saved);
  void restore_mesh(size_t shape, const MeshState &mesh);

private:
  struct ShapeSums {
    bool measures;
    double totals[N_TOTALS];
    size_t size; /* of the sums of all pieces, which take memory only where they were changed */
    std::unique_ptr<double[], void (*)(void *)> sums;
    void add_values(int piece, Sum first, int count, const double values[]);
  };

  void parse_ledger(Words &words);
  void check_written(const std::string &wrong) const;
  void record(const Impact &impact);
  double number(size_t k) const;

  /* An impulse and its torque. */
  struct Impulses {
    double p[3], turn[3];
  };
  void add_force(int i, const double p[3], const double point[3]);
  Impulses impulses_at(const double point[3], const double p[3]) const;
  void add_impulses(const Impulses &all);

  const Setup &setup_;
  Memories &rows_;
  bool is_in_step_;                   /* between begin_step() and begin_end() */
  std::vector<int> loaded_, waiting_; /* particles with a force; and with one of this step */
  std::vector<ShapeSums> shapes_;
  std::unique_ptr<Ledger> ledger_;
  double counters_[N_COUNTERS];
  Impulses kept_, step_; /* of the loads that are kept; of this step so far */
  double torque_about_[3];
  mutable std::vector<double> numbers_; /* counters and totals of all ranks; empty: out of date */
};

} // namespace asperity
