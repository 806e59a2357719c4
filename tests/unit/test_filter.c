/* The filters of instruments against the transmission that ISO 16610-21 gives them, against a tip
 * rolled over a wall here, and beside a deep valley.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "readers/read.h"

enum { POINTS = 16000 };
#define SPACING 0.5
#define LONG_WAVE 800.0
#define SHORT_WAVE 8.0

static double heights[POINTS];

/* Two waves, of amplitudes 1 and 0.1. */
static void set_waves(void) {
  for (int i = 0; i < POINTS; i++) {
    double x = i * SPACING;
    heights[i] = sin(2 * ASP_PI * x / LONG_WAVE) + 0.1 * sin(2 * ASP_PI * x / SHORT_WAVE);
  }
}

/* The amplitude of a wave over the middle half of the profile, which holds whole waves of it. */
static double amplitude(double wave) {
  double sum = 0;
  for (int i = POINTS / 5; i < POINTS * 4 / 5; i++)
    sum += heights[i] * sin(2 * ASP_PI * i * SPACING / wave);
  return 2 * sum / (POINTS * 3 / 5);
}

/* The share of a wave's amplitude that a Gaussian filter takes for long: half at the cut-off. */
static double share_of_long(double cutoff, double wave) {
  return exp2(-(cutoff / wave) * (cutoff / wave));
}

static void waves_pass_by_their_length(void **state) {
  (void)state;
  static const double cases[][2] = {{0, 80}, {0, 800}, {80, 0}, {8, 0}, {8, 80}, {16, 400}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    const aspi_filters filters = {.lambda_s = cases[i][0], .cutoff = cases[i][1]};
    set_waves();
    assert_int_equal(aspi_filter(heights, POINTS, SPACING, &filters, NULL), ASP_OK);
    double slow = 1, fast = 0.1;
    if (filters.lambda_s > 0) {
      slow *= share_of_long(filters.lambda_s, LONG_WAVE);
      fast *= share_of_long(filters.lambda_s, SHORT_WAVE);
    }
    if (filters.cutoff > 0) {
      slow *= 1 - share_of_long(filters.cutoff, LONG_WAVE);
      fast *= 1 - share_of_long(filters.cutoff, SHORT_WAVE);
    }
    assert_near(amplitude(LONG_WAVE), slow, 1e-3);
    assert_near(amplitude(SHORT_WAVE), fast, 1e-4);
  }
}

/* A tip of radius r over a wave that it reaches everywhere has measured its highest contact; taking
 * the tip out gives the wave back. */
static void tip_is_taken_out(void **state) {
  (void)state;
  static double wave[POINTS];
  const aspi_filters filters = {.tip = 20};
  int reach = (int)(filters.tip / SPACING);
  for (int i = 0; i < POINTS; i++)
    wave[i] = 2 * sin(2 * ASP_PI * i * SPACING / 50); /* least radius of curvature: 32 */
  for (int i = 0; i < POINTS; i++) {
    heights[i] = -INFINITY;
    for (int k = -reach; k <= reach; k++) {
      double x = k * SPACING, z = sqrt(filters.tip * filters.tip - x * x) - filters.tip;
      if (i + k >= 0 && i + k < POINTS)
        heights[i] = fmax(heights[i], wave[i + k] + z);
    }
  }
  double most = 0;
  for (int i = 0; i < POINTS; i++)
    most = fmax(most, heights[i] - wave[i]);
  assert_true(most > 0.3); /* in the valleys' flanks */
  assert_int_equal(aspi_filter(heights, POINTS, SPACING, &filters, NULL), ASP_OK);
  for (int i = 100; i < POINTS - 100; i++)
    assert_near(heights[i], wave[i], 0.005);
}

static void lengths_must_fit_the_profile(void **state) {
  (void)state;
  static const struct {
    aspi_filters filters;
    const char *word;
  } cases[] = {{{.tip = 0.2}, "tip is 0.2"},
               {{.lambda_s = 0.9}, "lambda_s is 0.9"},
               {{.cutoff = 8001}, "cutoff is 8001"},
               {{.lambda_s = 80, .cutoff = 80}, "less than the cutoff, 80"}};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    asp_error error;
    set_waves();
    assert_int_equal(aspi_filter(heights, POINTS, SPACING, &cases[i].filters, &error), ASP_EARG);
    assert_non_null(strstr(error.text, cases[i].word));
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(waves_pass_by_their_length),
      cmocka_unit_test(tip_is_taken_out),
      cmocka_unit_test(lengths_must_fit_the_profile),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
