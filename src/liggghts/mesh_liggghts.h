/* A mesh of LIGGGHTS as a shape: its triangles, how it moves, belts, and what it measures (stress,
 * servo).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef LMP_MESH_LIGGGHTS_H
#define LMP_MESH_LIGGGHTS_H

#include <mpi.h>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "fix_mesh_surface.h"
#include "mesh_module_stress.h"
#include "dem/shapes/mesh.h"
#include "dem/wall.h"
#include "shared_triangles.h"

namespace LAMMPS_NS {

class MeshOfLiggghts : public asperity::MeshShape {
public:
  MeshOfLiggghts(MPI_Comm world, FixMeshSurface *fix);

  FixMeshSurface *fix() const {
    return fix_;
  }
  /* Numbers of triangles are below this. */
  size_t pieces() const {
    return pieces_;
  }

  /* At the beginning of a run, with the box around this rank's particles; collective. Throws an
   * asperity::Error where the mesh has changed its form since the first run. Returns a note for
   * the user, or an empty string. */
  std::string setup(const asperity::Bounds &here, const asperity::Box &box);

  /* In each step, when the mesh is where it is at the end of it; collective. Throws an
   * asperity::Error where LIGGGHTS tears a turning mesh at a periodic edge. */
  void begin_step(double dt);

  /* Hands over what the mesh has felt in this step, when LIGGGHTS has cleared its own sums;
   * collective. */
  void hand_over(double dt);

  /* worn_density: of a wall with erosion, else 0. Writes sums of pieces from `first` on
   * (asperity::Books::N_SUMS each) where `dump mesh/vtk` finds them. */
  void show(size_t first, const std::vector<double> &sums, double worn_density);
  void remove_sums();

  std::vector<double> motion_record() const override;
  void restore_motion(const std::vector<double> &record) override;
  bool measures() const override;
  bool wears() const;
  void take(const asperity::ContactLoad &load) override;

protected:
  bool has_all() const override;
  bool has(const asperity::Bounds &box) const override;
  asperity::Bounds whole() const override;
  void fetch(const asperity::Bounds &box) const override;
  bool runs() const override;
  void surface_velocity(int piece, const double foot[3], double v[3]) const override;

private:
  typedef MultiVectorContainer<double, 3, 3> Nodes;
  /* A node of a triangle, by its number. */
  struct NodeName {
    int piece, node;
  };

  TriMesh *mesh() const {
    return fix_->triMesh();
  }
  MeshModuleStress *stress() const;
  void gather(const asperity::Bounds &here);
  void take(std::vector<double> mine);
  void add_fetched(asperity::Bounds box) const;
  void put_fetched() const;
  void choose_nodes(const std::vector<double> &mine);
  void unwrap(double x[3][3], const double v[3][3], double dt) const;
  asperity::Frame look(asperity::Twist &twist, double dt) const;
  void check_form() const;
  void read_belt();
  void add_sums();
  void give_away(const std::vector<double> &away);
  void add_force(int local, const double force[3]);

  MPI_Comm world_;
  FixMeshSurface *fix_;
  bool is_servo_;
  size_t pieces_;
  std::unique_ptr<asperity::SharedTriangles> shared_; /* of a large mesh on several ranks */
  std::string report_;                                /* for the log */
  mutable std::vector<asperity::Bounds> fetched_; /* of which this rank has the triangles then */
  asperity::Box box_;
  NodeName nodes_[3]; /* far from each other: they fix the position of the mesh */
  double reference_[3][3];
  double force_[3], torque_[3];             /* handed over in this step; of the next one so far */
  std::vector<std::array<double, 9>> belt_; /* velocities of the nodes, by number of the triangle */
  std::vector<asperity::ContactLoad> loads_;                   /* of this step */
  ScalarContainer<double> *sums_[asperity::Books::N_SUMS + 1]; /* the last one: depth of erosion */
};

} // namespace LAMMPS_NS

#endif
