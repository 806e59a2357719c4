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

/* 0 <= alpha1 <= pi/2 */
static inline asp_profile_place asp_profile_angle(const asp_profile_table *t, double alpha1) {
  const double per_square = 2 / ASP_PI * (ASP_PROFILE_ANGLES - 1) * (ASP_PROFILE_ANGLES - 1);
  int k = (int)sqrt(alpha1 * per_square);
  k = k < ASP_PROFILE_ANGLES - 2 ? k : ASP_PROFILE_ANGLES - 2;
  return (asp_profile_place){k, (alpha1 - t->angle[k]) * t->per_angle[k]};
}

static inline asp_profile_place asp_profile_size(const asp_profile_table *t, double d_p) {
  d_p = asp_within(d_p, t->d_p[0], t->most);
  int i = t->below[(asp_bits(d_p) - t->first_bits) >> t->part_bits];
  while (i < t->bins - 2 && d_p > t->d_p[i + 1])
    i++;
  return (asp_profile_place){i, (d_p - t->d_p[i]) * t->per_d_p[i]};
}

/* delta from the number at `at` on, with the shares of size, u and angle. */
static inline double asp_profile_delta(const float *delta, int at, int next, double size, double u,
                                       double angle) {
  double of[2];
  for (int k = 0; k < 2; k++, at++) {
    double first = delta[at], second = delta[at + next];
    double low = first + u * (delta[at + ASP_PROFILE_ANGLES] - first);
    double high = second + u * (delta[at + next + ASP_PROFILE_ANGLES] - second);
    of[k] = low + size * (high - low);
  }
  return of[0] + angle * (of[1] - of[0]);
}

#endif
