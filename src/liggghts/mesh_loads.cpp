/* Sums of a mesh of LIGGGHTS over its triangles, and force and torque for its stress module; see
 * mesh_liggghts.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh_liggghts.h"

#include <math.h>
#include <algorithm>

#include "atom.h"
#include "contact/vector.h"
#include "tri_mesh.h"

using namespace LAMMPS_NS;
using asperity::Books;
using asperity::ContactLoad;

/* A servo gets its force spread over about this many steps, as the contacts of soft grains last: a
 * rigid wall changes a velocity within one. */
static const double SPREAD = 100;

/* The sums, and behind them the depth of erosion. */
static const char *name_of(int k) {
  return k < Books::N_SUMS ? Books::SUM_NAMES[k] : "erosion_depth";
}

/* The mesh's own restart reads its triangles before these properties exist, so they stay out of it
 * (restart_no); the fix keeps them. */
void MeshOfLiggghts::add_sums() {
  for (int k = 0; k <= Books::N_SUMS; k++) {
    sums_[k] = mesh()->prop().addElementProperty<ScalarContainer<double>>(
        name_of(k), "comm_exchange_borders", "frame_invariant", "restart_no");
    sums_[k]->setAll(0.);
  }
}

void MeshOfLiggghts::remove_sums() {
  for (int k = 0; k <= Books::N_SUMS; k++)
    mesh()->prop().removeElementProperty(name_of(k));
}

void MeshOfLiggghts::show(size_t first, const std::vector<double> &sums, double worn_density) {
  const size_t count = sums.size() / Books::N_SUMS;
  for (int t = 0; t < mesh()->sizeLocal(); t++) {
    const size_t at = static_cast<size_t>(mesh()->id(t)) - first;
    if (at >= count)
      continue;
    const double *of = &sums[at * Books::N_SUMS];
    for (int k = 0; k < Books::N_SUMS; k++)
      (*sums_[k])(t) = of[k];
    if (worn_density > 0)
      (*sums_[Books::N_SUMS])(t) = of[Books::SUM_ERODED] / (worn_density * mesh()->areaElem(t));
  }
}

/* ---- for the stress module ---- */

MeshModuleStress *MeshOfLiggghts::stress() const {
  return dynamic_cast<MeshModuleStress *>(fix_->get_module("stress"));
}

bool MeshOfLiggghts::measures() const {
  MeshModuleStress *module = stress();
  return module && module->trackStress();
}

bool MeshOfLiggghts::wears() const {
  MeshModuleStress *module = stress();
  return module && module->trackWear();
}

void MeshOfLiggghts::take(const ContactLoad &load) {
  if (load.mask & fix_->get_groupbit())
    loads_.push_back(load);
}

void MeshOfLiggghts::add_force(int local, const double force[3]) {
  double *f = (*mesh()->prop().getElementProperty<VectorContainer<double, 3>>("f"))(local);
  aspi_add_scaled(f, 1, force, f);
}

/* The total goes to this rank's part of the mesh's sums, which LIGGGHTS adds up; the force on a
 * triangle to the triangle, or to its owner where this rank has none. */
void MeshOfLiggghts::hand_over(double dt) {
  const double spread = is_servo_ ? SPREAD : 1;
  std::vector<double> away; /* number and force of triangles that this rank does not have */
  double reference[3] = {stress()->compute_vector(6), stress()->compute_vector(7),
                         stress()->compute_vector(8)};
  for (const ContactLoad &load : loads_) {
    double force[3], arm[3], torque[3];
    for (int d = 0; d < 3; d++)
      force[d] = load.impulse[d] / dt;
    aspi_subtract(load.point, reference, arm);
    aspi_cross(arm, force, torque);
    aspi_add_scaled(torque, 1 / dt, load.couple, torque);
    aspi_add_scaled(force_, 1 / spread, force, force_);
    aspi_add_scaled(torque_, 1 / spread, torque, torque_);
    const int local = mesh()->map_size(load.piece) > 0 ? mesh()->map(load.piece, 0) : -1;
    if (local >= 0)
      add_force(local, force);
    else {
      away.push_back(load.piece);
      away.insert(away.end(), force, force + 3);
    }
  }
  loads_.clear();
  stress()->add_global_external_contribution(force_, torque_);
  aspi_scale(1 - 1 / spread, force_);
  aspi_scale(1 - 1 / spread, torque_);
  give_away(away);
}

/* Rows of number and force to the ranks that have these triangles. */
void MeshOfLiggghts::give_away(const std::vector<double> &away) {
  const std::vector<double> theirs = asperity::gather_for_all(away, world_);
  for (size_t at = 0; at < theirs.size(); at += 4) {
    const int piece = static_cast<int>(theirs[at]);
    for (int k = 0; k < mesh()->map_size(piece); k++)
      if (mesh()->map(piece, k) < mesh()->sizeLocal())
        add_force(mesh()->map(piece, k), &theirs[at + 1]);
  }
}
