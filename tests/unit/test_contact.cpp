/* Contacts of a sphere on a straight path, against brute force: the distance from a wall sampled
 * along the path, and the nearest of all triangles, one by one.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <stdlib.h>
#include <vector>

#include "contact/contact.h"
#include "contact/tree.h"
#include "contact/vector.h"
#include "dem/shapes/primitive.h"

#include "check.h"
#include "random.h"

using namespace asperity;

enum { SAMPLES = 2000, CASES = 1000 };

static void at(const ContactPath *path, double time, double x[3]) {
  aspi_add_scaled(path->x, time, path->v, x);
}

/* The distance of x from a triangle by a search over its barycentric coordinates, finer and finer:
 * independent of the code under test. */
static double brute_distance(const ContactTriangle *t, const double x[3]) {
  double best = INFINITY, mid_a = 0.5, mid_b = 0.5, width = 0.5;
  for (int level = 0; level < 40; level++, width *= 0.6) {
    double next_a = mid_a, next_b = mid_b;
    for (int i = -4; i <= 4; i++)
      for (int j = -4; j <= 4; j++) {
        double a = fmin(1, fmax(0, mid_a + width * i / 4)),
               b = fmin(1, fmax(0, mid_b + width * j / 4));
        if (a + b > 1) {
          const double sum = a + b;
          a /= sum;
          b /= sum;
        }
        double p[3], off[3];
        for (int d = 0; d < 3; d++)
          p[d] = (1 - a - b) * t->node[0][d] + a * t->node[1][d] + b * t->node[2][d];
        aspi_subtract(x, p, off);
        if (aspi_length(off) < best) {
          best = aspi_length(off);
          next_a = a;
          next_b = b;
        }
      }
    mid_a = next_a;
    mid_b = next_b;
  }
  return best;
}

enum { PLANE, CYLINDER, TRIANGLE, TWO_NODES, LINE }; /* the last: degenerate triangles */

struct Wall {
  int kind, axis; /* of a plane, or of a cylinder */
  double at, center[3], radius;
  ContactTriangle triangle;
};

static double gap_of(const Wall *w, const double x[3], double radius) {
  double arm[3];
  if (w->kind == PLANE)
    return fabs(x[w->axis] - w->at) - radius;
  if (w->kind != CYLINDER)
    return aspi_triangle_nearest(&w->triangle, x, arm) - radius;
  aspi_subtract(x, w->center, arm);
  arm[w->axis] = 0;
  return fabs(aspi_length(arm) - w->radius) - radius;
}

static bool find(const Wall *w, const ContactPath *path, double radius, double latest,
                 ContactTouch *touch) {
  const double still[3] = {0, 0, 0};
  Path way = {{}, {}, path->left, path->left, 0};
  Contact contact;
  if (w->kind >= TRIANGLE)
    return aspi_triangle_find(&w->triangle, path, radius, latest, touch);
  aspi_copy(path->x, way.x);
  aspi_copy(path->v, way.v);
  if (!(w->kind == PLANE ? PlaneShape(w->axis, w->at, still).find(way, radius, latest, contact)
                         : CylinderShape(w->axis, w->center, w->radius, 0, 0)
                               .find(way, radius, latest, contact)))
    return false;
  touch->time = contact.time;
  touch->overlapped = contact.overlapped;
  aspi_copy(contact.n, touch->n);
  at(path, contact.time, way.x);
  aspi_subtract(contact.x, way.x, way.x);
  touch->overlap = aspi_dot(way.x, contact.n);
  return true;
}

static void random_wall(int kind, Wall *w) {
  memset(w, 0, sizeof *w);
  w->kind = kind;
  w->axis = static_cast<int>(uniform(0, 2.999));
  w->at = uniform(-1, 1);
  random_vector(1, w->center);
  w->radius = uniform(0.5, 2);
  for (int k = 0; k < 3; k++)
    random_vector(1.5, w->triangle.node[k]);
  double(*node)[3] = w->triangle.node;
  if (kind == TWO_NODES)
    aspi_copy(node[0], node[2]);
  for (int d = 0; d < 3 && kind == LINE; d++)
    node[2][d] = 0.3 * node[0][d] + 0.7 * node[1][d];
}

/* From a place without an overlap: there is a contact where the sampled gap first falls below zero,
 * and none where it stays above. */
static void check_path(const Wall *w, const ContactPath *path, double radius) {
  double x[3];
  ContactTouch touch = ContactTouch();
  const bool found = find(w, path, radius, path->left, &touch);
  double first = INFINITY, least = INFINITY;
  for (int i = 0; i <= SAMPLES; i++) {
    const double time = path->left * i / SAMPLES;
    at(path, time, x);
    const double gap = gap_of(w, x, radius);
    least = fmin(least, gap);
    if (gap < 0 && time < first)
      first = time;
  }
  const double step = path->left / SAMPLES;
  if (!found) {
    assert_true(least > -1e-9);
    return;
  }
  at(path, touch.time, x);
  assert_true(fabs(gap_of(w, x, radius)) <= 2e-9 * radius);
  assert_true(touch.time >= 0 && touch.time <= path->left && touch.time <= first);
  assert_true(first == INFINITY || touch.time >= first - 1.001 * step || least > -1e-3);
  assert_true(aspi_dot(touch.n, path->v) < 0);
  assert_true(fabs(aspi_length(touch.n) - 1) < 1e-12);
  assert_true(touch.overlap == 0 && !touch.overlapped);
  /* The normal leads from the wall to the center. */
  double foot[3];
  aspi_add_scaled(x, -radius, touch.n, foot);
  assert_true(fabs(gap_of(w, foot, 0)) < 1e-7);
}

/* A degenerate triangle is its edges. */
TEST(test_paths) {
  for (int kind = PLANE; kind <= LINE; kind++)
    for (int i = 0; i < CASES;) {
      Wall w;
      ContactPath path;
      const double radius = uniform(0.02, 0.3);
      random_wall(kind, &w);
      random_vector(2, path.x);
      random_vector(3, path.v);
      path.left = uniform(0.1, 2);
      if (gap_of(&w, path.x, radius) < 1e-6)
        continue;
      check_path(&w, &path, radius);
      i++;
    }
}

/* Paths that graze an edge or a corner: the contact is missed or met, but never late. */
TEST(test_grazing) {
  for (int i = 0; i < CASES; i++) {
    Wall w;
    ContactPath path;
    double along[3], out[3], normal[3], edge[3];
    const double radius = uniform(0.05, 0.2);
    random_wall(TRIANGLE, &w);
    aspi_triangle_normal(&w.triangle, normal);
    aspi_subtract(w.triangle.node[1], w.triangle.node[0], edge);
    aspi_cross(edge, normal, out);
    aspi_scale(1 / aspi_length(out), out);
    aspi_cross(out, edge, along);
    aspi_scale(1 / aspi_length(along), along);
    /* A sphere whose center passes the edge's middle at a radius, within 1e-7 of it. */
    double center[3];
    for (int d = 0; d < 3; d++)
      center[d] = 0.5 * (w.triangle.node[0][d] + w.triangle.node[1][d]);
    aspi_add_scaled(center, radius * (1 + uniform(-1e-7, 1e-7)), out, center);
    aspi_copy(along, path.v);
    aspi_add_scaled(center, -1, along, path.x);
    path.left = 2;
    if (gap_of(&w, path.x, radius) > 1e-6)
      check_path(&w, &path, radius);
  }
}

TEST(test_nearest) {
  for (int i = 0; i < 300; i++) {
    Wall w;
    double x[3], nearest[3];
    random_wall(TRIANGLE + i % 3, &w);
    random_vector(2, x);
    const double distance = aspi_triangle_nearest(&w.triangle, x, nearest);
    assert_true(fabs(distance - brute_distance(&w.triangle, x)) < 1e-5);
    double off[3];
    aspi_subtract(x, nearest, off);
    assert_true(fabs(aspi_length(off) - distance) < 1e-12);
    assert_true(brute_distance(&w.triangle, nearest) < 1e-5);
  }
}

TEST(test_area) {
  const ContactTriangle right = {{{1, 2, 3}, {1, 4, 3}, {1, 2, 6}}};
  assert_true(fabs(aspi_triangle_area(&right) - 3) < 1e-15);
}

/* What overlaps already: an approach touches at once and is moved out; what leaves is let go. */
TEST(test_overlap) {
  for (int kind = PLANE; kind <= TRIANGLE; kind++)
    for (int i = 0; i < CASES;) {
      Wall w;
      ContactPath path;
      ContactTouch touch = ContactTouch();
      const double radius = 0.3;
      random_wall(kind, &w);
      random_vector(2, path.x);
      random_vector(3, path.v);
      path.left = 1e-6;
      const double gap = gap_of(&w, path.x, radius);
      if (gap > -1e-3 || gap < -0.29 || (kind == CYLINDER && w.radius < 0.7))
        continue;
      i++;
      double later[3];
      at(&path, path.left, later);
      const double rate = (gap_of(&w, later, radius) - gap) / path.left;
      if (fabs(rate) < 1e-3)
        continue;
      const bool found = find(&w, &path, radius, path.left, &touch);
      assert_int_equal(found, rate < 0);
      if (!found)
        continue;
      assert_true(touch.overlapped && touch.time == 0);
      aspi_add_scaled(path.x, touch.overlap, touch.n, later);
      assert_true(fabs(gap_of(&w, later, radius)) < 1e-5);
    }
}

/* A plane, or a triangle in it. */
static Wall flat_wall(int kind) {
  return Wall{kind, 2, 0, {}, 1, {{{-1, -1, 0}, {2, -1, 0}, {-1, 2, 0}}}};
}

/* A center on the wall goes back to the side that it comes from. */
TEST(test_centered) {
  for (int k = 0; k < 4; k++) {
    const double side = k % 2 ? 1 : -1;
    const Wall w = flat_wall(k < 2 ? PLANE : TRIANGLE);
    const ContactPath path = {{0, 0, 0}, {1, 0.5, 2 * side}, 1};
    ContactTouch touch = ContactTouch();
    assert_true(find(&w, &path, 0.1, 1, &touch));
    assert_true(touch.overlapped && touch.n[2] * side < 0);
  }
}

/* At rest, or along the wall, there is none; nor behind the latest time. */
TEST(test_none) {
  for (int k = 0; k < 2; k++) {
    const Wall w = flat_wall(k ? PLANE : TRIANGLE);
    const ContactPath down = {{0, 0, 1.1}, {k ? 5. : 0., 0, -1}, 3};
    ContactPath path = {{0, 0, 0.1}, {0, 0, 0}, 1};
    ContactTouch touch = ContactTouch();
    assert_false(find(&w, &path, 0.1, 1, &touch));
    path.v[0] = 5;
    assert_false(find(&w, &path, 0.1, 1, &touch));
    assert_false(find(&w, &down, 0.1, 0.99, &touch));
    assert_true(find(&w, &down, 0.1, 1.01, &touch));
  }
}

/* A sphere wider than its cylinder is put back on the axis at the end of its path. */
TEST(test_wide) {
  const Wall tube = {CYLINDER, 0, 0, {}, 1, {}};
  const ContactPath path = {{0, 0.5, 0.1}, {1, -1, 0}, 2};
  ContactTouch touch = ContactTouch();
  double x[3];
  assert_true(find(&tube, &path, 1.5, 2, &touch));
  at(&path, touch.time, x);
  aspi_add_scaled(x, touch.overlap, touch.n, x);
  assert_true(hypot(x[1], x[2]) < 1e-12);
}

/* A sphere that touches the inside and slides along it touches at time 0, also where rounding turns
 * it inward a little; one that turns inward more flies to the other side. */
TEST(test_sliding) {
  const Wall tube = {CYLINDER, 2, 0, {}, 5, {}};
  const double inward[] = {0, 5e-7, 1e-3};
  for (int k = 0; k < 3; k++) {
    const ContactPath path = {{4.5, 0, 0}, {-3 * inward[k], 3, 0.1}, 2};
    ContactTouch touch = ContactTouch();
    assert_true(find(&tube, &path, 0.5, 2, &touch));
    assert_true(k < 2 ? !(touch.time > 0) : fabs(touch.time - 3 * inward[k]) < 1e-8);
    assert_false(touch.overlapped);
  }
}

static ContactTree *make_tree(const std::vector<ContactTriangle> &triangles,
                              const std::vector<int> &id) {
  ContactTree *tree = aspi_tree_begin();
  assert_non_null(tree);
  for (size_t k = 0; k < id.size(); k++)
    assert_true(aspi_tree_add(tree, &triangles[k], id[k]));
  assert_true(aspi_tree_finish(tree));
  return tree;
}

/* How far the box of a triangle is from a point, along one axis. */
static double off_box(const ContactTriangle *t, const double x[3], int d) {
  const double a = t->node[0][d], b = t->node[1][d], c = t->node[2][d];
  return fmax(0, fmax(fmin(a, fmin(b, c)) - x[d], x[d] - fmax(a, fmax(b, c))));
}

/* It is clear until the predicted time, which is not much too early: the sphere is then
 * at the box and at the plane of a triangle. */
static void check_clear(const ContactTree *tree, int round) {
  ContactPath path = {{}, {}, 3};
  random_vector(6, path.x);
  random_vector(round % 3 ? 6 : 0.1, path.v);
  if (round % 5 == 0)
    path.v[round % 3] = 0;
  const double reach = uniform(0, 0.5), widen = round % 4 ? uniform(0, 0.2) : 0;
  const double time = aspi_tree_clear(tree, path.x, path.v, reach, widen, 0, path.left, NULL, 0);
  const double least = uniform(0, path.left);
  const double rough =
      aspi_tree_clear(tree, path.x, path.v, reach, widen, least, path.left, NULL, 0);
  assert_true(time >= 0 && time <= path.left);
  assert_true(time > least ? fabs(rough - time) <= 0 : rough >= time && rough <= least);
  double x[3], n[3], arm[3];
  for (int k = 0; k < 40 && time > 0; k++) {
    const double now = time * k / 40;
    at(&path, now, x);
    assert_true(aspi_tree_distance(tree, x, 10, NULL) > (reach + widen * now) * (1 - 1e-12));
  }
  if (!(time < path.left))
    return;
  const double now = time + 1e-9, wide = reach + widen * now;
  at(&path, now, x);
  bool there = false;
  for (size_t i = 0; i < aspi_tree_count(tree); i++) {
    const ContactTriangle *t = aspi_tree_triangle(tree, static_cast<int>(i));
    bool meets = true;
    for (int d = 0; d < 3; d++)
      meets = meets && off_box(t, x, d) <= wide;
    aspi_triangle_normal(t, n);
    aspi_subtract(x, t->node[0], arm);
    there = there || (meets && fabs(aspi_dot(n, arm)) <= wide);
  }
  assert_true(there);
}

/* What flies along a triangle that is aslant to the axes, or past one of its edges, is clear of it
 * for all of its way, though within its box. */
TEST(test_along) {
  const ContactTriangle triangle = {{{0, 0, 0}, {3, 1, 2}, {-1, 4, 3}}};
  ContactTree *tree = make_tree({triangle}, {0});
  double n[3], ab[3], bc[3], outward[3], x[3];
  aspi_triangle_normal(&triangle, n);
  aspi_subtract(triangle.node[1], triangle.node[0], ab);
  aspi_subtract(triangle.node[2], triangle.node[1], bc);
  aspi_cross(bc, n, outward);
  aspi_scale(1 / aspi_length(outward), outward);
  const double reach = 0.01, widen = 1e-3;
  for (int side = -1; side <= 1; side += 2) { /* 0.02 over its face */
    aspi_add_scaled(triangle.node[0], side * 0.02, n, x);
    assert_true(aspi_tree_clear(tree, x, ab, reach, widen, 0, 1, NULL, 0) >= 1);
    assert_true(aspi_tree_clear(tree, x, ab, 0.0195, widen, 0, 1, NULL, 0) < 1);
  }
  aspi_add_scaled(triangle.node[1], 0.02, outward, x);
  assert_true(aspi_tree_clear(tree, x, bc, reach, widen, 0, 1, NULL, 0) >= 1);
  assert_true(aspi_tree_clear(tree, x, bc, 0.0195, widen, 0, 1, NULL, 0) < 1);
  /* Aslant over an edge: as near to its plane and to the plane across the edge, but farther away.
   */
  aspi_add_scaled(x, 0.02, n, x);
  const double still[3] = {0, 0, 0};
  assert_true(aspi_tree_clear(tree, x, still, 0.028, 1e-4, 0, 1, NULL, 0) >= 1);
  assert_true(aspi_tree_clear(tree, x, still, 0.0283, 1e-4, 0, 1, NULL, 0) < 1);
  aspi_tree_free(tree);
}

TEST(test_tree) {
  for (int count = 0; count <= 3000; count = 3 * count + 1) {
    std::vector<ContactTriangle> triangles(static_cast<size_t>(count));
    std::vector<int> id(triangles.size());
    for (int i = 0; i < count; i++) {
      double center[3];
      random_vector(5, center);
      if (i % 5 == 4)
        aspi_copy(triangles[0].node[0], center); /* many in one place */
      for (int k = 0; k < 3; k++) {
        random_vector(0.3, triangles[i].node[k]);
        aspi_add_scaled(triangles[i].node[k], 1, center, triangles[i].node[k]);
      }
      id[i] = 7 * count - (count % 2 ? 3 : 1) * i; /* with gaps, and without */
    }
    ContactTree *tree = make_tree(triangles, id);
    assert_non_null(tree);
    void *block = malloc(aspi_tree_bytes(tree));
    assert_non_null(block);
    if (count % 2) { /* the same tree over a block */
      aspi_tree_pack(tree, block);
      aspi_tree_free(tree);
      tree = aspi_tree_over(block);
      assert_non_null(tree);
    }
    assert_int_equal(aspi_tree_count(tree), count);
    for (int i = 0; i < count; i++) {
      const int place = aspi_tree_place(tree, id[i]);
      assert_true(place >= 0 && aspi_tree_id(tree, place) == id[i]);
      assert_memory_equal(aspi_tree_triangle(tree, place), &triangles[i], sizeof triangles[i]);
    }
    assert_int_equal(aspi_tree_place(tree, 7 * count + 1), -1);
    assert_int_equal(aspi_tree_place(tree, 7 * count - 3 * count - 1), -1);
    assert_int_equal(aspi_tree_place(tree, -2147483647), -1);
    ContactList list = ContactList();
    for (int round = 0; round < 50; round++) {
      double x[3], lo[3], hi[3], middle[3], nearest[3], least = 2;
      const double reach = round % 3 ? uniform(0, 1.5) : INFINITY;
      random_vector(6, x);
      for (int d = 0; d < 3; d++) {
        lo[d] = x[d] - uniform(0, 1);
        hi[d] = x[d] + uniform(0, 1);
        middle[d] = 0.5 * (lo[d] + hi[d]);
      }
      list.count = 0;
      assert_true(aspi_tree_meet(tree, lo, hi, reach, &list));
      size_t in_reach = 0;
      for (int i = 0; i < count; i++) {
        bool meets = true;
        double square = 0; /* of the distance of its box from the middle */
        for (int d = 0; d < 3; d++) {
          const double off = off_box(&triangles[i], middle, d);
          meets = meets && off <= 0.5 * (hi[d] - lo[d]);
          square += off * off;
        }
        in_reach += meets && square <= reach * reach;
        least = fmin(least, aspi_triangle_nearest(&triangles[i], x, nearest));
      }
      assert_int_equal(list.count, in_reach);
      int place;
      const double distance = aspi_tree_distance(tree, x, 2, &place);
      assert_true(fabs(distance - least) < 1e-12);
      assert_int_equal(place >= 0, least < 2);
      check_clear(tree, round);
    }
    aspi_places_free(&list);
    aspi_tree_free(tree);
    free(block);
  }
}

/* Points on the edges and at the nodes of a plane of squares, to rounding, are over one of its
 * triangles: what rests there does not fall between them. */
TEST(test_edges) {
  for (int i = 0; i < 20000; i++) {
    double corner[3], sides[2][3], x[3], n[3], height;
    random_vector(1, corner);
    random_vector(0.3, sides[0]);
    random_vector(0.3, sides[1]);
    aspi_add_scaled(corner, i % 2 ? uniform(-1, 1) : 0, sides[0], x);
    bool any = false;
    for (int k = 0; k < 8; k++) { /* two of each square around the corner */
      ContactTriangle t;
      double *one = t.node[(i + 1) % 3], *both = t.node[(i + 2) % 3];
      aspi_copy(corner, t.node[i % 3]);
      aspi_add_scaled(corner, k & 1 ? 1 : -1, sides[k >> 2], one);
      aspi_add_scaled(one, k & 2 ? 1 : -1, sides[!(k >> 2)], both);
      any = any || aspi_triangle_is_under(&t, x, n, &height);
    }
    assert_true(any);
  }
}
