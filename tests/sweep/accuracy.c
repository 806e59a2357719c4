/* The accuracy that is promised of the models on Gaussian walls, against ensembles of profiles that
 * made none of them: accuracy [long].
 *
 * Four walls, and a steep one: D_KL of the rebound angle, with later hits, of `visible`,
 * `profile` and `traced`, with standard errors, and the mean tilt of the first hit of the tables. A
 * number is too large where it exceeds its limit by more than three standard errors. The short run
 * looks at a part with small ensembles.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/judge.h"
#include "base/units.h"
#include "wall/wall.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failures;

static void verdict(bool good, const char *what) {
  printf("  %s%s\n", good ? "" : "TOO LARGE: ", what);
  failures += !good;
}

/* The mean tilt of the first hits of a model of tables, in sigma, over that of the ensemble. */
static double tilt_off(const aspi_judge_case *subject, const aspi_first_hits *first, double degrees,
                       const asp_wall *wall) {
  double slope = asp_surface_slope(wall->surface, subject->d_p), sum = 0;
  aspi_spread_input input = {.slope = slope,
                             .sigma = atan(slope),
                             .alpha1 = aspi_radians(degrees),
                             .d_p = subject->d_p,
                             .phi_r = asp_surface_phi_r(wall->surface),
                             .kappa = asp_surface_kappa(wall->surface, subject->d_p)};
  for (int i = 0; i < 4000; i++)
    sum += wall->spread->quantile(&input, (i + 0.5) / 4000) / 4000;
  return (sum - first->mean) / atan(slope);
}

static asp_error error;

/* What comes out of setting up is no failure of a model. */
static void must(asp_code code) {
  if (code)
    fprintf(stderr, "%s\n", error.text), exit(2);
}

/* The divergence of a model; the means of both into `mean`. */
static aspi_mean_error compare(const aspi_judge_case *subject, const aspi_judge *judge,
                               const asp_wall *model, double degrees, size_t k, double mean[2]) {
  size_t groups = subject->groups;
  aspi_angles *angles = aspi_judge_model_rebounds(subject, model, degrees);
  aspi_angle_groups own = {angles, groups, 1};
  size_t rebound = offsetof(aspi_angles, rebound), sum = offsetof(aspi_angles, rebound_sum);
  aspi_mean_error d = aspi_judge_divergence(judge, k, angles, groups, rebound);
  mean[0] = aspi_angles_mean(own, sum).value;
  mean[1] = aspi_angles_mean(aspi_judge_groups(judge, k), sum).value;
  free(angles);
  return d;
}

/* Up to `most` of each of three models; one with 0 is not judged. */
static void judge_wall(aspi_judge_case subject, const double *angles, size_t n,
                       const double *most) {
  static const char *const names[] = {"visible", "profile", "traced"};
  aspi_judge judge;
  must(aspi_judge_create(&judge, &subject, angles, n, &error));
  for (int m = 0; m < 3; m++) {
    if (!(most[m] > 0))
      continue;
    asp_wall *model = aspi_judge_wall(&subject, names[m], &error);
    must(model ? ASP_OK : error.code);
    for (size_t k = 0; k < n; k++) {
      char text[200];
      double mean[2];
      aspi_mean_error d = compare(&subject, &judge, model, angles[k], k, mean);
      snprintf(text, sizeof text,
               "%s on (%g, %g, %g), alpha1 %g: D_KL %.5f +- %.5f, alpha2 %.3f, ensemble %.3f",
               names[m], subject.r_q, subject.lambda_c, subject.d_p, angles[k], d.value, d.se,
               mean[0], mean[1]);
      verdict(d.value < most[m] + 3 * d.se, text);
      if (m != 1)
        continue;
      double off = tilt_off(&subject, &judge.first[k], angles[k], model);
      double noise = 0.005 * sqrt(8. / (double)subject.groups); /* of 2048 lambda_c, at 2 degrees */
      snprintf(text, sizeof text, "mean tilt of its first hit: off by %.4f sigma", off);
      verdict(fabs(off) < 0.007 + noise, text);
    }
    asp_wall_free(model);
  }
  aspi_judge_free(&judge);
}

int main(int argc, char **argv) {
  bool whole = argc > 1 && strcmp(argv[1], "long") == 0;
  static const double walls[][3] = {{20, 130, 35}, {5, 40, 10}, {3, 50, 20}, {1.6, 40, 10}};
  static const double angles[] = {2, 10, 45, 5, 20, 30};
  static const double gentle[] = {0.0005, 0.001, 0.001}, steep[] = {0, 0.003, 0.004};
  aspi_judge_case subject = {.rays = whole ? 1000000 : 60000, .groups = whole ? 32 : 4, .seed = 9};
  for (int w = 0; w < (whole ? 4 : 1); w++) {
    subject.r_q = walls[w][0], subject.lambda_c = walls[w][1], subject.d_p = walls[w][2];
    judge_wall(subject, angles, whole ? 6 : 2, gentle);
  }
  subject.r_q = 20, subject.lambda_c = 40, subject.d_p = 23; /* phi_r 0.5 */
  judge_wall(subject, angles, whole ? 6 : 2, steep);
  return failures > 0;
}
