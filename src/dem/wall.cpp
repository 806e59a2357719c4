/* A rough wall in a simulation; see wall.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/wall.h"

#include <math.h>
#include <algorithm>

#include "contact/vector.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

const char Wall::KEYWORDS[] = "ledger torque_about interlock temperature_of ";

/* ---- the command ---- */

/* A shape with another kind of lay than the description. */
static void check_lay(const Setup &setup) {
  const asp_lay_kind kind = setup.model.lay().kind;
  for (const Member &member : setup.shapes)
    if (kind != ASP_LAY_NONE && kind != member.shape->lay_kind())
      throw Error(std::string("lay is ") + (kind == ASP_LAY_ANGLE ? "an angle" : "a vector") +
                  "; of a " +
                  (member.shape->lay_kind() == ASP_LAY_ANGLE
                       ? "cylinder it must be axial, circumferential, or an angle in degrees from "
                         "its axis"
                       : "plane or a mesh it must be a vector, X Y Z"));
}

/* A shape across a periodic direction. */
static void check_box(const Setup &setup) {
  for (const Member &member : setup.shapes)
    for (int d = 0; d < 3; d++)
      if (setup.box.period[d] > 0 && member.shape->bars(d))
        throw Error(text("the wall '%s' stands across %c, along which the box is periodic: a "
                         "particle that leaves the box would come back on the other side of the "
                         "wall; the boundary along %c must not be p, or the wall must be a mesh, "
                         "which repeats with the box",
                         setup.geometry.c_str(), "xyz"[d], "xyz"[d]));
}

static std::vector<int> wall_types(const Setup &setup) {
  std::vector<int> types;
  for (const Member &member : setup.shapes)
    if (std::find(types.begin(), types.end(), member.wall_type) == types.end())
      types.push_back(member.wall_type);
  return types;
}

Wall::Wall(const Engine &engine)
    : setup(engine), rows(), books(setup, rows), grains(setup, rows, false),
      bodies(setup, body_rows, true), begins(false), is_rough(false), has_valleys(false),
      has_flow(false), has_lay(false), is_still(false), has_to_delete(false), is_cut(false),
      is_passed(false), dt_ahead(0), fastest_(0), warned_(false), warned_of_passing_(false) {}

void Wall::add_shape(std::unique_ptr<Shape> shape, int wall_type, size_t pieces,
                     const std::string &name) {
  setup.shapes.push_back(Member{std::move(shape), name, wall_type, pieces});
  books.add_shape();
}

void Wall::parse(Words &words, const std::string &geometry, const std::string &own_words,
                 const std::function<bool(Words &)> &own) {
  setup.geometry = geometry;
  while (!words.done()) {
    if ((own && own(words)) || books.parse(words))
      continue;
    if (words.is("map"))
      throw Error("'map' is of the triangles of LAMMPS's 'stl FILE'; LIGGGHTS writes those of a "
                  "mesh by 'dump mesh/vtk'");
    if (words.take("temperature_of"))
      setup.temperature_of = words.word("the value of 'temperature_of'");
    else if (words.take("interlock")) {
      const std::string word = words.word("the value of 'interlock'");
      if (word != "on" && word != "off")
        throw Error("interlock is '" + word + "'; it must be on or off");
      setup.interlocks = word == "on";
    } else
      setup.model.parse(words, KEYWORDS + own_words);
  }
  setup.model.finish(!setup.temperature_of.empty());
  check_lay(setup);
}

/* ---- a run ---- */

void Wall::init(int64_t step, double dt) {
  setup.model.prepare(wall_types(setup));
  setup.find_temperatures();
  setup.set_clock(step, dt);
  books.init();
  const std::string report = setup.model.take_report();
  if (!report.empty())
    setup.engine.print("fix " + setup.engine.id() + " wall/rebound: " + report);
}

void Wall::begin_run(const Spheres &s, int groupbit, const Box &box) {
  setup.groupbit = groupbit;
  setup.box = box;
  check_box(setup);
  books.begin_run();
  for (int i = 0; i < s.n && is_restored(); i++)
    if (Memory *of = rows.find(i)) {
      renumber(shape_now_, rows.state[i], *of);
      for (Stuck &at : of->stuck)
        if (!(at.shape >= 1)) /* it stays where it is before the engine moves it */
          aspi_copy(s.x + 3 * static_cast<size_t>(i), at.at);
    }
  shape_now_.clear();
  is_rough = setup.model.wall() && asp_wall_surface(setup.model.wall());
  has_valleys = is_rough && setup.interlocks && setup.model.dissipates();
  has_flow = setup.model.has_flow();
  has_lay = setup.model.lay().kind != ASP_LAY_NONE || setup.engine.dimension() == 2;
  begins = true;
  grains.begin_run(setup, s);
  fastest_ = 0;
  reorder(s);
  warn_of_speeds();
}

/* The ball around a box. */
static Course around(const Bounds &box) {
  Course ball = {{}, {}, 0, 0, 0, 1};
  for (int d = 0; d < 3; d++)
    ball.x[d] = 0.5 * (box.lo[d] + box.hi[d]);
  ball.reach = hypot(hypot(box.hi[0] - ball.x[0], box.hi[1] - ball.x[1]), box.hi[2] - ball.x[2]);
  return ball;
}

void Wall::check_use(const Bounds *box, const char *empty_group) {
  for (const Member &member : setup.shapes) {
    if (box && !(member.shape->travel(setup.dt) > 0) &&
        member.shape->clear(around(*box), FaceList()) >= 1)
      setup.engine.warn("the wall '" + setup.geometry + "' lies outside of the box, " +
                        box->describe() +
                        ", and nothing meets it; is it in another unit of length?");
    const asp_lay lay = setup.model.lay();
    int mine = lay.kind == ASP_LAY_VECTOR && member.shape->is_across(lay.vector), all;
    MPI_Allreduce(&mine, &all, 1, MPI_INT, MPI_MIN, setup.engine.world());
    if (all)
      setup.engine.warn(text("the lay, %g %g %g, is along the normal of '%s', so that it has no "
                             "direction on the wall: all flights count as across it",
                             lay.vector[0], lay.vector[1], lay.vector[2],
                             (member.name.empty() ? setup.geometry : member.name).c_str()));
  }
  if (empty_group)
    setup.engine.warn(text("group '%s' has no particles: nothing meets this wall until some come "
                           "into it",
                           empty_group));
}

void Wall::set_rows(double *state) {
  rows.state = reinterpret_cast<MoverState *>(state);
}

void Wall::reorder(const Spheres &s) {
  has_to_delete = false;
  grains.list(s, setup.groupbit);
  for (const StuckOne &one : grains.stuck) {
    Stuck &at = rows.stuck(one.i);
    Load &load = rows.own(one.i).load;
    if (at.is_kept > 0 && books.is_in_step() && !(load.waits > 0)) {
      load.waits = 1;
      rows.loaded[static_cast<size_t>(one.i)] = 1;
      aspi_copy(rows.state[one.i].force, load.force);
      aspi_scale(0.5, load.force); /* a half is over */
      aspi_copy(rows.state[one.i].point, load.point);
    }
    at.is_kept = 0;
  }
  books.reorder(s.n);
  check_speeds(s);
}

void Wall::set_dt(int64_t step, double dt) {
  if (setup.dt >= dt && setup.dt <= dt)
    return;
  setup.set_clock(step, dt);
  clear_ahead(); /* it counts steps */
}

/* Each rank checks its own particles at every neighbor build. The ranks exchange results only when
 * something is printed, so none waits for another in between. */
void Wall::check_speeds(const Spheres &s) {
  for (int i = 0; !warned_ && i < s.n; i++) {
    const double *v = s.v + 3 * static_cast<size_t>(i);
    const double square = aspi_dot(v, v), limit = fastest_ * s.radius[i];
    if (s.mask[i] & setup.groupbit && square > limit * limit)
      fastest_ = sqrt(square) / s.radius[i];
  }
}

void Wall::warn_of_speeds() {
  int mine[2] = {is_cut, is_passed}, any[2];
  MPI_Allreduce(mine, any, 2, MPI_INT, MPI_MAX, setup.engine.world());
  is_cut = is_passed = false;
  if (any[1] && !warned_of_passing_)
    setup.engine.warn(
        "the wall has closed on a particle that has no room, or has gone over one that is stuck to "
        "another wall; such particles may pass it, and are among the guarded contacts");
  warned_of_passing_ = warned_of_passing_ || any[1];
  if (any[0])
    setup.engine.warn(
        "a particle had more than 10000 contacts in one step, and stayed where the last "
        "one left it; the step is far too long for walls so near to each other");
  if (warned_)
    return;
  double worst;
  MPI_Allreduce(&fastest_, &worst, 1, MPI_DOUBLE, MPI_MAX, setup.engine.world());
  warned_ = worst * setup.dt > 1;
  if (warned_)
    setup.engine.warn(
        text("particles move far in a step: up to %.3g diameters", 0.5 * worst * setup.dt) +
        ". No contact is missed, but paths that forces bend, and walls that turn, are taken as "
        "straight within a step; where that counts, the largest safe step is " +
        quantity_of_time(1 / worst, setup.engine.units()));
}

void Wall::end_step(int64_t step, bool output) {
  if (output)
    warn_of_speeds();
  books.end_step(step);
}

void Wall::end_run() {
  warn_of_speeds();
  books.end_run();
}

double Wall::stuck() const {
  double mine = static_cast<double>(grains.stuck.size() + bodies.stuck.size()), all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, setup.engine.world());
  return all;
}

double Wall::worn_density(size_t shape) const {
  return setup.model.worn_density(setup.shapes[shape].wall_type);
}

double Wall::bytes() const {
  size_t all = grains.bytes() + bodies.bytes() + books.bytes();
  for (const Member &member : setup.shapes)
    all += member.shape->bytes();
  return static_cast<double>(all);
}

/* ---- restart ---- */

std::vector<char> Wall::save() {
  WallState state = WallState();
  state.bodies = gather(body_rows.pack(), setup.engine.world());
  state.settings = settings();
  books.save(state);
  std::copy(setup.model.sizes(), setup.model.sizes() + 2, state.d_range);
  state.clock[0] = setup.clock.time;
  state.clock[1] = setup.clock.step;
  state.clock[2] = setup.clock.dt;
  const std::vector<char> record = setup.engine.rank() == 0 ? pack(state) : std::vector<char>();
  uint64_t size = record.size();
  MPI_Bcast(&size, sizeof size, MPI_BYTE, 0, setup.engine.world());
  check_record_size(size);
  return record;
}

Settings Wall::settings() const {
  Settings all{{"geometry", setup.geometry},
               {"description", setup.model.description()},
               {"interlock", setup.interlocks ? "on" : "off"},
               {"torque_about", books.torque_about()}};
  if (!setup.temperature_of.empty())
    all.push_back({"temperature_of", setup.temperature_of});
  return all;
}

/* The script is what counts; but it should not differ unnoticed. */
void Wall::restore(const char *record) {
  const WallState saved = unpack(record);
  books.restore(saved);
  const std::string changes = describe_changes(clauses(settings()), clauses(saved.settings));
  if (!changes.empty())
    setup.engine.warn("the script differs from the restart file, and the script is taken; " +
                      changes);
  setup.model.set_sizes(saved.d_range);
  setup.clock = Clock{saved.clock[0], saved.clock[1], saved.clock[2]};
  dt_ahead = setup.clock.dt;
  restore_meshes(saved);
  if (setup.engine.rank() == 0) /* from which they are claimed */
    body_rows.restore(saved.bodies, [this](MoverState &state, Memory &memory) {
      renumber(shape_now_, state, memory);
    });
}

/* Totals and sums of each mesh that is the same as before. */
void Wall::restore_meshes(const WallState &saved) {
  std::string lost;
  const auto lose = [&lost](const std::vector<double> &totals, const std::string &of) {
    lost += (lost.empty() ? "the " : "; the ") + setting(totals.empty() ? 0 : totals[0]) +
            " impacts of " + of;
  };
  const bool has_meshes = !setup.shapes[0].name.empty();
  if (has_meshes && !saved.totals.empty())
    lose(saved.totals, "the primitive wall");
  shape_now_.assign(std::max(saved.meshes.size(), static_cast<size_t>(1)), 0);
  shape_now_[0] = saved.meshes.empty() && !has_meshes;
  for (size_t k = 0; k < saved.meshes.size(); k++) {
    const MeshState &mesh = saved.meshes[k];
    size_t m = 0;
    while (m < setup.shapes.size() && setup.shapes[m].name != mesh.id)
      m++;
    if (m == setup.shapes.size())
      lose(mesh.totals, "mesh '" + mesh.id + "', which is not one of this wall");
    else if (setup.shapes[m].pieces != static_cast<size_t>(mesh.triangles))
      lose(mesh.totals, "mesh '" + mesh.id + "', which had " + std::to_string(mesh.triangles) +
                            " triangles and has " + std::to_string(setup.shapes[m].pieces));
    else {
      shape_now_[k] = static_cast<int>(m) + 1;
      books.restore_mesh(m, mesh);
      setup.shapes[m].shape->restore_motion(mesh.motion);
    }
  }
  if (!lost.empty())
    setup.engine.warn("not continued by a mesh, but kept in the wall's own counters: " + lost);
}

void Wall::renumber(const std::vector<int> &shape_now, MoverState &state, Memory &memory) {
  const auto now = [&](double saved) {
    return saved >= 1 && saved <= static_cast<double>(shape_now.size())
               ? shape_now[static_cast<size_t>(saved) - 1]
               : 0;
  };
  for (Stuck &at : memory.stuck)
    at.shape = now(at.shape);
  for (Rest &rest : memory.rests)
    rest.shape = now(rest.shape);
  memory.rests.erase(std::remove_if(memory.rests.begin(), memory.rests.end(),
                                    [](const Rest &rest) { return !(rest.shape >= 1); }),
                     memory.rests.end());
  if (memory.rests.empty() && state.status < 0)
    state.status = static_cast<double>(Status::FREE);
}
