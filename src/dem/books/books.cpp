/* Results of contacts at a wall; see books.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/books/books.h"

#include <stdlib.h>
#include <string.h>
#include <algorithm>
#include <new>

#include "contact/vector.h"
#include "dem/books/ledger_file.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

const char *const Books::SUM_NAMES[] = {"impacts",        "deposited_mass",     "impact_energy",
                                        "normal_impulse", "tangential_impulse", "dissipated_energy",
                                        "eroded_mass"};

/* Triangles per MPI_Allreduce. */
static const size_t SHOWN = 32768;

Books::Books(const Setup &setup, Memories &rows)
    : setup_(setup), rows_(rows), is_in_step_(false), counters_(), kept_(), step_(),
      torque_about_() {}

void Books::add_shape() {
  const size_t size = setup_.shapes.back().pieces * N_SUMS;
  ShapeSums shape = {
      false, {}, size, {static_cast<double *>(calloc(size + 1, sizeof(double))), free}};
  if (!shape.sums)
    throw std::bad_alloc();
  shapes_.push_back(std::move(shape));
}

/* ---- the command ---- */

bool Books::parse(Words &words) {
  if (words.take("ledger"))
    parse_ledger(words);
  else if (words.take("torque_about"))
    for (int d = 0; d < 3; d++)
      torque_about_[d] = words.number("a coordinate of 'torque_about'");
  else if (words.take("columns"))
    throw Error("'columns' belongs behind 'ledger': ledger N columns full");
  else if (words.take("on_error"))
    throw Error("'on_error' belongs behind 'ledger': ledger N file FILE on_error stop");
  else
    return false;
  return true;
}

void Books::parse_ledger(Words &words) {
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
  if (!words.done() && strpbrk(words.left_over()[0], "./"))
    throw Error("behind 'ledger', 'file " + words.word("") + "' is expected for a file");
  if (path.size() > 4 && path.compare(path.size() - 4, 4, ".npy") == 0)
    throw Error("the file of 'ledger' is '" + path + "'; ledgers are CSV, such as " +
                path.substr(0, path.size() - 4) + ".csv");
  if (!on_error.empty() && on_error != "stop" && on_error != "go_on")
    throw Error("on_error is '" + on_error + "'; it must be stop or go_on");
  if (!columns.empty() && columns != "full")
    throw Error("columns is '" + columns + "'; it must be full");
  if (!on_error.empty() && path.empty())
    throw Error("on_error is of a ledger's file; 'ledger N file FILE' must come with it");
  ledger_.reset(new Ledger(setup_.engine.world(), every, path,
                           on_error == "go_on" ? Ledger::GO_ON : Ledger::STOP,
                           columns.empty() ? Ledger::N_COLUMNS : Ledger::N_FULL));
}

std::string Books::torque_about() const {
  const double *at = torque_about_;
  return setting(at[0]) + " " + setting(at[1]) + " " + setting(at[2]);
}

/* ---- a run ---- */

void Books::init() {
  if (!ledger_)
    return;
  const Engine &engine = setup_.engine;
  const std::string heading = text("asperity %s; fix %s wall/rebound; units %s; ", asp_version(),
                                   engine.id().c_str(), engine.units().c_str()) +
                              setup_.model.description() + "; angles in degrees";
  const std::string report = ledger_->open(heading);
  if (!report.empty())
    engine.print(report);
}

void Books::begin_run() {
  for (size_t m = 0; m < shapes_.size(); m++)
    shapes_[m].measures = setup_.shapes[m].shape->measures();
}

void Books::reorder(int n) {
  loaded_.clear();
  waiting_.clear();
  kept_ = Impulses();
  for (int i = 0; i < n; i++) {
    char &any = rows_.loaded[static_cast<size_t>(i)];
    if (!any)
      continue;
    const Memory *of = rows_.find(i);
    const bool shows = aspi_dot(rows_.state[i].force, rows_.state[i].force) > 0;
    const bool waits = of && of->load.waits > 0;
    if (shows)
      loaded_.push_back(i);
    if (waits)
      waiting_.push_back(i);
    any = shows || waits;
  }
}

void Books::begin_step(int64_t step) {
  expire();
  is_in_step_ = true;
  if (ledger_)
    ledger_->begin_step(step);
}

void Books::begin_end() {
  expire();
  is_in_step_ = false;
  for (int i : loaded_)
    if (!(rows_.is_stuck(i) && rows_.stuck(i).is_kept > 0))
      for (int d = 0; d < 3; d++)
        rows_.state[i].force[d] = rows_.state[i].point[d] = 0;
  loaded_.clear();
  for (int i : waiting_) {
    Memory &of = rows_.own(i);
    aspi_copy(of.load.force, rows_.state[i].force);
    aspi_copy(of.load.point, rows_.state[i].point);
    of.load = Load();
  }
  loaded_.swap(waiting_);
}

/* Force and torque are the impulses of the whole step over its length, which may be 0. */
void Books::end_loads() {
  const double rate = setup_.dt > 0 ? 1 / setup_.dt : 0;
  for (int d = 0; d < 3; d++) {
    counters_[FORCE + d] = rate * step_.p[d];
    counters_[TORQUE + d] = rate * step_.turn[d];
    counters_[IMPULSE + d] += step_.p[d];
    counters_[ANGULAR_IMPULSE + d] += step_.turn[d];
  }
  step_ = Impulses();
  expire();
}

void Books::end_step(int64_t step) {
  if (ledger_)
    check_written(ledger_->end_step(step));
}

void Books::end_run() {
  if (ledger_)
    check_written(ledger_->flush());
}

/* If rows cannot be written, ends the run or warns, as the script chooses. */
void Books::check_written(const std::string &wrong) const {
  if (wrong.empty())
    return;
  if (ledger_->on_error() == Ledger::STOP)
    throw Error(wrong);
  setup_.engine.warn(wrong);
}

/* ---- loads ---- */

/* Adds to `count` sums of a piece from `first` on. */
void Books::ShapeSums::add_values(int piece, Sum first, int count, const double values[]) {
  for (int k = 0; k < count; k++)
    totals[first + k + (first + k > SUM_IMPACTS)] += values[k];
  double *of = size > 0 ? &sums[static_cast<size_t>(piece) * N_SUMS + first] : NULL;
  for (int k = 0; of && k < count; k++)
    of[k] += values[k];
}

Books::Impulses Books::impulses_at(const double point[3], const double p[3]) const {
  Impulses all;
  double arm[3];
  aspi_copy(p, all.p);
  aspi_subtract(point, torque_about_, arm);
  aspi_cross(arm, p, all.turn);
  return all;
}

void Books::add_impulses(const Impulses &all) {
  aspi_add_scaled(step_.p, 1, all.p, step_.p);
  aspi_add_scaled(step_.turn, 1, all.turn, step_.turn);
}

void Books::keep_load(int i, const double x[3], const double v[3], double mass) {
  double p[3] = {mass * v[0], mass * v[1], mass * v[2]};
  const Impulses its = impulses_at(x, p);
  aspi_add_scaled(kept_.p, 1, its.p, kept_.p);
  aspi_add_scaled(kept_.turn, 1, its.turn, kept_.turn);
  add_force(i, p, aspi_dot(v, v) > 0 ? x : p);
}

void Books::drop_load(int i, const double x[3], const double v[3], double mass, double share) {
  const double p[3] = {mass * v[0], mass * v[1], mass * v[2]};
  const Impulses its = impulses_at(x, p);
  MoverState &of = rows_.state[i];
  aspi_add_scaled(kept_.p, -1, its.p, kept_.p);
  aspi_add_scaled(kept_.turn, -1, its.turn, kept_.turn);
  if (share > 0)
    aspi_scale(share, of.force);
  loaded_.push_back(i);
}

void Books::add_force(int i, const double p[3], const double point[3]) {
  double *force = rows_.state[i].force, *at = rows_.state[i].point;
  rows_.loaded[static_cast<size_t>(i)] = 1;
  if (is_in_step_) {
    Load &load = rows_.own(i).load;
    if (!(load.waits > 0))
      waiting_.push_back(i);
    load.waits = 1;
    force = load.force;
    at = load.point;
  } else if (!(aspi_dot(force, force) > 0))
    loaded_.push_back(i);
  aspi_add_scaled(force, 1 / setup_.dt, p, force);
  aspi_copy(point, at);
}

void Books::add_load(size_t shape, const ContactLoad &load) {
  ShapeSums &sums = shapes_[shape];
  add_impulses(impulses_at(load.point, load.impulse));
  aspi_add_scaled(step_.turn, 1, load.couple, step_.turn);
  if (load.particle >= 0)
    add_force(load.particle, load.impulse, load.point);
  if (aspi_dot(load.n, load.n) > 0) {
    double along[3];
    const double normal = -aspi_dot(load.impulse, load.n);
    aspi_add_scaled(load.impulse, normal, load.n, along);
    const double values[] = {normal, aspi_length(along), load.dissipated, load.eroded};
    sums.add_values(load.piece, SUM_NORMAL, 4, values);
    counters_[DISSIPATED] += load.dissipated;
    counters_[ERODED] += load.eroded;
  }
  if (sums.measures)
    setup_.shapes[shape].shape->take(load);
}

void Books::count(const Impact &counted) {
  const asp_impact &impact = counted.result;
  const Contact &contact = counted.contact;
  const bool stuck = impact.outcome == ASP_DEPOSIT;
  const double mass = counted.mass, stuck_mass = stuck ? mass : 0;
  const double energy = 0.5 * mass * aspi_dot(counted.v1, counted.v1);
  counters_[N_IMPACTS]++;
  counters_[N_DEPOSITS] += stuck;
  counters_[DEPOSITED_MASS] += stuck_mass;
  counters_[N_LATER_HITS] += impact.hits - 1;
  counters_[N_CAPPED] += impact.capped;
  counters_[N_GUARDED] += contact.overlapped;
  ShapeSums &sums = shapes_[counted.shape];
  sums.totals[SHAPE_DEPOSITS] += stuck;
  const double values[] = {1, stuck_mass, energy};
  sums.add_values(contact.piece, SUM_IMPACTS, 3, values);
  add_load(counted.shape, counted.load);
  if (ledger_)
    record(counted);
}

void Books::record(const Impact &counted) {
  typedef Ledger L;
  const bool stuck = counted.result.outcome == ASP_DEPOSIT;
  LedgerRow row = impact_row(counted.v1, counted.load.n, counted.result);
  row[L::TAG] = static_cast<double>(counted.key.tag);
  row[L::IMPACT] = counted.key.impact;
  row[L::TIME] = counted.time;
  row[L::MESH] =
      setup_.shapes[counted.shape].pieces > 0 ? static_cast<double>(counted.shape) + 1 : 0;
  row[L::TRIANGLE] = counted.contact.piece;
  aspi_copy(counted.contact.x, &row[L::X]); /* it may be past a periodic edge */
  setup_.box.wrap(&row[L::X]);
  row[L::D_P] = counted.d_p;
  row[L::OUTCOME] = !stuck ? 0 : setup_.model.deposit() == Model::DELETE ? 2 : 1;
  row[L::STEP] = static_cast<double>(counted.step);
  row[L::MASS] = counted.mass;
  aspi_copy(counted.omega1, &row[L::OMEGA1X]);
  aspi_copy(counted.load.impulse, &row[L::IMPULSE_X]);
  row[L::ERODED_MASS] = counted.load.eroded;
  row[L::BODY] = static_cast<double>(counted.body);
  aspi_copy(counted.lever, &row[L::LEVER_X]);
  row[L::TEMPERATURE] = counted.temperature;
  ledger_->add_row(row);
}

/* ---- output ---- */

/* The counters, and behind them the totals of each shape. */
double Books::number(size_t k) const {
  if (numbers_.empty()) {
    std::vector<double> mine(counters_, counters_ + N_COUNTERS);
    for (const ShapeSums &shape : shapes_)
      mine.insert(mine.end(), shape.totals, shape.totals + N_TOTALS);
    numbers_.resize(mine.size());
    MPI_Allreduce(mine.data(), numbers_.data(), static_cast<int>(mine.size()), MPI_DOUBLE, MPI_SUM,
                  setup_.engine.world());
  }
  return numbers_[k];
}

double Books::counter(int k) const {
  return number(static_cast<size_t>(k));
}

double Books::total(size_t shape, int k) const {
  return number(N_COUNTERS + shape * N_TOTALS + static_cast<size_t>(k));
}

std::vector<double> Books::sums(size_t shape) const {
  std::vector<double> all;
  show_sums(shape, [&all](size_t, const std::vector<double> &some) {
    all.insert(all.end(), some.begin(), some.end());
  });
  return all;
}

void Books::show_sums(size_t shape,
                      const std::function<void(size_t, const std::vector<double> &)> &show) const {
  const ShapeSums &mine = shapes_[shape];
  const size_t most = SHOWN * N_SUMS;
  std::vector<double> some;
  for (size_t first = 0; first < mine.size; first += most) {
    some.resize(std::min(most, mine.size - first));
    MPI_Allreduce(&mine.sums[first], some.data(), static_cast<int>(some.size()), MPI_DOUBLE,
                  MPI_SUM, setup_.engine.world());
    show(first / N_SUMS, some);
  }
}

size_t Books::bytes() const {
  size_t all = ledger_ ? ledger_->bytes() : 0;
  for (const ShapeSums &shape : shapes_)
    all += shape.size * sizeof(double);
  return all;
}

/* ---- restart ---- */

void Books::save(WallState &state) {
  if (ledger_)
    check_written(ledger_->save(state.ledger));
  for (int k = 0; k < N_COUNTERS; k++)
    state.counters.push_back(number(static_cast<size_t>(k)));
  for (size_t m = 0; m < shapes_.size(); m++) {
    const Member &member = setup_.shapes[m];
    std::vector<double> totals;
    for (int k = 0; k < N_TOTALS; k++)
      totals.push_back(total(m, k));
    if (member.name.empty())
      state.totals = totals;
    else
      state.meshes.push_back(MeshState{member.name, static_cast<int64_t>(member.pieces), totals,
                                       sums(m), member.shape->motion_record()});
  }
}

void Books::restore(const WallState &saved) {
  if (saved.counters.size() != N_COUNTERS)
    throw Error(text("the restart file's record of this wall has %d counters; there must be %d",
                     static_cast<int>(saved.counters.size()), N_COUNTERS));
  expire();
  if (ledger_)
    ledger_->restore(saved.ledger);
  if (setup_.engine.rank() > 0)
    return;
  std::copy(saved.counters.begin(), saved.counters.end(), counters_);
  for (size_t m = 0; m < shapes_.size(); m++)
    if (setup_.shapes[m].name.empty() && saved.totals.size() == N_TOTALS)
      std::copy(saved.totals.begin(), saved.totals.end(), shapes_[m].totals);
}

void Books::restore_mesh(size_t shape, const MeshState &mesh) {
  ShapeSums &to = shapes_[shape];
  if (setup_.engine.rank() > 0)
    return;
  if (mesh.totals.size() == N_TOTALS)
    std::copy(mesh.totals.begin(), mesh.totals.end(), to.totals);
  if (mesh.map.size() == to.size)
    std::copy(mesh.map.begin(), mesh.map.end(), to.sums.get());
}
