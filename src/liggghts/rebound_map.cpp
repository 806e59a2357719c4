/* What the triangles of one mesh have taken; see rebound_map.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound_map.h"

using namespace LAMMPS_NS;

static const char *const STEP = "rebound_step";
static const char *const NAMES[] = {"impacts", "deposited_mass", "impact_energy"};

/* The mesh's own restart does not know these properties when it reads its triangles, so they stay
 * out of it (restart_no); the fix keeps them. */
ReboundMap::ReboundMap(TriMesh *mesh) : mesh_(mesh), touched_(false) {
  step_ = mesh->prop().addElementProperty<VectorContainer<double, 3>>(
      STEP, "comm_reverse", "frame_invariant", "restart_no");
  step_->setAll(0.);
  for (int k = 0; k < N_VALUES; k++) {
    sums_[k] = mesh->prop().addElementProperty<ScalarContainer<double>>(
        NAMES[k], "comm_exchange_borders", "frame_invariant", "restart_no");
    sums_[k]->setAll(0.);
  }
}

void ReboundMap::remove() {
  mesh_->prop().removeElementProperty(STEP);
  for (int k = 0; k < N_VALUES; k++)
    mesh_->prop().removeElementProperty(NAMES[k]);
}

void ReboundMap::add(int triangle, double deposited_mass, double energy) {
  double *value = (*step_)(triangle);
  touched_ = true;
  value[IMPACTS] += 1;
  value[MASS] += deposited_mass;
  value[ENERGY] += energy;
}

void ReboundMap::end_step(int ranks) {
  if (ranks == 1 && !touched_)
    return;
  touched_ = false;
  const int n = mesh_->sizeLocal();
  for (int t = 0; t < n; t++) {
    const double *value = (*step_)(t);
    if (!(value[IMPACTS] > 0))
      continue;
    for (int k = 0; k < N_VALUES; k++)
      (*sums_[k])(t) += value[k];
  }
}

std::vector<double> ReboundMap::gather(MPI_Comm world) {
  int mine = -1, most;
  for (int t = 0; t < mesh_->sizeLocal(); t++)
    if (mesh_->id(t) > mine)
      mine = mesh_->id(t);
  MPI_Allreduce(&mine, &most, 1, MPI_INT, MPI_MAX, world);
  std::vector<double> part((most + 1) * N_VALUES, 0.), all(part.size(), 0.);
  for (int t = 0; t < mesh_->sizeLocal(); t++)
    for (int k = 0; k < N_VALUES; k++)
      part[mesh_->id(t) * N_VALUES + k] = (*sums_[k])(t);
  MPI_Reduce(part.data(), all.data(), static_cast<int>(part.size()), MPI_DOUBLE, MPI_SUM, 0, world);
  return all;
}

void ReboundMap::scatter(const std::vector<double> &values) {
  for (int t = 0; t < mesh_->sizeLocal(); t++)
    for (int k = 0; k < N_VALUES; k++) {
      const size_t at = static_cast<size_t>(mesh_->id(t)) * N_VALUES + k;
      if (at < values.size())
        (*sums_[k])(t) = values[at];
    }
}
