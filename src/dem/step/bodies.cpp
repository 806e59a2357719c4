/* Rigid bodies as engines give them, and their free motion; see bodies.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/step/bodies.h"

#include <math.h>
#include <string.h>
#include <algorithm>

#include "contact/vector.h"
#include "dem/step/mover.h"

using namespace asperity;

Spheres Bodies::bounds() {
  x_.clear();
  v_.clear();
  mask_.clear();
  tag_.clear();
  reach_.clear();
  for (const Body &body : all) {
    x_.insert(x_.end(), body.x, body.x + 3);
    v_.insert(v_.end(), body.v, body.v + 3);
    mask_.push_back(body.mask);
    tag_.push_back(body.tag);
    reach_.push_back(body.reach);
  }
  Spheres s = Spheres();
  s.step = step;
  s.dt = dt;
  s.n = static_cast<int>(all.size());
  s.mask = mask_.data();
  s.tag = tag_.data();
  s.tag_bytes = 8;
  s.x = x_.data();
  s.v = v_.data();
  s.radius = reach_.data();
  return s;
}

/* Bodies are as the engine has them: it may have chosen other axes, and a body that is stuck to a
 * shape that is gone stays where it is. */
static void begin_run(Wall &wall, Bodies &bodies) {
  wall.bodies.begin_run(wall.setup, bodies.bounds());
  for (size_t b = 0; b < bodies.all.size(); b++) {
    const Mover mover(bodies, static_cast<int>(b));
    const Body &body = bodies.all[b];
    if (!wall.body_rows.is_stuck(mover.i))
      continue;
    Stuck &at = wall.body_rows.stuck(mover.i);
    memcpy(at.axes, body.axes, sizeof at.axes);
    if (!(at.shape >= 1)) {
      mover.arm(mover.anchor(at), at.at);
      aspi_add_scaled(at.at, 1, body.x, at.at);
    }
  }
}

void asperity::claim_bodies(const std::vector<Wall *> &walls, Bodies &bodies, MPI_Comm world) {
  std::vector<int64_t> tags;
  for (Body &body : bodies.all) {
    body.reach = body.mask = 0;
    for (size_t k = body.first; k < body.first + body.count; k++) {
      const BodySphere &one = bodies.spheres[k];
      body.reach = std::max(body.reach, aspi_length(one.arm) + one.radius);
      body.mask |= one.mask;
    }
    tags.push_back(body.tag);
  }
  for (Wall *wall : walls) {
    wall->body_rows.claim(tags, world);
    if (bodies.begins)
      begin_run(*wall, bodies);
    wall->bodies.list(bodies.bounds(), wall->setup.groupbit);
  }
}

/* ---- free motion ---- */

void asperity::turn_by(const double omega[3], double time, double axes[3][3]) {
  const double rate = aspi_length(omega);
  if (!(rate > 0))
    return;
  const double c = cos(rate * time), s = sin(rate * time) / rate;
  for (int k = 0; k < 3; k++) {
    double side[3], along = (1 - c) * aspi_dot(omega, axes[k]) / (rate * rate);
    aspi_cross(omega, axes[k], side);
    for (int d = 0; d < 3; d++)
      axes[k][d] = axes[k][d] * c + side[d] * s + omega[d] * along;
  }
}

/* A body of three different moments turns in parts of this angle at most, rad; the less they
 * differ, the larger are the parts. */
static const double PART = 0.05;

/* Turns a body about its axis k by an angle per component of the momentum. */
static void turn_about_own(int k, double angle, const double momentum[3], double axes[3][3]) {
  double *a = axes[(k + 1) % 3], *b = axes[(k + 2) % 3];
  const double by = angle * aspi_dot(momentum, axes[k]), c = cos(by), s = sin(by);
  for (int d = 0; d < 3; d++) {
    const double before = a[d];
    a[d] = c * before + s * b[d];
    b[d] = c * b[d] - s * before;
  }
}

/* A body of which two moments are equal spins about the axis of the third, and that goes round the
 * momentum. What another moment adds to it is taken in turns (fourth order: Suzuki 1990); turns
 * about the momentum leave its components alone, so that all of them are one. */
void asperity::turn_free(const double inertia[3], const double momentum[3], double time,
                         double axes[3][3]) {
  double rate[3], least = HUGE_VAL;
  int own = 0;
  for (int k = 0; k < 3; k++)
    rate[k] = inertia[k] > 0 ? 1 / inertia[k] : 0;
  for (int k = 0; k < 3; k++)
    if (fabs(rate[(k + 1) % 3] - rate[(k + 2) % 3]) < least) {
      least = fabs(rate[(k + 1) % 3] - rate[(k + 2) % 3]);
      own = k;
    }
  const int other = (own + 2) % 3;
  const double across = rate[(own + 1) % 3], spin = rate[own] - across,
               apart = rate[other] - across;
  const double l = aspi_length(momentum), l_own = aspi_dot(momentum, axes[own]);
  const double wobble = fabs(apart * time) * l;
  if (!(wobble > SUM_ROUNDING))
    turn_about_own(own, spin * time, momentum, axes);
  else {
    const double fifth = 1 / (4 - cbrt(4.0)); /* the energy limits the component along `own` */
    const double angle =
        wobble + fabs(time) * sqrt(fabs(spin) * (fabs(spin) * l_own * l_own + least * l * l));
    const int parts = 1 + static_cast<int>(angle / PART * sqrt(sqrt(wobble / angle)));
    for (int n = 0; n < 5 * parts; n++) {
      const double way = (n % 5 == 2 ? 1 - 4 * fifth : fifth) * time / parts;
      turn_about_own(other, 0.5 * apart * way, momentum, axes);
      turn_about_own(own, spin * way, momentum, axes);
      turn_about_own(other, 0.5 * apart * way, momentum, axes);
    }
  }
  turn_by(momentum, across * time, axes);
}

void asperity::advance(Body &body, double time) {
  turn_free(body.inertia, body.angular_momentum, time, body.axes);
  aspi_add_scaled(body.x, time, body.v, body.x);
}

void asperity::spin_of(const Body &body, double omega[3]) {
  for (int d = 0; d < 3; d++)
    omega[d] = 0;
  for (int k = 0; k < 3; k++)
    if (body.inertia[k] > 0)
      aspi_add_scaled(omega, aspi_dot(body.angular_momentum, body.axes[k]) / body.inertia[k],
                      body.axes[k], omega);
}

void asperity::momentum_of(const Body &body, const double omega[3], double momentum[3]) {
  for (int d = 0; d < 3; d++)
    momentum[d] = 0;
  for (int k = 0; k < 3; k++)
    aspi_add_scaled(momentum, body.inertia[k] * aspi_dot(omega, body.axes[k]), body.axes[k],
                    momentum);
}

/* ---- to and from an engine ---- */

void BodySource::set_spheres(std::vector<Found> &found) {
  std::sort(found.begin(), found.end(), [](const Found &a, const Found &b) {
    return a.first != b.first ? a.first < b.first : a.second.tag < b.second.tag;
  });
  bodies_.spheres.clear();
  for (Body &body : bodies_.all)
    body.count = 0;
  for (const Found &one : found) {
    Body &body = bodies_.all[one.first];
    if (body.count > 0 && bodies_.spheres.back().tag == one.second.tag)
      continue;
    if (body.count++ == 0)
      body.first = bodies_.spheres.size();
    bodies_.spheres.push_back(one.second);
  }
}

void BodySource::put(bool is_end, MPI_Comm world) {
  int mine = 0, any_changed;
  for (size_t b = 0; b < bodies_.all.size(); b++)
    if (bodies_.all[b].is_changed) {
      write(b, is_end);
      mine = 1;
    }
  MPI_Allreduce(&mine, &any_changed, 1, MPI_INT, MPI_MAX, world);
  if (any_changed)
    set_particles(is_end);
}

void BodySource::list_deleted(const Memories &rows, MPI_Comm world) {
  std::vector<double> mine;
  for (size_t b = 0; b < rows.memory.size(); b++)
    if (rows.status(static_cast<int>(b)) == Status::TO_DELETE)
      mine.push_back(name_of(b));
  deleted_ = gather_for_all(mine, world);
  std::sort(deleted_.begin(), deleted_.end());
}

bool BodySource::is_deleted(int i) const {
  return std::binary_search(deleted_.begin(), deleted_.end(), name_at(i));
}

void BodyRows::reset(const Spheres &spheres, size_t walls) {
  place_.clear();
  for (int i = 0; i < spheres.n; i++)
    place_[spheres.tag_of(i)] = i;
  shown_.assign(walls, std::vector<MoverState>());
}

void BodyRows::show(const std::vector<Wall *> &walls, const Bodies &bodies, MPI_Comm world) {
  std::vector<double> mine; /* number of the wall, tag of a sphere, impacts, state */
  for (size_t w = 0; w < walls.size(); w++) {
    std::vector<MoverState> &shown = shown_[w];
    shown.resize(bodies.all.size());
    for (size_t b = 0; b < bodies.all.size(); b++) {
      const MoverState &now = walls[w]->body_rows.state[b];
      if (memcmp(&now, &shown[b], 2 * sizeof(double)) == 0)
        continue;
      shown[b] = now;
      const BodySphere *first = &bodies.spheres[bodies.all[b].first];
      for (const BodySphere *one = first; one < first + bodies.all[b].count; one++)
        mine.insert(mine.end(), {static_cast<double>(w), static_cast<double>(one->tag), now.impacts,
                                 now.status});
    }
  }
  int changed = !mine.empty(), any;
  MPI_Allreduce(&changed, &any, 1, MPI_INT, MPI_MAX, world);
  if (!any)
    return;
  const std::vector<double> all = gather_for_all(mine, world);
  for (size_t k = 0; k < all.size(); k += 4) {
    const auto at = place_.find(static_cast<int64_t>(all[k + 1]));
    if (at == place_.end())
      continue;
    MoverState &row = walls[static_cast<size_t>(all[k])]->rows.state[at->second];
    row.impacts = all[k + 2];
    row.status = all[k + 3];
  }
}
