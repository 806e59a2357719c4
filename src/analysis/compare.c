/* Impacts at the places of measurements; see compare.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/compare.h"
#include "base/error.h"

#include <gsl/gsl_sort.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Tolerances of equal places: degrees, and relative. */
#define SAME_ANGLE 1e-4
#define SAME_SHARE 1e-4

/* With fewer impacts than this at a place, those near it count too. */
enum { ENOUGH = 20 };

/* Between the borders of more measured rows than this hardly any impacts are equivalent. */
enum { BORDERED_MOST = 1 << 17 };

/* Every place is a bin of its own if nearly all places, this share, have this many measurements. */
enum { ROWS_EACH = 4 };
#define NEARLY_ALL 0.9

/* An unknown one is near any. */
static bool is_near(double value, double wanted, double share) {
  return isnan(value - wanted) || fabs(value - wanted) <= share * wanted;
}

static bool same_place(const aspi_scatter_row *a, const aspi_scatter_row *b) {
  return fabs(a->degrees - b->degrees) <= SAME_ANGLE && is_near(a->v1, b->v1, SAME_SHARE) &&
         is_near(a->d_p, b->d_p, SAME_SHARE);
}

static asp_code no_memory(size_t count, asp_error *error) {
  return aspi_fail(error, ASP_ENOMEM, "out of memory for %zu impacts", count);
}

static const aspi_compare_reach same = {SAME_ANGLE, SAME_SHARE, SAME_SHARE};

asp_code aspi_compare_grouping(const aspi_scatter *data, const aspi_compare_reach *far,
                               aspi_grouping *grouping, asp_error *error) {
  const aspi_compare_reach *const reach[] = {&same, far};
  *grouping = (aspi_grouping){.width = 0};
  for (int d = 0; d < 3 && data->count <= BORDERED_MOST; d++) {
    double *border = grouping->border[d] = malloc((4 * data->count + 1) * sizeof *border);
    if (!border)
      return no_memory(data->count, error);
    for (size_t i = 0; i < 4 * data->count; i++) {
      const aspi_scatter_row *row = &data->rows[i / 4];
      const aspi_compare_reach *by = reach[i / 2 % 2];
      double sign = i % 2 ? 1 : -1;
      double at = d == 0   ? row->degrees + sign * by->degrees
                  : d == 1 ? row->v1 * (1 + sign * by->speed)
                           : row->d_p * (1 + sign * by->size);
      if (!isnan(at))
        border[grouping->count[d]++] = at;
    }
    gsl_sort(border, 1, grouping->count[d]);
  }
  return ASP_OK;
}

void aspi_compare_grouping_free(aspi_grouping *grouping) {
  for (int d = 0; d < 3; d++)
    free(grouping->border[d]);
}

/* True if places were measured repeatedly. A ledger of a curved wall has some such places, and many
 * that were hit once. */
static bool is_of_places(const aspi_scatter *data) {
  size_t places = 0, often = 0;
  double before = 0;
  for (size_t i = 0; i < data->count; i++) {
    bool again = i > 0 && same_place(&data->rows[i], &data->rows[i - 1]);
    double rows = data->rows[i].rows + (again ? before : 0);
    places += !again;
    often += rows >= ROWS_EACH && !(again && before >= ROWS_EACH);
    before = rows;
  }
  return !data->by_interval && (double)often >= NEARLY_ALL * (double)places;
}

static void describe_place(const aspi_scatter *data, aspi_compare_bin *on) {
  double n = 0;
  for (size_t i = on->first; i < on->end; i++)
    n += data->rows[i].rows;
  for (size_t i = on->first; i < on->end; i++) {
    double share = data->rows[i].rows / n;
    on->degrees += data->rows[i].degrees * share;
    on->v1 += data->rows[i].v1 * share;
    on->d_p += data->rows[i].d_p * share;
  }
}

asp_code aspi_compare_make_bins(aspi_comparison *c, double width, bool given, asp_error *error) {
  const aspi_scatter *data = &c->data;
  bool places = !data->means && !given && is_of_places(data);
  const bool clusters = aspi_scatter_is_clustered(data, width);
  c->bins = calloc(data->count + 1, sizeof *c->bins);
  if (!c->bins)
    return no_memory(data->count, error);
  for (size_t i = 0; i < data->count; i++) {
    bool joins = i > 0 && !data->means &&
                 (places ? same_place(&data->rows[i], &data->rows[i - 1])
                         : aspi_scatter_joins(data, i, width, clusters));
    if (!joins)
      c->bins[c->count++] = (aspi_compare_bin){.first = i};
    c->bins[c->count - 1].end = i + 1;
  }
  for (size_t b = 0; b < c->count; b++)
    describe_place(data, &c->bins[b]);
  return ASP_OK;
}

/* Source of the model's impacts in the bins. taken: those of one bin. */
typedef struct source {
  aspi_near *near;
  const aspi_compare_reach *far;
  aspi_weighted *taken;
} source;

/* Gives weights to the model's impacts in a bin: those near a measured place get the weight of the
 * measurements there together. */
static void weigh_bin(const aspi_comparison *c, const source *from, aspi_compare_bin *b) {
  const aspi_scatter_row *rows = c->data.rows;
  b->from = 90;
  b->to = 0;
  for (size_t i = b->first, next; i < b->end; i = next) {
    double n = rows[i].rows;
    for (next = i + 1; next < b->end && same_place(&rows[i], &rows[next]);)
      n += rows[next++].rows;
    double found = aspi_near_find(from->near, &rows[i], &same);
    bool exact = found >= ENOUGH;
    if (!exact) {
      double there = found;
      found = aspi_near_find(from->near, &rows[i], from->far);
      exact = there > 0 && there >= found;
      if (exact)
        found = aspi_near_find(from->near, &rows[i], &same);
    }
    if (found > 0)
      aspi_near_weigh(from->near, n / found);
    double wide = exact ? 0 : from->far->degrees;
    b->from = fmax(0, fmin(b->from, rows[i].degrees - wide));
    b->to = fmin(90, fmax(b->to, rows[i].degrees + wide));
  }
}

/* The model's impacts in a bin. False: out of memory. */
static bool take_model(const aspi_comparison *c, const source *from, aspi_compare_bin *b) {
  weigh_bin(c, from, b);
  aspi_side *side = &b->model;
  side->count = aspi_near_take(from->near, from->taken);
  side->impacts = malloc((side->count + 1) * sizeof *side->impacts);
  if (side->impacts)
    memcpy(side->impacts, from->taken, side->count * sizeof *side->impacts);
  return side->impacts;
}

/* The measured impacts, or means. An sd without a number of impacts counts as one impact. */
static bool take_data(const aspi_scatter *data, aspi_compare_bin *b) {
  const aspi_scatter_row *row = &data->rows[b->first];
  aspi_side *side = &b->data;
  for (int k = 0; k < ASPI_QUANTITIES; k++)
    side->of[k] = aspi_sample_none;
  for (int k = 0; k < ASPI_COMPARED && data->means; k++) {
    aspi_sample *s = &side->of[k];
    s->mean = row->cor[k];
    s->sd = row->sd[k];
    s->size = row->n;
    s->mean_se = isfinite(row->se[k]) ? row->se[k] : s->sd / sqrt(isfinite(row->n) ? row->n : 1);
  }
  if (data->means)
    return true;
  if (!(side->impacts = malloc((b->end - b->first) * sizeof *side->impacts)))
    return false;
  for (; side->count < b->end - b->first; row++)
    side->impacts[side->count++] = (aspi_weighted){row, 1};
  aspi_side_describe(side);
  return true;
}

static void free_impacts(aspi_side *side) {
  free(side->impacts);
  side->impacts = NULL;
}

asp_code aspi_compare_fill(aspi_comparison *c, const aspi_compare_reach *far, asp_error *error) {
  source from = {far ? aspi_near_create(&c->impacts, far) : NULL, far,
                 malloc((c->impacts.count + 1) * sizeof *from.taken)};
  aspi_score score = {0};
  bool fine = (from.near || !far) && from.taken;
  for (size_t i = 0; i < c->count && fine; i++) {
    aspi_compare_bin *b = &c->bins[i];
    fine = take_data(&c->data, b) && (!far || take_model(c, &from, b));
    if (!far && fine) {
      b->model = b->data;
      b->data = (aspi_side){.count = 0};
      for (int k = 0; k < ASPI_QUANTITIES; k++)
        b->data.of[k] = aspi_sample_none;
      b->from = 90;
      b->to = 0;
      for (size_t row = b->first; row < b->end; row++) {
        b->from = fmin(b->from, c->data.rows[row].least);
        b->to = fmax(b->to, c->data.rows[row].most);
      }
    }
    if (fine)
      aspi_side_describe(&b->model);
    if (!c->data.has_outcome)
      b->data.of[ASPI_DEPOSITS] = aspi_sample_none;
    aspi_score_add(&score, &b->model, &b->data);
    free_impacts(&b->model);
    free_impacts(&b->data);
  }
  c->score = aspi_score_end(&score);
  aspi_near_free(from.near);
  free(from.taken);
  return fine ? ASP_OK : no_memory(c->impacts.count, error);
}
