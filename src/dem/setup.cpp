/* A wall as it is set up; see setup.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/setup.h"

#include <algorithm>

#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

Setup::Setup(const Engine &of)
    : engine(of), model(of), key(asp_key_wall(of.id().c_str())),
      stay_key(asp_key_wall((of.id() + " stays").c_str())), interlocks(true), groupbit(1), box(),
      clock(), dt(0) {}

/* One formula for the time of a step, whether or not the run was interrupted before it. */
void Setup::set_clock(int64_t step, double now_dt) {
  const double now = static_cast<double>(step);
  dt = now_dt;
  if (!(clock.dt > 0))
    clock = Clock{engine.time(), now, dt};
  else if (clock.dt < dt || clock.dt > dt)
    clock = Clock{time(now), now, dt};
}

void Setup::check_lay() const {
  const asp_lay_kind kind = model.lay().kind;
  for (const Member &member : shapes)
    if (kind != ASP_LAY_NONE && kind != member.shape->lay_kind())
      throw Error(std::string("lay is ") + (kind == ASP_LAY_ANGLE ? "an angle" : "a vector") +
                  "; of a " +
                  (member.shape->lay_kind() == ASP_LAY_ANGLE
                       ? "cylinder it must be axial, circumferential, or an angle in degrees from "
                         "its axis"
                       : "plane or a mesh it must be a vector, X Y Z"));
}

void Setup::check_box() const {
  for (const Member &member : shapes)
    for (int d = 0; d < 3; d++)
      if (box.period[d] > 0 && member.shape->bars(d))
        throw Error(text("the wall '%s' stands across %c, along which the box is periodic: a "
                         "particle that leaves the box would come back on the other side of the "
                         "wall; the boundary along %c must not be p, or the wall must be a mesh, "
                         "which repeats with the box",
                         geometry.c_str(), "xyz"[d], "xyz"[d]));
}

bool Setup::repeats() const {
  bool all = true;
  for (const Member &member : shapes)
    for (int d = 0; d < 3; d++)
      all = all && (!(box.period[d] > 0) || member.shape->repeats(d));
  return all;
}

std::vector<int> Setup::wall_types() const {
  std::vector<int> types;
  for (const Member &member : shapes)
    if (std::find(types.begin(), types.end(), member.wall_type) == types.end())
      types.push_back(member.wall_type);
  return types;
}
