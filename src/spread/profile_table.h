/* The table of profile.c, and how a quantile is found in it, as straight code for one contact and
 * for loops over many. */
#ifndef ASP_SPREAD_PROFILE_TABLE_H
#define ASP_SPREAD_PROFILE_TABLE_H

#include "spread/cells.h"
#include "spread/models.h"
#include "spread/trace.h"

#include <math.h>

enum {
  ASP_PROFILE_ANGLES = 64,
  ASP_PROFILE_CELLS = 512, /* of equal width in u */
  ASP_PROFILE_PARTS = 32,  /* of the first and of the last of them */
  ASP_PROFILE_NODES = ASP_PROFILE_CELLS - 2 + 2 * ASP_PROFILE_PARTS + 1,
  ASP_PROFILE_SIZE = ASP_PROFILE_NODES * ASP_PROFILE_ANGLES, /* numbers a diameter */
  ASP_PROFILE_SIZE_PARTS = 512                               /* at most, to find a bin by */
};

typedef struct asp_profile_table {
  int bins, next; /* next: how far the numbers of the next size are; 0 of one size */
  double d_p[ASP_BINS_MAX], per_d_p[ASP_BINS_MAX]; /* 1 over the step to the next */
  double most;                                     /* the last d_p */
  /* Parts of the sizes' range, each so many bits of a double long, and the bin that each begins in:
   * the bits of the diameter are its logarithm, as straight lines between powers of two. */
  uint64_t first_bits;
  int part_bits;
  uint8_t below[ASP_PROFILE_SIZE_PARTS];
  double angle[ASP_PROFILE_ANGLES], per_angle[ASP_PROFILE_ANGLES];
  float delta[]; /* by size, u, angle; rad */
} asp_profile_table;

/* A place along one of the table's three ways: the step before it, and the share of that step. */
typedef struct asp_profile_place {
  int step;
  double share;
} asp_profile_place;

static inline asp_profile_place asp_profile_u(double u) {
  double cell = u * ASP_PROFILE_CELLS, last = cell - (ASP_PROFILE_CELLS - 1);
  double at = cell < 1 ? cell * ASP_PROFILE_PARTS : cell + (ASP_PROFILE_PARTS - 1);
  at = last > 0 ? last * ASP_PROFILE_PARTS + (ASP_PROFILE_CELLS + ASP_PROFILE_PARTS - 2) : at;
  int node = (int)at < ASP_PROFILE_NODES - 2 ? (int)at : ASP_PROFILE_NODES - 2;
  return (asp_profile_place){node, at - node};
}

/* The angles are this times k^2. */
static const double ASP_PROFILE_WIDTH =
    ASP_PI / 2 / ((ASP_PROFILE_ANGLES - 1.) * (ASP_PROFILE_ANGLES - 1.));

/* The last angle but one at most that is not above 0 <= alpha1 <= pi/2. */
static inline int asp_profile_angle_step(double alpha1) {
  int k = (int)sqrt(alpha1 * (1 / ASP_PROFILE_WIDTH));
  return k < ASP_PROFILE_ANGLES - 2 ? k : ASP_PROFILE_ANGLES - 2;
}

static inline asp_profile_place asp_profile_angle(const asp_profile_table *t, double alpha1) {
  int k = asp_profile_angle_step(alpha1);
  return (asp_profile_place){k, (alpha1 - t->angle[k]) * t->per_angle[k]};
}

/* The same for loops, in which a product costs less than a number from memory. */
static inline asp_profile_place asp_profile_angle_n(const asp_profile_table *t, double alpha1) {
  int k = asp_profile_angle_step(alpha1);
  double whole = k, from = ASP_PROFILE_WIDTH * whole * whole;
  return (asp_profile_place){k, (alpha1 - from) * t->per_angle[k]};
}

static inline asp_profile_place asp_profile_size(const asp_profile_table *t, double d_p) {
  d_p = asp_within(d_p, t->d_p[0], t->most);
  int i = t->below[(asp_bits(d_p) - t->first_bits) >> t->part_bits];
  while (i < t->bins - 2 && d_p > t->d_p[i + 1])
    i++;
  return (asp_profile_place){i, (d_p - t->d_p[i]) * t->per_d_p[i]};
}

/* Two neighbours of the table at once, as the halves of a number. */
static inline uint64_t asp_profile_two(const float *at) {
  typedef uint64_t __attribute__((aligned(4), may_alias)) two;
  return *(const two *)at;
}

static inline double asp_profile_half(uint64_t two, int shift) {
  uint32_t bits = (uint32_t)(two >> shift);
  float half;
  memcpy(&half, &bits, sizeof half);
  return half;
}

/* delta from the number at `at` on, with the shares of size, u and angle. */
static inline double asp_profile_delta(const float *delta, int at, int next, double size, double u,
                                       double angle) {
  const bool big_end_first = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;
  uint64_t a = asp_profile_two(delta + at), b = asp_profile_two(delta + at + ASP_PROFILE_ANGLES);
  uint64_t c = asp_profile_two(delta + at + next);
  uint64_t d = asp_profile_two(delta + at + next + ASP_PROFILE_ANGLES);
  double of[2];
  for (int k = 0; k < 2; k++) {
    int shift = (k > 0) != big_end_first ? 32 : 0;
    double first = asp_profile_half(a, shift), second = asp_profile_half(c, shift);
    double from = first + u * (asp_profile_half(b, shift) - first);
    double to = second + u * (asp_profile_half(d, shift) - second);
    of[k] = from + size * (to - from);
  }
  return of[0] + angle * (of[1] - of[0]);
}

#endif
