/* A mesh from a file that moves by a formula; see driven_mesh.h. The motions are those of LAMMPS's
 * `fix move`: linear x = V t, wiggle x = A sin(2 pi t/PERIOD), rotate by 2 pi t/PERIOD about the
 * axis A through P by the right-hand rule.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "driven_mesh.h"

#include <cmath>
#include <algorithm>

#include "asperity.h"
#include "contact/vector.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

/* ---- motions ----------------------------------------------------------------------------------
 */

void Drive::parse(Words &words, std::string &geometry) {
  const std::string name = words.word("the value of 'move'");
  if (name != "linear" && name != "wiggle" && name != "rotate")
    throw Error("move is '" + name + "'; it must be linear, wiggle or rotate");
  kind_ = name == "linear" ? LINEAR : name == "wiggle" ? WIGGLE : ROTATE;
  const std::string what = "a number of 'move " + name + "'";
  geometry += " move " + name;
  for (double *group : {a_, axis_})
    for (int d = 0; d < 3 && (group == a_ || kind_ == ROTATE); d++) {
      group[d] = words.number(what.c_str());
      if (!std::isfinite(group[d]))
        throw Error(what + text(" is %g; it must be finite", group[d]));
      geometry += " " + setting(group[d]);
    }
  if (kind_ == ROTATE) {
    const double length = aspi_length(axis_);
    if (!(length > 0))
      throw Error("the axis of 'move rotate' is 0 0 0; it must have a direction");
    aspi_scale(1 / length, axis_);
  }
  if (kind_ == LINEAR)
    return;
  period_ = words.number("the period of 'move'");
  if (!(period_ > 0) || !std::isfinite(period_))
    throw Error(
        text("the period of 'move %s' is %g; it must be a finite time > 0", name.c_str(), period_));
  geometry += " " + setting(period_);
}

void Drive::move(double time, Frame &frame, Twist &twist) const {
  const double rate = kind_ == LINEAR ? 1 : 2 * ASP_PI / period_, phase = rate * time;
  frame = kind_ == ROTATE ? turn_about(a_, axis_, phase) : Frame();
  twist = kind_ == ROTATE ? twist_about(a_, axis_, rate) : Twist();
  if (kind_ == ROTATE)
    return;
  aspi_add_scaled(frame.shift, kind_ == LINEAR ? time : sin(phase), a_, frame.shift);
  aspi_add_scaled(twist.linear, kind_ == LINEAR ? 1 : rate * cos(phase), a_, twist.linear);
}

/* ---- the mesh ---------------------------------------------------------------------------------
 */

DrivenMesh::DrivenMesh(MPI_Comm world, const std::string &path, double scale, const Drive &drive)
    : drive_(drive), path_(path), scale_(scale), origin_(0), has_begun_(false) {
  std::unique_ptr<ContactTree, void (*)(ContactTree *)> tree(NULL, aspi_tree_free);
  std::string wrong;
  int rank;
  MPI_Comm_rank(world, &rank);
  if (rank == 0)
    try {
      tree.reset(read_tree());
    } catch (const std::exception &error) {
      wrong = message_of(error);
    }
  wrong = asperity::share(wrong, world);
  if (!wrong.empty())
    throw Error(wrong);
  share(world, tree.release());
}

/* On rank 0. */
ContactTree *DrivenMesh::read_tree() const {
  std::unique_ptr<ContactTree, void (*)(ContactTree *)> tree(aspi_tree_begin(), aspi_tree_free);
  bool good = tree != NULL;
  int pieces = 0;
  read_stl(path_, [&](const ContactTriangle &read) {
    ContactTriangle triangle = read;
    for (double *node : triangle.node)
      aspi_scale(scale_, node);
    good = good && aspi_tree_add(tree.get(), &triangle, pieces++);
  });
  if (!good || !aspi_tree_finish(tree.get()))
    throw std::bad_alloc();
  return tree.release();
}

std::string DrivenMesh::describe() const {
  Bounds extent = Bounds::none();
  for (size_t place = 0; place < pieces(); place++)
    for (const double *node : aspi_tree_triangle(triangles(), static_cast<int>(place))->node)
      extent.include(node);
  return text("stl %s: %zu triangles, ", path_.c_str(), pieces()) + extent.describe() +
         text(" (scale %g)", scale_) +
         (each_keeps() ? "; MPI shares no memory here, so each rank keeps a copy" : "");
}

void DrivenMesh::setup(double time) {
  if (!drive_.moves())
    return;
  if (!has_begun_)
    origin_ = time;
  Frame frame;
  Twist twist;
  drive_.move(time - origin_, frame, twist);
  motion().settle(frame, false);
  motion().set_last(twist);
  has_begun_ = true;
}

void DrivenMesh::begin_step(double time, double dt) {
  if (!drive_.moves())
    return;
  Frame frame;
  Twist twist;
  drive_.move(time - origin_, frame, twist);
  motion().advance(frame, twist, dt);
}

std::vector<double> DrivenMesh::motion_record() const {
  return has_begun_ ? std::vector<double>(1, origin_) : std::vector<double>();
}

void DrivenMesh::restore_motion(const std::vector<double> &record) {
  if (record.empty())
    return;
  origin_ = record[0];
  has_begun_ = true;
}

std::unique_ptr<DrivenMesh> asperity::read_driven_mesh(MPI_Comm world, Words &words, int types,
                                                       int &type, std::string &geometry) {
  const std::string path = words.word("the file of 'stl'");
  double scale = 1;
  std::string motion;
  Drive drive;
  type = types;
  for (bool more = true; more;) {
    if (words.take("type"))
      type = static_cast<int>(words.whole("the wall's type", 1, types));
    else if (words.take("scale")) {
      scale = words.number("scale");
      if (!(scale > 0) || !std::isfinite(scale))
        throw Error(text("scale is %g; it must be a finite number > 0", scale));
    } else if (words.take("move")) {
      motion.clear();
      drive.parse(words, motion);
    } else
      more = false;
  }
  geometry = "stl " + path + " scale " + setting(scale) + motion + text(" type %d", type);
  return std::unique_ptr<DrivenMesh>(new DrivenMesh(world, path, scale, drive));
}
