/* How far a spread model is from the geometry: rebound angles of an ensemble of generated profiles,
 * none of which has made a model, and of the model; their divergence with its standard error; and
 * what an impact costs.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_MEASURE_H
#define ASP_CLI_MEASURE_H

#include "cli/cli.h"

enum {
  MEASURE_BINS = 180, /* of one degree */
  MEASURE_PROFILES_LEAST = 4,
  MEASURE_PROFILES_MOST = 1024
};

/* Rebound angles alpha2 of many impacts, from 0 to 180 degrees. */
typedef struct measure_angles {
  double count[MEASURE_BINS];
  double n, mean; /* how many; their mean, degrees */
  double later;   /* the share of impacts with more than one hit */
} measure_angles;

/* What is judged: a Gaussian wall and particles of one size, the impacts at each angle, and the
 * profiles of the ensemble that judges. */
typedef struct measure_case {
  double r_q, lambda_c, d_p;
  size_t rays;
  int profiles; /* MEASURE_PROFILES_LEAST to MEASURE_PROFILES_MOST */
  uint32_t seed;
} measure_case;

/* What the ensemble says at one angle: the rebounds on each of its profiles, and the shares of
 * first hits in bins of one degree from -90. */
typedef struct measure_reference {
  double alpha1; /* rad */
  measure_angles *profile;
  double first_hit[MEASURE_BINS], mean_first; /* its mean, rad */
} measure_reference;

/* Specular rebounds at n angles (degrees), over profiles of 2048 lambda_c, each with its negative
 * and in both directions of flight, whose rms slope is that of the ensemble; no model has these
 * seeds. Exits when profiles cannot be made. Freed by measure_references_free. */
measure_reference *measure_references(const measure_case *subject, const double *angles, size_t n);
void measure_references_free(measure_reference *references, size_t n);

/* What a wall of specular rebounds, on which nothing sticks, is made of; profile and map may be
 * NULL. */
typedef struct measure_specular_wall {
  const asp_surface *surface;
  const asp_profile *profile;
  const asp_map *map;
  bool isotropic; /* tilts all around; false: in the plane of incidence */
} measure_specular_wall;

/* That wall with one model, for one diameter; exits where it cannot be made. */
asp_wall *measure_specular(const measure_specular_wall *of, double d_p, const char *model,
                           bool multiple);

/* The wall with one model on it, as a user has it; every rebound is specular, nothing sticks.
 * surface must outlive it. */
asp_wall *measure_wall(const measure_case *subject, const asp_surface *surface, const char *model,
                       bool multiple);
asp_surface *measure_surface(const measure_case *subject);

/* n specular rebounds at alpha1 (rad), by all threads. */
measure_angles measure_rebounds(const asp_wall *wall, double d_p, double alpha1, size_t n,
                                uint32_t seed);

/* D_KL(ensemble || model) of the rebound angles. Both come in as many groups of impacts as there
 * are profiles; leaving out one after the other takes the bias of the histograms out, and gives the
 * standard error, which covers the ensemble's sampling and the model's (Quenouille's jackknife). A
 * bin that the model never fills counts as half an impact there. */
typedef struct measure_divergence {
  double kl, se, mean, reference_mean; /* degrees */
} measure_divergence;
measure_divergence measure_compare(const measure_case *subject, const measure_reference *reference,
                                   const asp_wall *wall);

/* D_KL of the law of the first hit on a wall against the ensemble's, in bins of one degree; a bin
 * that the model cannot fill counts as 1e-6. Not a number where the model has no distribution. */
double measure_first_hit(const measure_case *subject, const measure_reference *reference,
                         const asp_wall *wall);

/* Nanoseconds per impact, on one thread. */
double measure_cost(const asp_wall *wall, double d_p, double alpha1);

#endif
