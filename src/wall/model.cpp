/* The physics of a rough wall as a script states it; see model.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/model.h"

#include <math.h>
#include <string.h>
#include <algorithm>

#include "wall/error.h"
#include "wall/text.h"

using namespace asperity;

const char Model::KEYWORDS[] = "surface spread rebound materials deposit seed";

namespace {

const double DEGREES = 180 / ASP_PI;

/* Diameters that the law of a map is made for, where the script says none. */
const int MAP_BINS = 6;

/* A map whose lengths differ by more than this has a lay, and must be told which way it lies. */
const double STRETCH_MOST = 1.5;

/* A yield stress that is a larger share of the modulus is beyond all solids: then the modulus is
 * probably one that was made soft for a longer step. */
const double YIELD_MOST = 0.1;

/* The first of n words, and the last one of them for all others: "7e10 2.05e11 2.05e11". */
std::string for_types(int n, const char *first, const char *other) {
  std::string values = first;
  for (int i = 1; i < n; i++)
    values += std::string(" ") + other;
  return values;
}

} // namespace

Model::Model(const Engine &engine)
    : engine_(engine), smooth_(true), r_q_(0), lambda_c_(0), lambda_along_(0), dp_bins_(16),
      tolerance_(0), d_range_(), map_lambda_2_(0), sampled_for_(HUGE_VAL), tilt_("isotropic"),
      collisions_("multiple"), said_nothing_(false), deposit_(FREEZE), seed_(1),
      profile_(NULL, asp_profile_free), map_(NULL, asp_map_free), table_(NULL, asp_cor_table_free),
      own_materials_(NULL, asp_materials_free), units_(NULL), surface_(NULL, asp_surface_free),
      wall_(asp_wall_create(NULL), asp_wall_free), is_made_(false), default_friction_(ASP_FRICTION),
      is_new_(true) {
  if (wall_)
    rebound_text_ = asp_rebound_name(asp_wall_rebound(wall_.get()));
}

/* ---- words of the script ----------------------------------------------------------------------
 */

bool Model::parse(Words &words, const std::string &others) {
  if (words.take("surface"))
    parse_surface(words);
  else if (words.take("spread"))
    parse_spread(words);
  else if (words.take("rebound"))
    parse_rebound(words);
  else if (words.take("materials"))
    parse_materials(words, std::string(KEYWORDS) + " " + others);
  else if (words.take("seed"))
    seed_ = static_cast<uint32_t>(words.whole("seed", 0, 4294967295.0));
  else if (words.take("deposit")) {
    const std::string value = words.word("the value of 'deposit'");
    if (value != "freeze" && value != "delete" && value != "off")
      throw Error("deposit is '" + value + "'; it must be freeze, delete or off");
    deposit_ = value == "freeze" ? FREEZE : value == "delete" ? DELETE : OFF;
    parse_removal(words);
  } else
    return false;
  return true;
}

void Model::parse_surface(Words &words) {
  smooth_ = words.take("smooth");
  lambda_along_ = 0;
  lay_ = Lay();
  if (smooth_)
    return;
  map_path_.clear();
  if (words.take("map")) {
    map_path_ = words.file("the file of 'surface map'");
    dp_bins_ = MAP_BINS;
    parse_bins(words);
    if (words.take("lay"))
      lay_ = Lay::read(words);
    return;
  }
  if (words.take("profile")) {
    profile_path_ = words.file("the file of 'surface profile'");
    parse_bins(words);
    return;
  }
  if (!words.take("rq"))
    throw Error("surface is '" + words.word("the value of 'surface'") +
                "'; it must be 'smooth', 'rq R lambda_c L [L_along lay ...]', 'profile FILE' or "
                "'map FILE'");
  profile_path_.clear();
  r_q_ = words.number("rq");
  if (!words.take("lambda_c"))
    throw Error("behind 'surface rq R', 'lambda_c L' is expected");
  lambda_c_ = words.number("lambda_c");
  if (words.is_number()) {
    lambda_along_ = words.number("lambda_c along the lay");
    if (!words.take("lay"))
      throw Error("behind 'lambda_c L L_along', 'lay' and its direction are expected");
    lay_ = Lay::read(words);
  } else if (words.is("lay"))
    throw Error("'lay' needs two correlation lengths, across it and along it: lambda_c L L_along");
  parse_bins(words);
}

void Model::parse_bins(Words &words) {
  if (words.take("dp_bins"))
    dp_bins_ = static_cast<int>(words.whole("dp_bins", 1, 10000));
}

/* The wall itself is made where nothing can be reported yet. */
void Model::check_memory() const {
  if (!wall_)
    throw Error("out of memory for a wall");
}

void Model::parse_spread(Words &words) {
  check_memory();
  asp_error wrong;
  spread_ = words.word("the spread model");
  if (spread_ != "auto" && !asp_spread_find(spread_.c_str(), &wrong))
    throw Error(std::string(wrong.text) + " auto");
  tolerance_ = 0;
  for (bool more = true; more;) {
    if (words.take("plane"))
      tilt_ = "plane";
    else if (words.take("isotropic"))
      tilt_ = "isotropic";
    else if (words.take("collisions")) {
      collisions_ = words.word("the value of 'collisions'");
      if (asp_wall_choose(wall_.get(), "collisions", collisions_.c_str(), &wrong))
        throw Error(wrong.text);
    } else if (words.take("tolerance")) {
      tolerance_ = words.number("tolerance");
      if (!(tolerance_ > 0) || !(tolerance_ < INFINITY))
        throw Error(text("tolerance is %g; it must be a finite D_KL > 0", tolerance_));
    } else
      more = false;
  }
  if ((spread_ == "auto") != (tolerance_ > 0))
    throw Error("'spread auto' and 'tolerance D' go together, with no other model");
}

/* The flow that takes away what sticks, in the script's units. */
void Model::parse_removal(Words &words) {
  check_memory();
  removal_text_.clear();
  asp_wall_set(wall_.get(), "remove_u_tau", 0, NULL);
  if (!words.take("remove"))
    return;
  if (deposit_ == OFF)
    throw Error("'remove' is of what sticks; it goes with deposit freeze or delete, not off");
  const Units &units = units_of(engine_.units(), "removal is", engine_.known_units());
  set_number("remove_work", asp_wall_get(wall_.get(), "remove_work") * units.joule_per_m2());
  static const char *const names[] = {"u_tau", "gas_density", "mean_free_path", "work"};
  for (bool more = true; more;) {
    more = false;
    for (const char *name : names)
      if (words.take(name)) {
        const double value = words.number(name);
        set_number(std::string("remove_") + name, value);
        removal_text_ += text(" %s %g", name, value);
        more = true;
      }
  }
  if (!(asp_wall_get(wall_.get(), "remove_u_tau") > 0) ||
      !(asp_wall_get(wall_.get(), "remove_gas_density") > 0))
    throw Error("behind 'deposit freeze remove', 'u_tau U gas_density RHO' is expected, both more "
                "than 0");
}

void Model::set_number(const std::string &name, double value) {
  asp_error wrong;
  if (asp_wall_set(wall_.get(), name.c_str(), value, &wrong))
    throw Error(wrong.text);
}

/* A law's parameters follow the law's name, or keywords of their own, some of them one for several.
 */
void Model::parse_rebound(Words &words) {
  check_memory();
  asp_error wrong;
  const std::string name = words.word("the rebound law");
  if (asp_wall_choose(wall_.get(), "rebound", name.c_str(), &wrong))
    throw Error(wrong.text);
  const asp_rebound_law *law = asp_wall_rebound(wall_.get());
  rebound_text_ = name;
  table_path_.clear();
  auto set = [&](const std::string &keyword) {
    for (int i = 0; i < asp_rebound_parameters(law); i++) {
      const asp_parameter *p = asp_rebound_parameter(law, i);
      if (keyword != asp_parameter_keyword(p))
        continue;
      double value;
      if (!*asp_parameter_words(p))
        value = words.number(asp_parameter_name(p));
      else if (asp_parameter_read(p, words.word(asp_parameter_name(p)).c_str(), &value, &wrong))
        throw Error("rebound " + name + ": " + wrong.text);
      if (asp_wall_set(wall_.get(), asp_parameter_name(p), value, &wrong))
        throw Error("rebound " + name + ": " + wrong.text);
      rebound_text_ += text(" %s %g", asp_parameter_name(p), value);
    }
  };
  set("");
  if (asp_rebound_needs_table(law))
    read_table(words.file("the file of 'rebound table'"));
  for (bool more = true; more;) {
    more = words.take("scatter_twice");
    if (more)
      asp_wall_set(wall_.get(), "scatter_twice", 1, NULL);
    for (int i = 0; i < asp_rebound_parameters(law) && !more; i++) {
      const char *keyword = asp_parameter_keyword(asp_rebound_parameter(law, i));
      more = *keyword && words.take(keyword);
      if (more)
        set(keyword);
    }
  }
}

void Model::read_table(const std::string &path) {
  asp_error wrong;
  table_path_ = path;
  const Units &units = units_of(engine_.units(), "a table is", engine_.known_units());
  table_.reset(asp_cor_table_read(path.c_str(), units.metre / units.second, &wrong));
  if (!table_)
    throw Error(wrong.text);
  asp_wall_set_table(wall_.get(), table_.get());
}

/* A name for each atom type; they end where the file or another keyword begins. */
void Model::parse_materials(Words &words, const std::string &keywords) {
  asp_error wrong;
  std::vector<std::string> names;
  while (!words.done() && !words.is_one_of("file " + keywords))
    names.push_back(words.word("a material"));
  const std::string path = words.take("file") ? words.file("the file of 'materials'") : "";
  if (static_cast<int>(names.size()) != engine_.types())
    throw Error(text("materials has %d names, and the script has %d atom types; there must be one "
                     "name for each type",
                     static_cast<int>(names.size()), engine_.types()));
  units_ = &units_of(engine_.units(), "materials are", engine_.known_units());
  own_materials_.reset(path.empty() ? NULL : asp_materials_read(path.c_str(), &wrong));
  if (!path.empty() && !own_materials_)
    throw Error(std::string("materials: ") + wrong.text);
  materials_.clear();
  materials_text_.clear();
  for (const std::string &name : names) {
    materials_.push_back(asp_materials_find(own_materials_.get(), name.c_str(), &wrong));
    if (!materials_.back())
      throw Error(std::string("materials: ") + wrong.text);
    materials_text_ += (materials_text_.empty() ? "" : " ") + name;
  }
  materials_text_ += path.empty() ? "" : " file " + path;
}

void Model::finish() {
  check_memory();
  said_nothing_ = spread_.empty() && profile_path_.empty() && map_path_.empty();
  if (spread_.empty())
    spread_ = smooth_ ? "none" : profile_path_.empty() && map_path_.empty() ? "visible" : "profile";
  if (smooth_ && spread_ == "auto")
    spread_ = "none";
  if (spread_ != "auto")
    asp_wall_choose(wall_.get(), "spread", spread_.c_str(), NULL);
  asp_wall_choose(wall_.get(), "tilt", tilt_.c_str(), NULL);
  asp_wall_choose(wall_.get(), "collisions", collisions_.c_str(), NULL);
  asp_wall_set(wall_.get(), "deposit", deposit_ != OFF, NULL);
  if (!map_path_.empty() && !smooth_)
    read_map_file();
  else if (!profile_path_.empty() && !smooth_)
    read_profile_file();
  else if (!smooth_)
    make_surface();
  if (!needs_sizes())
    make_wall();
}

/* ---- set-up -----------------------------------------------------------------------------------
 */

/* Whether the wall depends on the range of diameters, and so cannot be made before a run. */
bool Model::needs_sizes() const {
  return !smooth_ && (profile_ || (map_ && spread_ == "profile") || spread_ == "auto" ||
                      asp_spread_needs_profile(asp_wall_spread(wall_.get())));
}

void Model::set_sizes(const double range[2]) {
  d_range_[0] = range[0];
  d_range_[1] = range[1];
}

void Model::prepare(const std::vector<int> &wall_types) {
  find_materials(wall_types);
  fit_sizes();
}

/* Bins, tables and the choice of a model span the diameters that there are or will be; the span
 * never shrinks. */
void Model::fit_sizes() {
  asp_error wrong;
  double least, most;
  engine_.diameters(least, most);
  if (!(most > 0))
    return;
  if (!needs_sizes()) {
    if (surface_ && asp_surface_check(surface_.get(), most, &wrong))
      throw Error(wrong.text);
    check_sampling(least);
    return;
  }
  if (is_made_ && least >= d_range_[0] && most <= d_range_[1])
    return;
  d_range_[0] = d_range_[0] > 0 ? std::min(d_range_[0], least) : least;
  d_range_[1] = std::max(d_range_[1], most);
  asp_wall_set(wall_.get(), "d_p_least", d_range_[0], NULL);
  asp_wall_set(wall_.get(), "d_p_most", d_range_[1], NULL);
  is_new_ = true;
  make_surface();
  make_wall();
  check_sampling(least);
}

void Model::read_profile_file() {
  Reading reading;
  profile_ =
      read_profile(engine_.world(), profile_path_,
                   units_of(engine_.units(), "a profile is", engine_.known_units()).metre, reading);
  profile_report_ = reading.report;
  if (!reading.doubts.empty())
    engine_.warn("surface profile " + profile_path_ + ": " + reading.doubts);
}

/* Warns once of a measured wall that tells little about the least of the particles. */
void Model::check_sampling(double least) {
  asp_error doubt;
  asp_code code = ASP_OK;
  if (!(least < sampled_for_) || smooth_)
    return;
  sampled_for_ = least;
  if (profile_) {
    const double spacing = asp_profile_spacing(profile_.get());
    code = asp_sampling_check(least, spacing, asp_profile_points(profile_.get()) * spacing,
                              asp_surface_lambda_c(surface_.get()), &doubt);
  } else if (map_) {
    const double step_x = asp_map_step_x(map_.get()), step_y = asp_map_step_y(map_.get());
    code = asp_sampling_check(
        least, std::max(step_x, step_y),
        std::min(asp_map_columns(map_.get()) * step_x, asp_map_rows(map_.get()) * step_y),
        map_lambda_2_, &doubt);
  }
  if (code)
    engine_.warn("surface " + (map_ ? "map " + map_path_ : "profile " + profile_path_) + ": " +
                 doubt.text);
}

/* The map for all ranks, and its numbers as those of the wall. */
void Model::read_map_file() {
  asp_error wrong;
  Reading reading;
  map_ = read_map(engine_.world(), map_path_,
                  units_of(engine_.units(), "a map is", engine_.known_units()).metre, reading);
  if (!reading.doubts.empty())
    engine_.warn("surface map " + map_path_ + ": " + reading.doubts);
  r_q_ = asp_map_get(map_.get(), "s_q", &wrong);
  lambda_c_ = asp_map_get(map_.get(), "lambda_1", &wrong);
  const double along = asp_map_get(map_.get(), "lambda_2", &wrong);
  map_lambda_2_ = along;
  if (!(r_q_ > 0 && lambda_c_ > 0 && along > 0))
    throw Error("surface map " + map_path_ + ": " + wrong.text);
  if (lay_.kind == Lay::NONE && along > STRETCH_MOST * lambda_c_)
    throw Error(text("surface map %s: the wall has a lay, lambda_c %.4g across and %.4g along it; "
                     "say which way it lies: 'lay X Y Z', axial, circumferential, or an angle",
                     map_path_.c_str(), lambda_c_, along));
  lambda_along_ = lay_.kind == Lay::NONE ? 0 : along;
  map_text_ =
      text("map %s (%s), S_sk %.3g, S_ku %.3g, ", map_path_.c_str(), reading.report.c_str(),
           asp_map_get(map_.get(), "s_sk", &wrong), asp_map_get(map_.get(), "s_ku", &wrong));
  make_surface();
}

void Model::make_surface() {
  asp_error wrong;
  is_made_ = false;
  if (profile_)
    surface_.reset(
        asp_surface_create_profile(profile_.get(), d_range_[0], d_range_[1], dp_bins_, &wrong));
  else if (map_)
    surface_.reset(asp_surface_create_map(map_.get(), lambda_along_ > 0, &wrong));
  else
    surface_.reset(lambda_along_ > 0
                       ? asp_surface_create_lay(r_q_, lambda_c_, lambda_along_, &wrong)
                       : asp_surface_create(r_q_, lambda_c_, &wrong));
  if (!surface_)
    throw Error("surface " +
                (profile_ ? "profile " + profile_path_ + ": "
                 : map_   ? "map " + map_path_ + ": "
                          : std::string()) +
                wrong.text);
  if (profile_ && asp_surface_phi_r(surface_.get()) > 1)
    throw Error(text("surface profile %s: phi_r = R_q/lambda_c is %g; over 1 is no roughness: are "
                     "the units of positions and heights right (asperity surface --unit)?",
                     profile_path_.c_str(), asp_surface_phi_r(surface_.get())));
}

void Model::make_wall() {
  asp_error wrong;
  asp_wall *wall = wall_.get();
  if (spread_ == "auto") {
    double divergence;
    char why[400];
    const asp_spread_model *model =
        asp_spread_auto(surface_.get(), d_range_[0], d_range_[1], collisions_ == "multiple",
                        tolerance_, &divergence, why, sizeof why, &wrong);
    if (!model)
      throw Error("spread auto: " + std::string(wrong.text));
    asp_wall_choose(wall, "spread", asp_spread_name(model), NULL);
    choice_ = why;
  }
  if (asp_spread_needs_profile(asp_wall_spread(wall)) &&
      asp_wall_set(wall, "d_p_bins", dp_bins_, &wrong))
    throw Error(wrong.text);
  asp_wall_set_surface(wall, surface_.get());
  asp_wall_set_profile(wall, profile_.get());
  asp_wall_set_map(wall, map_.get());
  if (asp_wall_prepare(wall, &wrong))
    throw Error(wrong.text);
  is_made_ = true;
}

/* The values of a constant of the script; empty where there are none and none are needed. */
void Model::constants(const char *name, bool pairs, bool needed, const char *example,
                      std::vector<double> &values) const {
  if (engine_.constants(name, pairs, values))
    return;
  values.clear();
  if (!needed)
    return;
  const std::string line = engine_.how_to_state(name, pairs, example);
  throw Error(text("the script has no %s; name a material for each atom type, as 'materials %s' "
                   "(the command `asperity materials` lists them)",
                   name, for_types(engine_.types(), "quartz", "hastelloy-x").c_str()) +
              (line.empty() ? "" : ", or add a line such as '" + line + "'"));
}

void Model::find_materials(const std::vector<int> &wall_types) {
  const asp_rebound_law *law = asp_wall_rebound(wall_.get());
  const bool named = !materials_.empty();
  const int n = engine_.types();
  pairs_.clear();
  materials_report_ = named ? text("\n  rebound %s needs no materials", asp_rebound_name(law)) : "";
  constants("coefficientFriction", true, false, "", friction_);
  /* A mirror takes nothing from a particle that slides. */
  const double own = asp_wall_get(wall_.get(), "mu");
  default_friction_ = asp_wall_get(wall_.get(), "cor_t") >= 1 ? 0 : own >= 0 ? own : ASP_FRICTION;
  if (!asp_rebound_needs_pair(law))
    return;
  const bool constant_yield = !(asp_wall_get(wall_.get(), "yield_rate") > 0);
  std::vector<double> modulus, poisson, yield, energy, friction = friction_;
  if (named) {
    take_materials(modulus, poisson, yield);
    check_kinds(constant_yield);
  } else {
    constants("youngsModulus", false, true, for_types(n, "7e10", "2.05e11").c_str(), modulus);
    constants("poissonsRatio", false, true, for_types(n, "0.17", "0.32").c_str(), poisson);
    constants("yieldStress", false, constant_yield, for_types(n, "2e8", "2e8").c_str(), yield);
  }
  constants("surfaceEnergy", true, deposit_ != OFF && !named,
            for_types(n * n, "0.8", "0.8").c_str(), energy);
  if (named)
    take_defaults(energy, friction);
  if (friction.empty())
    friction.assign(n * n, ASP_FRICTION);
  if (energy.empty())
    energy.assign(n * n, 0);
  if (yield.empty())
    yield.assign(n, 0);
  make_pairs(modulus, poisson, yield, energy, friction);
  friction_ = friction;
  if (constant_yield)
    report_yield(wall_types);
}

/* The pair of every particle type and every wall type. */
void Model::make_pairs(const std::vector<double> &modulus, const std::vector<double> &poisson,
                       const std::vector<double> &yield, const std::vector<double> &energy,
                       const std::vector<double> &friction) {
  typedef std::unique_ptr<asp_material, void (*)(asp_material *)> Material;
  asp_error wrong;
  std::vector<Material> materials;
  const int n = engine_.types();
  for (int t = 0; t < n; t++) {
    materials.push_back(
        Material(asp_material_create(text("type %d", t + 1).c_str(), &wrong), asp_material_free));
    asp_material *m = materials.back().get();
    if (!m || asp_material_set(m, "youngs_modulus", modulus[t], &wrong) ||
        asp_material_set(m, "poissons_ratio", poisson[t], &wrong) ||
        asp_material_set(m, "yield_stress", yield[t], &wrong))
      throw Error(wrong.text);
  }
  for (int p = 0; p < n; p++)
    for (int w = 0; w < n; w++) {
      pairs_.push_back(
          Pair(asp_pair_create(materials[p].get(), materials[w].get(), &wrong), asp_pair_free));
      asp_pair *pair = pairs_.back().get();
      if (!pair || asp_pair_set(pair, "surface_energy", energy[p * n + w], &wrong) ||
          asp_pair_set(pair, "friction", friction[p * n + w], &wrong))
        throw Error(text("types %d (particle) and %d (wall): %s", p + 1, w + 1, wrong.text));
    }
}

/* The values of the named materials, in the script's units. They go before the script's constants,
 * which may be soft ones for the pair style. */
void Model::take_materials(std::vector<double> &modulus, std::vector<double> &poisson,
                           std::vector<double> &yield) {
  const double pascal = units_->pascal();
  materials_report_.clear();
  for (const asp_material *m : materials_) {
    modulus.push_back(asp_material_get(m, "youngs_modulus") * pascal);
    poisson.push_back(asp_material_get(m, "poissons_ratio"));
    yield.push_back(asp_material_get(m, "yield_stress") * pascal);
    materials_report_ +=
        text("\n  type %d: material %s, E %.6g, nu %.6g, ", static_cast<int>(modulus.size()),
             asp_material_name(m), modulus.back(), poisson.back()) +
        (yield.back() > 0 ? text("sigma_y %.6g", yield.back()) : "no sigma_y");
  }
}

/* With named materials, the constants of a pair have the command's defaults. */
void Model::take_defaults(std::vector<double> &energy, std::vector<double> &friction) {
  const size_t n_pairs = materials_.size() * materials_.size();
  if (energy.empty() && deposit_ != OFF) {
    energy.assign(n_pairs, ASP_SURFACE_ENERGY * units_->joule_per_m2());
    materials_report_ += text("\n  surfaceEnergy: %g, the default", energy[0]);
  }
  if (friction.empty()) {
    friction.assign(n_pairs, ASP_FRICTION);
    materials_report_ += text("\n  coefficientFriction: %g, the default", friction[0]);
  }
}

/* Particles that there are or will be need a yield stress, which a material for walls lacks. Their
 * density is their own: where it is not the material's, that may be a mistake. */
void Model::check_kinds(bool constant_yield) const {
  const double unit = units_->kilogram_per_m3();
  const std::vector<Engine::Kind> kinds = engine_.kinds();
  for (size_t t = 0; t < kinds.size(); t++) {
    const asp_material *m = materials_[t];
    const double density = asp_material_get(m, "density") * unit;
    if (constant_yield && kinds[t].present && !(asp_material_get(m, "yield_stress") > 0))
      throw Error(text("material '%s' is that of particles (type %d) and has no yield stress; it "
                       "must be one that has, of your own in a file, or 'rebound bons yield_rate "
                       "A'",
                       asp_material_name(m), static_cast<int>(t) + 1));
    if (!(kinds[t].most > 0))
      continue;
    const double off =
        std::max(fabs(kinds[t].least / density - 1), fabs(kinds[t].most / density - 1));
    if (off > 0.01 && is_new_)
      engine_.warn(text("the density of particles of type %d is up to %.3g %% off that of material "
                        "'%s', %g; theirs is taken",
                        static_cast<int>(t) + 1, 100 * off, asp_material_name(m), density));
  }
}

/* The speed above which a particle yields, v_y = sigma_y/sqrt(rho E_c) (Bons et al. 2017). */
void Model::report_yield(const std::vector<int> &wall_types) {
  const std::vector<Engine::Kind> kinds = engine_.kinds();
  for (size_t t = 0; t < kinds.size(); t++)
    for (int w : wall_types) {
      const int type = static_cast<int>(t) + 1;
      const asp_pair *p = pair(type, w);
      if (!kinds[t].present)
        continue;
      const double stress = asp_pair_get(p, "yield_stress"), modulus = asp_pair_get(p, "modulus");
      const std::string of = text("type %d on a wall of type %d", type, w);
      const bool is_bons = asp_wall_get(wall_.get(), "yield_rate") >= 0;
      if (kinds[t].most > 0 && is_bons)
        materials_report_ +=
            "\n  " + of +
            text(": yields above %.4g along the normal", stress / sqrt(kinds[t].most * modulus));
      if (is_new_ && stress > YIELD_MOST * modulus)
        engine_.warn(of +
                     text(": the yield stress, %g, is %.3g times the composite modulus, %g, so "
                          "that nothing yields; is the modulus one that was made soft for the "
                          "pair style? 'materials' takes real ones",
                          stress, stress / modulus, modulus));
    }
}

const asp_pair *Model::pair(int type, int wall_type) const {
  return pairs_.empty() ? NULL : pairs_[(type - 1) * engine_.types() + wall_type - 1].get();
}

double Model::friction(int type, int wall_type) const {
  return friction_.empty() ? default_friction_
                           : friction_[(type - 1) * engine_.types() + wall_type - 1];
}

bool Model::removes(int type, int wall_type, double d_p) const {
  const asp_particle particle = {d_p, 1, pair(type, wall_type), {0, 0, 0}, NULL};
  return wall() && asp_wall_removes(wall(), &particle);
}

bool Model::sticks() const {
  return deposit_ != OFF && asp_rebound_needs_pair(asp_wall_rebound(wall_.get()));
}

/* ---- texts ------------------------------------------------------------------------------------
 */

std::string Model::deposit_text() const {
  return std::string(deposit_name()) + (removal_text_.empty() ? "" : " remove" + removal_text_);
}

const char *Model::deposit_name() const {
  return deposit_ == FREEZE ? "freeze" : deposit_ == DELETE ? "delete" : "off";
}

std::string Model::surface_text() const {
  const std::string lay = lay_.kind == Lay::NONE ? "" : " lay " + lay_.text;
  return smooth_              ? "smooth"
         : !map_path_.empty() ? "map " + map_path_ + lay
         : profile_
             ? "profile " + profile_path_
             : text("rq %g lambda_c %g", r_q_, lambda_c_) +
                   (lay_.kind == Lay::NONE ? "" : text(" %g lay ", lambda_along_) + lay_.text);
}

std::string Model::heading() const {
  const std::string materials = materials_.empty() ? "" : "; materials " + materials_text_;
  return text("surface %s; spread %s; rebound %s%s; seed %u", surface_text().c_str(),
              asp_spread_name(asp_wall_spread(wall_.get())), rebound_text_.c_str(),
              materials.c_str(), seed_);
}

std::string Model::describe_surface() const {
  if (smooth_ || strcmp(asp_spread_name(asp_wall_spread(wall_.get())), "none") == 0)
    return "smooth wall";
  const asp_surface *s = surface_.get();
  std::string line =
      profile_ ? "profile " + profile_path_ + " (" + profile_report_ + "), " : map_text_;
  line += text("R_q %.4g, lambda_c %.4g, Phi_R %.4g, sigma %.4g deg before the size filter",
               asp_surface_r_q(s), asp_surface_lambda_c(s), asp_surface_phi_r(s),
               atan(asp_surface_slope_rms(s)) * DEGREES);
  if (lay_.kind != Lay::NONE)
    line += text(", lambda_c along the lay (%s) %.4g", lay_.text.c_str(), lambda_along_);
  line += text(", spread %s %s, collisions %s", asp_spread_name(asp_wall_spread(wall_.get())),
               tilt_.c_str(), collisions_.c_str());
  if (!choice_.empty())
    line += "\n  " + choice_;
  if (asp_surface_uncertainty(s) > 0)
    line += text("\n  one profile of this length leaves the mean tilt at 2 deg uncertain by about "
                 "%.2g %% of "
                 "sigma",
                 100 * asp_surface_uncertainty(s));
  if (said_nothing_)
    line +=
        "\n  spread is the default; the choice of Altmeppen et al. 2020 is 'spread weibull plane "
        "collisions single'";
  for (int i = 0; i < asp_surface_bins(s); i++)
    line += text("\n  bin %d: d_p %.4g, sigma %.4g deg", i + 1, asp_surface_bin_d_p(s, i),
                 atan(asp_surface_bin_slope(s, i)) * DEGREES);
  return line;
}

/* Whether the tilts come from a law of the rms slope alone. */
bool Model::draws_from_gaussian() const {
  const std::string model = asp_spread_name(asp_wall_spread(wall_.get()));
  return !smooth_ && model != "none" && model != "profile" && model != "traced";
}

std::string Model::news() {
  if (!is_new_ || !is_made_)
    return "";
  is_new_ = false;
  const std::string &measured = map_path_.empty() ? profile_path_ : map_path_;
  if (!measured.empty() && draws_from_gaussian())
    engine_.warn("'spread " + spread_ + "' draws from a Gaussian wall with the slopes of '" +
                 measured + "', whose own law is 'spread profile'");
  if (asp_rebound_measured(asp_wall_rebound(wall_.get())) && !smooth_)
    engine_.warn(text("the coefficients of '%s' were measured on a wall with a roughness of its "
                      "own; on a rough wall that counts twice",
                      asp_rebound_name(asp_wall_rebound(wall_.get()))));
  return text("rebound %s, deposit %s, seed %u; ", rebound_text_.c_str(), deposit_text().c_str(),
              seed_) +
         describe_surface() + materials_report_;
}

Settings Model::settings() const {
  const std::string bins = dp_bins_ == 16 ? "" : text(" dp_bins %d", dp_bins_);
  const std::string lay_setting =
      lay_.kind == Lay::NONE ? "" : " " + setting(lambda_along_) + " lay " + lay_.text;
  const std::string map_lay = lay_.kind == Lay::NONE ? "" : " lay " + lay_.text;
  const std::string surface = smooth_                 ? "smooth"
                              : !map_path_.empty()    ? "map " + map_path_ + map_lay + bins
                              : profile_path_.empty() ? "rq " + setting(r_q_) + " lambda_c " +
                                                            setting(lambda_c_) + lay_setting + bins
                                                      : "profile " + profile_path_ + bins;
  std::string spread = spread_ + " " + tilt_ + " collisions " + collisions_;
  if (tolerance_ > 0)
    spread += " tolerance " + setting(tolerance_);
  const asp_rebound_law *law = asp_wall_rebound(wall_.get());
  std::string rebound = asp_rebound_name(law) + (table_path_.empty() ? "" : " " + table_path_);
  for (int i = 0; i < asp_rebound_parameters(law); i++) {
    const char *name = asp_parameter_name(asp_rebound_parameter(law, i));
    rebound += std::string(" ") + name + " " + setting(asp_wall_get(wall_.get(), name));
  }
  return Settings{{"surface", surface},        {"spread", spread},
                  {"rebound", rebound},        {"materials", materials_text_},
                  {"deposit", deposit_text()}, {"seed", text("%u", seed_)}};
}
