/* What the triangles of one mesh have taken; see rebound_map.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound_map.h"

#include <numeric>
#include <utility>

using namespace LAMMPS_NS;

static const char *const NAMES[] = {"impacts", "deposited_mass", "impact_energy"};

/* The mesh's own restart does not know these properties when it reads its triangles, so they stay
 * out of it (restart_no); the fix keeps them. */
ReboundMap::ReboundMap(TriMesh *mesh) : mesh_(mesh) {
  for (int k = 0; k < N_VALUES; k++) {
    sums_[k] = mesh->prop().addElementProperty<ScalarContainer<double>>(
        NAMES[k], "comm_exchange_borders", "frame_invariant", "restart_no");
    sums_[k]->setAll(0.);
  }
}

void ReboundMap::remove() {
  for (int k = 0; k < N_VALUES; k++)
    mesh_->prop().removeElementProperty(NAMES[k]);
}

void ReboundMap::add_own(int triangle, const Values &values) {
  for (int k = 0; k < N_VALUES; k++) /* one behind the other, found without pointers to each */
    sums_[k]->begin()[triangle] += values[k];
}

void ReboundMap::fetch(int triangle) const {
  for (int k = 0; k < N_VALUES; k++)
    __builtin_prefetch(sums_[k]->begin() + triangle);
}

void ReboundMap::add(int triangle, double deposited_mass, double energy) {
  const Values values = {{1, deposited_mass, energy}};
  if (triangle < mesh_->sizeLocal()) {
    add_own(triangle, values);
    return;
  }
  Values &sum = away_.insert(std::make_pair(mesh_->id(triangle), Values())).first->second;
  for (int k = 0; k < N_VALUES; k++)
    sum[k] += values[k];
}

void ReboundMap::settle(MPI_Comm world) {
  int ranks, all = 0;
  MPI_Comm_size(world, &ranks);
  std::vector<double> mine, theirs;
  for (const std::pair<const int, Values> &entry : away_) {
    mine.push_back(entry.first);
    mine.insert(mine.end(), entry.second.begin(), entry.second.end());
  }
  away_.clear();
  const int size = static_cast<int>(mine.size());
  MPI_Allreduce(&size, &all, 1, MPI_INT, MPI_SUM, world);
  if (all == 0)
    return;
  std::vector<int> sizes(ranks), starts(ranks, 0);
  MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, world);
  std::partial_sum(sizes.begin(), sizes.end() - 1, starts.begin() + 1);
  theirs.resize(all);
  MPI_Allgatherv(mine.data(), size, MPI_DOUBLE, theirs.data(), sizes.data(), starts.data(),
                 MPI_DOUBLE, world);
  for (int at = 0; at < all; at += 1 + N_VALUES) {
    const int id = static_cast<int>(theirs[at]);
    for (int k = 0; k < mesh_->map_size(id); k++)
      if (mesh_->map(id, k) < mesh_->sizeLocal())
        add_own(mesh_->map(id, k), Values{{theirs[at + 1], theirs[at + 2], theirs[at + 3]}});
  }
}

std::vector<double> ReboundMap::gather(MPI_Comm world) {
  settle(world);
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
