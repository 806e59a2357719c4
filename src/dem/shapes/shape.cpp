/* Default functions of a shape; see shape.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/shapes/shape.h"

#include <algorithm>

#include "contact/tolerances.h"
#include "contact/vector.h"

using namespace asperity;

void Shape::stick(const Path &, const Contact &contact, Place &place) const {
  place.piece = contact.piece;
  aspi_copy(contact.x, place.at);
}

void Shape::turn(const Place &, double, double, double[3][3], double omega[3]) const {
  std::fill(omega, omega + 3, 0.0);
}

bool Shape::are_parallel(const double a[3], const double b[3]) {
  double across[3];
  aspi_cross(a, b, across);
  return aspi_length(across) <= GRAZING * aspi_length(a) * aspi_length(b);
}
