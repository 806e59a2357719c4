/* What the triangles of one mesh have taken: impacts, deposited mass, and impact energy, as element
 * properties of the mesh (`impacts`, `deposited_mass`, `impact_energy`) for `dump mesh/vtk`. What
 * the ghosts of another rank's triangles take is noted by triangle id, and handed over when
 * somebody is about to read: LIGGGHTS's own way (comm_reverse) would clear, send and add up in
 * every step.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_REBOUND_MAP_H
#define LMP_REBOUND_MAP_H

#include <mpi.h>
#include <array>
#include <map>
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

  /* Asks for what add() will write to. */
  void fetch(int triangle) const;

  /* One impact on a local or ghost triangle. */
  void add(int triangle, double deposited_mass, double energy);

  /* Hands over what ghosts have taken; collective, before the properties are read. */
  void settle(MPI_Comm world);

  /* All values by triangle id, N_VALUES each, on rank 0; collective. */
  std::vector<double> gather(MPI_Comm world);

  /* Sets the triangles of this rank from such a list. */
  void scatter(const std::vector<double> &values);

private:
  typedef std::array<double, N_VALUES> Values;

  void add_own(int triangle, const Values &values);

  TriMesh *mesh_;
  ScalarContainer<double> *sums_[N_VALUES];
  std::map<int, Values> away_; /* by id of the triangle */
};

} // namespace LAMMPS_NS

#endif
