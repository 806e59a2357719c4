/* A mesh as a wall: its contacts; see mesh.h. What it takes along is in mesh_carry.cpp, its
 * periodic images in mesh_images.cpp.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/shapes/mesh.h"

#include <math.h>
#include <algorithm>
#include <new>

#include "contact/vector.h"
#include "dem/error.h"

using namespace asperity;

namespace {

/* A long path is searched in pieces, the first one first: PIECE radii, and longer while a piece
 * meets at most MANY triangles. */
const double PIECE = 16;
const size_t MANY = 64;

/* How much later than `touch` another contact may be to be at the same instant: as far as the
 * instant is known, which is not well where the sphere grazes the wall, but no more than a small
 * share of the time in which it moves by its radius. */
double same_instant(const ContactTouch &touch, const ContactPath &path, double radius) {
  const double by_gap = 2 * TOUCHING * radius / -aspi_dot(path.v, touch.n);
  return std::min(by_gap, ONE_PLACE * radius / aspi_length(path.v));
}

} // namespace

MeshShape::MeshShape() : tree_(NULL, aspi_tree_free), period_(), swept_(), near_() {}

MeshShape::~MeshShape() {
  aspi_places_free(&near_);
}

void MeshShape::build(MPI_Comm world, const std::function<bool(ContactTree *)> &add) {
  std::unique_ptr<ContactTree, void (*)(ContactTree *)> tree(NULL, aspi_tree_free);
  std::string wrong;
  int rank;
  MPI_Comm_rank(world, &rank);
  try {
    if (rank == 0)
      tree.reset(aspi_tree_begin());
    if (rank == 0 && !(tree && add(tree.get()) && aspi_tree_finish(tree.get())))
      throw std::bad_alloc();
  } catch (const std::exception &error) {
    wrong = message_of(error);
  }
  wrong = asperity::share(wrong, world);
  if (!wrong.empty())
    throw Error(wrong);
  tree_.reset(shared_.spread(world, tree.release()));
  if (!tree_)
    throw std::bad_alloc();
}

Bounds MeshShape::whole() const {
  Bounds box;
  aspi_tree_box(tree_.get(), box.lo, box.hi);
  return box;
}

/* The box moves with the mesh. Within a step the velocity changes from one end to the other. */
double MeshShape::travel(double dt) const {
  double most = 0;
  const Bounds box = whole();
  for (int corner = 0; corner < 8 && motion_.moves() && !(box.lo[0] > box.hi[0]); corner++) {
    double x[3], begin[3], end[3], v[3];
    for (int d = 0; d < 3; d++)
      x[d] = corner >> d & 1 ? box.hi[d] : box.lo[d];
    motion_.frame_at(0).to_world(x, begin);
    motion_.end().to_world(x, end);
    motion_.velocity(1, end, v);
    aspi_subtract(end, begin, begin);
    most = std::max(most, std::max(aspi_length(begin), dt * aspi_length(v)));
  }
  return 1.5 * most; /* a chord is shorter than its arc */
}

double MeshShape::clear(const Course &course, const FaceList &stays) const {
  double steps = course.most;
  for (const Shift &shift : images_ahead(course, steps)) {
    Course at = course;
    aspi_subtract(course.x, shift.by, at.x);
    if (!motion_.in_world()) {
      const Frame &frame = motion_.end();
      const double *v = course.v;
      frame.to_local(at.x, at.x);
      for (int j = 0; j < 3; j++)
        at.v[j] = frame.turn[0][j] * v[0] + frame.turn[1][j] * v[1] + frame.turn[2][j] * v[2];
    }
    steps = std::min(steps, aspi_tree_clear(tree_.get(), at.x, at.v, at.reach, at.widen, at.least,
                                            steps, stays.face, stays.count));
  }
  return steps;
}

bool MeshShape::separate(const double x[3], double reach, const FaceList &stays,
                         BarrierList &made) const {
  const std::vector<Shift> &all = images_at(x, reach);
  if (all.empty())
    return true;
  if (all.size() > 1 || aspi_length(all[0].by) > 0)
    return false;
  double at[3];
  ContactPlane planes[BarrierList::MOST];
  const int room = BarrierList::MOST - made.count;
  aspi_copy(x, at);
  if (!motion_.in_world())
    motion_.end().to_local(x, at);
  const int count =
      aspi_tree_separate(tree_.get(), at, reach, stays.face, stays.count, &near_, planes, room);
  for (int k = 0; k < count; k++) {
    Barrier *barrier = made.add();
    aspi_copy(planes[k].n, barrier->n);
    barrier->at = planes[k].at;
  }
  return count >= 0;
}

double MeshShape::gap(const Barriers &all, const double from[3], const double to[3],
                      double radius) const {
  if (motion_.in_world())
    return Shape::gap(all, from, to, radius);
  double begin[3], end[3];
  motion_.start().to_local(from, begin);
  motion_.end().to_local(to, end);
  return Shape::gap(all, begin, end, radius);
}

bool MeshShape::repeats(int axis) const {
  return period_[axis] > 0;
}

/* The path as the mesh sees it: straight between its two ends in the mesh's frame. */
void MeshShape::local_path(const Path &path, const Shift &shift, ContactPath &local) const {
  double begin[3], end[3], end_local[3];
  local.left = path.left;
  aspi_subtract(path.x, shift.by, begin);
  if (motion_.in_world()) {
    aspi_copy(begin, local.x);
    aspi_copy(path.v, local.v);
    return;
  }
  aspi_add_scaled(begin, path.left, path.v, end);
  motion_.frame_at(path.share()).to_local(begin, local.x);
  if (path.rest > 0)
    motion_.frame_at(1 - path.rest / path.dt).to_local(end, end_local);
  else
    motion_.end().to_local(end, end_local);
  aspi_subtract(end_local, local.x, local.v);
  aspi_scale(1 / path.left, local.v);
}

/* The triangles that meet a box within `reach` of its middle, in order of their numbers. */
const ContactList &MeshShape::meet(const Bounds &box, double reach) const {
  const ContactTree *tree = tree_.get();
  near_.count = 0;
  if (!aspi_tree_meet(tree, box.lo, box.hi, reach, &near_))
    throw std::bad_alloc();
  std::sort(near_.item, near_.item + near_.count,
            [tree](int a, int b) { return aspi_tree_id(tree, a) < aspi_tree_id(tree, b); });
  return near_;
}

/* Cuts the times from..to to those at which the sphere may meet the box of the triangles. */
bool MeshShape::clip(const ContactPath &local, double radius, double &from, double &to) const {
  const Bounds box = whole();
  for (int d = 0; d < 3; d++) {
    const double lo = box.lo[d] - 1.001 * radius - local.x[d];
    const double hi = box.hi[d] + 1.001 * radius - local.x[d];
    if (local.v[d] > 0 || local.v[d] < 0) {
      from = std::max(from, std::min(lo / local.v[d], hi / local.v[d]));
      to = std::min(to, std::max(lo / local.v[d], hi / local.v[d]));
    } else if (lo > 0 || hi < 0)
      return false;
  }
  return from <= to;
}

/* The first triangle on the path. An edge is met at one instant by all of its triangles: the
 * contact is that of the one with the least number, but with the normal that is nearest to that of
 * a face: on a flat wall, an edge has it only to the rounding of nodes and places. */
bool MeshShape::find_image(const ContactPath &local, double radius, double from, double latest,
                           ContactTouch &touch, Places &place) const {
  const double speed = aspi_length(local.v);
  const double least = PIECE * radius / speed;
  double most = std::min(latest, local.left), piece = least;
  if (!(speed > 0) || (piece < most && !clip(local, radius, from, most)))
    return false;
  for (;;) {
    const double to = std::min(from + piece, most);
    const double way = speed * (to - from);
    const ContactList &list = meet(Bounds::of_path(local.x, local.v, from, to, 1.001 * radius),
                                   1.001 * radius + 0.5 * way);
    if (list.count > MANY && piece > least) {
      piece = std::max(least, piece / 4);
      continue;
    }
    const ContactTree *tree = tree_.get();
    bool found = false;
    for (size_t i = 0; i < list.count; i++) {
      ContactTouch other;
      const double slack = found ? same_instant(touch, local, radius) : 0;
      if (!aspi_triangle_find(aspi_tree_triangle(tree, list.item[i]), &local, radius,
                              found ? touch.time + slack : to, &other))
        continue;
      const bool same = found && other.time >= touch.time - slack;
      if (!same)
        place.piece = list.item[i];
      if (!same || other.edge_sine < touch.edge_sine) {
        touch = other;
        place.face = list.item[i];
      }
      found = true;
    }
    if (found)
      return true;
    if (to >= most || !(to > from))
      return false;
    piece *= 2;
    from = to;
  }
}

void MeshShape::set_contact(const Path &path, const ContactPath &local, const Shift &shift,
                            double radius, const ContactTouch &touch, const Places &place,
                            Contact &contact) const {
  double center[3], foot[3], follow[3];
  contact.time = touch.time;
  contact.overlapped = touch.overlapped;
  contact.curve = contact.chord = 0;
  contact.approach_speed = -aspi_dot(local.v, touch.n);
  contact.piece = aspi_tree_id(tree_.get(), place.piece);
  contact.face = aspi_tree_id(tree_.get(), place.face);
  if (touch.edge_sine > GRAZING)
    contact.face = ~contact.face;
  aspi_add_scaled(local.x, touch.time, local.v, center);
  aspi_add_scaled(center, touch.overlap, touch.n, center);
  aspi_add_scaled(center, -radius, touch.n, foot);
  if (motion_.in_world()) {
    aspi_copy(touch.n, contact.n);
    aspi_copy(touch.n, contact.n_end);
    aspi_add_scaled(path.x, touch.time, path.v, contact.x);
    aspi_add_scaled(contact.x, touch.overlap, touch.n, contact.x);
    contact.v_wall[0] = contact.v_wall[1] = contact.v_wall[2] = contact.follow = 0;
    if (runs())
      surface_velocity(contact.piece, foot, contact.v_wall);
    return;
  }
  const double share = path.share() + touch.time / path.dt;
  const Frame frame = motion_.frame_at(share);
  frame.to_world(center, contact.x);
  motion_.acceleration(share, contact.x, path.v, follow);
  aspi_add_scaled(contact.x, 1, shift.by, contact.x);
  for (int i = 0; i < 3; i++) {
    contact.n[i] = aspi_dot(frame.turn[i], touch.n);
    contact.n_end[i] = aspi_dot(motion_.end().turn[i], touch.n);
  }
  double world_foot[3];
  frame.to_world(foot, world_foot);
  motion_.velocity(share, world_foot, contact.v_wall);
  contact.follow = aspi_dot(follow, contact.n);
}

/* From a face the center may have come to another one in its plane. An edge or a corner, whose
 * number is the complement of the triangle's, counts as itself. */
bool MeshShape::under(int face, const double x[3], const double v[3], double reach,
                      Contact &contact, double &distance) const {
  const ContactTree *tree = tree_.get();
  for (const Shift &shift : images_at(x, 2 * reach)) {
    double at[3], foot[3], normal[3], other[3], height;
    aspi_subtract(x, shift.by, at);
    if (!motion_.in_world())
      motion_.end().to_local(at, at);
    int place = aspi_tree_place(tree, face < 0 ? ~face : face);
    if (place < 0)
      continue;
    contact.face = face;
    if (face < 0) {
      height = aspi_triangle_nearest(aspi_tree_triangle(tree, place), at, foot);
      aspi_subtract(at, foot, normal);
      aspi_scale(height > 0 ? 1 / height : 0, normal);
    } else if (!aspi_triangle_is_under(aspi_tree_triangle(tree, place), at, normal, &height)) {
      aspi_copy(normal, other);
      aspi_tree_distance(tree, at, reach, &place);
      if (place < 0 ||
          !aspi_triangle_is_under(aspi_tree_triangle(tree, place), at, normal, &height) ||
          fabs(aspi_dot(normal, other)) < 1 - ROUNDING)
        continue;
      contact.face = aspi_tree_id(tree, place);
    }
    distance = fabs(height);
    if (!(distance <= reach && distance > 0))
      continue;
    aspi_scale(height < 0 ? -1 : 1, normal);
    aspi_add_scaled(at, -distance, normal, foot);
    if (motion_.in_world()) {
      aspi_copy(normal, contact.n);
      if (runs())
        surface_velocity(contact.face < 0 ? ~contact.face : contact.face, foot, contact.v_wall);
      return true;
    }
    for (int i = 0; i < 3; i++)
      contact.n[i] = aspi_dot(motion_.end().turn[i], normal);
    if (motion_.moves()) {
      double a[3];
      motion_.acceleration(1, x, v, a);
      contact.follow = aspi_dot(a, contact.n);
      motion_.end().to_world(foot, foot);
      motion_.velocity(1, foot, contact.v_wall);
    }
    return true;
  }
  return false;
}

/* The first contact between two times among all periodic images. Where two are met at one instant,
 * as at a seam between them, the one whose normal is nearest to that of a face counts. */
bool MeshShape::find_piece(const Path &path, double radius, double from, double latest,
                           Contact &contact) const {
  bool found = false;
  ContactTouch first;
  for (const Shift &shift : images(around(path, from, latest, radius))) {
    ContactPath local;
    ContactTouch touch;
    Places place;
    local_path(path, shift, local);
    const double slack = found ? same_instant(first, local, radius) : 0;
    if (!find_image(local, radius, from, found ? std::min(latest, first.time + slack) : latest,
                    touch, place))
      continue;
    if (found && touch.time >= first.time - slack && !(touch.edge_sine < first.edge_sine))
      continue;
    set_contact(path, local, shift, radius, touch, place, contact);
    found = true;
    first = touch;
  }
  return found;
}

bool MeshShape::find(const Path &path, double radius, double latest, Contact &contact) const {
  if (!(path.left > 0))
    return false;
  const double piece = period_of(path);
  for (double from = 0;; from += piece) {
    const double to = std::min(latest, from + piece);
    if (find_piece(path, radius, from, to, contact))
      return true;
    if (to >= latest)
      return false;
  }
}

size_t MeshShape::bytes() const {
  return sizeof *this + (tree_ && shared_.keeps() ? aspi_tree_bytes(tree_.get()) : 0);
}
