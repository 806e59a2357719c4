/* Distance of a spread model from the geometry, in the plane of incidence. Reference: rebound
 * angles of generated profiles, or of the pieces of a measured one, none of which made the model.
 * Against it: the model's rebound angles, their divergence, and the cost of an impact. Every
 * rebound is specular, nothing sticks. The judge in three dimensions is in tests/sweep.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_ANALYSIS_JUDGE_H
#define ASP_ANALYSIS_JUDGE_H

#include "analysis/angles.h"
#include "asperity_internal.h"

enum { ASPI_JUDGES_LEAST = 4, ASPI_JUDGES_MOST = 1024 };

/* The case that is judged: a wall and particles of one size. Of a measured profile,
 * two-fold cross-validation: models made from one half are tested on pieces of the other. */
typedef struct aspi_judge_case {
  double r_q, lambda_c, d_p;
  size_t groups; /* profiles of the ensemble, or pieces of a measured one */
  size_t rays;   /* impacts at an angle */
  uint32_t seed;
  const asp_profile *profile;                    /* measured; NULL: none */
  void (*progress)(void *context, double share); /* of the ensemble; may be NULL */
  void *context;
} aspi_judge_case;

size_t aspi_judge_folds(const aspi_judge_case *subject);

/* Least impact angle, in degrees, that the pieces of a measured wall resolve, into *degrees; 0 for
 * a generated wall. */
asp_code aspi_judge_angle_least(const aspi_judge_case *subject, double *degrees, asp_error *error);

/* Source of the models in each fold: the other half, or numbers. */
typedef struct aspi_judge_walls {
  size_t folds;
  asp_surface *surface[2];
  asp_profile *profile[2];
} aspi_judge_walls;
asp_code aspi_judge_walls_create(aspi_judge_walls *walls, const aspi_judge_case *subject,
                                 asp_error *error);
void aspi_judge_walls_free(aspi_judge_walls *walls);

/* First hits of an ensemble of profiles at one angle: shares in bins of one degree from -90, for
 * each fold, and the mean tilt of all, rad. */
typedef struct aspi_first_hits {
  double share[2][ASPI_ANGLE_BINS], mean;
} aspi_first_hits;

/* Reference results at `count` impact angles (degrees): group g at angle k is angles[g * count +
 * k]. */
typedef struct aspi_judge {
  size_t groups, count, folds;
  aspi_angles *angles;
  aspi_first_hits *first; /* at each angle; may be NULL */
} aspi_judge;

/* Rebounds over profiles of 2048 lambda_c, each with its negative and in both directions of flight,
 * whose rms slope is that of the ensemble; no model has these seeds. Or over the pieces of a
 * measured profile, each continued by its mirror image. */
asp_code aspi_judge_create(aspi_judge *judge, const aspi_judge_case *subject,
                           const aspi_judge_walls *walls, const double *degrees, size_t count,
                           asp_error *error);
void aspi_judge_free(aspi_judge *judge);

/* All groups at an angle. */
aspi_angle_groups aspi_judge_groups(const aspi_judge *judge, size_t angle);

/* The divergence of a model, averaged over the folds. Its groups follow each other: as many as the
 * reference has, or one per fold. */
aspi_estimate aspi_judge_divergence(const aspi_judge *judge, size_t angle, const aspi_angles *model,
                                    size_t groups, size_t histogram);

/* One model on what it is made of, as a user has it; the walls must outlive it. */
typedef struct aspi_judge_model {
  asp_wall *on[2];
  size_t folds;
} aspi_judge_model;
asp_code aspi_judge_model_create(aspi_judge_model *model, const aspi_judge_walls *walls, double d_p,
                                 const char *name, bool multiple, asp_error *error);
void aspi_judge_model_free(aspi_judge_model *model);

/* One wall with one model and specular rebounds, of that fold. */
asp_wall *aspi_judge_wall(const aspi_judge_walls *walls, size_t fold, double d_p, const char *name,
                          bool multiple, asp_error *error);

/* n rebounds at an impact angle (degrees), by all threads. */
aspi_angles aspi_judge_rebounds(const asp_wall *wall, double d_p, double degrees, size_t n,
                                uint32_t seed);

/* The model's rebounds at one angle, in as many groups as the judge has, to be freed; NULL: out of
 * memory. */
aspi_angles *aspi_judge_model_rebounds(const aspi_judge_case *subject,
                                       const aspi_judge_model *model, double degrees);

/* D_KL of a model's law of the first hit against the ensemble's, in bins of one degree; a bin that
 * the model cannot fill counts as 1e-6. NAN where the model has no distribution. */
double aspi_judge_first_hit(const aspi_first_hits *first, const aspi_judge_model *model, double d_p,
                            double degrees);

/* Nanoseconds per impact, on one thread. */
double aspi_judge_cost(const asp_wall *wall, double d_p, double degrees);

/* ---- the flights of a judge over one of its profiles ---- */

/* Adds the rebounds of group `number` at all angles, and its first hits to judge->first; called by
 * several threads. */
asp_code aspi_judge_fly_profile(aspi_judge *judge, const aspi_judge_case *subject,
                                const aspi_judge_walls *walls, const double *degrees, size_t number,
                                asp_error *error);

/* The half of a measured profile that judges in fold 0 or 1; NULL on error. */
asp_profile *aspi_judge_profile_half(const asp_profile *profile, size_t half, asp_error *error);

/* The least angle (degrees) at which pieces of a profile can judge. */
asp_code aspi_judge_profile_angle_least(const aspi_judge_case *subject, double *degrees,
                                        asp_error *error);

#endif
