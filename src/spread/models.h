/* What the spread models share, and the list of them. A new model is one file
 * that defines its record, and one line here. */
#ifndef ASP_SPREAD_MODELS_H
#define ASP_SPREAD_MODELS_H

#include "asperity.h"

#define ASP_SPREAD_MODELS(X)                                                                       \
  X(none)                                                                                          \
  X(normal)                                                                                        \
  X(rejection)                                                                                     \
  X(effective)                                                                                     \
  X(truncated)                                                                                     \
  X(weibull)                                                                                       \
  X(multicollision)                                                                                \
  X(visible)                                                                                       \
  X(profile)                                                                                       \
  X(traced)

#define ASP_SPREAD_DECLARE(name) extern const asp_spread_model asp_spread_##name;
ASP_SPREAD_MODELS(ASP_SPREAD_DECLARE)
#undef ASP_SPREAD_DECLARE

/* Below this sigma (rad) a wall is smooth to the last bit, and alpha1/sigma could overflow. */
#define ASP_SIGMA_ZERO 1e-290

/* No face of a height function is steeper than this. With alpha1 <= 90 degrees it also is the
 * steepest face that a particle can hit: 180 degrees - alpha1 is never less. */
#define ASP_DELTA_MOST (ASP_PI / 2)

/* The normal distribution with mean 0 and sd sigma > 0, cut to lo <= delta <= hi with lo <= 0 < hi,
 * and normalised (eq. 5). The quantile uses the complementary form in the upper half, so that it
 * keeps its digits for u near 1, and never leaves [lo, hi]. */
double asp_cut_normal_density(double sigma, double lo, double hi, double delta);
double asp_cut_normal_distribution(double sigma, double lo, double hi, double delta);
double asp_cut_normal_quantile(double sigma, double lo, double hi, double u);

/* Laws that more than one model has: the first face of `multicollision` follows the effective law,
 * and the rejection loop samples the truncated one. */
double asp_effective_density(const asp_view *view, double delta);
double asp_effective_distribution(const asp_view *view, double delta);
double asp_effective_quantile(const asp_view *view, double u);

double asp_truncated_density(const asp_view *view, double delta);
double asp_truncated_distribution(const asp_view *view, double delta);

#endif
