/* A rough wall in a simulation; see wall.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/wall.h"

#include <math.h>
#include <string.h>
#include <algorithm>

#include "contact/vector.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

const char Wall::KEYWORDS[] = "ledger torque_about interlock";

Wall::Wall(const Engine &engine)
    : setup(engine), books(setup), stepper(setup, books), fastest_(), warned_(false),
      is_use_checked_(false) {}

void Wall::add_shape(std::unique_ptr<Shape> shape, int wall_type, size_t pieces,
                     const std::string &name) {
  setup.shapes.push_back(Member{std::move(shape), name, wall_type, pieces});
  books.add_shape();
}

void Wall::parse(Words &words, const std::string &geometry, OwnKeywords *own) {
  setup.geometry = geometry;
  const std::string others = KEYWORDS + (own ? " " + own->keywords() : "");
  while (!words.done()) {
    if ((own && own->parse(words)) || books.parse(words))
      continue;
    if (words.is("map"))
      throw Error("'map' is of the triangles of LAMMPS's 'stl FILE'; LIGGGHTS writes those of a "
                  "mesh by 'dump mesh/vtk'");
    if (words.take("interlock")) {
      const std::string word = words.word("the value of 'interlock'");
      if (word != "on" && word != "off")
        throw Error("interlock is '" + word + "'; it must be on or off");
      setup.interlocks = word == "on";
    } else
      setup.model.parse(words, others);
  }
  setup.model.finish();
  setup.check_lay();
}

/* ---- a run ------------------------------------------------------------------------------------
 */

void Wall::init(int64_t step, double dt) {
  setup.model.prepare(setup.wall_types());
  setup.set_clock(step, dt);
  books.init();
  const std::string report = setup.model.take_report();
  if (!report.empty())
    setup.engine.print("fix " + setup.engine.id() + " wall/rebound: " + report);
}

void Wall::begin_run(const Spheres &spheres, int groupbit, const Box &box) {
  setup.groupbit = groupbit;
  setup.box = box;
  setup.check_box();
  setup.dt = spheres.dt;
  books.begin_run();
  books.reorder(spheres.n);
  stepper.begin_run(spheres, shape_now_);
  shape_now_.clear();
  fastest_ = Fastest();
  check_speeds(spheres);
  warn_of_speeds();
}

/* The ball around a box. */
static Course around(const Bounds &box) {
  Course ball = {{}, {}, 0, 0, 1};
  for (int d = 0; d < 3; d++)
    ball.x[d] = 0.5 * (box.lo[d] + box.hi[d]);
  ball.reach = hypot(hypot(box.hi[0] - ball.x[0], box.hi[1] - ball.x[1]), box.hi[2] - ball.x[2]);
  return ball;
}

void Wall::check_use(const Bounds *box, const char *empty_group) {
  if (is_use_checked_)
    return;
  is_use_checked_ = true;
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
  stepper.rows.state = reinterpret_cast<MoverState *>(state);
  books.set_states(stepper.rows.state);
}

void Wall::reorder(const Spheres &spheres) {
  books.reorder(spheres.n);
  stepper.reorder(spheres);
  check_speeds(spheres);
}

static std::vector<Stepper *> steppers(const std::vector<Wall *> &walls) {
  std::vector<Stepper *> all;
  for (Wall *wall : walls)
    all.push_back(&wall->stepper);
  return all;
}

void Wall::step(const std::vector<Wall *> &walls, const Spheres &spheres, Bodies *bodies) {
  step_walls(steppers(walls), spheres);
  if (bodies)
    step_bodies(steppers(walls), *bodies);
}

void Wall::hold(const std::vector<Wall *> &walls, const Spheres &spheres, Bodies *bodies) {
  end_walls(steppers(walls), spheres);
  if (bodies)
    end_bodies(steppers(walls), *bodies);
}

void Wall::reset_dt(int64_t step, double dt) {
  setup.set_clock(step, dt);
  stepper.clear_ahead(); /* it counts steps */
}

/* Each rank checks its own particles at every neighbor build. The ranks exchange results only when
 * something is printed, so none waits for another in between. */
void Wall::check_speeds(const Spheres &s) {
  for (int i = 0; !warned_ && i < s.n; i++) {
    const double *v = s.v + 3 * static_cast<size_t>(i);
    const double square = aspi_dot(v, v), limit = fastest_.ratio * s.radius[i];
    if (!(s.mask[i] & setup.groupbit) || square <= limit * limit)
      continue;
    fastest_ = Fastest{sqrt(square) / s.radius[i], 2 * s.radius[i], sqrt(square)};
  }
}

void Wall::warn_of_speeds() {
  int cut = stepper.is_cut, any_cut;
  MPI_Allreduce(&cut, &any_cut, 1, MPI_INT, MPI_MAX, setup.engine.world());
  stepper.is_cut = false;
  if (any_cut)
    setup.engine.warn(
        "a particle had more than 10000 contacts in one step, and stayed where the last "
        "one left it; the step is far too long for walls so near to each other");
  if (warned_)
    return;
  struct {
    double ratio;
    int rank;
  } mine = {fastest_.ratio, setup.engine.rank()}, worst;
  MPI_Allreduce(&mine, &worst, 1, MPI_DOUBLE_INT, MPI_MAXLOC, setup.engine.world());
  if (worst.ratio * setup.dt <= 1)
    return;
  double fastest[2] = {fastest_.d_p, fastest_.speed};
  MPI_Bcast(fastest, 2, MPI_DOUBLE, worst.rank, setup.engine.world());
  warned_ = true;
  const auto with_unit = [this](double value, const char *kind) {
    return quantity(value, kind, setup.engine.units());
  };
  setup.engine.warn(
      "particles move far in a step: one of diameter " + with_unit(fastest[0], "length") +
      " moves at " + with_unit(fastest[1], "speed") +
      text(", which is %.3g diameters in a step of ", 0.5 * worst.ratio * setup.dt) +
      with_unit(setup.dt, "time") +
      ". No contact is missed, but paths that forces bend, and walls that turn, are taken as "
      "straight within a step; where that counts, the largest safe step is " +
      with_unit(1 / worst.ratio, "time"));
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
  double mine = static_cast<double>(stepper.grains.stuck.size() + stepper.bodies.stuck.size()), all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, setup.engine.world());
  return all;
}

double Wall::worn_density(size_t shape) const {
  return setup.model.worn_density(setup.shapes[shape].wall_type);
}

double Wall::bytes() const {
  size_t all = stepper.grains.bytes() + stepper.bodies.bytes() + books.bytes();
  for (const Member &member : setup.shapes)
    all += member.shape->bytes();
  return static_cast<double>(all);
}

/* ---- restart ----------------------------------------------------------------------------------
 */

std::vector<char> Wall::save() {
  WallState state = WallState();
  state.bodies = gather(stepper.body_rows.pack(), setup.engine.world());
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
  return Settings{{"geometry", setup.geometry},
                  {"description", setup.model.description()},
                  {"interlock", setup.interlocks ? "on" : "off"},
                  {"torque_about", books.torque_about()}};
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
  restore_meshes(saved);
  if (setup.engine.rank() == 0) /* from which they are claimed */
    stepper.body_rows.restore(saved.bodies, [this](MoverState &state, Memory &memory) {
      Stepper::renumber(shape_now_, state, memory);
    });
}

/* Totals and sums of each mesh that is the same as before. */
void Wall::restore_meshes(const WallState &saved) {
  std::vector<std::pair<std::string, int64_t>> meshes;
  std::vector<size_t> shape_of;
  for (size_t m = 0; m < setup.shapes.size(); m++) {
    const Member &member = setup.shapes[m];
    if (member.name.empty())
      continue;
    meshes.push_back(std::make_pair(member.name, static_cast<int64_t>(member.pieces)));
    shape_of.push_back(m);
  }
  std::string lost;
  const std::vector<int> found = match_meshes(saved, meshes, lost);
  if (!lost.empty())
    setup.engine.warn("not continued by a mesh, but kept in the wall's own counters: " + lost);
  shape_now_.assign(std::max(saved.meshes.size(), static_cast<size_t>(1)), 0);
  if (saved.meshes.empty() && meshes.empty())
    shape_now_[0] = 1;
  for (size_t k = 0; k < found.size(); k++) {
    if (found[k] < 0)
      continue;
    const MeshState &mesh = saved.meshes[found[k]];
    shape_now_[found[k]] = static_cast<int>(shape_of[k]) + 1;
    books.restore_mesh(shape_of[k], mesh);
    setup.shapes[shape_of[k]].shape->restore_motion(mesh.motion);
  }
}
