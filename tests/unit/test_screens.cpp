/* Barriers between spheres and walls: what is behind them, that a search finds nothing in front of
 * them, and that grains do the same with and without them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "alone.h"

#include <math.h>
#include <string.h>

#include "contact/vector.h"
#include "dem/shapes/mesh.h"
#include "dem/shapes/primitive.h"

#include "barriers.h"
#include "check.h"

using namespace asperity;

namespace {

typedef std::unique_ptr<Shape> ShapePtr;

const double STILL[3] = {0, 0, 0};

/* A box from -1 to 1 with n x n squares of two triangles on each side. */
std::vector<ContactTriangle> box(int n) {
  std::vector<ContactTriangle> all;
  for (int d = 0; d < 3; d++)
    for (int side = -1; side <= 1; side += 2)
      for (int i = 0; i < n; i++)
        for (int j = 0; j < n; j++) {
          double corner[4][3];
          for (int k = 0; k < 4; k++) {
            corner[k][d] = side;
            corner[k][(d + 1) % 3] = 2.0 * (i + k % 2) / n - 1;
            corner[k][(d + 2) % 3] = 2.0 * (j + k / 2) / n - 1;
          }
          for (int k = 1; k < 3; k++) {
            ContactTriangle one;
            aspi_copy(corner[0], one.node[0]);
            aspi_copy(corner[k], one.node[1]);
            aspi_copy(corner[3], one.node[2]);
            all.push_back(one);
          }
        }
  return all;
}

std::vector<ContactTriangle> soup(int n) {
  std::vector<ContactTriangle> all(static_cast<size_t>(n));
  for (ContactTriangle &one : all) {
    double center[3];
    random_vector(1, center);
    for (double(&node)[3] : one.node) {
      random_vector(0.3, node);
      aspi_add_scaled(node, 1, center, node);
    }
  }
  return all;
}

/* ---- the planes of a tree ---- */

bool is_behind(const ContactTriangle &t, const ContactPlane &plane) {
  bool all = true;
  for (const double(&node)[3] : t.node)
    all = all && aspi_dot(plane.n, node) <= plane.at + 1e-14;
  return all;
}

int check_planes(const std::vector<ContactTriangle> &all, ContactTree *tree, const double x[3],
                 double reach, int room) {
  ContactList near = {NULL, 0, 0};
  ContactPlane planes[4];
  const int count = aspi_tree_separate(tree, x, reach, NULL, 0, &near, planes, room);
  aspi_places_free(&near);
  for (int k = 0; k < count; k++) {
    assert_near(aspi_length(planes[k].n), 1, 1e-12);
    assert_true(aspi_dot(planes[k].n, x) > planes[k].at);
  }
  for (const ContactTriangle &t : all) {
    double foot[3];
    bool behind = count < 0 || aspi_triangle_nearest(&t, x, foot) >= reach;
    for (int k = 0; k < count; k++)
      behind = behind || is_behind(t, planes[k]);
    assert_true(behind);
  }
  return count;
}

ContactTree *tree_of(const std::vector<ContactTriangle> &all) {
  ContactTree *tree = aspi_tree_begin();
  for (size_t k = 0; k < all.size(); k++)
    assert_true(aspi_tree_add(tree, &all[k], static_cast<int>(k)));
  assert_true(aspi_tree_finish(tree));
  return tree;
}

TEST(all_that_is_near_is_behind_a_plane) {
  for (int kind = 0; kind < 3; kind++) {
    const std::vector<ContactTriangle> all = kind < 2 ? box(kind ? 12 : 1) : soup(200);
    ContactTree *tree = tree_of(all);
    int counts[6] = {0, 0, 0, 0, 0, 0};
    for (int round = 0; round < 2000; round++) {
      double x[3];
      random_vector(kind < 2 ? 0.99 : 1.5, x);
      counts[1 + check_planes(all, tree, x, uniform(0.01, 0.6), 4)]++;
    }
    for (int count = 1; count <= 4; count++)
      assert_true(counts[count] > (kind < 2 && count == 4 ? 0 : 10));
    assert_true(kind < 2 ? counts[0] == 0 : counts[0] > 10); /* a box has three planes at most */
    aspi_tree_free(tree);
  }
}

/* A face is one plane, however many triangles it has; without room, and on a face, there is none.
 */
TEST(a_corner_is_three_planes) {
  const std::vector<ContactTriangle> all = box(20);
  ContactTree *tree = tree_of(all);
  const double corner[3] = {0.9, 0.85, -0.8}, on[3] = {1, 0.3, 0.2}, middle[3] = {0.1, 0.2, 0};
  assert_int_equal(check_planes(all, tree, corner, 0.3, 4), 3);
  assert_int_equal(check_planes(all, tree, corner, 0.3, 2), -1);
  assert_int_equal(check_planes(all, tree, corner, 0.12, 4), 1);
  assert_int_equal(check_planes(all, tree, on, 0.3, 4), -1);
  assert_int_equal(check_planes(all, tree, middle, 0.3, 4), 0);
  const int stays[2] = {0, 1000000}; /* a triangle at x = -1, and one that is not there */
  const double low[3] = {-0.95, 0.3, -0.9};
  ContactList near = {NULL, 0, 0};
  ContactPlane planes[4];
  assert_int_equal(aspi_tree_separate(tree, low, 0.3, stays, 2, &near, planes, 4), 1);
  assert_near(planes[0].n[2], 1, 1e-12);
  aspi_places_free(&near);
  aspi_tree_free(tree);
}

/* ---- shapes ---- */

ShapePtr mesh_of(const std::vector<ContactTriangle> &triangles) {
  std::unique_ptr<MeshShape> mesh(new MeshShape);
  set_triangles(*mesh, triangles);
  mesh->set_images(Box());
  return ShapePtr(mesh.release());
}

/* Moves a mesh as in a step: by a turn about an axis aslant, and a shift. */
void move(Shape &shape, double dt) {
  MeshShape *mesh = dynamic_cast<MeshShape *>(&shape);
  if (!mesh)
    return;
  double axis[3], rate[3];
  random_vector(1, axis);
  random_vector(0.02, rate);
  aspi_scale(1 / aspi_length(axis), axis);
  const double turn = uniform(-0.05, 0.05);
  Frame end = turn_about(rate, axis, turn);
  Twist twist = twist_about(rate, axis, turn / dt);
  aspi_add_scaled(end.shift, dt, rate, end.shift);
  aspi_add_scaled(twist.linear, 1, rate, twist.linear);
  mesh->motion().advance(end, twist, dt);
  mesh->set_images(Box());
  mesh->motion().settle(Frame(), false);
  mesh->motion().advance(end, twist, dt);
  mesh->set_images(Box());
}

/* Where a sphere keeps in front of all barriers, within the reach that they were made for, a search
 * finds nothing; and this is so for most that have a wall near. */
void check_shape(Shape &shape, bool moves) {
  const double dt = 0.1, radius = 0.2;
  BarrierCounts counts = BarrierCounts();
  for (int round = 0; round < 20000; round++) {
    if (moves)
      move(shape, dt);
    count_sphere(shape, radius, dt, counts);
  }
  assert_int_equal(counts.both, 0);
  assert_true(counts.met > 200 && counts.before > 400 && counts.near > counts.before);
}

TEST(nothing_is_met_before_barriers) {
  const double center[3] = {0.1, 0, 0};
  PlaneShape plane(1, 0.2, STILL);
  CylinderShape tube(2, center, 0.9, 0, 0), rod(0, center, 0.3, 0, 0);
  check_shape(plane, false);
  check_shape(tube, false);
  check_shape(rod, false);
  for (int moves = 0; moves < 2; moves++) {
    check_shape(*mesh_of(box(1)), moves);
    check_shape(*mesh_of(box(15)), moves);
    check_shape(*mesh_of(soup(30)), moves);
  }
}

/* ---- grains ---- */

/* A mesh that counts its searches, and may have no barriers. */
class Counted : public MeshShape {
public:
  bool separate(const double x[3], double reach, const FaceList &stays,
                BarrierList &made) const override {
    return has_barriers && MeshShape::separate(x, reach, stays, made);
  }
  bool find(const Path &path, double radius, double latest, Contact &contact) const override {
    finds++;
    return MeshShape::find(path, radius, latest, contact);
  }
  bool has_barriers = true;
  mutable int finds = 0;
};

const int GRAINS = 40, STEPS = 4000;

/* Grains in a box that shakes and turns to and fro; random forces act on them, as of others, and
 * gravity. */
struct Room {
  Alone engine;
  Counted *mesh;
  std::unique_ptr<Wall> wall;
  Grains grains;

  Room(bool has_barriers, const char *law, double rate, double at)
      : mesh(new Counted), grains(GRAINS, 0.1, 2e-3), rate_(rate), center_{at, 0, 0} {
    std::vector<ContactTriangle> triangles = box(3);
    for (ContactTriangle &one : triangles)
      for (double(&node)[3] : one.node)
        aspi_add_scaled(node, 1, center_, node);
    ShapePtr shape(mesh);
    mesh->has_barriers = has_barriers;
    set_triangles(*mesh, triangles);
    mesh->set_images(Box());
    engine.least = engine.most = 0.2;
    wall = make_wall(engine, std::move(shape), law, triangles.size());
    grains.spins = true;
    for (int i = 0; i < GRAINS; i++) {
      double x[3];
      random_vector(0.8, x);
      aspi_add_scaled(x, 1, center_, x);
      aspi_copy(x, &grains.x[static_cast<size_t>(3 * i)]);
    }
    grains.begin({wall.get()});
  }
  void step() {
    const double time = grains.dt * static_cast<double>(grains.now + 1);
    const double up[3] = {0, 0, 1};
    if (rate_ > 0) {
      Frame end = turn_about(center_, up, 0.3 * sin(rate_ * time));
      Twist twist = twist_about(center_, up, 0.3 * rate_ * cos(rate_ * time));
      end.shift[0] += 0.02 * sin(rate_ * time);
      twist.linear[0] += 0.02 * rate_ * cos(rate_ * time);
      mesh->motion().advance(end, twist, grains.dt);
      mesh->set_images(Box());
    }
    grains.advance();
    for (int i = 0; i < GRAINS; i++) {
      double *f = &grains.f[static_cast<size_t>(3 * i)];
      random_vector(0.5, f);
      f[2] -= 1;
      for (int d = 0; d < 3; d++)
        f[d] -= grains.v[static_cast<size_t>(3 * i + d)]; /* a drag */
    }
    grains.finish();
  }

private:
  double rate_, center_[3];
};

void check_grains(const char *law, double rate, double at, double most) {
  const uint32_t begin = random_state;
  Room with(true, law, rate, at);
  random_state = begin;
  Room without(false, law, rate, at);
  for (int k = 0; k < STEPS; k++) {
    const uint32_t now = random_state;
    with.step();
    random_state = now;
    without.step();
  }
  const size_t size = with.grains.x.size() * sizeof(double);
  const bool same = memcmp(with.grains.x.data(), without.grains.x.data(), size) == 0 &&
                    memcmp(with.grains.v.data(), without.grains.v.data(), size) == 0 &&
                    memcmp(with.grains.omega.data(), without.grains.omega.data(), size) == 0;
  for (int k = 0; k < Books::N_COUNTERS; k++)
    assert_true(!(fabs(with.wall->books.counter(k) - without.wall->books.counter(k)) > 0));
  assert_true(with.wall->books.counter(Books::N_IMPACTS) > GRAINS);
  printf("  searches of a grain in 1000 steps: %.0f, %.0f without barriers; %s\n",
         1e3 * with.mesh->finds / GRAINS / STEPS, 1e3 * without.mesh->finds / GRAINS / STEPS,
         same ? "the same" : "others");
  assert_true(same);
  assert_true(with.mesh->finds < most * without.mesh->finds);
}

TEST(grains_do_the_same) {
  check_grains("rebound walton 0.5 0.3 0 deposit off", 0, 0, 0.5);
  check_grains("rebound walton 0.5 0.3 0 deposit off", 2, 0, 0.5);
  check_grains("surface sigma 5 rebound walton 0.5 0.3 0.1 deposit off", 2, 0, 0.7);
  check_grains("rebound walton 0.5 0.3 0 deposit off", 2, 100, 0.5); /* places are rounded more */
}

/* A run begins with other forces than those with which the last one has ended, as engines may have
 * them: a grain that rests at a wall that moves does not come into it. */
TEST(first_forces_may_be_others) {
  const double r = 0.1, dt = 2e-3, speed = 0.03;
  MeshShape *mesh = new MeshShape;
  const std::vector<ContactTriangle> triangles = box(1);
  GrainsAtWall s(ShapePtr(mesh), "rebound walton 0.5 0.3 0 deposit off", 1, r, dt,
                 triangles.size());
  set_triangles(*mesh, triangles);
  mesh->set_images(Box());
  s.engine.least = s.engine.most = 2 * r;
  s.grains.put(0, {0.1, 0.2, -1 + r}, {0, 0, speed});
  s.grains.f[2] = -0.2;
  const auto step = [&]() {
    Frame end;
    Twist twist;
    end.shift[2] = speed * dt * static_cast<double>(s.grains.now + 1);
    twist.linear[2] = speed;
    mesh->motion().advance(end, twist, dt);
    mesh->set_images(Box());
    s.grains.advance();
    const double over = s.grains.x[2] - (-1 + r + end.shift[2]);
    s.grains.finish();
    return over;
  };
  s.begin();
  for (int k = 0; k < 100; k++)
    step();
  assert_true(fabs(step()) < 1e-9 * r);
  s.grains.f[2] = -0.21;
  s.grains.total = s.grains.f;
  s.wall->begin_run(s.grains.spheres(), 1, Box());
  push_again(s.grains.walls, s.grains.spheres());
  for (int k = 0; k < 10; k++)
    assert_true(fabs(step()) < 1e-9 * r);
}

} // namespace
