/* Functions that are the same for all engines; see engine.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/engine.h"

#include <math.h>
#include <algorithm>

#include "asperity.h"

using namespace asperity;

std::vector<Engine::Kind> asperity::kinds_of(const Spheres &spheres, int group,
                                             const std::vector<double> &present, MPI_Comm world) {
  const size_t n = present.size();
  /* For each type: whether it has particles, their largest density, and minus their least. */
  std::vector<double> mine(3 * n, -HUGE_VAL), all(3 * n);
  for (size_t t = 0; t < n; t++)
    mine[3 * t] = present[t];
  for (int i = 0; i < spheres.n; i++) {
    if (!(spheres.mask[i] & group))
      continue;
    double *of = &mine[3 * static_cast<size_t>(spheres.type[i] - 1)];
    const double r = spheres.radius[i], density = spheres.mass[i] / (4 * ASP_PI / 3 * r * r * r);
    of[0] = 1;
    of[1] = std::max(of[1], density);
    of[2] = std::max(of[2], -density);
  }
  MPI_Allreduce(mine.data(), all.data(), static_cast<int>(3 * n), MPI_DOUBLE, MPI_MAX, world);
  std::vector<Engine::Kind> kinds;
  for (size_t t = 0; t < n; t++) {
    const bool here = all[3 * t + 1] > 0;
    kinds.push_back(
        Engine::Kind{all[3 * t] > 0, here ? -all[3 * t + 2] : 0, here ? all[3 * t + 1] : 0});
  }
  return kinds;
}

/* Of the functions for this a LAMMPS without MPI has MPI_Gather only, so that rows are filled up.
 */
std::vector<double> asperity::gather(const std::vector<double> &mine, MPI_Comm world) {
  int ranks, rank, count = static_cast<int>(mine.size()), most;
  MPI_Comm_size(world, &ranks);
  MPI_Comm_rank(world, &rank);
  MPI_Allreduce(&count, &most, 1, MPI_INT, MPI_MAX, world);
  const size_t width = static_cast<size_t>(most) + 1;
  std::vector<double> row(width), rows(rank == 0 ? width * static_cast<size_t>(ranks) : 0), all;
  row[0] = count;
  std::copy(mine.begin(), mine.end(), row.begin() + 1);
  MPI_Gather(row.data(), most + 1, MPI_DOUBLE, rows.data(), most + 1, MPI_DOUBLE, 0, world);
  for (size_t at = 0; at < rows.size(); at += width) {
    const double *from = &rows[at];
    all.insert(all.end(), from + 1, from + 1 + static_cast<size_t>(*from));
  }
  return all;
}

std::vector<double> asperity::gather_for_all(const std::vector<double> &mine, MPI_Comm world) {
  std::vector<double> all = gather(mine, world);
  int count = static_cast<int>(all.size());
  MPI_Bcast(&count, 1, MPI_INT, 0, world);
  all.resize(static_cast<size_t>(count));
  MPI_Bcast(all.data(), count, MPI_DOUBLE, 0, world);
  return all;
}
