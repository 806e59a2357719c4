/* Where a flight over a row continues after a hit on an isotropic wall. The rebound turns the
 * flight, and the wall along the new direction is another cut than the row. Given the height and
 * the slope at a place, all cuts of an isotropic wall have one law, so any place of the row with
 * that height and slope, in either direction, stands for the new cut. Its curvature depends on the
 * old cut's: given the height, the curvatures of two cuts of Gaussian heights at an angle f have
 * the correlation cos^2 f. In that share of the moves the new place therefore has the old
 * curvature. Without this, particles that skip along a valley forget it, and up to a third too many
 * stick. The joint law of both cuts is symmetric; so elastic rebounds can be reversed, and keep the
 * cosine law. (Derived for this project.)
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/places.h"
#include "base/error.h"
#include "base/search.h"

#include <math.h>
#include <stdlib.h>

/* Most places of an index. Four times as many change nothing for elastic particles. */
enum { PLACES_MOST = 32768 };

/* Weight of the slope against height and curvature, all in standard deviations. With weight 1 too
 * many particles leave at grazing angles. */
#define SLOPE_COUNTS 8

/* Curvatures are second differences over this share of the row's wavelength. */
#define BEND_SHARE 0.125

static int by_height(const void *a, const void *b) {
  const aspi_row_place *x = a, *y = b;
  return (x->height > y->height) - (x->height < y->height);
}

static int by_steepness(const void *a, const void *b) {
  const aspi_row_place *x = a, *y = b;
  return (x->steepness > y->steepness) - (x->steepness < y->steepness);
}

static size_t strip_size(const aspi_row_places *p, size_t strip) {
  size_t left = p->count - strip * p->strip;
  return left < p->strip ? left : p->strip;
}

static void sort(aspi_row_places *p) {
  qsort(p->place, p->count, sizeof *p->place, by_height);
  for (size_t k = 0; k < p->strips; k++) {
    aspi_row_place *first = p->place + k * p->strip;
    p->bottom[k] = first->height;
    qsort(first, strip_size(p, k), sizeof *first, by_steepness);
  }
}

/* The second difference of the heights around the face behind point i. */
static double bend_at(const aspi_row_places *p, const aspi_field *row, ptrdiff_t i) {
  ptrdiff_t n = row->columns, before = i - p->reach, after = i + 1 + p->reach;
  before = before < 0 ? before + n : before;
  after = after < n ? after : after - n;
  double middle = (double)row->z[i] + (double)row->z[i + 1 < n ? i + 1 : 0];
  return (double)row->z[before] + (double)row->z[after] - middle;
}

/* The curvatures, and their unit; `ratio` is rms height over rms slope. */
static void set_bends(aspi_row_places *p, const aspi_field *row, double r_q, double ratio) {
  double share = BEND_SHARE * sqrt(2) * ratio / row->step[0], square = 0;
  p->reach = (ptrdiff_t)fmin(fmax(share, 1), 0.25 * (double)row->columns);
  for (size_t i = 0; i < p->count; i++) {
    double bend = bend_at(p, row, p->place[i].cell);
    p->place[i].bend = (float)bend;
    square += bend * bend / (double)p->count;
  }
  p->bend_unit = square > 0 ? r_q / sqrt(square) : 0;
}

asp_code aspi_row_places_create(aspi_row_places *p, const aspi_field *row, asp_error *error) {
  size_t n = (size_t)row->columns, every = (n + PLACES_MOST - 1) / PLACES_MOST;
  *p = (aspi_row_places){.count = n / every};
  p->strip = (size_t)ceil(4 * sqrt((double)p->count)); /* long ones: the slope counts more */
  p->strips = (p->count + p->strip - 1) / p->strip;
  p->place = malloc(p->count * sizeof *p->place + p->strips * sizeof *p->bottom);
  p->bottom = (float *)(p->place + p->count);
  if (!p->place)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for %zu places of a profile", p->count);
  double mean = 0, square = 0, steep = 0;
  for (size_t i = 0; i < p->count; i++) {
    double slope = aspi_field_slope(row, i * every);
    double z = (double)row->z[i * every] + 0.5 * slope * row->step[0];
    p->place[i] = (aspi_row_place){(float)z, (float)fabs(slope), 0, (int)(i * every)};
    mean += z / (double)p->count;
    square += z * z / (double)p->count;
    steep += slope * slope / (double)p->count;
  }
  double r_q = sqrt(fmax(0, square - mean * mean)), ratio = steep > 0 ? r_q / sqrt(steep) : 0;
  p->unit = SLOPE_COUNTS * ratio;
  set_bends(p, row, r_q, ratio);
  sort(p);
  return ASP_OK;
}

void aspi_row_places_free(aspi_row_places *p) {
  free(p->place);
}

/* A search: the wanted place, and the best one so far. */
typedef struct search {
  double height, steepness, bend;
  double bend_unit; /* 0: any curvature */
  double off;       /* square of the distance of the best one */
  const aspi_row_place *best;
} search;

/* False if all places beyond this one in its strip are farther off than the best. */
static bool look_at(const aspi_row_places *p, const aspi_row_place *at, search *s) {
  double steepness = (double)at->steepness, aside = p->unit * (steepness - s->steepness);
  if (aside * aside >= s->off)
    return false;
  double up = (double)at->height - s->height, turn = s->bend_unit * ((double)at->bend - s->bend);
  double off = aside * aside + up * up + turn * turn;
  if (off < s->off) {
    s->off = off;
    s->best = at;
  }
  return true;
}

static bool is_flatter(const void *places, size_t i, double steepness) {
  return (double)((const aspi_row_place *)places)[i].steepness < steepness;
}

static void look_through(const aspi_row_places *p, size_t strip, search *s) {
  const aspi_row_place *first = p->place + strip * p->strip;
  size_t n = strip_size(p, strip), low = aspi_count_below(first, n, s->steepness, is_flatter);
  for (size_t i = low; i < n && look_at(p, &first[i], s); i++)
    ;
  for (size_t i = low; i > 0 && look_at(p, &first[i - 1], s); i--)
    ;
}

static bool begins_below(const void *bottom, size_t i, double height) {
  return (double)((const float *)bottom)[i] <= height;
}

/* The strip of a height. */
static size_t strip_at(const aspi_row_places *p, double height) {
  return aspi_count_below(p->bottom + 1, p->strips - 1, height, begins_below);
}

/* True if a strip whose nearest height this is may have a better place. */
static bool in_reach(const search *s, float height) {
  double up = (double)height - s->height;
  return up * up < s->off;
}

static const aspi_row_place *find(const aspi_row_places *p, search *s) {
  size_t at = strip_at(p, s->height);
  look_through(p, at, s);
  for (size_t k = at + 1; k < p->strips && in_reach(s, p->bottom[k]); k++)
    look_through(p, k, s);
  for (size_t k = at; k > 0 && in_reach(s, p->bottom[k]); k--)
    look_through(p, k - 1, s);
  return s->best;
}

double aspi_row_places_move(const aspi_row_places *p, const aspi_field *row, double slope,
                            bool bends_alike, aspi_spot *spot, bool *back) {
  ptrdiff_t last = row->columns - 1, here = (ptrdiff_t)spot->x[0];
  double bend = bend_at(p, row, here < last ? here : last);
  search s = {spot->z,  fabs(slope), bend, bends_alike ? p->bend_unit : 0,
              INFINITY, p->place}; /* the first place for a slope of NaN */
  const aspi_row_place *at = find(p, &s);
  double own = aspi_field_slope(row, (size_t)at->cell), first = (double)row->z[at->cell];
  double up = (spot->z - first) / row->step[0];
  double part = fabs(own) > 0 ? fmin(fmax(up / own, 0), 1) : 0.5;
  *back = (own < 0) != (slope < 0);
  spot->x[0] = (double)at->cell + part;
  spot->z = first + part * own * row->step[0];
  return slope - (*back ? -own : own);
}
