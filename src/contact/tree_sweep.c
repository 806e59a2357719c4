/* A sphere that moves and grows against a tree of triangles; see aspi_tree_clear().
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include <math.h>

#include "contact/tree_nodes.h"
#include "contact/vector.h"

/* A flatter triangle, by height over longest edge, has no well-defined plane. */
static const double SLIVER = 1e-3;

enum { CONTACT_SKIPPED = 3 };

/* The sphere, and the box around it. */
typedef struct Sweep {
  double x[3], v[3], reach, widen;
  double speed;              /* of the point of the sphere that moves fastest */
  double lo[3], hi[3];       /* sides of its box at the beginning */
  double rises[3], falls[3]; /* times in which the upper side goes up by 1, the lower one down */
  bool leaves_up[3], leaves_down[3]; /* the other side moves that way, too */
} Sweep;

static Sweep sweep_of(const double x[3], const double v[3], double reach, double widen) {
  Sweep sweep = {.reach = reach, .widen = widen, .speed = aspi_length(v) + widen};
  aspi_copy(x, sweep.x);
  aspi_copy(v, sweep.v);
  for (int d = 0; d < 3; d++) {
    const double up = widen + v[d], down = widen - v[d];
    sweep.lo[d] = x[d] - reach;
    sweep.hi[d] = x[d] + reach;
    sweep.rises[d] = up > 0 || up < 0 ? 1 / up : INFINITY;
    sweep.falls[d] = down > 0 || down < 0 ? 1 / down : INFINITY;
    sweep.leaves_up[d] = down < 0;
    sweep.leaves_down[d] = up < 0;
  }
  return sweep;
}

/* The time that it needs at least to reach what is at a distance from its center. */
static inline double sweep_reaches(const Sweep *sweep, double distance) {
  const double gap = distance - sweep->reach;
  return gap > 0 ? gap / sweep->speed : 0;
}

/* The time at which it first meets the box lo to hi, at most `most`; it leaves the box by *end. */
static inline double sweep_meets(const Sweep *sweep, const double lo[3], const double hi[3],
                                 double most, double *end) {
  double begin = 0, square = 0;
  *end = most;
  for (int d = 0; d < 3; d++) {
    const double above = lo[d] - sweep->hi[d], below = sweep->lo[d] - hi[d];
    if (above > 0) {
      if (sweep->leaves_down[d])
        return most;
      begin = aspi_larger(begin, above * sweep->rises[d]);
    } else if (sweep->leaves_down[d])
      *end = aspi_smaller(*end, above * sweep->rises[d]);
    if (below > 0) {
      if (sweep->leaves_up[d])
        return most;
      begin = aspi_larger(begin, below * sweep->falls[d]);
    } else if (sweep->leaves_up[d])
      *end = aspi_smaller(*end, below * sweep->falls[d]);
    if (begin > *end)
      return most;
    const double off = aspi_larger(0, aspi_larger(lo[d] - sweep->x[d], sweep->x[d] - hi[d]));
    square += off * off;
  }
  begin = aspi_larger(begin, sweep_reaches(sweep, sqrt(square)));
  return begin > *end ? most : begin;
}

static inline double sweep_meets_node(const Sweep *sweep, const ContactNode *node, double most) {
  const double lo[3] = {node->lo[0], node->lo[1], node->lo[2]};
  const double hi[3] = {node->hi[0], node->hi[1], node->hi[2]};
  double end;
  return sweep_meets(sweep, lo, hi, most, &end);
}

/* Narrows the times in which it is not beyond a plane: where n.(center - on) is at most the radius
 * times `length`, that of n. False where it is beyond it throughout. */
static bool sweep_is_within(const Sweep *sweep, const double n[3], double length,
                            const double on[3], double *begin, double *end) {
  double arm[3];
  aspi_subtract(sweep->x, on, arm);
  const double gap = aspi_dot(n, arm) - sweep->reach * length;
  const double closing = sweep->widen * length - aspi_dot(n, sweep->v);
  if (gap > 0) {
    if (!(closing * *end > gap))
      return false;
    *begin = aspi_larger(*begin, gap / closing);
  } else if (closing < 0)
    *end = aspi_smaller(*end, gap / closing);
  return *begin <= *end;
}

/* Lower bound by the triangle's box, its plane, the inner sides of its edges, and its distance: a
 * sphere that flies along a wall oblique to the axes stays in the boxes of its triangles for long,
 * and one that rests there is near to few of those that its box meets. */
static double sweep_meets_triangle(const Sweep *sweep, const ContactTriangle *t, double most) {
  double lo[3], hi[3], end;
  aspi_triangle_box(t, lo, hi);
  double begin = sweep_meets(sweep, lo, hi, most, &end);
  if (!(begin < most))
    return most;
  double edge[3][3], n[3], back[3];
  for (int k = 0; k < 3; k++)
    aspi_subtract(t->node[(k + 1) % 3], t->node[k], edge[k]);
  aspi_cross(edge[0], edge[1], n);
  aspi_copy(n, back);
  aspi_scale(-1, back);
  const double length = aspi_length(n);
  const double longest =
      aspi_larger(aspi_dot(edge[0], edge[0]),
                  aspi_larger(aspi_dot(edge[1], edge[1]), aspi_dot(edge[2], edge[2])));
  if (!(length > SLIVER * longest))
    return begin;
  if (!sweep_is_within(sweep, n, length, t->node[0], &begin, &end) ||
      !sweep_is_within(sweep, back, length, t->node[0], &begin, &end))
    return most;
  for (int k = 0; k < 3; k++) {
    double outward[3];
    aspi_cross(edge[k], n, outward);
    if (!sweep_is_within(sweep, outward, aspi_length(outward), t->node[k], &begin, &end))
      return most;
  }
  double nearest[3];
  begin = aspi_larger(begin, sweep_reaches(sweep, aspi_triangle_nearest(t, sweep->x, nearest)));
  return begin > end ? most : aspi_smaller(begin, most);
}

/* The planes of some triangles. */
typedef struct Planes {
  int count;
  double n[CONTACT_SKIPPED][3], at[CONTACT_SKIPPED], flat;
} Planes;

static Planes planes_of(const ContactTree *tree, const int *id, int count, double reach) {
  Planes planes = {.count = 0, .flat = ONE_PLACE * reach};
  for (int k = 0; k < count && k < CONTACT_SKIPPED; k++) {
    const int place = aspi_tree_place(tree, id[k]);
    if (place < 0)
      continue;
    double *n = planes.n[planes.count];
    aspi_triangle_normal(&tree->triangles[place], n);
    planes.at[planes.count++] = aspi_dot(n, tree->triangles[place].node[0]);
  }
  return planes;
}

static bool is_in_planes(const ContactTriangle *t, const Planes *planes) {
  for (int k = 0; k < planes->count; k++) {
    bool all = true;
    for (int i = 0; all && i < 3; i++)
      all = fabs(aspi_dot(planes->n[k], t->node[i]) - planes->at[k]) <= planes->flat;
    if (all)
      return true;
  }
  return false;
}

double aspi_tree_clear(const ContactTree *tree, const double x[3], const double v[3], double reach,
                       double widen, double least, double most, const int *skip, int skipped) {
  const Sweep sweep = sweep_of(x, v, reach, widen);
  const Planes planes = planes_of(tree, skip, skipped, reach);
  struct {
    int at;
    double time;
  } stack[CONTACT_TREE_DEPTH];
  int top = 0;
  double first = most;
  if (tree->count > 0) {
    stack[top].at = 0;
    stack[top++].time = sweep_meets_node(&sweep, tree->nodes, first);
  }
  while (top > 0 && first > least) {
    const int at = stack[--top].at;
    if (!(stack[top].time < first))
      continue;
    const ContactNode *node = &tree->nodes[at];
    if (node->count == 0) { /* the nearer child first */
      const int child[2] = {at + 1, node->first};
      const double time[2] = {sweep_meets_node(&sweep, &tree->nodes[child[0]], first),
                              sweep_meets_node(&sweep, &tree->nodes[child[1]], first)};
      const int sooner = time[1] < time[0];
      for (int k = 0; k < 2; k++) {
        const int which = k == 0 ? !sooner : sooner;
        if (!(time[which] < first))
          continue;
        stack[top].at = child[which];
        stack[top++].time = time[which];
      }
    }
    for (int i = node->first; i < node->first + node->count; i++)
      if (!is_in_planes(&tree->triangles[i], &planes))
        first = aspi_smaller(first, sweep_meets_triangle(&sweep, &tree->triangles[i], first));
  }
  return first;
}

/* True if a triangle is behind a plane, which is moved on by no more than `slack` for it. */
static bool is_behind(const ContactTriangle *t, double slack, ContactPlane *plane) {
  double most = plane->at;
  for (int i = 0; i < 3; i++)
    most = aspi_larger(most, aspi_dot(plane->n, t->node[i]));
  if (most - plane->at > slack)
    return false;
  plane->at = most;
  return true;
}

/* One plane across the nearest point of each triangle that is behind none, the nearest first. */
int aspi_tree_separate(const ContactTree *tree, const double x[3], double reach, const int *skip,
                       int skipped, ContactList *near, ContactPlane *planes, int room) {
  const Planes stays = planes_of(tree, skip, skipped, reach);
  double lo[3], hi[3];
  for (int d = 0; d < 3; d++) {
    lo[d] = x[d] - reach;
    hi[d] = x[d] + reach;
  }
  near->count = 0;
  if (!aspi_tree_meet(tree, lo, hi, reach, near))
    return -1;
  for (int count = 0;; count++) {
    ContactPlane next = {{0, 0, 0}, 0};
    double least = reach;
    size_t left = 0;
    for (size_t k = 0; k < near->count; k++) {
      const ContactTriangle *t = &tree->triangles[near->item[k]];
      double foot[3];
      if (count > 0 ? is_behind(t, ONE_PLACE * reach, &planes[count - 1]) : is_in_planes(t, &stays))
        continue;
      const double distance = aspi_triangle_nearest(t, x, foot);
      if (!(distance < reach))
        continue;
      near->item[left++] = near->item[k];
      if (!(distance < least))
        continue;
      least = distance;
      aspi_subtract(x, foot, next.n);
      aspi_scale(1 / distance, next.n);
      next.at = aspi_dot(next.n, foot);
    }
    near->count = left;
    if (left == 0)
      return count;
    if (count == room || !(least > 0))
      return -1;
    planes[count] = next;
  }
}
