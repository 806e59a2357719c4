/* What the triangles of one mesh have taken: impacts, deposited mass, and impact energy, as element
 * properties of the mesh (`impacts`, `deposited_mass`, `impact_energy`) for `dump mesh/vtk`. Within
 * a step they gather in a property that LIGGGHTS adds up over ghost triangles (comm_reverse) and
 * clears.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_REBOUND_MAP_H
#define LMP_REBOUND_MAP_H

#include <mpi.h>
#include <vector>

#include "container.h"
#include "tri_mesh.h"

namespace LAMMPS_NS {

class ReboundMap {
public:
  enum { IMPACTS, MASS, ENERGY, N_VALUES };

  explicit ReboundMap(TriMesh *mesh);

  /* Takes the properties off the mesh again; not in the destructor, for the mesh may be gone by
   * then. */
  void remove();

  /* One impact on a local or ghost triangle. */
  void add(int triangle, double deposited_mass, double energy);

  /* At the end of a step, after the mesh has added up its ghosts, on `ranks` ranks. */
  void end_step(int ranks);

  /* All values by triangle id, N_VALUES each, on rank 0; collective. */
  std::vector<double> gather(MPI_Comm world);

  /* Sets the triangles of this rank from such a list. */
  void scatter(const std::vector<double> &values);

private:
  TriMesh *mesh_;
  bool touched_; /* by this rank, in this step */
  VectorContainer<double, 3> *step_;
  ScalarContainer<double> *sums_[N_VALUES];
};

} // namespace LAMMPS_NS

#endif
