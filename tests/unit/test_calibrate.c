/* Moments of impacts, of which some stick, by hand.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "analysis/calibrate.h"

TEST(deposits_are_a_share_of_all) {
  double xy[4][COR_BOTH] = {{0.1, 0.9}, {0.2, 0.8}, {0.4, 0.6}, {0.5, 0.9}};
  for (size_t deposits = 0; deposits < 13; deposits += 4) {
    const aspi_bin_moments m = aspi_calibration_moments(xy, 4, deposits);
    assert_near(m.of[MOMENT_STUCK], (double)deposits / (4 + (double)deposits), 1e-15);
    assert_near(m.of[MOMENT_X], 0.3, 1e-15);
    assert_near(m.of[MOMENT_Y], 0.8, 1e-15);
    assert_near(m.of[MOMENT_XX], 0.1 / 3, 1e-15);
    assert_near(m.of[MOMENT_YY], 0.06 / 3, 1e-15);
    assert_near(m.covariance[MOMENT_X][MOMENT_Y], -0.02 / 3, 1e-15);
    /* Squares about the means: 0.04, 0.01, 0.01, 0.04, their mean 0.025. */
    assert_near(m.covariance[MOMENT_XX][MOMENT_XX], 0.0009 / 3, 1e-15);
  }
}
