/* Distance of a spread model from the geometry, in the plane of incidence. Reference: rebound
 * angles over generated profiles, none of which made the model, or over a measured profile, hit by
 * hit. Against it: the model's rebound angles, their divergence, and the cost of an impact. Every
 * rebound is specular, nothing sticks. The judge in three dimensions is in tests/sweep.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "analysis/angles.h"
#include "asperity_internal.h"

enum { ASPI_JUDGES_LEAST = 4, ASPI_JUDGES_MOST = 1024 };

/* The case that is judged: a wall and particles of one size. */
typedef struct aspi_judge_case {
  double r_q, lambda_c, d_p;
  size_t groups; /* profiles of the ensemble; over a measured one, parts of the rays */
  size_t rays;   /* impacts at an angle */
  uint32_t seed;
  const asp_heights *profile;                    /* measured; NULL: none */
  void (*progress)(void *context, double share); /* of the ensemble; may be NULL */
  void *context;
} aspi_judge_case;

/* First hits over all profiles at one angle: shares in bins of one degree from -90, and the mean
 * tilt, rad. */
typedef struct aspi_first_hits {
  double share[ASPI_ANGLE_BINS], mean;
} aspi_first_hits;

/* Reference results at `count` impact angles (degrees): group g at angle k is angles[g * count +
 * k]. */
typedef struct aspi_judge {
  size_t groups, count;
  aspi_angles *angles;
  aspi_first_hits *first; /* at each angle; may be NULL */
} aspi_judge;

/* Rebounds over profiles of 2048 lambda_c, each with its negative and in both directions of flight,
 * whose rms slope is that of the ensemble; no model has these seeds. Or over the measured profile,
 * continued by its mirror image. */
asp_code aspi_judge_create(aspi_judge *judge, const aspi_judge_case *subject, const double *degrees,
                           size_t count, asp_error *error);
void aspi_judge_free(aspi_judge *judge);

/* All groups at an angle. */
aspi_angle_groups aspi_judge_groups(const aspi_judge *judge, size_t angle);

/* The divergence of a model with as many groups as the reference has, or one. */
aspi_mean_error aspi_judge_divergence(const aspi_judge *judge, size_t angle,
                                      const aspi_angles *model, size_t groups, size_t histogram);

/* ---- one model ---- */

/* The wall of the case with that model and specular rebounds; NULL on error. */
asp_wall *aspi_judge_wall(const aspi_judge_case *subject, const char *name, asp_error *error);

/* A wall with other heights (NULL: none) than the case's. */
asp_wall *aspi_judge_wall_over(const aspi_judge_case *subject, const asp_heights *profile,
                               double d_p, const char *name, asp_error *error);

/* n rebounds at an impact angle (degrees), by all threads. */
aspi_angles aspi_judge_rebounds(const asp_wall *wall, double d_p, double degrees, size_t n,
                                uint32_t seed);

/* A model's rebounds at one angle, in as many groups as the judge has, to be freed; NULL: out of
 * memory. */
aspi_angles *aspi_judge_model_rebounds(const aspi_judge_case *subject, const asp_wall *wall,
                                       double degrees);

/* D_KL of a model's law of the first hit against the reference's, in bins of one degree; a bin that
 * the model cannot fill counts as 1e-6. NAN if the model has no distribution. */
double aspi_judge_first_hit(const aspi_first_hits *first, const asp_wall *wall, double d_p,
                            double degrees);

/* Nanoseconds per impact, on one thread. */
double aspi_judge_cost(const asp_wall *wall, double d_p, double degrees);
