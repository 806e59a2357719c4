/* A mesh for dump image; see mesh_image.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh_image.h"

#if __has_include("graphics.h")
#include "graphics.h"
#endif

using namespace LAMMPS_NS;

/* Codes of dump image for a triangle; they are in a header since LAMMPS draws more than three
 * kinds. */
#if __has_include("graphics.h")
static const int TRIANGLE = Graphics::TRI;
#else
static const int TRIANGLE = 2;
#endif

int MeshImage::draw(const asperity::MeshShape &mesh, int type, int rank, int ranks, int *&kinds,
                    double **&rows) {
  enum { ROW = 10 };
  const size_t all = aspi_tree_count(mesh.triangles());
  const size_t first = all * rank / ranks, count = all * (rank + 1) / ranks - first;
  kinds_.assign(count, TRIANGLE);
  numbers_.resize(count * ROW);
  rows_.resize(count);
  for (size_t i = 0; i < count; i++) {
    const int place = static_cast<int>(first + i);
    double *row = rows_[i] = &numbers_[i * ROW];
    row[0] = type;
    for (int k = 0; k < 3; k++)
      mesh.motion().end().to_world(aspi_tree_triangle(mesh.triangles(), place)->node[k],
                                   row + 1 + 3 * k);
  }
  kinds = kinds_.data();
  rows = rows_.data();
  return static_cast<int>(count);
}
