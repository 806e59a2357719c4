/* Impacts at the places of measurements; see compare.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/compare.h"
#include "analysis/window.h"
#include "base/error.h"

#include <math.h>
#include <stdlib.h>

/* Places are the same that differ by less: in degrees, and as a share. */
#define SAME_ANGLE 1e-4
#define SAME_SHARE 1e-4

/* With fewer impacts than this at a place, those near it count too. */
enum { ENOUGH = 20 };

/* With this many measurements per place on average, every place is a bin of its own. */
enum { ROWS_EACH = 4 };

/* How many of the points, which are in order of their angle, lie below it. */
static size_t count_below(const scatter_impacts *impacts, double angle) {
  size_t low = 0, high = impacts->count;
  while (low < high) {
    size_t middle = low + (high - low) / 2;
    if (impacts->points[middle].degrees < angle)
      low = middle + 1;
    else
      high = middle;
  }
  return low;
}

static bool is_near(double is, double wanted, double share) {
  return isnan(wanted) || fabs(is - wanted) <= share * wanted;
}

static bool same_place(const measured_row *a, const measured_row *b) {
  return fabs(a->degrees - b->degrees) <= SAME_ANGLE &&
         (isnan(a->v1) || is_near(a->v1, b->v1, SAME_SHARE)) &&
         (isnan(a->d_p) || is_near(a->d_p, b->d_p, SAME_SHARE));
}

/* ---- the bins' rows ---------------------------------------------------------------------------
 */

static size_t count_places(const measured *data) {
  size_t places = 0;
  for (size_t i = 0; i < data->count; i++)
    places += i == 0 || !same_place(&data->rows[i], &data->rows[i - 1]);
  return places;
}

/* Which interval of that width an angle is in; the last one ends with 90 degrees. */
static double interval_of(const measured_row *row, double width) {
  return floor(fmin(row->degrees, 90 - 1e-6) / width + 1e-9);
}

static asp_code no_memory(size_t count, asp_error *error) {
  return aspi_fail(error, ASP_ENOMEM, "out of memory for %zu impacts", count);
}

static void describe_place(const measured *data, aspi_compare_bin *on) {
  double n = (double)(on->end - on->first);
  for (size_t i = on->first; i < on->end; i++) {
    on->degrees += data->rows[i].degrees / n;
    on->v1 += data->rows[i].v1 / n;
    on->d_p += data->rows[i].d_p / n;
    on->data_deposits += data->rows[i].deposit;
  }
  on->deposits_p = NAN;
  for (int k = 0; k < COR_BOTH; k++)
    on->in_band[k] = on->distance[k] = on->p[k] = NAN;
}

asp_code aspi_compare_make_bins(aspi_comparison *c, double width, bool given, asp_error *error) {
  const measured *data = &c->data;
  bool places = !data->means && !given && data->count >= ROWS_EACH * count_places(data);
  c->bins = calloc(data->count + 1, sizeof *c->bins);
  if (!c->bins)
    return no_memory(data->count, error);
  for (size_t i = 0; i < data->count; i++) {
    const measured_row *row = &data->rows[i], *last = i ? row - 1 : row;
    bool joins =
        i > 0 && !data->means &&
        (places ? same_place(row, last) : interval_of(row, width) <= interval_of(last, width));
    if (!joins)
      c->bins[c->count++] = (aspi_compare_bin){.first = i};
    c->bins[c->count - 1].end = i + 1;
  }
  for (size_t b = 0; b < c->count; b++)
    describe_place(data, &c->bins[b]);
  return ASP_OK;
}

/* ---- impacts at a place -----------------------------------------------------------------------
 */

/* The impacts that weigh in a bin, and how much. */
typedef struct weights {
  double *of;    /* of each impact */
  size_t *which; /* those that have a weight */
  size_t count;
} weights;

static bool is_around(const scatter_point *p, const measured_row *at,
                      const aspi_compare_reach *far) {
  return is_near(p->v1, at->v1, far->speed) && is_near(p->d_p, at->d_p, far->size);
}

static size_t count_near(const scatter_impacts *impacts, const measured_row *at,
                         const aspi_compare_reach *far) {
  size_t found = 0;
  const scatter_point *p = impacts->points;
  for (size_t i = count_below(impacts, at->degrees - far->degrees);
       i < impacts->count && p[i].degrees <= at->degrees + far->degrees; i++)
    found += is_around(&p[i], at, far);
  return found;
}

/* Gives the impacts around a place, no farther than that, a weight of `rows` together. */
static void weigh(const scatter_impacts *impacts, const measured_row *at,
                  const aspi_compare_reach *far, double rows, weights *w) {
  double each = rows / (double)count_near(impacts, at, far);
  const scatter_point *p = impacts->points;
  for (size_t i = count_below(impacts, at->degrees - far->degrees);
       i < impacts->count && p[i].degrees <= at->degrees + far->degrees; i++) {
    if (!is_around(&p[i], at, far))
      continue;
    if (!(w->of[i] > 0))
      w->which[w->count++] = i;
    w->of[i] += each;
  }
}

/* Gives weights to the model's impacts in a bin. */
static void weigh_bin(const aspi_comparison *c, const aspi_compare_reach *far, weights *w,
                      aspi_compare_bin *b) {
  static const aspi_compare_reach same = {SAME_ANGLE, SAME_SHARE, SAME_SHARE};
  const measured_row *rows = c->data.rows;
  b->from = 90;
  b->to = 0;
  w->count = 0;
  for (size_t i = b->first, next; i < b->end; i = next) {
    for (next = i + 1; next < b->end && same_place(&rows[i], &rows[next]);)
      next++;
    double n = (double)(next - i);
    size_t at = count_near(&c->impacts, &rows[i], &same);
    bool exact = at >= ENOUGH || (at > 0 && at == count_near(&c->impacts, &rows[i], far));
    weigh(&c->impacts, &rows[i], exact ? &same : far, n, w);
    double wide = exact ? 0 : far->degrees;
    b->from = fmax(0, fmin(b->from, rows[i].degrees - wide));
    b->to = fmin(90, fmax(b->to, rows[i].degrees + wide));
  }
}

/* The model's sample in a bin, and its deposits. False: out of memory. */
static bool sample_model(const aspi_comparison *c, const aspi_compare_reach *far, weights *w,
                         aspi_compare_bin *b) {
  weigh_bin(c, far, w, b);
  double total = 0, stuck = 0, squares = 0;
  for (size_t i = 0; i < w->count; i++) {
    double weight = w->of[w->which[i]];
    total += weight;
    squares += weight * weight;
    stuck += c->impacts.points[w->which[i]].deposit ? weight : 0;
  }
  b->model_all = total > 0 ? total * total / squares : 0;
  b->model_deposits = total > 0 ? stuck / total * b->model_all : 0;
  for (int k = 0; k < COR_BOTH; k++) {
    aspi_sample *s = &b->model[k];
    if (!(s->values = calloc(w->count + 1, sizeof *s->values)))
      return false;
    for (size_t i = 0; i < w->count; i++)
      if (isfinite(c->impacts.points[w->which[i]].cor[k]))
        s->values[s->count++] =
            (aspi_weighted){c->impacts.points[w->which[i]].cor[k], w->of[w->which[i]]};
    aspi_sample_describe(s);
  }
  while (w->count > 0)
    w->of[w->which[--w->count]] = 0;
  return true;
}

/* False: out of memory. */
static bool sample_data(const measured *data, aspi_compare_bin *b) {
  for (int k = 0; k < COR_BOTH; k++) {
    aspi_sample *s = &b->data[k];
    const measured_row *row = &data->rows[b->first];
    *s = (aspi_sample){
        .mean = row->cor[k], .sd = row->sd[k], .median = NAN, .low = NAN, .high = NAN};
    if (data->means)
      continue;
    if (!(s->values = calloc(b->end - b->first, sizeof *s->values)))
      return false;
    for (size_t i = b->first; i < b->end; i++)
      if (isfinite(data->rows[i].cor[k]))
        s->values[s->count++] = (aspi_weighted){data->rows[i].cor[k], 1};
    aspi_sample_describe(s);
  }
  return true;
}

/* Rows of means without speeds and sizes, as many as there may be, by a window that moves over the
 * impacts. */
static bool sample_by_window(aspi_comparison *c, double far, int which) {
  const scatter_point *points = c->impacts.points;
  aspi_window *window =
      aspi_window_create(&points->degrees, &points->cor[which], sizeof *points, c->impacts.count);
  if (!window)
    return false;
  for (size_t i = 0; i < c->count; i++) {
    aspi_compare_bin *b = &c->bins[i];
    size_t at = count_below(&c->impacts, b->degrees + SAME_ANGLE) -
                count_below(&c->impacts, b->degrees - SAME_ANGLE);
    size_t around =
        count_below(&c->impacts, b->degrees + far) - count_below(&c->impacts, b->degrees - far);
    bool exact = at >= ENOUGH || (at > 0 && at >= around);
    double wide = exact ? 0 : far, slack = exact ? SAME_ANGLE : 0;
    b->from = fmax(0, b->degrees - wide);
    b->to = fmin(90, b->degrees + wide);
    aspi_window_move(window, b->from - slack, b->to + slack);
    aspi_sample *s = &b->model[which];
    *s = (aspi_sample){.count = aspi_window_count(window)};
    s->mean = s->sd = s->median = s->low = s->high = NAN;
    s->size = (double)s->count;
    if (s->count > 0) {
      aspi_window_moments(window, &s->mean, &s->sd);
      s->sd = s->count > 1 ? s->sd : NAN;
      s->median = aspi_window_quantile(window, 0.5);
    }
    if (s->count >= 20) {
      s->low = aspi_window_quantile(window, 0.05);
      s->high = aspi_window_quantile(window, 0.95);
    }
  }
  aspi_window_free(window);
  return true;
}

/* ---- one bin ----------------------------------------------------------------------------------
 */

bool aspi_compare_has_both(const aspi_compare_bin *b, int which) {
  return isfinite(b->data[which].mean) && b->model[which].count > 0;
}

/* A mean whose standard error is known, against the model's. */
static double p_of_means(const aspi_sample *model, const measured_row *row, int which) {
  double error = isfinite(row->se[which]) ? row->se[which] : row->sd[which] / sqrt(row->n);
  double own = model->sd / sqrt(model->size);
  double z = fabs(model->mean - row->cor[which]) / hypot(error, isfinite(own) ? own : 0);
  return isfinite(z) ? erfc(z / sqrt(2)) : NAN;
}

static void compare_bin_of(const aspi_comparison *c, aspi_compare_bin *b) {
  size_t rows = b->end - b->first;
  for (int k = 0; k < COR_BOTH; k++) {
    const aspi_sample *m = &b->model[k], *d = &b->data[k];
    if (!aspi_compare_has_both(b, k))
      continue;
    if (c->data.means) {
      b->p[k] = p_of_means(m, &c->data.rows[b->first], k);
      continue;
    }
    if (isfinite(m->low))
      b->in_band[k] = aspi_sample_within(d, m->low, m->high);
    b->distance[k] = aspi_sample_distance(m, d);
    b->p[k] = aspi_sample_p_value(m, d, b->distance[k]);
  }
  if (c->data.has_outcome && b->model_all >= 1 && b->model_deposits + b->data_deposits > 0)
    b->deposits_p =
        aspi_shares_p_value((size_t)(b->model_deposits + 0.5), (size_t)(b->model_all + 0.5),
                            (size_t)b->data_deposits, rows);
}

static int by_angle(const void *left, const void *right) {
  const scatter_point *a = left, *b = right;
  return (a->degrees > b->degrees) - (a->degrees < b->degrees);
}

asp_code aspi_compare_fill(aspi_comparison *c, const aspi_compare_reach *far, asp_error *error) {
  bool by_window = c->data.means && !c->data.has_speed && !c->data.has_size;
  weights w = {calloc(c->impacts.count + 1, sizeof *w.of),
               calloc(c->impacts.count + 1, sizeof *w.which), 0};
  bool fine = w.of && w.which;
  qsort(c->impacts.points, c->impacts.count, sizeof *c->impacts.points, by_angle);
  for (int k = 0; k < COR_BOTH && by_window && fine; k++)
    fine = sample_by_window(c, far->degrees, k);
  for (size_t i = 0; i < c->count && fine; i++) {
    aspi_compare_bin *b = &c->bins[i];
    fine = (by_window || sample_model(c, far, &w, b)) && sample_data(&c->data, b);
    if (fine)
      compare_bin_of(c, b);
  }
  free(w.of);
  free(w.which);
  return fine ? ASP_OK : no_memory(c->impacts.count, error);
}

asp_code aspi_compare_fill_alone(aspi_comparison *c, asp_error *error) {
  for (size_t i = 0; i < c->count; i++) {
    aspi_compare_bin *b = &c->bins[i];
    if (!sample_data(&c->data, b))
      return no_memory(c->data.count, error);
    for (int k = 0; k < COR_BOTH; k++) {
      b->model[k] = b->data[k];
      b->data[k] = (aspi_sample){.mean = NAN, .sd = NAN};
    }
    b->from = c->data.rows[b->first].degrees;
    b->to = c->data.rows[b->end - 1].degrees;
  }
  return ASP_OK;
}

void aspi_compare_free_bins(aspi_comparison *c) {
  for (size_t i = 0; i < c->count; i++)
    for (int k = 0; k < COR_BOTH; k++) {
      free(c->bins[i].model[k].values);
      free(c->bins[i].data[k].values);
    }
  free(c->bins);
}
