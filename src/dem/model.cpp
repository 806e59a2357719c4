/* The wall that a script describes; see model.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/model.h"

#include <math.h>
#include <algorithm>

#include "asperity_engine.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

namespace {

/* The first of n words, and the last one of them for all others: "7e10 2.05e11 2.05e11". */
std::string for_types(int n, const char *first, const char *other) {
  std::string values = first;
  for (int i = 1; i < n; i++)
    values += std::string(" ") + other;
  return values;
}

} // namespace

Model::Model(const Engine &engine)
    : engine_(engine), units_(), d_range_(), doubted_for_{HUGE_VAL, 0}, deposit_(FREEZE), lay_(),
      heights_(NULL, asp_heights_free), description_(NULL, asp_description_free),
      wall_(NULL, asp_wall_free), default_friction_(ASP_FRICTION), types_(1), least_(0), most_(0),
      temperature_(0), dissipates_(true), is_new_(true) {}

/* ---- words of the script ---- */

bool Model::is_given(const char *keyword) const {
  return asp_description_is_given(description_.get(), keyword);
}

/* Called on first use: the constructor cannot report errors. */
void Model::begin() {
  asp_error wrong;
  if (description_)
    return;
  const std::string style = engine_.units();
  units_ = units_of(style);
  units_name_ = "'units " + style + "'; units must be " + engine_.known_units();
  units_.name = units_name_.c_str();
  description_.reset(asp_description_parse("", &units_, &wrong));
  if (!description_)
    throw_error(wrong);
  asp_description_expect_pairs(description_.get()); /* those of the types */
  if (engine_.dimension() == 2)
    asp_description_default_plane(description_.get());
}

void Model::parse(Words &words, const std::string &others) {
  asp_error wrong;
  int taken;
  const std::vector<const char *> rest = words.left_over();
  begin();
  if (asp_description_read(description_.get(), static_cast<int>(rest.size()), rest.data(),
                           others.c_str(), &taken, &wrong))
    throw_error(wrong);
  words.advance(taken);
}

void Model::finish(bool own_heat) {
  asp_error wrong;
  begin();
  if (asp_description_check(description_.get(), &wrong))
    throw_error(wrong);
  if (asp_description_check_heat(description_.get(), own_heat, &wrong))
    throw_error(wrong);
  if (own_heat && !is_given("viscosity") && !is_given("soften_modulus") &&
      !(number("soften_from") >= 0))
    throw Error("'temperature_of' has no effect with rebound " + word("rebound") +
                ", without 'viscosity' and 'soften_modulus'");
  temperature_ = is_given("temperature") ? number("temperature") : 0;
  const int names = asp_description_materials(description_.get());
  if (is_given("materials") && names != engine_.types())
    throw Error(text("materials has %d names, and the script has %d atom types; there must be one "
                     "name for each type",
                     names, engine_.types()));
  if (is_given("remove") && !is_given("u_tau"))
    throw Error("behind 'remove', 'u_tau U' is expected");
  const std::string deposit = word("deposit");
  deposit_ = deposit == "freeze" ? FREEZE : deposit == "delete" ? DELETE : OFF;
  lay_ = asp_description_lay(description_.get());
  check_dimension();
  if (measured())
    read_measured();
  if (!asp_description_needs_sizes(description_.get()))
    make();
}

/* Refuses spreads that leave the plane in two dimensions. The law of a map does, whatever the
 * script's words. */
void Model::check_dimension() const {
  if (engine_.dimension() != 2)
    return;
  if (number("lever") > 0)
    throw Error("grain is 'lever', which turns grains out of the plane of 'dimension 2'; it must "
                "be sphere");
  const std::string surface = word("surface"), tilt = word("tilt"), spread = word("spread");
  if (surface == "smooth")
    return;
  if (tilt != "plane")
    throw Error("spread is 'isotropic', which tilts out of the plane of 'dimension 2'; it must be "
                "plane");
  if (surface == "map" && spread == "traced")
    throw Error("spread is 'traced', over a map a flight in three dimensions; in 'dimension 2' it "
                "must be another model, such as visible");
  if (lay_.kind != ASP_LAY_NONE)
    throw Error(
        "the wall has a lay; in 'dimension 2' it must have none: lambda_c must be the length "
        "along the plane");
}

bool Model::measured() const {
  return asp_description_word(description_.get(), "file") != NULL;
}

/* Each rank reads the file itself. An error is all ranks', also where only some can read it. */
void Model::read_measured() {
  asp_error wrong;
  const std::string path = word("file");
  const bool is_map = word("surface") == "map";
  if (!(units_.meter > 0))
    throw Error(std::string(is_map ? "a map" : "a profile") +
                " is in SI units, which cannot be converted to " + units_name_);
  asp_error doubt;
  char report[700];
  heights_.reset(
      asp_heights_read(path.c_str(), is_map, units_.meter, report, sizeof report, &doubt, &wrong));
  int good = heights_ != NULL, all;
  if (!good && wrong.code == ASP_ENOMEM)
    throw_error(wrong); /* of this rank alone */
  MPI_Allreduce(&good, &all, 1, MPI_INT, MPI_MIN, engine_.world());
  if (!all)
    throw Error(good ? "the file '" + path + "' cannot be read by all ranks"
                     : std::string(wrong.text));
  report_ = report;
  if (doubt.code)
    engine_.warn(std::string(is_map ? "surface map " : "surface profile ") + path + ": " +
                 doubt.text);
  if (asp_description_set_heights(description_.get(), heights_.get(), &wrong))
    throw_error(wrong);
}

/* ---- set-up ---- */

void Model::make() {
  asp_error wrong;
  wall_.reset(asp_wall_create(description_.get(), d_range_[0], d_range_[1], &wrong));
  if (!wall_)
    throw_error(wrong);
  if (!needs_materials()) {
    asp_particle particle = {};
    particle.d_p = particle.density = 1;
    const double v1[3] = {1, 0, -1}, n[3] = {0, 0, 1};
    const asp_key key = {seed(), 0, 0, 0, 0};
    asp_impact impact;
    asp_wall_impact_mean(wall_.get(), &particle, v1, n, &key, &impact);
    dissipates_ = impact.v2[0] < v1[0] || impact.v2[2] < -v1[2];
  }
}

void Model::prepare(const std::vector<int> &wall_types) {
  wall_types_ = wall_types;
  kinds_ = engine_.kinds();
  engine_.diameters(least_, most_);
  find_materials();
  fit_sizes();
  warn_of_doubts();
}

/* Bins, tables and the choice of a model span the diameters that there are or will be; the span
 * never shrinks. */
void Model::fit_sizes() {
  asp_error wrong;
  if (!(most_ > 0))
    return;
  if (!asp_description_needs_sizes(description_.get())) {
    const asp_surface *surface = asp_wall_surface(wall_.get());
    if (surface && asp_surface_check(surface, most_, &wrong))
      throw_error(wrong);
    return;
  }
  if (wall_ && least_ >= d_range_[0] && most_ <= d_range_[1])
    return;
  d_range_[0] = d_range_[0] > 0 ? std::min(d_range_[0], least_) : least_;
  d_range_[1] = std::max(d_range_[1], most_);
  is_new_ = true;
  make();
}

/* The values of a constant of the script; empty where there are none and none are needed. example:
 * some values, for the message where they are. */
void Model::constants(const char *name, bool pairs, bool needed, const char *example,
                      std::vector<double> &values) const {
  const std::string line = engine_.constants(name, pairs, values);
  if (!values.empty() || !needed)
    return;
  throw Error(text("the script has no %s; name a material for each atom type, as 'materials %s' "
                   "(the command `asperity materials` lists them)",
                   name, for_types(engine_.types(), "quartz", "hastelloy-x").c_str()) +
              (line.empty() ? "" : ", or add a line such as '" + line + " " + example + "'"));
}

/* The description's constants go before the script's, which may be soft ones for the pair style. */
void Model::find_materials() {
  const int n = types_ = engine_.types();
  pairs_.clear();
  materials_.clear();
  own_.clear();
  materials_report_.clear();
  constants("coefficientFriction", true, false, "", friction_);
  const bool of_script = !friction_.empty();
  if (is_given("friction"))
    friction_.assign(static_cast<size_t>(n * n), number("friction"));
  /* A mirror takes nothing from a particle that slides. */
  const double own = number("mu");
  default_friction_ = number("cor_t") >= 1 ? 0 : own >= 0 ? own : ASP_FRICTION;
  if (own >= 0)
    friction_.clear(); /* the law's own coefficient counts in sustained contact, too */
  if (needs_materials()) {
    if (is_given("materials"))
      take_named();
    else
      take_constants();
    make_pairs();
    if (is_given("yield_stress"))
      materials_report_ += text("\n  yield_stress %g, by the description", number("yield_stress"));
  }
  if (!pairs_.empty() || is_given("friction"))
    report_constant("friction", "coefficientFriction", of_script, friction(1, 1));
}

void Model::take_named() {
  for (int t = 0; t < engine_.types(); t++) {
    const asp_material *m = asp_description_material(description_.get(), t);
    const double yield = asp_material_get(m, "yield_stress");
    materials_.push_back(m);
    materials_report_ +=
        text("\n  type %d: material %s, E %.6g, nu %.6g, ", t + 1, asp_material_name(m),
             asp_material_get(m, "youngs_modulus"), asp_material_get(m, "poissons_ratio")) +
        (yield > 0 ? text("sigma_y %.6g", yield) : "no sigma_y");
  }
  check_kinds();
}

void Model::take_constants() {
  asp_error wrong;
  const int n = engine_.types();
  const bool yields = !(number("yield_rate") > 0) && !is_given("yield_stress");
  std::vector<double> modulus, poisson, yield;
  constants("youngsModulus", false, true, for_types(n, "7e10", "2.05e11").c_str(), modulus);
  constants("poissonsRatio", false, true, for_types(n, "0.17", "0.32").c_str(), poisson);
  constants("yieldStress", false, yields, for_types(n, "2e8", "2e8").c_str(), yield);
  for (int t = 0; t < n; t++) {
    own_.push_back(
        Material(asp_material_create(text("type %d", t + 1).c_str(), &wrong), asp_material_free));
    asp_material *m = own_.back().get();
    if (!m || asp_material_set(m, "youngs_modulus", modulus[t], &wrong) ||
        asp_material_set(m, "poissons_ratio", poisson[t], &wrong) ||
        asp_material_set(m, "yield_stress", yield.empty() ? 0 : yield[t], &wrong))
      throw_error(wrong);
    materials_.push_back(m);
  }
  materials_report_ += "\n  youngsModulus, poissonsRatio" +
                       std::string(yield.empty() ? "" : " and yieldStress") + " of the script";
}

/* The pair of every particle type and every wall type. */
void Model::make_pairs() {
  asp_error wrong;
  const int n = engine_.types();
  std::vector<double> energy;
  constants("surfaceEnergy", true,
            deposit_ != OFF && !is_given("materials") && !is_given("surface_energy"),
            for_types(n * n, "0.8", "0.8").c_str(), energy);
  for (int p = 0; p < n; p++)
    for (int w = 0; w < n; w++) {
      const size_t k = static_cast<size_t>(p * n + w);
      pairs_.push_back(
          Pair(asp_description_pair(description_.get(), materials_[p], materials_[w], &wrong),
               asp_pair_free));
      asp_pair *pair = pairs_.back().get();
      if (!pair ||
          (!energy.empty() && !is_given("surface_energy") &&
           asp_pair_set(pair, "surface_energy", energy[k], &wrong)) ||
          (!friction_.empty() && asp_pair_set(pair, "friction", friction_[k], &wrong)))
        throw_error(wrong, text("types %d (particle) and %d (wall): ", p + 1, w + 1));
    }
  if (friction_.empty())
    friction_.assign(pairs_.size(), ASP_FRICTION);
  if (deposit_ != OFF)
    report_constant("surface_energy", "surfaceEnergy", !energy.empty(),
                    asp_pair_get(pairs_[0].get(), "surface_energy"));
}

/* Particles that there are or will be need a yield stress, which a material for walls lacks. */
void Model::check_kinds() const {
  if (number("yield_rate") > 0 || is_given("yield_stress"))
    return;
  for (size_t t = 0; t < kinds_.size(); t++)
    if (kinds_[t].present && !(asp_material_get(materials_[t], "yield_stress") > 0))
      throw Error(text("material '%s' is that of particles (type %d) and has no yield stress; it "
                       "must be one that has, of your own in a file, or 'yield_stress Y', or "
                       "'rebound bons yield_rate A', or 'rebound walton E MU 0 deposit off', which "
                       "needs none",
                       asp_material_name(materials_[t]), static_cast<int>(t) + 1));
}

const asp_pair *Model::pair(int type, int wall_type) const {
  return pairs_.empty() ? NULL : pairs_[(type - 1) * engine_.types() + wall_type - 1].get();
}

double Model::worn_density(int wall_type) const {
  const double own = number("density");
  if (own > 0 || !is_given("erosion") || materials_.empty())
    return own > 0 ? own : 0;
  return asp_material_get(materials_[wall_type - 1], "density");
}

asp_removal Model::removal(int type, int wall_type, double d_p, const asp_key &key) const {
  asp_particle particle = asp_particle();
  particle.d_p = d_p;
  particle.density = 1;
  particle.pair = pair(type, wall_type);
  return asp_wall_removal(wall(), &particle, &key);
}

bool Model::needs_materials() const {
  return asp_rebound_needs_pair(asp_description_rebound(description_.get()));
}

void Model::check_bodies() const {
  asp_error wrong;
  if (asp_description_check_bodies(description_.get(), &wrong))
    throw_error(wrong);
}

bool Model::sticks() const {
  return deposit_ != OFF && (needs_materials() || is_given("viscosity"));
}
