/* A mesh of LIGGGHTS as a shape; see mesh_liggghts.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "mesh_liggghts.h"

#include <math.h>
#include <string.h>
#include <algorithm>

#include "atom.h"
#include "contact/vector.h"
#include "tri_mesh.h"
#include "dem/error.h"
#include "dem/text.h"

using namespace LAMMPS_NS;
using asperity::Box;
using asperity::Frame;
using asperity::text;
using asperity::Twist;

/* By how much of its size a mesh may have changed its form, by rounding. */
static const double FORM = 1e-6;

MeshOfLiggghts::MeshOfLiggghts(MPI_Comm world, FixMeshSurface *fix)
    : world_(world), fix_(fix), is_servo_(strcmp(fix->style, "mesh/surface/stress/servo") == 0),
      pieces_(0), box_(), nodes_(), reference_(), force_(), torque_() {
  add_sums();
  int mine = -1, most;
  for (int t = 0; t < mesh()->sizeLocal(); t++)
    mine = std::max(mine, mesh()->id(t));
  MPI_Allreduce(&mine, &most, 1, MPI_INT, MPI_MAX, world_);
  pieces_ = static_cast<size_t>(most) + 1;
}

/* ---- where it is ---- */

std::string MeshOfLiggghts::setup(const Box &box) {
  const bool first = !triangles();
  box_ = box;
  if (first)
    gather();
  else {
    Twist twist;
    const Frame frame = look(twist, 0);
    bool moved = false;
    for (int k = 0; k < 3; k++)
      moved = moved || fabs(frame.shift[k] - motion().end().shift[k]) > 0;
    if (moved || !motion().in_world())
      motion().settle(frame, mesh()->isMoving());
    check_form();
  }
  if (runs())
    read_belt();
  return first && each_keeps()
             ? text("mesh '%s': MPI shares no memory here, so each rank keeps a copy", fix_->id)
             : "";
}

/* The triangles as they are now: that is the mesh's own frame. */
void MeshOfLiggghts::gather() {
  std::vector<double> mine;
  const int n = mesh()->sizeLocal();
  mine.reserve(static_cast<size_t>(n) * ROW);
  for (int t = 0; t < n; t++) {
    mine.push_back(mesh()->id(t));
    for (int k = 0; k < 3; k++) {
      double node[3];
      mesh()->node(t, k, node);
      mine.insert(mine.end(), node, node + 3);
    }
  }
  const std::vector<double> all = asperity::gather(mine, world_);
  take(all.data(), all.size() / ROW);
}

/* Rows of all triangles; those of rank 0 count. */
void MeshOfLiggghts::take(const double *rows, size_t count) {
  build(world_, [rows, count](ContactTree *tree) {
    bool good = true;
    for (const double *row = rows; good && row < rows + ROW * count; row += ROW) {
      ContactTriangle triangle;
      memcpy(triangle.node, row + 1, sizeof triangle.node);
      good = aspi_tree_add(tree, &triangle, static_cast<int>(row[0]));
    }
    return good;
  });
  choose_nodes();
}

std::vector<double> MeshOfLiggghts::motion_record() const {
  std::vector<double> record;
  if (!triangles() || motion().in_world())
    return record;
  const Twist &last = motion().last();
  const Frame &end = motion().end();
  record.insert(record.end(), last.angular, last.angular + 3);
  record.insert(record.end(), last.linear, last.linear + 3);
  record.insert(record.end(), end.turn[0], end.turn[0] + 9);
  record.insert(record.end(), end.shift, end.shift + 3);
  for (int i = 0; i < static_cast<int>(aspi_tree_count(triangles())); i++) {
    const ContactTriangle *triangle = aspi_tree_triangle(triangles(), i);
    record.push_back(aspi_tree_id(triangles(), i));
    record.insert(record.end(), triangle->node[0], triangle->node[0] + 9);
  }
  return record;
}

void MeshOfLiggghts::restore_motion(const std::vector<double> &record) {
  if (record.size() < HEAD || (record.size() - HEAD) % ROW != 0)
    return;
  Twist last;
  Frame end;
  aspi_copy(&record[0], last.angular);
  aspi_copy(&record[3], last.linear);
  std::copy(&record[6], &record[15], end.turn[0]);
  aspi_copy(&record[15], end.shift);
  take(record.data() + HEAD, (record.size() - HEAD) / ROW);
  motion().set_last(last);
  motion().settle(end, true);
}

/* The first node of the first triangle, the one farthest from it, and the one farthest from the
 * line through both; of equal ones that with the least number. */
void MeshOfLiggghts::choose_nodes() {
  for (int pick = 0; pick < 3; pick++) {
    double farthest = -1, best[3] = {0, 0, 0}, arm[3], line[3], across[3];
    for (int id = 0; id < static_cast<int>(pieces_); id++) {
      const int place = aspi_tree_place(triangles(), id);
      for (int k = 0; k < 3 && place >= 0; k++) {
        const double *x = aspi_tree_triangle(triangles(), place)->node[k];
        aspi_subtract(x, reference_[0], arm);
        aspi_subtract(reference_[1], reference_[0], line);
        aspi_cross(line, arm, across);
        const double far = pick == 0 ? 0 : aspi_length(pick == 1 ? arm : across);
        if (!(far > farthest))
          continue;
        farthest = far;
        nodes_[pick] = NodeName{id, k};
        aspi_copy(x, best);
      }
    }
    aspi_copy(best, reference_[pick]);
  }
}

/* An orthonormal frame that goes with three points: the first, the direction to the second, and
 * the normal of their plane. */
static Frame frame_of(const double a[3], const double b[3], const double c[3]) {
  double e[3][3], arm[3];
  aspi_subtract(b, a, e[0]);
  aspi_subtract(c, a, arm);
  aspi_cross(e[0], arm, e[2]);
  aspi_scale(1 / aspi_length(e[0]), e[0]);
  aspi_scale(1 / aspi_length(e[2]), e[2]);
  aspi_cross(e[2], e[0], e[1]);
  Frame frame;
  for (int i = 0; i < 3; i++)
    for (int j = 0; j < 3; j++)
      frame.turn[i][j] = e[j][i];
  aspi_copy(a, frame.shift);
  return frame;
}

/* LIGGGHTS wraps each triangle for itself at a periodic edge. Choose the periodic image of each
 * node that is closest to where the motion puts it. */
void MeshOfLiggghts::unwrap(double x[3][3], const double v[3][3], double dt) const {
  const Twist last = motion().moves() ? motion().last() : Twist();
  for (int k = 0; k < 3; k++) {
    double there[3], by[3], torn[3];
    motion().end().to_world(reference_[k], there);
    aspi_add_scaled(there, dt, v[k], there);
    aspi_copy(x[k], by);
    box_.bring_near(there, x[k]);
    aspi_subtract(x[k], by, by);
    aspi_cross(last.angular, by, torn);
    if (aspi_length(torn) > FORM * aspi_length(last.angular) * aspi_length(by))
      throw asperity::Error(
          text("mesh '%s' turns and crosses a periodic edge; LIGGGHTS would turn each of its "
               "triangles about the same point on either side, which tears the mesh; the axis must "
               "be along the periodic direction, or the mesh must stay within the box",
               fix_->id));
  }
}

/* Position and motion of the mesh from three of its nodes, each read on the rank that owns it. */
Frame MeshOfLiggghts::look(Twist &twist, double dt) const {
  double mine[18] = {0}, all[18];
  Nodes *moving = mesh()->isMoving() ? mesh()->prop().getElementProperty<Nodes>("v") : NULL;
  for (int k = 0; k < 3; k++)
    for (int j = 0; j < mesh()->map_size(nodes_[k].piece); j++) {
      const int t = mesh()->map(nodes_[k].piece, j);
      if (t < 0 || t >= mesh()->sizeLocal())
        continue;
      mesh()->node(t, nodes_[k].node, mine + 6 * k);
      if (moving)
        aspi_copy(moving->begin()[t][nodes_[k].node], mine + 6 * k + 3);
    }
  MPI_Allreduce(mine, all, 18, MPI_DOUBLE, MPI_SUM, world_);
  double x[3][3], v[3][3];
  for (int k = 0; k < 3; k++) {
    aspi_copy(all + 6 * k, x[k]);
    aspi_copy(all + 6 * k + 3, v[k]);
  }
  unwrap(x, v, dt);

  const Frame now = frame_of(x[0], x[1], x[2]),
              then = frame_of(reference_[0], reference_[1], reference_[2]);
  Frame frame;
  bool same = true;
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      frame.turn[i][j] = aspi_dot(now.turn[i], then.turn[j]);
      same = same && !(x[i][j] < reference_[i][j] || x[i][j] > reference_[i][j]);
    }
  }
  for (int i = 0; i < 3; i++)
    frame.shift[i] = x[0][i] - aspi_dot(frame.turn[i], reference_[0]);
  if (same)
    frame = Frame();

  /* From two arms a and b and their velocities: the part of the rotation across a, and the rest
   * from b. */
  double a[3], b[3], va[3], vb[3], n[3], w[3], rest[3];
  aspi_subtract(x[1], x[0], a);
  aspi_subtract(x[2], x[0], b);
  aspi_subtract(v[1], v[0], va);
  aspi_subtract(v[2], v[0], vb);
  aspi_cross(a, va, w);
  aspi_scale(1 / aspi_dot(a, a), w);
  aspi_cross(w, b, rest);
  aspi_subtract(vb, rest, rest);
  aspi_cross(a, b, n);
  aspi_add_scaled(w, aspi_dot(rest, n) / aspi_dot(n, n), a, twist.angular);
  aspi_cross(twist.angular, x[0], rest);
  aspi_subtract(v[0], rest, twist.linear);
  return frame;
}

void MeshOfLiggghts::begin_step(double dt) {
  if (mesh()->isMoving()) {
    Twist twist;
    const Frame frame = look(twist, dt);
    asperity::check_turn("mesh", fix_->id, aspi_length(twist.angular) * dt);
    motion().advance(frame, twist, dt);
  } else if (motion().moves())
    motion().rest();
  if (runs())
    read_belt();
}

void MeshOfLiggghts::check_form() const {
  double size[3], worst = 0;
  aspi_subtract(whole().hi, whole().lo, size);
  for (int t = 0; t < mesh()->sizeLocal(); t++) {
    const int place = aspi_tree_place(triangles(), mesh()->id(t));
    for (int k = 0; place >= 0 && k < 3; k++) {
      double node[3], there[3];
      mesh()->node(t, k, node);
      motion().end().to_world(aspi_tree_triangle(triangles(), place)->node[k], there);
      box_.bring_near(node, there);
      aspi_subtract(there, node, there);
      worst = std::max(worst, aspi_length(there));
    }
  }
  double all;
  MPI_Allreduce(&worst, &all, 1, MPI_DOUBLE, MPI_MAX, world_);
  if (all > FORM * aspi_length(size))
    throw asperity::Error(
        text("mesh '%s' has changed its form or size since this wall took it over (by %g); "
             "meshes must be rigid: unfix the wall and define it again",
             fix_->id, all));
}

/* ---- belts ---- */

bool MeshOfLiggghts::runs() const {
  return fix_->surfaceVel();
}

/* Reads the belt velocities of this rank's triangles; the others keep theirs, which do not
 * change. */
void MeshOfLiggghts::read_belt() {
  const bool first = belt_.empty();
  if (first)
    belt_.assign(pieces_, std::array<double, 9>());
  Nodes *v = mesh()->prop().getElementProperty<Nodes>("v");
  const int n = mesh()->sizeLocal() + (first ? 0 : mesh()->sizeGhost());
  for (int t = 0; v && t < n; t++)
    for (int k = 0; k < 3; k++)
      aspi_copy(v->begin()[t][k], &belt_[mesh()->id(t)][3 * k]);
  if (first)
    MPI_Allreduce(MPI_IN_PLACE, belt_.data(), static_cast<int>(9 * pieces_), MPI_DOUBLE, MPI_SUM,
                  world_);
}

/* Linear between the nodes. */
void MeshOfLiggghts::surface_velocity(int piece, const double foot[3], double v[3]) const {
  const ContactTriangle *t = aspi_tree_triangle(triangles(), aspi_tree_place(triangles(), piece));
  const std::array<double, 9> &of = belt_[piece];
  double ab[3], ac[3], at[3], n[3], part[3];
  aspi_subtract(t->node[1], t->node[0], ab);
  aspi_subtract(t->node[2], t->node[0], ac);
  aspi_subtract(foot, t->node[0], at);
  aspi_cross(ab, ac, n);
  const double square = aspi_dot(n, n);
  aspi_cross(at, ac, part);
  const double to_b = square > 0 ? aspi_dot(part, n) / square : 0;
  aspi_cross(ab, at, part);
  const double to_c = square > 0 ? aspi_dot(part, n) / square : 0;
  for (int d = 0; d < 3; d++)
    v[d] = of[d] + to_b * (of[3 + d] - of[d]) + to_c * (of[6 + d] - of[d]);
}
