/* Steps of walls without an engine: loads and their numbers, the search, what stays at a wall, and
 * what a restart keeps.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "alone.h"

#include <stdlib.h>
#include <algorithm>

#include "contact/vector.h"
#include "dem/shapes/mesh.h"
#include "dem/shapes/primitive.h"

#include "check.h"

using namespace asperity;

static int reductions;

/* MPI's own, and counted. */
int MPI_Allreduce(const void *from, void *to, int count, MPI_Datatype type, MPI_Op op,
                  MPI_Comm comm) {
  reductions++;
  return PMPI_Allreduce(from, to, count, type, op, comm);
}

namespace {

typedef std::unique_ptr<Shape> ShapePtr;

const double STILL[3] = {0, 0, 0};
const char *const STICKY = "rebound bons yield_rate 0 deposit freeze materials quartz";
const char *const DULL = "rebound constant 0.5 0.5 deposit off";

bool near(double a, double b, double within) {
  return fabs(a - b) <= within;
}

int count(const std::string &text, const char *part) {
  int found = 0;
  for (size_t at = 0; (at = text.find(part, at)) != std::string::npos; at++)
    found++;
  return found;
}

ShapePtr plane(int axis, double at, const double velocity[3] = STILL) {
  return ShapePtr(new PlaneShape(axis, at, velocity));
}

/* A triangle around the origin, far larger than all else, across `normal`. */
ShapePtr triangle_across(const double normal[3]) {
  const double other[3] = {normal[1], normal[2], normal[0] + 1};
  double a[3], b[3];
  aspi_cross(normal, other, a);
  aspi_scale(1 / aspi_length(a), a);
  aspi_cross(normal, a, b);
  aspi_scale(1 / aspi_length(b), b);
  ContactTriangle triangle;
  for (int k = 0; k < 3; k++)
    for (int d = 0; d < 3; d++)
      triangle.node[k][d] = 100 * (cos(2 * ASP_PI * k / 3) * a[d] + sin(2 * ASP_PI * k / 3) * b[d]);
  std::unique_ptr<MeshShape> mesh(new MeshShape);
  set_triangles(*mesh, {triangle});
  return ShapePtr(mesh.release());
}

/* ---- loads ------------------------------------------------------------------------------------
 */

/* The momenta of grains, and the angular ones about a point; all may spin. */
void add_momenta(const Grains &g, const double about[3], double sign, double sum[6]) {
  for (size_t i = 0; i < g.tag.size(); i++) {
    double arm[3], turn[3];
    aspi_subtract(&g.x[3 * i], about, arm);
    aspi_cross(arm, &g.v[3 * i], turn);
    aspi_add_scaled(turn, 0.4 * g.radius[i] * g.radius[i], &g.omega[3 * i], turn);
    aspi_add_scaled(sum, sign * g.mass[i], &g.v[3 * i], sum);
    aspi_add_scaled(sum + 3, sign * g.mass[i], turn, sum + 3);
  }
}

/* Impulse and angular impulse of rough walls are what the grains lose, to rounding: by laws that
 * turn them and by those that do not, with first and later hits. */
TEST(walls_get_what_grains_lose) {
  const double about[3] = {0.3, -0.2, 0.5};
  const char *const laws[] = {"walton 0.9 0.3 0.2", "constant 0.9 0.8"};
  for (const char *law : laws) {
    const Alone engine;
    Shapes planes;
    planes.push_back(plane(0, -5));
    planes.push_back(plane(0, 5));
    std::unique_ptr<Wall> wall = make_wall(
        engine, std::move(planes),
        std::string("surface sigma 10 deposit off torque_about 0.3 -0.2 0.5 rebound ") + law);
    Grains grains(200, 0.5, 0.5);
    grains.spins = true;
    for (int i = 0; i < 200; i++) {
      grains.v[3 * i] = 1 + 0.01 * i;
      grains.v[3 * i + 1] = 0.05 * i;
      grains.omega[3 * i + 1] = 0.01 * i - 1;
      grains.omega[3 * i + 2] = 1 - 0.02 * i;
    }
    double lost[6] = {0}, torque[3] = {0}, scale = 0;
    add_momenta(grains, about, 1, lost);
    grains.begin({wall.get()});
    for (int step = 0; step < 30; step++) {
      grains.fly(1);
      for (int d = 0; d < 3; d++)
        torque[d] += wall->books.counter(Books::TORQUE + d) * grains.dt;
    }
    add_momenta(grains, about, -1, lost);
    assert_true(wall->books.counter(Books::N_IMPACTS) > 100 &&
                wall->books.counter(Books::N_LATER_HITS) > 10);
    for (double of : lost)
      scale = std::max(scale, fabs(of));
    for (int k = 0; k < 6; k++)
      assert_true(fabs(wall->books.counter(Books::IMPULSE + k) - lost[k]) < 1e-12 * scale);
    for (int d = 0; d < 3; d++)
      assert_true(fabs(torque[d] - lost[3 + d]) < 1e-12 * scale && fabs(lost[3 + d]) > 0);
  }
}

/* The kinetic energy of grains that spin. */
double energy_of(const Grains &g) {
  double sum = 0;
  for (size_t i = 0; i < g.tag.size(); i++)
    sum += 0.5 * g.mass[i] *
           (aspi_dot(&g.v[3 * i], &g.v[3 * i]) +
            0.4 * g.radius[i] * g.radius[i] * aspi_dot(&g.omega[3 * i], &g.omega[3 * i]));
  return sum;
}

/* A kick; what forces give is not the walls'. */
void kick_without_forces(Grains &g, const double about[3], double lost[6]) {
  std::vector<double> walls(g.total), turning(g.torque);
  for (size_t k = 0; k < walls.size(); k++)
    walls[k] -= g.f[k];
  add_momenta(g, about, -1, lost);
  g.total = g.f;
  g.torque.assign(turning.size(), 0.);
  g.kick();
  add_momenta(g, about, 1, lost);
  g.total = walls;
  g.torque = turning;
  g.kick();
  for (size_t k = 0; k < walls.size(); k++)
    g.total[k] += g.f[k];
}

/* So it does of grains that roll over its faces, hop, and lie in its valleys. Some of the energy
 * that forces give is lost within a step, so that the sums of energy are less exact. */
TEST(valleys_get_what_grains_lose) {
  const double about[3] = {0.3, -0.2, 0.5};
  const int n = 100;
  GrainsAtWall s(
      plane(0, 0),
      "surface rq 0.1 lambda_c 1 deposit off torque_about 0.3 -0.2 0.5 rebound walton 0.5 0.3 0", n,
      0.5, 0.01);
  Grains &grains = s.grains;
  grains.spins = true;
  for (int i = 0; i < n; i++) {
    grains.put(i, {i % 2 ? 0.5 : 0.51, 3. * i, 0}, {0, 0.03 * i, 0});
    grains.omega[3 * i + 2] = 0.02 * i;
    grains.f[3 * i] = -1;
    grains.f[3 * i + 2] = 0.1;
  }
  double lost[6] = {0}, work = energy_of(grains), scale = 0;
  add_momenta(grains, about, 1, lost);
  s.begin();
  for (int step = 0; step < 1500; step++) {
    kick_without_forces(grains, about, lost);
    add_momenta(grains, about, -1, lost);
    for (size_t k = 0; k < grains.x.size(); k++) {
      work += grains.f[k] * grains.v[k] * grains.dt;
      grains.x[k] += grains.v[k] * grains.dt;
    }
    add_momenta(grains, about, 1, lost);
    step_walls(grains.walls, grains.spheres());
    grains.total = grains.f;
    grains.torque.assign(grains.torque.size(), 0.);
    kick_without_forces(grains, about, lost);
    end_walls(grains.walls, grains.spheres());
    s.wall->books.end_loads();
  }
  add_momenta(grains, about, -1, lost);
  int lie = 0;
  for (int i = 0; i < n; i++)
    lie += aspi_length(&grains.v[3 * i]) < 1e-12;
  work -= energy_of(grains);
  for (size_t k = 0; k < grains.v.size(); k++) /* the half that is to come */
    grains.total[k] -= grains.f[k];
  add_momenta(grains, about, 1, lost);
  grains.kick();
  add_momenta(grains, about, -1, lost);
  for (double of : lost)
    scale = std::max(scale, fabs(of));
  assert_true(s.count(Books::N_IMPACTS) > n && lie > n / 20 && lie < n);
  for (int k = 0; k < 6; k++)
    assert_true(fabs(s.count(Books::IMPULSE + k) - lost[k]) < (k < 3 ? 1e-11 : 1e-7) * scale);
  assert_true(fabs(s.count(Books::DISSIPATED) - work) < 0.1 * work);
}

/* ---- slopes -----------------------------------------------------------------------------------
 */

/* Grains that fall to a slope of `angle` degrees, in units of gravity and lambda_c. Their mean way
 * in the last half of the time, of those that move at its end, and the share of the others. */
void go_down(const std::string &surface, double d, double angle, double height, double speed,
             double dt, double &way, double &stopped) {
  const int n = 300, half = static_cast<int>(75 / dt + 0.5);
  GrainsAtWall s(plane(2, 0), "deposit off rebound walton 0.5 0.3 0 surface rq " + surface, n,
                 d / 2, dt);
  Grains &grains = s.grains;
  grains.spins = true;
  for (int i = 0; i < n; i++) {
    grains.put(i, {0, 0, d / 2 + height}, {speed, 0, 0});
    grains.omega[3 * i + 1] = 2 * speed / d;
    grains.f[3 * i] = sin(angle * ASP_PI / 180);
    grains.f[3 * i + 2] = -cos(angle * ASP_PI / 180);
  }
  s.begin();
  grains.fly(half);
  const std::vector<double> middle(grains.x);
  grains.fly(half);
  int moving = 0;
  way = 0;
  for (int i = 0; i < n; i++)
    if (fabs(grains.v[3 * i]) > 0.05) {
      moving++;
      way += grains.x[3 * i] - middle[3 * i];
    }
  way /= moving;
  stopped = 1 - moving / static_cast<double>(n);
}

/* Grains that fall to a wall stop as often as spheres on generated walls do
 * (tests/sweep/README.md); they are anywhere in their first valley, not at its bottom. */
TEST(grains_fall_anywhere) {
  double way, stopped;
  go_down("0.1414 lambda_c 1 spread visible plane", 4, 5, 0.1, 0, 0.1, way, stopped);
  assert_true(fabs(stopped - 0.575) < 0.1);
  go_down("0.1414 lambda_c 1", 4, 5, 0.1, 0, 0.1, way, stopped);
  assert_true(fabs(stopped - 0.44) < 0.1);
}

/* A long step does not make the faces longer: what it passes of a face at its end counts to the
 * next one. */
TEST(faces_keep_their_length) {
  double coarse, fine, stopped;
  go_down("0.035355 lambda_c 1", 8, 2, 0.01, 1.5, 0.5, coarse, stopped);
  go_down("0.035355 lambda_c 1", 8, 2, 0.01, 1.5, 0.05, fine, stopped);
  assert_true(fabs(coarse / fine - 1) < 0.04);
}

/* A bounce that is over within a step is none, also at a smooth wall: the last one that counts has
 * more speed than gravity takes in half a step. */
TEST(low_bounces_are_rests) {
  for (double dt : {1e-3, 2.5e-4}) {
    const double e = 0.8, drop = 0.02, g = 9.81;
    GrainsAtWall s(plane(2, 0), "deposit off rebound walton 0.8 0.3 0", 1, 1e-3, dt);
    s.grains.x[2] = 1e-3 + drop;
    s.grains.f[2] = -g;
    s.begin();
    s.grains.fly(static_cast<int>(1 / dt));
    int bounces = 0;
    for (double v = sqrt(2 * g * drop); v > g * dt / 2; v *= e)
      bounces++;
    assert_int_equal(static_cast<int>(s.count(Books::N_IMPACTS)), bounces);
    assert_true(aspi_length(&s.grains.v[0]) < 1e-12);
  }
}

/* So does a wall at which one sticks, and later what others do to it. */
TEST(stuck_grains_pass_their_spin_on) {
  GrainsAtWall s(plane(0, 0), STICKY, 1, 0.5, 0.1);
  Grains &grains = s.grains;
  grains.spins = true;
  grains.put(0, {0.5001, 0, 0}, {-1e-3, 2e-3, 0});
  grains.omega[2] = 3;
  double lost[6] = {0};
  add_momenta(grains, STILL, 1, lost);
  s.begin();
  grains.fly(5);
  assert_true(s.wall->stuck() == 1);
  for (int k = 0; k < 6; k++)
    assert_true(fabs(s.count(Books::IMPULSE + k) - lost[k]) < 1e-14);
  grains.omega[2] = 3;
  grains.fly(1);
  assert_true(fabs(s.count(Books::ANGULAR_IMPULSE + 2) - lost[5] - 0.4 * 0.25 * 3) < 1e-14);
  assert_true(!(fabs(grains.omega[2]) > 0));
}

/* Whatever acts on a stuck grain goes to its wall, in the step in which it acts: as long as it
 * stays the same, when it changes within a step, and where grains change places within one. */
TEST(stuck_grains_pass_their_forces_on) {
  GrainsAtWall s(plane(0, 0), STICKY, 2, 0.5, 0.1);
  Grains &grains = s.grains;
  for (int i = 0; i < 2; i++)
    grains.put(i, {0.5001, 2. * i, 0}, {-2e-3, 0, 0});
  s.begin();
  grains.fly(1);
  assert_true(s.wall->stuck() == 2);
  const double before = s.count(Books::ANGULAR_IMPULSE + 2);
  double sum = 0, turn = 0, last[2] = {0, 0};
  for (int step = 0; step < 40; step++) {
    grains.advance();
    const double acts = step % 20 < 12 ? 3 : step % 20 < 14 ? -2 : 0;
    grains.mass[1] = step > 30 ? 2 : 1;
    grains.f[1] = acts;
    grains.f[4] = 0.5 * acts * grains.mass[1];
    if (step % 8 == 5)
      s.wall->reorder(grains.spheres());
    grains.finish();
    double all = 0;
    for (size_t i = 0; i < 2; i++) {
      const double force = 0.5 * (last[i] + grains.f[3 * i + 1]), y = 2 * static_cast<double>(i);
      const double *state = &grains.states[0][i * Wall::N_STATE];
      assert_true(fabs(state[3] - force) < 1e-12 && !(fabs(state[2]) > 0));
      assert_true(fabs(state[6] - (fabs(force) > 0 ? y : 0)) < 1e-12);
      assert_true(!(fabs(grains.v[3 * i + 1]) > 0) && !(fabs(grains.x[3 * i + 1] - y) > 0));
      last[i] = grains.f[3 * i + 1];
      all += force;
    }
    sum += 0.1 * all;
    turn += 0.1 * 0.5 * all;
    assert_true(fabs(s.count(Books::FORCE + 1) - all) < 1e-12);
    assert_true(fabs(s.count(Books::IMPULSE + 1) - sum) < 1e-12);
    assert_true(fabs(s.count(Books::ANGULAR_IMPULSE + 2) - before - turn) < 1e-12);
  }
}

/* Closes in along z at its own speed, wherever the grain is. */
class Chaser : public Shape {
public:
  explicit Chaser(double speed) : speed_(speed) {}
  double clear(const Course &, const FaceList &) const override {
    return 0;
  }
  bool find(const Path &path, double, double, Contact &contact) const override {
    contact = Contact();
    aspi_copy(path.x, contact.x);
    contact.n[2] = contact.n_end[2] = 1;
    contact.v_wall[2] = speed_;
    contact.approach_speed = speed_ - path.v[2];
    return contact.approach_speed > 1e-6;
  }
  bool under(int, const double[3], const double[3], double, Contact &, double &) const override {
    return false;
  }
  void stick(const Path &, const Contact &contact, Place &place) const override {
    aspi_copy(contact.x, place.at);
  }
  void carry(Place &place, double, double, double x[3], double v[3]) const override {
    aspi_copy(place.at, x);
    aspi_copy(STILL, v);
  }

private:
  double speed_;
};

/* Of contacts in a row the last one that is searched may be a deposit: the grain is not trapped,
 * and its impacts count. */
TEST(the_last_contact_may_stick) {
  const Alone engine;
  const int series = 32, struck = 16; /* contacts; those before all are taken as sustained */
  Shapes walls;
  double speed = 0;
  for (int k = 0; k < series; k++) {
    speed += k == series - 1 ? 1e-3 : 10 * (k + 1);
    walls.push_back(ShapePtr(new Chaser(speed)));
  }
  std::unique_ptr<Wall> wall = make_wall(engine, std::move(walls), STICKY);
  Grains grains(1, 0.5, 0.1);
  grains.begin({wall.get()});
  grains.fly(1);
  assert_true(wall->stuck() == 1);
  assert_true(wall->books.counter(Books::N_DEPOSITS) == 1);
  assert_true(wall->books.counter(Books::N_IMPACTS) == struck + 1);
  assert_true(wall->books.counter(Books::N_GUARDED) == 0);
}

/* All numbers of a wall take one reduction, and none until something has changed. */
TEST(numbers_take_one_reduction) {
  GrainsAtWall s(plane(0, 0), DULL, 1, 0.5, 0.1);
  Grains &grains = s.grains;
  grains.put(0, {0.55, 0, 0}, {-1, 0, 0});
  grains.f[0] = -0.1;
  s.begin();
  assert_true(!(s.count(Books::N_IMPACTS) > 0));
  grains.advance();
  reductions = 0;
  for (int times = 0; times < 2; times++) {
    for (int k = 0; k < Books::N_COUNTERS; k++)
      s.count(k);
    for (int k = 0; k < Books::N_TOTALS; k++)
      s.wall->books.total(0, k);
    assert_int_equal(reductions, 1);
  }
  assert_true(s.count(Books::N_IMPACTS) > 0);
  const double force = s.count(Books::FORCE);
  grains.f[0] = -100; /* presses the grain back by the end of its step */
  grains.finish();
  assert_true(fabs(s.count(Books::FORCE) - force) > 0);
  assert_int_equal(reductions, 2);
}

/* ---- the search -------------------------------------------------------------------------------
 */

/* Overlaps by rounding are no guarded contacts. A center on the wall goes back to its side. */
TEST(rounding_is_not_guarded) {
  const double overlap[] = {1e-10, 1e-6, 1e-3, 1};
  for (double deep : overlap) {
    GrainsAtWall s(plane(0, 0), DULL, 1, 0.5, 0.1);
    s.grains.put(0, {0.5 * (1 - deep), 0, 0}, {-1, 0, 0});
    s.begin();
    s.grains.fly(1);
    assert_true(s.count(Books::N_IMPACTS) == 1);
    assert_true(s.count(Books::N_GUARDED) == (deep > 1e-4));
    assert_true(s.grains.x[0] >= 0 && near(s.grains.v[0], 0.5, 1e-12));
  }
}

/* Between two meshes that leave a grain no room, of one wall or of two, at rest or closing in: it
 * is in the middle, goes with them, counts as guarded in each step, and has no more impacts. */
TEST(narrow_places_hold_grains) {
  const double up[3] = {0, 0, 1}, r = 1e-3, dt = 1e-5;
  const double cases[][4] = {/* gap, speed of the upper mesh; place and speed of the grain */
                             {1.5e-3, 0, 0.7e-3, 1e-3},
                             {1.5e-3, 0, 0.8e-3, -2},
                             {1.5e-3, 0, 0.1e-3, 1},
                             {2.3e-3, -0.1, 1.1e-3, 0}};
  for (const double *of : cases)
    for (int kind = 0; kind < 6; kind++) {
      Alone engine;
      engine.least = engine.most = 2 * r;
      const char *const laws[] = {"constant 1 1", "constant 0.5 0.9",
                                  "constant 0.9 0.9 surface rq 1e-5 lambda_c 1e-4"};
      const std::string words = std::string("deposit off rebound ") + laws[kind % 3];
      Shapes shapes;
      shapes.push_back(triangle_across(up));
      shapes.push_back(triangle_across(up));
      MeshShape *upper = static_cast<MeshShape *>(shapes[1].get());
      Frame frame;
      Twist twist;
      frame.shift[2] = of[0];
      twist.linear[2] = of[1];
      upper->motion().settle(frame, false);
      upper->motion().set_last(twist);
      for (ShapePtr &shape : shapes)
        static_cast<MeshShape *>(shape.get())->set_images(Box());
      std::vector<std::unique_ptr<Wall>> walls;
      if (kind < 3)
        walls.push_back(make_wall(engine, std::move(shapes), words, 1));
      else
        for (ShapePtr &shape : shapes)
          walls.push_back(make_wall(engine, std::move(shape), words, 1));
      Grains grains(1, r, dt);
      grains.spins = true;
      grains.x[2] = of[2];
      grains.v[2] = of[3];
      std::vector<Wall *> all;
      for (const std::unique_ptr<Wall> &wall : walls)
        all.push_back(wall.get());
      grains.begin(all);
      const bool closes = fabs(of[1]) > 0;
      double guarded = 0, impacts = 0;
      for (int step = 1; step <= 1000; step++) {
        double now = 0, hits = 0;
        frame.shift[2] += of[1] * dt;
        upper->motion().advance(frame, twist, dt);
        upper->set_images(Box());
        grains.fly(1);
        for (Wall *wall : all) {
          now += wall->books.counter(Books::N_GUARDED);
          hits += wall->books.counter(Books::N_IMPACTS);
        }
        if (step > 310) {
          assert_true(near(grains.v[2], 0.5 * of[1], 1e-12) && !(hits > impacts));
          assert_true(!closes || (near(grains.x[2], 0.5 * frame.shift[2], 1e-7) && now > guarded));
        }
        guarded = now;
        impacts = hits;
      }
      assert_true(guarded > 0 && impacts < 50);
    }
}

/* A prediction allows for as much straying as goes unnoticed: by three components at once. */
TEST(straying_grains_are_met) {
  const double n[3] = {sqrt(1. / 3), sqrt(1. / 3), sqrt(1. / 3)};
  const double stray = 2e-3 * 0.5, share[] = {0.57, 0.6, 0.99};
  for (double of : share) {
    GrainsAtWall s(triangle_across(n), DULL, 1, 0.5, 0.1, 1);
    Grains &grains = s.grains;
    for (int d = 0; d < 3; d++)
      grains.x[d] = 0.7 * n[d];
    s.begin();
    grains.fly(2);
    for (int d = 0; d < 3; d++)
      grains.v[d] = -of * stray / grains.dt;
    for (int k = 0; k < 300; k++) {
      grains.fly(1);
      assert_true(aspi_dot(grains.x.data(), n) > 0.5 - 1e-9);
    }
    assert_true(s.count(Books::N_IMPACTS) == 1 && s.count(Books::N_GUARDED) < 1);
  }
}

/* The same of one that a floor bends on its way within each step, while a force bends it back: the
 * velocity that the prediction sees is not that of the path. */
TEST(bent_ways_are_met) {
  const double n[3] = {-M_SQRT1_2, -M_SQRT1_2, 0};
  const double stray = 2e-3 * 0.5, dt = 0.1, bends[] = {0.24, 2};
  const double fast[3] = {100 * stray / dt, 100 * stray / dt, 0};
  for (double bend : bends) {
    const Alone engine;
    std::unique_ptr<Wall> floor = make_wall(engine, plane(2, 0, fast),
                                            "rebound walton 0.5 10 0 deposit off"),
                          wall = make_wall(engine, triangle_across(n), DULL, 1);
    Grains grains(1, 0.5, dt);
    const double pull = bend * stray / dt, along = 0.5 * stray / dt;
    for (int d = 0; d < 2; d++) {
      grains.x[d] = (0.5 + 300 * stray) * n[d];
      grains.v[d] = -along * n[d];
      grains.f[d] = 2 * pull / dt * n[d];
    }
    grains.x[2] = 0.5;
    grains.f[2] = -0.2 * pull / dt;
    grains.begin({floor.get(), wall.get()});
    for (int k = 0; k < 400 && wall->books.counter(Books::N_IMPACTS) < 1; k++) {
      if (k == 3)
        for (int d = 0; d < 2; d++)
          grains.v[d] += 0.57 * stray / dt;
      grains.fly(1);
      assert_true(aspi_dot(grains.x.data(), n) > 0.5 - 1e-9);
    }
    assert_true(wall->books.counter(Books::N_IMPACTS) == 1 &&
                wall->books.counter(Books::N_GUARDED) < 1);
    assert_true(!(floor->books.counter(Books::N_IMPACTS) > 0));
  }
}

/* ---- what stays at a wall ---------------------------------------------------------------------
 */

/* Without friction a grain slides around the inside of a cylinder at its speed, on the wall. The
 * steps that it takes are chords: their speed differs from that of the first instant by a share of
 * 1e-6. */
TEST(grains_slide_inside_cylinders) {
  GrainsAtWall s(ShapePtr(new CylinderShape(2, STILL, 5, 0, 0)),
                 "rebound walton 0.5 0 0 deposit off", 1, 0.5, 0.01);
  Grains &grains = s.grains;
  grains.put(0, {4.5, 0, 0}, {0, 3, 0.2});
  s.begin();
  double speed = aspi_length(grains.v.data());
  for (int k = 0; k < 3000; k++) {
    grains.fly(1);
    assert_true(fabs(hypot(grains.x[0], grains.x[1]) - 4.5) < 1e-6);
    if (k == 10)
      speed = aspi_length(grains.v.data());
    assert_true(fabs(aspi_length(grains.v.data()) - speed) < (k < 10 ? 1e-5 : 1e-9));
  }
  assert_true(grains.x[2] > 5.9 && s.count(Books::N_IMPACTS) < 1 && s.count(Books::N_GUARDED) < 1);
}

/* Without friction a grain slides down the outside of a cylinder, above it by no more than a
 * tangent of a step's length is, and leaves it where the cosine of the angle from the top is 2/3 of
 * that at which it began. */
TEST(grains_leave_cylinders) {
  const double at = 0.1, rho = 5.5;
  GrainsAtWall s(ShapePtr(new CylinderShape(1, STILL, 5, 0, 0)),
                 "rebound walton 0.5 0 0 deposit off", 1, 0.5, 0.01);
  Grains &grains = s.grains;
  grains.put(0, {rho * sin(at), 0, rho * cos(at)}, {0, 0, 0});
  grains.f[2] = -1 * grains.mass[0];
  s.begin();
  double leaves = 0;
  for (int k = 0; k < 3000 && !(leaves > 0); k++) {
    const double way = grains.dt * hypot(grains.v[0], grains.v[2]);
    const double above = hypot(grains.x[0], grains.x[2]) - rho;
    grains.fly(1);
    if (static_cast<int>(grains.states[0][1]) != static_cast<int>(Status::RESTING))
      leaves = k > 0 ? atan2(grains.x[0], grains.x[2]) : 0;
    else
      assert_true(above > -1e-10 && above < 0.51 * way * way / rho + 1e-9);
  }
  print_message("leaves at %g, not %g\n", leaves, acos(2.0 / 3 * cos(at)));
  assert_true(fabs(leaves - acos(2.0 / 3 * cos(at))) < 0.02);
}

/* A belt that turns about z. */
class Turntable : public MeshShape {
  bool runs() const override {
    return true;
  }
  void surface_velocity(int, const double foot[3], double v[3]) const override {
    v[0] = -foot[1];
    v[1] = foot[0];
    v[2] = 0;
  }
};

/* A stuck grain goes around on a circle, to the second order of the step. */
TEST(belts_keep_their_radius) {
  ContactTriangle triangle = {{{-30, -20, 0}, {30, -20, 0}, {0, 40, 0}}};
  Turntable belt;
  set_triangles(belt, {triangle});
  Place place = {0, {3, 0, 0.5}};
  double x[3], v[3];
  for (int step = 0; step < 100; step++)
    static_cast<const Shape &>(belt).carry(place, 0.5, 2 * ASP_PI / 100, x, v);
  assert_true(fabs(hypot(x[0], x[1]) - 3) < 1e-3 && fabs(x[1]) < 0.02 && x[0] > 0);
}

/* A rough room at rest gives no energy to grains that gravity lets hop, slide and hit its corners,
 * in steps of 10 and 100 diameters: a cube, of one wall or of one for each plane, and a tube. */
TEST(rough_rooms_give_no_energy) {
  const double half = 10, g = 1, speed = sqrt(6 * g * half);
  for (int kind = 0; kind < 3; kind++) {
    const Alone engine;
    const char *const law = "surface sigma 10 rebound constant 1 1 deposit off";
    std::vector<std::unique_ptr<Wall>> walls;
    Shapes shapes;
    if (kind == 2)
      shapes.push_back(ShapePtr(new CylinderShape(1, STILL, half, 0, 0)));
    for (int k = 0; k < 6 && kind < 2; k++) {
      shapes.push_back(plane(k / 2, k % 2 ? half : -half));
      if (kind == 1) {
        walls.push_back(make_wall(engine, std::move(shapes), law));
        shapes.clear();
      }
    }
    if (kind != 1)
      walls.push_back(make_wall(engine, std::move(shapes), law));
    std::vector<Wall *> all;
    for (const std::unique_ptr<Wall> &wall : walls)
      all.push_back(wall.get());
    const int n = 100;
    Grains grains(n, 0.5, (kind == 1 ? 10 : 100) / speed);
    grains.spins = true;
    for (int i = 0; i < n; i++) {
      const double v[3] = {sin(i * 1.7 + 1), cos(i * 2.3), sin(3.1 * i + 2)};
      aspi_add_scaled(&grains.v[3 * i], speed / aspi_length(v), v, &grains.v[3 * i]);
      for (int d = 0; d < 3; d++)
        grains.x[3 * i + d] = 0.6 * half * sin(i * (d + 1.3));
      grains.f[3 * i + 2] = -g;
    }
    double first = 0;
    grains.begin(all);
    for (int step = 0; step <= 100; step++) {
      double energy = energy_of(grains);
      for (int i = 0; i < n; i++)
        energy += g * grains.x[3 * i + 2];
      if (step == 0)
        first = energy;
      assert_true(energy < first + 1e-3 * n * g * half);
      grains.fly(1);
    }
  }
}

/* A face that faces the flight may send a grain off faster along the normal of the mean wall than
 * it came; no force that changes within the step may do so many times its work. */
TEST(forces_do_their_own_work) {
  GrainsAtWall s(plane(2, 0), "surface sigma 10 rebound constant 1 1 deposit off spread visible",
                 100, 0.5, 0.01);
  Grains &grains = s.grains;
  for (int i = 0; i < 100; i++) {
    grains.put(i, {3. * i, 0, 0.5001}, {5, 0, -0.02});
    grains.f[3 * i + 2] = 0.01;
  }
  s.begin();
  grains.advance();
  double most = 0;
  const std::vector<double> before = grains.v;
  for (int i = 0; i < 100; i++)
    grains.f[3 * i + 2] = 2;
  grains.finish();
  for (int i = 0; i < 100; i++) {
    const double v = before[3 * i + 2], now = grains.v[3 * i + 2];
    const double work = 2 * (fabs(grains.x[3 * i + 2] - 0.5) + 1e-4);
    most = std::max(most, v / 0.02);
    if (v > 0.1)
      assert_true(fabs(now * now - v * v) < 2 * 2 * work);
  }
  assert_true(most > 10);
}

/* ---- what the user is told --------------------------------------------------------------------
 */

/* Particles that are still to come have no density yet: that of their material counts. */
TEST(grains_to_come_are_not_doubted) {
  const std::vector<Engine::Kind> kinds =
      kinds_of(Spheres(), 1, std::vector<double>(1, 5e-5), MPI_COMM_WORLD);
  assert_true(kinds[0].present && !(kinds[0].least > 0) && !(kinds[0].most > 0));
  Alone engine;
  engine.least = 1e-5;
  engine.most = 1e-4;
  engine.kind = kinds[0];
  std::unique_ptr<Wall> wall = make_wall(engine, plane(0, 0), "materials quartz");
  wall->init(0, 0.1);
  assert_string_equal(engine.warned.c_str(), "");
  assert_int_equal(count(engine.printed, "d_p 1e-05 sticks below"), 1);
  assert_int_equal(count(engine.printed, ", d_p 0.0001 below"), 1);
}

/* A doubt that takes a diameter is said when there is one, and none is said twice. */
TEST(doubts_are_said_once) {
  Alone engine;
  engine.least = engine.most = 0;
  std::unique_ptr<Wall> wall =
      make_wall(engine, plane(0, 0),
                "surface rq 0.005 lambda_c 0.1 materials quartz erosion oka 1.8 density 7800");
  const double sizes[] = {0, 0, 1e-6, 1e-6, 5e-7};
  for (int k = 0; k < 5; k++) {
    engine.least = sizes[k];
    engine.most = sizes[k] > 0 ? 1e-6 : 0;
    wall->init(k, 0.1);
    assert_int_equal(count(engine.warned, "hardness is 1.8,"), 1);
    assert_int_equal(count(engine.warned, "rq is 0.005 m, 5e+03 times"), k > 1);
  }
}

/* Grains stick below the speed that the log names, and not above it. */
TEST(the_log_names_what_sticks) {
  Alone engine;
  engine.least = engine.most = 1e-5;
  engine.kind = Engine::Kind{true, 2650, 2650};
  std::unique_ptr<Wall> wall = make_wall(engine, plane(0, 0), "materials quartz");
  wall->init(0, 0.1);
  const size_t at = engine.printed.find("sticks below ");
  assert_true(at != std::string::npos);
  const double speed = strtod(engine.printed.c_str() + at + 13, NULL);
  assert_true(speed > 0);
  Grains grains(2, 5e-6, 1e-6 / speed);
  for (int i = 0; i < 2; i++) {
    grains.mass[i] = 2650 * ASP_PI / 6 * 1e-15;
    grains.put(i, {5.5e-6, 0, 0}, {-speed * (i ? 1.01 : 0.99), 0, 0});
  }
  grains.begin({wall.get()});
  grains.fly(1);
  assert_true(wall->books.counter(Books::N_IMPACTS) == 2 && wall->stuck() == 1);
  assert_true(grains.v[3] > 0);
}

/* ---- runs after others ------------------------------------------------------------------------
 */

/* Larger and smaller grains than those so far need tables of their own; others do not. */
TEST(new_sizes_need_new_tables) {
  Alone engine;
  std::unique_ptr<Wall> wall = make_wall(
      engine, plane(2, 0),
      "surface rq 0.05 lambda_c 1 dp_bins 1 spread traced rebound constant 1 1 deposit off");
  const double sizes[][2] = {{1, 1}, {1, 4}, {2, 3}};
  const int reports[] = {1, 2, 2};
  for (int k = 0; k < 3; k++) {
    engine.least = sizes[k][0];
    engine.most = sizes[k][1];
    wall->init(k, 0.1);
    assert_int_equal(count(engine.printed, ", spread traced"), reports[k]);
  }
}

/* A restart file that is written before the first step has what was read of the ledger's file. */
TEST(restarts_keep_their_ledger) {
  const Alone engine;
  char folder[] = "/tmp/asperity.XXXXXX";
  assert_non_null(mkdtemp(folder));
  const std::string file = std::string(folder) + "/rows.csv";
  const auto make = [&] {
    return make_wall(engine, plane(0, 0),
                     "rebound constant 0.5 0.5 deposit off ledger 10 file " + file);
  };
  std::unique_ptr<Wall> wall = make(), next = make();
  Grains grains(1, 0.5, 0.1);
  grains.put(0, {0.55, 0, 0}, {-1, 0, 0});
  grains.begin({wall.get()});
  grains.fly(2);
  const std::vector<char> saved = wall->save();
  next->restore(saved.data());
  const std::vector<char> again = next->save();
  const LedgerState first = unpack(saved.data()).ledger, second = unpack(again.data()).ledger;
  assert_int_equal(first.rows, 1);
  assert_int_equal(second.rows, 1);
  assert_int_equal(second.bytes, first.bytes);
  assert_int_equal(second.tail, first.tail);
  assert_string_equal(second.path.c_str(), file.c_str());
  assert_true(next->books.counter(Books::N_IMPACTS) == 1);
  remove(file.c_str());
  remove(folder);
}

} // namespace
