/* Triangles shared among ranks; see shared_triangles.h. A rank reads those of another one by
 * one-sided communication (MPI_Get).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "shared_triangles.h"

#include <algorithm>

using namespace asperity;

/* Rows per read. */
static const int PIECE = 2048;

Bounds asperity::bounds_of_row(const double row[SharedTriangles::ROW]) {
  Bounds box = Bounds::none();
  for (int k = 0; k < 3; k++)
    box.include(row + 1 + 3 * k);
  return box;
}

SharedTriangles::SharedTriangles(MPI_Comm world, std::vector<double> rows)
    : rank_(0), mine_(std::move(rows)), whole_(Bounds::none()), window_(MPI_WIN_NULL) {
  int ranks;
  MPI_Comm_size(world, &ranks);
  MPI_Comm_rank(world, &rank_);
  counts_.resize(ranks);
  places_.resize(ranks);
  const int count = static_cast<int>(mine_.size() / ROW);
  Bounds place = Bounds::none();
  for (int i = 0; i < count; i++)
    place.include(bounds_of_row(&mine_[static_cast<size_t>(i) * ROW]));
  MPI_Allgather(&count, 1, MPI_INT, counts_.data(), 1, MPI_INT, world);
  MPI_Allgather(&place, sizeof place, MPI_BYTE, places_.data(), sizeof place, MPI_BYTE, world);
  for (const Bounds &each : places_)
    whole_.include(each);
  if (ranks > 1 && !open_window(world))
    gather(world);
}

/* False, on all ranks, where MPI refuses: Open MPI without a transport for it does. */
bool SharedTriangles::open_window(MPI_Comm world) {
  MPI_Errhandler handler;
  MPI_Comm_get_errhandler(world, &handler);
  MPI_Comm_set_errhandler(world, MPI_ERRORS_RETURN);
  int good = MPI_Win_create(mine_.data(), static_cast<MPI_Aint>(mine_.size() * sizeof(double)),
                            sizeof(double), MPI_INFO_NULL, world, &window_) == MPI_SUCCESS;
  MPI_Comm_set_errhandler(world, handler);
  MPI_Errhandler_free(&handler);
  int all;
  MPI_Allreduce(&good, &all, 1, MPI_INT, MPI_MIN, world);
  if (!all)
    window_ = MPI_WIN_NULL;
  return all;
}

void SharedTriangles::gather(MPI_Comm world) {
  MPI_Datatype row;
  MPI_Type_contiguous(ROW, MPI_DOUBLE, &row);
  MPI_Type_commit(&row);
  std::vector<int> first(counts_.size(), 0);
  for (size_t rank = 1; rank < counts_.size(); rank++)
    first[rank] = first[rank - 1] + counts_[rank - 1];
  std::vector<double> all(static_cast<size_t>(first.back() + counts_.back()) * ROW);
  MPI_Allgatherv(mine_.data(), counts_[rank_], row, all.data(), counts_.data(), first.data(), row,
                 world);
  MPI_Type_free(&row);
  mine_.swap(all);
  counts_.assign(1, static_cast<int>(mine_.size() / ROW));
  places_.assign(1, whole_);
  rank_ = 0;
}

SharedTriangles::~SharedTriangles() {
  if (window_ != MPI_WIN_NULL)
    MPI_Win_free(&window_);
}

/* Rows of a rank: its own, or copies. */
const double *SharedTriangles::piece(int rank, int first, int count,
                                     std::vector<double> &copy) const {
  const size_t at = static_cast<size_t>(first) * ROW;
  if (rank == rank_)
    return &mine_[at];
  MPI_Win_lock(MPI_LOCK_SHARED, rank, 0, window_);
  MPI_Get(copy.data(), count * ROW, MPI_DOUBLE, rank, static_cast<MPI_Aint>(at), count * ROW,
          MPI_DOUBLE, window_);
  MPI_Win_unlock(rank, window_);
  return copy.data();
}

void SharedTriangles::read(const std::vector<Bounds> &boxes,
                           const std::function<void(const double *)> &take) const {
  std::vector<double> copy(static_cast<size_t>(PIECE) * ROW);
  const auto met = [&boxes](const Bounds &box) {
    for (const Bounds &each : boxes)
      if (each.meets(box))
        return true;
    return false;
  };
  for (size_t rank = 0; rank < counts_.size(); rank++)
    for (int first = 0; met(places_[rank]) && first < counts_[rank]; first += PIECE) {
      const int count = std::min(PIECE, counts_[rank] - first);
      const double *rows = piece(static_cast<int>(rank), first, count, copy);
      for (int i = 0; i < count; i++)
        if (met(bounds_of_row(rows + static_cast<size_t>(i) * ROW)))
          take(rows + static_cast<size_t>(i) * ROW);
    }
}
