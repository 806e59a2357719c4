/* The standard normal law as short straight code, so that a quantile that needs it costs little and
 * a loop over many contacts vectorises: the tail Q by Hart's rational approximation (Hart et al.
 * 1968, no. 5666, as recalled from West 2005: within 3e-16 everywhere, a relative 1e-8 at x = 8),
 * and the middle of the quantile by Wichura 1988 (AS 241). Where a tail needs full relative
 * precision, erfc and GSL's functions take over. */
#ifndef ASP_SPREAD_GAUSS_H
#define ASP_SPREAD_GAUSS_H

#include <gsl/gsl_cdf.h>
#include <math.h>

#define ASP_INV_SQRT_2PI 0.398942280401432677940

static inline double asp_gauss_density(double x) {
  return ASP_INV_SQRT_2PI * exp(-0.5 * x * x);
}

/* Q(x) / (sqrt(2 pi) phi(x)) for x >= 0. Powers in pairs: shorter than Horner's chain. */
static inline double asp_gauss_mills(double x) {
  double x2 = x * x, x4 = x2 * x2;
  double p = (220.206867912376 + 221.213596169931 * x) +
             x2 * (112.079291497871 + 33.912866078383 * x) +
             x4 * ((6.37396220353165 + 0.700383064443688 * x) + x2 * 3.52624965998911e-02);
  double q = (440.413735824752 + 793.826512519948 * x) +
             x2 * (637.333633378831 + 296.564248779674 * x) +
             x4 * ((86.7807322029461 + 16.064177579207 * x) +
                   x2 * (1.75566716318264 + 8.83883476483184e-02 * x));
  return p / q;
}

/* Q(x) = 1 - Phi(x), given phi(x). */
static inline double asp_gauss_above(double x, double density) {
  double tail = density * (1 / ASP_INV_SQRT_2PI) * asp_gauss_mills(fabs(x));
  return 0.5 - copysign(0.5 - tail, x);
}

/* Phi(x), with full relative precision in the lower tail. */
static inline double asp_gauss_below(double x) {
  return 0.5 * erfc(-x * M_SQRT1_2);
}

/* The quantile in the lower tail, p from 1.4e-11 to 0.075 (AS 241, its middle range). */
static inline double asp_gauss_tail_quantile(double p) {
  double r = sqrt(-log(p)) - 1.6, r2 = r * r, r4 = r2 * r2;
  double a = (1.42343711074968357734e+0 + 4.63033784615654529590e+0 * r) +
             r2 * (5.76949722146069140550e+0 + 3.64784832476320460504e+0 * r) +
             r4 * ((1.27045825245236838258e+0 + 2.41780725177450611770e-1 * r) +
                   r2 * (2.27238449892691845833e-2 + 7.74545014278341407640e-4 * r));
  double b = (1 + 2.05319162663775882187e+0 * r) +
             r2 * (1.67638483018380384940e+0 + 6.89767334985100004550e-1 * r) +
             r4 * ((1.48103976427480074590e-1 + 1.51986665636164571966e-2 * r) +
                   r2 * (5.47593808499534494600e-4 + 1.05075007164441684324e-9 * r));
  return -a / b;
}

/* The x with Phi(x) = p = 1 - q; both are given, so that neither tail loses digits. */
static inline double asp_gauss_quantile(double p, double q) {
  double d = p - 0.5;
  if (fabs(d) > 0.425) {
    double least = d < 0 ? p : q;
    double x = least > 1.4e-11 ? asp_gauss_tail_quantile(least) : gsl_cdf_ugaussian_Pinv(least);
    return d < 0 ? x : -x;
  }
  double r = 0.180625 - d * d, r2 = r * r, r4 = r2 * r2;
  double a = (3.3871328727963666080e+0 + 1.3314166789178437745e+2 * r) +
             r2 * (1.9715909503065514427e+3 + 1.3731693765509461125e+4 * r) +
             r4 * ((4.5921953931549871457e+4 + 6.7265770927008700853e+4 * r) +
                   r2 * (3.3430575583588128105e+4 + 2.5090809287301226727e+3 * r));
  double b = (1 + 4.2313330701600911252e+1 * r) +
             r2 * (6.8718700749205790830e+2 + 5.3941960214247511077e+3 * r) +
             r4 * ((2.1213794301586595867e+4 + 3.9307895800092710610e+4 * r) +
                   r2 * (2.8729085735721942674e+4 + 5.2264952788528545610e+3 * r));
  return d * a / b;
}

#endif
