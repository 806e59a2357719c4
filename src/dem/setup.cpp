/* A wall as it is set up; see setup.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/setup.h"

#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

Setup::Setup(const Engine &of)
    : engine(of), model(of), key(asp_key_wall(of.id().c_str())),
      stay_key(asp_key_wall((of.id() + " stays").c_str())), interlocks(true), temperatures(NULL),
      groupbit(1), box(), clock(), dt(0) {}

/* One formula for the time of a step, whether or not the run was interrupted before it. */
void Setup::set_clock(int64_t step, double now_dt) {
  const double now = static_cast<double>(step);
  if (!(now_dt >= 0))
    throw Error(text("the time step is %g; it must be >= 0", now_dt));
  dt = now_dt;
  if (!(clock.dt > 0))
    clock = Clock{engine.time(), now, dt};
  else if (clock.dt < dt || clock.dt > dt)
    clock = Clock{time(now), now, dt};
}

void Setup::check_bodies() const {
  if (!temperature_of.empty())
    throw Error("'temperature_of' is of single particles, and the script has bodies; with bodies "
                "it must be 'temperature T', behind 'rebound LAW'");
  model.check_bodies();
}

bool Setup::repeats() const {
  bool all = true;
  for (const Member &member : shapes)
    for (int d = 0; d < 3; d++)
      all = all && (!(box.period[d] > 0) || member.shape->repeats(d));
  return all;
}
