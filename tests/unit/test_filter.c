/* The noise filter of instruments against the transmission that ISO 16610-21 gives it, and at the
 * ends of a profile.
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

TEST(waves_pass_by_their_length) {
  static const double cases[] = {8, 16, 80, 800};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    set_waves();
    assert_int_equal(aspi_filter(heights, POINTS, SPACING, cases[i], NULL), ASP_OK);
    assert_near(amplitude(LONG_WAVE), share_of_long(cases[i], LONG_WAVE), 1e-3);
    assert_near(amplitude(SHORT_WAVE), 0.1 * share_of_long(cases[i], SHORT_WAVE), 1e-4);
  }
}

/* Weights count within the profile alone: what is level stays so to its ends. */
TEST(ends_are_not_drawn_to_zero) {
  for (int i = 0; i < POINTS; i++)
    heights[i] = 3;
  assert_int_equal(aspi_filter(heights, POINTS, SPACING, 80, NULL), ASP_OK);
  for (int i = 0; i < POINTS; i++)
    assert_near(heights[i], 3, 1e-12);
}

TEST(length_must_fit_the_profile) {
  static const double cases[] = {0.9, 8001};
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    asp_error error;
    set_waves();
    assert_int_equal(aspi_filter(heights, POINTS, SPACING, cases[i], &error), ASP_EARG);
    assert_says(error.text, i ? "lambda_s is 8001" : "lambda_s is 0.9");
  }
}
