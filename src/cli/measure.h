/* How far a spread model is from the geometry: histograms of rebound angles, their divergence, and
 * what an impact costs. */
#ifndef ASP_CLI_MEASURE_H
#define ASP_CLI_MEASURE_H

#include "cli/cli.h"
#include "spread/trace.h"

enum { MEASURE_BINS = 180 }; /* of one degree */

/* Rebound angles alpha2 of many impacts, from 0 to 180 degrees. */
typedef struct measure_angles {
  double count[MEASURE_BINS];
  double n, mean; /* how many; their mean, degrees */
  double later;   /* the share of impacts with more than one hit */
} measure_angles;

/* A wall to be judged: a Gaussian profile, what it is for one diameter, and its track. */
typedef struct measure_case {
  asp_profile *profile;
  asp_surface *surface; /* its slope is that of the very track */
  aspi_track *track;
  double d_p;
} measure_case;

/* Exits when the profile cannot be made. */
measure_case measure_case_create(double r_q, double lambda_c, double d_p, uint32_t seed);
void measure_case_free(measure_case *subject);

/* The wall with one model on it; every rebound is specular, nothing sticks. */
asp_wall *measure_wall(const measure_case *subject, const char *model, bool multiple);

/* n specular rebounds at alpha1 (rad), by all threads. */
measure_angles measure_rebounds(const asp_wall *wall, double d_p, double alpha1, size_t n,
                                uint32_t seed);

/* Nanoseconds per impact, on one thread. */
double measure_cost(const asp_wall *wall, double d_p, double alpha1);

/* D_KL(reference || other) of the histograms, less the bias of two samples, (B - 1)/2 (1/n + 1/m)
 * for B bins in use. A bin that the other never fills counts as half an impact there. */
double measure_divergence(const measure_angles *reference, const measure_angles *other);

/* D_KL of the law of the first hit on a wall of the subject against the track's exact one, in bins
 * of one degree; a bin that the model cannot fill counts as 1e-6. Not a number where the model has
 * no distribution. */
double measure_first_hit(const measure_case *subject, const asp_wall *wall, double alpha1);

#endif
