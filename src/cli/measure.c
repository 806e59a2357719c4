/* Models against the geometry; see measure.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/measure.h"
#include "spread/line.h"
#include "wall/wall.h"
#include "surface/closing.h"
#include "surface/profile.h"

#include <math.h>
#include <stdlib.h>

/* A profile that judges. */
#define RESOLUTION 64
#define LENGTH 2048

/* Those that make models have seeds above 2^30 (first_hits.csv), or below 2^10 (traced). */
#define SEED_FIRST 1024

/* Flights over a profile: over itself and its negative, and in both directions. */
enum { FLIGHTS = 4 };

/* Probability of a bin that a model leaves empty, in a comparison without sampling. */
#define LEAST_SHARE 1e-6

/* `count` points of a measured profile; NULL on error. */
static asp_profile *part_of(const asp_profile *profile, size_t first, size_t count,
                            asp_error *error) {
  return asp_profile_from_heights(asp_profile_heights(profile) + first, count,
                                  asp_profile_spacing(profile), false, error);
}

measure_wall measure_wall_create(const measure_case *subject) {
  measure_wall wall = {{NULL, NULL}, {NULL, NULL}};
  asp_error error;
  size_t half = subject->profile ? asp_profile_points(subject->profile) / 2 : 0;
  for (int i = 0; i < 2; i++) {
    if (!subject->profile) {
      wall.surface[i] =
          i ? wall.surface[0] : asp_surface_create(subject->r_q, subject->lambda_c, &error);
    } else {
      wall.profile[i] = part_of(subject->profile, i ? 0 : half, half, &error);
      if (wall.profile[i])
        wall.surface[i] =
            asp_surface_create_profile(wall.profile[i], subject->d_p, subject->d_p, 1, &error);
    }
    if (!wall.surface[i])
      cli_bad_usage("%s%s", subject->profile ? "surface profile: half of it: " : "", error.text);
  }
  return wall;
}

void measure_wall_free(measure_wall *wall) {
  asp_surface_free(wall->surface[0]);
  if (wall->surface[1] != wall->surface[0])
    asp_surface_free(wall->surface[1]);
  asp_profile_free(wall->profile[0]);
  asp_profile_free(wall->profile[1]);
}

asp_wall *measure_specular(const measure_specular_wall *of, double d_p, const char *model,
                           bool multiple) {
  asp_error error;
  asp_wall *wall = asp_wall_create(&error);
  if (!wall)
    cli_fail("%s", error.text);
  asp_wall_choose(wall, "rebound", "constant", NULL);
  asp_wall_choose(wall, "spread", model, NULL);
  asp_wall_choose(wall, "tilt", of->isotropic ? "isotropic" : "plane", NULL);
  asp_wall_choose(wall, "collisions", multiple ? "multiple" : "single", NULL);
  asp_wall_set(wall, "deposit", 0, NULL);
  asp_wall_set(wall, "d_p_least", d_p, NULL);
  asp_wall_set(wall, "d_p_most", d_p, NULL);
  asp_wall_set_surface(wall, of->surface);
  asp_wall_set_profile(wall, of->profile);
  asp_wall_set_map(wall, of->map);
  if (asp_wall_prepare(wall, &error))
    cli_bad_usage("%s", error.text);
  return wall;
}

measure_model measure_model_create(const measure_case *subject, const measure_wall *wall,
                                   const char *model, bool multiple) {
  measure_model made;
  for (int i = 0; i < 2; i++) {
    bool same = i && wall->surface[1] == wall->surface[0];
    measure_specular_wall of = {.surface = wall->surface[i], .profile = wall->profile[i]};
    made.on[i] = same ? made.on[0] : measure_specular(&of, subject->d_p, model, multiple);
  }
  return made;
}

void measure_model_free(measure_model *model) {
  asp_wall_free(model->on[0]);
  if (model->on[1] != model->on[0])
    asp_wall_free(model->on[1]);
}

static const double up[3] = {0, 0, 1};

static void hit(const asp_wall *wall, double d_p, const double v1[3], uint32_t seed, uint64_t tag,
                asp_impact *impact) {
  asp_particle particle = {d_p, 1, NULL, {0, 0, 0}, NULL};
  asp_wall_impact(wall, &particle, v1, up, &(asp_key){seed, 1, tag, 1}, impact);
}

static void add(measure_angles *sum, const measure_angles *other) {
  for (int i = 0; i < MEASURE_BINS; i++)
    sum->count[i] += other->count[i];
  double all = sum->n + other->n, share = all > 0 ? other->n / all : 0;
  sum->mean += share * (other->mean - sum->mean);
  sum->later += share * (other->later - sum->later);
  sum->n = all;
}

measure_angles measure_rebounds(const asp_wall *wall, double d_p, double alpha1, size_t n,
                                uint32_t seed) {
  measure_angles all = {.n = (double)n};
  double v1[3] = {cos(alpha1), 0, -sin(alpha1)};
#pragma omp parallel
  {
    measure_angles mine = {.n = 0};
#pragma omp for schedule(static)
    for (size_t i = 0; i < n; i++) {
      asp_impact impact;
      hit(wall, d_p, v1, seed, i, &impact);
      double angle = cli_degrees(asp_impact_coefficients(v1, up, &impact).alpha2);
      int bin = (int)angle;
      mine.count[bin < MEASURE_BINS ? bin : MEASURE_BINS - 1]++;
      mine.mean += angle / (double)n;
      mine.later += (impact.hits > 1) / (double)n;
    }
#pragma omp critical
    {
      for (int i = 0; i < MEASURE_BINS; i++)
        all.count[i] += mine.count[i];
      all.mean += mine.mean;
      all.later += mine.later;
    }
  }
  return all;
}

/* ---- the ensemble ---- */

/* A piece of a measured profile. */
static asp_profile *piece_of(const measure_case *subject, int number, asp_error *error) {
  size_t points = asp_profile_points(subject->profile), pieces = (size_t)subject->profiles;
  size_t first = points * (size_t)number / pieces, end = points * (size_t)(number + 1) / pieces;
  return part_of(subject->profile, first, end - first, error);
}

/* The path of the particle's centre over a realisation, as one of the flights sees it. */
static asp_profile *path_of(const measure_case *subject, int number, int flight, asp_error *error) {
  size_t points = (size_t)RESOLUTION * LENGTH;
  double spacing = subject->lambda_c / RESOLUTION;
  uint32_t seed = SEED_FIRST + subject->seed % 1048576 * MEASURE_PROFILES_MOST + (uint32_t)number;
  asp_profile *profile = aspi_profile_create_scaled(subject->r_q, subject->lambda_c, spacing,
                                                    points, seed, flight % 2 ? -1 : 1, error);
  asp_profile *path = profile ? aspi_profile_rolled(profile, subject->d_p, 1, error) : NULL;
  asp_profile_free(profile);
  if (path && flight > 1) {
    asp_profile *mirrored = aspi_profile_mirrored(path, error);
    asp_profile_free(path);
    path = mirrored;
  }
  return path;
}

/* What a flight goes over, and the diameter of what flies: of a path of the centre nearly nothing.
 */
typedef struct course {
  asp_profile *profile;
  double d_p;
} course;

static course course_of(const measure_case *subject, int number, int flight) {
  asp_error error;
  course made = subject->profile
                    ? (course){piece_of(subject, number, &error), subject->d_p}
                    : (course){path_of(subject, number, flight, &error), 1e-6 * subject->lambda_c};
  if (!made.profile)
    cli_fail("%s", error.text);
  return made;
}

/* The halves of a measured profile, of which each judges what is made of the other. */
static int folds_of(const measure_case *subject) {
  return subject->profile ? 2 : 1;
}

static int fold_of(const measure_case *subject, int number) {
  return folds_of(subject) * number / subject->profiles;
}

static int flights_of(const measure_case *subject) {
  return subject->profile ? 1 : FLIGHTS;
}

static aspi_line line_of(const course *over, bool measured) {
  asp_error error;
  aspi_line line;
  if (aspi_line_over_profile(&line, over->profile, measured ? over->d_p : 0, &error))
    cli_fail("%s", error.text);
  return line;
}

double measure_angle_least(const measure_case *subject) {
  double least = 0;
  for (int number = 0; subject->profile && number < subject->profiles; number++) {
    course over = course_of(subject, number, 0);
    aspi_line line = line_of(&over, true);
    least = fmax(least, cli_degrees(atan(line.fall_least)));
    aspi_line_free(&line);
    asp_profile_free(over.profile);
  }
  return least;
}

/* Adds the shares of the line's first hits in bins of one degree, from -90 to 90. */
static void add_first_hits(const aspi_line *line, double part, int fold,
                           measure_reference *reference) {
  double *weight = cli_allocate(line->n, sizeof *weight);
  aspi_line_first_hits(line, aspi_line_fall(line, reference->alpha1), weight);
  double share[MEASURE_BINS] = {0}, mean = 0;
  for (size_t i = 0; i < line->n; i++)
    if (weight[i] > 0) {
      double delta = atan(line->slope[i]);
      share[(int)floor(cli_degrees(delta)) + 90] += weight[i];
      mean += weight[i] * delta;
    }
  free(weight);
#pragma omp critical
  {
    for (int i = 0; i < MEASURE_BINS; i++)
      reference->first_hit[fold][i] += part * share[i];
    reference->mean_first += part * mean;
  }
}

/* One flight over one of the profiles, at all angles. */
static void fly(const measure_case *subject, const asp_surface *surface, int number, int flight,
                measure_reference *references, size_t n) {
  course over = course_of(subject, number, flight);
  aspi_line line = line_of(&over, subject->profile);
  measure_specular_wall of = {.surface = surface, .profile = over.profile};
  asp_wall *wall = measure_specular(&of, over.d_p, "traced", true);
  asp_profile_free(over.profile);
  int flights = flights_of(subject), all = flights * subject->profiles;
  size_t rays = subject->rays / (size_t)all + 1;
  for (size_t k = 0; k < n; k++) {
    uint32_t seed = subject->seed + (uint32_t)(number * flights + flight);
    measure_angles found = measure_rebounds(wall, over.d_p, references[k].alpha1, rays, seed);
    add(&references[k].profile[number], &found);
    add_first_hits(&line, 1. / all, fold_of(subject, number), &references[k]);
  }
  aspi_line_free(&line);
  asp_wall_free(wall);
}

measure_reference *measure_references(const measure_case *subject, const measure_wall *wall,
                                      const double *angles, size_t n) {
  measure_reference *references = cli_allocate(n, sizeof *references);
  for (size_t k = 0; k < n; k++) {
    references[k].alpha1 = cli_radians(angles[k]);
    references[k].profile = cli_allocate((size_t)subject->profiles, sizeof(measure_angles));
  }
  cli_progress progress = cli_progress_begin("ensemble", subject->profiles);
  int done = 0;
#pragma omp parallel for schedule(dynamic)
  for (int number = 0; number < subject->profiles; number++) {
    for (int flight = 0; flight < flights_of(subject); flight++)
      fly(subject, wall->surface[0], number, flight, references, n);
#pragma omp critical
    cli_progress_show(&progress, ++done);
  }
  cli_progress_end(&progress);
  return references;
}

void measure_references_free(measure_reference *references, size_t n) {
  for (size_t k = 0; k < n; k++)
    free(references[k].profile);
  free(references);
}

/* ---- comparing ---- */

/* Of the groups of a fold but one; -1: of all of them. */
static double divergence_of(const measure_case *subject, const measure_angles *reference,
                            const measure_angles *other, int fold, int without) {
  measure_angles p = {.n = 0}, q = {.n = 0};
  for (int g = 0; g < subject->profiles; g++)
    if (g != without && fold_of(subject, g) == fold) {
      add(&p, &reference[g]);
      add(&q, &other[g]);
    }
  double sum = 0;
  for (int i = 0; i < MEASURE_BINS; i++)
    if (p.count[i] > 0)
      sum += p.count[i] / p.n * log(p.count[i] / p.n * q.n / fmax(q.count[i], 0.5));
  return sum;
}

/* By the jackknife over the groups of a fold: adds its share to the mean over the folds. */
static void add_fold(const measure_case *subject, const measure_angles *reference,
                     const measure_angles *other, int fold, measure_divergence *d) {
  double whole = divergence_of(subject, reference, other, fold, -1), mean = 0, square = 0;
  double n = (double)subject->profiles / folds_of(subject), share = 1. / folds_of(subject);
  for (int g = 0; g < subject->profiles; g++)
    if (fold_of(subject, g) == fold) {
      double less = divergence_of(subject, reference, other, fold, g) - whole;
      mean += less / n;
      square += less * less / n;
    }
  d->kl += share * (whole - (n - 1) * mean);
  d->se = hypot(d->se, share * sqrt((n - 1) * fmax(0, square - mean * mean)));
}

measure_divergence measure_compare(const measure_case *subject, const measure_reference *reference,
                                   const measure_model *model) {
  int groups = subject->profiles;
  measure_angles *mine = cli_allocate((size_t)groups, sizeof *mine);
  measure_angles all = {.n = 0}, judge = {.n = 0};
  for (int g = 0; g < groups; g++) {
    uint32_t seed = ~subject->seed - (uint32_t)g;
    mine[g] = measure_rebounds(model->on[fold_of(subject, g)], subject->d_p, reference->alpha1,
                               subject->rays / (size_t)groups + 1, seed);
    add(&all, &mine[g]);
    add(&judge, &reference->profile[g]);
  }
  measure_divergence d = {.mean = all.mean, .reference_mean = judge.mean};
  for (int fold = 0; fold < folds_of(subject); fold++)
    add_fold(subject, reference->profile, mine, fold, &d);
  free(mine);
  return d;
}

/* The share of first hits between two tilts. */
static double share_between(const asp_wall *wall, const measure_case *subject, double alpha1,
                            double low, double high) {
  double slope = asp_surface_slope(wall->surface, subject->d_p);
  aspi_view view = {.slope = slope,
                    .sigma = atan(slope),
                    .alpha1 = alpha1,
                    .d_p = subject->d_p,
                    .data = wall->data,
                    .phi_r = asp_surface_phi_r(wall->surface),
                    .kappa = asp_surface_kappa(wall->surface, subject->d_p)};
  return wall->spread->distribution(&view, high) - wall->spread->distribution(&view, low);
}

double measure_first_hit(const measure_case *subject, const measure_reference *reference,
                         const measure_model *model) {
  if (!model->on[0]->spread->distribution)
    return NAN;
  double sum = 0;
  for (int fold = 0; fold < folds_of(subject); fold++)
    for (int i = 0; i < MEASURE_BINS; i++) {
      double share = reference->first_hit[fold][i];
      if (!(share > 0))
        continue;
      double p = share_between(model->on[fold], subject, reference->alpha1, cli_radians(i - 90),
                               cli_radians(i - 89));
      sum += share * log(folds_of(subject) * share / fmax(p, LEAST_SHARE));
    }
  return sum;
}

double measure_cost(const asp_wall *wall, double d_p, double alpha1) {
  enum { RUNS = 12, IMPACTS = 2000 };
  double least = INFINITY, v1[3] = {cos(alpha1), 0, -sin(alpha1)};
  for (int run = 0; run < RUNS; run++) {
    double begun = cli_seconds();
    asp_impact impact;
    for (uint64_t i = 0; i < IMPACTS; i++)
      hit(wall, d_p, v1, 77, i, &impact);
    least = fmin(least, cli_seconds() - begun);
  }
  return 1e9 * least / IMPACTS;
}
