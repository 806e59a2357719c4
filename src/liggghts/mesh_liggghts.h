/* A mesh of LIGGGHTS as a shape: its triangles, how it moves, belts, and what it measures (stress,
 * servo).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include <mpi.h>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "fix_mesh_surface.h"
#include "mesh_module_stress.h"
#include "dem/shapes/mesh.h"
#include "dem/wall.h"

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

  /* At the beginning of a run; collective. Throws an asperity::Error where the mesh has changed its
   * form since the first run. Returns a note for the user, or an empty string. */
  std::string setup(const asperity::Box &box);

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

  /* The velocity and the frame at the end of the last step (HEAD numbers); then, of each triangle,
   * its number and its nodes in the mesh's own frame (ROW numbers): with these a continued run
   * finds the same contacts, to the bit. */
  std::vector<double> motion_record() const override;
  void restore_motion(const std::vector<double> &record) override;
  bool measures() const override;
  bool wears() const;
  void take(const asperity::ContactLoad &load) override;

protected:
  bool runs() const override;
  void surface_velocity(int piece, const double foot[3], double v[3]) const override;

private:
  enum { HEAD = 6 + 12, ROW = 10 };
  typedef MultiVectorContainer<double, 3, 3> Nodes;
  /* A node of a triangle, by its number. */
  struct NodeName {
    int piece, node;
  };

  TriMesh *mesh() const {
    return fix_->triMesh();
  }
  MeshModuleStress *stress() const;
  void gather();
  void take(const double *rows, size_t count);
  void choose_nodes();
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
  asperity::Box box_;
  NodeName nodes_[3]; /* far from each other: they fix the position of the mesh */
  double reference_[3][3];
  double force_[3], torque_[3];             /* handed over in this step; of the next one so far */
  std::vector<std::array<double, 9>> belt_; /* velocities of the nodes, by number of the triangle */
  std::vector<asperity::ContactLoad> loads_;                   /* of this step */
  ScalarContainer<double> *sums_[asperity::Books::N_SUMS + 1]; /* the last one: depth of erosion */
};

} // namespace LAMMPS_NS
