/* Rows of quantiles; see quantiles.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/quantiles.h"
#include "asperity_internal.h"

#include <math.h>
#include <string.h>

double aspi_shares_at(const aspi_shares *s, double place) {
  if (s->parts == 0) {
    if (place < s->cells)
      return place / s->cells;
    return place < s->nodes - 1 ? 1 - exp2(s->cells - 1 - place) / s->cells : 1;
  }
  double last = s->parts + s->cells - 2;
  if (place < s->parts)
    return place / ((double)s->parts * s->cells);
  if (place > last)
    return ((place - last) / s->parts + s->cells - 1) / s->cells;
  return (place - (s->parts - 1)) / s->cells;
}

aspi_place aspi_shares_place(const aspi_shares *s, double u) {
  double cell = u * s->cells, last = cell - (s->cells - 1), at = cell;
  if (s->parts == 0 && last > 0)
    at = s->cells - 1 - log2(fmax(1 - last, 1e-9));
  else if (s->parts > 0 && cell < 1)
    at = cell * s->parts;
  else if (s->parts > 0)
    at = last > 0 ? last * s->parts + (s->cells + s->parts - 2) : cell + (s->parts - 1);
  at = fmin(at, s->nodes - 1);
  int node = (int)fmin(at, s->nodes - 2);
  return (aspi_place){node, at - node};
}

double aspi_quantiles_between(const float *nodes, aspi_place place) {
  const float *at = nodes + place.node;
  return at[0] + place.part * ((double)at[1] - at[0]);
}

double aspi_quantile(const aspi_shares *shares, const float *nodes, double u) {
  return aspi_quantiles_between(nodes, aspi_shares_place(shares, u));
}

double aspi_quantiles_below(const aspi_shares *shares, const float *nodes, double value) {
  int low = 0, high = shares->nodes - 1;
  while (high - low > 1) {
    int middle = (low + high) / 2;
    *(nodes[middle] <= value ? &low : &high) = middle;
  }
  double step = (double)nodes[high] - nodes[low], share = aspi_shares_at(shares, low);
  double part = step > 0 ? fmin(fmax((value - nodes[low]) / step, 0), 1) : 0.5;
  return share + part * (aspi_shares_at(shares, high) - share);
}

/* A bin while its row is filled; `need` is the weight at which the next node is reached. */
typedef struct filling {
  double sum, total, last, need;
  int node;
} filling;

static void take_value(const aspi_shares *shares, double value, double weight, filling *f,
                       float *row) {
  f->sum += weight;
  f->last = value;
  while (f->need <= f->sum) {
    row[f->node++] = (float)value;
    f->need = f->node < shares->nodes ? aspi_shares_at(shares, f->node) * f->total : INFINITY;
  }
}

static void copy_to_empty(const filling *f, int bins, size_t nodes, float *table) {
  int first = 0;
  while (first < bins - 1 && !(f[first].total > 0))
    first++;
  for (int b = 0; b < bins; b++)
    if (!(f[b].total > 0)) {
      int from = b < first ? first : b - 1;
      memcpy(table + (size_t)b * nodes, table + (size_t)from * nodes, nodes * sizeof *table);
    }
}

void aspi_quantiles_fill(const aspi_shares *shares, const aspi_sample *sample, int bins,
                         float *table) {
  int nodes = shares->nodes;
  filling f[ASPI_SAMPLE_BINS] = {{0}};
  f[0].total = 1;
  for (int b = 0; sample->bin && b < bins; b++)
    f[b].total = sample->total[b];
  for (size_t i = 0; i < sample->n; i++) {
    size_t at = sample->order[i];
    if (!(sample->weight[at] > 0))
      continue;
    int b = sample->bin ? sample->bin[at] : 0;
    take_value(shares, sample->value[i], sample->weight[at], &f[b], table + b * nodes);
  }
  for (int b = 0; b < bins; b++)
    for (; f[b].node < nodes; f[b].node++)
      table[b * nodes + f[b].node] = (float)f[b].last;
  copy_to_empty(f, bins, (size_t)nodes, table);
}

static double angle_step(int nodes) {
  return ASP_PI / 2 / ((nodes - 1.) * (nodes - 1.));
}

double aspi_angle_at(int nodes, int node) {
  return angle_step(nodes) * node * node;
}

aspi_place aspi_angle_place(int nodes, double alpha1) {
  double step = angle_step(nodes), angle = fmax(alpha1, 0);
  int k = (int)fmin(sqrt(angle / step), nodes - 2);
  return (aspi_place){k, (angle - step * k * k) / (step * (2 * k + 1))};
}
