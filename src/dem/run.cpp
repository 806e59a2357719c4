/* The walls of a run; see run.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/run.h"

#include "dem/text.h"

using namespace asperity;

WallRun::WallRun(const Engine &engine)
    : wall(engine), has_begun_(false), has_steps_(false), is_checked_(false) {}

std::vector<Wall *> WallRun::all_walls() const {
  std::vector<Wall *> all;
  for (WallRun *each : walls)
    all.push_back(&each->wall);
  return all;
}

Spheres WallRun::spheres() const {
  Spheres s = all_spheres();
  const std::vector<int> &masks = walls.front()->masks_;
  if (!masks.empty())
    s.mask = masks.data();
  return s;
}

Bodies *WallRun::take_bodies() {
  return bodies().any() ? bodies().take(all_walls()) : NULL;
}

/* ---- a run ---- */

void WallRun::list_bodies(bool begins) {
  if (!leads())
    return;
  masks_.clear();
  if (!bodies().any())
    return;
  const Spheres s = all_spheres();
  bodies().list(all_walls(), begins);
  body_rows_.reset(s, walls.size());
  for (int i = 0; i < s.n; i++)
    masks_.push_back(bodies().has(i) ? 0 : s.mask[i]);
}

void WallRun::begin(bool is_setup) {
  list_bodies(is_setup);
  attempt([this, is_setup] {
    const Spheres all = spheres();
    wall.begin_run(all, group_bit(), box());
    wall.free_displaced(all, is_setup ? 0 : all.dt);
  });
  has_begun_ = true;
  has_steps_ = false;
}

void WallRun::push_spheres() {
  if (walls.back() != this)
    return;
  push_again(all_walls(), spheres());
}

void WallRun::push_bodies() {
  if (walls.back() != this)
    return;
  WallRun &first = *walls.front();
  if (Bodies *all = first.take_bodies()) {
    for (Wall *each : all_walls()) /* all walls are where this run finds them */
      each->free_displaced(*all, 0);
    push_again(all_walls(), *all);
    first.bodies().put(true, wall.setup.engine.world());
  }
}

void WallRun::step() {
  if (!leads())
    return;
  for (WallRun *each : walls)
    if (!each->has_begun_)
      each->begin(false);
  try {
    const bool grow = particles_grow();
    const Spheres now = spheres();
    for (WallRun *each : walls) {
      each->has_steps_ = true;
      each->wall.set_dt(now.step - 1, now.dt);
      if (grow)
        each->wall.clear_ahead();
      each->begin_step();
      each->wall.setup.find_temperatures();
      if (!each->is_checked_)
        each->check_use();
      each->is_checked_ = true;
    }
    Bodies *all = take_bodies();
    if (all && all->begins) /* the run */
      warn_of_lost(*all);
    step_walls(all_walls(), now, all);
  } catch (const std::exception &wrong) {
    fail_alone(message_of(wrong));
  }
  if (bodies().any())
    bodies().put(false, wall.setup.engine.world());
  for (WallRun *each : walls) {
    int mine = each->wall.has_to_delete, any; /* all ranks must agree */
    if (!each->deletes())
      continue;
    MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, wall.setup.engine.world());
    if (any)
      each->renew_lists();
  }
}

void WallRun::hold() {
  if (!has_steps_)
    fail("rerun is not supported: a rebound is an event in time; use run");
  if (!leads())
    return;
  Bodies *all = NULL;
  try {
    Spheres s = spheres();
    all = take_bodies();
    s.dt = wall.setup.dt; /* another fix may have changed that of the next step */
    if (all)
      all->dt = s.dt;
    end_walls(all_walls(), s, all);
  } catch (const std::exception &wrong) {
    fail_alone(message_of(wrong));
  }
  if (all) {
    bodies().put(true, wall.setup.engine.world());
    body_rows_.show(all_walls(), *all, wall.setup.engine.world());
  }
  for (WallRun *each : walls)
    each->wall.books.end_loads();
}

void WallRun::end() {
  has_begun_ = false;
  attempt([this] { wall.end_run(); });
}

void WallRun::list_deleted() {
  BodySource &of = walls.front()->bodies();
  if (of.any())
    of.list_deleted(wall.body_rows, wall.setup.engine.world());
}

bool WallRun::is_deleted(int i) {
  const BodySource &of = walls.front()->bodies();
  return wall.rows.status(i) == Status::TO_DELETE || (of.any() && of.is_deleted(i));
}

/* ---- restart, and what is lost ---- */

void WallRun::write_record(FILE *file) {
  std::vector<char> record;
  attempt([&] { record = wall.save(); });
  if (wall.setup.engine.rank() != 0)
    return;
  const int size = static_cast<int>(record.size());
  fwrite(&size, sizeof size, 1, file);
  fwrite(record.data(), 1, record.size(), file);
}

void WallRun::restore(const char *record) {
  attempt([this, record] { wall.restore(record); });
}

void WallRun::warn_of_no_restart() const {
  wall.setup.engine.warn("the restart file has no data of this wall; its impact numbers begin at "
                         "1, and no particle is stuck to it");
}

void WallRun::warn_of_lost(const Bodies &all) {
  const size_t saved = wall.body_rows.take_restored();
  long long mine = static_cast<long long>(all.all.size()), now;
  MPI_Allreduce(&mine, &now, 1, MPI_LONG_LONG, MPI_SUM, wall.setup.engine.world());
  if (now < static_cast<long long>(saved))
    wall.setup.engine.warn(text("the restart file has %zu bodies, and %lld are left; the engine "
                                "lost the others when it read the file",
                                saved, now));
}

void WallRun::report_loss() const {
  const double stuck = wall.stuck(), impacts = wall.books.counter(Books::N_IMPACTS);
  const std::string counts = text("its counts, of %.0f impacts, end with it", impacts);
  if (stuck > 0)
    wall.setup.engine.warn(text("%.0f particles that are stuck to this wall are free from here on, "
                                "also at a wall that takes its place; ",
                                stuck) +
                           counts);
  else if (impacts > 0)
    wall.setup.engine.print("fix " + wall.setup.engine.id() +
                            " wall/rebound: the wall is taken away; " + counts);
}
