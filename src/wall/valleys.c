/* Tables of valleys and faces; see valleys.h.
 *
 * Lines go over the heights of the center that flights go over, too: straight over a map in 16
 * directions; a profile is one line. The crests on them are what
 * a moving sphere must climb, their kinks and smooth troughs are its faces. A sphere that starts
 * slowly goes round what is steep: along more lines it is pushed, and settles across its way at
 * each step. The steepest slope of such a line between a trough and the next crest is the slope at
 * which the sphere leaves the trough. In three glued beads this is exact.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "wall/valleys.h"
#include "base/error.h"
#include "base/grow.h"
#include "surface/heights.h"
#include "surface/size_law.h"

#include <math.h>
#include <stdlib.h>

/* Directions over a map; points a correlation length, and of all straight and all pushed lines. */
enum { DIRECTIONS = 16, PER_LAMBDA = 24, STRAIGHT = 32768, PUSHED = 16384, TRIES_MOST = 1000 };

/* With a lay valleys are longer, and lines are longer by as much, but no more than this. */
#define LONGER_MOST 4.0

/* Steps across the way while a sphere settles, and halvings of the last one. */
enum { SETTLES_MOST = 64, HALVINGS = 3 };

/* Starts in the list per correlation length of a valley. */
#define STARTS 6.0

/* Waves lower than this share of the rms height along a line are no valleys. */
#define LOW 0.1

/* Fractions of two numbers that spread places evenly over a square (Roberts' sequence). */
#define SPREAD_X 0.7548776662466927
#define SPREAD_Y 0.5698402909980532

typedef struct list {
  float *values;
  size_t n;
} list;

/* The table of a diameter in one direction, or in all. */
typedef struct class {
  list start, height;
  aspi_face *face;
  size_t faces;
  double way; /* length of the straight lines */
} class;

struct aspi_valleys {
  aspi_sizes sizes;
  int directions; /* 1: all alike */
  class class[];
};

/* Heights of the center along a line, and their slopes along it and across it. kink: the contact
 * jumps by more than this; every: points per start of a valley. */
typedef struct line {
  size_t n, every;
  double step, radius, kink, *z, *p, *q;
} line;

/* Room for so many points, in one block at l->z; false: out of memory. */
static bool make_room(line *l, size_t points) {
  l->z = aspi_allocate(3 * points);
  l->p = l->z ? l->z + points : NULL;
  l->q = l->z ? l->p + points : NULL;
  return l->z;
}

/* ---- rows of a line ---- */

static bool add(list *to, double value) {
  float *more = aspi_grow(to->values, to->n, sizeof *more);
  if (more)
    (to->values = more)[to->n++] = (float)value;
  return more;
}

static bool add_face(class *c, const line *l, size_t before, size_t at, double length) {
  aspi_face *more = aspi_grow(c->face, c->faces, sizeof *more);
  if (more)
    (c->face = more)[c->faces++] =
        (aspi_face){(float)l->p[before], (float)l->p[at], (float)l->q[at], (float)length};
  return more;
}

/* From the center to the contact, along the line. */
static double contact(const line *l, size_t i) {
  return l->radius * l->p[i] / sqrt(1 + l->p[i] * l->p[i] + l->q[i] * l->q[i]);
}

static bool is_kink(const line *l, size_t i) {
  return i + 1 < l->n && contact(l, i + 1) - contact(l, i) > l->kink;
}

static bool add_kinks(class *c, const line *l) {
  bool ok = true;
  for (size_t i = 0, from; i < l->n && ok; i++) {
    for (from = i; is_kink(l, i);)
      i++;
    ok = i == from || add_face(c, l, from, i, 0);
  }
  return ok;
}

/* Points of a line: the crest before a trough, the trough, and the crest behind it. */
typedef struct valley {
  size_t from, trough, crest;
} valley;

static size_t steepest(const line *l, const valley *v) {
  size_t at = v->trough;
  for (size_t i = v->trough; i < v->crest; i++)
    at = l->p[i] > l->p[at] ? i : at;
  return at;
}

/* A sphere that lies somewhere lies in a valley in proportion to its length: one start per length.
 */
static bool add_start(class *c, const line *l, const valley *v) {
  bool ok = true;
  for (size_t i = v->from; i < v->crest && ok; i += l->every)
    ok = add(&c->start, l->p[steepest(l, v)]);
  return ok;
}

/* The height of a crest; and a face, if its trough is no kink. */
static bool add_crest(class *c, const line *l, const valley *v) {
  bool kink = false;
  for (size_t i = v->trough > 2 ? v->trough - 2 : 0; i < v->trough + 2; i++)
    kink = kink || is_kink(l, i);
  return add(&c->height, l->z[v->crest] - l->z[v->trough]) &&
         (kink ||
          add_face(c, l, v->trough, steepest(l, v), (double)(v->crest - v->trough) * l->step));
}

static double rms(const double *z, size_t n) {
  double mean = 0, square = 0;
  for (size_t i = 0; i < n; i++)
    mean += z[i] / (double)n;
  for (size_t i = 0; i < n; i++)
    square += (z[i] - mean) * (z[i] - mean) / (double)n;
  return sqrt(square);
}

/* Hands over the valleys but the first, which may be cut off. */
static bool find_valleys(class *c, const line *l,
                         bool (*take)(class *c, const line *l, const valley *v)) {
  double low = LOW * rms(l->z, l->n);
  valley v = {0, 0, 0};
  bool rises = false, begun = false, ok = true;
  for (size_t i = 0; i < l->n && ok; i++) {
    if (!rises && l->z[i] < l->z[v.trough])
      v.trough = i;
    if (rises && l->z[i] > l->z[v.crest])
      v.crest = i;
    if (rises && l->z[i] < l->z[v.crest] - low) {
      ok = !begun || take(c, l, &v);
      begun = true;
      rises = false;
      v.from = v.crest;
      v.trough = i;
    } else if (!rises && l->z[i] > l->z[v.trough] + low) {
      rises = true;
      v.crest = i;
    }
  }
  return ok;
}

static bool add_straight(class *c, const line *l) {
  return add_kinks(c, l) && find_valleys(c, l, add_crest);
}

/* ---- lines over a map ---- */

/* A course over the heights of a center; places by lengths. */
typedef struct course {
  const aspi_field *over;
  double from[2], along[2], step;
} course;

/* Touches the map x along the course and y across it; false beyond its edges. */
static bool touch_at(const course *c, double x, double y, aspi_touch *touch) {
  const aspi_field *over = c->over;
  double at[2] = {c->from[0] + x * c->along[0] - y * c->along[1],
                  c->from[1] + x * c->along[1] + y * c->along[0]};
  for (int a = 0; a < 2; a++) {
    double cells = (double)over->cells[a];
    at[a] /= over->step[a];
    at[a] -= over->wraps ? cells * floor(at[a] / cells) : 0;
    if (!(at[a] >= 0 && at[a] <= cells))
      return false;
  }
  *touch = aspi_field_at(over, at);
  return true;
}

static double along(const course *c, const aspi_touch *touch) {
  return touch->p * c->along[0] + touch->q * c->along[1];
}

static double across(const course *c, const aspi_touch *touch) {
  return touch->q * c->along[0] - touch->p * c->along[1];
}

/* Lets the sphere go down across its course, from *y on. The bottom may be a kink: it is where the
 * tangents at both sides of it meet, and the slope is that along the kink. */
static bool settle(const course *c, double x, double *y, double *z, double *slope) {
  aspi_touch low, high = {0, 0, 0}, next;
  if (!touch_at(c, x, *y, &low))
    return false;
  double way = across(c, &low) > 0 ? -c->step : c->step;
  for (int k = 0, halvings = 0; k < SETTLES_MOST && halvings < HALVINGS; k++) {
    way *= halvings > 0 ? 0.5 : 1;
    if (!touch_at(c, x, *y + way, &next))
      return false;
    bool past = across(c, &next) * way >= 0;
    halvings += past || halvings > 0;
    *(past ? &high : &low) = next;
    *y += past ? 0 : way;
  }
  double a = across(c, &low), b = across(c, &high), part = 0;
  *slope = along(c, &low);
  if (a * way < 0 && b * way > 0) {
    part = fmin(fmax((high.height - low.height - b * way) / ((a - b) * way), 0), 1);
    *slope = (b * *slope - a * along(c, &high)) / (b - a);
  }
  *z = low.height + part * a * way;
  *y += part * way;
  return true;
}

/* Follows the course over at most so many points. */
static void follow(const course *c, line *l, size_t most, bool pushed) {
  double y = 0;
  for (l->n = 0; l->n < most; l->n++) {
    double x = (double)l->n * l->step;
    size_t i = l->n;
    aspi_touch touch;
    if (pushed ? !settle(c, x, &y, &l->z[i], &l->p[i]) : !touch_at(c, x, 0, &touch))
      return;
    l->q[i] = pushed ? 0 : across(c, &touch);
    if (pushed)
      continue;
    l->z[i] = touch.height;
    l->p[i] = along(c, &touch);
  }
}

/* Lines of a course from many places, of so many points in all. */
static bool cover(class *k, course *c, line *l, double points, bool pushed) {
  for (int i = 1; i < TRIES_MOST && points >= 1; i++) {
    c->from[0] = fmod(i * SPREAD_X, 1) * aspi_field_length(c->over, 0);
    c->from[1] = fmod(i * SPREAD_Y, 1) * aspi_field_length(c->over, 1);
    follow(c, l, (size_t)points, pushed);
    if (!(pushed ? find_valleys(k, l, add_start) : add_straight(k, l)))
      return false;
    points -= (double)l->n;
    k->way += pushed ? 0 : (double)l->n * l->step;
  }
  return true;
}

static bool fill_map(class *to, int directions, const aspi_field *over, const asp_surface *surface,
                     double lay, line *l) {
  double longer = fmin(aspi_surface_stretch(surface), LONGER_MOST);
  l->step = asp_surface_lambda_c(surface) / PER_LAMBDA;
  l->every = (size_t)(PER_LAMBDA / STARTS);
  l->kink = fmax((ASPI_KINK - 1) * l->step, 0.5 * fmax(over->step[0], over->step[1]));
  course c = {.over = over, .step = l->step};
  bool ok = make_room(l, (size_t)(longer * STRAIGHT / DIRECTIONS));
  for (int i = 0; i < DIRECTIONS && ok; i++) {
    double azimuth = lay - ASP_PI / 2 + 2 * ASP_PI * i / DIRECTIONS;
    class *k = &to[i % directions];
    c.along[0] = cos(azimuth);
    c.along[1] = sin(azimuth);
    ok = cover(k, &c, l, longer * STRAIGHT / DIRECTIONS, false) &&
         cover(k, &c, l, longer * PUSHED / DIRECTIONS, true);
  }
  return ok;
}

/* ---- a profile ---- */

static void turn_round(line *l) {
  for (size_t i = 0; i < l->n - 1 - i; i++) {
    size_t j = l->n - 1 - i;
    double z = l->z[i], p = l->p[i];
    l->z[i] = l->z[j];
    l->z[j] = z;
    l->p[i] = -l->p[j];
    l->p[j] = -p;
  }
}

/* In space both ways. */
static bool fill_row(class *k, const aspi_field *row, double lambda, bool in_space, line *l) {
  bool ok = make_room(l, (size_t)row->columns);
  l->n = (size_t)row->columns;
  l->step = row->step[0];
  l->every = (size_t)fmax(1, lambda / (STARTS * l->step));
  l->kink = (ASPI_KINK - 1) * l->step;
  for (size_t i = 0; i < l->n && ok; i++) {
    l->z[i] = (double)row->z[i];
    l->p[i] = aspi_field_slope(row, i);
    l->q[i] = 0;
  }
  for (int way = 0; way < (in_space ? 2 : 1) && ok; way++) {
    ok = add_straight(k, l) && find_valleys(k, l, add_start);
    k->way += (double)l->n * l->step;
    turn_round(l);
  }
  return ok;
}

/* ---- the tables ---- */

static int in_order(const void *a, const void *b) {
  const float x = *(const float *)a, y = *(const float *)b;
  return (x > y) - (x < y);
}

static void put_in_order(list *all) {
  if (all->n > 0) /* where a class has no valley, there is no list */
    qsort(all->values, all->n, sizeof *all->values, in_order);
}

void aspi_valleys_free(aspi_valleys *v) {
  for (int i = 0; v && i < v->sizes.bins * v->directions; i++) {
    free(v->class[i].start.values);
    free(v->class[i].height.values);
    free(v->class[i].face);
  }
  free(v);
}

static bool fill_bin(aspi_valleys *v, int bin, const asp_spread_model *model, const void *data,
                     const aspi_height_field *of, double lay) {
  class *at = &v->class[bin * v->directions];
  line l = {.radius = 0.5 * aspi_sizes_at(&v->sizes, bin)};
  const aspi_field *over;
  bool ok = true;
  for (int part = 0; ok && (over = model->field(data, bin, part)); part++) {
    ok = over->axes > 1 ? fill_map(at, v->directions, over, of->surface, lay, &l)
                        : fill_row(at, over, asp_surface_lambda_c(of->surface), of->in_space, &l);
    free(l.z);
  }
  for (class *k = at; k < at + v->directions && ok; k++) {
    put_in_order(&k->start);
    put_in_order(&k->height);
  }
  return ok;
}

aspi_valleys *aspi_valleys_create(const asp_spread_model *model, const void *data,
                                  const aspi_height_field *of, const aspi_sizes *sizes,
                                  asp_error *error) {
  asp_heights_numbers d = {.lay = 0};
  int directions = aspi_surface_stretch(of->surface) > 1 ? DIRECTIONS : 1;
  if (directions > 1 && asp_heights_describe(of->heights, &d, error))
    return NULL;
  aspi_valleys *v = calloc(1, sizeof *v + (size_t)(sizes->bins * directions) * sizeof *v->class);
  bool ok = v;
  if (v) {
    v->sizes = *sizes;
    v->directions = directions;
  }
  for (int i = 0; i < sizes->bins && ok; i++)
    ok = fill_bin(v, i, model, data, of, d.lay);
  if (ok)
    return v;
  aspi_valleys_free(v);
  aspi_fail(error, ASP_ENOMEM, "out of memory for the valleys of a %s",
            aspi_kind_of_rows(of->heights->rows));
  return NULL;
}

aspi_valley_table aspi_valleys_at(const aspi_valleys *v, double d_p, const double *azimuth) {
  const class *k = &v->class[aspi_sizes_nearest(&v->sizes, d_p) * v->directions];
  double turns = azimuth ? *azimuth / (2 * ASP_PI) : 0;
  k += lround(v->directions * (turns - floor(turns))) % v->directions;
  if (!k->start.n || !k->height.n || !k->faces)
    return (aspi_valley_table){0};
  return (aspi_valley_table){
      k->start.values, k->height.values,         k->face, k->start.n, k->height.n,
      k->faces,        k->way / (double)k->faces};
}
