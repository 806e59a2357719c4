/* A rough wall in a simulation: the contacts of its particles in each step, its stuck particles,
 * counters, ledger, and restart data. It does not depend on an engine.
 *
 * A contact is an event on the straight path of a step, found before the forces of that step are
 * computed. The particle continues from there with its new velocity for the rest of the step,
 * through any number of contacts on any number of walls. All walls of a run are computed together.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_WALL_WALL_H
#define ASPERITY_WALL_WALL_H

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "dem/engine.h"
#include "dem/ledger.h"
#include "dem/model.h"
#include "dem/particle_state.h"
#include "dem/record.h"
#include "dem/shape.h"
#include "dem/sustained.h"
#include "dem/words.h"

namespace asperity {

/* Relative rounding of velocities, times and distances that are compared. */
const double ROUNDING = 1e-9;

class Wall {
public:
  /* Numbers of each particle that the engine keeps: a ParticleState and a ParticlePlace. */
  static const int N_STATE = sizeof(ParticleState) / sizeof(double);
  static const int N_PLACE = sizeof(ParticlePlace) / sizeof(double);

  enum Counter {
    N_IMPACTS,
    N_DEPOSITS,
    DEPOSITED_MASS,
    N_LATER_HITS,
    N_CAPPED,
    N_GUARDED,
    FORCE,              /* on the wall, in the last step: three numbers */
    TORQUE = FORCE + 3, /* the same about the point of `torque_about` */
    DISSIPATED = TORQUE + 3,
    ERODED,
    IMPULSE,                       /* on the wall so far: three numbers */
    ANGULAR_IMPULSE = IMPULSE + 3, /* the same of the torque */
    N_COUNTERS = ANGULAR_IMPULSE + 3
  };

  /* Sums of each piece of a shape, in the order in which Wall::count and Wall::add fill them. A
   * shape has the same, with its deposits as the second number. */
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

  explicit Wall(const Engine &engine);

  /* Adds a shape, of atoms of wall_type, with `pieces` triangles numbered from 0 (0: one piece),
   * and a name by which restart files refer to it. */
  void add_shape(std::unique_ptr<Shape> shape, int wall_type, size_t pieces,
                 const std::string &name);
  size_t shapes() const {
    return shapes_.size();
  }

  /* Reads the rest of the command. geometry: the words before it, for messages. own: the engine's
   * own keywords, or NULL. */
  void parse(Words &words, const std::string &geometry, OwnKeywords *own = NULL);

  /* Before a run, and at its beginning, when all particles are where they belong; collective. */
  void init(int64_t step, double dt);
  void setup(const Spheres &spheres, int groupbit, const Box &box);

  /* The rows of this rank's particles, N_STATE and N_PLACE each. */
  void set_rows(double *state, double *place) {
    state_ = reinterpret_cast<ParticleState *>(state);
    place_ = reinterpret_cast<ParticlePlace *>(place);
  }

  /* Call when the box may have changed its size since setup(). */
  void set_box(const Box &box) {
    box_ = box;
  }

  /* Discards all predictions; call when particles may have grown. */
  void look_anew();

  /* After particles have moved between ranks, or have been put into another order. */
  void reorder(const Spheres &spheres);

  /* All contacts of a step of all walls of a run; their rows must be set. */
  static void step(const std::vector<Wall *> &walls, const Spheres &spheres);

  /* The end of a step, after its forces, for all walls of a run; their rows must be set. */
  static void hold(const std::vector<Wall *> &walls, const Spheres &spheres);

  /* True if particles of this rank are to be deleted. */
  bool has_to_delete() const {
    return has_to_delete_;
  }
  bool is_to_delete(int i) const {
    return status(i) == Status::TO_DELETE;
  }

  /* The ledger's windows, and warnings at output; collective. */
  void end_step(int64_t step, bool output);
  void end_run();

  void reset_dt(int64_t step, double dt);
  void reset_step(int64_t now, int64_t before);

  /* By the wall's own clock, which restarts and reset_step() do not disturb; after init(). */
  bool is_at_rest(int i) const {
    return status(i) == Status::RESTING;
  }
  double time(double step) const;

  const Model &model() const {
    return model_;
  }
  Ledger *ledger() {
    return ledger_.get();
  }
  const std::string &geometry() const {
    return geometry_;
  }

  /* Sums over the ranks; collective. All of them are summed up at once, when the first is asked
   * for after a change. */
  double counter(int k) const;
  double total(size_t shape, int k) const;
  double worn_density(size_t shape) const {
    return model_.worn_density(shapes_[shape].wall_type);
  }
  double stuck() const;                         /* how many particles are, now */
  std::vector<double> sums(size_t shape) const; /* N_SUMS each piece, on all ranks */
  /* The same, some pieces at a time: their first one, and theirs. */
  void show_sums(size_t shape,
                 const std::function<void(size_t, const std::vector<double> &)> &show) const;

  double bytes() const;

  /* Saves and restores the wall's restart data, on rank 0; restore before init(). Collective. Both
   * throw an Error if they fail. */
  std::vector<char> save();
  void restore(const char *record);

  static const char KEYWORDS[];

private:
  /* The time of the ledger: an engine's own may begin anew after a restart. dt 0: not set yet. */
  struct Clock {
    double time, step, dt;
  };

  /* Numbers, 0 at first, that take memory only where one of them has been changed. */
  class Sums {
  public:
    explicit Sums(size_t count);
    size_t size() const {
      return count_;
    }
    double *data() const {
      return numbers_.get();
    }

  private:
    size_t count_;
    std::unique_ptr<double[], void (*)(void *)> numbers_;
  };

  struct Member {
    std::unique_ptr<Shape> shape;
    std::string name; /* of a mesh; empty for a shape of one piece */
    int wall_type;
    bool measures;
    double totals[N_TOTALS];
    Sums sums;
    void add(int piece, Sum first, int count, const double values[]);
  };

  /* A contact that is not counted yet. */
  struct Event {
    Wall *wall;
    size_t shape;
    Contact contact;
    double v1[3];         /* relative to the wall */
    double omega1[3];     /* before the impact */
    double elapsed, time; /* of the step; of the ledger */
    bool grazes;          /* the particle was staying at the wall */
    asp_key key;
    asp_impact impact;
  };

  /* The contacts of one particle in one step. */
  struct Flight;

  /* A contact with a shape at the end of a path, and the face of the rough wall there. */
  struct Site {
    size_t shape;
    Path before;
    const Contact &contact;
    double press;       /* acceleration that presses the particle to the wall; may be negative */
    FacePlace *face;    /* NULL: the wall is smooth */
    bool is_new, moved; /* a face not met yet; the particle has come to it along the wall */
  };

  /* For each particle, the first step in which it may touch if it keeps this velocity, not counting
   * faces at which it stays. Negative: it stays, and is near others until that step. */
  struct Ahead {
    int now; /* steps are counted from the beginning of the run */
    std::vector<int> due;
    std::vector<float> v;     /* rows of three */
    std::vector<int64_t> tag; /* of whom this is */
  };

  /* A particle that may touch a wall in this step, which has this number among those of the run. */
  struct Near {
    int i, wall;
    bool operator<(const Near &other) const {
      return i < other.i || (i == other.i && wall < other.wall);
    }
  };

  /* A stuck particle before it gets its wall's velocity. */
  struct Held {
    double v[3], spin[3];
    Held(const Spheres &spheres, int i);
  };

  /* The fastest particle of this rank in this run, by its radii per time. */
  struct Fastest {
    double ratio, d_p, speed;
  };

  ParticleState &state(int i) const {
    return state_[i];
  }
  ParticlePlace &place(int i) const {
    return place_[i];
  }
  Status status(int i) const {
    return static_cast<Status>(static_cast<int>(state_[i].status));
  }
  void set_status(int i, Status now) {
    state_[i].status = static_cast<double>(now);
  }
  bool is_stuck(int i) const {
    return status(i) == Status::STUCK || status(i) == Status::TO_DELETE;
  }
  void set_clock(int64_t step, double dt);
  std::string heading() const;
  Settings settings() const;

  /* ahead.cpp */
  void find_near(const Spheres &spheres, int number, std::vector<Near> &near);
  bool look_ahead(const Spheres &spheres, int i);
  bool repeats() const;
  void check_box() const;
  Faces faces(int i, size_t shape) const;
  int steps_clear(const Spheres &spheres, int i) const;

  /* step.cpp */
  void begin_step(const Spheres &spheres, int number, std::vector<Near> &near);
  static bool find_first(const std::vector<Wall *> &walls, const Flight &flight, Wall *&wall,
                         size_t &shape, Contact &contact);
  static void list_known(const std::vector<Wall *> &walls, Flight &flight);
  static bool find_known(Flight &flight, Wall *&wall, size_t &shape, Contact &contact);
  static void search_all(const std::vector<Wall *> &walls, Flight &flight);
  static void look_next(const std::vector<Wall *> &near, const Flight &flight);
  static void fly(const std::vector<Wall *> &walls, const std::vector<Wall *> &near,
                  const Spheres &spheres, int i);
  static void finish(const std::vector<Wall *> &near, Flight &flight, bool moved);
  bool touch(Flight &flight, size_t shape, Contact &contact, bool trapped);
  bool is_sustained(Flight &flight, size_t shape, Contact &contact, const double v1[3],
                    double &press, bool &arrives) const;
  Event event_at(const Flight &flight, const Site &site, const double v1[3]);
  Event hit(const Flight &flight, const Site &site, const double v1[3]);
  asp_particle at_site(const Flight &flight, const Site &site, double lay[3]) const;

  /* faces.cpp */
  void find_face(const Flight &flight, Site &site);
  asp_key next_key(const Spheres &s, int i);
  const FacePlace &valley(const Flight &flight, const Site &site, const double v1[3]);
  bool is_low(const Flight &flight, const Site &site, const double v1[3]);
  void lose_bounce(const Flight &flight, const Site &site, const double v1[3]);
  double hold_of(const Flight &flight, const Site &site, const double v1[3], bool stays);
  void brake(Flight &flight, const Site &site, const double to[3], const double spin[3],
             double v1[3]);
  void stop_along(Flight &flight, const Site &site, double v1[3]);
  bool graze(Flight &flight, const Site &site, double v1[3], Event &event);
  double hold_of(const Spheres &s, int i, const Support &support, const double spin[3]) const;

  /* hold.cpp */
  void keep_resting(int i, size_t shape, const Contact &contact);
  static void hold_resting(const std::vector<Wall *> &walls, const Spheres &spheres, int i);
  static void note_energy(const Flight &flight);
  void balance(const Spheres &spheres, int i);

  /* tally.cpp */
  void add(size_t shape, const ContactLoad &load);
  void add_held(const Spheres &spheres, int i, const Held &before);
  void count(const Spheres &spheres, int i, const Event &event);
  void record(const Spheres &spheres, int i, const Event &event, const ContactLoad &load);

  /* stick.cpp */
  void stick(Flight &flight, size_t shape, const Path &before, const Contact &contact);
  void carry(const Spheres &spheres);
  void carry_one(const Spheres &spheres, int i, double dt);
  int shape_now(double before) const;
  void renumber(const Spheres &spheres);

  void restore_shapes(const WallState &saved);
  void parse_interlock(Words &words);
  void parse_ledger(Words &words);
  double number(size_t k) const;
  void check_written(const std::string &wrong) const;
  void check_speeds(const Spheres &spheres);
  void warn_of_speeds();

  const Engine &engine_;
  Model model_;
  std::string geometry_;
  std::vector<Member> shapes_;
  std::unique_ptr<Ledger> ledger_;
  uint32_t key_, stay_key_; /* of the draws: of impacts, and of particles that stay */
  bool interlocks_;         /* valleys hold particles */
  int groupbit_;
  Box box_;
  ParticleState *state_;
  ParticlePlace *place_;
  std::vector<int> stuck_;
  std::vector<int> touching_; /* those that stay or have rebounded in this step */
  std::vector<int> rested_;   /* the same of the step before */
  Ahead ahead_;
  double travel_;               /* of the wall's fastest point in a step, at most */
  double stray_;                /* how far a particle may stray from its predicted path in a step */
  double bend_;                 /* how far sustained contacts may bend its way within a step */
  double counters_[N_COUNTERS]; /* force and torque as impulses */
  double torque_about_[3];
  mutable std::vector<double> numbers_; /* counters and totals of all ranks; empty: out of date */
  Clock clock_;
  Fastest fastest_;
  double dt_;
  std::vector<int>
      shape_now_; /* of a restart: the shape, from 1, that was each of the saved ones */
  bool warned_, cut_, has_to_delete_; /* cut: a particle had too many contacts in a step */
};

} // namespace asperity

#endif
