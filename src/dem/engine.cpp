/* Functions that are the same for all engines; see engine.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/engine.h"

#include <algorithm>

#include "asperity_engine.h"
#include "dem/text.h"

using namespace asperity;

Bounds Bounds::of_path(const double x[3], const double v[3], double from, double to,
                       double radius) {
  Bounds box;
  for (int d = 0; d < 3; d++) {
    const double a = x[d] + v[d] * from, b = x[d] + v[d] * to;
    box.lo[d] = std::min(a, b) - radius;
    box.hi[d] = std::max(a, b) + radius;
  }
  return box;
}

std::string Bounds::describe() const {
  return text("x %.6g to %.6g, y %.6g to %.6g, z %.6g to %.6g", lo[0], hi[0], lo[1], hi[1], lo[2],
              hi[2]);
}

void asperity::add_diameters(const Spheres &spheres, int group, MPI_Comm world, double &least,
                             double &most) {
  double mine[2] = {most > 0 ? -least : -HUGE_VAL, most}, all[2];
  for (int i = 0; i < spheres.n; i++) {
    if (!(spheres.mask[i] & group))
      continue;
    mine[0] = std::max(mine[0], -2 * spheres.radius[i]);
    mine[1] = std::max(mine[1], 2 * spheres.radius[i]);
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_MAX, world);
  least = all[1] > 0 ? -all[0] : 0;
  most = all[1];
}

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

/* Bytes a message, and the tag of these messages. */
static const size_t MESSAGE = 1 << 24;
static const int TAG = 7301;

template <class Item>
std::vector<Item> asperity::gather(const std::vector<Item> &mine, MPI_Comm world) {
  int ranks, rank;
  MPI_Comm_size(world, &ranks);
  MPI_Comm_rank(world, &rank);
  long long count = static_cast<long long>(mine.size());
  std::vector<long long> counts(static_cast<size_t>(ranks));
  MPI_Gather(&count, 1, MPI_LONG_LONG, counts.data(), 1, MPI_LONG_LONG, 0, world);
  const auto bytes = [](size_t left) {
    return static_cast<int>(std::min(left, MESSAGE / sizeof(Item)) * sizeof(Item));
  };
  if (rank > 0) {
    for (size_t at = 0; at < mine.size(); at += MESSAGE / sizeof(Item))
      MPI_Send(&mine[at], bytes(mine.size() - at), MPI_BYTE, 0, TAG, world);
    return std::vector<Item>();
  }
  std::vector<Item> all(mine);
  for (int from = 1; from < ranks; from++) {
    size_t at = all.size();
    all.resize(at + static_cast<size_t>(counts[static_cast<size_t>(from)]));
    for (; at < all.size(); at += MESSAGE / sizeof(Item))
      MPI_Recv(&all[at], bytes(all.size() - at), MPI_BYTE, from, TAG, world, MPI_STATUS_IGNORE);
  }
  return all;
}
template std::vector<double> asperity::gather(const std::vector<double> &, MPI_Comm);
template std::vector<char> asperity::gather(const std::vector<char> &, MPI_Comm);

std::vector<double> asperity::gather_for_all(const std::vector<double> &mine, MPI_Comm world) {
  std::vector<double> all = gather(mine, world);
  int count = static_cast<int>(all.size());
  MPI_Bcast(&count, 1, MPI_INT, 0, world);
  all.resize(static_cast<size_t>(count));
  MPI_Bcast(all.data(), count, MPI_DOUBLE, 0, world);
  return all;
}

std::string asperity::share(std::string text, MPI_Comm world) {
  unsigned long long length = text.size();
  MPI_Bcast(&length, 1, MPI_UNSIGNED_LONG_LONG, 0, world);
  text.resize(static_cast<size_t>(length));
  MPI_Bcast(&text[0], static_cast<int>(length), MPI_CHAR, 0, world);
  return text;
}
