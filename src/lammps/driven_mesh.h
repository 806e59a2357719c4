/* A mesh of triangles from a file, at rest or moved by a formula in time: for engines that have no
 * meshes of their own.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

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
  /* The value of an equal-style variable now; throws an Error. */
  typedef std::function<double(const std::string &name)> Variables;

  explicit Drive(const Variables &variables)
      : kind_(REST), a_(), axis_(), period_(0), variables_(variables) {}

  /* Reads `linear VX VY VZ`, `wiggle AX AY AZ PERIOD`, `rotate PX PY PZ AX AY AZ PERIOD` or
   * `variable v_DX v_DY v_DZ v_VX v_VY v_VZ`. `geometry` grows by what was read. Throws an Error.
   */
  void parse(Words &words, std::string &geometry);

  bool moves() const {
    return kind_ != REST;
  }
  void move(double time, Frame &frame, Twist &twist) const;

private:
  enum Kind { REST, LINEAR, WIGGLE, ROTATE, VARIABLE };

  void parse_variables(Words &words, std::string &geometry);

  Kind kind_;
  double a_[3];    /* velocity, amplitude, or a point of the axis */
  double axis_[3]; /* unit vector */
  double period_;
  Variables variables_;
  std::string names_[6]; /* of displacements and velocities, "" for 0 */
};

/* Where the triangles of a file are put: x becomes turn * (scale * x) + shift. */
struct Placing {
  double scale;
  Frame frame;
  std::string words;

  Placing() : scale(1) {}

  /* Takes the next of `scale S`, `shift X Y Z` and `turn X Y Z DEGREES`, about an axis through the
   * origin, which acts behind those before it; false if it is none of them. Throws an Error. */
  bool take(Words &next);
};

class DrivenMesh : public MeshShape {
public:
  /* Rank 0 reads the triangles; see NodeTree for who keeps them. Collective. Throws an Error. */
  DrivenMesh(MPI_Comm world, const std::string &path, const Placing &placing, const Drive &drive);

  size_t pieces() const {
    return aspi_tree_count(triangles());
  }

  /* Number of triangles and their extent, for the log. */
  std::string describe() const;

  /* At the beginning of a run, and of each step: the time of the wall's own clock. setup: how far
   * it stands from where the last step has left it. */
  double setup(double time);
  void begin_step(double time, double dt);

  /* The time at which the motion began, and the shift by now. */
  std::vector<double> motion_record() const override;
  void restore_motion(const std::vector<double> &record) override;

private:
  Drive drive_;
  std::string path_;
  Placing placing_;
  double origin_;
  bool has_begun_;
};

/* Reads `FILE`, and behind it, in any order, `type T`, `move ...` and what places it. type: the
 * last of `types` where the words name none. */
std::unique_ptr<DrivenMesh> read_driven_mesh(MPI_Comm world, Words &words, int types, int &type,
                                             std::string &geometry,
                                             const Drive::Variables &variables);

} // namespace asperity
