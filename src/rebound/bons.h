/* The law of bons.c as straight code, for one hit and for loops over many. */
#ifndef ASP_REBOUND_BONS_H
#define ASP_REBOUND_BONS_H

#include "asperity.h"

#include <float.h>
#include <math.h>

/* How near a difference may come to 0, as a share of what it is taken from, before long double. */
static const double ASP_BONS_NEAR = 2e-2;

typedef struct asp_bons_constants {
  double yield_rate, a, b;
  double softened; /* the share of the yield stress that heat leaves */
  double adhesion; /* 6, or 0 without */
} asp_bons_constants;

/* What the law makes of a particle and its pair, whatever the hit. */
typedef struct asp_bons_grain {
  double v_y, per_v_y; /* with a yield rate: v_y over the speed, and nothing */
  double pull;         /* v_a^2 = pull f */
  double friction;
} asp_bons_grain;

typedef struct asp_bons_answer {
  double v_n2, v_t2;
  bool near; /* a threshold: to be worked out again in long double */
} asp_bons_answer;

/* 1/v_y; of a grain that yields at any speed, nothing, for it is not needed. */
static inline double asp_bons_inverse(double v_y) {
  return v_y > DBL_MIN * 8 ? 1 / v_y : 0;
}

/* rate: there is a yield_rate. */
static inline asp_bons_grain asp_bons_grain_of(const asp_bons_constants *p, double d_p,
                                               double density, asp_pair pair, bool rate) {
  double v_y = (rate ? p->yield_rate : pair.yield_stress) * p->softened;
  v_y /= sqrt(density * pair.modulus);
  double pull = p->adhesion * pair.surface_energy / (density * d_p);
  return (asp_bons_grain){v_y, rate ? 0 : asp_bons_inverse(v_y), pull, pair.friction};
}

/* root: c is 0.5, and the power is spared. Without branches that a vector loop could not take. */
static inline asp_bons_answer asp_bons_plain(const asp_bons_constants *p, double n1, double t1,
                                             asp_bons_grain g, bool rate, bool root, double c) {
  double speed2 = n1 * n1 + t1 * t1, v_y = rate ? g.v_y * sqrt(speed2) : g.v_y;
  double per_v_y = rate ? asp_bons_inverse(v_y) : g.per_v_y;
  double n2 = n1 < v_y ? n1 : v_y, ratio = n1 < v_y ? n1 * per_v_y : 1; /* v_y = 0: all yields */
  double share = p->a + p->b * (root ? sqrt(ratio) : pow(ratio, c));
  double square = n2 * n2, left = square - g.pull * share;
  bool near_capture = (g.pull > 0) & (fabs(left) < ASP_BONS_NEAR * square);
  n2 = g.pull > 0 ? sqrt(left > 0 ? left : 0) : n2;
  double cos2 = speed2 > 0 ? t1 * t1 / speed2 : 0;
  double t2 = t1 - g.friction * (n1 + n2) * cos2;
  bool near_rest = fabs(t2) < ASP_BONS_NEAR * t1;
  return (asp_bons_answer){n2, t2 > 0 ? t2 : 0, near_capture | near_rest};
}

/* Of n hits, with c = 0.5; near[i] is 1 or 0. */
void asp_bons_n(const asp_bons_constants *p, const asp_hits *hits, size_t n, double *v_n2,
                double *v_t2, double *near);

#endif
