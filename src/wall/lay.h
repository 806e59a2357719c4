/* The lay of a wall as a script states it: a vector that is fixed to the wall, or, on a cylinder,
 * an angle from its axis.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_WALL_LAY_H
#define ASPERITY_WALL_LAY_H

#include <string>

#include "wall/words.h"

namespace asperity {

struct Lay {
  enum Kind { NONE, VECTOR, ANGLE };
  Kind kind;
  double vector[3]; /* projected on the wall at each contact */
  double angle;     /* rad, from the axis about the outward normal; pi/2: around the axis */
  std::string text; /* as the script has it */

  Lay();

  /* Reads X Y Z, `axial`, `circumferential`, or an angle in degrees. Throws an Error. */
  static Lay read(Words &words);
};

} // namespace asperity

#endif
