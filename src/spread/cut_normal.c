/* The normal distribution cut to an interval (eq. 5 to 7); see models.h. */
#include "spread/gauss.h"
#include "spread/models.h"
#include "spread/normal_law.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

#include "normal_table.inc"

/* Q(x) for x >= 0. */
static inline double tail(double x) {
  if (!(x <= ASP_TAIL_END))
    return 0;
  double place = x * ASP_TAIL_PER_UNIT, cell = asp_nearest(place), z = place - cell;
  double z2 = z * z, z4 = z2 * z2;
  const double *c = tail_table + (int)cell * ASP_TAIL_TERMS;
  return ((c[0] + c[1] * z) + z2 * (c[2] + c[3] * z)) +
         z4 * ((c[4] + c[5] * z) + z2 * (c[6] + c[7] * z));
}

static inline uint64_t bits_of(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}

static inline double number_of(uint64_t bits) {
  double x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

/* The x with Phi(x) = p = 1 - q; both are given, so that neither tail loses digits. Found in the
 * lower half, where exponent and first three bits of the mantissa tell the cell. */
static inline double normal_quantile(double p, double q) {
  const uint64_t one = bits_of(1), in_cell = ((uint64_t)1 << 49) - 1, middle = (uint64_t)1 << 48;
  const uint64_t first = bits_of(ASP_NORMAL_LEAST) >> 49;
  double least = p < q ? p : q;
  if (!(least >= ASP_NORMAL_LEAST))
    return copysign(gsl_cdf_ugaussian_Pinv(least), p - q);
  uint64_t bits = bits_of(least), mantissa = (bits & (((uint64_t)1 << 52) - 1)) | one;
  double z = number_of(mantissa) - number_of((mantissa & ~in_cell) | middle);
  double z2 = z * z, z4 = z2 * z2, z8 = z4 * z4;
  const double *c = quantile_table + ((bits >> 49) - first) * ASP_NORMAL_TERMS;
  double x = (((c[0] + c[1] * z) + z2 * (c[2] + c[3] * z)) +
              z4 * ((c[4] + c[5] * z) + z2 * (c[6] + c[7] * z))) +
             z8 * (c[8] + c[9] * z);
  return copysign(x, p - q);
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
  double below = tail(-lo / sigma), above = tail(hi / sigma), left = 1 - below - above;
  double x = normal_quantile(below + u * left, above + (1 - u) * left);
  return asp_within(sigma * x, lo, hi);
}
