/* fix wall/rebound; see fix_wall_rebound.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "fix_wall_rebound.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <numeric>
#include <tuple>

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "error.h"
#include "fix_mesh_surface.h"
#include "fix_neighlist_mesh.h"
#include "fix_property_atom.h"
#include "fix_property_global.h"
#include "fix_template_sphere.h"
#include "group.h"
#include "modify.h"
#include "output.h"
#include "primitive_wall.h"
#include "tri_mesh.h"
#include "update.h"
#include "wall/error.h"

using namespace LAMMPS_NS;
using namespace FixConst;

/* How closely the instant of contact is found, in radii of the particle, and how many steps of
 * Newton's method that may take; a plane takes one. */
static const double GAP_TOLERANCE = 1e-10;
static const int NEWTON_MAX = 50;

/* How many pairs ahead the rows of their particles are asked for. */
static const int FETCH_AHEAD = 64;

/* The same for the states of particles, one after the other. */
static const int STATES_AHEAD = 512;

/* How many times one particle may hit the wall within one step. */
static const int CONTACTS_MAX = 16;

/* A particle leaves a triangle where the sine of its angle to it is larger than this: the distance
 * is convex along the path, so it grows from there on. At less, rounding might say otherwise: that
 * of a mesh at its edges, above all. */
static const double LEAVES = 0.01;

/* Inside a cylinder, a particle slides that approaches with less than this share of its speed. */
static const double SLIDES = 1e-6;

/* As the script has them. */
static const char *const DEPOSITS[] = {"freeze", "delete", "off"};

static const char KEYWORDS[] = "surface spread rebound materials deposit seed timing ledger";

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* A particle's row in an array of the atoms. Rows lie one behind the other; the pointers to them,
 * in an array of their own, would each have to come from far away first. */
static double *row_of(double **array, int columns, int i) {
  return array[0] + static_cast<ptrdiff_t>(columns) * i;
}

static std::string text(const char *format, ...) {
  char line[600];
  va_list args;
  va_start(args, format);
  vsnprintf(line, sizeof line, format, args);
  va_end(args);
  return line;
}

namespace LAMMPS_NS {

/* Reads the arguments behind the geometry one by one; says what is missing or wrong. */
class ArgReader {
public:
  ArgReader(int narg, char **arg, int first) : narg_(narg), arg_(arg), next_(first) {}

  bool done() const {
    return next_ >= narg_;
  }
  bool is(const char *word) const {
    return !done() && strcmp(arg_[next_], word) == 0;
  }
  bool is_one_of(const std::string &words) const {
    return !done() && (" " + words + " ").find(" " + std::string(arg_[next_]) + " ") != words.npos;
  }
  bool take(const char *word) {
    if (!is(word))
      return false;
    next_++;
    return true;
  }
  std::string word(const char *what) {
    if (done())
      throw text("%s is missing at the end of the command", what);
    return arg_[next_++];
  }
  double number(const char *what) {
    std::string value = word(what);
    char *end;
    double number = strtod(value.c_str(), &end);
    if (value.empty() || *end)
      throw text("%s is '%s'; a number is expected", what, value.c_str());
    return number;
  }
  double whole(const char *what, double least, double most) {
    double value = number(what);
    if (!(value >= least && value <= most) || value != floor(value))
      throw text("%s is %.15g; allowed is a whole number, %.0f to %.0f", what, value, least, most);
    return value;
  }

private:
  int narg_;
  char **arg_;
  int next_;
};

/* A unit style of LIGGGHTS: how many of its units make one of SI. */
struct UnitStyle {
  const char *name;
  double metre, kilogram, second;

  double kilogram_per_m3() const {
    return kilogram / (metre * metre * metre);
  }
  double pascal() const {
    return kilogram / (metre * second * second);
  }
  double joule_per_m2() const {
    return kilogram / (second * second);
  }
};

} // namespace LAMMPS_NS

/* The base class reads the geometry before anything of ours runs, and trusts that every argument is
 * there. So the words are counted here first. */
static char **check_geometry(LAMMPS *lmp, int narg, char **arg) {
  std::string wrong;
  if (narg < 4)
    wrong = "the wall is missing; allowed is 'mesh n_meshes N meshes id1 ...' or "
            "'primitive type T style args'";
  else if (strcmp(arg[3], "primitive") == 0) {
    if (narg < 7 || strcmp(arg[4], "type") != 0)
      wrong = "behind 'primitive', 'type T style args' is expected";
    else if (PRIMITIVE_WALL_DEFINITIONS::numArgsPrimitiveWall(arg[6]) == 0)
      wrong = text("primitive wall '%s' is unknown; there are: xplane yplane zplane xcylinder "
                   "ycylinder zcylinder",
                   arg[6]);
  } else if (strcmp(arg[3], "mesh") == 0) {
    int count = narg > 5 ? atoi(arg[5]) : 0;
    if (narg < 7 || strcmp(arg[4], "n_meshes") != 0 || strcmp(arg[6], "meshes") != 0)
      wrong = "behind 'mesh', 'n_meshes N meshes id1 ...' is expected";
    else if (count < 1 || narg < 7 + count)
      wrong = text("n_meshes is '%s', with %d words behind 'meshes'; allowed is a number >= 1, and "
                   "as many mesh ids",
                   arg[5], narg - 7);
    for (int i = 7; wrong.empty() && i < 7 + count; i++) {
      int found = lmp->modify->find_fix(arg[i]);
      if (found < 0 || strncmp(lmp->modify->fix[found]->style, "mesh/surface", 12) != 0)
        wrong = text("mesh '%s' does not exist; define it before the wall, by 'fix %s all "
                     "mesh/surface file FILE.stl type T'",
                     arg[i], arg[i]);
    }
  } else
    wrong = text("the wall is '%s'; allowed is 'mesh' or 'primitive'", arg[3]);
  if (!wrong.empty())
    lmp->error->all(FLERR, ("Fix wall/rebound (id " + std::string(arg[0]) + "): " + wrong).c_str());
  return arg;
}

static const UnitStyle UNIT_STYLES[] = {
    {"si", 1, 1, 1}, {"cgs", 1e2, 1e3, 1}, {"micro", 1e6, 1e15, 1e6}};

static const UnitStyle &units_of(const char *style, const char *what) {
  for (const UnitStyle &units : UNIT_STYLES)
    if (strcmp(style, units.name) == 0)
      return units;
  throw text("%s in SI units, which cannot be converted to 'units %s'; allowed is units si, cgs or "
             "micro",
             what, style);
}

/* The words of the geometry, numbers in one form. */
static std::string geometry_of(char **arg, int end) {
  std::string geometry = arg[3];
  for (int i = strcmp(arg[3], "mesh") == 0 ? 7 : 4; i < end; i++) {
    char *rest;
    const double value = strtod(arg[i], &rest);
    geometry += std::string(" ") + (*rest ? arg[i] : asperity::setting(value));
  }
  return geometry;
}

/* ---- making ---------------------------------------------------------------------------------- */

FixWallRebound::FixWallRebound(LAMMPS *engine, int narg, char **arg)
    : FixWallGran(engine, narg, check_geometry(engine, narg, arg)), smooth_(true), r_q_(0),
      lambda_c_(0), dp_bins_(16), tolerance_(0), d_range_(), spec_(asp_wall_spec_default()),
      deposit_(FREEZE), timing_(EXACT), seed_(1), fix_key_(asp_key_fix(id)),
      profile_(NULL, asp_profile_free), table_(NULL, asp_cor_table_free),
      own_materials_(NULL, asp_materials_free), units_(NULL), surface_(NULL, asp_surface_free),
      wall_(NULL, asp_wall_free), fix_state_(NULL), fix_place_(NULL), clock_(), fastest_(),
      wall_path_(0), counters_(), lists_are_new_(true), warned_(false), announced_(false),
      restarted_(false) {
  for (int m = 0; m < n_meshes(); m++)
    mesh_ids_.push_back(mesh_list()[m]->id);
  geometry_ = geometry_of(arg, iarg_);
  check_particles();
  check_meshes();
  try {
    parse(narg, arg);
    if (!profile_path_.empty())
      profile_ = asperity::read_profile(world, profile_path_,
                                        units_of(update->unit_style, "a profile is").metre,
                                        profile_report_);
    else if (!smooth_)
      make_surface();
    if (!needs_sizes())
      make_wall();
  } catch (const std::string &wrong) {
    fail(wrong);
  } catch (const asperity::Error &wrong) {
    fail(wrong.what());
  }
  scalar_flag = vector_flag = array_flag = 1;
  size_vector = N_COUNTERS;
  size_array_rows = std::max(1, n_meshes());
  size_array_cols = N_TOTALS;
  totals_.resize(size_array_rows * N_TOTALS, 0.);
  global_freq = 1;
  extscalar = extvector = extarray = 1;
  restart_global = 1;
  nevery = 1;
  time_depend = 1;
  force_reneighbor = deposit_ == DELETE;
  next_reneighbor = -1;
  if (ledger_) {
    local_flag = 1;
    local_freq = static_cast<int>(ledger_->every());
    size_local_rows = 0;
    size_local_cols = asperity::Ledger::N_COLUMNS;
  }
}

FixWallRebound::~FixWallRebound() {}

void FixWallRebound::fail(const std::string &what) {
  error->fix_error(FLERR, this, what.c_str());
}

void FixWallRebound::parse(int narg, char **arg) {
  ArgReader args(narg, arg, iarg_);
  rebound_text_ = spec_.rebound;
  while (!args.done()) {
    if (args.take("surface"))
      parse_surface(args);
    else if (args.take("spread"))
      parse_spread(args);
    else if (args.take("rebound"))
      parse_rebound(args);
    else if (args.take("materials"))
      parse_materials(args);
    else if (args.take("deposit")) {
      std::string value = args.word("the value of 'deposit'");
      if (value != "freeze" && value != "delete" && value != "off")
        throw "deposit is '" + value + "'; allowed is freeze, delete or off";
      deposit_ = value == "freeze" ? FREEZE : value == "delete" ? DELETE : OFF;
    } else if (args.take("timing")) {
      std::string value = args.word("the value of 'timing'");
      if (value != "exact" && value != "overlap")
        throw "timing is '" + value + "'; allowed is exact or overlap";
      timing_ = value == "exact" ? EXACT : OVERLAP;
    } else if (args.take("seed"))
      seed_ = static_cast<uint32_t>(args.whole("seed", 0, 4294967295.0));
    else if (args.take("ledger"))
      parse_ledger(args);
    else
      throw "keyword '" + args.word("keyword") + "' is unknown; there are: " + KEYWORDS;
  }
  if (spread_.empty())
    spread_ = smooth_ ? "none" : "weibull";
  if (smooth_ && spread_ == "auto")
    spread_ = "none";
  if (spread_ != "auto")
    spec_.spread = asp_spread_find(spread_.c_str(), NULL)->name;
  spec_.deposit = deposit_ != OFF;
}

void FixWallRebound::parse_surface(ArgReader &args) {
  smooth_ = args.take("smooth");
  if (smooth_)
    return;
  if (args.take("profile")) {
    profile_path_ = args.word("the file of 'surface profile'");
    parse_bins(args);
    return;
  }
  if (!args.take("rq"))
    throw "surface is '" + args.word("the value of 'surface'") +
        "'; allowed is 'smooth', 'rq R lambda_c L' or 'profile FILE'";
  r_q_ = args.number("rq");
  if (!args.take("lambda_c"))
    throw std::string("behind 'surface rq R', 'lambda_c L' is expected");
  lambda_c_ = args.number("lambda_c");
  parse_bins(args);
}

void FixWallRebound::parse_bins(ArgReader &args) {
  if (args.take("dp_bins"))
    dp_bins_ = static_cast<int>(args.whole("dp_bins", 1, 10000));
}

void FixWallRebound::parse_spread(ArgReader &args) {
  asp_error wrong;
  spread_ = args.word("the spread model");
  if (spread_ != "auto" && !asp_spread_find(spread_.c_str(), &wrong))
    throw std::string(wrong.text) + " auto";
  tolerance_ = 0;
  for (bool more = true; more;) {
    if (args.take("plane"))
      spec_.tilt = ASP_TILT_PLANE;
    else if (args.take("isotropic"))
      spec_.tilt = ASP_TILT_ISOTROPIC;
    else if (args.take("collisions")) {
      std::string value = args.word("the value of 'collisions'");
      if (value != "single" && value != "multiple")
        throw "collisions is '" + value + "'; allowed is single or multiple";
      spec_.collisions = value == "single" ? ASP_COLLISIONS_SINGLE : ASP_COLLISIONS_MULTIPLE;
    } else if (args.take("tolerance")) {
      tolerance_ = args.number("tolerance");
      if (!(tolerance_ > 0) || std::isinf(tolerance_))
        throw text("tolerance is %g; allowed is a finite D_KL > 0", tolerance_);
    } else
      more = false;
  }
  if ((spread_ == "auto") != (tolerance_ > 0))
    throw std::string("'spread auto' and 'tolerance D' go together, with no other model");
}

/* A law's parameters have keywords of their own in a script, some of them one for several. */
static const struct {
  const char *keyword;
  std::vector<const char *> parameters;
} LAW_KEYWORDS[] = {{"yield_rate", {"yield_rate"}},
                    {"contact_area", {"a", "b", "c"}},
                    {"temperature", {"temperature"}},
                    {"soften", {"soften_from", "soften_rate"}},
                    {"scatter", {"scatter"}}};

void FixWallRebound::parse_rebound(ArgReader &args) {
  asp_error wrong;
  std::string name = args.word("the rebound law");
  if (asp_wall_spec_rebound(&spec_, name.c_str(), &wrong))
    throw std::string(wrong.text);
  const asp_rebound_law *law = asp_rebound_find(name.c_str(), NULL);
  rebound_text_ = name;
  auto set = [&](const char *parameter) {
    double value = args.number(parameter);
    if (asp_wall_spec_set(&spec_, parameter, value, &wrong))
      throw "rebound " + name + ": " + wrong.text;
    rebound_text_ += text(" %s %g", parameter, value);
  };
  if (name == "constant") {
    set("cor_n");
    set("cor_t");
  }
  if (law->needs_table)
    read_table(args.word("the file of 'rebound table'"));
  for (bool more = true; more;) {
    more = args.take("scatter_twice");
    spec_.scatter_twice = spec_.scatter_twice || more;
    for (const auto &entry : LAW_KEYWORDS)
      if (asp_rebound_parameter(law, entry.parameters[0], NULL) >= 0 && args.take(entry.keyword)) {
        for (const char *parameter : entry.parameters)
          set(parameter);
        more = true;
      }
  }
}

void FixWallRebound::read_table(const std::string &path) {
  asp_error wrong;
  const UnitStyle &units = units_of(update->unit_style, "a table is");
  table_path_ = path;
  table_.reset(asp_cor_table_read(path.c_str(), units.metre / units.second, &wrong));
  if (!table_)
    throw std::string(wrong.text);
  spec_.table = table_.get();
}

/* A name for each atom type; they end where the file or another keyword begins. */
void FixWallRebound::parse_materials(ArgReader &args) {
  asp_error wrong;
  std::vector<std::string> names;
  while (!args.done() && !args.is_one_of(std::string("file ") + KEYWORDS))
    names.push_back(args.word("a material"));
  const std::string path = args.take("file") ? args.word("the file of 'materials'") : "";
  if (static_cast<int>(names.size()) != atom->ntypes)
    throw text("materials has %d names, and the script has %d atom types; allowed is one name for "
               "each type",
               static_cast<int>(names.size()), atom->ntypes);
  units_ = &units_of(update->unit_style, "materials are");
  own_materials_.reset(path.empty() ? NULL : asp_materials_read(path.c_str(), &wrong));
  if (!path.empty() && !own_materials_)
    throw std::string("materials: ") + wrong.text;
  materials_.clear();
  materials_text_.clear();
  for (const std::string &name : names) {
    materials_.push_back(asp_materials_find(own_materials_.get(), name.c_str(), &wrong));
    if (!materials_.back())
      throw std::string("materials: ") + wrong.text;
    materials_text_ += (materials_text_.empty() ? "" : " ") + name;
  }
  materials_text_ += path.empty() ? "" : " file " + path;
}

void FixWallRebound::parse_ledger(ArgReader &args) {
  bigint every = static_cast<bigint>(args.whole("ledger", 1, 2147483647.0));
  std::string path, on_error;
  for (bool more = true; more;) {
    if (args.take("file"))
      path = args.word("the file of 'ledger'");
    else if (args.take("on_error"))
      on_error = args.word("the value of 'on_error'");
    else
      more = false;
  }
  if (!on_error.empty() && on_error != "stop" && on_error != "go_on")
    throw "on_error is '" + on_error + "'; it must be stop or go_on";
  if (!on_error.empty() && path.empty())
    throw std::string("on_error is of a ledger's file; 'ledger N file FILE' must come with it");
  ledger_.reset(
      new asperity::Ledger(world, std::string("fix ") + id, every, path,
                           on_error == "go_on" ? asperity::Ledger::GO_ON : asperity::Ledger::STOP));
}

/* Whether the wall depends on the range of diameters, and so cannot be made before a run. */
bool FixWallRebound::needs_sizes() const {
  return !smooth_ &&
         (profile_ || spread_ == "auto" || asp_spread_find(spread_.c_str(), NULL)->prepare);
}

/* Bins, tables and the choice of a model span the diameters that there are or, by the templates,
 * will be; the span never shrinks, and goes into restarts, so that a run and its continuation have
 * the same. Throws what is wrong. */
void FixWallRebound::fit_sizes() {
  asp_error wrong;
  double most, least;
  modify->max_min_rad(most, least);
  if (!needs_sizes()) {
    if (surface_ && asp_surface_check(surface_.get(), 2 * most, &wrong))
      throw std::string(wrong.text);
    return;
  }
  if (wall_ && 2 * least >= d_range_[0] && 2 * most <= d_range_[1])
    return;
  d_range_[0] = d_range_[0] > 0 ? std::min(d_range_[0], 2 * least) : 2 * least;
  d_range_[1] = std::max(d_range_[1], 2 * most);
  spec_.sizes.least = d_range_[0];
  spec_.sizes.most = d_range_[1];
  spec_.sizes.bins = dp_bins_;
  announced_ = false;
  make_surface();
  make_wall();
}

void FixWallRebound::make_surface() {
  asp_error wrong;
  wall_.reset();
  if (profile_)
    surface_.reset(
        asp_surface_create_profile(profile_.get(), d_range_[0], d_range_[1], dp_bins_, &wrong));
  else
    surface_.reset(asp_surface_create(r_q_, lambda_c_, &wrong));
  if (!surface_)
    throw "surface " + (profile_ ? "profile " + profile_path_ + ": " : std::string()) + wrong.text;
}

void FixWallRebound::make_wall() {
  asp_error wrong;
  if (spread_ == "auto") {
    asp_choice choice;
    if (asp_spread_auto(surface_.get(), &spec_.sizes, 0, ASP_PI / 2, spec_.collisions, tolerance_,
                        &choice, &wrong))
      throw "spread auto: " + std::string(wrong.text);
    spec_.spread = choice.model->name;
    choice_ = choice.text;
  }
  spec_.surface = surface_.get();
  spec_.profile = profile_.get();
  wall_.reset(asp_wall_create(&spec_, &wrong));
  if (!wall_)
    throw std::string(wrong.text);
}

std::string FixWallRebound::state_id() const {
  return std::string("rebound_") + id;
}

std::string FixWallRebound::place_id() const {
  return std::string("stuck_") + id;
}

double *FixWallRebound::state(int i) const {
  return row_of(fix_state_->array_atom, N_STATE, i);
}

double *FixWallRebound::place(int i) const {
  return row_of(fix_place_->array_atom, N_PLACE, i);
}

/* What the base class does before forces is for the lists of primitive walls. */
int FixWallRebound::setmask() {
  const int base = FixWallGran::setmask() & (is_mesh_wall() ? ~PRE_FORCE : ~0);
  return base | PRE_INITIAL_INTEGRATE | PRE_EXCHANGE | END_OF_STEP | POST_RUN;
}

/* Zeros for each particle, which go with it and into restart files. */
FixPropertyAtom *FixWallRebound::add_property(const std::string &name, int columns) {
  std::vector<std::string> words = {name, "all", "property/atom", name, "vector", "yes",
                                    "no", "no"};
  words.resize(words.size() + columns, "0.");
  std::vector<char *> arg;
  for (std::string &word : words)
    arg.push_back(&word[0]);
  return modify->add_fix_property_atom(static_cast<int>(arg.size()), arg.data(), style);
}

void FixWallRebound::post_create() {
  if (modify->fix_restart_in_progress() && !restarted_ && comm->me == 0)
    error->warning(
        FLERR,
        text("Fix wall/rebound (id %s): the restart file has no data of this wall; its impact "
             "numbers begin at 1, and no particle is stuck to it",
             id)
            .c_str());
  FixWallGran::post_create();
  fix_state_ = add_property(state_id(), N_STATE);
  if (deposit_ != OFF)
    fix_place_ = add_property(place_id(), N_PLACE);
  for (int m = 0; m < n_meshes(); m++)
    maps_.push_back(std::unique_ptr<ReboundMap>(new ReboundMap(mesh_list()[m]->triMesh())));
}

void FixWallRebound::pre_delete(bool unfixflag) {
  for (const std::string &name : {state_id(), place_id()})
    if (unfixflag && modify->find_fix_id(name.c_str()))
      modify->delete_fix(name.c_str());
  for (size_t m = 0; unfixflag && m < maps_.size(); m++)
    maps_[m]->remove();
  FixWallGran::pre_delete(unfixflag);
}

/* ---- before a run ---------------------------------------------------------------------------- */

void FixWallRebound::init() {
  FixWallGran::init();
  find_siblings();
  if (strstr(update->integrate_style, "respa"))
    fail("run_style respa is not supported; allowed is run_style verlet");
  if (update->whichflag == 2)
    fail("minimize is not supported: a rebound is an event in time; allowed is run");
  check_particles();
  check_meshes();
  find_materials();
  check_group();
  try {
    fit_sizes();
  } catch (const std::string &wrong) {
    fail(wrong);
  }
  set_clock();
  renumber_stuck();
  try {
    if (ledger_)
      print(ledger_->open(heading(), update->ntimestep));
  } catch (const asperity::Error &wrong) {
    fail(wrong.what());
  }
  if (!announced_)
    announce();
  announced_ = true;
}

/* The values of a fix property/global, row by row; empty where there is none and none is needed. */
void FixWallRebound::property(const char *name, const char *kind, int rows, int columns,
                              bool needed, const char *example, std::vector<double> &values) {
  Fix *found =
      modify->find_fix_property(name, "property/global", kind, rows, columns, style, false);
  if (!found && needed)
    fail(text("the script has no %s for each atom type; add a line such as 'fix %s all "
              "property/global %s %s %s'",
              name, name, name, kind, example));
  values.clear();
  for (int i = 0; found && i < rows; i++)
    for (int j = 0; j < std::max(columns, 1); j++)
      values.push_back(columns ? static_cast<FixPropertyGlobal *>(found)->compute_array(i, j)
                               : static_cast<FixPropertyGlobal *>(found)->compute_vector(i));
}

void FixWallRebound::find_materials() {
  const asp_rebound_law *law = asp_rebound_find(spec_.rebound, NULL);
  const bool named = !materials_.empty();
  pairs_.clear();
  materials_report_ = named ? text("\n  rebound %s needs no materials", law->name) : "";
  if (!law->needs_material)
    return;
  const int n = atom->ntypes;
  int rate = asp_rebound_parameter(law, "yield_rate", NULL);
  bool constant_yield = rate < 0 || !(spec_.parameters[rate] > 0);
  std::vector<double> modulus, poisson, yield, friction, energy;
  if (named) {
    take_materials(modulus, poisson, yield);
    check_materials(constant_yield);
  } else {
    property("youngsModulus", "peratomtype", n, 0, true, "7e10 2.05e11", modulus);
    property("poissonsRatio", "peratomtype", n, 0, true, "0.17 0.32", poisson);
    property("yieldStress", "peratomtype", n, 0, constant_yield, "2e8 2e8", yield);
  }
  property("surfaceEnergy", "peratomtypepair", n, n, deposit_ != OFF && !named, "2 0.8 0.8 0.8 0.8",
           energy);
  property("coefficientFriction", "peratomtypepair", n, n, false, "2 0.3 0.3 0.3 0.3", friction);
  if (named)
    take_defaults(energy, friction);
  pairs_.resize((n + 1) * (n + 1));
  for (int p = 0; p < n; p++)
    for (int w = 0; w < n; w++) {
      asp_error wrong;
      if (asp_pair_create(modulus[p], poisson[p], modulus[w], poisson[w],
                          yield.empty() ? 0 : yield[p], energy.empty() ? 0 : energy[p * n + w],
                          friction.empty() ? ASP_FRICTION : friction[p * n + w],
                          &pairs_[(p + 1) * (n + 1) + w + 1], &wrong))
        fail(text("types %d (particle) and %d (wall): %s", p + 1, w + 1, wrong.text));
    }
}

/* The values of the named materials, in the script's units. They go before those of fix
 * property/global, which may be soft ones for the pair style. */
void FixWallRebound::take_materials(std::vector<double> &modulus, std::vector<double> &poisson,
                                    std::vector<double> &yield) {
  const double pascal = units_->pascal();
  materials_report_.clear();
  for (const asp_material *m : materials_) {
    modulus.push_back(m->youngs_modulus * pascal);
    poisson.push_back(m->poissons_ratio);
    yield.push_back(m->yield_stress * pascal);
    materials_report_ +=
        text("\n  type %d: material %s, E %.6g, nu %.6g, ", static_cast<int>(modulus.size()),
             m->name, modulus.back(), poisson.back()) +
        (yield.back() > 0 ? text("sigma_y %.6g", yield.back()) : "no sigma_y");
  }
}

/* With named materials, the constants of a pair have the command's defaults. */
void FixWallRebound::take_defaults(std::vector<double> &energy, std::vector<double> &friction) {
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

/* Particles that there are or, by the templates, will be need a yield stress, which a material for
 * walls lacks. Their density is their own: where it is not the material's, that may be a mistake.
 */
void FixWallRebound::check_materials(bool constant_yield) {
  const int n = atom->ntypes;
  const double unit = units_->kilogram_per_m3();
  /* Of each type: 1 where it has particles; then how far their density is off. */
  std::vector<double> mine(2 * n), all(2 * n);
  for (int i = 0; i < atom->nlocal; i++) {
    if (!(atom->mask[i] & groupbit))
      continue;
    const int t = atom->type[i] - 1;
    const double r = atom->radius[i], density = atom->rmass[i] / (4 * ASP_PI / 3 * r * r * r);
    mine[t] = 1;
    mine[n + t] = std::max(mine[n + t], fabs(density / (materials_[t]->density * unit) - 1));
  }
  for (int i = 0; i < modify->nfix; i++)
    if (FixTemplateSphere *grain = dynamic_cast<FixTemplateSphere *>(modify->fix[i]))
      mine[grain->maxtype() - 1] = 1;
  MPI_Allreduce(mine.data(), all.data(), 2 * n, MPI_DOUBLE, MPI_MAX, world);
  for (int t = 0; t < n; t++) {
    const asp_material *m = materials_[t];
    if (constant_yield && all[t] > 0 && !(m->yield_stress > 0))
      fail(text("material '%s' is that of particles (type %d) and has no yield stress; allowed is "
                "one that has, of your own in a file, or 'rebound bons yield_rate A'",
                m->name, t + 1));
    if (all[n + t] > 0.01 && !announced_ && comm->me == 0)
      error->warning(FLERR, text("Fix wall/rebound (id %s): the density of particles of type %d is "
                                 "up to %.3g %% off that of material '%s', %g; theirs is taken",
                                 id, t + 1, 100 * all[n + t], m->name, m->density * unit)
                                .c_str());
  }
}

void FixWallRebound::check_particles() {
  if (!atom->radius_flag || !atom->rmass_flag || atom->ellipsoid_flag || atom->superquadric_flag ||
      atom->shapetype_flag)
    fail("particles must be spheres with a radius and a density; allowed is 'atom_style granular' "
         "or "
         "'sphere'");
  if (modify->n_fixes_style("multisphere") > 0 || modify->n_fixes_style("rigid") > 0)
    fail(
        "particles that are tied to bodies (fix multisphere, fix rigid) cannot rebound one by one");
  if (!atom->tag_enable)
    fail("particles have no tags, which the draws depend on; use 'atom_modify id yes'");
}

/* A mesh may have been taken away since, or be another wall's too: its particles would rebound
 * twice. */
void FixWallRebound::check_meshes() {
  for (int m = 0; m < n_meshes(); m++)
    if (modify->find_fix_id(mesh_ids_[m].c_str()) != mesh_list()[m])
      fail("mesh '" + mesh_ids_[m] +
           "' has been deleted while this wall uses it; unfix the wall first");
  if (fix_state_ && modify->find_fix_id(state_id().c_str()) != fix_state_)
    fail("fix property/atom '" + state_id() + "' has been deleted while this wall uses it");
  if (fix_place_ && modify->find_fix_id(place_id().c_str()) != fix_place_)
    fail("fix property/atom '" + place_id() + "' has been deleted while this wall uses it");
  for (int i = 0; i < modify->nfix; i++) {
    FixWallGran *other = dynamic_cast<FixWallGran *>(modify->fix[i]);
    if (!other || other == this)
      continue;
    for (int k = 0; k < other->n_meshes(); k++)
      for (int m = 0; m < n_meshes(); m++)
        if (other->mesh_list()[k] == mesh_list()[m])
          fail("mesh '" + mesh_ids_[m] + "' is already used by fix '" + other->id +
               "'; allowed is one wall for each mesh");
  }
}

/* A wall for nobody is a mistake in the script, unless particles are still to come. */
void FixWallRebound::check_group() {
  if (group->count(igroup) > 0 || modify->n_fixes_style("insert") > 0)
    return;
  fail(text("group '%s' holds no particle, and there is no fix insert to bring any",
            group->names[igroup]));
}

/* The first line of a ledger: what the wall was, for those who compare it with measurements. */
std::string FixWallRebound::heading() const {
  std::string surface = smooth_    ? "smooth"
                        : profile_ ? "profile " + profile_path_
                                   : text("rq %g lambda_c %g", r_q_, lambda_c_);
  std::string materials = materials_.empty() ? "" : "; materials " + materials_text_;
  return text("asperity %s; fix %s wall/rebound; units %s; surface %s; spread %s; rebound %s%s; "
              "seed %u; angles in degrees",
              ASP_VERSION, id, update->unit_style, surface.c_str(), spec_.spread,
              rebound_text_.c_str(), materials.c_str(), seed_);
}

std::string FixWallRebound::describe_surface() const {
  const double degrees = 180 / ASP_PI;
  if (smooth_ || strcmp(spec_.spread, "none") == 0)
    return "smooth wall";
  const asp_surface *s = surface_.get();
  std::string line = profile_ ? "profile " + profile_path_ + " (" + profile_report_ + "), " : "";
  line += text("R_q %.4g, lambda_c %.4g, Phi_R %.4g, sigma %.4g deg before the size filter",
               asp_surface_r_q(s), asp_surface_lambda_c(s), asp_surface_phi_r(s),
               atan(asp_surface_slope_rms(s)) * degrees);
  line += text(", spread %s %s, collisions %s", spec_.spread,
               spec_.tilt == ASP_TILT_PLANE ? "plane" : "isotropic",
               spec_.collisions == ASP_COLLISIONS_SINGLE ? "single" : "multiple");
  if (!choice_.empty())
    line += "\n  " + choice_;
  for (int i = 0; i < asp_surface_bins(s); i++)
    line += text("\n  bin %d: d_p %.4g, sigma %.4g deg", i + 1, asp_surface_bin_d_p(s, i),
                 atan(asp_surface_bin_slope(s, i)) * degrees);
  return line;
}

/* One formula for the time of a step, whether or not the run was interrupted before it. */
void FixWallRebound::set_clock() {
  const double step = static_cast<double>(update->ntimestep);
  if (!(clock_.dt > 0))
    clock_ = Clock{update->get_cur_time(), step, update->dt};
  else if (clock_.dt < update->dt || clock_.dt > update->dt)
    clock_ = Clock{time(), step, update->dt};
}

void FixWallRebound::reset_dt() {
  set_clock();
  lists_are_new_ = true; /* planes know the path of a step */
}

double FixWallRebound::time() const {
  return clock_.time + (static_cast<double>(update->ntimestep) - clock_.step) * clock_.dt;
}

/* To screen and log, on one rank. */
void FixWallRebound::print(const std::string &line) {
  if (line.empty() || comm->me != 0)
    return;
  const std::string whole = std::string("fix ") + id + " wall/rebound: " + line + "\n";
  if (screen)
    fputs(whole.c_str(), screen);
  if (logfile)
    fputs(whole.c_str(), logfile);
}

void FixWallRebound::warn(const std::string &what) {
  if (comm->me == 0)
    error->warning(FLERR, ("Fix wall/rebound (id " + std::string(id) + "): " + what).c_str());
}

/* Rows of the ledger that could not be written. */
void FixWallRebound::tell_lost(const std::string &lost) {
  if (lost.empty())
    return;
  if (ledger_->on_error() == asperity::Ledger::STOP)
    fail(lost);
  warn(lost);
}

void FixWallRebound::announce() {
  std::string line = text("fix %s wall/rebound: rebound %s, deposit %s, timing %s, seed %u; ", id,
                          rebound_text_.c_str(), DEPOSITS[deposit_],
                          timing_ == EXACT ? "exact" : "overlap", seed_);
  line += describe_surface() + materials_report_ + "\n";
  if (comm->me != 0)
    return;
  if (asp_rebound_find(spec_.rebound, NULL)->measured && !smooth_)
    error->warning(
        FLERR,
        text("Fix wall/rebound (id %s): the coefficients of '%s' were measured on a wall with a "
             "roughness of its own; on a rough wall that counts twice",
             id, spec_.rebound)
            .c_str());
  if (screen)
    fputs(line.c_str(), screen);
  if (logfile)
    fputs(line.c_str(), logfile);
}

void FixWallRebound::setup_pre_exchange() {
  pre_exchange();
}

/* The base class would run a step of contacts here, with velocities of the full step. A contact is
 * an event within a step, so there is none to do. */
void FixWallRebound::setup(int vflag) {
  FixWallGran::pre_neighbor();
  pre_force(vflag);
  lists_are_new_ = true;
  collect_stuck();
  fastest_ = Fastest();
  check_speeds();
  warn_of_speeds();
  for (size_t m = 0; m < saved_maps_.size(); m++)
    maps_[m]->scatter(saved_maps_[m]);
  saved_maps_.clear();
}

void FixWallRebound::pre_neighbor() {
  FixWallGran::pre_neighbor();
  lists_are_new_ = true;
  collect_stuck();
  check_speeds();
}

/* A particle that moves more than its radius in a step may pass the wall between two looks at it.
 * Each rank looks where lists are built anew; they tell each other when something is printed, and
 * do not wait for each other in between. */
void FixWallRebound::check_speeds() {
  const int n = atom->nlocal, *mask = atom->mask;
  if (warned_ || n == 0)
    return;
  const double *v = atom->v[0], *radius = atom->radius; /* v: rows of three */
  double worst = fastest_.ratio;
  for (int i = 0; i < n; i++, v += 3) {
    const double square = dot(v, v), limit = worst * radius[i];
    if (!(mask[i] & groupbit) || square <= limit * limit)
      continue;
    worst = sqrt(square) / radius[i];
    fastest_ = Fastest{worst, 2 * radius[i], sqrt(square)};
  }
}

void FixWallRebound::warn_of_speeds() {
  if (warned_)
    return;
  struct {
    double ratio;
    int rank;
  } mine = {fastest_.ratio, comm->me}, worst;
  MPI_Allreduce(&mine, &worst, 1, MPI_DOUBLE_INT, MPI_MAXLOC, world);
  if (worst.ratio * update->dt <= 1)
    return;
  double fastest[2] = {fastest_.d_p, fastest_.speed};
  MPI_Bcast(fastest, 2, MPI_DOUBLE, worst.rank, world);
  warned_ = true;
  if (comm->me == 0)
    error->warning(FLERR,
                   text("Fix wall/rebound (id %s): particles that fly straight at the wall can "
                        "cross it within a step: "
                        "one of diameter %g moves at %g, which is %.3g diameters in a step of "
                        "%g; the largest safe step is %g",
                        id, fastest[0], fastest[1], 0.5 * worst.ratio * update->dt, update->dt,
                        1 / worst.ratio)
                       .c_str());
}

/* ---- contacts -------------------------------------------------------------------------------- */

void FixWallRebound::find_siblings() {
  siblings_.clear();
  for (int i = 0; i < modify->nfix; i++)
    if (FixWallRebound *wall = dynamic_cast<FixWallRebound *>(modify->fix[i]))
      siblings_.push_back(wall);
}

/* A cheap look at all pairs of particle and wall first; then, for the few particles whose path may
 * meet a wall in this step, all walls that they may reach. */
void FixWallRebound::post_force(int) {
  if (update->setupflag || siblings_.front() != this)
    return;
  for (FixWallRebound *wall : siblings_)
    wall->refresh();
  hits_.clear();
  for (FixWallRebound *wall : siblings_)
    wall->find_hits(hits_);
  std::sort(hits_.begin(), hits_.end());
  hits_.erase(std::unique(hits_.begin(), hits_.end()), hits_.end());
  for (int i : hits_)
    for (FixWallRebound *wall : siblings_)
      wall->fetch(i);
  double walls = 0;
  for (const FixWallRebound *wall : siblings_)
    walls = std::max(walls, wall->wall_path_);
  for (int i : hits_) {
    if (is_stuck(i))
      continue;
    candidates_.clear();
    for (FixWallRebound *wall : siblings_)
      wall->find_candidates(i, walls, candidates_);
    collide(candidates_.data(), candidates_.data() + candidates_.size());
  }
}

/* Asks for what the contact of a particle will read. The rest of a step has pushed it out of the
 * caches; asked for by all contacts of a step beforehand, it comes while others are waited for. */
void FixWallRebound::fetch(int i) const {
  __builtin_prefetch(state(i));
  __builtin_prefetch(&atom->type[i]);
  __builtin_prefetch(&atom->tag[i]);
  __builtin_prefetch(&atom->rmass[i]);
  if (near_.empty())
    return;
  for (int k = first_[i]; k < first_[i + 1]; k++) {
    const Plane &plane = planes_[near_[k].plane];
    maps_[plane.mesh]->fetch(plane.triangle);
  }
}

/* Arrays of the atoms may have moved since the last step, and walls have: stuck particles with
 * them. */
void FixWallRebound::refresh() {
  x_ = atom->x;
  radius_ = atom->radius;
  rmass_ = atom->rmass;
  nlocal_ = atom->nlocal;
  if (lists_are_new_)
    find_velocities();
  if (!stuck_.empty() && is_moving())
    for (Stuck &stuck : stuck_)
      carry(stuck);
}

/* A mesh has velocities while a fix that moves it is there, which may change between two runs. */
void FixWallRebound::find_velocities() {
  moving_.clear();
  for (int m = 0; m < n_meshes(); m++)
    moving_.push_back(mesh_list()[m]->triMesh()->prop().getElementProperty<NodeVelocities>("v"));
}

/* The neighbour lists of the meshes, triangle by triangle, as pairs ordered by particle, mesh and
 * id of the triangle: so that a step reads the particles one after the other, and the candidates of
 * one come together, in an order that does not depend on how a rank numbers its triangles. */
void FixWallRebound::collect_pairs() {
  std::vector<Pair> pairs; /* by triangle */
  pairs.reserve(near_.capacity());
  std::vector<char> stuck(atom->nlocal, 0);
  for (const FixWallRebound *wall : siblings_)
    wall->mark_stuck(stuck);
  planes_.clear();
  first_.assign(atom->nlocal + 1, 0);
  const int nlocal = atom->nlocal, *mask = atom->mask;
  for (int m = 0; m < n_meshes(); m++) {
    TriMesh *mesh = mesh_list()[m]->triMesh();
    FixNeighlistMesh *lists = mesh_list()[m]->meshNeighlist();
    const int n = mesh->sizeLocal() + mesh->sizeGhost();
    for (int t = 0; t < n; t++) {
      const std::vector<int> &list = lists->get_contact_list(t);
      if (list.empty())
        continue;
      const int plane = static_cast<int>(planes_.size());
      planes_.push_back(Plane{m, t, mesh->id(t), {0, 0, 0}, 0, 0});
      for (int i : list)
        if (i < nlocal && (mask[i] & groupbit) && !stuck[i]) {
          pairs.push_back(Pair{i, plane, 0});
          first_[i]++;
        }
    }
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin()); /* the ends, for now */
  near_.resize(pairs.size());
  for (size_t k = pairs.size(); k-- > 0;)
    near_[--first_[pairs[k].particle]] = pairs[k];
  auto before = [this](const Pair &a, const Pair &b) {
    const Plane &of_a = planes_[a.plane], &of_b = planes_[b.plane];
    return a.particle == b.particle && std::tie(of_a.mesh, of_a.id, of_a.triangle) <
                                           std::tie(of_b.mesh, of_b.id, of_b.triangle);
  };
  for (size_t k = 1; k < near_.size(); k++) /* few of one particle, that is */
    for (size_t j = k; j > 0 && before(near_[j], near_[j - 1]); j--)
      std::swap(near_[j], near_[j - 1]);
  if (!near_.empty())
    near_.insert(near_.end(), FETCH_AHEAD, near_.back());
  lists_are_new_ = false;
}

double FixWallRebound::Plane::distance(const double x[3]) const {
  return dot(normal, x) - offset;
}

/* The planes where their triangles are; anew when the lists are, and in every step where a mesh
 * moves. */
void FixWallRebound::place_planes() {
  double node[3];
  wall_path_ = 0;
  for (Plane &plane : planes_) {
    TriMesh *mesh = mesh_list()[plane.mesh]->triMesh();
    mesh->surfaceNorm(plane.triangle, plane.normal);
    mesh->node(plane.triangle, 0, node);
    plane.offset = dot(plane.normal, node);
    const double path = speed_of_triangle(plane.mesh, plane.triangle) * update->dt;
    plane.reach = 2 * path;
    wall_path_ = std::max(wall_path_, path);
  }
}

/* Which pairs to look at in this step, and how many: the particles of the others have not gone as
 * far yet as they were away. No path is longer than the sum of its components. Without branches,
 * which would be guessed wrong too often. */
int FixWallRebound::find_due() {
  due_.resize(near_.size());
  const double dt = update->dt, *v = atom->v[0]; /* rows of three */
  const int n = static_cast<int>(near_.size()) - FETCH_AHEAD;
  Pair *const pair = near_.data();
  int due = 0, *const at = due_.data();
  for (int k = 0; k < n; k++) {
    const ptrdiff_t i = 3 * static_cast<ptrdiff_t>(pair[k].particle);
    const double *ahead = v + 3 * static_cast<ptrdiff_t>(pair[k + FETCH_AHEAD].particle);
    __builtin_prefetch(ahead); /* both its ends, which may be in two cache lines */
    __builtin_prefetch(ahead + 2);
    const double clear = pair[k].clear - (fabs(v[i]) + fabs(v[i + 1]) + fabs(v[i + 2])) * dt;
    pair[k].clear = clear;
    at[due] = k;
    due += clear <= 0;
  }
  return due;
}

/* Particles that may touch a wall in this step. The distance from the plane of a triangle is a
 * lower bound of that from the triangle, and along a straight path it is least at one of its ends,
 * or zero between them where they lie on different sides. */
void FixWallRebound::find_hits(std::vector<int> &hits) {
  if (!is_mesh_wall()) {
    find_hits_primitive(hits);
    return;
  }
  const double half_step = 0.5 * update->dt;
  const bool lists_were_new = lists_are_new_, moving = is_moving();
  if (lists_are_new_)
    collect_pairs();
  if (lists_were_new || moving)
    place_planes();
  if (near_.empty())
    return;
  const double *x = atom->x[0], *v = atom->v[0], *radius = atom->radius; /* x, v: rows of three */
  const int due = find_due(), *at = due_.data();
  const Plane *planes = planes_.data();
  for (int k = 0; k < due; k++) {
    Pair &pair = near_[at[k]];
    const Plane &plane = planes[pair.plane];
    const ptrdiff_t i = pair.particle;
    const double touching = radius[i] + plane.reach;
    const double end = plane.distance(x + 3 * i);
    const double half = dot(plane.normal, v + 3 * i) * half_step;
    pair.clear = moving ? 0 : fabs(end) - touching;
    if (fabs(end - half) - fabs(half) <= touching)
      hits.push_back(pair.particle);
  }
}

/* How far a primitive wall moves along itself within a step. */
double FixWallRebound::path_of_primitive() {
  if (!shear_)
    return 0;
  return fabs(vshear_) * (shearAxis_ >= 0 ? cylinder_radius() : 1) * update->dt;
}

/* The distance from any wall changes by no more than the path is long, so it cannot fall to zero
 * where the distances at its ends add up to more. A primitive wall moves along itself only. */
void FixWallRebound::find_hits_primitive(std::vector<int> &hits) {
  wall_path_ = path_of_primitive();
  int *list;
  double delta[3], begin[3];
  const double dt = update->dt;
  const int n = primitiveWall()->getNeighbors(list);
  for (int k = 0; k < n; k++) {
    const int i = list[k];
    if (i >= nlocal_ || !(atom->mask[i] & groupbit))
      continue;
    double *x = row_of(x_, 3, i);
    const double *v = row_of(atom->v, 3, i);
    for (int d = 0; d < 3; d++)
      begin[d] = x[d] - v[d] * dt;
    double sum = primitiveWall()->resolveContact(x, radius_[i], delta) +
                 primitiveWall()->resolveContact(begin, radius_[i], delta);
    if (sum <= 0 || sum * sum <= dt * dt * dot(v, v))
      hits.push_back(i);
  }
}

/* All pieces of this wall that the particle may touch in this step, also after rebounds: its speed
 * may have grown by then where walls move, of which the fastest moves by `walls`. */
void FixWallRebound::find_candidates(int i, double walls, std::vector<Candidate> &candidates) {
  if (!(atom->mask[i] & groupbit))
    return;
  if (!is_mesh_wall()) {
    candidates.push_back(Candidate{this, i, -1, 0, 0, 0});
    return;
  }
  const double *x = row_of(x_, 3, i), *v = row_of(atom->v, 3, i);
  const double path = sqrt(dot(v, v)) * update->dt;
  for (int k = first_[i]; k < first_[i + 1]; k++) {
    near_[k].clear = 0; /* its path may bend */
    const Plane &plane = planes_[near_[k].plane];
    double gap = fabs(plane.distance(x)) - radius_[i];
    if (gap <= 2 * path + 4 * walls)
      candidates.push_back(
          Candidate{this, i, plane.mesh, plane.triangle, plane.id, near_[k].plane});
  }
}

/* The speed of the fastest node; 0 for a wall at rest. */
double FixWallRebound::speed_of_triangle(int m, int t) const {
  double most = 0;
  for (int k = 0; moving_[m] && k < 3; k++) {
    const double *v = moving_[m]->begin()[t][k];
    most = std::max(most, dot(v, v));
  }
  return sqrt(most);
}

bool FixWallRebound::is_stuck(int i) const {
  for (const FixWallRebound *wall : siblings_)
    if (wall->state(i)[STATE] != FREE)
      return true;
  return false;
}

/* From the axis of a cylinder to x, and how far. LIGGGHTS exchanges x and z where the axis is y. */
double FixWallRebound::from_axis(double x[3], double arm[3]) {
  const double distance = primitiveWall()->calcRadialDistance(x, arm);
  if (primitiveWall()->axis() == 1)
    std::swap(arm[0], arm[2]);
  return distance;
}

/* The distance from the sphere's surface to the wall when its centre is at x, in the state of the
 * wall at the end of the step; delta points from the centre to the nearest point of the wall. */
double FixWallRebound::gap_at(const Candidate &on, double x[3], double delta[3], double v_wall[3]) {
  for (int d = 0; d < 3; d++)
    v_wall[d] = 0;
  const double radius = radius_[on.particle];
  if (on.mesh < 0) {
    if (shear_ && shearAxis_ >= 0) {
      double arm[3];
      from_axis(x, arm);
      vectorCross3D(shearAxisVec_, arm, v_wall);
    } else if (shear_)
      v_wall[shearDim_] = vshear_;
    return primitiveWall()->resolveContact(x, radius, delta);
  }
  TriMesh *mesh = mesh_list()[on.mesh]->triMesh();
  double bary[3];
  int sign;
  double gap = mesh->resolveTriSphereContactBary(on.particle, on.triangle, radius, x, delta, bary,
                                                 sign, false);
  if (NodeVelocities *moving = moving_[on.mesh])
    for (int d = 0; d < 3; d++)
      for (int k = 0; k < 3; k++)
        v_wall[d] += bary[k] * moving->begin()[on.triangle][k][d];
  return gap;
}

/* The outward normal, from the wall to the centre. A centre exactly on the wall has none: then the
 * side that it came from is taken, and the contact counts as guarded. */
bool FixWallRebound::normal_of(const Candidate &on, const Path &path, const double delta[3],
                               double n[3], bool &guarded) {
  double length = sqrt(dot(delta, delta));
  if (length > 1e-12 * radius_[on.particle]) {
    for (int d = 0; d < 3; d++)
      n[d] = -delta[d] / length;
    return true;
  }
  double before[3], back[3], v_wall[3];
  for (int d = 0; d < 3; d++)
    before[d] = path.x[d] - path.v[d] * update->dt;
  gap_at(on, before, back, v_wall);
  length = sqrt(dot(back, back));
  if (!(length > 0))
    return false;
  for (int d = 0; d < 3; d++)
    n[d] = -back[d] / length;
  guarded = true;
  return true;
}

/* Whether a particle that moves with v, relative to the wall, is leaving it for this step: n points
 * away from the wall. */
bool FixWallRebound::leaves(const Candidate &on, const double v[3], const double n[3]) const {
  const double away = dot(v, n);
  return on.mesh >= 0 && away > 0 && away * away > LEAVES * LEAVES * dot(v, v);
}

bool FixWallRebound::moves(const Candidate &on) const {
  return on.mesh < 0 ? shear_ : moving_[on.mesh] != NULL;
}

/* The radius of a cylinder, which the primitive wall keeps to itself: the distance of its nearest
 * point from the axis, seen from somewhere, and then from near by. */
double FixWallRebound::cylinder_radius() {
  double axis[3] = {0, 0, 0}, arm[3], radius = 1;
  from_axis(axis, arm);
  for (int look = 0; look < 2; look++) {
    double x[3], off[3], delta[3] = {0, 0, 0};
    for (int d = 0; d < 3; d++)
      x[d] = axis[d] - arm[d];
    x[(primitiveWall()->axis() + 1) % 3] += 2 * radius;
    primitiveWall()->resolveContact(x, 0, delta);
    from_axis(x, off);
    for (int d = 0; d < 3; d++)
      off[d] += delta[d];
    radius = sqrt(dot(off, off));
  }
  return radius;
}

/* When the square of a distance, that of `distance` at first and a quadratic in time on a straight
 * path, is that of `touching`: 0 for what is beyond it already and goes on, infinite for never.
 * rate: half the square's growth at first; square: of the speed, > 0. */
static double chord_time(bool inside, double distance, double touching, double rate,
                         double square) {
  const double beyond = (distance - touching) * (distance + touching);
  const double root = sqrt(std::max(0.0, rate * rate - square * beyond));
  if (inside) {
    if (rate > 0)
      return beyond < 0 ? -beyond / (rate + root) : 0;
    return (root - rate) / square;
  }
  if (rate >= 0 || (beyond > 0 && !(root > 0)))
    return INFINITY;
  return beyond > 0 ? beyond / (root - rate) : 0;
}

/* The first instant at which the path touches a cylinder, on the side that it begins on, in closed
 * form however long it is. The wall moves along itself only. A particle that slides inside is
 * turned at the end of its path, where it has left the wall's curve. */
bool FixWallRebound::find_on_cylinder(const Candidate &on, const Path &path, double latest,
                                      Contact &contact) {
  double x[3], v[3], arm[3], delta[3];
  vectorCopy3D(path.x, x);
  vectorCopy3D(path.v, v);
  v[primitiveWall()->axis()] = 0;
  const double wall = cylinder_radius(), radius = radius_[on.particle];
  const double distance = from_axis(x, arm), square = dot(v, v);
  const bool inside = distance < wall;
  const double touching = inside ? std::max(0.0, wall - radius) : wall + radius;
  if (!(square > 0))
    return false;
  contact.time = chord_time(inside, distance, touching, dot(arm, v), square);
  double approach, length;
  bool slides = false;
  for (;; slides = true, contact.time = path.left) {
    if (!(contact.time <= latest))
      return false;
    for (int d = 0; d < 3; d++)
      contact.n[d] = (arm[d] + v[d] * contact.time) * (inside ? -1 : 1);
    length = sqrt(dot(contact.n, contact.n));
    approach = -dot(v, contact.n) / length;
    if (approach > SLIDES * sqrt(square))
      break;
    if (!inside || slides)
      return false;
  }
  for (int d = 0; d < 3; d++) {
    x[d] += path.v[d] * contact.time;
    contact.n[d] /= length;
  }
  gap_at(on, x, delta, contact.v_wall);
  contact.on = &on;
  contact.lift = inside ? length - touching : touching - length;
  if (contact.lift <= GAP_TOLERANCE * radius)
    contact.lift = 0;
  contact.guarded = (contact.lift > 0 && !slides) || approach * update->dt >= radius;
  return true;
}

/* When a path comes within the particle's radius of the plane of a triangle at rest, before which
 * it cannot touch it; 0 where it begins there, or leads away. */
double FixWallRebound::time_to_plane(const Candidate &on, const Path &path) const {
  if (on.mesh < 0)
    return 0;
  const Plane &plane = planes_[on.plane];
  const double from = plane.distance(path.x), rate = dot(plane.normal, path.v);
  const double gap = fabs(from) - radius_[on.particle];
  return gap > 0 && from * rate < 0 ? gap / fabs(rate) : 0;
}

/* The first instant at which the path touches the candidate, by Newton's method on the gap, from
 * the beginning of the path, or where it comes near the plane. In the frame of the wall: it is at
 * rest there as it is at the end of the step. A contact after `latest` does not count; the distance
 * from a triangle along a line is convex, so that Newton's method comes to it from below, and may
 * be stopped there. */
bool FixWallRebound::find_contact(const Candidate &on, const Path &path, double latest,
                                  Contact &contact) {
  if (on.mesh < 0 && primitiveWall()->axis() >= 0)
    return find_on_cylinder(on, path, latest, contact);
  double delta[3], end[3], n[3], v[3], x[3];
  for (int d = 0; d < 3; d++)
    end[d] = path.x[d] + path.v[d] * path.left;
  vectorZeroize3D(contact.v_wall);
  if (moves(on))
    gap_at(on, end, delta, contact.v_wall);
  for (int d = 0; d < 3; d++)
    v[d] = path.v[d] - contact.v_wall[d];
  contact.guarded = false;
  contact.lift = 0;
  double time = moves(on) ? 0 : time_to_plane(on, path);
  if (time > latest)
    return false;
  for (int i = 0; i < NEWTON_MAX; i++) {
    for (int d = 0; d < 3; d++)
      x[d] = end[d] - v[d] * (path.left - time);
    double still[3], gap = gap_at(on, x, delta, still);
    if (!normal_of(on, path, delta, n, contact.guarded))
      return false;
    double approach = -dot(v, n);
    if (approach <= 0 && i == 0) {
      if (leaves(on, v, n))
        return false;
      time = path.left;
      continue;
    }
    if (!(approach > 0))
      return false;
    if (fabs(gap) <= GAP_TOLERANCE * radius_[on.particle])
      break;
    if (gap < 0 && time <= 0) { /* overlaps already: now */
      contact.guarded = true;
      contact.lift = -gap;
      break;
    }
    time = std::max(0.0, time + gap / approach);
    if (time > latest)
      return false;
  }
  if (!(time <= latest))
    return false;
  contact.on = &on;
  contact.time = time;
  contact.guarded = contact.guarded || -dot(v, n) * update->dt >= radius_[on.particle];
  for (int d = 0; d < 3; d++)
    contact.n[d] = n[d];
  return true;
}

/* `timing overlap`: the contact is where the particle is found at the end of the step. Where the
 * centre has crossed the wall within the step, or all of the particle, only its path knows the
 * contact. */
bool FixWallRebound::find_overlap(const Candidate &on, const Path &path, Contact &contact) {
  double delta[3], end[3], v[3];
  for (int d = 0; d < 3; d++)
    end[d] = path.x[d] + path.v[d] * path.left;
  double gap = gap_at(on, end, delta, contact.v_wall);
  for (int d = 0; d < 3; d++)
    v[d] = path.v[d] - contact.v_wall[d];
  contact.guarded = false;
  if (!normal_of(on, path, delta, contact.n, contact.guarded))
    return false;
  double approach = -dot(v, contact.n);
  if (contact.guarded || sqrt(dot(delta, delta)) + approach * path.left < 0) {
    if (!find_contact(on, path, path.left, contact))
      return false;
    contact.guarded = true;
    return true;
  }
  contact.guarded = approach * update->dt >= radius_[on.particle];
  contact.lift = 0;
  contact.on = &on;
  contact.time = path.left;
  return gap <= 0 && approach > 0;
}

/* Whether a contact comes before another one, as far as their instants are known. An edge is met at
 * one instant by both of its triangles: the contact is that of the first candidate. */
bool FixWallRebound::is_earlier(const Contact &contact, const Contact &other,
                                const Path &path) const {
  double approach = 0;
  for (int d = 0; d < 3; d++)
    approach += (contact.v_wall[d] - path.v[d]) * contact.n[d];
  return (other.time - contact.time) * approach > 2 * GAP_TOLERANCE * radius_[contact.on->particle];
}

/* All contacts of one particle in this step, the earliest first, each on the path that the one
 * before it has left. */
void FixWallRebound::collide(const Candidate *first, const Candidate *last) {
  const int i = first->particle;
  Path path;
  double *x = row_of(x_, 3, i), *v = row_of(atom->v, 3, i);
  path.left = update->dt;
  for (int d = 0; d < 3; d++) {
    path.v[d] = v[d];
    path.x[d] = x[d] - path.v[d] * path.left;
  }
  bool hit = false;
  const Candidate *behind = NULL; /* left for this step by the rebound before */
  for (int k = 0; k < CONTACTS_MAX; k++) {
    Contact earliest, contact;
    earliest.on = NULL;
    for (const Candidate *on = first; on < last; on++) {
      if (on == behind)
        continue;
      FixWallRebound *wall = on->wall;
      const double latest = earliest.on ? earliest.time : path.left;
      bool found = wall->timing_ == EXACT ? wall->find_contact(*on, path, latest, contact)
                                          : wall->find_overlap(*on, path, contact);
      if (found && (!earliest.on || is_earlier(contact, earliest, path)))
        earliest = contact;
    }
    if (!earliest.on)
      break;
    hit = true;
    FixWallRebound *wall = earliest.on->wall;
    if (!wall->rebound(earliest, path))
      return;
    behind = NULL;
    if (wall->timing_ == EXACT && !wall->moves(*earliest.on) &&
        wall->leaves(*earliest.on, path.v, earliest.n))
      behind = earliest.on;
    if (k == CONTACTS_MAX - 1) {
      path.left = 0;
      wall->counters_[N_GUARDED]++;
    }
  }
  if (!hit)
    return;
  for (int d = 0; d < 3; d++) {
    v[d] = path.v[d];
    x[d] = path.x[d] + path.v[d] * path.left;
  }
}

/* One contact. Moves the path on to it and gives it the velocity after it; false where the particle
 * has stuck. */
bool FixWallRebound::rebound(const Contact &contact, Path &path) {
  const int i = contact.on->particle, type = atom->type[i];
  const int wall_type =
      contact.on->mesh < 0 ? atom_type_wall_ : mesh_list()[contact.on->mesh]->atomTypeWall();
  double v1[3];
  for (int d = 0; d < 3; d++) {
    path.x[d] += path.v[d] * contact.time + contact.n[d] * contact.lift;
    v1[d] = path.v[d] - contact.v_wall[d];
  }
  path.left -= contact.time;
  const double d_p = 2 * radius_[i];
  asp_particle particle = {d_p, rmass_[i] / (ASP_PI / 6 * d_p * d_p * d_p),
                           pairs_.empty() ? NULL : &pairs_[type * (atom->ntypes + 1) + wall_type]};
  asp_key key = {seed_, fix_key_, static_cast<uint64_t>(atom->tag[i]),
                 static_cast<uint32_t>(state(i)[IMPACTS] += 1)};
  asp_impact impact;
  asp_wall_impact(wall_.get(), &particle, v1, contact.n, &key, &impact);
  count(contact, v1, impact);
  if (ledger_)
    record(contact, path, v1, key, impact);
  if (impact.outcome == ASP_DEPOSIT) {
    stick(contact, path);
    return false;
  }
  for (int d = 0; d < 3; d++)
    path.v[d] = impact.v2[d] + contact.v_wall[d];
  return true;
}

void FixWallRebound::count(const Contact &contact, const double v1[3], const asp_impact &impact) {
  const int m = contact.on->mesh;
  const bool stuck = impact.outcome == ASP_DEPOSIT;
  const double mass = rmass_[contact.on->particle], energy = 0.5 * mass * dot(v1, v1);
  counters_[N_IMPACTS]++;
  counters_[N_DEPOSITS] += stuck;
  counters_[DEPOSITED_MASS] += stuck ? mass : 0;
  counters_[N_LATER_HITS] += impact.hits - 1;
  counters_[N_CAPPED] += impact.capped;
  counters_[N_GUARDED] += contact.guarded;
  double *total = &totals_[std::max(m, 0) * N_TOTALS];
  total[MESH_IMPACTS]++;
  total[MESH_DEPOSITS] += stuck;
  total[MESH_MASS] += stuck ? mass : 0;
  total[MESH_ENERGY] += energy;
  if (m >= 0)
    maps_[m]->add(contact.on->triangle, stuck ? mass : 0, energy);
}

void FixWallRebound::record(const Contact &contact, const Path &path, const double v1[3],
                            const asp_key &key, const asp_impact &impact) {
  typedef asperity::Ledger L;
  const double degrees = 180 / ASP_PI;
  asp_coefficients c = asp_impact_coefficients(v1, contact.n, &impact);
  L::Row row;
  row[L::TAG] = static_cast<double>(key.tag);
  row[L::IMPACT] = key.impact;
  row[L::TIME] = time() - path.left;
  row[L::MESH] = contact.on->mesh + 1;
  row[L::TRIANGLE] = contact.on->id;
  for (int d = 0; d < 3; d++)
    row[L::X + d] = path.x[d];
  row[L::D_P] = 2 * radius_[contact.on->particle];
  row[L::V1] = c.v1;
  row[L::ALPHA1] = c.alpha1 * degrees;
  row[L::DELTA_ALPHA] = impact.delta_alpha * degrees;
  row[L::TILT_OUT] = impact.tilt_out * degrees;
  row[L::HITS] = impact.hits;
  row[L::V2] = c.v2;
  row[L::ALPHA2] = c.alpha2 * degrees;
  row[L::COR_N] = c.cor_n;
  row[L::COR_T] = c.cor_t;
  row[L::OUTCOME] = impact.outcome == ASP_REBOUND ? 0 : deposit_ == DELETE ? 2 : 1;
  row[L::STEP] = static_cast<double>(update->ntimestep);
  row[L::COR_T_DEFINED] = c.cor_t_defined;
  ledger_->add(row);
}

/* ---- deposits -------------------------------------------------------------------------------- */

/* Puts the particle to rest on the wall where it touched it, and notes the place in the frame of
 * the triangle, so that it can move with it. */
void FixWallRebound::stick(const Contact &contact, const Path &path) {
  const int i = contact.on->particle;
  double *s = place(i);
  state(i)[STATE] = deposit_ == DELETE ? DOOMED : FROZEN;
  s[STUCK_MESH] = contact.on->mesh + 1;
  s[STUCK_TRIANGLE] = contact.on->id;
  for (int d = 0; d < 3; d++) {
    s[STUCK_V + d] = contact.v_wall[d];
    x_[i][d] = path.x[d] + contact.v_wall[d] * path.left;
  }
  if (contact.on->mesh >= 0) {
    double frame[3][3], origin[3];
    triangle_frame(contact.on->mesh, contact.on->triangle, origin, frame);
    double arm[3] = {x_[i][0] - origin[0], x_[i][1] - origin[1], x_[i][2] - origin[2]};
    for (int k = 0; k < 3; k++)
      s[STUCK_AT + k] = dot(arm, frame[k]);
  }
  add_stuck(i);
  hold(stuck_.back());
  stop_spin(stuck_.back());
}

/* An orthonormal frame that moves with a triangle: its first node, first edge, and normal. */
void FixWallRebound::triangle_frame(int m, int t, double origin[3], double frame[3][3]) {
  TriMesh *mesh = mesh_list()[m]->triMesh();
  double a[3], b[3], c[3], e[3];
  mesh->node(t, 0, a);
  mesh->node(t, 1, b);
  mesh->node(t, 2, c);
  for (int d = 0; d < 3; d++) {
    origin[d] = a[d];
    frame[0][d] = b[d] - a[d];
    e[d] = c[d] - a[d];
  }
  vectorNormalize3D(frame[0]);
  vectorCross3D(frame[0], e, frame[2]);
  vectorNormalize3D(frame[2]);
  vectorCross3D(frame[2], frame[0], frame[1]);
}

/* The particles are looked through first, and the places of the stuck ones read afterwards: so the
 * processor need not wait for one place before it looks at the next particle. */
void FixWallRebound::collect_stuck() {
  stuck_.clear();
  if (deposit_ == OFF || atom->nlocal == 0)
    return;
  const double *state_of = state(0) + STATE;
  const int n = atom->nlocal;
  for (int i = 0; i < n; i++) {
    __builtin_prefetch(state_of + std::min(i + STATES_AHEAD, n - 1) * N_STATE);
    if (state_of[i * N_STATE] != FREE)
      stuck_.push_back(Stuck{i, {0, 0, 0}});
  }
  for (Stuck &stuck : stuck_)
    vectorCopy3D(place(stuck.particle) + STUCK_V, stuck.v);
}

/* Of all particles, those that are stuck to this wall. Where the wall keeps no list of them, they
 * are of an earlier part of the run, whose script had them stick. */
void FixWallRebound::mark_stuck(std::vector<char> &marks) const {
  for (const Stuck &stuck : stuck_)
    marks[stuck.particle] = 1;
  for (int i = 0; deposit_ == OFF && i < atom->nlocal; i++)
    marks[i] |= state(i)[STATE] != FREE;
}

void FixWallRebound::add_stuck(int i) {
  const double *v = place(i) + STUCK_V;
  stuck_.push_back(Stuck{i, {v[0], v[1], v[2]}});
}

/* A stuck particle has the wall's velocity, ... */
void FixWallRebound::hold(const Stuck &stuck) {
  vectorCopy3D(stuck.v, row_of(atom->v, 3, stuck.particle));
}

/* ... does not spin, ... */
void FixWallRebound::stop_spin(const Stuck &stuck) {
  if (atom->omega_flag)
    vectorZeroize3D(row_of(atom->omega, 3, stuck.particle));
}

/* ... and no force on it moves it. */
void FixWallRebound::free_of_forces(const Stuck &stuck) {
  vectorZeroize3D(row_of(atom->f, 3, stuck.particle));
  if (atom->torque_flag)
    vectorZeroize3D(row_of(atom->torque, 3, stuck.particle));
}

/* Takes a stuck particle along with the triangle that it sits on. */
void FixWallRebound::carry(Stuck &stuck) {
  const int i = stuck.particle;
  double *s = place(i);
  const int m = static_cast<int>(s[STUCK_MESH]) - 1;
  if (m < 0 || m >= n_meshes() || !mesh_list()[m]->triMesh()->isMoving())
    return;
  const int t = mesh_list()[m]->triMesh()->map(static_cast<int>(s[STUCK_TRIANGLE]), 0);
  if (t < 0)
    return;
  double frame[3][3], x[3];
  triangle_frame(m, t, x, frame);
  for (int d = 0; d < 3; d++) {
    for (int k = 0; k < 3; k++)
      x[d] += s[STUCK_AT + k] * frame[k][d];
    s[STUCK_V + d] += (x[d] - x_[i][d]) / update->dt;
    stuck.v[d] = s[STUCK_V + d];
    x_[i][d] = x[d];
  }
}

void FixWallRebound::pre_initial_integrate() {
  if (ledger_)
    ledger_->begin_step(update->ntimestep);
  for (const Stuck &stuck : stuck_) {
    hold(stuck);
    free_of_forces(stuck);
  }
}

/* Comm::exchange, which follows, counts the atoms anew. */
void FixWallRebound::pre_exchange() {
  if (deposit_ != DELETE)
    return;
  bigint mine = 0, all;
  for (int i = 0; i < atom->nlocal;) {
    if (state(i)[STATE] == DOOMED) {
      atom->avec->copy(atom->nlocal - 1, i, 1);
      atom->nlocal--;
      mine++;
    } else
      i++;
  }
  MPI_Allreduce(&mine, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (all == 0)
    return;
  stuck_.clear();
  if (atom->tag_enable && atom->map_style) {
    atom->nghost = 0;
    atom->map_init();
    atom->map_set();
  }
}

void FixWallRebound::end_of_step() {
  for (const Stuck &stuck : stuck_) {
    hold(stuck);
    stop_spin(stuck);
  }
  if (output->next == update->ntimestep) {
    settle_maps();
    warn_of_speeds();
  }
  if (deposit_ ==
      DELETE) { /* particles leave where lists are built anew, and all ranks must agree */
    int mine = !stuck_.empty(), any;
    MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
    if (any)
      next_reneighbor = update->ntimestep + 1;
  }
  if (!ledger_)
    return;
  tell_lost(ledger_->end_step(update->ntimestep));
  if (update->ntimestep % ledger_->every() == 0) {
    array_local = ledger_->rows();
    size_local_rows = ledger_->size();
  }
}

void FixWallRebound::settle_maps() {
  for (std::unique_ptr<ReboundMap> &map : maps_)
    map->settle(world);
}

void FixWallRebound::post_run() {
  settle_maps();
  warn_of_speeds();
  if (ledger_)
    tell_lost(ledger_->flush());
}

/* ---- output and restart ---------------------------------------------------------------------- */

double FixWallRebound::compute_scalar() {
  return compute_vector(N_IMPACTS);
}

double FixWallRebound::compute_vector(int n) {
  double all;
  MPI_Allreduce(&counters_[n], &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

double FixWallRebound::compute_array(int row, int column) {
  double all;
  MPI_Allreduce(&totals_[row * N_TOTALS + column], &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

double FixWallRebound::memory_usage() {
  return static_cast<double>(near_.capacity() * sizeof(Pair) + planes_.capacity() * sizeof(Plane) +
                             candidates_.capacity() * sizeof(Candidate) +
                             stuck_.capacity() * sizeof(Stuck) +
                             (first_.capacity() + hits_.capacity()) * sizeof(int)) +
         (ledger_ ? ledger_->memory_usage() : 0);
}

asperity::Settings FixWallRebound::settings() const {
  const std::string bins = dp_bins_ == 16 ? "" : text(" dp_bins %d", dp_bins_);
  const std::string surface =
      smooth_ ? "smooth"
      : profile_path_.empty()
          ? "rq " + asperity::setting(r_q_) + " lambda_c " + asperity::setting(lambda_c_) + bins
          : "profile " + profile_path_ + bins;
  std::string spread =
      spread_ + (spec_.tilt == ASP_TILT_PLANE ? " plane" : " isotropic") +
      (spec_.collisions == ASP_COLLISIONS_SINGLE ? " collisions single" : " collisions multiple");
  if (tolerance_ > 0)
    spread += " tolerance " + asperity::setting(tolerance_);
  const asp_rebound_law *law = asp_rebound_find(spec_.rebound, NULL);
  std::string rebound = law->name + (table_path_.empty() ? "" : " " + table_path_);
  for (int i = 0; i < law->n_parameters; i++)
    rebound +=
        std::string(" ") + law->parameters[i].name + " " + asperity::setting(spec_.parameters[i]);
  return {{"geometry", geometry_},
          {"surface", surface},
          {"spread", spread},
          {"rebound", rebound},
          {"materials", materials_text_},
          {"deposit", DEPOSITS[deposit_]},
          {"timing", timing_ == EXACT ? "exact" : "overlap"},
          {"seed", std::to_string(seed_)}};
}

/* The script is what counts; but it should not differ unnoticed. */
void FixWallRebound::compare_settings(const asperity::Settings &saved) {
  const std::string changes = asperity::describe_changes(settings(), saved);
  if (!changes.empty())
    warn("the script differs from the restart file, and the script is taken; " + changes);
}

/* Of a mesh in all; before meshes are shared out among the ranks, each has all of them. */
int64_t FixWallRebound::triangles(int m) const {
  TriMesh *mesh = mesh_list()[m]->triMesh();
  return mesh->sizeGlobal() > 0 ? mesh->sizeGlobal() : mesh->sizeLocal();
}

void FixWallRebound::write_restart(FILE *file) {
  asperity::WallState state = asperity::WallState();
  state.settings = settings();
  if (ledger_)
    tell_lost(ledger_->save(state.ledger));
  state.counters.resize(N_COUNTERS);
  MPI_Allreduce(counters_, state.counters.data(), N_COUNTERS, MPI_DOUBLE, MPI_SUM, world);
  std::vector<double> totals(totals_.size());
  MPI_Allreduce(totals_.data(), totals.data(), static_cast<int>(totals.size()), MPI_DOUBLE, MPI_SUM,
                world);
  if (!is_mesh_wall())
    state.totals = totals;
  for (int m = 0; m < n_meshes(); m++) {
    const auto begin = totals.begin() + m * N_TOTALS;
    state.meshes.push_back(asperity::MeshState{
        mesh_ids_[m], triangles(m), std::vector<double>(begin, begin + N_TOTALS),
        saved_maps_.empty() ? maps_[m]->gather(world) : saved_maps_[m]});
  }
  memcpy(state.d_range, d_range_, sizeof d_range_);
  state.clock[0] = clock_.time;
  state.clock[1] = clock_.step;
  state.clock[2] = clock_.dt;
  if (comm->me != 0)
    return;
  const std::vector<char> record = asperity::pack(state);
  const int size = static_cast<int>(record.size());
  fwrite(&size, sizeof(int), 1, file);
  fwrite(record.data(), 1, record.size(), file);
}

/* LIGGGHTS does not tell how long the buffer is. */
void FixWallRebound::restart(char *buffer) {
  asperity::WallState saved;
  try {
    saved = asperity::unpack(buffer);
    if (saved.counters.size() != N_COUNTERS)
      throw asperity::Error(
          text("the restart file's record of this wall has %d counters; they must "
               "be %d",
               static_cast<int>(saved.counters.size()), N_COUNTERS));
  } catch (const asperity::Error &wrong) {
    fail(wrong.what());
  }
  compare_settings(saved.settings);
  memcpy(d_range_, saved.d_range, sizeof d_range_);
  clock_ = Clock{saved.clock[0], saved.clock[1], saved.clock[2]};
  if (comm->me == 0)
    std::copy(saved.counters.begin(), saved.counters.end(), counters_);
  continue_meshes(saved);
  if (ledger_)
    ledger_->restore(saved.ledger);
  restarted_ = true;
}

/* Totals and maps, those of a mesh only where it is the same one. */
void FixWallRebound::continue_meshes(const asperity::WallState &saved) {
  std::vector<std::pair<std::string, int64_t>> meshes;
  for (int m = 0; m < n_meshes(); m++)
    meshes.push_back(std::make_pair(mesh_ids_[m], triangles(m)));
  std::string lost;
  const std::vector<int> found = asperity::match_meshes(saved, meshes, lost);
  if (!lost.empty())
    warn("not continued by a mesh, but kept in the wall's own counters: " + lost);
  if (!is_mesh_wall() && comm->me == 0 && saved.totals.size() == N_TOTALS)
    totals_ = saved.totals;
  saved_maps_.resize(n_meshes());
  mesh_now_.assign(saved.meshes.size(), 0);
  for (int m = 0; m < n_meshes(); m++) {
    if (found[m] < 0)
      continue;
    const asperity::MeshState &mesh = saved.meshes[found[m]];
    mesh_now_[found[m]] = m + 1;
    saved_maps_[m] = mesh.map;
    if (comm->me == 0 && mesh.totals.size() == N_TOTALS)
      std::copy(mesh.totals.begin(), mesh.totals.end(), &totals_[m * N_TOTALS]);
  }
}

/* What is stuck knows its mesh by a number, which another script may have changed. What is stuck to
 * a mesh that is gone stays where it is. */
void FixWallRebound::renumber_stuck() {
  for (int i = 0; fix_place_ && !mesh_now_.empty() && i < atom->nlocal; i++) {
    double *s = place(i);
    const int before = static_cast<int>(s[STUCK_MESH]);
    if (state(i)[STATE] == FREE || before < 1 || before > static_cast<int>(mesh_now_.size()))
      continue;
    s[STUCK_MESH] = mesh_now_[before - 1];
    if (mesh_now_[before - 1] == 0)
      vectorZeroize3D(s + STUCK_V);
  }
  mesh_now_.clear();
}
