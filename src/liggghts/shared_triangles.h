/* The triangles of a large mesh, shared among the ranks: each has some of them, where the others
 * can read them at any time, without its doing. So a rank needs only those in its own search that
 * its particles can meet, and can have others when one of them comes to where it has none. Where
 * MPI has no one-sided communication, each rank has them all.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_LIGGGHTS_SHARED_TRIANGLES_H
#define ASPERITY_LIGGGHTS_SHARED_TRIANGLES_H

#include <mpi.h>
#include <functional>
#include <vector>

#include "dem/shapes/bounds.h"

namespace asperity {

class SharedTriangles {
public:
  enum { ROW = 10 }; /* number of the triangle, and its nodes */

  /* Both are collective. */
  SharedTriangles(MPI_Comm world, std::vector<double> rows);
  ~SharedTriangles();
  SharedTriangles(const SharedTriangles &) = delete;
  SharedTriangles &operator=(const SharedTriangles &) = delete;

  /* True if each rank has all triangles. */
  bool is_whole() const {
    return window_ == MPI_WIN_NULL;
  }
  const Bounds &whole() const { /* around all triangles */
    return whole_;
  }

  /* Calls `take` for each row of all ranks whose box meets one of the boxes. */
  void read(const std::vector<Bounds> &boxes,
            const std::function<void(const double *)> &take) const;

private:
  bool open_window(MPI_Comm world);
  void gather(MPI_Comm world);
  const double *piece(int rank, int first, int count, std::vector<double> &copy) const;

  int rank_;
  std::vector<double> mine_;   /* rows of this rank, or of all, one rank's behind the other's */
  std::vector<int> counts_;    /* rows of each rank */
  std::vector<Bounds> places_; /* around those of each rank */
  Bounds whole_;
  MPI_Win window_;
};

/* Around the triangle of a row. */
Bounds bounds_of_row(const double row[SharedTriangles::ROW]);

} // namespace asperity

#endif
