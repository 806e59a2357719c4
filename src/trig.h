/* Sine, cosine and arc tangent of one contact. The GNU C library's own look up the rounding mode,
 * for which the processor waits until all that came before is done; its vector functions do not, so
 * that two contacts overlap. Those have at most 4 ulps of error. Elsewhere: the C library's. */
#ifndef ASP_TRIG_H
#define ASP_TRIG_H

#include "asperity.h"

#include <math.h>

#if defined(__x86_64__) && defined(__GNUC__) && defined(__GLIBC__)
#if __GLIBC_PREREQ(2, 35)
#define ASP_VECTOR_LIBM
#endif
#endif

#ifdef ASP_VECTOR_LIBM

typedef double asp_two __attribute__((vector_size(16)));

asp_two _ZGVbN2v_sin(asp_two);
asp_two _ZGVbN2v_atan(asp_two);

/* Of -pi/2 <= x <= pi/2. */
static inline void asp_sin_cos(double x, double *s, double *c) {
  asp_two both = _ZGVbN2v_sin((asp_two){x, ASP_PI / 2 - fabs(x)});
  *s = both[0];
  *c = both[1];
}

static inline double asp_atan(double x) {
  return _ZGVbN2v_atan((asp_two){x, x})[0];
}

#else

static inline void asp_sin_cos(double x, double *s, double *c) {
  *s = sin(x);
  *c = cos(x);
}

static inline double asp_atan(double x) {
  return atan(x);
}

#endif

#endif
