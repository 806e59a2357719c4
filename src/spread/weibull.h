/* The Weibull law of an impact angle, as straight code; see weibull.c. */
#ifndef ASP_SPREAD_WEIBULL_H
#define ASP_SPREAD_WEIBULL_H

#include "spread/models.h"

#include <math.h>

/* The paper's boundary angle e over sigma. */
#define ASP_WEIBULL_END 6.48

/* Where the steepest face cuts off less than the last bit: sigma (rad) below the first, at any
 * angle, or below the second plus the third times tau. */
#define ASP_WEIBULL_UNCUT 0.105
#define ASP_WEIBULL_UNCUT_FROM 0.058
#define ASP_WEIBULL_UNCUT_PER_TAU 0.0275

typedef struct asp_weibull_law {
  double b, k, lambda;
} asp_weibull_law;

/* Shape and scale as polynomials of fourth degree in tau = alpha1/sigma, written around the end so
 * that they arrive there at the values that hold beyond it: k = 3.602, and the lambda that makes
 * the mean zero, 3.24/Gamma(1 + 1/3.602) (sd 0.9991). */
static inline asp_weibull_law asp_weibull_at(double sigma, double alpha1) {
  double per_sigma = 1 / sigma, tau = alpha1 * per_sigma; /* the first is ready before alpha1 is */
  tau = tau < ASP_WEIBULL_END ? tau : ASP_WEIBULL_END;
  double ahead = tau - ASP_WEIBULL_END, tau2 = tau * tau;
  double k = (0.3607531 + tau * 0.0404840) + tau2 * (0.0037227 - tau * 0.0007002);
  double scale = (0.4221985 + tau * 0.0357573) - tau2 * (0.0019619 + tau * 0.0002228);
  asp_weibull_law w = {-0.5 * tau * sigma, 3.602 + ahead * k,
                       (3.595474673403 + ahead * scale) * sigma};
  return w;
}

/* Whether the steepest face cuts off less than the last bit (e^-36.7). */
static inline bool asp_weibull_uncut(double sigma, double alpha1) {
  return sigma < ASP_WEIBULL_UNCUT ||
         sigma * (sigma - ASP_WEIBULL_UNCUT_FROM) < ASP_WEIBULL_UNCUT_PER_TAU * alpha1;
}

/* -log(1 - u), with full relative precision for small u. */
static inline double asp_minus_log_rest(double u) {
  double rest = 1 - u;
  return -(log(rest) + ((1 - rest) - u) / rest);
}

/* -log(1 - u (1 - lost)), for u near 1 too: the last sum is what the first two have rounded off. */
static inline double asp_minus_log_cut(double u, double lost) {
  double above = 1 - u, beyond = u * lost, rest = above + beyond;
  return -(log(rest) + (((1 - above) - u) + ((above - rest) + beyond)) / rest);
}

#endif
