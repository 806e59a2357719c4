/* A rough wall in a simulation; see wall.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/wall.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <algorithm>
#include <new>

#include "contact/contact.h"
#include "contact/vector.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

const char Wall::KEYWORDS[] = "ledger torque_about interlock";
const char *const Wall::SUM_NAMES[] = {"impacts",        "deposited_mass",     "impact_energy",
                                       "normal_impulse", "tangential_impulse", "dissipated_energy",
                                       "eroded_mass"};

namespace {

/* Triangles per MPI_Allreduce. */
const size_t SHOWN = 32768;

/* Distance per step by which a particle may stray from its predicted path, in radii of the smallest
 * particle. */
const double STRAY = 2e-3;

/* Largest bend of the path by sustained contacts within a step, as a share of that distance. */
const double BEND = 0.25;

} // namespace

Wall::Wall(const Engine &engine)
    : engine_(engine), model_(engine), key_(asp_key_wall(engine.id().c_str())),
      stay_key_(asp_key_wall((engine.id() + " stays").c_str())), interlocks_(true), groupbit_(1),
      box_(), state_(NULL), place_(NULL), ahead_(), travel_(0), stray_(0), bend_(0), counters_(),
      torque_about_(), clock_(), fastest_(), dt_(0), warned_(false), cut_(false),
      has_to_delete_(false) {}

Wall::Sums::Sums(size_t count)
    : count_(count), numbers_(static_cast<double *>(calloc(count + 1, sizeof(double))), free) {
  if (!numbers_)
    throw std::bad_alloc();
}

void Wall::add_shape(std::unique_ptr<Shape> shape, int wall_type, size_t pieces,
                     const std::string &name) {
  Member member = {std::move(shape), name, wall_type, false, {}, Sums(pieces * N_SUMS)};
  shapes_.push_back(std::move(member));
}

void Wall::parse(Words &words, const std::string &geometry, OwnKeywords *own) {
  geometry_ = geometry;
  const std::string others = KEYWORDS + (own ? " " + own->keywords() : "");
  while (!words.done()) {
    if (own && own->parse(words))
      continue;
    if (words.take("ledger"))
      parse_ledger(words);
    else if (words.take("torque_about"))
      for (int d = 0; d < 3; d++)
        torque_about_[d] = words.number("a coordinate of 'torque_about'");
    else if (words.take("columns"))
      throw Error("'columns' belongs behind 'ledger': ledger N columns full");
    else if (words.take("on_error"))
      throw Error("'on_error' belongs behind 'ledger': ledger N file FILE on_error stop");
    else if (words.take("interlock"))
      parse_interlock(words);
    else
      model_.parse(words, others);
  }
  model_.finish();
  for (const Member &member : shapes_)
    if (model_.lay().kind != ASP_LAY_NONE && model_.lay().kind != member.shape->lay_kind())
      throw Error(std::string("lay is ") +
                  (model_.lay().kind == ASP_LAY_ANGLE ? "an angle" : "a vector") + "; of a " +
                  (member.shape->lay_kind() == ASP_LAY_ANGLE
                       ? "cylinder it must be axial, circumferential, or an angle in degrees from "
                         "its axis"
                       : "plane or a mesh it must be a vector, X Y Z"));
}

void Wall::parse_interlock(Words &words) {
  const std::string word = words.word("the value of 'interlock'");
  if (word != "on" && word != "off")
    throw Error("interlock is '" + word + "'; it must be on or off");
  interlocks_ = word == "on";
}

void Wall::parse_ledger(Words &words) {
  const int64_t every = static_cast<int64_t>(words.whole("ledger", 1, 2147483647.0));
  std::string path, on_error, columns;
  for (bool more = true; more;) {
    if (words.take("file"))
      path = words.word("the file of 'ledger'");
    else if (words.take("on_error"))
      on_error = words.word("the value of 'on_error'");
    else if (words.take("columns"))
      columns = words.word("the value of 'columns'");
    else
      more = false;
  }
  if (!on_error.empty() && on_error != "stop" && on_error != "go_on")
    throw Error("on_error is '" + on_error + "'; it must be stop or go_on");
  if (!columns.empty() && columns != "full")
    throw Error("columns is '" + columns + "'; it must be full");
  if (!on_error.empty() && path.empty())
    throw Error("on_error is of a ledger's file; 'ledger N file FILE' must come with it");
  ledger_.reset(new Ledger(engine_.world(), every, path,
                           on_error == "go_on" ? Ledger::GO_ON : Ledger::STOP,
                           columns.empty() ? Ledger::N_COLUMNS : Ledger::N_FULL));
}

/* ---- before a run -----------------------------------------------------------------------------
 */

void Wall::init(int64_t step, double dt) {
  std::vector<int> types;
  for (const Member &member : shapes_)
    if (std::find(types.begin(), types.end(), member.wall_type) == types.end())
      types.push_back(member.wall_type);
  model_.prepare(types);
  set_clock(step, dt);
  if (ledger_) {
    const std::string report = ledger_->open(heading());
    if (!report.empty())
      engine_.print(report);
  }
  const std::string report = model_.take_report();
  if (!report.empty())
    engine_.print("fix " + engine_.id() + " wall/rebound: " + report);
}

std::string Wall::heading() const {
  return text("asperity %s; fix %s wall/rebound; units %s; ", asp_version(), engine_.id().c_str(),
              engine_.units().c_str()) +
         model_.heading() + "; angles in degrees";
}

/* Throws an Error if a shape stands across a periodic direction. */
void Wall::check_box() const {
  for (const Member &member : shapes_)
    for (int d = 0; d < 3; d++)
      if (box_.period[d] > 0 && member.shape->bars(d))
        throw Error(text("the wall '%s' stands across %c, along which the box is periodic: a "
                         "particle that leaves the box would come back on the other side of the "
                         "wall; the boundary along %c must not be p, or the wall must be a mesh, "
                         "which repeats with the box",
                         geometry_.c_str(), "xyz"[d], "xyz"[d]));
}

void Wall::setup(const Spheres &spheres, int groupbit, const Box &box) {
  groupbit_ = groupbit;
  box_ = box;
  check_box();
  dt_ = spheres.dt;
  fastest_ = Fastest();
  travel_ = 0;
  double least, most;
  engine_.diameters(least, most);
  stray_ = STRAY * 0.5 * least;
  bend_ = BEND * stray_;
  for (Member &member : shapes_)
    member.measures = member.shape->measures();
  for (int i = 0; i < spheres.n; i++) {
    if (model_.deposit() == Model::OFF && is_stuck(i))
      set_status(i, Status::FREE); /* an earlier part of the run had deposits */
  }
  renumber(spheres);
  look_anew();
  for (int i = 0; i < spheres.n; i++) {
    const size_t shape = static_cast<size_t>(place(i).stuck.shape) - 1;
    if (is_stuck(i) && shape < shapes_.size() &&
        model_.removes(spheres.type[i], shapes_[shape].wall_type, 2 * spheres.radius[i]))
      set_status(i, Status::FREE); /* it had no such flow */
  }
  reorder(spheres);
  warn_of_speeds();
}

void Wall::reorder(const Spheres &spheres) {
  stuck_.clear();
  touching_.clear();
  has_to_delete_ = false;
  for (int i = 0; i < spheres.n; i++)
    if (is_stuck(i))
      stuck_.push_back(i);
    else if (status(i) != Status::FREE)
      touching_.push_back(i);
  const size_t n = static_cast<size_t>(spheres.n);
  if (!repeats())
    look_anew();
  ahead_.due.resize(n);
  ahead_.v.resize(3 * n);
  ahead_.tag.resize(n, -1);
  for (size_t i = 0; i < n; i++) { /* predictions of other particles are void */
    const int64_t tag = spheres.tag_of(static_cast<int>(i));
    if (ahead_.tag[i] == tag)
      continue;
    ahead_.tag[i] = tag;
    ahead_.due[i] = 0;
  }
  check_speeds(spheres);
}

/* True if all shapes look the same to a particle that has crossed a periodic edge of the box. */
bool Wall::repeats() const {
  bool all = true;
  for (const Member &member : shapes_)
    for (int d = 0; d < 3; d++)
      all = all && (!(box_.period[d] > 0) || member.shape->repeats(d));
  return all;
}

/* One formula for the time of a step, whether or not the run was interrupted before it. */
void Wall::set_clock(int64_t step, double dt) {
  const double now = static_cast<double>(step);
  dt_ = dt;
  if (!(clock_.dt > 0))
    clock_ = Clock{engine_.time(), now, dt};
  else if (clock_.dt < dt || clock_.dt > dt)
    clock_ = Clock{time(now), now, dt};
}

double Wall::time(double step) const {
  return clock_.time + (step - clock_.step) * clock_.dt;
}

void Wall::reset_dt(int64_t step, double dt) {
  set_clock(step, dt);
  look_anew(); /* it counts steps */
}

void Wall::reset_step(int64_t now, int64_t before) {
  clock_.step += static_cast<double>(now - before);
}

/* Each rank checks its own particles at every neighbor build. The ranks exchange results only when
 * something is printed, so none waits for another in between. */
void Wall::check_speeds(const Spheres &s) {
  for (int i = 0; !warned_ && i < s.n; i++) {
    const double *v = s.v + 3 * static_cast<size_t>(i);
    const double square = aspi_dot(v, v), limit = fastest_.ratio * s.radius[i];
    if (!(s.mask[i] & groupbit_) || square <= limit * limit)
      continue;
    fastest_ = Fastest{sqrt(square) / s.radius[i], 2 * s.radius[i], sqrt(square)};
  }
}

void Wall::warn_of_speeds() {
  int cut = cut_, any_cut;
  MPI_Allreduce(&cut, &any_cut, 1, MPI_INT, MPI_MAX, engine_.world());
  cut_ = false;
  if (any_cut)
    engine_.warn("a particle had more than 10000 contacts in one step, and stayed where the last "
                 "one left it; the step is far too long for walls so near to each other");
  if (warned_)
    return;
  int rank;
  MPI_Comm_rank(engine_.world(), &rank);
  struct {
    double ratio;
    int rank;
  } mine = {fastest_.ratio, rank}, worst;
  MPI_Allreduce(&mine, &worst, 1, MPI_DOUBLE_INT, MPI_MAXLOC, engine_.world());
  if (worst.ratio * dt_ <= 1)
    return;
  double fastest[2] = {fastest_.d_p, fastest_.speed};
  MPI_Bcast(fastest, 2, MPI_DOUBLE, worst.rank, engine_.world());
  warned_ = true;
  engine_.warn(text("particles move far in a step: one of diameter %g moves at %g, which is %.3g "
                    "diameters in a step of %g. No contact is missed, but paths that forces bend, "
                    "and walls that turn, are taken as straight within a step; where that counts, "
                    "the largest safe step is %g",
                    fastest[0], fastest[1], 0.5 * worst.ratio * dt_, dt_, 1 / worst.ratio));
}

/* ---- output -----------------------------------------------------------------------------------
 */

void Wall::end_step(int64_t step, bool output) {
  if (output)
    warn_of_speeds();
  if (ledger_)
    check_written(ledger_->end_step(step));
}

/* If rows cannot be written, ends the run or warns, as the script chooses. */
void Wall::check_written(const std::string &wrong) const {
  if (wrong.empty())
    return;
  if (ledger_->on_error() == Ledger::STOP)
    throw Error(wrong);
  engine_.warn(wrong);
}

void Wall::end_run() {
  warn_of_speeds();
  if (ledger_)
    check_written(ledger_->flush());
}

/* The counters, and behind them the totals of each shape. */
double Wall::number(size_t k) const {
  if (numbers_.empty()) {
    std::vector<double> mine(counters_, counters_ + N_COUNTERS);
    for (const Member &member : shapes_)
      mine.insert(mine.end(), member.totals, member.totals + N_TOTALS);
    numbers_.resize(mine.size());
    MPI_Allreduce(mine.data(), numbers_.data(), static_cast<int>(mine.size()), MPI_DOUBLE, MPI_SUM,
                  engine_.world());
  }
  return numbers_[k];
}

double Wall::counter(int k) const {
  const double sum = number(static_cast<size_t>(k));
  return k >= FORCE && k < TORQUE + 3 && dt_ > 0 ? sum / dt_ : sum;
}

double Wall::stuck() const {
  double mine = static_cast<double>(stuck_.size()), all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, engine_.world());
  return all;
}

double Wall::total(size_t shape, int k) const {
  return number(N_COUNTERS + shape * N_TOTALS + static_cast<size_t>(k));
}

std::vector<double> Wall::sums(size_t shape) const {
  std::vector<double> all;
  show_sums(shape, [&all](size_t, const std::vector<double> &some) {
    all.insert(all.end(), some.begin(), some.end());
  });
  return all;
}

void Wall::show_sums(size_t shape,
                     const std::function<void(size_t, const std::vector<double> &)> &show) const {
  const Sums &mine = shapes_[shape].sums;
  const size_t most = SHOWN * N_SUMS;
  std::vector<double> some;
  for (size_t first = 0; first < mine.size(); first += most) {
    some.resize(std::min(most, mine.size() - first));
    MPI_Allreduce(mine.data() + first, some.data(), static_cast<int>(some.size()), MPI_DOUBLE,
                  MPI_SUM, engine_.world());
    show(first / N_SUMS, some);
  }
}

double Wall::bytes() const {
  size_t all = stuck_.capacity() * sizeof(int) + ahead_.due.capacity() * sizeof(int) +
               ahead_.v.capacity() * sizeof(float) + ahead_.tag.capacity() * sizeof(int64_t);
  for (const Member &member : shapes_)
    all += member.shape->bytes() + member.sums.size() * sizeof(double);
  return static_cast<double>(all) + (ledger_ ? ledger_->memory_usage() : 0);
}

/* ---- restart ----------------------------------------------------------------------------------
 */

std::vector<char> Wall::save() {
  WallState state = WallState();
  state.settings = settings();
  if (ledger_)
    check_written(ledger_->save(state.ledger));
  for (int k = 0; k < N_COUNTERS; k++)
    state.counters.push_back(number(static_cast<size_t>(k)));
  for (size_t m = 0; m < shapes_.size(); m++) {
    std::vector<double> totals;
    for (int k = 0; k < N_TOTALS; k++)
      totals.push_back(total(m, k));
    const Member &member = shapes_[m];
    if (member.name.empty())
      state.totals = totals;
    else
      state.meshes.push_back(MeshState{member.name,
                                       static_cast<int64_t>(member.sums.size() / N_SUMS), totals,
                                       sums(m), member.shape->motion_record()});
  }
  std::copy(model_.sizes(), model_.sizes() + 2, state.d_range);
  state.clock[0] = clock_.time;
  state.clock[1] = clock_.step;
  state.clock[2] = clock_.dt;
  int rank;
  MPI_Comm_rank(engine_.world(), &rank);
  const std::vector<char> record = rank == 0 ? pack(state) : std::vector<char>();
  uint64_t size = record.size();
  MPI_Bcast(&size, sizeof size, MPI_BYTE, 0, engine_.world());
  check_record_size(size);
  return record;
}

Settings Wall::settings() const {
  const double *at = torque_about_;
  return Settings{{"geometry", geometry_},
                  {"description", model_.description()},
                  {"interlock", interlocks_ ? "on" : "off"},
                  {"torque_about", text("%.15g %.15g %.15g", at[0], at[1], at[2])}};
}

/* The script is what counts; but it should not differ unnoticed. */
void Wall::restore(const char *record) {
  const WallState saved = unpack(record);
  if (saved.counters.size() != N_COUNTERS)
    throw Error(text("the restart file's record of this wall has %d counters; there must be %d",
                     static_cast<int>(saved.counters.size()), N_COUNTERS));
  const std::string changes = describe_changes(clauses(settings()), clauses(saved.settings));
  if (!changes.empty())
    engine_.warn("the script differs from the restart file, and the script is taken; " + changes);
  model_.set_sizes(saved.d_range);
  clock_ = Clock{saved.clock[0], saved.clock[1], saved.clock[2]};
  int rank;
  MPI_Comm_rank(engine_.world(), &rank);
  if (rank == 0)
    std::copy(saved.counters.begin(), saved.counters.end(), counters_);
  restore_shapes(saved);
  numbers_.clear();
  if (ledger_)
    ledger_->restore(saved.ledger);
}

/* Totals and maps, those of a mesh only where it is the same one. */
void Wall::restore_shapes(const WallState &saved) {
  std::vector<std::pair<std::string, int64_t>> meshes;
  std::vector<size_t> member_of;
  int rank;
  MPI_Comm_rank(engine_.world(), &rank);
  for (size_t m = 0; m < shapes_.size(); m++) {
    Member &member = shapes_[m];
    if (!member.name.empty()) {
      meshes.push_back(
          std::make_pair(member.name, static_cast<int64_t>(member.sums.size() / N_SUMS)));
      member_of.push_back(m);
    } else if (rank == 0 && saved.totals.size() == N_TOTALS)
      std::copy(saved.totals.begin(), saved.totals.end(), member.totals);
  }
  std::string lost;
  const std::vector<int> found = match_meshes(saved, meshes, lost);
  if (!lost.empty())
    engine_.warn("not continued by a mesh, but kept in the wall's own counters: " + lost);
  shape_now_.assign(std::max(saved.meshes.size(), static_cast<size_t>(1)), 0);
  if (saved.meshes.empty() && meshes.empty())
    shape_now_[0] = 1;
  for (size_t k = 0; k < found.size(); k++) {
    if (found[k] < 0)
      continue;
    const MeshState &mesh = saved.meshes[found[k]];
    Member &member = shapes_[member_of[k]];
    shape_now_[found[k]] = static_cast<int>(member_of[k]) + 1;
    if (rank == 0 && mesh.totals.size() == N_TOTALS)
      std::copy(mesh.totals.begin(), mesh.totals.end(), member.totals);
    if (rank == 0 && mesh.map.size() == member.sums.size())
      std::copy(mesh.map.begin(), mesh.map.end(), member.sums.data());
    member.shape->restore_motion(mesh.motion);
  }
}
