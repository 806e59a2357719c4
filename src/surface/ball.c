/* Dilation of a map by a sphere: the height of the center over a point is the largest of
 * z_j + sqrt(r^2 - d_j^2) over the points j at a distance d_j <= r. A branch and bound over blocks
 * of points finds it: it skips blocks whose maximum, at the block's least distance, is below the
 * best so far. The search begins with the contact point of the neighbor, so the time hardly grows
 * with r.
 *
 * Contact gradients are not differences of that surface, which smear its kinks, but those of the
 * map at the touching point (differences bias the rms slope by 1 to 2 %): between the points the
 * map is the parabola through them, on which p = x + r g/sqrt(1 + g^2), g its gradient at p, is
 * solved by Newton's method.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "surface/ball.h"
#include "base/error.h"
#include "surface/heights.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

enum { STEPS = 4 };

/* The refined point stays within this many steps of the sampled one. */
#define STRAY_MOST 1.5

/* Maxima over blocks of points, so that a search need not look at each point: level k has one for
 * each block of 2^k x 2^k points, row after row; level 0 is the points themselves. */
enum { LEVELS_MOST = 32 };
typedef struct level {
  ptrdiff_t columns, rows;
  const double *most;
} level;
typedef struct pyramid {
  int levels;
  level level[LEVELS_MOST];
  double *memory; /* of the levels above 0 */
  double top;     /* the maximum of all points */
} pyramid;

static bool pyramid_create(pyramid *p, const asp_heights *map) {
  size_t total = 0;
  *p = (pyramid){.levels = 1};
  level *at = p->level;
  *at = (level){(ptrdiff_t)map->columns, (ptrdiff_t)map->rows, map->z};
  for (; at->columns > 1 || at->rows > 1; p->levels++) {
    at[1] = (level){(at->columns + 1) / 2, (at->rows + 1) / 2, NULL};
    at++;
    total += (size_t)(at->columns * at->rows);
  }
  double *next = p->memory = aspi_allocate(total + 1);
  for (int k = 1; k < p->levels && next; k++) {
    const level *below = &p->level[k - 1];
    p->level[k].most = next;
    for (ptrdiff_t j = 0; j < p->level[k].rows; j++) {
      const double *one = below->most + 2 * j * below->columns;
      const double *two = 2 * j + 1 < below->rows ? one + below->columns : one;
      for (ptrdiff_t i = 0; i < p->level[k].columns; i++) {
        ptrdiff_t a = 2 * i, b = a + 1 < below->columns ? a + 1 : a;
        *next++ = fmax(fmax(one[a], one[b]), fmax(two[a], two[b]));
      }
    }
  }
  if (next)
    p->top = *p->level[p->levels - 1].most;
  return next;
}

struct aspi_ball {
  const asp_heights *map;
  double radius;
  pyramid pyramid;
};

aspi_ball *aspi_ball_create(const asp_heights *map, double d_p, asp_error *error) {
  double side = aspi_heights_extent(map).length;
  if (aspi_check_range(error, "d_p", "", d_p, 0, side))
    return NULL;
  aspi_ball *ball = calloc(1, sizeof *ball);
  if (!ball || !pyramid_create(&ball->pyramid, map)) {
    free(ball);
    aspi_fail(error, ASP_ENOMEM, "out of memory for a sphere on a map of %zu x %zu points",
              map->columns, map->rows);
    return NULL;
  }
  ball->map = map;
  ball->radius = 0.5 * d_p;
  return ball;
}

void aspi_ball_free(aspi_ball *ball) {
  if (ball)
    free(ball->pyramid.memory);
  free(ball);
}

/* A search for the contact point of a sphere over (x, y). Positions are in points, relative to the
 * periodic image of the map that is searched. */
typedef struct search {
  const aspi_ball *ball;
  double x, y;
  double best;        /* height of the center so far */
  ptrdiff_t at[2];    /* and the point, in the image */
  ptrdiff_t image[2]; /* where the image begins */
} search;

/* Distance of x from the interval, in steps. */
static double outside(double x, double first, double last) {
  return x < first ? first - x : x > last ? x - last : 0;
}

/* True if a height at this squared distance could lift the sphere. */
static bool lifts(const search *s, double height, double square) {
  double room = s->ball->radius * s->ball->radius - square, gap = s->best - height;
  return room >= 0 && (gap < 0 || gap * gap < room);
}

static void look(search *s, int k, ptrdiff_t i, ptrdiff_t j) {
  const aspi_ball *ball = s->ball;
  const level *at = &ball->pyramid.level[k];
  double dx = ball->map->step[0], dy = ball->map->step[1];
  double width = (double)((ptrdiff_t)1 << k);
  double u = dx * outside(s->x, (double)i * width, (double)(i + 1) * width - 1);
  double v = dy * outside(s->y, (double)j * width, (double)(j + 1) * width - 1);
  double height = at->most[j * at->columns + i], square = u * u + v * v;
  if (!lifts(s, height, square))
    return;
  if (k == 0) {
    s->best = height + sqrt(ball->radius * ball->radius - square);
    s->at[0] = i + s->image[0];
    s->at[1] = j + s->image[1];
    return;
  }
  const level *below = at - 1;
  /* The nearer children first. */
  ptrdiff_t i0 = 2 * i, j0 = 2 * j, si = 0, sj = 0;
  if (s->x > ((double)i + 0.5) * width)
    si = 1;
  if (s->y > ((double)j + 0.5) * width)
    sj = 1;
  for (ptrdiff_t b = 0; b < 2; b++)
    for (ptrdiff_t a = 0; a < 2; a++) {
      ptrdiff_t ci = i0 + (si ^ a), cj = j0 + (sj ^ b);
      if (ci < below->columns && cj < below->rows)
        look(s, k - 1, ci, cj);
    }
}

static ptrdiff_t wrapped(ptrdiff_t i, ptrdiff_t n) {
  i %= n;
  return i < 0 ? i + n : i;
}

static ptrdiff_t clipped(double i, ptrdiff_t n) {
  return i < 0 ? 0 : i >= (double)n ? n - 1 : (ptrdiff_t)i;
}

/* Searches all blocks of one image of the map that are in reach. */
static void look_at_image(search *s, double reach_x, double reach_y) {
  const aspi_ball *ball = s->ball;
  int k = 0;
  while (k + 1 < ball->pyramid.levels && (double)((ptrdiff_t)1 << k) < fmax(reach_x, reach_y))
    k++;
  double width = (double)((ptrdiff_t)1 << k);
  const level *at = &ball->pyramid.level[k];
  ptrdiff_t columns = ball->pyramid.level[0].columns, rows = ball->pyramid.level[0].rows;
  if (s->x + reach_x < 0 || s->x - reach_x > (double)(columns - 1) || s->y + reach_y < 0 ||
      s->y - reach_y > (double)(rows - 1))
    return;
  ptrdiff_t i0 = clipped((s->x - reach_x) / width, at->columns);
  ptrdiff_t i1 = clipped((s->x + reach_x) / width, at->columns);
  ptrdiff_t j0 = clipped((s->y - reach_y) / width, at->rows);
  ptrdiff_t j1 = clipped((s->y + reach_y) / width, at->rows);
  for (ptrdiff_t j = j0; j <= j1; j++)
    for (ptrdiff_t i = i0; i <= i1; i++)
      look(s, k, i, j);
}

/* Offers a point, in the coordinates of the map's first image. */
static void offer(search *s, ptrdiff_t i, ptrdiff_t j) {
  const asp_heights *map = s->ball->map;
  ptrdiff_t columns = (ptrdiff_t)map->columns, rows = (ptrdiff_t)map->rows;
  if (!map->periodic && (i < 0 || i >= columns || j < 0 || j >= rows))
    return;
  double u = map->step[0] * ((double)i - s->x), v = map->step[1] * ((double)j - s->y);
  double height = map->z[wrapped(j, rows) * columns + wrapped(i, columns)];
  if (!lifts(s, height, u * u + v * v))
    return;
  s->best = height + sqrt(s->ball->radius * s->ball->radius - u * u - v * v);
  s->at[0] = i;
  s->at[1] = j;
}

/* The contact point of a sphere over (x, y), in points. The search begins at `from`, relative to
 * the nearest point. */
static search find(const aspi_ball *ball, double x, double y, const ptrdiff_t from[2]) {
  const asp_heights *map = ball->map;
  search s = {ball, x, y, -INFINITY, {0}, {0}};
  ptrdiff_t i = (ptrdiff_t)(x + 0.5), j = (ptrdiff_t)(y + 0.5);
  offer(&s, i, j);
  if (s.best < -DBL_MAX) { /* no point is in reach: it rests between them */
    s.at[0] = i;
    s.at[1] = j;
    s.best = map->z[wrapped(j, (ptrdiff_t)map->rows) * (ptrdiff_t)map->columns +
                    wrapped(i, (ptrdiff_t)map->columns)];
    return s;
  }
  offer(&s, i + from[0], j + from[1]);
  double drop = fmax(0, s.best - ball->pyramid.top);
  double reach = sqrt(fmax(0, ball->radius * ball->radius - drop * drop));
  double reach_x = reach / map->step[0], reach_y = reach / map->step[1];
  ptrdiff_t columns = (ptrdiff_t)map->columns, rows = (ptrdiff_t)map->rows;
  int images = map->periodic ? 1 : 0;
  for (int b = -images; b <= images; b++)
    for (int a = -images; a <= images; a++) {
      s.image[0] = a * columns;
      s.image[1] = b * rows;
      s.x = x - (double)s.image[0];
      s.y = y - (double)s.image[1];
      look_at_image(&s, reach_x, reach_y);
    }
  s.x = x;
  s.y = y;
  return s;
}

/* The map around a point: value, gradient, second derivatives. */
typedef struct patch {
  double z, gx, gy, xx, xy, yy;
} patch;

static double height_at(const asp_heights *map, ptrdiff_t i, ptrdiff_t j) {
  ptrdiff_t columns = (ptrdiff_t)map->columns, rows = (ptrdiff_t)map->rows;
  if (map->periodic) {
    i = wrapped(i, columns);
    j = wrapped(j, rows);
  } else {
    i = i < 0 ? 0 : i < columns ? i : columns - 1;
    j = j < 0 ? 0 : j < rows ? j : rows - 1;
  }
  return map->z[j * columns + i];
}

static patch patch_at(const asp_heights *map, ptrdiff_t i, ptrdiff_t j) {
  double dx = map->step[0], dy = map->step[1], z = height_at(map, i, j);
  double e = height_at(map, i + 1, j), w = height_at(map, i - 1, j), n = height_at(map, i, j + 1),
         s = height_at(map, i, j - 1);
  double ee = height_at(map, i + 2, j), ww = height_at(map, i - 2, j),
         nn = height_at(map, i, j + 2), ss = height_at(map, i, j - 2);
  patch f = {.z = z,
             .gx = (8 * (e - w) - (ee - ww)) / (12 * dx),
             .gy = (8 * (n - s) - (nn - ss)) / (12 * dy),
             .xx = (e - 2 * z + w) / (dx * dx),
             .yy = (n - 2 * z + s) / (dy * dy)};
  f.xy = (height_at(map, i + 1, j + 1) - height_at(map, i - 1, j + 1) -
          height_at(map, i + 1, j - 1) + height_at(map, i - 1, j - 1)) /
         (4 * dx * dy);
  return f;
}

/* The map between four points: the parabolas around them, weighted bilinearly, without steps. */
typedef struct surface {
  double z, gx, gy;
} surface;

static surface blend(const asp_heights *map, double x, double y) {
  double dx = map->step[0], dy = map->step[1], column = floor(x), row = floor(y);
  ptrdiff_t i = (ptrdiff_t)column, j = (ptrdiff_t)row;
  surface sum = {0};
  for (int k = 0; k < 4; k++) {
    ptrdiff_t a = k % 2, b = k / 2;
    double u = x - column - (double)a, v = y - row - (double)b, w = (1 - fabs(u)) * (1 - fabs(v));
    if (!(w > 0))
      continue;
    patch f = patch_at(map, i + a, j + b);
    u *= dx;
    v *= dy;
    sum.z += w * (f.z + f.gx * u + f.gy * v + 0.5 * (f.xx * u * u + f.yy * v * v) + f.xy * u * v);
    sum.gx += w * (f.gx + f.xx * u + f.xy * v);
    sum.gy += w * (f.gy + f.xy * u + f.yy * v);
  }
  return sum;
}

/* The contact near the point that was found: Newton's method on the parabola around that point,
 * then with the gradient of the blended surface and the parabola's derivatives. (x, y): from the
 * point to the center. False if it does not end nearby. */
static bool refine(const search *s, double x, double y, aspi_touch *touch) {
  const asp_heights *map = s->ball->map;
  const patch f = patch_at(map, s->at[0], s->at[1]);
  double r = s->ball->radius, dx = map->step[0], dy = map->step[1], u = 0, v = 0, gx = 0, gy = 0;
  surface here = {0};
  for (int step = 0; step <= STEPS; step++) {
    bool last = step >= STEPS - 1;
    gx = f.gx + f.xx * u + f.xy * v;
    gy = f.gy + f.xy * u + f.yy * v;
    if (last) {
      here = blend(map, (double)s->at[0] + u / dx, (double)s->at[1] + v / dy);
      gx = here.gx;
      gy = here.gy;
    }
    if (step == STEPS)
      break;
    double root = sqrt(1 + gx * gx + gy * gy), a = r / root, b = a / (root * root);
    double fx = u - x - a * gx, fy = v - y - a * gy;
    /* The derivatives of a g with respect to g, times those of g. */
    double nxx = a - b * gx * gx, nxy = -b * gx * gy, nyy = a - b * gy * gy;
    double jxx = 1 - nxx * f.xx - nxy * f.xy, jxy = -nxx * f.xy - nxy * f.yy;
    double jyx = -nxy * f.xx - nyy * f.xy, jyy = 1 - nxy * f.xy - nyy * f.yy;
    double det = jxx * jyy - jxy * jyx;
    if (!(det > 1e-6))
      return false;
    u -= (jyy * fx - jxy * fy) / det;
    v -= (jxx * fy - jyx * fx) / det;
    if (!(fabs(u) <= STRAY_MOST * dx && fabs(v) <= STRAY_MOST * dy))
      return false;
  }
  double room = r * r - (x - u) * (x - u) - (y - v) * (y - v);
  touch->p = gx;
  touch->q = gy;
  touch->height = here.z + sqrt(fmax(0, room));
  return true;
}

static aspi_touch touch_of(const search *s, bool sampled) {
  const aspi_ball *ball = s->ball;
  const asp_heights *map = ball->map;
  double x = map->step[0] * (s->x - (double)s->at[0]), y = map->step[1] * (s->y - (double)s->at[1]);
  double up = sqrt(fmax(0, ball->radius * ball->radius - x * x - y * y));
  aspi_touch touch = {s->best, 0, 0};
  if (!sampled && refine(s, x, y, &touch))
    return touch;
  patch f = patch_at(map, s->at[0], s->at[1]);
  touch.height = s->best;
  touch.p = up > 0 ? -x / up : f.gx;
  touch.q = up > 0 ? -y / up : f.gy;
  return touch;
}

aspi_touch aspi_ball_touch(const aspi_ball *ball, size_t column, size_t row, bool sampled) {
  search s = find(ball, (double)column, (double)row, (const ptrdiff_t[2]){0, 0});
  return touch_of(&s, sampled);
}

aspi_ball_search aspi_ball_begin(const aspi_ball *ball) {
  return (aspi_ball_search){ball, {0, 0}};
}

aspi_touch aspi_ball_at(aspi_ball_search *way, double x, double y) {
  const aspi_ball *ball = way->ball;
  search s = find(ball, x / ball->map->step[0], y / ball->map->step[1], way->from);
  way->from[0] = s.at[0] - (ptrdiff_t)(s.x + 0.5);
  way->from[1] = s.at[1] - (ptrdiff_t)(s.y + 0.5);
  return touch_of(&s, false);
}

void aspi_ball_rows(const aspi_ball *ball, size_t first, size_t end, float *height, float *p,
                    float *q) {
  size_t columns = ball->map->columns;
  ptrdiff_t from[2] = {0, 0};
  for (size_t j = first; j < end; j++)
    for (size_t k = 0; k < columns; k++) {
      /* Back and forth, so that each center follows a neighbor. */
      size_t i = (j - first) % 2 ? columns - 1 - k : k;
      search s = find(ball, (double)i, (double)j, from);
      from[0] = s.at[0] - (ptrdiff_t)i;
      from[1] = s.at[1] - (ptrdiff_t)j;
      aspi_touch touch = touch_of(&s, false);
      height[j * columns + i] = (float)touch.height;
      if (p)
        p[j * columns + i] = (float)touch.p;
      if (q)
        q[j * columns + i] = (float)touch.q;
    }
}
