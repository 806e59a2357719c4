/* The normal distribution cut to an interval (eq. 5 to 7); see models.h. */
#include "spread/cells.h"
#include "spread/gauss.h"
#include "spread/models.h"
#include "spread/normal_law.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

#include "normal_table.inc"

/* Q(x). Nearly always x >= 0; less, where a particle that grazes flies up by its last bits. */
static inline double tail(double x) {
  double place = fabs(x) * ASP_TAIL_PER_UNIT, cell = asp_nearest(place);
  if (!(place <= ASP_TAIL_CELLS - 1))
    return x < 0 ? 1 : 0;
  double q = asp_powers(tail_table + (int)cell * ASP_POWERS, place - cell);
  return x < 0 ? 1 - q : q;
}

/* The x with Phi(x) = p = 1 - q; both are given, so that neither tail loses digits. */
static inline double normal_quantile(double p, double q) {
  double least = p < q ? p : q;
  if (!(least >= ASP_NORMAL_LEAST))
    return copysign(gsl_cdf_ugaussian_Pinv(least), p - q);
  const double *c = quantile_table + asp_eighth(least, ASP_NORMAL_LEAST) * ASP_NORMAL_TERMS;
  double z = asp_over_eighth(least), z4 = z * z * (z * z);
  return copysign(asp_powers(c, z) + z4 * z4 * (c[8] + c[9] * z), p - q);
}

/* What the cuts leave of the whole. */
static double mass(double sigma, double lo, double hi) {
  return 1 - tail(-lo / sigma) - tail(hi / sigma);
}

double asp_cut_normal_density(double sigma, double lo, double hi, double delta) {
  if (delta < lo || delta > hi)
    return 0;
  double x = delta / sigma;
  return exp(-0.5 * x * x) / (sqrt(2 * ASP_PI) * sigma * mass(sigma, lo, hi));
}

double asp_cut_normal_distribution(double sigma, double lo, double hi, double delta) {
  if (delta <= lo)
    return 0;
  if (delta >= hi)
    return 1;
  return (asp_gauss_below(delta / sigma) - tail(-lo / sigma)) / mass(sigma, lo, hi);
}

double asp_cut_normal_quantile(double sigma, double lo, double hi, double u) {
  double below = tail(-lo / sigma), above = tail(hi / sigma), rest = 1 - u;
  double moved = rest * below - u * above; /* what the cuts make of u in the whole law */
  return asp_within(sigma * normal_quantile(u + moved, rest - moved), lo, hi);
}
