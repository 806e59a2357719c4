/* Which movers of this rank are at a wall; see stepper.h. What sticks is in stick.cpp.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/stepper.h"

#include <algorithm>

#include "contact/vector.h"

using namespace asperity;

Stepper::Stepper(const Setup &of, Books &its)
    : setup(of), books(its), rows(), grains(of, rows, false), bodies(of, body_rows, true),
      begins(false), is_rough(false), has_valleys(false), has_lay(false), is_still(false),
      has_to_delete(false), is_cut(false), is_passed(false), dt_ahead(0) {
  books.set_rows(&rows);
}

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

void Stepper::begin_run(const Spheres &s, const std::vector<int> &shape_now) {
  for (int i = 0; i < s.n && !shape_now.empty(); i++)
    if (Memory *of = rows.find(i)) {
      renumber(shape_now, rows.state[i], *of);
      for (Stuck &at : of->stuck)
        if (!(at.shape >= 1)) /* it stays where it is before the engine moves it */
          aspi_copy(s.x + 3 * static_cast<size_t>(i), at.at);
    }
  is_rough = setup.model.wall() && asp_wall_surface(setup.model.wall());
  has_valleys = is_rough && setup.interlocks && setup.model.dissipates();
  has_lay = setup.model.lay().kind != ASP_LAY_NONE || setup.engine.dimension() == 2;
  begins = true;
  grains.begin_run(setup, s);
  reorder(s);
}

void Stepper::reorder(const Spheres &s) {
  has_to_delete = false;
  grains.list(s, setup.groupbit);
  for (const StuckOne &one : grains.stuck) {
    Stuck &at = rows.stuck(one.i);
    Load &load = rows.own(one.i).load;
    if (at.is_kept > 0 && books.is_in_step() && !(load.waits > 0)) {
      load.waits = 1;
      aspi_copy(rows.state[one.i].force, load.force);
      aspi_scale(0.5, load.force); /* a half is over */
      aspi_copy(rows.state[one.i].point, load.point);
    }
    at.is_kept = 0;
  }
}

void Stepper::renumber(const std::vector<int> &shape_now, MoverState &state, Memory &memory) {
  const auto now = [&](double saved) {
    return saved >= 1 && saved <= static_cast<double>(shape_now.size())
               ? shape_now[static_cast<size_t>(saved) - 1]
               : 0;
  };
  for (Stuck &at : memory.stuck)
    at.shape = now(at.shape);
  for (Rest &rest : memory.rests)
    rest.shape = now(rest.shape);
  memory.rests.erase(std::remove_if(memory.rests.begin(), memory.rests.end(),
                                    [](const Rest &rest) { return !(rest.shape >= 1); }),
                     memory.rests.end());
  if (memory.rests.empty() && state.status < 0)
    state.status = static_cast<double>(Status::FREE);
}
