/* Bodies from their particles; see bodies_lammps.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "bodies_lammps.h"

#include <cmath>
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "lammps.h"
#include "update.h"

#include "contact/vector.h"
#include "dem/error.h"
#include "dem/step/body_motion.h"
#include "dem/text.h"

using namespace LAMMPS_NS;
using asperity::Body;
using asperity::BodyMemory;
using asperity::BodySphere;
using asperity::text;

/* The largest error, relative, of a body's mass; and of the sum of its accelerations. */
static const double NEAR = 1e-6, ROUNDED = 1e-12;

/* The fix's masses of bodies must be those of the particles: so none is missed, and their inertia
 * is that of the bodies. After particles have moved between ranks; a fix lists all its masses at
 * once.
 */
std::string BodiesOfLammps::masses_error() const {
  for (size_t k = 0; k < fixes_.size(); k++) {
    int dimension;
    const int *number = static_cast<const int *>(fixes_[k]->extract("body", dimension));
    const double *mass = static_cast<const double *>(fixes_[k]->extract("masstotal", dimension));
    for (size_t b = 0; number && mass && b < firsts_.size(); b++) {
      const double here = bodies_.all[b].mass, theirs = mass[number[firsts_[b].i]];
      if (fix_of(firsts_[b]) == fixes_[k] && fabs(theirs - here) > NEAR * theirs)
        return text("the mass of the body of particle %lld is %g by ", (long long)firsts_[b].tag,
                    theirs) +
               name_of(fixes_[k]) +
               text(" and %g by its particles near this rank; they must be equal: let its spheres "
                    "not overlap, leave out 'infile', and raise 'comm_modify cutoff' to the length "
                    "of the bodies",
                    here);
    }
  }
  return "";
}

/* A body from its particles, by the mass, the center and the inertia of these spheres. */
void BodiesOfLammps::add_body(size_t from, size_t to, const Walls &walls, double time) {
  const Atom *atom = lammps_->atom;
  const Particle &first = particles_[from];
  Body body = Body();
  body.tag = first.body / FIXES - 1;
  body.first = bodies_.spheres.size();
  body.count = to - from;
  for (size_t k = from; k < to; k++) {
    const int i = particles_[k].i;
    BodySphere sphere = {{0, 0, 0}, atom->radius[i], atom->type[i], atom->mask[i], atom->tag[i]};
    aspi_subtract(row(i) + 1, row(first.i) + 1, sphere.arm);
    lammps_->domain->minimum_image(sphere.arm[0], sphere.arm[1], sphere.arm[2]);
    body.mass += atom->rmass[i];
    aspi_add_scaled(body.x, atom->rmass[i], sphere.arm, body.x);
    aspi_add_scaled(body.acceleration, 1, row(i) + 13, body.acceleration);
    bodies_.spheres.push_back(sphere);
  }
  aspi_scale(1 / body.mass, body.x);
  aspi_scale(1 / body.mass, body.acceleration);
  double inertia[6] = {0, 0, 0, 0, 0, 0};
  for (size_t k = from; k < to; k++) {
    BodySphere &sphere = bodies_.spheres[body.first + k - from];
    const double m = atom->rmass[particles_[k].i], *a = sphere.arm;
    aspi_add_scaled(sphere.arm, -1, body.x, sphere.arm);
    for (int d = 0; d < 3; d++)
      inertia[d] += m * (0.4 * sphere.radius * sphere.radius + aspi_dot(a, a) - a[d] * a[d]);
    inertia[3] -= m * a[0] * a[1];
    inertia[4] -= m * a[0] * a[2];
    inertia[5] -= m * a[1] * a[2];
  }
  firsts_.push_back(first);
  set_axes(body, inertia, walls, time);
  double turned[3];
  aspi_cross(atom->omega[first.i], bodies_.spheres[body.first].arm, turned);
  aspi_subtract(atom->v[first.i], turned, body.v);
  set_momentum(body, from);
  aspi_add_scaled(row(first.i) + 1, 1, body.x, body.x);
  for (size_t k = 0; k < body.count; k++) {
    double *arm = bodies_.spheres[body.first + k].arm;
    const double away[3] = {arm[0], arm[1], arm[2]};
    for (int d = 0; d < 3; d++)
      arm[d] = aspi_dot(away, body.axes[d]);
  }
  bodies_.all.push_back(body);
}

/* Principal moments and axes of xx, yy, zz, xy, xz, yz, from axes near to them: turned no more than
 * that takes, so that a body keeps its axes in time, also where two of its moments are equal. */
static void diagonalize(const double m[6], Body &body) {
  static const double ROUND = 1e-12;
  const double rows[3][3] = {{m[0], m[3], m[4]}, {m[3], m[1], m[5]}, {m[4], m[5], m[2]}};
  const auto product = [&](int a, int b) {
    double sum = 0;
    for (int d = 0; d < 3; d++)
      sum += body.axes[a][d] * aspi_dot(rows[d], body.axes[b]);
    return sum;
  };
  int good = 0; /* products in a row that are 0 */
  for (int round = 0; round < 60 && good < 3; round++) {
    const int a = round % 3, b = (a + 1) % 3;
    const double both = product(a, b), apart = product(b, b) - product(a, a);
    good++;
    if (!(fabs(both) > ROUND * (m[0] + m[1] + m[2])))
      continue;
    good = 0;
    const double ratio = 0.5 * apart / both;
    const double t = (ratio < 0 ? -1 : 1) / (fabs(ratio) + sqrt(1 + ratio * ratio));
    const double c = 1 / sqrt(1 + t * t), s = t * c;
    double first[3];
    aspi_copy(body.axes[a], first);
    for (int d = 0; d < 3; d++) {
      body.axes[a][d] = c * first[d] - s * body.axes[b][d];
      body.axes[b][d] = s * first[d] + c * body.axes[b][d];
    }
  }
  for (int k = 0; k < 3; k++)
    body.inertia[k] = product(k, k);
}

/* From those that are kept, turned by the spin for a time; of a stuck body from a restart file
 * those with which it has stuck. */
void BodiesOfLammps::set_axes(Body &body, const double inertia[6], const Walls &walls,
                              double time) {
  const int64_t tag = firsts_.back().tag;
  const Memory &memory = memories_[tag];
  for (int k = 0; k < 3; k++)
    for (int d = 0; d < 3; d++)
      body.axes[k][d] = k == d;
  const double(*start)[3] = body.axes;
  if (memory.has_axes > 0)
    start = memory.axes;
  else
    for (BodiesOfLammps *wall : walls)
      if (wall->memories_[tag].of_wall.is_stuck())
        start = wall->memories_[tag].of_wall.stuck.axes;
  memmove(body.axes, start, sizeof body.axes);
  if (memory.has_axes > 0)
    asperity::turn_by(lammps_->atom->omega[firsts_.back().i], time, body.axes);
  diagonalize(inertia, body);
}

/* The angular momentum at the end of the step before, and what the torque has added to it since;
 * and the acceleration in between that is not from the forces, but for rounding. */
void BodiesOfLammps::set_momentum(Body &body, size_t from) {
  const Atom *atom = lammps_->atom;
  const double half = 0.5 * lammps_->update->dt, *first = row(particles_[from].i);
  double center[3] = {0, 0, 0}, own[3], *sum = body.angular_momentum;
  aspi_copy(body.v, own);
  for (int round = 0; round < 2; round++)
    for (size_t k = from; k < from + body.count; k++) {
      const int i = particles_[k].i;
      const double *at = row(i), m = atom->rmass[i], r = atom->radius[i];
      double arm[3], couple[3], push[3];
      aspi_subtract(at + 4, first + 4, arm);
      lammps_->domain->minimum_image(arm[0], arm[1], arm[2]);
      if (round == 0) {
        aspi_add_scaled(center, m / body.mass, arm, center);
        aspi_add_scaled(own, -m / body.mass, at + 7, own);
        continue;
      }
      aspi_subtract(arm, center, arm);
      aspi_copy(at + 7, push);
      aspi_scale(m, push);
      aspi_add_scaled(push, half, at + 13, push);
      aspi_cross(arm, push, couple);
      aspi_add_scaled(sum, 1, couple, sum);
      aspi_add_scaled(sum, 0.4 * m * r * r, at + 10, sum);
      aspi_add_scaled(sum, half, at + 16, sum);
    }
  aspi_scale(1 / half, own);
  aspi_subtract(own, body.acceleration, own);
  const double terms = aspi_length(body.v) / half + aspi_length(body.acceleration);
  aspi_scale(aspi_length(own) > ROUNDED * terms ? 1 : 0, own);
  added_.insert(added_.end(), own, own + 3);
}

/* The acceleration that each fix adds by itself, as by its keyword `gravity`: of the body with the
 * least number of all ranks. */
void BodiesOfLammps::find_own() {
  for (size_t k = 0; k < fixes_.size(); k++) {
    struct {
      double number;
      int rank;
    } mine = {-HUGE_VAL, lammps_->comm->me}, all;
    double *own = &own_[3 * k];
    for (size_t b = 0; b < firsts_.size(); b++)
      if (fix_of(firsts_[b]) == fixes_[k] && -static_cast<double>(firsts_[b].body) > mine.number) {
        mine.number = -static_cast<double>(firsts_[b].body);
        aspi_copy(&added_[3 * b], own);
      }
    MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE_INT, MPI_MAXLOC, lammps_->world);
    MPI_Bcast(own, 3, MPI_DOUBLE, all.rank, lammps_->world);
  }
}

/* At the end of a step (`forces` false) the places kept are those of now, and nothing moves a body
 * on. */
void BodiesOfLammps::read_bodies(const Walls &walls, bool forces) {
  bodies_.step = lammps_->update->ntimestep;
  bodies_.dt = lammps_->update->dt;
  bodies_.all.clear();
  bodies_.spheres.clear();
  bodies_.memory.assign(walls.size(), std::vector<BodyMemory *>());
  firsts_.clear();
  added_.clear();
  read_particles(forces);
  for (size_t from = 0, to; from < particles_.size(); from = to) {
    for (to = from + 1; to < particles_.size() && particles_[to].body == particles_[from].body;)
      to++;
    if (particles_[from].i < lammps_->atom->nlocal)
      add_body(from, to, walls, forces ? bodies_.dt : 0);
  }
  for (size_t w = 0; w < walls.size(); w++)
    for (const Particle &first : firsts_) {
      Memory &memory = walls[w]->memories_[first.tag];
      memory.body = static_cast<double>(first.body);
      bodies_.memory[w].push_back(&memory.of_wall);
    }
  if (forces && is_new_)
    find_own();
  for (size_t b = 0; b < bodies_.all.size(); b++)
    aspi_add_scaled(bodies_.all[b].acceleration, 1, own_of(firsts_[b]),
                    bodies_.all[b].acceleration);
  before_ = bodies_.all;
}

asperity::Bodies *BodiesOfLammps::take(const Walls &walls) {
  if (!any())
    return NULL;
  read_bodies(walls, true);
  if (is_new_)
    fail_together(masses_error());
  is_new_ = false;
  return &bodies_;
}

asperity::Bodies *BodiesOfLammps::take_stuck(const Walls &walls) {
  if (!any() || !is_any_stuck_)
    return NULL;
  read_bodies(walls, false);
  return &bodies_;
}

void BodiesOfLammps::list_deleted() {
  std::vector<double> mine;
  for (const auto &memory : memories_)
    if (memory.second.of_wall.status == static_cast<double>(asperity::Status::TO_DELETE))
      mine.push_back(memory.second.body);
  deleted_ = asperity::gather_for_all(mine, lammps_->world);
  std::sort(deleted_.begin(), deleted_.end());
}
