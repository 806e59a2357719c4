/* Tables of polynomials, cell by cell, that the build makes (powers.h): how a number finds its cell
 * and its place there without a branch or a call. */
#ifndef ASP_SPREAD_CELLS_H
#define ASP_SPREAD_CELLS_H

#include <stdint.h>
#include <string.h>

/* x to the nearest whole number, halves to the even one, for |x| < 2^51. */
static inline double asp_nearest(double x) {
  const double shift = 6755399441055744.0; /* 1.5 * 2^52, where doubles are whole */
  return (x + shift) - shift;
}

static inline uint64_t asp_bits(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}

static inline double asp_number(uint64_t bits) {
  double x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

#define ASP_MANTISSA_BITS 52

/* Of cells of an eighth of an octave: the one that x > 0 is in, counted from that of a power of
 * two, and what the mantissa of x (1 to 2) has over its middle. */
static inline int asp_eighth(double x, double from) {
  return (int)((asp_bits(x) >> (ASP_MANTISSA_BITS - 3)) -
               (asp_bits(from) >> (ASP_MANTISSA_BITS - 3)));
}

static inline double asp_over_eighth(double x) {
  const uint64_t one = (uint64_t)1 << ASP_MANTISSA_BITS, in_cell = one / 8 - 1;
  uint64_t mantissa = (asp_bits(x) & (one - 1)) | asp_bits(1);
  return asp_number(mantissa) - asp_number((mantissa & ~in_cell) | one / 16);
}

enum { ASP_POWERS = 8 };

/* So many powers of z; in pairs, shorter than Horner's chain. */
static inline double asp_powers(const double *c, double z) {
  double z2 = z * z, z4 = z2 * z2;
  return ((c[0] + c[1] * z) + z2 * (c[2] + c[3] * z)) +
         z4 * ((c[4] + c[5] * z) + z2 * (c[6] + c[7] * z));
}

#endif
