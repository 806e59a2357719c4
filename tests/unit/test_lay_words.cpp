/* The lay as a script states it, and as shapes that move and turn take it along.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>
#include <string>

#include "wall/error.h"
#include "wall/lay.h"
#include "wall/mesh.h"
#include "wall/primitive.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
extern "C" { /* behind the others: it has a macro `fail`, which is a name of theirs */
#include <cmocka.h>
}

using namespace asperity;

namespace {

Lay read(int count, const char *const *words) {
  Words w(count, words);
  return Lay::read(w);
}

void assert_direction(const double is[3], double x, double y, double z) {
  assert_true(fabs(is[0] - x) < 1e-12 && fabs(is[1] - y) < 1e-12 && fabs(is[2] - z) < 1e-12);
}

void words_are_read(void **) {
  const char *const vector[] = {"3", "0", "4", "seed"}, *const axial[] = {"axial"},
                    *const around[] = {"circumferential"}, *const angle[] = {"30", "spread"};
  Lay lay = read(4, vector);
  assert_int_equal(lay.kind, Lay::VECTOR);
  assert_direction(lay.vector, 0.6, 0, 0.8);
  assert_int_equal(read(1, axial).kind, Lay::ANGLE);
  assert_true(fabs(read(1, axial).angle) < 1e-15);
  assert_true(fabs(read(1, around).angle - M_PI / 2) < 1e-15);
  assert_true(fabs(read(2, angle).angle - M_PI / 6) < 1e-15);
}

void bad_words_are_named(void **) {
  const char *const bad[][3] = {
      {"0", "0", "0"}, {"1", "2", "up"}, {"diagonal", "", ""}, {"500", "", ""}};
  const char *const says[] = {"> 0", "third number of the lay", "lay is 'diagonal'", "lay is 500"};
  for (int i = 0; i < 4; i++) {
    std::string said;
    try {
      read(bad[i][1][0] ? 3 : 1, bad[i]);
    } catch (const Error &wrong) {
      said = wrong.what();
    }
    assert_true(said.find(says[i]) != std::string::npos);
  }
}

/* A mesh that has turned by a quarter about z by the end of the step has turned its lay by an
 * eighth in the middle of it; at rest there, the whole quarter stays. */
void meshes_turn_their_lay(void **) {
  const char *const words[] = {"1", "0", "0"};
  const Lay lay = read(3, words);
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
void cylinders_have_helices(void **) {
  const char *const wall[] = {"zcylinder", "1", "0", "0"}, *const axial[] = {"axial"},
                    *const around[] = {"circumferential"}, *const angle[] = {"30"};
  Words w(4, wall);
  std::string geometry;
  const std::unique_ptr<Shape> shape = read_primitive(w, geometry);
  assert_int_equal(shape->lay_kind(), Lay::ANGLE);
  Path path = Path();
  Contact contact = Contact();
  contact.n[0] = 1;
  double direction[3];
  shape->lay(read(1, axial), path, contact, direction);
  assert_direction(direction, 0, 0, 1);
  shape->lay(read(1, around), path, contact, direction);
  assert_direction(direction, 0, -1, 0);
  shape->lay(read(1, angle), path, contact, direction);
  assert_direction(direction, 0, -0.5, sqrt(0.75));
}

} // namespace

int main() {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(words_are_read),
      cmocka_unit_test(bad_words_are_named),
      cmocka_unit_test(meshes_turn_their_lay),
      cmocka_unit_test(cylinders_have_helices),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
