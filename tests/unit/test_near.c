/* Impacts near a place against a search through all of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "analysis/near.h"
#include "base/stream.h"

#include <stdlib.h>

enum { ROWS = 3000, QUERIES = 200 };

static aspi_scatter_row rows[ROWS];
static double weights[ROWS];

static bool is_close(double value, double wanted, double share) {
  return isnan(value - wanted) || fabs(value - wanted) <= share * wanted;
}

/* Many equal numbers among others, and some that are unknown. */
static aspi_scatter_row draw_row(aspi_stream *s) {
  double kind = aspi_stream_uniform(s), angle = 90 * aspi_stream_uniform(s);
  aspi_scatter_row row = {.degrees = kind < 0.5 ? floor(angle / 10) * 10 : angle,
                          .v1 = 100 * aspi_stream_uniform(s),
                          .d_p = kind < 0.7 ? 1e-5 : 1e-5 * aspi_stream_uniform(s),
                          .rows = floor(1 + 3 * aspi_stream_uniform(s))};
  if (aspi_stream_uniform(s) < 0.1)
    row.v1 = NAN;
  if (aspi_stream_uniform(s) < 0.1)
    row.d_p = NAN;
  return row;
}

static double by_search(const aspi_scatter_row *at, const aspi_compare_reach *reach, double each) {
  double sum = 0;
  for (int i = 0; i < ROWS; i++) {
    if (fabs(rows[i].degrees - at->degrees) > reach->degrees ||
        !is_close(rows[i].v1, at->v1, reach->speed) || !is_close(rows[i].d_p, at->d_p, reach->size))
      continue;
    sum += rows[i].rows;
    weights[i] += each;
  }
  return sum;
}

TEST(as_by_search) {
  static const aspi_compare_reach reaches[] = {{1e-4, 1e-4, 1e-4}, {5, 0.2, 0.3}, {90, 9, 9}};
  static aspi_weighted taken[ROWS];
  aspi_stream s = aspi_stream_begin(&(asp_key){4, 4, 4, 4, 0});
  for (int i = 0; i < ROWS; i++)
    rows[i] = draw_row(&s);
  const aspi_scatter all = {.rows = rows, .count = ROWS};
  aspi_near *near = aspi_near_create(&all, &reaches[1]);
  assert_non_null(near);
  for (int q = 0; q < QUERIES; q++) {
    memset(weights, 0, sizeof weights);
    for (int k = 0; k < 5; k++) { /* of one bin */
      const aspi_scatter_row at = q % 2 ? rows[(q * 37 + k) % ROWS] : draw_row(&s);
      const aspi_compare_reach *reach = &reaches[(q + k) % 3];
      assert_near(aspi_near_find(near, &at, reach), by_search(&at, reach, 0.5 + k), 0);
      aspi_near_weigh(near, 0.5 + k);
    }
    size_t n = aspi_near_take(near, taken), expected = 0;
    for (int i = 0; i < ROWS; i++)
      expected += weights[i] > 0;
    assert_int_equal(n, expected);
    for (size_t i = 0; i < n; i++)
      assert_near(taken[i].weight, weights[taken[i].row - rows], 1e-9);
  }
  assert_int_equal(aspi_near_take(near, taken), 0);
  aspi_near_free(near);
}

TEST(none_is_near_nothing) {
  const aspi_scatter empty = {.count = 0};
  const aspi_compare_reach reach = {0, 0, 0};
  const aspi_scatter_row at = {.degrees = 3};
  aspi_near *near = aspi_near_create(&empty, &reach);
  aspi_weighted taken;
  assert_non_null(near);
  assert_near(aspi_near_find(near, &at, &reach), 0, 0);
  aspi_near_weigh(near, 1);
  assert_int_equal(aspi_near_take(near, &taken), 0);
  aspi_near_free(near);
}
