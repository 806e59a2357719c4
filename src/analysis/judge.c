/* Models against the geometry; see judge.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/judge.h"
#include "base/error.h"

#include <math.h>
#include <stdlib.h>

size_t aspi_judge_folds(const aspi_judge_case *subject) {
  return subject->profile ? 2 : 1;
}

asp_code aspi_judge_angle_least(const aspi_judge_case *subject, double *degrees, asp_error *error) {
  *degrees = 0;
  return subject->profile ? aspi_judge_profile_angle_least(subject, degrees, error) : ASP_OK;
}

/* ---- what models are made of ---- */

static asp_code make_fold(aspi_judge_walls *w, const aspi_judge_case *subject, size_t fold,
                          asp_error *error) {
  double d_p = subject->d_p;
  if (subject->profile) {
    w->profile[fold] = aspi_judge_profile_half(subject->profile, 1 - fold, error);
    w->surface[fold] =
        w->profile[fold] ? asp_surface_create_profile(w->profile[fold], d_p, d_p, 1, error) : NULL;
  } else {
    w->surface[fold] = asp_surface_create(subject->r_q, subject->lambda_c, error);
  }
  return w->surface[fold] ? ASP_OK : error->code;
}

asp_code aspi_judge_walls_create(aspi_judge_walls *w, const aspi_judge_case *subject,
                                 asp_error *error) {
  asp_error own;
  *w = (aspi_judge_walls){.folds = aspi_judge_folds(subject)};
  for (size_t fold = 0; fold < w->folds; fold++)
    if (make_fold(w, subject, fold, &own)) {
      aspi_judge_walls_free(w);
      const char *of = subject->profile ? "surface profile: half of it: " : "";
      return aspi_fail(error, own.code, "%s%.400s", of, own.text);
    }
  return ASP_OK;
}

void aspi_judge_walls_free(aspi_judge_walls *w) {
  for (size_t fold = 0; fold < 2; fold++) {
    asp_surface_free(w->surface[fold]);
    asp_profile_free(w->profile[fold]);
  }
  *w = (aspi_judge_walls){.folds = 0};
}

/* ---- the ensemble ---- */

asp_code aspi_judge_create(aspi_judge *judge, const aspi_judge_case *subject,
                           const aspi_judge_walls *walls, const double *degrees, size_t count,
                           asp_error *error) {
  size_t groups = subject->groups, done = 0;
  *judge = (aspi_judge){.groups = groups, .count = count, .folds = aspi_judge_folds(subject)};
  judge->angles = calloc(groups * count, sizeof *judge->angles);
  judge->first = calloc(count, sizeof *judge->first);
  asp_error worst = {ASP_OK, ""};
  if (!judge->angles || !judge->first)
    aspi_fail(&worst, ASP_ENOMEM, "out of memory for a judge of %zu groups", groups);
#pragma omp parallel for schedule(dynamic)
  for (size_t g = 0; g < groups; g++) {
    asp_error own = {ASP_OK, ""};
    bool failed;
#pragma omp critical
    failed = worst.code;
    if (!failed)
      aspi_judge_fly_profile(judge, subject, walls, degrees, g, &own);
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

/* The groups of one fold. */
static aspi_angle_groups fold_of(const aspi_judge *judge, size_t angle, size_t fold) {
  size_t first = judge->groups * fold / judge->folds;
  size_t end = judge->groups * (fold + 1) / judge->folds;
  return (aspi_angle_groups){judge->angles + first * judge->count + angle, end - first,
                             judge->count};
}

aspi_estimate aspi_judge_divergence(const aspi_judge *judge, size_t angle, const aspi_angles *model,
                                    size_t groups, size_t histogram) {
  aspi_estimate d = {0, 0};
  double folds = (double)judge->folds;
  for (size_t fold = 0; fold < judge->folds; fold++) {
    size_t first = groups * fold / judge->folds, end = groups * (fold + 1) / judge->folds;
    aspi_angle_groups own = {model + first, end - first, 1};
    aspi_estimate of = aspi_angles_divergence(fold_of(judge, angle, fold), own, histogram);
    d.value += of.value / folds;
    d.se = hypot(d.se, of.se / folds);
  }
  return d;
}
