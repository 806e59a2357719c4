/* Files of coefficients of restitution over the impact angle: impacts, as `asperity cor`, a ledger
 * or LIGGGHTS's `dump local` of one writes them, and measurements, as single points or as means and
 * standard deviations. */
#ifndef ASP_CLI_SCATTER_H
#define ASP_CLI_SCATTER_H

#include <stdbool.h>
#include <stddef.h>

enum { COR_N, COR_T, COR_BOTH };

typedef struct scatter_point {
  double degrees;       /* impact angle */
  double cor[COR_BOTH]; /* NAN where there is none */
} scatter_point;

typedef struct scatter_impacts {
  scatter_point *points; /* rebounds only */
  size_t count, deposits;
  bool rough;         /* some local wall was tilted */
  char comment[1024]; /* the file's first comment */
} scatter_impacts;

/* A row of measured means and standard deviations at an angle. */
typedef struct scatter_mean {
  double degrees;
  double mean[COR_BOTH], sd[COR_BOTH]; /* NAN where there is none */
} scatter_mean;

/* Either points or means. */
typedef struct scatter_data {
  scatter_point *points;
  size_t n_points;
  scatter_mean *means;
  size_t n_means;
} scatter_data;

/* Both exit on a file that is not one of theirs, and warn where angles look like radians. */
scatter_impacts scatter_read_impacts(const char *path);
scatter_data scatter_read_data(const char *path);

void scatter_free_impacts(scatter_impacts *impacts);
void scatter_free_data(scatter_data *data);

#endif
