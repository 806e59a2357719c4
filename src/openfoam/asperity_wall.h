/* The patch interaction model asperityWall, a template for all kinds of cloud.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "PatchInteractionModel.H"
#include "openfoam/compatibility.h"
#include "openfoam/patch_walls.h"

namespace Foam {

/* The temperature of a parcel that has one, else 0. */
template <class P> auto temperature(const P &p, int) -> decltype(p.T()) {
  return p.T();
}
template <class P> scalar temperature(const P &, long) {
  return 0;
}
template <class P> auto hasTemperature(const P *p) -> decltype(p->T(), true) {
  return true;
}
inline bool hasTemperature(const void *) {
  return false;
}
template <class P> auto canCollide(const P *p) -> decltype(p->collisionRecords(), true) {
  return true;
}
inline bool canCollide(const void *) {
  return false;
}

template <class CloudType>
class asperityWall : public asperity::Reporting<PatchInteractionModel<CloudType>> {
public:
  typedef PatchInteractionModel<CloudType> Model;
  typedef typename CloudType::parcelType parcelType;
  TypeName("asperityWall");

  asperityWall(const dictionary &dict, CloudType &cloud)
      : asperity::Reporting<Model>(dict, cloud, typeName),
        walls_(std::make_shared<asperity::PatchWalls>(
            cloud.name(), asperity::Gas{cloud.U(), cloud.rho(), cloud.mu()}, kind_of(cloud),
            *this)) {}
  /* A cloud in steady state makes a copy at each solution; it has the same walls. */
  virtual autoPtr<Model> clone() const {
    return autoPtr<Model>(new asperityWall<CloudType>(*this));
  }
  virtual bool correct(parcelType &p, const polyPatch &patch, bool &keepParticle);

protected:
  virtual void report(Ostream &log, Ostream &fates);
  virtual void write_header(Ostream &fates) const {
    walls_->write_header(fates);
  }

private:
  static asperity::Cloud kind_of(const CloudType &cloud);
  void remove();
  asperity::Parcel parcel_at(const parcelType &p, const polyPatch &patch, label face) const;

  std::shared_ptr<asperity::PatchWalls> walls_;
};

template <class CloudType>
asperity::Cloud asperityWall<CloudType>::kind_of(const CloudType &cloud) {
  const parcelType *const any = nullptr;
  asperity::Cloud kind = {};
  kind.density = cloud.constProps().rho0();
  kind.has_temperature = hasTemperature(any);
  kind.can_collide = canCollide(any);
  kind.is_steady = cloud.solution().steadyState();
  return kind;
}

/* The base class has begun the line of `fates`. */
template <class CloudType> void asperityWall<CloudType>::report(Ostream &log, Ostream &fates) {
  remove();
  scalar least = GREAT, most = 0;
  for (const parcelType &p : this->owner()) {
    least = std::min(least, p.d());
    most = std::max(most, p.d());
  }
  walls_->meet(least, most);
  walls_->info(log, fates, *this);
  fates << endl;
}

/* What flows take away in this time step begins at rest on its face. A parcel that has stuck is on
 * the face of its tetrahedron. */
template <class CloudType> void asperityWall<CloudType>::remove() {
  const polyBoundaryMesh &patches = this->owner().mesh().boundaryMesh();
  for (parcelType &p : this->owner()) {
    const label patch = asperity::is_active(p) ? -1 : patches.whichPatch(p.tetFace());
    const asperity::PatchWall *wall = patch < 0 ? NULL : walls_->at(patch);
    if (!wall || !wall->has_flow)
      continue;
    asperity::Parcel parcel = parcel_at(p, patches[patch], p.tetFace());
    if (!walls_->removes(parcel))
      continue;
    asperity::set_active(p, true);
    p.U() = vector::zero;
  }
}

template <class CloudType>
asperity::Parcel asperityWall<CloudType>::parcel_at(const parcelType &p, const polyPatch &patch,
                                                    label face) const {
  const label step = this->owner().mesh().time().timeIndex();
  asperity::Parcel parcel = {};
  parcel.sphere.d_p = p.d();
  parcel.sphere.density = p.rho();
  parcel.sphere.temperature = temperature(p, 0);
  parcel.number = p.nParticle();
  parcel.key.tag = static_cast<uint64_t>(p.origProc()) << 32 | static_cast<uint32_t>(p.origId());
  parcel.key.impact = (static_cast<uint32_t>(step) * 2654435761u) & 0x7fffffffu;
  parcel.step = step;
  parcel.patch = patch.index();
  parcel.face = patch.whichFace(face);
  return parcel;
}

/* A parcel has no place for the number of its impact. The time stands for it: the time step, and a
 * number of 2^-16 of it, which seldom depends on the number of ranks, though its last digits do; in
 * steady state, where a step is a whole flight, of 2^-26. */
template <class CloudType>
bool asperityWall<CloudType>::correct(parcelType &p, const polyPatch &patch, bool &keepParticle) {
  const asperity::PatchWall *wall = walls_->at(patch.index());
  if (!wall)
    return false;
  vector outward, speed;
  this->owner().patchData(p, patch, outward, speed);
  const vector before = p.U() - speed;
  const vector place = asperity::position(p, this->owner().mesh());
  keepParticle = true;
  if (!((before & outward) > 0))
    return true;
  const Time &time = this->owner().mesh().time();
  const cloudSolution &solution = this->owner().solution();
  const scalar step = solution.transient() ? time.deltaTValue() : solution.trackTime();
  const uint32_t fraction =
      static_cast<uint32_t>(p.stepFraction() * (1 << (solution.transient() ? 16 : 26)));
  asperity::Parcel parcel = parcel_at(p, patch, p.face());
  parcel.key.impact = (fraction + parcel.key.impact) & 0x7fffffffu;
  parcel.time = time.value() + (p.stepFraction() - 1) * step;
  for (direction k = 0; k < 3; k++) {
    parcel.x[k] = place[k];
    parcel.v1[k] = before[k];
    parcel.n[k] = -outward[k];
  }
  const asperity::Hit hit = walls_->hit(parcel);
  const bool sticks = hit.outcome == ASP_DEPOSIT;
  asperity::set_active(p, !sticks);
  p.U() = sticks ? vector::zero : vector(hit.v2[0], hit.v2[1], hit.v2[2]) + speed;
  keepParticle = !(sticks && wall->deletes);
  return true;
}

} // namespace Foam
