/* Reference in the plane of incidence: generated profiles, or the pieces of a measured one; see
 * judge.h. Later hits are followed along the path of the particle's center.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/judge.h"
#include "base/error.h"
#include "base/units.h"
#include "surface/closing.h"
#include "spread/line.h"
#include "surface/profile.h"
#include "wall/wall.h"

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

/* `count` points of a measured profile; NULL on error. */
static asp_profile *part_of(const asp_profile *profile, size_t first, size_t count,
                            asp_error *error) {
  return asp_profile_from_heights(asp_profile_heights(profile) + first, count,
                                  asp_profile_spacing(profile), false, error);
}

asp_profile *aspi_judge_profile_half(const asp_profile *profile, size_t half, asp_error *error) {
  size_t points = asp_profile_points(profile) / 2;
  return part_of(profile, half * points, points, error);
}

/* A piece of a measured profile. */
static asp_profile *piece_of(const aspi_judge_case *subject, size_t number, asp_error *error) {
  size_t points = asp_profile_points(subject->profile), pieces = subject->groups;
  size_t first = points * number / pieces, end = points * (number + 1) / pieces;
  return part_of(subject->profile, first, end - first, error);
}

/* The path of the particle's center over a realization, as one of the flights meets it. */
static asp_profile *path_of(const aspi_judge_case *subject, size_t number, int flight,
                            asp_error *error) {
  double r_q = subject->r_q, lambda_c = subject->lambda_c;
  uint32_t seed = SEED_FIRST + subject->seed % 1048576 * ASPI_JUDGES_MOST + (uint32_t)number;
  asp_profile *profile =
      aspi_profile_create_scaled(r_q, lambda_c, lambda_c / RESOLUTION, (size_t)RESOLUTION * LENGTH,
                                 seed, flight % 2 ? -1 : 1, error);
  asp_profile *path = profile ? aspi_profile_rolled(profile, subject->d_p, 1, error) : NULL;
  asp_profile_free(profile);
  if (path && flight > 1) {
    asp_profile *mirrored = aspi_profile_mirrored(path, error);
    asp_profile_free(path);
    path = mirrored;
  }
  return path;
}

/* The line that a flight passes over, as a wall and as segments, and the diameter of the flying
 * particle: nearly 0 over the path of the center. */
typedef struct course {
  asp_wall *wall;
  aspi_line line;
  double d_p;
} course;

static asp_code course_create(course *made, const aspi_judge_case *subject, asp_surface *surface,
                              size_t number, int flight, asp_error *error) {
  bool measured = subject->profile;
  asp_profile *profile =
      measured ? piece_of(subject, number, error) : path_of(subject, number, flight, error);
  aspi_judge_walls of = {.folds = 1, .surface = {surface}, .profile = {profile}};
  *made = (course){.d_p = measured ? subject->d_p : 1e-6 * subject->lambda_c};
  asp_code code =
      profile ? aspi_line_over_profile(&made->line, profile, measured ? made->d_p : 0, error)
              : error->code;
  if (!code && surface && !(made->wall = aspi_judge_wall(&of, 0, made->d_p, "traced", true, error)))
    code = error->code;
  asp_profile_free(profile);
  return code;
}

static void course_free(course *over) {
  aspi_line_free(&over->line);
  asp_wall_free(over->wall);
}

asp_code aspi_judge_profile_angle_least(const aspi_judge_case *subject, double *degrees,
                                        asp_error *error) {
  *degrees = 0;
  for (size_t number = 0; number < subject->groups; number++) {
    course over;
    asp_code code = course_create(&over, subject, NULL, number, 0, error);
    if (!code)
      *degrees = fmax(*degrees, aspi_degrees(atan(over.line.fall_least)));
    course_free(&over);
    if (code)
      return code;
  }
  return ASP_OK;
}

/* Adds the shares of the line's first hits in bins of one degree, from -90 to 90. */
static asp_code add_first_hits(const aspi_line *line, double degrees, double part, size_t fold,
                               aspi_first_hits *first, asp_error *error) {
  size_t n = line->n;
  double *weight = calloc(n, sizeof *weight);
  if (!weight)
    return aspi_fail(error, ASP_ENOMEM, "out of memory for %zu faces", n);
  aspi_line_first_hits(line, aspi_line_fall(line, aspi_radians(degrees)), weight);
  double share[ASPI_ANGLE_BINS] = {0}, mean = 0;
  for (size_t i = 0; i < n; i++)
    if (weight[i] > 0) {
      double delta = atan(line->slope[i]);
      share[(int)floor(aspi_degrees(delta)) + 90] += weight[i];
      mean += weight[i] * delta;
    }
  free(weight);
#pragma omp critical
  {
    for (int i = 0; i < ASPI_ANGLE_BINS; i++)
      first->share[fold][i] += part * share[i];
    first->mean += part * mean;
  }
  return ASP_OK;
}

asp_code aspi_judge_fly_profile(aspi_judge *judge, const aspi_judge_case *subject,
                                const aspi_judge_walls *walls, const double *degrees, size_t number,
                                asp_error *error) {
  int flights = subject->profile ? 1 : FLIGHTS;
  size_t all = (size_t)flights * subject->groups, rays = subject->rays / all + 1;
  size_t fold = judge->folds * number / subject->groups;
  asp_code code = ASP_OK;
  for (int flight = 0; flight < flights && !code; flight++) {
    course over;
    code = course_create(&over, subject, walls->surface[0], number, flight, error);
    for (size_t k = 0; k < judge->count && !code; k++) {
      uint32_t seed = subject->seed + (uint32_t)number * (uint32_t)flights + (uint32_t)flight;
      aspi_angles found = aspi_judge_rebounds(over.wall, over.d_p, degrees[k], rays, seed);
      aspi_angles_merge(&judge->angles[number * judge->count + k], &found);
      code =
          add_first_hits(&over.line, degrees[k], 1. / (double)all, fold, &judge->first[k], error);
    }
    course_free(&over);
  }
  return code;
}
