/* The lay of a description, and as shapes that move and turn take it along.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <memory>
#include <string>

#include "dem/shapes/mesh.h"
#include "dem/shapes/primitive.h"

#include "check.h"

using namespace asperity;

namespace {

asp_lay read(const std::string &words) {
  const std::string text = "surface rq 1 lambda_c 10 20 lay " + words;
  std::unique_ptr<asp_description, void (*)(asp_description *)> description(
      asp_description_parse(text.c_str(), NULL, NULL), asp_description_free);
  assert_true(description != NULL);
  return asp_description_lay(description.get());
}

void assert_direction(const double is[3], double x, double y, double z) {
  assert_true(fabs(is[0] - x) < 1e-12 && fabs(is[1] - y) < 1e-12 && fabs(is[2] - z) < 1e-12);
}

TEST(words_are_read) {
  const asp_lay lay = read("3 0 4");
  assert_int_equal(lay.kind, ASP_LAY_VECTOR);
  assert_direction(lay.vector, 0.6, 0, 0.8);
  assert_int_equal(read("axial").kind, ASP_LAY_ANGLE);
  assert_true(fabs(read("axial").angle) < 1e-15);
  assert_true(fabs(read("circumferential").angle - M_PI / 2) < 1e-15);
  assert_true(fabs(read("30").angle - M_PI / 6) < 1e-15);
}

/* A mesh that has turned by a quarter about z by the end of the step has turned its lay by an
 * eighth in the middle of it; at rest there, the whole quarter stays. */
TEST(meshes_turn_their_lay) {
  const asp_lay lay = read("1 0 0");
  MeshShape mesh;
  Path path = Path();
  Contact contact = Contact();
  double direction[3];
  path.left = path.dt = 2;
  contact.time = 1;
  mesh.lay(lay, path, contact, direction);
  assert_direction(direction, 1, 0, 0);
  Frame quarter;
  quarter.turn[0][0] = quarter.turn[1][1] = 0;
  quarter.turn[0][1] = -1;
  quarter.turn[1][0] = 1;
  mesh.motion().advance(quarter, Twist(), path.dt);
  mesh.lay(lay, path, contact, direction);
  assert_direction(direction, M_SQRT1_2, M_SQRT1_2, 0);
  mesh.motion().rest();
  mesh.lay(lay, path, contact, direction);
  assert_direction(direction, 0, 1, 0);
}

/* Around a cylinder: along the axis, around it, and between. */
TEST(cylinders_have_helices) {
  const char *const wall[] = {"zcylinder", "1", "0", "0"};
  Words w(4, wall);
  std::string geometry;
  const std::unique_ptr<Shape> shape = read_primitive(w, geometry);
  assert_int_equal(shape->lay_kind(), ASP_LAY_ANGLE);
  Path path = Path();
  Contact contact = Contact();
  contact.n[0] = 1;
  double direction[3];
  shape->lay(read("axial"), path, contact, direction);
  assert_direction(direction, 0, 0, 1);
  shape->lay(read("circumferential"), path, contact, direction);
  assert_direction(direction, 0, -1, 0);
  shape->lay(read("30"), path, contact, direction);
  assert_direction(direction, 0, -0.5, sqrt(0.75));
}

} // namespace
