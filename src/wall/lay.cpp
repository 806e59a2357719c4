/* The lay of a wall; see lay.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/lay.h"

#include <math.h>

#include "asperity.h"
#include "contact/vector.h"
#include "wall/error.h"
#include "wall/record.h"
#include "wall/text.h"

using namespace asperity;

Lay::Lay() : kind(NONE), vector{0, 0, 0}, angle(0) {}

Lay Lay::read(Words &words) {
  Lay lay;
  lay.kind = ANGLE;
  if (words.take("axial")) {
    lay.text = "axial";
    return lay;
  }
  if (words.take("circumferential")) {
    lay.angle = 0.5 * ASP_PI;
    lay.text = "circumferential";
    return lay;
  }
  const double first = words.number("lay");
  if (!words.is_number()) {
    if (!(fabs(first) <= 180))
      throw Error(asperity::text(
          "lay is %g; an angle from a cylinder's axis must be -180 to 180 degrees", first));
    lay.angle = first * (ASP_PI / 180);
    lay.text = setting(first);
    return lay;
  }
  lay.kind = VECTOR;
  lay.vector[0] = first;
  lay.vector[1] = words.number("the second number of the lay's vector");
  lay.vector[2] = words.number("the third number of the lay's vector");
  const double length = vector_length(lay.vector);
  if (!(length > 0) || !(length < HUGE_VAL))
    throw Error(asperity::text("lay is %g %g %g; it must be a vector of a finite length > 0",
                               lay.vector[0], lay.vector[1], lay.vector[2]));
  for (int d = 0; d < 3; d++)
    lay.text += (d ? " " : "") + setting(lay.vector[d]);
  vector_scale(1 / length, lay.vector);
  return lay;
}
