/* How far a spread model is from the geometry: rebound angles of an ensemble of generated profiles,
 * or of the pieces of a measured one, none of which has made the model, and of the model; their
 * divergence with its standard error; and what an impact costs.
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

/* What is judged: a wall and particles of one size, the impacts at each angle, and the profiles of
 * the ensemble that judges: so many pieces, of equal length, of a measured profile. Pieces of one
 * half of it judge what is made of the other half. */
typedef struct measure_case {
  double r_q, lambda_c, d_p;
  size_t rays;
  int profiles; /* MEASURE_PROFILES_LEAST to MEASURE_PROFILES_MOST */
  uint32_t seed;
  const asp_profile *profile; /* NULL: a Gaussian wall of r_q and lambda_c */
} measure_case;

/* What models are made of: for each half of a measured profile the other one; of a Gaussian wall
 * both are the same. Exits where there is no such wall. */
typedef struct measure_wall {
  asp_surface *surface[2];
  asp_profile *profile[2]; /* NULL: Gaussian */
} measure_wall;
measure_wall measure_wall_create(const measure_case *subject);
void measure_wall_free(measure_wall *wall);

/* The least impact angle, in degrees, that the pieces of a measured profile can tell; 0 of a
 * Gaussian wall. */
double measure_angle_least(const measure_case *subject);

/* What the ensemble says at one angle: the rebounds on each of its profiles, and the shares of
 * first hits in bins of one degree from -90. */
typedef struct measure_reference {
  double alpha1; /* rad */
  measure_angles *profile;
  double first_hit[2][MEASURE_BINS]; /* on either half of a measured profile */
  double mean_first;                 /* rad, of all */
} measure_reference;

/* Specular rebounds at n angles (degrees), over profiles of 2048 lambda_c, each with its negative
 * and in both directions of flight, whose rms slope is that of the ensemble; no model has these
 * seeds. Or over the pieces of a measured profile, each of which goes on as its mirror image. Exits
 * when profiles cannot be made. Freed by measure_references_free. */
measure_reference *measure_references(const measure_case *subject, const measure_wall *wall,
                                      const double *angles, size_t n);
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

/* One model on what it is made of, as a user has it; every rebound is specular, nothing sticks. The
 * wall must outlive it. */
typedef struct measure_model {
  asp_wall *on[2];
} measure_model;
measure_model measure_model_create(const measure_case *subject, const measure_wall *wall,
                                   const char *model, bool multiple);
void measure_model_free(measure_model *model);

/* n specular rebounds at alpha1 (rad), by all threads. */
measure_angles measure_rebounds(const asp_wall *wall, double d_p, double alpha1, size_t n,
                                uint32_t seed);

/* D_KL(ensemble || model) of the rebound angles. Both come in as many groups of impacts as there
 * are profiles; leaving out one after the other takes the bias of the histograms out, and gives the
 * standard error, which covers the ensemble's sampling and the model's (Quenouille's jackknife). A
 * bin that the model never fills counts as half an impact there. On a measured profile it is the
 * mean over its halves. */
typedef struct measure_divergence {
  double kl, se, mean, reference_mean; /* degrees */
} measure_divergence;
measure_divergence measure_compare(const measure_case *subject, const measure_reference *reference,
                                   const measure_model *model);

/* D_KL of a model's law of the first hit against the ensemble's, in bins of one degree; a bin
 * that the model cannot fill counts as 1e-6. Not a number where the model has no distribution. */
double measure_first_hit(const measure_case *subject, const measure_reference *reference,
                         const measure_model *model);

/* Nanoseconds per impact, on one thread. */
double measure_cost(const asp_wall *wall, double d_p, double alpha1);

#endif
