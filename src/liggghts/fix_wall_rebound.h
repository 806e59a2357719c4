/* fix wall/rebound: rough walls for LIGGGHTS. A contact is an event: a particle that reaches the
 * wall within a step rebounds, or sticks, once, by asp_wall_impact() of the core. No physics in
 * here: this is the adapter that finds contacts, converts, moves the particle, and keeps the books.
 *
 * The base class gives the geometry (primitive and mesh walls, neighbour lists, moving meshes,
 * MPI). Instead of its loop over overlaps at the end of a step, contacts are searched along the
 * path of the step: that gives the instant of contact, the side a particle came from, and the one
 * contact that comes first where several triangles are near, independent of their order and so of
 * the ranks. The first fix of the style searches for all of them, for a particle may meet two walls
 * in one step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifdef FIX_CLASS
FixStyle(wall / rebound, FixWallRebound)
#else

#ifndef LMP_FIX_WALL_REBOUND_H
#define LMP_FIX_WALL_REBOUND_H

#include <memory>
#include <string>
#include <vector>

#include "fix_wall_gran.h"
#include "asperity.h"
#include "rebound_map.h"
#include "wall/ledger.h"
#include "wall/profile.h"
#include "wall/record.h"

namespace LAMMPS_NS {

class FixWallRebound : public FixWallGran {
public:
  FixWallRebound(class LAMMPS *, int, char **);
  ~FixWallRebound();

  int setmask();
  void post_create();
  void pre_delete(bool unfixflag);
  void init();
  void setup_pre_exchange();
  void setup(int vflag);
  void pre_initial_integrate();
  void pre_exchange();
  void pre_neighbor();
  void post_force(int vflag);
  void end_of_step();
  void post_run();
  void reset_dt();
  double compute_scalar();
  double compute_vector(int n);
  double compute_array(int row, int column);
  double memory_usage();
  void write_restart(FILE *file);
  void restart(char *buffer);

private:
  /* Columns of the per-atom properties: how often the particle has hit this wall, and whether it
   * has stuck; and, apart from these since all are looked through for stuck particles, where. */
  enum { IMPACTS, STATE, N_STATE };
  enum { STUCK_MESH, STUCK_TRIANGLE, STUCK_AT, STUCK_V = STUCK_AT + 3, N_PLACE = STUCK_V + 3 };
  enum State { FREE, FROZEN, DOOMED };
  enum Deposit { FREEZE, DELETE, OFF };
  enum Timing { EXACT, OVERLAP };

  /* The time of the ledger: LIGGGHTS's own begins anew after a restart. `dt` 0: not set yet. */
  struct Clock {
    double time, step, dt;
  };

  enum Counter {
    N_IMPACTS,
    N_DEPOSITS,
    DEPOSITED_MASS,
    N_LATER_HITS,
    N_CAPPED,
    N_GUARDED,
    N_COUNTERS
  };

  /* The columns of the global array. */
  enum Total { MESH_IMPACTS, MESH_DEPOSITS, MESH_MASS, MESH_ENERGY, N_TOTALS };

  /* A piece of wall that a particle may reach within the step. */
  struct Candidate {
    FixWallRebound *wall;
    int particle, mesh, triangle; /* local indices; mesh -1 for a primitive wall */
    int id, plane;                /* of the triangle; 0 for a primitive wall */
  };

  /* The fastest particle of this rank in this run, by its radii per time. */
  struct Fastest {
    double ratio, d_p, speed;
  };

  /* A triangle that some particle is near, and its plane. */
  struct Plane {
    int mesh, triangle, id;
    double normal[3], offset;
    double reach; /* how near it may come within a step, beyond the particle's radius */
    double distance(const double x[3]) const; /* signed */
  };

  /* A particle and one of planes_ near it. clear: how far it may go before it can touch, not above
   * 0 where that is not known. */
  struct Pair {
    int particle, plane;
    double clear;
  };

  /* A stuck particle and its velocity, which is the wall's. */
  struct Stuck {
    int particle;
    double v[3];
  };

  /* Velocities of a moving mesh's nodes; NULL for one at rest. */
  typedef MultiVectorContainer<double, 3, 3> NodeVelocities;

  /* Where a path meets a candidate. */
  struct Contact {
    const Candidate *on;
    double time; /* since the beginning of the path */
    double n[3]; /* outward unit normal, from the wall to the centre */
    double v_wall[3];
    double lift; /* how far out along n the particle has to go to touch: it overlapped before */
    bool guarded;
  };

  /* What is left of a particle's step: from x, with v, for a time. */
  struct Path {
    double x[3], v[3], left;
  };

  void parse(int narg, char **arg);
  void parse_surface(class ArgReader &args);
  void parse_bins(ArgReader &args);
  void parse_spread(ArgReader &args);
  void parse_rebound(ArgReader &args);
  void read_table(const std::string &path);
  void parse_materials(ArgReader &args);
  void parse_ledger(ArgReader &args);
  void set_clock();
  double time() const;
  bool needs_sizes() const;
  void fit_sizes();
  void make_surface();
  void make_wall();
  void announce();
  std::string heading() const;
  std::string describe_surface() const;

  void fail(const std::string &what);
  void property(const char *name, const char *style, int rows, int columns, bool needed,
                const char *example, std::vector<double> &values);
  void find_materials();
  void take_materials(std::vector<double> &modulus, std::vector<double> &poisson,
                      std::vector<double> &yield);
  void take_defaults(std::vector<double> &energy, std::vector<double> &friction);
  void check_materials(bool constant_yield);
  std::string state_id() const;
  std::string place_id() const;
  class FixPropertyAtom *add_property(const std::string &name, int columns);
  double *state(int i) const;
  double *place(int i) const;
  void check_particles();
  void check_meshes();
  void check_group();
  asperity::Settings settings() const;
  void compare_settings(const asperity::Settings &saved);
  void continue_meshes(const asperity::WallState &saved);
  void renumber_stuck();
  int64_t triangles(int m) const;
  void print(const std::string &line);
  void warn(const std::string &what);
  void tell_lost(const std::string &lost);
  void check_speeds();
  void warn_of_speeds();

  void find_siblings();
  void fetch(int i) const;
  void refresh();
  void find_velocities();
  void collect_pairs();
  int find_due();
  void find_hits(std::vector<int> &hits);
  void find_hits_primitive(std::vector<int> &hits);
  void find_candidates(int particle, double walls, std::vector<Candidate> &candidates);
  double path_of_primitive();
  void place_planes();
  double speed_of_triangle(int mesh, int triangle) const;
  bool is_stuck(int i) const;
  double from_axis(double x[3], double arm[3]);
  double gap_at(const Candidate &on, double x[3], double delta[3], double v_wall[3]);
  bool leaves(const Candidate &on, const double v[3], const double n[3]) const;
  bool moves(const Candidate &on) const;
  bool find_contact(const Candidate &on, const Path &path, double latest, Contact &contact);
  double time_to_plane(const Candidate &on, const Path &path) const;
  double cylinder_radius();
  bool find_on_cylinder(const Candidate &on, const Path &path, double latest, Contact &contact);
  bool find_overlap(const Candidate &on, const Path &path, Contact &contact);
  bool normal_of(const Candidate &on, const Path &path, const double delta[3], double n[3],
                 bool &guarded);
  bool is_earlier(const Contact &contact, const Contact &other, const Path &path) const;
  void collide(const Candidate *first, const Candidate *last);
  bool rebound(const Contact &contact, Path &path);
  void stick(const Contact &contact, const Path &path);
  void count(const Contact &contact, const double v1[3], const asp_impact &impact);
  void record(const Contact &contact, const Path &path, const double v1[3], const asp_key &key,
              const asp_impact &impact);

  void triangle_frame(int mesh, int triangle, double origin[3], double frame[3][3]);
  void settle_maps();
  void collect_stuck();
  void mark_stuck(std::vector<char> &marks) const;
  void add_stuck(int i);
  void hold(const Stuck &stuck);
  void stop_spin(const Stuck &stuck);
  void free_of_forces(const Stuck &stuck);
  void carry(Stuck &stuck);

  bool smooth_;
  double r_q_, lambda_c_;
  std::string profile_path_, profile_report_; /* empty: no profile */
  std::string geometry_;                      /* as the script has it */
  std::vector<std::string> mesh_ids_;
  int dp_bins_;
  std::string spread_;                            /* as the script has it: a model, or auto */
  double tolerance_;                              /* of auto */
  std::string table_path_;                        /* of a law that needs one */
  std::string rebound_text_;                      /* the law and what the script has set of it */
  std::string materials_text_, materials_report_; /* names and file; which values are taken */
  std::string choice_;                            /* what auto has chosen, and why */
  double d_range_[2]; /* the diameters that the bins span; 0: not known yet */
  asp_wall_spec spec_;
  Deposit deposit_;
  Timing timing_;
  uint32_t seed_, fix_key_;
  asperity::Profile profile_;
  std::unique_ptr<asp_cor_table, void (*)(asp_cor_table *)> table_;
  std::unique_ptr<asp_materials, void (*)(asp_materials *)> own_materials_;
  std::vector<const asp_material *> materials_; /* of each atom type; empty: property/global */
  const struct UnitStyle *units_;               /* of the script, where there are materials */
  std::unique_ptr<asp_surface, void (*)(asp_surface *)> surface_;
  std::unique_ptr<asp_wall, void (*)(asp_wall *)> wall_;
  std::unique_ptr<asperity::Ledger> ledger_;

  std::vector<asp_pair> pairs_;                   /* particle type x wall type, from 1 */
  class FixPropertyAtom *fix_state_, *fix_place_; /* the second one: unless deposits are off */
  std::vector<FixWallRebound *> siblings_;        /* all walls of this style, the first one leads */
  std::vector<NodeVelocities *> moving_;          /* one a mesh */
  /* The neighbour lists of the meshes, by particle, and some pairs more to look ahead to. */
  std::vector<Pair> near_;
  std::vector<int> first_;                        /* where in it a particle's pairs begin */
  std::vector<int> due_;                          /* those of near_ to look at in this step */
  std::vector<Plane> planes_;                     /* the triangles of these pairs */
  std::vector<Candidate> candidates_;             /* what may be hit in this step */
  std::vector<int> hits_;                         /* particles that may touch a wall in this step */
  std::vector<Stuck> stuck_;                      /* since the last exchange */
  std::vector<std::unique_ptr<ReboundMap>> maps_; /* one a mesh */
  std::vector<std::vector<double>> saved_maps_;   /* of a restart, until the meshes are set up */
  std::vector<int>
      mesh_now_; /* of a restart: by the saved number of a mesh, that of now; 0: none */
  std::vector<double> totals_; /* N_TOTALS a mesh; one row for a primitive wall */
  Clock clock_;
  Fastest fastest_;
  double wall_path_; /* of the wall's fastest point in a step */
  double counters_[N_COUNTERS];
  bool lists_are_new_, warned_, announced_, restarted_;
};

} // namespace LAMMPS_NS

#endif
#endif
