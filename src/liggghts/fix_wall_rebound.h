/* fix wall/rebound: rough walls for LIGGGHTS. This is LIGGGHTS's side only: its hooks, meshes,
 * constants and per-atom numbers. What both engines do is in
 * dem/wall_fix.h; what a wall does, in the rest of dem, which knows no engine.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifdef FIX_CLASS
// clang-format off
FixStyle(wall/rebound, FixWallRebound)
// clang-format on
#else

#ifndef LMP_FIX_WALL_REBOUND_H
#define LMP_FIX_WALL_REBOUND_H

#include <memory>
#include <string>
#include <vector>

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "group.h"
#include "memory.h"
#include "modify.h"
#include "output.h"
#include "update.h"
#include "bodies_liggghts.h"
#include "mesh_liggghts.h"
#include "dem/wall_fix.h"

namespace LAMMPS_NS {

struct MessageOfLiggghts {
  std::string text;
  operator const char *() const {
    return text.c_str();
  }
};

typedef asperity::EngineOf<LAMMPS, Fix, MessageOfLiggghts> EngineOfLiggghts;

class FixWallRebound : public asperity::WallHooks<Fix, EngineOfLiggghts>,
                       private asperity::WallFix<EngineOfLiggghts> {
public:
  FixWallRebound(class LAMMPS *, int, char **);
  ~FixWallRebound();

  int setmask() override;
  void post_create() override;
  void pre_delete(bool unfixflag) override;
  void setup(int vflag) override;
  void pre_initial_integrate() override;
  void pre_force(int vflag) override;
  void end_of_step() override;
  void post_run() override;
  void reset_timestep(bigint now, bigint before) override;
  int min_type() override;
  int max_type() override;

private:
  /* asperity::Engine, and asperity::WallFix */
  using EngineOf::id;
  std::string known_units() const override;
  std::string constants(const char *name, bool pairs, std::vector<double> &values) const override;
  const double *numbers(const std::string &name) const override;
  void diameters(double &least, double &most) const override;
  std::vector<Kind> kinds() const override;
  void check_atoms() const override;
  void prepare() override;
  void set_up_shapes() override;
  void begin_step() override;
  WallFix &wall_fix() override {
    return *this;
  }
  asperity::BodySource &bodies() override {
    return *bodies_;
  }
  std::string body_error(const Fix *fix) const override;
  bool changes_box(const Fix *fix) const override {
    return fix->box_change_size || fix->box_change_shape;
  }

  void check_bodies();
  void read_geometry(asperity::Words &words, std::string &geometry);
  std::string read_meshes(asperity::Words &words);
  void check_id() const;
  void check_meshes() const;
  void check_owner(const FixMeshSurface *mesh) const;
  void show_maps();

  std::vector<std::string> mesh_ids_;
  std::vector<MeshOfLiggghts *> meshes_;     /* the wall's shapes; empty: a primitive wall */
  int wall_type_[2];                         /* least and largest */
  bool is_set_up_;                           /* and no step yet */
  std::unique_ptr<BodiesOfLiggghts> bodies_; /* of the run */
};

} // namespace LAMMPS_NS

#endif
#endif
