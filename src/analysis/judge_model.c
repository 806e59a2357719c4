/* One spread model with specular rebounds: its wall, rebounds, law of the first hit and cost; see
 * judge.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/judge.h"
#include "base/units.h"
#include "wall/wall.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

/* Probability of a bin that a model leaves empty, in a comparison without sampling. */
#define LEAST_SHARE 1e-6

asp_wall *aspi_judge_wall(const aspi_judge_walls *walls, size_t fold, double d_p, const char *name,
                          bool multiple, asp_error *error) {
  aspi_wall_choice choice = aspi_wall_choice_smooth();
  aspi_wall_choose_law(&choice, asp_rebound_find("constant", NULL));
  choice.surface = walls->surface[fold];
  choice.profile = walls->profile[fold];
  choice.spread = asp_spread_find(name, NULL);
  choice.sizes = (aspi_sizes){d_p, d_p, 1};
  choice.multiple = multiple;
  choice.deposit = false;
  return aspi_wall_create(&choice, error);
}

asp_code aspi_judge_model_create(aspi_judge_model *model, const aspi_judge_walls *walls, double d_p,
                                 const char *name, bool multiple, asp_error *error) {
  *model = (aspi_judge_model){.folds = walls->folds};
  for (size_t fold = 0; fold < walls->folds; fold++) {
    model->on[fold] = aspi_judge_wall(walls, fold, d_p, name, multiple, error);
    if (!model->on[fold]) {
      aspi_judge_model_free(model);
      return error->code;
    }
  }
  return ASP_OK;
}

void aspi_judge_model_free(aspi_judge_model *model) {
  asp_wall_free(model->on[0]);
  asp_wall_free(model->on[1]);
}

static const double up[3] = {0, 0, 1};

static void hit(const asp_wall *wall, double d_p, const double v1[3], const asp_key *key,
                asp_impact *impact) {
  asp_particle particle = {.d_p = d_p, .density = 1};
  asp_wall_impact(wall, &particle, v1, up, key, impact);
}

aspi_angles aspi_judge_rebounds(const asp_wall *wall, double d_p, double degrees, size_t n,
                                uint32_t seed) {
  aspi_angles all = {0};
  double alpha1 = aspi_radians(degrees), v1[3] = {cos(alpha1), 0, -sin(alpha1)};
#pragma omp parallel
  {
    aspi_angles mine = {0};
#pragma omp for schedule(static)
    for (size_t i = 0; i < n; i++) {
      asp_impact impact;
      hit(wall, d_p, v1, &(asp_key){seed, 1, i, 1}, &impact);
      aspi_angles_add(&mine, impact.v2, impact.delta_alpha, impact.hits);
    }
#pragma omp critical
    aspi_angles_merge(&all, &mine);
  }
  return all;
}

aspi_angles *aspi_judge_model_rebounds(const aspi_judge_case *subject,
                                       const aspi_judge_model *model, double degrees) {
  size_t groups = subject->groups;
  aspi_angles *angles = calloc(groups, sizeof *angles);
  for (size_t g = 0; angles && g < groups; g++)
    angles[g] = aspi_judge_rebounds(model->on[model->folds * g / groups], subject->d_p, degrees,
                                    subject->rays / groups + 1, ~subject->seed - (uint32_t)g);
  return angles;
}

/* The share of first hits between two tilts. */
static double share_between(const asp_wall *wall, double d_p, double alpha1, double low,
                            double high) {
  double slope = asp_surface_slope(wall->surface, d_p);
  aspi_view view = {.slope = slope,
                    .sigma = atan(slope),
                    .alpha1 = alpha1,
                    .d_p = d_p,
                    .data = wall->data,
                    .phi_r = asp_surface_phi_r(wall->surface),
                    .kappa = asp_surface_kappa(wall->surface, d_p)};
  return wall->spread->distribution(&view, high) - wall->spread->distribution(&view, low);
}

double aspi_judge_first_hit(const aspi_first_hits *first, const aspi_judge_model *model, double d_p,
                            double degrees) {
  if (!model->on[0]->spread->distribution)
    return NAN;
  double sum = 0, folds = (double)model->folds;
  for (size_t fold = 0; fold < model->folds; fold++)
    for (int i = 0; i < ASPI_ANGLE_BINS; i++) {
      double share = first->share[fold][i];
      if (!(share > 0))
        continue;
      double p = share_between(model->on[fold], d_p, aspi_radians(degrees), aspi_radians(i - 90),
                               aspi_radians(i - 89));
      sum += share * log(folds * share / fmax(p, LEAST_SHARE));
    }
  return sum;
}

static double seconds(void) {
  struct timespec now;
  timespec_get(&now, TIME_UTC);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

double aspi_judge_cost(const asp_wall *wall, double d_p, double degrees) {
  enum { RUNS = 12, IMPACTS = 2000 };
  double alpha1 = aspi_radians(degrees), v1[3] = {cos(alpha1), 0, -sin(alpha1)}, least = INFINITY;
  for (int run = 0; run < RUNS; run++) {
    double begun = seconds();
    asp_impact impact;
    for (uint64_t i = 0; i < IMPACTS; i++)
      hit(wall, d_p, v1, &(asp_key){77, 1, i, 1}, &impact);
    least = fmin(least, seconds() - begun);
  }
  return 1e9 * least / IMPACTS;
}
