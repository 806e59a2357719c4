/* Grains and bodies at walls, as one table: each mover in each room, smooth and rough, with and
 * without friction, in gentle steps of three lengths and in steps of 100 diameters. Walls keep
 * their movers inside, give no energy while they stand still, and write no impacts while a mover
 * rests; the length of the step does not change the number of impacts; a body of one sphere does
 * what a grain does; a run in two pieces, or continued from a restart file, is the run in one to
 * the bit. test_movers [WORD]... runs the cases whose names have all the words.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "alone.h"

#include <math.h>
#include <string.h>
#include <stdio.h>
#include <algorithm>
#include <exception>

#include "contact/vector.h"
#include "dem/shapes/mesh.h"
#include "dem/shapes/primitive.h"

using namespace asperity;

namespace {

/* ---- the table --------------------------------------------------------------------------------
 */

/* Radius of a sphere; its mass, by which all is divided exactly; half the width of a drum. */
const double R = 1e-3, MASS = 1. / 131072, GRAVITY = 9.81, WIDE = 12e-3;

struct Kind {
  const char *name;
  int nx, ny; /* touching spheres along x and y */
  bool is_body;
};

const Kind KINDS[] = {{"grain", 1, 1, false}, {"ball", 1, 1, true}, {"2x2", 2, 2, true},
                      {"3x3", 3, 3, true},    {"rod5", 5, 1, true}, {"rod10", 10, 1, true}};

enum Form { PLANES, CYLINDER, MESH };
enum Move { STANDS, TURNS, SHAKES, ROCKS, SLIDES };

/* A convex room: flat sides around the x axis, each turned from the one before by `angle`, all at
 * the distance `wide`, and perhaps two ends. Movers start near the sides along the axes `off`,
 * moved by `at`; gravity has this direction. */
struct Room {
  const char *name;
  Form form;
  Move move;
  int sides, ends;
  double angle, wide, at[3], off[3], gravity[3];
};

const double V = 1.2, RIGHT = 0.5 * ASP_PI;

const Room ROOMS[] = {
    {"plane", PLANES, STANDS, 1, 0, 0, 0, {}, {0, 0, 1}, {0.309, 0, -0.951}},
    {"planes", PLANES, STANDS, 2, 0, RIGHT, 0, {}, {0, 1, 1}, {0, -0.6, -0.8}},
    {"corner", MESH, STANDS, 4, 2, RIGHT, 2 * WIDE, {}, {1, 1, 1}, {-0.48, -0.6, -0.64}},
    {"V", MESH, STANDS, 2, 0, ASP_PI - V, 0, {0, R / tan(V / 2) - R}, {0, 1, 1}, {0, -0.6, -0.8}},
    {"cylinder", CYLINDER, STANDS, 0, 0, 0, WIDE, {0, 0, 0.2 * R}, {0, 0, 1}, {0, 0, -1}},
    {"drum", MESH, TURNS, 16, 0, RIGHT / 4, WIDE, {}, {0, 0, 1}, {0, 0, -1}},
    {"shaken", MESH, SHAKES, 1, 0, 0, 0, {}, {0, 0, 1}, {0, 0, -1}},
    {"rocking", MESH, ROCKS, 1, 0, 0, 0, {0, 5 * R}, {0, 0, 1}, {0, 0, -1}},
    {"sliding", PLANES, SLIDES, 1, 0, 0, 0, {}, {0, 0, 1}, {0, 0, -1}}};

/* Steps of one length. */
struct Pace {
  const char *name;
  double dt, speed;
  size_t movers;
  int steps;
  double e; /* restitution */
};

const Pace PACES[] = {{"1e-3", 1e-3, 0.02, 8, 40, 0.5},
                      {"1e-4", 1e-4, 0.02, 2, 400, 0.5},
                      {"1e-5", 1e-5, 0.02, 1, 4000, 0.5},
                      {"100 d", 1e-3, 200 * R / 1e-3, 8, 20, 1}};
const int GENTLE = 3, ALL = 4; /* paces */

/* The movement of a mesh. What rests on it does not leave it. */
void move_to(Move move, double t, Frame &frame, Twist &twist) {
  const double w = 60, rise = 0.5 * GRAVITY / (w * w), tilt = 0.05, spin = 10;
  const double part = 1 - cos(w * t), rate = w * sin(w * t);
  const double angle = move == TURNS ? spin * t : move == ROCKS ? tilt * part : 0;
  frame.turn[1][1] = frame.turn[2][2] = cos(angle);
  frame.turn[2][1] = sin(angle);
  frame.turn[1][2] = -sin(angle);
  twist.angular[0] = move == TURNS ? spin : move == ROCKS ? tilt * rate : 0;
  frame.shift[2] = move == SHAKES ? rise * part : 0;
  twist.linear[2] = move == SHAKES ? rise * rate : 0;
}

void normal_of(const Room &room, int side, double n[3]) {
  n[0] = side < room.sides ? 0 : side == room.sides ? 1 : -1;
  n[1] = side < room.sides ? sin(side * room.angle) : 0;
  n[2] = side < room.sides ? cos(side * room.angle) : 0;
}

/* Every side is a square far larger than the room. */
std::unique_ptr<MeshShape> make_mesh(const Room &room) {
  const double half = 10;
  std::vector<ContactTriangle> triangles;
  for (int k = 0; k < 2 * (room.sides + room.ends); k++) {
    double n[3], a[3], b[3];
    normal_of(room, k / 2, n);
    const double other[3] = {n[2], n[0], n[1]};
    aspi_cross(n, other, a);
    aspi_scale(half / aspi_length(a), a);
    aspi_cross(n, a, b);
    ContactTriangle triangle;
    for (int c = 0; c < 3; c++) {
      const int corner = (c + 2 * (k % 2)) % 4;
      for (int d = 0; d < 3; d++)
        triangle.node[c][d] =
            -room.wide * n[d] + (corner % 3 ? a[d] : -a[d]) + (corner > 1 ? b[d] : -b[d]);
    }
    triangles.push_back(triangle);
  }
  std::unique_ptr<MeshShape> mesh(new MeshShape);
  Frame frame;
  Twist twist;
  move_to(room.move, 0, frame, twist);
  set_triangles(*mesh, triangles);
  mesh->set_images(Box());
  mesh->motion().settle(frame, false);
  mesh->motion().set_last(twist);
  return mesh;
}

/* In the last quarter of its steps a mover that settles may still have so many impacts. */
const double LAST = 10;

/* ---- movers in a room -------------------------------------------------------------------------
 */

struct State {
  double x[3], v[3], spin[3], axes[3][3];
};

void turn_axes(const double about[3], double angle, double axes[3][3]) {
  const double length = aspi_length(about);
  for (int k = 0; k < 3 && length > 0; k++) {
    double side[3];
    aspi_cross(about, axes[k], side);
    const double along = aspi_dot(about, axes[k]) / length * (1 - cos(angle));
    for (int d = 0; d < 3; d++)
      axes[k][d] = axes[k][d] * cos(angle) + (side[d] * sin(angle) + about[d] * along) / length;
  }
}

/* Movers of one kind in one room, in the steps of an engine: half a kick and the way, the wall, the
 * forces, the second half, the end of the step. Bodies turn exactly, as all are symmetric. All that
 * depends on how the project takes movers is here. */
class Scene {
public:
  Scene(const Kind &kind, const Room &room, const std::string &words, double dt, size_t n)
      : kind_(kind), room_(room), words_(words), dt_(dt), count_(kind.nx * kind.ny), mesh_(NULL),
        grains_(kind.is_body ? 0 : n, R, dt), bodies_() {
    engine_.least = engine_.most = 2 * R;
    wall_ = make_room();
    grains_.spins = true;
    grains_.mass.assign(grains_.mass.size(), MASS);
    bodies_.dt = dt;
    bodies_.begins = true;
  }

  void add(size_t i, const State &at) {
    if (!kind_.is_body) {
      std::copy(at.x, at.x + 3, &grains_.x[3 * i]);
      std::copy(at.v, at.v + 3, &grains_.v[3 * i]);
      std::copy(at.spin, at.spin + 3, &grains_.omega[3 * i]);
      return;
    }
    Body body = Body();
    body.tag = static_cast<int64_t>(i);
    body.first = bodies_.spheres.size();
    body.count = static_cast<size_t>(count_);
    body.mass = MASS * count_;
    for (int k = 0; k < count_; k++) {
      const double a = R * (2 * (k % kind_.nx) - kind_.nx + 1);
      const double b = R * (2 * (k / kind_.nx) - kind_.ny + 1);
      bodies_.spheres.push_back(
          BodySphere{{a, b, 0}, R, 1, 1, static_cast<int64_t>(bodies_.spheres.size()) + 1});
      body.inertia[0] += MASS * (0.4 * R * R + b * b);
      body.inertia[1] += MASS * (0.4 * R * R + a * a);
      body.inertia[2] += MASS * (0.4 * R * R + a * a + b * b);
    }
    aspi_copy(at.x, body.x);
    aspi_copy(at.v, body.v);
    for (int k = 0; k < 3; k++) {
      aspi_copy(at.axes[k], body.axes[k]);
      aspi_add_scaled(body.angular_momentum, body.inertia[k] * aspi_dot(at.spin, at.axes[k]),
                      at.axes[k], body.angular_momentum);
    }
    bodies_.all.push_back(body);
  }

  void begin() { /* when all are there */
    set_forces();
    grains_.begin({wall_.get()});
    bodies_.step = 1;
    claim_bodies({wall_.get()}, bodies_, MPI_COMM_WORLD);
  }

  void step() {
    grains_.now++;
    bodies_.step = grains_.now;
    if (mesh_ && room_.move != STANDS) {
      Frame frame;
      Twist twist;
      move_to(room_.move, static_cast<double>(grains_.now) * dt_, frame, twist);
      mesh_->motion().advance(frame, twist, dt_);
      mesh_->set_images(Box());
    }
    kick();
    for (size_t k = 0; k < grains_.x.size(); k++)
      grains_.x[k] += grains_.v[k] * dt_;
    for (Body &body : bodies_.all) {
      aspi_add_scaled(body.x, dt_, body.v, body.x);
      turn(body);
      body.is_changed = false;
    }
    step_walls(grains_.walls, grains_.spheres(), &bodies_);
    set_forces();
    kick();
    end_walls(grains_.walls, grains_.spheres(), &bodies_);
    wall_->books.end_loads();
  }

  /* The set-up of another run; restarts: of another program, with the memory of a restart file. */
  void resume(bool restarts) {
    set_forces();
    if (restarts) {
      std::unique_ptr<Wall> before = std::move(wall_);
      const MeshShape *mesh = mesh_;
      wall_ = make_room();
      wall_->restore(before->save().data());
      if (mesh_)
        mesh_->motion() = mesh->motion();
      std::vector<double> packed(PACKED_MOST);
      wall_->rows.grow(static_cast<int>(grains_.tag.size()));
      for (size_t i = 0; i < grains_.tag.size(); i++) {
        before->rows.pack(static_cast<int>(i), packed.data());
        wall_->rows.unpack(static_cast<int>(i), packed.data());
      }
      grains_.walls.assign(1, wall_.get());
      wall_->init(grains_.now, dt_);
      wall_->set_rows(grains_.states[0].data());
    }
    wall_->begin_run(grains_.spheres(), 1, Box());
    bodies_.begins = true;
    bodies_.step = grains_.now + 1;
    claim_bodies(grains_.walls, bodies_, MPI_COMM_WORLD);
    push_again(grains_.walls, grains_.spheres());
    push_again(grains_.walls, bodies_);
  }

  /* Impulse on the wall so far, and force in the last step. */
  double load(int of, int axis) const {
    return wall_->books.counter(of + axis);
  }

  State state(size_t i) const {
    State at = State();
    if (!kind_.is_body) {
      aspi_copy(&grains_.x[3 * i], at.x);
      aspi_copy(&grains_.v[3 * i], at.v);
      aspi_copy(&grains_.omega[3 * i], at.spin);
      return at;
    }
    const Body &body = bodies_.all[i];
    aspi_copy(body.x, at.x);
    aspi_copy(body.v, at.v);
    for (int k = 0; k < 3; k++) {
      aspi_copy(body.axes[k], at.axes[k]);
      aspi_add_scaled(at.spin, aspi_dot(body.angular_momentum, body.axes[k]) / body.inertia[k],
                      body.axes[k], at.spin);
    }
    return at;
  }

  double energy(size_t i) const { /* per mass */
    const State at = state(i);
    const double turns =
        kind_.is_body ? aspi_dot(at.spin, bodies_.all[i].angular_momentum) / bodies_.all[i].mass
                      : 0.4 * R * R * aspi_dot(at.spin, at.spin);
    return 0.5 * (aspi_dot(at.v, at.v) + turns) - GRAVITY * aspi_dot(room_.gravity, at.x);
  }

  double impacts(size_t i) const {
    const Wall &of = *wall_;
    return (kind_.is_body ? of.body_rows.state : of.rows.state)[i].impacts;
  }

  double guarded() const {
    return wall_->books.counter(Books::N_GUARDED);
  }

  /* How far its spheres are inside the room, at least. */
  double inside(size_t i) const {
    const State at = state(i);
    double least = HUGE_VAL;
    for (size_t k = 0; k < static_cast<size_t>(count_); k++) {
      double x[3];
      aspi_copy(at.x, x);
      for (int a = 0; a < 3 && kind_.is_body; a++)
        aspi_add_scaled(x, bodies_.spheres[k].arm[a], at.axes[a], x);
      if (mesh_) {
        double world[3];
        aspi_copy(x, world);
        mesh_->motion().end().to_local(world, x);
      }
      if (room_.form == CYLINDER)
        least = std::min(least, room_.wide - hypot(x[1], x[2]) - R);
      for (int side = 0; side < room_.sides + room_.ends; side++) {
        double n[3];
        normal_of(room_, side, n);
        least = std::min(least, room_.wide + aspi_dot(x, n) - R);
      }
    }
    return aspi_dot(at.x, at.x) >= 0 ? least : -HUGE_VAL; /* not a number */
  }

private:
  std::unique_ptr<Wall> make_room() {
    const double still[3] = {0, 0, 0}, belt[3] = {0.1, 0, 0};
    Shapes shapes;
    if (room_.form == CYLINDER)
      shapes.push_back(std::unique_ptr<Shape>(new CylinderShape(0, still, room_.wide, 0, 0)));
    for (int k = 0; k < room_.sides && room_.form == PLANES; k++)
      shapes.push_back(std::unique_ptr<Shape>(
          new PlaneShape(2 - k, -room_.wide, room_.move == SLIDES ? belt : still)));
    if (room_.form == MESH) {
      std::unique_ptr<MeshShape> mesh = make_mesh(room_);
      mesh_ = mesh.get();
      shapes.push_back(std::move(mesh));
    }
    return make_wall(engine_, std::move(shapes), words_,
                     mesh_ ? static_cast<size_t>(2 * (room_.sides + room_.ends)) : 0);
  }

  void set_forces() {
    for (size_t k = 0; k < grains_.f.size(); k++)
      grains_.f[k] = MASS * (GRAVITY * room_.gravity[k % 3]);
    grains_.total = grains_.f;
    grains_.torque.assign(grains_.torque.size(), 0.);
    for (Body &body : bodies_.all)
      for (int d = 0; d < 3; d++) {
        body.acceleration[d] = GRAVITY * room_.gravity[d];
        body.torque[d] = 0;
      }
  }

  void kick() {
    grains_.kick();
    for (Body &body : bodies_.all) {
      aspi_add_scaled(body.v, 0.5 * dt_, body.acceleration, body.v);
      aspi_add_scaled(body.angular_momentum, 0.5 * dt_, body.torque, body.angular_momentum);
    }
  }

  /* About its axis of symmetry, and about the angular momentum. */
  void turn(Body &body) const {
    const int own = kind_.ny > 1 ? 2 : 0, across = 1;
    const double *momentum = body.angular_momentum, spin = aspi_dot(momentum, body.axes[own]);
    double axis[3];
    aspi_copy(body.axes[own], axis);
    turn_axes(axis, spin * (1 / body.inertia[own] - 1 / body.inertia[across]) * dt_, body.axes);
    turn_axes(momentum, aspi_length(momentum) / body.inertia[across] * dt_, body.axes);
  }

  const Kind &kind_;
  const Room &room_;
  const std::string words_;
  const double dt_;
  const int count_; /* spheres of a mover */
  Alone engine_;
  std::unique_ptr<Wall> wall_;
  MeshShape *mesh_;
  Grains grains_;
  Bodies bodies_;
};

/* ---- a run ------------------------------------------------------------------------------------
 */

/* In -1 to 1, the same for all kinds and paces. */
double uniform(size_t mover, int k) {
  const double mixed = sin(12.9898 * (static_cast<double>(mover) + 1) + 78.233 * k) * 43758.5453;
  return 2 * (mixed - floor(mixed)) - 1;
}

State start(const Kind &kind, const Room &room, const Pace &pace, size_t i) {
  const double extent[3] = {(kind.nx - 1) * R, (kind.ny - 1) * R, 0}, tilt = 1e-3;
  const double gap = 0.02 * R + 2 * tilt * (extent[0] + extent[1]);
  const bool is_closed = room.wide > 0;
  State at = State();
  double way[3];
  for (int d = 0; d < 3; d++) {
    at.axes[d][d] = 1;
    at.x[d] = room.at[d] + room.off[d] * (extent[d] + R + gap - room.wide);
    at.v[d] = pace.speed * (room.gravity[d] + (d == 0 ? uniform(i, 0) : 0));
    at.spin[d] = uniform(i, 1 + d);
    way[d] = uniform(i, 4 + d);
  }
  turn_axes(way, tilt * aspi_length(way), at.axes);
  if (!is_closed) /* from afar to all sides */
    for (int d = 0; d < 3; d++)
      way[d] = room.gravity[d] + 0.1 * way[d];
  for (int d = 0; d < 3 && pace.e >= 1; d++) {
    at.v[d] = pace.speed * way[d] / aspi_length(way);
    at.x[d] = is_closed ? 0 : at.x[d] - 1.3 * pace.dt * at.v[d];
  }
  return at;
}

struct Result {
  double out, rise, loss, guarded, resting; /* impacts that were written at rest */
  double load[3];                           /* impulse on the wall */
  std::vector<double> impacts;
  std::vector<State> end;
};

/* How a run is cut at its middle. */
enum Cut { WHOLE, SET_UP, RESTART };

void run(Scene &scene, const Pace &pace, bool stands, bool settles, Cut cut, Result &r) {
  const size_t n = pace.movers;
  std::vector<double> first(n), low(n), late(n), before(n);
  for (size_t i = 0; i < n; i++)
    first[i] = low[i] = scene.energy(i);
  scene.begin();
  for (int k = 1; k <= pace.steps; k++) {
    if (cut != WHOLE && k == pace.steps / 2)
      scene.resume(cut == RESTART);
    scene.step();
    for (size_t i = 0; i < n; i++) {
      const double now = scene.energy(i);
      r.out = std::max(r.out, -scene.inside(i) / R);
      r.rise = now - low[i] <= r.rise ? r.rise : now - low[i];
      low[i] = std::min(low[i], now);
      if (k == pace.steps * 3 / 4) {
        late[i] = now;
        before[i] = scene.impacts(i);
      }
    }
  }
  for (size_t i = 0; i < n; i++) {
    const bool same = stands && fabs(scene.energy(i) - late[i]) < 1e-6 * GRAVITY * R;
    const double late_ones = scene.impacts(i) - before[i];
    r.resting += same ? late_ones : settles ? std::max(0.0, late_ones - LAST) : 0;
    r.loss = std::max(r.loss, 1 - scene.energy(i) / first[i]);
    r.impacts.push_back(scene.impacts(i));
    r.end.push_back(scene.state(i));
  }
  r.guarded = scene.guarded();
  for (int d = 0; d < 3; d++)
    r.load[d] = scene.load(Books::IMPULSE, d);
}

/* ---- what must hold ---------------------------------------------------------------------------
 */

/* Of the energy, by the turn of bodies in parts of 0.01 rad. */
const double HEAT = 1e-3;

/* What is left: where ten spheres in a row rest at several smooth walls, the sweeps over their 20
 * or 30 contacts do not converge, so that they hop in steps of 1e-5; ten times as many sweeps leave
 * that. */
const char *const LEFT[] = {"rod10 planes smooth", "rod10 corner smooth", "rod10 V smooth"};

struct Case {
  std::string name;
  const Kind &kind;
  const Room &room;
  bool rough;
  double friction;
  int failed;

  void check(const Pace &pace, const char *what, double value, double most) {
    for (const char *left : LEFT)
      if (value <= most || name.compare(0, strlen(left), left) == 0)
        return;
    printf("FAIL %-28s %-5s %-14s %.4g, at most %.4g\n", name.c_str(), pace.name, what, value,
           most);
    fflush(stdout);
    failed++;
  }

  Result run_at(const Pace &pace, Cut cut = WHOLE) {
    const bool stands = room.move == STANDS;
    const bool settles = !rough && room.form != CYLINDER && room.move != TURNS;
    const double kick = GRAVITY * pace.dt;
    const std::string words = std::string(rough ? "surface sigma 10 lambda_c 2e-4 " : "") +
                              "rebound walton " + (pace.e < 1 ? "0.5 " : "1 ") +
                              (friction > 0 ? "0.3" : "0") + " 0 deposit off";
    Scene scene(kind, room, words, pace.dt, pace.movers);
    Result r = Result();
    for (size_t i = 0; i < pace.movers; i++)
      scene.add(i, start(kind, room, pace, i));
    try {
      run(scene, pace, stands, settles, cut, r);
    } catch (const std::exception &error) {
      check(pace, error.what(), 1, 0);
    }
    check(pace, "radii outside", r.out, 1e-3);
    check(pace, "guarded", r.guarded, 0);
    if (stands)
      check(pace, "energy gained", r.rise,
            HEAT * pace.speed * pace.speed + 6 * kind.nx * kind.ny * kick * kick);
    if (stands && pace.e >= 1 && !(friction > 0))
      check(pace, "energy lost", r.loss, HEAT);
    if (pace.e < 1)
      check(pace, "at rest", r.resting, settles ? LAST : 0);
    return r;
  }

  static double mean_impacts(const Result &r) {
    double all = 0;
    for (double one : r.impacts)
      all += one;
    return all / static_cast<double>(r.impacts.size());
  }

  /* A kick ends a series of bounces, of each sphere at each side; one series may start another. On
   * a single rough side the wall's own heights end it. A pace whose few movers have more is judged
   * by as many as the first one has. */
  void check_impacts(const Result (&r)[ALL]) {
    if (room.move == TURNS) /* a drum lifts them again and again */
      return;
    const double first = mean_impacts(r[0]);
    double square = 0;
    for (double one : r[0].impacts)
      square += (one - first) * (one - first) / static_cast<double>(PACES[0].movers - 1);
    const double sides = room.off[0] + room.off[1] + 1, series = 4 * kind.nx * kind.ny * sides;
    for (int p = 1; p < GENTLE; p++) {
      const double bounces = rough && !(sides > 1) ? 1 : log(PACES[0].dt / PACES[p].dt) / log(2);
      const auto most = [&](size_t movers) {
        return first + series * bounces +
               3 * sqrt(std::max(square, first) * (1. / static_cast<double>(movers) +
                                                   1. / static_cast<double>(PACES[0].movers)));
      };
      char what[40];
      snprintf(what, sizeof what, "impacts %.4g ->", first);
      Pace pace = PACES[p];
      double mean = mean_impacts(r[p]);
      if (mean > most(pace.movers)) {
        pace.movers = PACES[0].movers;
        mean = mean_impacts(run_at(pace));
      }
      check(pace, what, mean, most(pace.movers));
    }
  }

  /* A run in pieces is the run in one. */
  void check_pieces(const Pace &pace, const Result &whole) {
    for (Cut cut : {SET_UP, RESTART}) {
      const Result r = run_at(pace, cut);
      const char *const what = cut == SET_UP ? "two runs" : "restart";
      double load = 0, off = 0;
      for (int d = 0; d < 3; d++) {
        load = std::max(load, fabs(whole.load[d]));
        off = std::max(off, fabs(r.load[d] - whole.load[d]));
      }
      check(pace, what, off, 1e-12 * load);
      for (size_t i = 0; i < whole.end.size(); i++)
        check(pace, what, memcmp(&r.end[i], &whole.end[i], sizeof r.end[i]) != 0, 0);
    }
  }

  /* In closed rooms, long steps have too many contacts. */
  void check_same(const Pace &pace, const Result &grain, const Result &ball) {
    double apart = 0, far = 0, more = 0;
    if (room.move == TURNS) /* rounding grows from side to side */
      return;
    for (size_t i = 0; i < pace.movers && (pace.e < 1 || !(room.wide > 0)); i++) {
      double off[3];
      aspi_subtract(grain.end[i].x, ball.end[i].x, off);
      apart = std::max(apart, aspi_length(off) / R);
      far = std::max(far, aspi_length(grain.end[i].x) / R);
      more += fabs(grain.impacts[i] - ball.impacts[i]);
    }
    check(pace, "from the grain", apart, 1e-6 + 1e-9 * far);
    check(pace, "other impacts", more, 0);
  }
};

} // namespace

int main(int argc, char **argv) {
  int cases = 0, failed = 0;
  for (const Room &room : ROOMS)
    for (int k = 0; k < 4; k++) {
      Result grain[ALL];
      for (const Kind &kind : KINDS) {
        const bool rough = k > 1;
        const std::string name = std::string(kind.name) + " " + room.name +
                                 (rough ? " rough " : " smooth ") + (k % 2 ? "0.3" : "0");
        Case now = {name, kind, room, rough, k % 2 ? 0.3 : 0, 0};
        bool is_asked = true;
        for (int word = 1; word < argc; word++)
          is_asked = is_asked && (" " + name + " ").find(argv[word]) != std::string::npos;
        if (!is_asked)
          continue;
        Result r[ALL];
        for (int p = 0; p < ALL; p++) {
          r[p] = now.run_at(PACES[p]);
          if (!kind.is_body)
            grain[p] = r[p];
          else if (kind.nx == 1 && r[p].end.size() == grain[p].end.size())
            now.check_same(PACES[p], grain[p], r[p]);
        }
        now.check_impacts(r);
        now.check_pieces(PACES[1], r[1]);
        cases++;
        failed += now.failed > 0;
      }
    }
  printf("%d of %d cases fail\n", failed, cases);
  return failed > 0;
}
