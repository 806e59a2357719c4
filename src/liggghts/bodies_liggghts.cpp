/* The bodies of fix multisphere; see bodies_liggghts.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "bodies_liggghts.h"

#include <string.h>
#include <algorithm>

#include "atom.h"
#include "domain.h"
#include "math_extra.h"
#include "modify.h"
#include "multisphere.h"
#include "update.h"
#include "contact/vector.h"
#include "dem/step/body_motion.h"

using namespace LAMMPS_NS;
using asperity::Bodies;
using asperity::Body;
using asperity::BodySphere;

namespace {

typedef VectorContainer<double, 3> Vectors;
typedef VectorContainer<double, 4> Quaternions;

/* What the engine keeps to itself: it sets atoms by their bodies, and sends those of ghosts home;
 * and the places of atoms along the axes of their bodies. */
struct Inner : public FixMultisphere {
  static double **places(FixMultisphere *fix) {
    double **FixMultisphere::*of = &Inner::displace_;
    return fix->*of;
  }
  static void set_atoms(FixMultisphere *fix) {
    void (FixMultisphere::*set)() = &Inner::set_xv;
    int FixMultisphere::*flag = &Inner::rev_comm_flag_;
    (fix->*set)();
    fix->*flag = MS_COMM_REV_X_V_OMEGA;
    fix->reverse_comm();
  }
};

template <class Container> Container &property(FixMultisphere *fix, const char *name) {
  return *fix->data().prop().getElementProperty<Container>(name);
}

} // namespace

BodiesOfLiggghts::BodiesOfLiggghts(LAMMPS *engine)
    : Pointers(engine),
      fix_(static_cast<FixMultisphere *>(modify->find_fix_style("multisphere", 0))), bodies_(),
      is_reordered_(true) {
  bodies_.begins = true;
}

Bodies *BodiesOfLiggghts::take(const std::vector<asperity::Stepper *> &walls) {
  if (!fix_)
    return NULL;
  Multisphere &data = fix_->data();
  bodies_.step = update->ntimestep;
  bodies_.dt = update->dt;
  bodies_.all.resize(static_cast<size_t>(data.n_body()));
  double **const inertia = property<Vectors>(fix_, "inertia").begin(),
                 **const forces = property<Vectors>(fix_, "fcm").begin(),
                 **const torques = property<Vectors>(fix_, "torque").begin();
  /* A body of an insert/stream is moved straight until it has left the face. */
  const bool streams = modify->n_fixes_style("insert/stream") > 0;
  const int *const starts = property<ScalarContainer<int>>(fix_, "start_step").begin();
  double **const axes[] = {property<Vectors>(fix_, "ex_space").begin(),
                           property<Vectors>(fix_, "ey_space").begin(),
                           property<Vectors>(fix_, "ez_space").begin()};
  for (size_t b = 0; b < bodies_.all.size(); b++) {
    Body &body = bodies_.all[b];
    const int i = static_cast<int>(b);
    body.tag = data.tag(i) - 1;
    body.mass = data.mass(i);
    data.xcm(body.x, i);
    data.vcm(body.v, i);
    data.angmom(body.angular_momentum, i);
    aspi_copy(inertia[b], body.inertia);
    aspi_copy(forces[b], body.acceleration);
    aspi_scale(1 / body.mass, body.acceleration);
    aspi_copy(torques[b], body.torque);
    for (int k = 0; k < 3; k++)
      aspi_copy(axes[k][b], body.axes[k]);
    body.is_changed = false;
    body.is_led = streams && update->ntimestep < starts[b];
  }
  if (is_reordered_) {
    take_spheres();
    asperity::claim_bodies(walls, bodies_, world);
  }
  is_reordered_ = false;
  return &bodies_;
}

/* Each sphere once: an atom of this rank, or the first of its ghosts; in the order of their tags,
 * for the same sums on any number of ranks. */
void BodiesOfLiggghts::take_spheres() {
  std::vector<std::pair<int, BodySphere>> found;
  double **const places = Inner::places(fix_);
  for (int i = 0; i < atom->nlocal + atom->nghost; i++) {
    const int b = fix_->belongs_to(i) < 0 ? -1 : fix_->data().map(fix_->belongs_to(i));
    if (b < 0 || !domain->is_owned_or_first_ghost(i))
      continue;
    BodySphere sphere = {{0, 0, 0}, atom->radius[i], atom->type[i], atom->mask[i], atom->tag[i]};
    aspi_copy(places[i], sphere.arm);
    found.push_back(std::make_pair(b, sphere));
  }
  std::sort(found.begin(), found.end(),
            [](const std::pair<int, BodySphere> &one, const std::pair<int, BodySphere> &other) {
              return one.first != other.first ? one.first < other.first
                                              : one.second.tag < other.second.tag;
            });
  bodies_.spheres.clear();
  for (Body &body : bodies_.all)
    body.count = 0;
  for (const std::pair<int, BodySphere> &one : found) {
    Body &body = bodies_.all[static_cast<size_t>(one.first)];
    if (body.count++ == 0)
      body.first = bodies_.spheres.size();
    bodies_.spheres.push_back(one.second);
  }
}

void BodiesOfLiggghts::write(size_t b, bool is_end) {
  Body &body = bodies_.all[b];
  const auto put = [this, b](const double *from, const char *name) {
    aspi_copy(from, property<Vectors>(fix_, name).begin()[b]);
  };
  double omega[3], pull[3];
  if (is_end) {
    aspi_copy(body.acceleration, pull);
    aspi_scale(body.mass, pull);
    put(pull, "fcm");
    put(body.torque, "torque");
  } else {
    MathExtra::exyz_to_q(body.axes[0], body.axes[1], body.axes[2],
                         property<Quaternions>(fix_, "quat").begin()[b]);
    put(body.x, "xcm");
    put(body.axes[0], "ex_space");
    put(body.axes[1], "ey_space");
    put(body.axes[2], "ez_space");
  }
  asperity::spin_of(body, omega);
  put(body.v, "vcm");
  put(body.angular_momentum, "angmom");
  put(omega, "omega");
}

void BodiesOfLiggghts::put(bool is_end) {
  if (!fix_)
    return;
  int mine = 0, any_changed;
  for (size_t b = 0; b < bodies_.all.size(); b++)
    if (bodies_.all[b].is_changed) {
      write(b, is_end);
      mine = 1;
    }
  MPI_Allreduce(&mine, &any_changed, 1, MPI_INT, MPI_MAX, world);
  if (any_changed && is_end)
    fix_->set_v_communicate();
  else if (any_changed)
    Inner::set_atoms(fix_);
}

void BodiesOfLiggghts::list_deleted(const asperity::Memories &rows) {
  std::vector<double> mine;
  for (size_t b = 0; b < rows.memory.size(); b++)
    if (rows.status(static_cast<int>(b)) == asperity::Status::TO_DELETE)
      mine.push_back(static_cast<double>(bodies_.all[b].tag) + 1);
  deleted_ = asperity::gather_for_all(mine, world);
  std::sort(deleted_.begin(), deleted_.end());
}
