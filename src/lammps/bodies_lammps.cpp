/* The bodies of fixes rigid/small and rigid/nve/small; see bodies_lammps.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "bodies_lammps.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "fix_rigid_small.h"
#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "lammps.h"
#include "modify.h"
#include "update.h"

#include "contact/vector.h"
#include "dem/error.h"
#include "dem/text.h"

/* Of math_extra.h, which Debian's package leaves out. */
namespace MathExtra {
void exyz_to_q(double *ex, double *ey, double *ez, double *q);
}

using namespace LAMMPS_NS;
using asperity::Bodies;
using asperity::Body;
using asperity::BodySphere;

namespace {

/* What the fix keeps to itself. */
struct Small : public FixRigidSmall {
  using FixRigidSmall::atom2body;
  using FixRigidSmall::Body;
  using FixRigidSmall::body;
  using FixRigidSmall::bodytag;
  using FixRigidSmall::commflag;
  using FixRigidSmall::displace;
  using FixRigidSmall::nlocal_body;
  using FixRigidSmall::xcmimage;
};

template <class T> T &of(const Fix *fix, T FixRigidSmall::*member) {
  return const_cast<FixRigidSmall *>(static_cast<const FixRigidSmall *>(fix))->*member;
}

/* What it sends to the ghosts of bodies: values of its `commflag`. */
const int MOTION = 1, VELOCITY = 2;

/* In LAMMPS since 2022 the function has another name. */
template <class C> auto send(C *comm, Fix *fix, int) -> decltype(comm->forward_comm_fix(fix)) {
  return comm->forward_comm_fix(fix);
}
template <class C> auto send(C *comm, Fix *fix, long) -> decltype(comm->forward_comm(fix)) {
  return comm->forward_comm(fix);
}

/* The momentum of the quaternion, which rigid/nve/small keeps (Miller et al. 2002). */
void set_conjugate(const Body &body, const double q[4], double conjugate[4]) {
  double along[3], side[3];
  for (int k = 0; k < 3; k++)
    along[k] = 2 * aspi_dot(body.axes[k], body.angular_momentum);
  aspi_cross(q + 1, along, side);
  conjugate[0] = -aspi_dot(q + 1, along);
  for (int d = 0; d < 3; d++)
    conjugate[1 + d] = q[0] * along[d] + side[d];
}

void write(const Body &from, Small::Body &to, bool is_end) {
  if (is_end) {
    aspi_copy(from.acceleration, to.fcm);
    aspi_scale(from.mass, to.fcm);
    aspi_copy(from.torque, to.torque);
  } else {
    aspi_copy(from.x, to.xcm);
    aspi_copy(from.axes[0], to.ex_space);
    aspi_copy(from.axes[1], to.ey_space);
    aspi_copy(from.axes[2], to.ez_space);
    MathExtra::exyz_to_q(to.ex_space, to.ey_space, to.ez_space, to.quat);
  }
  aspi_copy(from.v, to.vcm);
  aspi_copy(from.angular_momentum, to.angmom);
  asperity::spin_of(from, to.omega);
  set_conjugate(from, to.quat, to.conjqm);
}

} // namespace

std::string BodiesOfLammps::error_of(const Fix *fix) {
  const std::string style = fix->style;
  if (style == "rigid/small" || style == "rigid/nve/small")
    return "";
  const std::string plain = asperity::without_suffix(style);
  const std::string name = "fix " + style + " (id " + fix->id + ")";
  if (plain != style)
    return name + " has its bodies in KOKKOS, where they cannot rebound; put 'suffix off' before "
                  "and 'suffix on' after it";
  return name + " ties particles to bodies that cannot rebound; " +
         (style == "rigid" || style == "rigid/nve"
              ? "it must be " + style + "/small"
              : "those of rigid/small and rigid/nve/small can");
}

void BodiesOfLammps::init() {
  fixes_.clear();
  for (int i = 0; i < lammps_->modify->nfix; i++) {
    Fix *fix = lammps_->modify->fix[i];
    if (fix->rigid_flag && error_of(fix).empty())
      fixes_.push_back(fix);
  }
}

bool BodiesOfLammps::stand_before(const Fix *fix) const {
  const Modify *modify = lammps_->modify;
  bool all = true;
  for (int i = modify->nfix - 1; i >= 0 && modify->fix[i] != fix; i--)
    all = all && std::find(fixes_.begin(), fixes_.end(), modify->fix[i]) == fixes_.end();
  return all;
}

Fix *BodiesOfLammps::fix_of(int i) const {
  for (Fix *fix : fixes_)
    if (of(fix, &Small::bodytag)[i] > 0)
      return fix;
  return NULL;
}

/* ---- listing ---- */

void BodiesOfLammps::list(const std::vector<asperity::Wall *> &walls, bool begins) {
  std::map<double, size_t> numbers; /* by the tags of their owners */
  owned_.clear();
  owners_.clear();
  bodies_.all.clear();
  for (Fix *fix : fixes_)
    for (int b = 0; b < of(fix, &Small::nlocal_body); b++) {
      const Small::Body &from = of(fix, &Small::body)[b];
      Body body = Body();
      body.mass = from.mass;
      aspi_copy(from.inertia, body.inertia);
      owners_.push_back(static_cast<double>(lammps_->atom->tag[from.ilocal]));
      numbers[owners_.back()] = owned_.size();
      owned_.push_back(std::make_pair(fix, b));
      bodies_.all.push_back(body);
    }
  send_rows();
  list_spheres(numbers);
  if (begins) {
    is_checked_ = false;
    bodies_.begins = true;
    read();
  }
  asperity::claim_bodies(walls, bodies_, lammps_->world);
}

void BodiesOfLammps::send_rows() {
  const Atom *atom = lammps_->atom;
  rows_.assign(static_cast<size_t>(atom->nlocal + atom->nghost) + 1, Row());
  for (int i = 0; i < atom->nlocal; i++)
    if (const Fix *fix = fix_of(i)) {
      Row &row = rows_[static_cast<size_t>(i)];
      row.owner = static_cast<double>(of(fix, &Small::bodytag)[i]);
      aspi_copy(of(fix, &Small::displace)[i], row.arm);
    }
  send(lammps_->comm, fix_, 0);
}

/* By particles of this rank and their ghosts. */
void BodiesOfLammps::list_spheres(const std::map<double, size_t> &numbers) {
  const Atom *atom = lammps_->atom;
  std::vector<Found> found;
  for (int i = 0; i < atom->nlocal + atom->nghost; i++) {
    const Row &row = rows_[static_cast<size_t>(i)];
    const auto number = row.owner > 0 ? numbers.find(row.owner) : numbers.end();
    if (number == numbers.end())
      continue;
    BodySphere sphere = {{0, 0, 0}, atom->radius[i], atom->type[i], atom->mask[i], atom->tag[i]};
    aspi_copy(row.arm, sphere.arm);
    found.push_back(Found(number->second, sphere));
  }
  set_spheres(found);
  for (Body &body : bodies_.all)
    body.tag = bodies_.spheres[body.first].tag - 1;
}

int BodiesOfLammps::pack(int n, const int *list, double *to) const {
  for (int k = 0; k < n; k++)
    memcpy(to + SENT * k, &rows_[static_cast<size_t>(list[k])], sizeof(Row));
  return SENT * n;
}

void BodiesOfLammps::unpack(int n, int first, const double *from) {
  memcpy(&rows_[static_cast<size_t>(first)], from, static_cast<size_t>(n) * sizeof(Row));
}

double BodiesOfLammps::name_at(int i) const {
  const Fix *fix = fix_of(i);
  return fix ? static_cast<double>(of(fix, &Small::bodytag)[i]) : 0;
}

/* ---- a step ---- */

void BodiesOfLammps::read() {
  bodies_.step = lammps_->update->ntimestep;
  bodies_.dt = lammps_->update->dt;
  for (size_t b = 0; b < bodies_.all.size(); b++) {
    const Small::Body &from = of(owned_[b].first, &Small::body)[owned_[b].second];
    Body &body = bodies_.all[b];
    aspi_copy(from.xcm, body.x);
    aspi_copy(from.vcm, body.v);
    aspi_copy(from.angmom, body.angular_momentum);
    aspi_copy(from.fcm, body.acceleration);
    aspi_scale(1 / body.mass, body.acceleration);
    aspi_copy(from.torque, body.torque);
    aspi_copy(from.ex_space, body.axes[0]);
    aspi_copy(from.ey_space, body.axes[1]);
    aspi_copy(from.ez_space, body.axes[2]);
    body.is_changed = false;
  }
}

Bodies *BodiesOfLammps::take(const std::vector<asperity::Wall *> &) {
  read();
  for (Fix *fix : fixes_)
    if (!is_checked_ && !is_known(fix))
      throw asperity::Error(std::string("fix ") + fix->style + " (id " + fix->id +
                            ") does not keep its bodies as the LAMMPS does that asperity was built "
                            "for; build asperity for this one's source tree");
  is_checked_ = true;
  return &bodies_;
}

void BodiesOfLammps::write(size_t b, bool is_end) {
  ::write(bodies_.all[b], of(owned_[b].first, &Small::body)[owned_[b].second], is_end);
}

void BodiesOfLammps::set_particles(bool is_end) {
  const Atom *atom = lammps_->atom;
  for (Fix *fix : fixes_) {
    of(fix, &Small::commflag) = is_end ? VELOCITY : MOTION;
    send(lammps_->comm, fix, 0);
    for (int i = 0; i < atom->nlocal; i++)
      set_particle(fix, i, is_end ? NULL : atom->x[i], atom->v[i], atom->omega[i]);
  }
}

/* As the fix does it, but for its virial, which has the forces of the step already. */
void BodiesOfLammps::set_particle(const Fix *fix, int i, double *x, double v[3],
                                  double omega[3]) const {
  const int number = of(fix, &Small::atom2body)[i];
  if (number < 0)
    return;
  const Small::Body &body = of(fix, &Small::body)[number];
  const double *period = lammps_->domain->prd, *at = of(fix, &Small::displace)[i];
  const imageint image = of(fix, &Small::xcmimage)[i];
  const imageint boxes[] = {image & IMGMASK, image >> IMGBITS & IMGMASK, image >> IMG2BITS};
  double arm[3], turned[3];
  for (int d = 0; d < 3; d++)
    arm[d] = body.ex_space[d] * at[0] + body.ey_space[d] * at[1] + body.ez_space[d] * at[2];
  aspi_cross(body.omega, arm, turned);
  aspi_copy(body.omega, omega);
  for (int d = 0; d < 3; d++) {
    v[d] = turned[d] + body.vcm[d];
    if (x)
      x[d] = arm[d] + (body.xcm[d] - static_cast<double>(boxes[d] - IMGMAX) * period[d]);
  }
}

static bool is_near(const double one[3], const double other[3], double scale) {
  double off[3];
  aspi_subtract(one, other, off);
  return aspi_length(off) <= 1e-6 * (scale + aspi_length(one));
}

/* True if a fix's bodies are where the declaration of its class has them: by what the fix tells,
 * and by its particles, which it has moved in this step. */
bool BodiesOfLammps::is_known(Fix *fix) const {
  const Atom *atom = lammps_->atom;
  const size_t sent = static_cast<size_t>(fix->comm_forward - 1) * sizeof(double);
  int dimension;
  bool is_as_declared = fix->extract("body", dimension) == of(fix, &Small::atom2body) &&
                        sizeof(Small::Body) <= sent && sent < sizeof(Small::Body) + sizeof(double);
  const double *masses = static_cast<double *>(fix->extract("masstotal", dimension));
  for (size_t b = 0; b < owned_.size() && is_as_declared; b++)
    is_as_declared =
        owned_[b].first != fix || !(fabs(masses[owned_[b].second] - bodies_.all[b].mass) > 0);
  for (int i = 0; i < atom->nlocal && is_as_declared; i++) {
    double x[3], v[3], omega[3];
    aspi_copy(atom->x[i], x);
    aspi_copy(atom->v[i], v);
    aspi_copy(atom->omega[i], omega);
    set_particle(fix, i, x, v, omega);
    is_as_declared = is_near(x, atom->x[i], atom->radius[i]) && is_near(v, atom->v[i], 0) &&
                     is_near(omega, atom->omega[i], 0);
  }
  return is_as_declared;
}
