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
      fix_(static_cast<FixMultisphere *>(modify->find_fix_style("multisphere", 0))),
      is_reordered_(true) {}

Bodies *BodiesOfLiggghts::take(const std::vector<asperity::Wall *> &walls) {
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
    body.is_guided = streams && update->ntimestep < starts[b];
  }
  if (is_reordered_) {
    take_spheres();
    asperity::claim_bodies(walls, bodies_, world);
  }
  is_reordered_ = false;
  return &bodies_;
}

/* By atoms of this rank, and the first of their ghosts. */
void BodiesOfLiggghts::take_spheres() {
  std::vector<Found> found;
  double **const places = Inner::places(fix_);
  for (int i = 0; i < atom->nlocal + atom->nghost; i++) {
    const int b = fix_->belongs_to(i) < 0 ? -1 : fix_->data().map(fix_->belongs_to(i));
    if (b < 0 || !domain->is_owned_or_first_ghost(i))
      continue;
    BodySphere sphere = {{0, 0, 0}, atom->radius[i], atom->type[i], atom->mask[i], atom->tag[i]};
    aspi_copy(places[i], sphere.arm);
    found.push_back(Found(static_cast<size_t>(b), sphere));
  }
  set_spheres(found);
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

void BodiesOfLiggghts::set_particles(bool is_end) {
  if (is_end)
    fix_->set_v_communicate();
  else
    Inner::set_atoms(fix_);
}
