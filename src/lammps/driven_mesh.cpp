/* A mesh from a file that moves by a formula; see driven_mesh.h. The motions are those of LAMMPS's
 * `fix move`: linear x = V t, wiggle x = A sin(2 pi t/PERIOD), rotate by 2 pi t/PERIOD about the
 * axis A through P by the right-hand rule, variable by displacements and velocities.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "driven_mesh.h"

#include <cmath>
#include <algorithm>

#include "asperity.h"
#include "base/units.h"
#include "contact/stl.h"
#include "contact/vector.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace asperity;

/* ---- places ---- */

static void read_finite(Words &words, const std::string &what, double *to, int count,
                        std::string &said) {
  for (int d = 0; d < count; d++) {
    to[d] = words.number(what.c_str());
    if (!std::isfinite(to[d]))
      throw Error(what + text(" is %g; it must be finite", to[d]));
    said += " " + setting(to[d]);
  }
}

static void make_unit(const char *what, double axis[3]) {
  const double length = aspi_length(axis);
  if (!(length > 0))
    throw Error(text("the axis of '%s' is 0 0 0; it must have a direction", what));
  aspi_scale(1 / length, axis);
}

bool Placing::take(Words &next) {
  static const double ORIGIN[3] = {0, 0, 0};
  double by[4];
  if (next.take("scale")) {
    by[0] = next.number("scale");
    if (!(by[0] > 0) || !std::isfinite(by[0]))
      throw Error(text("scale is %g; it must be a finite number > 0", by[0]));
    scale *= by[0];
    aspi_scale(by[0], frame.shift);
    words += " scale " + setting(by[0]);
  } else if (next.take("shift")) {
    words += " shift";
    read_finite(next, "a number of 'shift'", by, 3, words);
    aspi_add_scaled(frame.shift, 1, by, frame.shift);
  } else if (next.take("turn")) {
    words += " turn";
    read_finite(next, "a number of 'turn'", by, 4, words);
    make_unit("turn", by);
    const Frame turn = turn_about(ORIGIN, by, aspi_radians(by[3])), before = frame;
    for (int column = 0; column < 3; column++) {
      double from[3], to[3];
      for (int d = 0; d < 3; d++)
        from[d] = before.turn[d][column];
      turn.to_world_direction(from, to);
      for (int d = 0; d < 3; d++)
        frame.turn[d][column] = to[d];
    }
    turn.to_world_direction(before.shift, frame.shift);
  } else
    return false;
  return true;
}

/* ---- motions ---- */

void Drive::parse(Words &words, std::string &geometry) {
  const std::string name = words.word("the value of 'move'");
  if (name == "variable")
    return parse_variables(words, geometry);
  if (name != "linear" && name != "wiggle" && name != "rotate")
    throw Error("move is '" + name + "'; it must be linear, wiggle, rotate or variable");
  kind_ = name == "linear" ? LINEAR : name == "wiggle" ? WIGGLE : ROTATE;
  const std::string what = "a number of 'move " + name + "'";
  geometry += " move " + name;
  read_finite(words, what, a_, 3, geometry);
  if (kind_ == ROTATE) {
    read_finite(words, what, axis_, 3, geometry);
    make_unit("move rotate", axis_);
  }
  if (kind_ == LINEAR)
    return;
  period_ = words.number("the period of 'move'");
  if (!(period_ > 0) || !std::isfinite(period_))
    throw Error(
        text("the period of 'move %s' is %g; it must be a finite time > 0", name.c_str(), period_));
  geometry += " " + setting(period_);
}

/* Of each direction both variables, so that the velocity is exact, or NULL. */
void Drive::parse_variables(Words &words, std::string &geometry) {
  kind_ = VARIABLE;
  geometry += " move variable";
  for (int k = 0; k < 6; k++) {
    const std::string word = words.word("a variable of 'move variable'");
    geometry += " " + word;
    if (word.compare(0, 2, "v_") != 0 && word != "NULL")
      throw Error("a variable of 'move' is '" + word +
                  "'; it must be v_NAME of an equal-style variable, or NULL");
    names_[k] = word == "NULL" ? "" : word.substr(2);
    if (k >= 3 && names_[k].empty() != names_[k - 3].empty())
      throw Error(text("'move variable' has a displacement or a velocity along %c alone; it must "
                       "have both, or NULL twice",
                       "xyz"[k - 3]));
  }
}

void Drive::move(double time, Frame &frame, Twist &twist) const {
  if (kind_ == VARIABLE) {
    frame = Frame();
    twist = Twist();
    for (int k = 0; k < 6; k++)
      if (!names_[k].empty())
        (k < 3 ? frame.shift : twist.linear)[k % 3] = variables_(names_[k]);
    return;
  }
  const double rate = kind_ == LINEAR ? 1 : 2 * ASP_PI / period_, phase = rate * time;
  frame = kind_ == ROTATE ? turn_about(a_, axis_, phase) : Frame();
  twist = kind_ == ROTATE ? twist_about(a_, axis_, rate) : Twist();
  if (kind_ == ROTATE)
    return;
  aspi_add_scaled(frame.shift, kind_ == LINEAR ? time : sin(phase), a_, frame.shift);
  aspi_add_scaled(twist.linear, kind_ == LINEAR ? 1 : rate * cos(phase), a_, twist.linear);
}

/* ---- the mesh ---- */

DrivenMesh::DrivenMesh(MPI_Comm world, const std::string &path, const Placing &placing,
                       const Drive &drive)
    : drive_(drive), path_(path), placing_(placing), origin_(0), has_begun_(false) {
  struct Adder {
    const Placing &placing;
    ContactTree *tree;
    int pieces;
  };
  build(world, [this](ContactTree *tree) {
    Adder adder = {placing_, tree, 0};
    const auto take = [](void *to, const ContactTriangle *read) {
      Adder &a = *static_cast<Adder *>(to);
      ContactTriangle triangle = *read;
      for (double *node : triangle.node) {
        aspi_scale(a.placing.scale, node);
        a.placing.frame.to_world(node, node);
      }
      return aspi_tree_add(a.tree, &triangle, a.pieces++);
    };
    asp_error error;
    if (aspi_stl_read(path_.c_str(), take, &adder, &error))
      throw_error(error);
    return true;
  });
}

std::string DrivenMesh::describe() const {
  Bounds extent = Bounds::none();
  for (size_t place = 0; place < pieces(); place++)
    for (const double *node : aspi_tree_triangle(triangles(), static_cast<int>(place))->node)
      extent.include(node);
  return text("stl %s: %zu triangles, ", path_.c_str(), pieces()) + extent.describe() +
         text(" (scale %g)", placing_.scale) +
         (each_keeps() ? "; MPI shares no memory here, so each rank keeps a copy" : "");
}

double DrivenMesh::setup(double time) {
  if (!drive_.moves())
    return 0;
  if (!has_begun_)
    origin_ = time;
  Frame frame;
  Twist twist;
  double off[3] = {0, 0, 0};
  drive_.move(time - origin_, frame, twist);
  if (has_begun_)
    aspi_subtract(frame.shift, motion().end().shift, off);
  motion().settle(frame, false);
  motion().set_last(twist);
  has_begun_ = true;
  return aspi_length(off);
}

void DrivenMesh::begin_step(double time, double dt) {
  if (!drive_.moves())
    return;
  Frame frame;
  Twist twist;
  drive_.move(time - origin_, frame, twist);
  check_turn("stl", path_.c_str(), aspi_length(twist.angular) * dt);
  motion().advance(frame, twist, dt);
}

std::vector<double> DrivenMesh::motion_record() const {
  const double *shift = motion().end().shift;
  return has_begun_ ? std::vector<double>{origin_, shift[0], shift[1], shift[2]}
                    : std::vector<double>();
}

void DrivenMesh::restore_motion(const std::vector<double> &record) {
  if (record.size() != 4)
    return;
  Frame frame;
  origin_ = record[0];
  aspi_copy(&record[1], frame.shift);
  motion().settle(frame, false);
  has_begun_ = true;
}

std::unique_ptr<DrivenMesh> asperity::read_driven_mesh(MPI_Comm world, Words &words, int types,
                                                       int &type, std::string &geometry,
                                                       const Drive::Variables &variables) {
  const std::string path = words.word("the file of 'stl'");
  Placing placing;
  std::string motion;
  Drive drive(variables);
  type = types;
  for (bool more = true; more;) {
    if (words.take("type"))
      type = static_cast<int>(words.whole("the wall's type", 1, types));
    else if (words.take("move")) {
      motion.clear();
      drive = Drive(variables);
      drive.parse(words, motion);
    } else
      more = placing.take(words);
  }
  geometry = "stl " + path + (placing.words.empty() ? " scale 1" : placing.words) + motion +
             text(" type %d", type);
  return std::unique_ptr<DrivenMesh>(new DrivenMesh(world, path, placing, drive));
}
