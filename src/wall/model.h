/* The physics of a rough wall as a script states it: surface, spread, rebound law, materials,
 * deposits and seed; and the core's wall that is made of them. Also the texts that describe it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_WALL_MODEL_H
#define ASPERITY_WALL_MODEL_H

#include <memory>
#include <string>
#include <vector>

#include "asperity.h"
#include "wall/engine.h"
#include "wall/lay.h"
#include "wall/profile.h"
#include "wall/record.h"
#include "wall/units.h"
#include "wall/words.h"

namespace asperity {

class Model {
public:
  enum Deposit { FREEZE, DELETE, OFF };

  explicit Model(const Engine &engine);

  /* Whether the next words are of the model; if so, reads them. others: keywords that are not its
   * own, which end a list of materials. */
  bool parse(Words &words, const std::string &others);
  static const char KEYWORDS[];

  /* When all words are read. */
  void finish();

  /* Before a run, when particles and constants are known; collective. wall_types: of the atoms
   * that the wall's pieces are made of. */
  void prepare(const std::vector<int> &wall_types);

  /* What is new since it was last printed, for the log; empty if nothing is. */
  std::string news();

  Deposit deposit() const {
    return deposit_;
  }
  const char *deposit_name() const;
  uint32_t seed() const {
    return seed_;
  }
  const asp_wall *wall() const {
    return is_made_ ? wall_.get() : NULL;
  }
  /* Of a particle type on a wall type; NULL where the law knows no materials. */
  const asp_pair *pair(int type, int wall_type) const;

  /* The coefficient of friction of a particle that rests, Coulomb's. */
  double friction(int type, int wall_type) const;

  /* Of a wall that has one. */
  const Lay &lay() const {
    return lay_;
  }

  /* Whether a particle may stick: where it cannot, one that rests needs no look at the law. */
  bool sticks() const;

  /* Whether a flow takes away what would stick. */
  bool removes(int type, int wall_type, double d_p) const;

  /* The range of diameters that the wall is made for, 0 where it depends on none; it goes into
   * restart files, so that a continued run has the same tables. */
  const double *sizes() const {
    return d_range_;
  }
  void set_sizes(const double range[2]);

  /* As one line: for the ledger's head. */
  std::string heading() const;

  /* What the script says, for the comparison with a restart file. */
  Settings settings() const;

private:
  void check_memory() const;
  void parse_surface(Words &words);
  void parse_bins(Words &words);
  void parse_spread(Words &words);
  void parse_rebound(Words &words);
  void parse_removal(Words &words);
  void set_number(const std::string &name, double value);
  std::string deposit_text() const;
  void parse_materials(Words &words, const std::string &keywords);
  void read_table(const std::string &path);
  bool needs_sizes() const;
  void fit_sizes();
  void read_profile_file();
  void read_map_file();
  void check_sampling(double least);
  void make_surface();
  void make_wall();
  void find_materials(const std::vector<int> &wall_types);
  void constants(const char *name, bool pairs, bool needed, const char *example,
                 std::vector<double> &values) const;
  void make_pairs(const std::vector<double> &modulus, const std::vector<double> &poisson,
                  const std::vector<double> &yield, const std::vector<double> &energy,
                  const std::vector<double> &friction);
  void take_materials(std::vector<double> &modulus, std::vector<double> &poisson,
                      std::vector<double> &yield);
  void take_defaults(std::vector<double> &energy, std::vector<double> &friction);
  void check_kinds(bool constant_yield) const;
  void report_yield(const std::vector<int> &wall_types);
  bool draws_from_gaussian() const;
  std::string surface_text() const;
  std::string describe_surface() const;

  const Engine &engine_;
  bool smooth_;
  double r_q_, lambda_c_, lambda_along_; /* along the lay; 0 where there is none */
  Lay lay_;
  std::string profile_path_, profile_report_; /* empty: no profile */
  std::string map_path_, map_text_;           /* empty: no map; what it is */
  int dp_bins_;
  std::string spread_; /* as the script has it: a model, or auto */
  double tolerance_;   /* of auto */
  std::string choice_; /* what auto has chosen, and why */
  std::string table_path_, rebound_text_, materials_text_, materials_report_, removal_text_;
  double d_range_[2];
  double map_lambda_2_, sampled_for_; /* the least diameter whose sampling was checked */
  std::string tilt_, collisions_;
  bool said_nothing_; /* of the spread of a Gaussian wall */
  Deposit deposit_;
  uint32_t seed_;
  Profile profile_;
  Map map_;
  std::unique_ptr<asp_cor_table, void (*)(asp_cor_table *)> table_;
  std::unique_ptr<asp_materials, void (*)(asp_materials *)> own_materials_;
  std::vector<const asp_material *>
      materials_;      /* of each atom type; empty: the script's constants */
  const Units *units_; /* of the script, where there are materials */
  std::unique_ptr<asp_surface, void (*)(asp_surface *)> surface_;
  std::unique_ptr<asp_wall, void (*)(asp_wall *)> wall_;
  bool is_made_; /* the wall is prepared for contacts */
  typedef std::unique_ptr<asp_pair, void (*)(asp_pair *)> Pair;
  std::vector<Pair> pairs_;      /* particle type x wall type */
  std::vector<double> friction_; /* the same; empty: neither pairs nor the script have it */
  double default_friction_;
  bool is_new_;
};

} // namespace asperity

#endif
