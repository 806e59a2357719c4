/* A mesh for LAMMPS's dump image: rows of the type and the corners of each triangle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_MESH_IMAGE_H
#define LMP_MESH_IMAGE_H

#include <vector>

#include "dem/shapes/mesh.h"

namespace LAMMPS_NS {

class MeshImage {
public:
  /* This rank's share of the triangles, where they are now: how many, with what Fix::image() gives.
   * Valid until the next call. */
  int draw(const asperity::MeshShape &mesh, int type, int rank, int ranks, int *&kinds,
           double **&rows);

private:
  std::vector<int> kinds_;
  std::vector<double> numbers_;
  std::vector<double *> rows_;
};

} // namespace LAMMPS_NS

#endif
