/* A mesh of triangles from a file, at rest or moved by a formula in time: for engines that have no
 * meshes of their own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASPERITY_LAMMPS_DRIVEN_MESH_H
#define ASPERITY_LAMMPS_DRIVEN_MESH_H

#include <mpi.h>
#include <functional>
#include <memory>
#include <string>

#include "dem/shapes/mesh.h"
#include "dem/text.h"

namespace asperity {

/* A motion that is known for all times. Time counts from where it began. */
class Drive {
public:
  Drive() : kind_(REST), a_(), axis_(), period_(0) {}

  /* Reads `linear VX VY VZ`, `wiggle AX AY AZ PERIOD` or `rotate PX PY PZ AX AY AZ PERIOD`.
   * `geometry` grows by what was read. Throws an Error. */
  void parse(Words &words, std::string &geometry);

  bool moves() const {
    return kind_ != REST;
  }
  void move(double time, Frame &frame, Twist &twist) const;

private:
  enum Kind { REST, LINEAR, WIGGLE, ROTATE };
  Kind kind_;
  double a_[3];    /* velocity, amplitude, or a point of the axis */
  double axis_[3]; /* unit vector */
  double period_;
};

class DrivenMesh : public MeshShape {
public:
  /* Rank 0 reads the triangles; see MeshShape::share() for who keeps them. Collective. Throws an
   * Error. */
  DrivenMesh(MPI_Comm world, const std::string &path, double scale, const Drive &drive);

  size_t pieces() const {
    return aspi_tree_count(triangles());
  }

  /* Number of triangles and their extent, for the log. */
  std::string describe() const;

  /* At the beginning of a run, and of each step: the time of the wall's own clock. */
  void setup(double time);
  void begin_step(double time, double dt);

  /* The time at which the motion began. */
  std::vector<double> motion_record() const override;
  void restore_motion(const std::vector<double> &record) override;

private:
  ContactTree *read_tree() const;

  Drive drive_;
  std::string path_;
  double scale_;
  double origin_;
  bool has_begun_;
};

/* Calls `take` for each triangle of the file, in its order; those of several solids one after the
 * other. The normals that a file states are not used. Throws an Error that names the file, the line
 * (or, of a binary file, the triangle), what stands there, and what must. */
void read_stl(const std::string &path, const std::function<void(const ContactTriangle &)> &take);

/* Reads `FILE`, and behind it, in any order, `type T`, `scale S`, `move ...` and `map N FILE`.
 * type: the last of `types` where the words name none. */
std::unique_ptr<DrivenMesh> read_driven_mesh(MPI_Comm world, Words &words, int types, int &type,
                                             std::string &geometry);

} // namespace asperity

#endif
