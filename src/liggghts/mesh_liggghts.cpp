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
using asperity::Books;
using asperity::Bounds;
using asperity::Box;
using asperity::ContactLoad;
using asperity::Frame;
using asperity::SharedTriangles;
using asperity::text;
using asperity::Twist;
using asperity::Wall;

/* A mesh of fewer triangles is kept whole by each rank. */
static const size_t LARGE = 1000;

/* A box of triangles that is fetched is widened on each side by this share of its longest side. */
static const double WIDER = 0.5;

/* Two boxes are merged if the union is at most this many times larger than both. */
static const double UNITED = 2;

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

/* ---- where it is ------------------------------------------------------------------------------
 */

std::string MeshOfLiggghts::setup(const Bounds &here, const Box &box) {
  box_ = box;
  if (!triangles())
    gather(here);
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
  std::string report;
  report.swap(report_);
  return report;
}

/* The triangles as they are now: that is the mesh's own frame. */
void MeshOfLiggghts::gather(const Bounds &here) {
  std::vector<double> mine;
  const int n = mesh()->sizeLocal();
  mine.reserve(static_cast<size_t>(n) * SharedTriangles::ROW);
  for (int t = 0; t < n; t++) {
    mine.push_back(mesh()->id(t));
    for (int k = 0; k < 3; k++) {
      double node[3];
      mesh()->node(t, k, node);
      mine.insert(mine.end(), node, node + 3);
    }
  }
  take(std::move(mine));
  if (shared_)
    add_fetched(here);
}

/* Rows of triangles, of which each rank brings some. */
void MeshOfLiggghts::take(std::vector<double> mine) {
  int ranks;
  MPI_Comm_size(world_, &ranks);
  choose_nodes(mine);
  fetched_.clear();
  shared_.reset(new SharedTriangles(world_, std::move(mine)));
  const bool large = ranks > 1 && pieces_ >= LARGE;
  if (large && shared_->is_whole())
    report_ = text("mesh '%s': this MPI has no one-sided communication, so each rank keeps all of "
                   "its %d triangles",
                   fix_->id, static_cast<int>(pieces_));
  if (large && !shared_->is_whole())
    set_triangles(std::vector<ContactTriangle>(), std::vector<int>());
  else {
    fetched_.push_back(shared_->whole());
    put_fetched();
    shared_.reset();
  }
}

bool MeshOfLiggghts::has_all() const {
  return !shared_;
}

Bounds MeshOfLiggghts::whole() const {
  return shared_ ? shared_->whole() : MeshShape::whole();
}

bool MeshOfLiggghts::has(const Bounds &box) const {
  if (!shared_ || !box.meets(shared_->whole()))
    return true;
  Bounds inner = box;
  for (int d = 0; d < 3; d++) {
    inner.lo[d] = std::max(inner.lo[d], shared_->whole().lo[d]);
    inner.hi[d] = std::min(inner.hi[d], shared_->whole().hi[d]);
  }
  for (const Bounds &known : fetched_)
    if (known.has(inner))
      return true;
  return false;
}

void MeshOfLiggghts::fetch(const Bounds &box) const {
  Bounds wide = box;
  double longest = 0;
  for (int d = 0; d < 3; d++)
    longest = std::max(longest, box.hi[d] - box.lo[d]);
  wide.widen(WIDER * longest);
  add_fetched(wide);
}

/* Adds a box to those with fetched triangles; they never shrink. */
void MeshOfLiggghts::add_fetched(Bounds wide) const {
  for (size_t k = 0; k < fetched_.size();) { /* one that is near becomes a part of it */
    Bounds both = fetched_[k];
    both.include(wide);
    if (both.size() > UNITED * (fetched_[k].size() + wide.size())) {
      k++;
      continue;
    }
    wide = both;
    fetched_.erase(fetched_.begin() + k);
    k = 0;
  }
  fetched_.push_back(wide);
  put_fetched();
}

void MeshOfLiggghts::put_fetched() const {
  std::unique_ptr<ContactTree, void (*)(ContactTree *)> tree(aspi_tree_begin(), aspi_tree_free);
  bool good = tree != NULL;
  shared_->read(fetched_, [&](const double *row) {
    ContactTriangle triangle;
    memcpy(triangle.node, row + 1, sizeof triangle.node);
    good = good && aspi_tree_add(tree.get(), &triangle, static_cast<int>(row[0]));
  });
  put_tree(good && aspi_tree_finish(tree.get()) ? tree.release() : NULL);
}

std::vector<double> MeshOfLiggghts::motion_record() const {
  std::vector<double> record = MeshShape::motion_record();
  if (!shared_ || record.empty())
    return record;
  record.resize(HEAD); /* then all triangles, of this rank or not */
  shared_->read(std::vector<Bounds>(1, shared_->whole()), [&record](const double *row) {
    record.insert(record.end(), row, row + SharedTriangles::ROW);
  });
  return record;
}

void MeshOfLiggghts::restore_motion(const std::vector<double> &record) {
  MeshShape::restore_motion(record);
  if (!triangles() || record.size() < HEAD)
    return;
  int rank, ranks;
  MPI_Comm_rank(world_, &rank);
  MPI_Comm_size(world_, &ranks);
  const size_t rows = (record.size() - HEAD) / SharedTriangles::ROW;
  const auto from = [&](int of) {
    return record.begin() + HEAD + rows * of / ranks * SharedTriangles::ROW;
  };
  take(std::vector<double>(from(rank), from(rank + 1)));
}

/* The first node of the first triangle, the one farthest from it, and the one farthest from the
 * line through both; ties by number, so that it does not depend on whose the triangles are. */
void MeshOfLiggghts::choose_nodes(const std::vector<double> &mine) {
  struct Pick {
    double far, id, node, x[3];
    bool before(const Pick &other) const {
      return far > other.far ||
             (!(far < other.far) && (id < other.id || (!(id > other.id) && node < other.node)));
    }
  };
  int ranks;
  MPI_Comm_size(world_, &ranks);
  std::vector<Pick> all(ranks);
  for (int pick = 0; pick < 3; pick++) {
    Pick best = {-1, static_cast<double>(pieces_), 0, {0, 0, 0}};
    for (size_t row = 0; row < mine.size(); row += SharedTriangles::ROW)
      for (int k = 0; k < 3; k++) {
        Pick other = {0, mine[row], static_cast<double>(k), {0, 0, 0}};
        double arm[3], line[3], across[3];
        aspi_copy(&mine[row + 1 + 3 * k], other.x);
        aspi_subtract(other.x, reference_[0], arm);
        aspi_subtract(reference_[1], reference_[0], line);
        aspi_cross(line, arm, across);
        if (pick > 0)
          other.far = pick == 1 ? aspi_length(arm) : aspi_length(across);
        if (other.before(best))
          best = other;
      }
    MPI_Allgather(&best, sizeof best, MPI_BYTE, all.data(), sizeof best, MPI_BYTE, world_);
    for (const Pick &other : all)
      if (other.before(best))
        best = other;
    nodes_[pick] = NodeName{static_cast<int>(best.id), static_cast<int>(best.node)};
    aspi_copy(best.x, reference_[pick]);
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

/* LIGGGHTS wraps each triangle for itself at a periodic edge. Of each node the image counts to
 * which the mesh's own motion has brought it. */
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

/* ---- belts ------------------------------------------------------------------------------------
 */

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
