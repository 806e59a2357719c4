/* A wall as an engine drives it, without one: walls in two dimensions and in periodic boxes, and
 * the ledger's rows as engines read them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "alone.h"

#include <unistd.h>
#include <algorithm>
#include <fstream>
#include <iterator>

#include "contact/vector.h"
#include "dem/error.h"
#include "dem/shapes/mesh.h"
#include "dem/shapes/primitive.h"

#include "check.h"

using namespace asperity;

namespace {

const double DIAMETER = 1, HALF = 5; /* of the grains; of the distance of both planes */
const int GRAINS = 200;
const char *const ELASTIC = "rebound constant 1 1 deposit off";
const char *const IN_FLOW = "materials quartz surface_energy 0.4 deposit freeze remove u_tau 1 "
                            "gas_density 1.2 gas_viscosity 1.5e-5";

/* A wall of two planes across x. */
std::unique_ptr<Wall> wall_of(const Engine &engine, const std::string &description) {
  const double still[3] = {0, 0, 0};
  Shapes planes;
  for (int side = -1; side <= 1; side += 2)
    planes.push_back(std::unique_ptr<Shape>(new PlaneShape(0, side * HALF, still)));
  return make_wall(engine, std::move(planes), description);
}

/* The message of the error that it ends with. */
template <class Action> std::string error_of(Action action) {
  try {
    action();
  } catch (const Error &wrong) {
    return wrong.what();
  }
  return "";
}

std::string message(const Engine &engine, const std::string &description) {
  return error_of([&] { wall_of(engine, description); });
}

bool has(const std::string &text, const char *part) {
  return text.find(part) != std::string::npos;
}

/* Nothing leaves the plane, neither at an angle nor straight on, and an elastic wall keeps the
 * energy. */
TEST(two_dimensions_stay_in_their_plane) {
  const Alone flat(2);
  Grains grains(GRAINS, DIAMETER / 2, 0.5);
  for (int i = 0; i < GRAINS; i++) /* each second one straight toward a plane */
    grains.put(i, {0.01 * i, 0, 0}, {1 + 0.01 * i, i % 2 ? 0.02 * i : 0, 0});
  std::unique_ptr<Wall> wall =
      wall_of(flat, "surface rq 0.2 lambda_c 1.6 rebound constant 1 1 deposit off");
  grains.begin({wall.get()});
  grains.fly(100);
  assert_true(wall->books.counter(Books::N_IMPACTS) > 5 * GRAINS);
  int turned = 0;
  for (int i = 0; i < GRAINS; i++) {
    const double *v = &grains.v[3 * i], speed = hypot(1 + 0.01 * i, i % 2 ? 0.02 * i : 0);
    assert_true(fabs(v[2]) < 1e-12);
    assert_true(fabs(aspi_length(v) / speed - 1) < 1e-9);
    turned += i % 2 == 0 && fabs(v[1]) > 0.1;
  }
  assert_true(turned > GRAINS / 4);
}

TEST(two_dimensions_refuse_what_leaves_them) {
  const Alone flat(2), space(3);
  const std::string rough = "surface rq 0.2 lambda_c 1.6 ",
                    lay = "surface rq 0.1 lambda_c 1 2 lay ";
  for (const char *part : {"'isotropic'", "'dimension 2'"})
    assert_true(has(message(flat, rough + "spread visible isotropic"), part));
  assert_true(has(message(flat, lay + "0 1 0"), "the wall has a lay"));
  assert_string_equal(message(flat, rough + "spread visible plane").c_str(), "");
  for (const std::string &words : {rough + "spread visible isotropic", lay + "0 1 0"})
    assert_string_equal(message(space, words).c_str(), "");
}

/* LAMMPS's fix ave/histo and its Python interface step from the first row by the number of
 * columns. */
TEST(ledger_rows_are_one_block) {
  for (int columns : {+Ledger::N_COLUMNS, +Ledger::N_FULL}) {
    Ledger ledger(MPI_COMM_WORLD, 10, "", Ledger::STOP, columns);
    const int n = 20164;
    assert_non_null(ledger.rows());
    assert_int_equal(ledger.size(), 0);
    for (int i = 0; i < n; i++) {
      LedgerRow row;
      for (int k = 0; k < Ledger::N_FIELDS; k++)
        row[k] = 100. * i + k;
      ledger.add_row(row);
    }
    double **rows = ledger.rows();
    assert_int_equal(ledger.size(), n);
    for (int i = 0; i < n; i++) {
      assert_ptr_equal(rows[i], rows[0] + static_cast<ptrdiff_t>(i) * columns);
      for (int k = 0; k < columns; k++)
        assert_true(rows[i][k] == 100. * i + k);
    }
  }
}

std::string contents(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
}

/* Rows go to the file long before a window ends, in the same order: no more of them wait than some
 * steps have. */
TEST(ledger_is_written_early) {
  const char *const names[] = {"ledger_each.csv", "ledger_end.csv"};
  const int64_t steps = 400, each = 200, every[] = {1, 1000000};
  for (int k = 0; k < 2; k++) {
    Ledger ledger(MPI_COMM_WORLD, every[k], names[k], Ledger::STOP, Ledger::N_COLUMNS);
    size_t last = 0, most = 0;
    ledger.open("heading");
    for (int64_t step = 1; step <= steps; step++) {
      ledger.begin_step(step);
      for (int64_t i = 0; i < each; i++) {
        LedgerRow row;
        row.fill(0.1);
        row[Ledger::STEP] = static_cast<double>(step);
        row[Ledger::TAG] = static_cast<double>(i * 37 % each);
        ledger.add_row(row);
      }
      assert_string_equal(ledger.end_step(step).c_str(), "");
      const size_t now = contents(names[k]).size();
      most = std::max(most, now - last);
      last = now;
    }
    assert_int_equal(ledger.size(), k == 0 ? each : steps * each);
    assert_string_equal(ledger.flush().c_str(), "");
    const size_t whole = contents(names[k]).size();
    assert_true(last > 0.7 * static_cast<double>(whole));
    assert_true(most < 0.3 * static_cast<double>(whole));
  }
  assert_true(contents(names[0]) == contents(names[1]));
  for (const char *name : names)
    unlink(name);
}

/* Particles that leave a periodic box would come back behind a plane or inside of a cylinder. */
TEST(periodic_directions_are_refused) {
  const Alone engine(3);
  const Spheres none = Spheres();
  const double still[3] = {0, 0, 0};
  for (int d = 0; d < 3; d++) {
    std::unique_ptr<Wall> wall = wall_of(engine, ELASTIC);
    Wall tube(engine);
    tube.add_shape(std::unique_ptr<Shape>(new CylinderShape(1, still, 1, 0, 0)), 1, 0, "");
    Box box = {{0, 0, 0}, {0, 0, 0}};
    box.period[d] = 1;
    for (Wall *each : {wall.get(), &tube}) {
      const std::string wrong = error_of([&] { each->begin_run(none, 1, box); });
      assert_int_equal(wrong.empty(), each == &tube ? d == 1 : d != 0);
      if (!wrong.empty())
        assert_true(has(wrong, (std::string("stands across ") + "xyz"[d]).c_str()));
    }
  }
}

/* A plate of one period, of two triangles at z = 0. */
void set_plate(MeshShape &mesh) {
  const double corner[4][3] = {{-2, 5, 0}, {-1, 5, 0}, {-1, 6, 0}, {-2, 6, 0}};
  std::vector<ContactTriangle> triangles(2);
  for (int k = 0; k < 3; k++) {
    aspi_copy(corner[k], triangles[0].node[k]);
    aspi_copy(corner[(k + 2) % 4], triangles[1].node[k]);
  }
  set_triangles(mesh, triangles);
}

const Box BOX = {{-2, 5, -1}, {1, 1, 0}};

/* At rest anywhere, or moved by part of a period or several in a step: a grain that falls meets it,
 * even if it flies through many periods in the step. */
TEST(meshes_repeat_with_the_box) {
  for (double moved : {0.0, 0.4, 1.0, 3.3, -7.6, 1e4}) {
    for (double by : {0.0, 0.01, 0.5, -3.7}) {
      MeshShape plate;
      set_plate(plate);
      Frame frame;
      frame.shift[0] = moved;
      frame.shift[1] = -moved;
      plate.motion().settle(frame, true);
      frame.shift[0] += by;
      frame.shift[1] -= by;
      if (fabs(by) > 0)
        plate.motion().advance(frame, Twist(), 1);
      assert_true(plate.set_images(BOX));
      assert_false(plate.set_images(BOX));
      for (int k = 0; k < 100; k += 4) {
        Path path = {{-2.2 + 0.014 * k, 4.9 + 0.012 * k, 0.1}, {0, 0, -1}, 1, 1, 0};
        Contact contact;
        path.v[0] = k % 3 - 1;
        path.v[1] = k % 7 * (k % 2 ? 2.3 : 2e4);
        assert_true(plate.find(path, 0.02, 1, contact));
        assert_float_equal(contact.time, 0.08, 1e-6);
        assert_float_equal(contact.x[0], path.x[0] + 0.08 * path.v[0], 1e-6);
        assert_float_equal(contact.n[2], 1, 1e-6);
      }
    }
  }
}

/* Grains that fly through many periods before they fall on the plate bounce from it. */
TEST(long_flights_meet_a_mesh) {
  const int n = 100;
  for (double by : {0.0, 0.003, 0.5}) {
    MeshShape *const plate = new MeshShape;
    set_plate(*plate);
    GrainsAtWall s(std::unique_ptr<Shape>(plate), ELASTIC, n, 0.005, 0.01, 2);
    Grains &grains = s.grains;
    for (int i = 0; i < n; i++)
      grains.put(i, {-2 + 0.01 * i, 5 + 0.37 * i - floor(0.37 * i), 0.02 + 0.001 * i},
                 {0.4, 0, -0.01});
    plate->set_images(BOX);
    s.begin();
    Frame frame;
    for (int step = 1; step <= 1400; step++) {
      frame.shift[0] += by;
      if (by > 0)
        plate->motion().advance(frame, Twist(), grains.dt);
      assert_false(plate->set_images(BOX));
      grains.fly(1);
      if (step % 100)
        continue;
      for (int i = 0; i < n; i++)
        grains.x[3 * i] -= floor(grains.x[3 * i] + 2);
      s.wall->reorder(grains.spheres());
    }
    for (int i = 0; i < n; i++)
      assert_true(grains.x[3 * i + 2] > 0 && grains.v[3 * i + 2] > 0);
    assert_int_equal(s.count(Books::N_IMPACTS), n);
  }
}

/* A flight of several periods is predicted for no step; one of a million is refused. */
TEST(absurd_flights_are_refused) {
  MeshShape plate;
  set_plate(plate);
  plate.set_images(BOX);
  const Course course = {{-2, 5, 0.1}, {1e5, 0, 0}, 0.02, 0, 0, 100};
  assert_true(plate.clear(course, FaceList{0, {0, 0, 0}}) < 1);
  for (double v : {1e9, HUGE_VAL}) {
    const Path path = {{-2, 5, 0.1}, {v, 0, -1}, 1, 1, 0};
    Contact contact;
    assert_true(
        has(error_of([&] { plate.find(path, 0.02, 1, contact); }), "shorten the time step"));
  }
}

std::unique_ptr<Shape> ground() {
  const double still[3] = {0, 0, 0};
  return std::unique_ptr<Shape>(new PlaneShape(2, 0, still));
}

/* A row has the place in the box, wherever the grain is followed. */
TEST(rows_are_in_the_box) {
  GrainsAtWall s(ground(), "rebound constant 1 1 deposit off ledger 10 columns full", 2, 0.1, 1);
  s.grains.put(0, {1.3, 0, 0.5}, {0, 0, -1});
  s.grains.put(1, {-0.4, 0, 0.5}, {0, 0, -1});
  s.begin();
  s.wall->setup.box = Box{{0, 0, 0}, {1, 0, 0}};
  s.grains.fly(1);
  Ledger &ledger = *s.wall->books.ledger();
  assert_int_equal(ledger.size(), 2);
  assert_float_equal(ledger.rows()[0][Ledger::X], 0.3, 1e-12);
  assert_float_equal(ledger.rows()[1][Ledger::X], 0.6, 1e-12);
}

/* A plane that is in another unit, a lay without a direction on it, and a group without particles.
 */
TEST(idle_walls_are_doubted) {
  const char *const lay = "surface rq 0.1 lambda_c 1 2 lay 0 0 1 rebound constant 1 1 deposit off";
  const Bounds here = {{-1, -1, 0.3}, {1, 1, 5}}, far = {{-1, -1, 2}, {1, 1, 5}};
  Alone engine;
  for (const Bounds *bounds : {&here, static_cast<const Bounds *>(NULL)})
    make_wall(engine, ground(), ELASTIC)->check_use(bounds, NULL);
  assert_string_equal(engine.warned.c_str(), "");
  std::unique_ptr<Wall> wall = make_wall(engine, ground(), lay);
  wall->check_use(&far, "dust");
  assert_true(has(engine.warned, "lies outside of the box, x -1 to 1, y -1 to 1, z 2 to 5"));
  assert_true(has(engine.warned, "the lay, 0 0 1, is along the normal"));
  assert_true(has(engine.warned, "group 'dust' has no particles"));
  assert_int_equal(std::count(engine.warned.begin(), engine.warned.end(), '\n'), 3);
}

/* Grains that come later are asked about, too: once. */
TEST(grains_too_large_for_adhesion_are_doubted) {
  Alone engine;
  engine.least = engine.most = 1e-5;
  engine.kind = {true, 2650, 2650};
  std::unique_ptr<Wall> wall = make_wall(engine, ground(), "materials quartz");
  wall->init(0, 1e-6);
  assert_string_equal(engine.warned.c_str(), "");
  engine.most = 2e-3;
  for (int run = 0; run < 2; run++)
    wall->init(0, 1e-6);
  assert_true(has(engine.warned, "type 1 on a wall of type 1: the adhesion of 'bons' is for"));
  assert_int_equal(std::count(engine.warned.begin(), engine.warned.end(), '\n'), 1);
}

} // namespace

/* Deposits of 10 um in a flow that takes half of them away in a second: when each leaves, in steps
 * of dt. After half of the time all go on at another wall, as after a restart. They are pulled to
 * the wall, and do not stick again. */
std::vector<double> times_of_removal(double dt) {
  const double d = 1e-5;
  Alone engine;
  engine.least = engine.most = d;
  std::vector<std::unique_ptr<Wall>> walls;
  std::vector<double> times(GRAINS, HUGE_VAL);
  Grains grains(GRAINS, d / 2, dt);
  double packed[PACKED_MOST];
  for (int half = 0; half < 2; half++) {
    const std::vector<std::vector<double>> states = grains.states;
    walls.push_back(make_wall(engine, ground(), IN_FLOW));
    grains.begin({walls.back().get()});
    Memories &rows = walls[half]->rows;
    if (half)
      std::copy(states[0].begin(), states[0].end(), grains.states[0].begin());
    for (int i = 0; i < GRAINS; i++) {
      grains.f[3 * i + 2] = -1e-3;
      if (half) {
        walls[0]->rows.pack(i, packed);
        rows.unpack(i, packed);
        continue;
      }
      rows.set_status(i, Status::STUCK);
      rows.stuck(i) = Stuck();
      rows.stuck(i).shape = 1;
      rows.stuck(i).sphere = i + 1;
      rows.stuck(i).at[2] = grains.x[3 * i + 2] = d / 2;
    }
    walls[half]->reorder(grains.spheres());
    for (int step = 0; step < lround(0.5 / dt); step++) {
      grains.fly(1);
      for (int i = 0; i < GRAINS; i++) {
        assert_false(rows.is_stuck(i) && times[i] < HUGE_VAL);
        if (!rows.is_stuck(i) && !(times[i] < HUGE_VAL))
          times[i] = static_cast<double>(grains.now) * dt;
      }
    }
  }
  return times;
}

/* A body of two spheres is held by the one with this tag: when it leaves. */
double time_of_body(int tag, double dt) {
  const double d = 1e-5;
  Alone engine;
  engine.least = engine.most = d;
  std::unique_ptr<Wall> wall = make_wall(engine, ground(), IN_FLOW);
  Bodies bodies;
  bodies.dt = dt;
  bodies.all.push_back(Body());
  bodies.all[0].count = 2;
  bodies.all[0].mass = 1;
  bodies.spheres = {BodySphere{{0, 0, 0}, 9 * d, 1, 1, 1}, BodySphere{{1, 0, 0}, d / 2, 1, 1, tag}};
  Grains grains(1, d / 2, dt);
  grains.begin({wall.get()});
  claim_bodies({wall.get()}, bodies, MPI_COMM_WORLD);
  wall->body_rows.set_status(0, Status::STUCK);
  wall->body_rows.stuck(0).shape = 1;
  wall->body_rows.stuck(0).sphere = tag;
  claim_bodies({wall.get()}, bodies, MPI_COMM_WORLD);
  double time = 0;
  for (; wall->body_rows.is_stuck(0) && time < 2; time += dt)
    wall->let_go(bodies);
  return time;
}

/* When a deposit leaves depends neither on the step nor on a restart, and a body leaves as the
 * sphere that holds it. */
TEST(flow_takes_deposits_away) {
  const std::vector<double> coarse = times_of_removal(0.02), fine = times_of_removal(0.005);
  int left = 0;
  for (int i = 0; i < GRAINS; i++) {
    const double late = coarse[i] < HUGE_VAL ? coarse[i] - fine[i] : 0;
    left += coarse[i] < HUGE_VAL;
    assert_true(late > -1e-9 && late < 0.02);
    if (i < 10 && coarse[i] < HUGE_VAL)
      assert_true(fabs(time_of_body(i + 1, 0.02) - coarse[i]) < 1e-9);
  }
  assert_true(left > 0.3 * GRAINS && left < 0.7 * GRAINS);
}

/* A body of two spheres lands flat, but for the rounding by which the second one is lower: its
 * impacts are numbered in the order of the spheres. */
TEST(impacts_of_a_body_are_in_order) {
  const double tilt = 1e-9;
  const Alone engine;
  std::unique_ptr<Wall> wall =
      make_wall(engine, ground(), "rebound constant 0.5 0.5 deposit off ledger 1");
  Bodies bodies;
  Body body = Body();
  body.count = 2;
  body.mass = 1;
  body.inertia[0] = 0.1;
  body.inertia[1] = body.inertia[2] = 0.35;
  body.axes[0][0] = body.axes[1][1] = body.axes[2][2] = 1;
  body.axes[0][2] = -tilt;
  body.axes[2][0] = tilt;
  body.x[2] = 0.4;
  body.v[2] = -1;
  bodies.all.push_back(body);
  bodies.spheres = {BodySphere{{-0.5, 0, 0}, 0.5, 1, 1, 1}, BodySphere{{0.5, 0, 0}, 0.5, 1, 1, 2}};
  bodies.dt = 0.2;
  Grains none(0, 0.5, bodies.dt);
  none.begin({wall.get()});
  bodies.step = none.now = 1;
  claim_bodies(none.walls, bodies, MPI_COMM_WORLD);
  step_walls(none.walls, none.spheres(), &bodies);
  assert_int_equal(wall->books.ledger()->size(), 2);
  for (int k = 0; k < 2; k++) /* tag, and number of the impact */
    for (int column = 0; column < 2; column++)
      assert_true(wall->books.ledger()->rows()[k][column] == 1 + k);
}

/* A body that was stuck to a wall which is gone is held where it is at the beginning of the run,
 * before forces move it. */
TEST(bodies_of_no_wall_stay) {
  const Alone engine;
  std::unique_ptr<Wall> wall = make_wall(engine, ground(), "rebound constant 1 1 deposit freeze");
  Bodies bodies;
  Body body = Body();
  body.count = 1;
  body.mass = body.inertia[0] = body.inertia[1] = body.inertia[2] = 1;
  body.axes[0][1] = body.axes[1][2] = body.axes[2][0] = 1;
  body.x[2] = 3;
  bodies.all.push_back(body);
  bodies.spheres = {BodySphere{{0.5, 0, 0}, 0.1, 1, 1, 1}};
  bodies.begins = false;
  claim_bodies({wall.get()}, bodies, MPI_COMM_WORLD);
  wall->body_rows.set_status(0, Status::STUCK);
  Stuck &at = wall->body_rows.stuck(0);
  at = Stuck();
  at.sphere = 1;
  bodies.begins = true;
  claim_bodies({wall.get()}, bodies, MPI_COMM_WORLD);
  const double held[3] = {0, 0.5, 3};
  assert_memory_equal(at.at, held, sizeof held);
  bodies.all[0].x[2] -= 0.1;
  wall->carry_stuck(bodies);
  assert_float_equal(bodies.all[0].x[2], 3, 1e-15);
  assert_memory_equal(bodies.all[0].axes, body.axes, sizeof body.axes);
}

/* A memory comes back as it was packed, its body finds it by its tag, and a wrong one is refused.
 */
TEST(memories_come_back) {
  MoverState shown[2] = {};
  Memories all = {shown, {}, {}};
  double packed[PACKED_MOST], again[PACKED_MOST];
  all.grow(2);
  assert_true(all.pack(0, packed) == 1 && all.unpack(1, packed) == 1 && !all.find(1));
  all.own(0).draws = 7;
  all.own(0).faces.assign(FACES_MOST, FacePlace{4, {1, 2, 3}, {0, 0, 1}, 5, 0.1, 6, 0.5, 8, 7});
  all.set_status(0, Status::STUCK);
  all.stuck(0).at[1] = 8;
  const int n = all.pack(0, packed);
  assert_true(n > 1 && n <= PACKED_MOST && all.unpack(1, packed) == n);
  all.copy(1, 0);
  assert_true(all.pack(0, again) == n && std::equal(packed, packed + n, again));
  all.set_status(0, Status::FREE);
  assert_true(all.find(0)->stuck.empty() && all.find(0)->faces.size() == FACES_MOST);

  BodyMemories bodies;
  bodies.claim({3, 8}, MPI_COMM_WORLD);
  bodies.state[1].impacts = 2;
  bodies.own(1).draws = 9;
  const std::vector<double> saved = bodies.pack();
  bodies.claim({5, 8}, MPI_COMM_WORLD);
  assert_true(!bodies.find(0) && bodies.find(1)->draws > 8);
  BodyMemories restored;
  restored.restore(saved, [](MoverState &, Memory &memory) { memory.draws++; });
  restored.claim({8}, MPI_COMM_WORLD);
  assert_true(restored.take_restored() == 2 && restored.find(0)->draws > 9);
  assert_true(restored.state[0].impacts > 1);
  restored.claim({}, MPI_COMM_WORLD);
  assert_true(restored.pack().empty());
  const std::vector<double> cut(saved.begin(), saved.begin() + 9);
  const std::string wrong = error_of([&] { restored.restore(cut, [](MoverState &, Memory &) {}); });
  assert_true(has(wrong, "bodies of another form"));
}
