/* Flights over a dilated wall: the center of the particle flies straight. A flight skips blocks of
 * cells whose maximum lies below it, in growing steps while nothing is in reach.
 *
 * A map that does not repeat ends at its edges. A flight that leaves there continues at the
 * opposite edge, shifted along it to a place below the flight. This keeps statistics and lay, which
 * a mirror image would turn.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/flight.h"

#include <math.h>

/* A flight that has passed this many blocks is lost; a sinking flight passes far fewer. */
enum { BLOCKS_MOST = 100000 };

/* Contact gradients differ from the gradient of the surface between the points, so a face may send
 * a particle slightly into its neighbor. After 2 cells below the surface it counts as a hit. */
enum { UNDER_MOST = 2 };

/* A flight slower than this along an axis does not move along it. */
#define SLOWEST 1e-200

/* Places along an edge are tried in turn: multiples of the golden section modulo 1, which spread
 * evenly. */
enum { SHIFTS_MOST = 64 };
#define GOLDEN 0.6180339887498949

static double bilinear(const double z[4], double u, double v) {
  return (1 - v) * ((1 - u) * z[0] + u * z[1]) + v * ((1 - u) * z[2] + u * z[3]);
}

/* A flight in units of cells along the field: its parameter is the time t. */
typedef struct ray {
  double x[3], v[3];
} ray;

static double along(const ray *r, int axis, double t) {
  return r->x[axis] + t * r->v[axis];
}

/* Height of the surface of a cell, u and v from its first corner. */
static double height(const aspi_field *f, const aspi_cell *c, double u, double v) {
  return f->axes > 1 ? bilinear(c->z, u, v) : c->z[0] + u * (c->z[1] - c->z[0]);
}

/* Height of the flight over the surface of a cell. */
static double over(const aspi_field *f, const ray *r, const aspi_cell *c, double t) {
  return along(r, 2, t) - height(f, c, along(r, 0, t) - c->at[0], along(r, 1, t) - c->at[1]);
}

/* The exact time between t[0] and t[1] at which the flight meets the surface of a cell: over() is a
 * parabola, over a row a line. False if it does not come from above. */
static bool meets(const aspi_field *f, const ray *r, const aspi_cell *c, const double t[2],
                  double *at) {
  double a = over(f, r, c, t[0]), b = over(f, r, c, t[1]), curve = 0;
  if (f->axes > 1)
    curve = 2 * (a + b - 2 * over(f, r, c, 0.5 * (t[0] + t[1])));
  double slope = b - a - curve;
  if (a <= 0) { /* below the surface already: a hit at the edge if it still sinks */
    *at = t[0];
    return slope < 0;
  }
  /* a + slope s + curve s^2 = 0, the smaller root between 0 and 1. */
  double square = slope * slope - 4 * a * curve;
  if (b > 0 && !(curve > 0 && slope < 0 && slope > -2 * curve && square > 0))
    return false;
  double s = 2 * a / (-slope + sqrt(fmax(0, square)));
  if (!(s >= 0 && s <= 1))
    return false;
  *at = t[0] + s * (t[1] - t[0]);
  return true;
}

static bool approaches(const double way[3], const double gradient[2]) {
  return way[2] - gradient[0] * way[0] - gradient[1] * way[1] < 0;
}

static ptrdiff_t clamped(double x, ptrdiff_t first, ptrdiff_t end) {
  ptrdiff_t i = (ptrdiff_t)x;
  return i < first ? first : i < end ? i : end - 1;
}

/* True if the sphere lies between two contacts somewhere in a cell: its contact moves by more than
 * ASPI_KINK cells along an edge of it. */
static bool has_kink(const aspi_field *f, const aspi_cell *c) {
  double x = fmax(c->point[1][1] - c->point[0][1], c->point[3][1] - c->point[2][1]);
  double y = fmax(c->point[2][2] - c->point[0][2], c->point[3][2] - c->point[1][2]);
  return f->radius * x > (ASPI_KINK - 1) * f->step[0] ||
         f->radius * y > (ASPI_KINK - 1) * f->step[1];
}

/* The change of a contact's gradient per step along an axis, toward the cell from its corner k: the
 * same as from the next point behind the corner, unless there is a kink or an edge between them. */
static double bend_at(const aspi_field *f, const aspi_cell *c, int k, int axis) {
  const ptrdiff_t side = axis ? f->rows : f->columns;
  ptrdiff_t at[2] = {(ptrdiff_t)c->at[0] + k % 2, (ptrdiff_t)c->at[1] + k / 2};
  const int way = (axis ? k / 2 : k % 2) ? 1 : -1;
  at[!axis] %= axis ? f->columns : f->rows;
  at[axis] += way;
  if (!f->wraps && (at[axis] < 0 || at[axis] >= side))
    return 0;
  at[axis] = (at[axis] + side) % side;
  const float *behind = f->z + f->stride * (f->columns * at[1] + at[0]);
  double change = c->point[k][1 + axis] - behind[1 + axis];
  return -way * f->radius * change > (ASPI_KINK - 1) * f->step[axis] ? 0 : -way * change;
}

/* The highest tangent plane of the corners of a cell at a place is of one on the same side of the
 * kink; the gradient changes toward it as before. */
static aspi_touch highest_tangent(const aspi_field *f, const aspi_cell *c, double u, double v) {
  int best = 0;
  double most = -INFINITY;
  for (int k = 0; k < 4; k++) {
    double z = c->z[k] + c->point[k][1] * (u - k % 2) * f->step[0] +
               c->point[k][2] * (v - k / 2) * f->step[1];
    best = z > most ? k : best;
    most = fmax(z, most);
  }
  double x = u - best % 2, y = v - best / 2;
  double p = x * bend_at(f, c, best, 0), q = y * bend_at(f, c, best, 1);
  return (aspi_touch){most + 0.5 * (p * x * f->step[0] + q * y * f->step[1]), c->point[best][1] + p,
                      c->point[best][2] + q};
}

/* The contact at a place of a cell: between those at its corners, or in a kink that of one of them.
 * The mean of the heights by the corners' heights and by their tangent planes is exact for a
 * parabola. */
static aspi_touch touch_in(const aspi_field *f, const aspi_cell *c, double u, double v) {
  double p[4], q[4], z[4];
  if (has_kink(f, c))
    return highest_tangent(f, c, u, v);
  for (int k = 0; k < 4; k++) {
    p[k] = c->point[k][1];
    q[k] = c->point[k][2];
    z[k] = c->z[k] + 0.5 * (p[k] * (u - k % 2) * f->step[0] + q[k] * (v - k / 2) * f->step[1]);
  }
  return (aspi_touch){bilinear(z, u, v), bilinear(p, u, v), bilinear(q, u, v)};
}

aspi_touch aspi_field_at(const aspi_field *f, const double place[2]) {
  const ptrdiff_t at[2] = {clamped(place[0], 0, f->cells[0]), clamped(place[1], 0, f->cells[1])};
  aspi_cell c = aspi_cell_at(f, at);
  return touch_in(f, &c, place[0] - c.at[0], place[1] - c.at[1]);
}

/* The gradient at a place of a cell: that of the contact if the particle approaches that face; else
 * that of the surface. */
static void gradient_at(const aspi_field *f, const aspi_cell *c, double u, double v,
                        const double way[3], double gradient[2]) {
  if (f->axes == 1) {
    gradient[0] = (c->z[1] - c->z[0]) / f->step[0];
    gradient[1] = 0;
    return;
  }
  gradient[0] = ((1 - v) * (c->z[1] - c->z[0]) + v * (c->z[3] - c->z[2])) / f->step[0];
  gradient[1] = ((1 - u) * (c->z[2] - c->z[0]) + u * (c->z[3] - c->z[1])) / f->step[1];
  if (!aspi_field_has_gradients(f))
    return;
  const aspi_touch touch = touch_in(f, c, u, v);
  const double contact[2] = {touch.p, touch.q};
  if (approaches(way, contact)) {
    gradient[0] = contact[0];
    gradient[1] = contact[1];
  }
}

aspi_spot aspi_field_enter(const aspi_field *f, double u, double v) {
  return (aspi_spot){{u * (double)f->cells[0], v * (double)f->cells[1]}, f->top, false};
}

/* Continues a flight that has left the field along an axis at the opposite edge. */
static void reenter(const aspi_field *f, ray *r, double t, int axis, ptrdiff_t at[2]) {
  ptrdiff_t n = f->cells[axis], m = f->cells[!axis];
  double width = (double)m, y = along(r, !axis, t);
  r->x[axis] += at[axis] < 0 ? (double)n : -(double)n;
  at[axis] = at[axis] < 0 ? n - 1 : 0;
  for (int k = 0; !f->wraps && k < SHIFTS_MOST; k++) {
    y += GOLDEN * width;
    y = y < width ? y : y - width;
    at[!axis] = clamped(y, 0, m);
    if (*aspi_field_top(f, 0, at[0], at[1]) < along(r, 2, t))
      break;
  }
  r->x[!axis] = y - t * r->v[!axis];
}

/* The blocks of cells along a flight. */
typedef struct walk {
  ray r;
  double inverse[2], t; /* 1/v; the time */
  bool ahead[2];        /* v is not negative */
  ptrdiff_t at[2];      /* the cell at that time */
  int level;            /* of the blocks */
  int axis;             /* along which the flight leaves the block */
  ptrdiff_t end[2][2];  /* first and behind the last cell of the block */
  double last;          /* the time when it leaves */
  double most;          /* upper bound of the time of flight */
} walk;

/* Finds the end of the block around the cell. */
static void find_end(const aspi_field *f, walk *w) {
  int shift = 2 * w->level;
  double out[2];
  for (int a = 0; a < f->axes; a++) {
    ptrdiff_t first = w->at[a] >> shift << shift, end = first + ((ptrdiff_t)1 << shift);
    w->end[a][0] = first;
    w->end[a][1] = end < f->cells[a] ? end : f->cells[a];
    out[a] = ((double)w->end[a][w->ahead[a]] - w->r.x[a]) * w->inverse[a];
  }
  w->axis = f->axes > 1 && out[1] < out[0];
  double last = out[w->axis] < w->most ? out[w->axis] : w->most;
  w->last = last > w->t ? last : w->t;
}

/* Move to the next block; go up one level when crossing a block of that level. */
static void leave(const aspi_field *f, walk *w) {
  int a = w->axis, b = !a;
  int larger = 2 * w->level + 2;
  ptrdiff_t from = w->at[a] >> larger;
  w->t = w->last;
  w->at[a] = w->end[a][w->ahead[a]] - !w->ahead[a];
  if (f->axes > 1)
    w->at[b] = clamped(along(&w->r, b, w->t), w->end[b][0], w->end[b][1]);
  if ((size_t)w->at[a] >= (size_t)f->cells[a])
    reenter(f, &w->r, w->t, a, w->at);
  if (w->level + 1 < f->levels && w->at[a] >> larger != from)
    w->level++;
}

/* Puts the particle on the surface where it hits at time t, and sets the gradient there. */
static void land(const aspi_field *f, const walk *w, const aspi_cell *c, double t,
                 const double way[3], aspi_spot *spot, double gradient[2]) {
  for (int a = 0; a < 2; a++)
    spot->x[a] = fmin(fmax(along(&w->r, a, t), c->at[a]), c->at[a] + 1);
  double u = spot->x[0] - c->at[0], v = spot->x[1] - c->at[1];
  spot->z = height(f, c, u, v);
  spot->lies = true;
  gradient_at(f, c, u, v, way, gradient);
}

/* True if the flight hits the surface of its cell or has gone under it. This includes flights that
 * enter the face they start from. clear: it has been over
 * the surface since it started; under: cells that it has left below the surface until then. */
static bool hits(const aspi_field *f, const walk *w, const double way[3], bool *clear, int *under,
                 aspi_spot *spot, double gradient[2]) {
  aspi_cell c = aspi_cell_at(f, w->at);
  double span[2] = {w->t, w->last}, at = w->t;
  bool met = *clear && meets(f, &w->r, &c, span, &at), below_all = way[2] < 0 && w->last >= w->most;
  if (met || below_all) {
    land(f, w, &c, at, way, spot, gradient);
    return true;
  }
  bool above = over(f, &w->r, &c, w->last) > 0;
  if (!*clear && !above) {
    aspi_spot below = *spot;
    land(f, w, &c, w->last, way, &below, gradient);
    if (approaches(way, gradient) && ++*under == UNDER_MOST) {
      *spot = below;
      return true;
    }
  }
  *clear = *clear || above || !aspi_field_has_gradients(f);
  return false;
}

bool aspi_field_next(const aspi_field *f, const double way[3], aspi_spot *spot,
                     double gradient[2]) {
  walk w = {
      .r = {{spot->x[0], spot->x[1], spot->z}, {way[0] / f->step[0], way[1] / f->step[1], way[2]}},
      .level = spot->lies ? 0 : f->levels - 1};
  for (int a = 0; a < 2; a++) {
    w.ahead[a] = w.r.v[a] >= 0;
    w.inverse[a] = 1 / (fabs(w.r.v[a]) > SLOWEST ? w.r.v[a] : SLOWEST);
    w.at[a] = clamped(spot->x[a], 0, f->cells[a]);
  }
  double rise = way[2] < 0 ? f->bottom - spot->z : f->top - spot->z;
  w.most = fabs(way[2]) > SLOWEST ? fmax(rise / way[2], 0) : INFINITY;
  bool clear = !spot->lies;
  int under = 0;
  for (int count = 0; count < BLOCKS_MOST; count++) {
    if (way[2] > 0 && w.t >= w.most)
      return false;
    int shift = 2 * w.level;
    double top = *aspi_field_top(f, w.level, w.at[0] >> shift, w.at[1] >> shift);
    bool passes = along(&w.r, 2, w.t) > top;
    if (passes || w.level == 0) {
      find_end(f, &w);
      passes = passes && (way[2] >= 0 || along(&w.r, 2, w.last) > top);
    }
    if (!passes && w.level > 0) {
      w.level--;
      continue;
    }
    clear = clear || passes;
    if (!passes && hits(f, &w, way, &clear, &under, spot, gradient))
      return true;
    leave(f, &w);
  }
  return false;
}
