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
#include "stl_file.h"
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
    : drive_(drive), path_(path), scale_(scale), extent_(Bounds::none()), pieces_(0), origin_(0),
      has_begun_(false) {
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
  long long sizes[2] = {static_cast<long long>(wrong.size()), static_cast<long long>(pieces_)};
  MPI_Bcast(sizes, 2, MPI_LONG_LONG, 0, world);
  wrong.resize(sizes[0]);
  MPI_Bcast(&wrong[0], static_cast<int>(sizes[0]), MPI_CHAR, 0, world);
  if (!wrong.empty())
    throw Error(wrong);
  pieces_ = sizes[1];
  MPI_Bcast(&extent_, sizeof extent_, MPI_BYTE, 0, world);
  share(world, tree.release());
}

/* On rank 0. */
ContactTree *DrivenMesh::read_tree() {
  std::unique_ptr<ContactTree, void (*)(ContactTree *)> tree(aspi_tree_begin(), aspi_tree_free);
  bool good = tree != NULL;
  read_stl(path_, [&](const ContactTriangle &read) {
    ContactTriangle triangle = read;
    for (double *node : triangle.node) {
      aspi_scale(scale_, node);
      extent_.include(node);
    }
    good = good && aspi_tree_add(tree.get(), &triangle, static_cast<int>(pieces_++));
  });
  if (!good || !aspi_tree_finish(tree.get()))
    throw std::bad_alloc();
  return tree.release();
}

std::string DrivenMesh::describe() const {
  return text("stl %s: %zu triangles, ", path_.c_str(), pieces_) + extent_.describe() +
         text(" (scale %g)", scale_) +
         (each_keeps() ? "; MPI shares no memory here, so each rank keeps a copy" : "");
}

static double longest_side(const Bounds &b) {
  return std::max(std::max(b.hi[0] - b.lo[0], b.hi[1] - b.lo[1]), b.hi[2] - b.lo[2]);
}

/* Between common units of length that a mesh may be in: mm, um, m, cm and nm. */
static const double SCALES[] = {1e-3, 1e-6, 1e3, 1e6, 1e-2, 1e2, 1e-9, 1e9};

/* A mesh may stand out of its box by this part of it, and is far too large, or too small to be what
 * was meant, from this many times its size. */
static const double STANDS_OUT = 0.1, SIZES_APART = 100;

/* The first of the scales that brings a mesh into the box; 0: none does. */
static double fitting(const Bounds &mesh, const Bounds &box) {
  Bounds room = box;
  room.widen(STANDS_OUT * longest_side(box));
  for (double by : SCALES) {
    Bounds scaled = mesh;
    for (int d = 0; d < 3; d++) {
      scaled.lo[d] *= by;
      scaled.hi[d] *= by;
    }
    if (room.has(scaled) && SIZES_APART * longest_side(scaled) > longest_side(box))
      return by;
  }
  return 0;
}

std::string DrivenMesh::misfit(const Bounds &box, const double period[3]) const {
  Bounds images = box;
  for (int d = 0; d < 3; d++)
    if (period[d] > 0) {
      images.lo[d] = -HUGE_VAL;
      images.hi[d] = HUGE_VAL;
    }
  const bool outside = !drive_.moves() && !extent_.meets(images);
  const double times = longest_side(extent_) / longest_side(box);
  if (!outside && !(times > SIZES_APART))
    return "";
  const double by = fitting(extent_, box);
  return describe() +
         (outside ? ": it lies outside of the box, "
                  : text(": it is %.3g times as large as the box, ", times)) +
         box.describe() +
         (by > 0 ? text("; 'scale %g' would bring it in", by * scale_)
                 : "; no scale between m, cm, mm, um and nm would bring it in");
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
