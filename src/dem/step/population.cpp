/* Which movers of this rank are at a wall; see wall.h. What sticks is in stick.cpp.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <algorithm>

#include "dem/wall.h"

using namespace asperity;

void Population::list(const Spheres &s, int groupbit) {
  stuck.clear();
  resting.clear();
  rebounded.clear();
  any_left = false;
  for (int i = 0; i < s.n; i++)
    if (!(s.mask[i] & groupbit) || !rows.has_list(i))
      rows.forget(i);
    else if (rows.is_stuck(i))
      stuck.push_back(StuckOne{i, false, false, false, {}, {}, 0, {}});
    else if (rows.status(i) == Status::RESTING)
      resting.push_back(i);
    else if (rows.status(i) == Status::REBOUNDED)
      rebounded.push_back(i);
  ahead.reorder(s);
}

void Population::begin_step() {
  for (int i : rebounded)
    if (rows.status(i) == Status::REBOUNDED)
      rows.set_status(i, Status::FREE);
  rebounded.clear();
  if (!any_left)
    return;
  const auto left = [this](int i) { return rows.status(i) != Status::RESTING; };
  resting.erase(std::remove_if(resting.begin(), resting.end(), left), resting.end());
  any_left = false;
}

void Population::begin_run(const Setup &setup, const Spheres &s) {
  ahead.begin_run();
  for (int i = 0; i < s.n; i++)
    if (rows.is_stuck(i) && setup.model.deposit() == Model::OFF)
      rows.set_status(i, Status::FREE); /* an earlier part of the run had deposits */
}
