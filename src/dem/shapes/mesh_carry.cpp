/* Moves stuck particles and the lay with a mesh, also on a belt; see mesh.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "dem/shapes/mesh.h"

#include <math.h>

#include "contact/vector.h"

using namespace asperity;

bool MeshShape::is_still() const {
  return motion_.in_world() && !motion_.moves() && !runs();
}

void MeshShape::stick(const Path &path, const Contact &contact, Place &place) const {
  Shape::stick(path, contact, place);
  if (!motion_.in_world())
    motion_.frame_at(path.share() + contact.time / path.dt).to_local(contact.x, place.at);
}

/* The vector is of the mesh's own frame, which is the world's when the wall is defined. */
void MeshShape::lay(const asp_lay &lay, const Path &path, const Contact &contact,
                    double direction[3]) const {
  aspi_copy(lay.vector, direction);
  if (motion_.in_world())
    return;
  motion_.frame_at(path.share() + contact.time / path.dt).to_world_direction(lay.vector, direction);
}

bool MeshShape::is_across(const double direction[3]) const {
  bool all = true;
  for (size_t place = 0; all && place < aspi_tree_count(tree_.get()); place++) {
    const ContactTriangle &t = *aspi_tree_triangle(tree_.get(), static_cast<int>(place));
    double a[3], b[3], n[3];
    aspi_subtract(t.node[1], t.node[0], a);
    aspi_subtract(t.node[2], t.node[0], b);
    aspi_cross(a, b, n);
    all = are_parallel(direction, n);
  }
  return all;
}

/* One step along a belt: false where it ends or bends, or runs against something. */
bool MeshShape::walk(Place &place, double radius, double dt) const {
  const ContactTree *tree = tree_.get();
  const int from = aspi_tree_place(tree, place.piece);
  if (from < 0)
    return false;
  double v[3], foot[3], there[3], arm[3];
  aspi_triangle_nearest(aspi_tree_triangle(tree, from), place.at, foot);
  surface_velocity(place.piece, foot, v);
  aspi_add_scaled(place.at, 0.5 * dt, v, there); /* the midpoint rule, for belts that turn */
  aspi_triangle_nearest(aspi_tree_triangle(tree, from), there, foot);
  surface_velocity(place.piece, foot, v);
  aspi_add_scaled(place.at, dt, v, there);
  int to;
  const double reach = radius + aspi_length(v) * dt + AT_ONCE * radius;
  const double distance = aspi_tree_distance(tree, there, reach, &to);
  if (to < 0 || distance < (1 - AT_ONCE) * radius)
    return false;
  aspi_triangle_nearest(aspi_tree_triangle(tree, to), there, foot);
  aspi_subtract(there, foot, arm);
  double normal[3];
  aspi_triangle_normal(aspi_tree_triangle(tree, to), normal);
  if (fabs(aspi_dot(arm, normal)) < (1 - ROUNDING) * distance) /* beyond an edge */
    return false;
  place.piece = aspi_tree_id(tree, to);
  aspi_add_scaled(foot, radius / distance, arm, place.at);
  return true;
}

void MeshShape::carry(Place &place, double radius, double dt, double x[3], double v[3]) const {
  double before[3];
  aspi_copy(place.at, before);
  if (runs() && dt > 0 && walk(place, radius, dt)) {
    aspi_copy(place.at, x);
    aspi_subtract(x, before, v);
    aspi_scale(1 / dt, v);
    return;
  }
  if (motion_.in_world())
    aspi_copy(place.at, x);
  else
    motion_.end().to_world(place.at, x);
  motion_.velocity(1, x, v);
}

void MeshShape::turn(const Place &, double share, double, double axes[3][3],
                     double omega[3]) const {
  motion_.turn(share, axes, omega);
}
