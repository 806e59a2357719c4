/* Files of impacts, as `asperity cor`, a ledger or `dump local` of one writes them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_SCATTER_H
#define ASP_CLI_SCATTER_H

#include <stdbool.h>
#include <stddef.h>

enum { COR_N, COR_T, COR_BOTH };

typedef struct scatter_point {
  double degrees;       /* impact angle */
  float v1, d_p;        /* SI; NAN where there is none */
  bool deposit;         /* it has no coefficients */
  float cor_t_space;    /* of the whole speed along the wall, without a sign; NAN alike */
  double cor[COR_BOTH]; /* NAN where there is none */
} scatter_point;

typedef struct scatter_impacts {
  scatter_point *points;
  size_t count, deposits;         /* deposits: of those */
  bool rough;                     /* some local wall was tilted */
  bool sideways;                  /* some went out of the plane of incidence */
  char comment[1024];             /* the file's first comment */
  double metre, metre_per_second; /* of the file's units */
} scatter_impacts;

/* Exits on a file that is not one of these, and warns where angles look like radians. */
scatter_impacts scatter_read_impacts(const char *path);
void scatter_free_impacts(scatter_impacts *impacts);

#endif
