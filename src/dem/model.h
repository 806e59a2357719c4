/* The wall that a script describes, created by the core, with the materials and sizes of the
 * engine's particles and the lines for the log.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <algorithm>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "asperity_engine.h"
#include "dem/engine.h"
#include "dem/text.h"

namespace asperity {

class Model {
public:
  enum Deposit { FREEZE, DELETE, OFF };

  explicit Model(const Engine &engine);

  /* Reads the clause of the description that begins here. others: words of the command that are not
   * the description's, which end a list of materials. */
  void parse(Words &words, const std::string &others);

  /* When all words are read. own_heat: each particle has a temperature of its own. */
  void finish(bool own_heat);

  /* Before a run, when particles and constants are known; collective. wall_types: of the atoms
   * that the wall's pieces are made of. */
  void prepare(const std::vector<int> &wall_types);

  /* Report for the log since the last call; empty if nothing is new. Collective. */
  std::string take_report();

  Deposit deposit() const {
    return deposit_;
  }
  uint32_t seed() const {
    return asp_wall_seed(wall_.get());
  }
  const asp_wall *wall() const {
    return wall_.get();
  }
  /* Pair of a particle type and a wall type; NULL if the law uses no materials. */
  const asp_pair *pair(int type, int wall_type) const;

  /* The coefficient of friction of a particle that rests, Coulomb's. */
  double friction(int type, int wall_type) const {
    return friction_.empty() ? default_friction_
                             : friction_[static_cast<size_t>((type - 1) * types_ + wall_type - 1)];
  }

  /* False if the law takes no energy, as that of a mirror. */
  bool dissipates() const {
    return dissipates_;
  }

  const asp_lay &lay() const {
    return lay_;
  }

  /* The density of a wall that is worn; 0 where nothing is. */
  double worn_density(int wall_type) const;

  /* Of the description, K; 0: it has none. */
  double temperature() const {
    return temperature_;
  }

  /* True if the law needs the elastic constants of particle and wall. */
  bool needs_materials() const;

  /* True if a particle may stick. If not, the law is skipped for a particle at rest. */
  bool sticks() const;

  /* Throws an Error if bodies cannot hit this wall. */
  void check_bodies() const;

  /* How the flow takes away a deposit of this size. */
  bool has_flow() const {
    return wall() && is_given("remove");
  }
  asp_removal removal(int type, int wall_type, double d_p, const asp_key &key) const;

  /* The range of diameters that the wall is made for, 0 where it depends on none; it goes into
   * restart files, so that a continued run has the same tables. */
  const double *sizes() const {
    return d_range_;
  }
  void set_sizes(const double range[2]) {
    std::copy(range, range + 2, d_range_);
  }

  /* The canonical text. */
  std::string description() const {
    return description_text(description_.get());
  }

private:
  typedef std::unique_ptr<asp_material, void (*)(asp_material *)> Material;
  typedef std::unique_ptr<asp_pair, void (*)(asp_pair *)> Pair;

  bool is_given(const char *keyword) const;
  std::string word(const char *name) const {
    return asp_description_word(description_.get(), name);
  }
  double number(const char *name) const {
    return asp_description_get(description_.get(), name);
  }
  void begin();
  void check_dimension() const;
  bool measured() const;
  void read_measured();
  void make();
  void fit_sizes();
  void constants(const char *name, bool pairs, bool needed, const char *example,
                 std::vector<double> &values) const;
  void find_materials();
  void take_named();
  void take_constants();
  void make_pairs();
  void check_kinds() const;
  void report_constant(const char *keyword, const char *name, bool of_script, double value);
  void ask(const asp_check_input &input, int type, int wall_type);
  void warn_of_doubts();
  double density(int type, const Engine::Kind &kind) const;
  std::string report(const asp_particle &particles) const;
  std::string describe_speeds() const;
  std::string describe_file() const;

  const Engine &engine_;
  std::string units_name_;
  asp_units units_;
  std::string report_, materials_report_; /* what the reader of a file found; the constants */
  double d_range_[2];
  double doubted_for_[2]; /* the least and the greatest diameter for which doubts were looked for */
  std::set<std::pair<int, std::string>> said_; /* doubts, with the type of the particles */
  Deposit deposit_;
  asp_lay lay_;
  std::unique_ptr<asp_heights, void (*)(asp_heights *)> heights_;
  std::unique_ptr<asp_description, void (*)(asp_description *)> description_;
  std::unique_ptr<asp_wall, void (*)(asp_wall *)> wall_; /* NULL until diameters are known */
  std::vector<Material> own_;                   /* of each atom type, by the script's constants */
  std::vector<const asp_material *> materials_; /* of each atom type */
  std::vector<Pair> pairs_;                     /* particle type x wall type */
  std::vector<double> friction_; /* the same; empty: neither pairs nor the script have it */
  double default_friction_;
  int types_;                       /* of atoms */
  std::vector<int> wall_types_;     /* of the wall's pieces */
  std::vector<Engine::Kind> kinds_; /* of the particles, and their least and largest diameters */
  double least_, most_, temperature_;
  bool dissipates_;
  bool is_new_;
};

} // namespace asperity
