/* The reference in the plane of incidence: generated profiles, or a measured one; see judge.h.
 * Later hits are followed along the path of the particle's center.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/judge.h"
#include "base/error.h"
#include "base/units.h"
#include "spread/flight.h"
#include "surface/rolling.h"

#include <math.h>
#include <stdlib.h>

/* Points per lambda_c of a reference profile, and its length in lambda_c. */
#define RESOLUTION 64
#define LENGTH 2048

/* Seeds of reference profiles. Profiles behind models have seeds above 2^30 (first_hits.csv) or
 * below 2^10 (traced). */
#define SEED_FIRST 1024

/* Flights over a generated profile: over itself and its negative, and in both directions. */
enum { FLIGHTS = 4 };

/* The path of the particle's center over a realization, as one of the flights meets it. */
static asp_heights *path_of(const aspi_judge_case *subject, size_t number, int flight,
                            asp_error *error) {
  double r_q = subject->r_q, lambda_c = subject->lambda_c;
  uint32_t seed = SEED_FIRST + subject->seed % 1048576 * ASPI_JUDGES_MOST + (uint32_t)number;
  asp_heights *profile =
      aspi_profile_generate_scaled(r_q, lambda_c, lambda_c / RESOLUTION,
                                   (size_t)RESOLUTION * LENGTH, seed, flight % 2 ? -1 : 1, error);
  asp_heights *path = profile ? aspi_profile_rolled(profile, subject->d_p, 1, error) : NULL;
  asp_heights_free(profile);
  if (path && flight > 1) {
    asp_heights *mirrored = aspi_profile_mirrored(path, error);
    asp_heights_free(path);
    path = mirrored;
  }
  return path;
}

/* The heights under a flight, as a wall and as a field, and the diameter of the flying
 * particle: nearly 0 over the path of the center. */
typedef struct course {
  asp_wall *wall;
  aspi_field field;
  double d_p;
} course;

/* Over one of the measured profiles; NULL: over a generated one. */
static asp_code course_create(course *made, const aspi_judge_case *subject,
                              const asp_heights *measured, size_t number, int flight,
                              asp_error *error) {
  asp_heights one, *path = measured ? NULL : path_of(subject, number, flight, error);
  const asp_heights *over = path;
  if (measured) {
    one = *measured;
    one.next = NULL;
    over = &one;
  }
  *made = (course){.d_p = measured ? subject->d_p : 1e-6 * subject->lambda_c};
  asp_code code =
      over ? aspi_field_create(&made->field, over, measured ? subject->d_p : 0, NULL, error)
           : error->code;
  if (!code && !(made->wall = aspi_judge_wall_over(subject, over, made->d_p, "traced", error)))
    code = error->code;
  asp_heights_free(path);
  return code;
}

static void course_free(course *over) {
  aspi_field_free(&over->field);
  asp_wall_free(over->wall);
}

/* Adds the shares of a field's first hits in bins of one degree, from -90 to 90. */
static asp_code add_first_hits(const aspi_field *field, double degrees, double part,
                               aspi_first_hits *first, asp_error *error) {
  size_t n = (size_t)field->columns;
  double *weight = calloc(n, sizeof *weight);
  if (!weight)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for %zu faces", n);
  aspi_field_first_hits(field, aspi_field_fall(field, aspi_radians(degrees)), weight);
#pragma omp critical
  for (size_t i = 0; i < n; i++)
    if (weight[i] > 0) {
      double delta = atan(aspi_field_slope(field, i));
      first->share[(int)floor(aspi_degrees(delta)) + 90] += part * weight[i];
      first->mean += part * weight[i] * delta;
    }
  free(weight);
  return ASP_OK;
}

/* Adds the rebounds of a group at all angles, and its first hits; called by several threads. */
static asp_code fly_group(aspi_judge *judge, const aspi_judge_case *subject, const double *degrees,
                          size_t number, asp_error *error) {
  const asp_heights *measured = subject->profile;
  int flights = measured ? 0 : FLIGHTS;
  for (const asp_heights *h = measured; h; h = h->next)
    flights++;
  asp_code code = ASP_OK;
  for (int flight = 0; flight < flights && !code; flight++) {
    double part = 1. / FLIGHTS;
    if (measured)
      part = aspi_profile_length(measured) / aspi_heights_extent(subject->profile).total;
    part /= (double)subject->groups;
    size_t rays = (size_t)((double)subject->rays * part) + 1;
    course over;
    code = course_create(&over, subject, measured, number, flight, error);
    for (size_t k = 0; k < judge->count && !code; k++) {
      uint32_t seed = subject->seed + (uint32_t)number * (uint32_t)flights + (uint32_t)flight;
      aspi_angles found = aspi_judge_rebounds(over.wall, over.d_p, degrees[k], rays, seed);
      aspi_angles_merge(&judge->angles[number * judge->count + k], &found);
      code = add_first_hits(&over.field, degrees[k], part, &judge->first[k], error);
    }
    course_free(&over);
    measured = measured ? measured->next : NULL;
  }
  return code;
}

asp_code aspi_judge_create(aspi_judge *judge, const aspi_judge_case *subject, const double *degrees,
                           size_t count, asp_error *error) {
  size_t groups = subject->groups, done = 0;
  *judge = (aspi_judge){.groups = groups, .count = count};
  judge->angles = calloc(groups * count, sizeof *judge->angles);
  judge->first = calloc(count, sizeof *judge->first);
  asp_error worst = {.code = ASP_OK};
  if (!judge->angles || !judge->first)
    aspi_fail(&worst, ASP_ENOMEM, "out of memory for a judge of %zu groups", groups);
#pragma omp parallel for schedule(dynamic)
  for (size_t g = 0; g < groups; g++) {
    asp_error own = {.code = ASP_OK};
    bool failed;
#pragma omp critical
    failed = worst.code;
    if (!failed)
      fly_group(judge, subject, degrees, g, &own);
#pragma omp critical
    {
      worst = own.code ? own : worst;
      done++;
      if (subject->progress)
        subject->progress(subject->context, (double)done / (double)groups);
    }
  }
  if (worst.code) {
    aspi_judge_free(judge);
    *error = worst;
  }
  return worst.code;
}

void aspi_judge_free(aspi_judge *judge) {
  free(judge->angles);
  free(judge->first);
  *judge = (aspi_judge){.groups = 0};
}

aspi_angle_groups aspi_judge_groups(const aspi_judge *judge, size_t angle) {
  return (aspi_angle_groups){judge->angles + angle, judge->groups, judge->count};
}

aspi_mean_error aspi_judge_divergence(const aspi_judge *judge, size_t angle,
                                      const aspi_angles *model, size_t groups, size_t histogram) {
  return aspi_angles_divergence(aspi_judge_groups(judge, angle),
                                (aspi_angle_groups){model, groups, 1}, histogram);
}
