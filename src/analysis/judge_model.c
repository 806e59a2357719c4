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

asp_wall *aspi_judge_wall_over(const aspi_judge_case *subject, const asp_heights *profile,
                               double d_p, const char *name, asp_error *error) {
  aspi_wall_choice choice = aspi_wall_choice_smooth();
  asp_surface *surface = subject->profile
                             ? asp_surface_create_profile(subject->profile, d_p, d_p, 1, error)
                             : asp_surface_create(subject->r_q, subject->lambda_c, error);
  aspi_wall_choose_law(&choice, asp_rebound_find("constant", NULL));
  choice.surface = surface;
  choice.heights = profile;
  choice.spread = asp_spread_find(name, NULL);
  choice.sizes = (aspi_sizes){d_p, d_p, 1};
  choice.multiple = true;
  choice.deposit = false;
  asp_wall *wall = surface ? aspi_wall_create(&choice, error) : NULL;
  asp_surface_free(surface);
  return wall;
}

asp_wall *aspi_judge_wall(const aspi_judge_case *subject, const char *name, asp_error *error) {
  return aspi_judge_wall_over(subject, subject->profile, subject->d_p, name, error);
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
      hit(wall, d_p, v1, &(asp_key){seed, 1, i, 1, 0}, &impact);
      aspi_angles_add(&mine, impact.v2, impact.delta_alpha, impact.hits);
    }
#pragma omp critical
    aspi_angles_merge(&all, &mine);
  }
  return all;
}

aspi_angles *aspi_judge_model_rebounds(const aspi_judge_case *subject, const asp_wall *wall,
                                       double degrees) {
  size_t groups = subject->groups;
  aspi_angles *angles = calloc(groups, sizeof *angles);
  for (size_t g = 0; angles && g < groups; g++)
    angles[g] = aspi_judge_rebounds(wall, subject->d_p, degrees, subject->rays / groups + 1,
                                    ~subject->seed - (uint32_t)g);
  return angles;
}

/* The share of first hits between two tilts. */
static double share_between(const asp_wall *wall, double d_p, double alpha1, double low,
                            double high) {
  double slope = asp_surface_slope(wall->surface, d_p);
  aspi_spread_input input = {.slope = slope,
                             .sigma = atan(slope),
                             .alpha1 = alpha1,
                             .d_p = d_p,
                             .data = wall->data,
                             .phi_r = asp_surface_phi_r(wall->surface),
                             .kappa = asp_surface_kappa(wall->surface, d_p)};
  return wall->spread->distribution(&input, high) - wall->spread->distribution(&input, low);
}

double aspi_judge_first_hit(const aspi_first_hits *first, const asp_wall *wall, double d_p,
                            double degrees) {
  double sum = 0;
  for (int i = 0; i < ASPI_ANGLE_BINS && wall->spread->distribution; i++) {
    double share = first->share[i];
    if (!(share > 0))
      continue;
    double p =
        share_between(wall, d_p, aspi_radians(degrees), aspi_radians(i - 90), aspi_radians(i - 89));
    sum += share * log(share / fmax(p, LEAST_SHARE));
  }
  return wall->spread->distribution ? sum : NAN;
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
      hit(wall, d_p, v1, &(asp_key){77, 1, i, 1, 0}, &impact);
    least = fmin(least, seconds() - begun);
  }
  return 1e9 * least / IMPACTS;
}
