/* Makes first_hits.csv: the law of the first hit of discs on Gaussian profiles, which depends on a
 * = tan(alpha1)/s_eff and kappa, and where slopes are not small on phi_r. An ensemble
 * of generated profiles, each with its negative and in both directions of flight; each face weighs
 * what it adds to the running maximum of the path (aspi_field_first_hits). Slopes are in units
 * of the size law's s_eff. To be run by `cmake --build build --target first_hits`, which writes the
 * file in its place; takes some half an hour; the result does not depend on the number of threads.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "asperity_internal.h"
#include "spread/ensemble.h"
#include "spread/flight.h"
#include "surface/rolling.h"
#include "surface/heights.h"
#include "surface/size_law.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum {
  PROFILES = 48,
  LENGTH = 4096,   /* lambda_c */
  PER_LAMBDA = 64, /* points */
  CELLS = 4000     /* of the histogram */
};

#define SEED 0x70000000u /* and those behind it, which judge no model */
#define X_MOST 10.0      /* the histogram is from -X_MOST to X_MOST */

static void fail(const char *text) {
  fprintf(stderr, "make_first_hits: %s\n", text);
  exit(1);
}

/* The shares of first hits in cells of p/s_eff, by a. */
typedef struct counts {
  double share[ASP_ENSEMBLE_AS][CELLS], mean[ASP_ENSEMBLE_AS];
} counts;

static void add_flights(const aspi_field *line, double s_eff, counts *into) {
  size_t faces = (size_t)line->columns;
  double *weight = malloc(faces * sizeof *weight);
  if (!weight)
    fail("out of memory");
  for (int k = 0; k < ASP_ENSEMBLE_AS; k++) {
    aspi_field_first_hits(line, aspi_field_fall(line, atan(aspi_ensemble_a(k) * s_eff)), weight);
    for (size_t i = 0; i < faces; i++) {
      if (!(weight[i] > 0))
        continue;
      double x = aspi_field_slope(line, i) / s_eff;
      int cell = (int)((x + X_MOST) * (CELLS / (2 * X_MOST)));
      into->share[k][cell < 0 ? 0 : cell < CELLS ? cell : CELLS - 1] += weight[i] / 4;
      into->mean[k] += weight[i] * x / 4;
    }
  }
  free(weight);
}

static void add_heights(const asp_heights *profile, double d_p, double s_eff, counts *into) {
  asp_error error;
  asp_heights *path = aspi_profile_rolled(profile, d_p, 1, &error);
  asp_heights *mirror = path ? aspi_profile_mirrored(path, &error) : NULL;
  if (!mirror)
    fail(error.text);
  const asp_heights *both[] = {path, mirror};
  for (int i = 0; i < 2; i++) {
    aspi_field line;
    if (aspi_field_create(&line, both[i], 0, NULL, &error))
      fail(error.text);
    add_flights(&line, s_eff, into);
    aspi_field_free(&line);
  }
  asp_heights_free(path);
  asp_heights_free(mirror);
}

static void add_profile(double phi_r, double kappa, uint32_t seed, counts *into) {
  asp_error error;
  asp_surface *surface = asp_surface_create(phi_r, 1, &error);
  if (!surface)
    fail(error.text);
  double d_p = kappa / (sqrt(3) * phi_r), s_eff = asp_surface_slope(surface, d_p);
  asp_surface_free(surface);
  for (int sign = -1; sign <= 1; sign += 2) {
    asp_heights *profile = aspi_profile_generate_scaled(phi_r, 1, 1. / PER_LAMBDA,
                                                        LENGTH * PER_LAMBDA, seed, sign, &error);
    if (!profile)
      fail(error.text);
    add_heights(profile, d_p, s_eff, into);
    asp_heights_free(profile);
  }
}

/* Where the share below is Phi(z), linear within a cell. */
static double quantile(const double *share, double z) {
  double u = gsl_cdf_ugaussian_P(z), below = 0, total = 0;
  for (int i = 0; i < CELLS; i++)
    total += share[i];
  u *= total;
  for (int i = 0; i < CELLS; i++) {
    if (below + share[i] >= u)
      return ((double)i + (u - below) / share[i]) * (2 * X_MOST / CELLS) - X_MOST;
    below += share[i];
  }
  return X_MOST;
}

static void print_kappa(double phi_r, double kappa, const counts *each) {
  static counts sum;
  sum = (counts){{{0}}, {0}};
  double square[ASP_ENSEMBLE_AS] = {0};
  for (int r = 0; r < PROFILES; r++)
    for (int k = 0; k < ASP_ENSEMBLE_AS; k++) {
      sum.mean[k] += each[r].mean[k] / PROFILES;
      square[k] += each[r].mean[k] * each[r].mean[k] / PROFILES;
      for (int i = 0; i < CELLS; i++)
        sum.share[k][i] += each[r].share[k][i] / PROFILES;
    }
  for (int k = 0; k < ASP_ENSEMBLE_AS; k++) {
    double a = aspi_ensemble_a(k);
    double se = sqrt(fmax(0, square[k] - sum.mean[k] * sum.mean[k]) / (PROFILES - 1));
    printf("%.4g,%.4g,%.4g,%.5f,%.5f", phi_r, kappa, a, sum.mean[k], se);
    for (int i = 0; i < ASP_ENSEMBLE_ZS; i++)
      printf(",%.4f", fmax(-a, quantile(sum.share[k], aspi_ensemble_z(i))));
    putchar('\n');
  }
  fflush(stdout);
}

int main(void) {
  printf("# first hits of discs on Gaussian profiles; %d profiles of %d lambda_c, %d points a "
         "lambda_c, seeds %u to %u, each with its negative, both directions\n"
         "# phi_r; kappa; a = tan(alpha1)/s_eff; mean of x = slope/s_eff and its standard error; x "
         "where "
         "the share below is Phi(z), by z\n"
         "# made by: cmake --build build --target first_hits\nphi_r,kappa,a,mean,mean_se",
         PROFILES, LENGTH, PER_LAMBDA, SEED, SEED + PROFILES - 1);
  for (int i = 0; i < ASP_ENSEMBLE_ZS; i++)
    printf(",z_%g", aspi_ensemble_z(i));
  putchar('\n');
  counts *each = malloc(PROFILES * sizeof *each);
  if (!each)
    fail("out of memory");
  for (int k = 0; k < ASP_ENSEMBLE_PHIS * ASP_ENSEMBLE_KAPPAS; k++) {
    double phi_r = aspi_ensemble_phi_r[k / ASP_ENSEMBLE_KAPPAS];
    double kappa = aspi_ensemble_kappa(k % ASP_ENSEMBLE_KAPPAS);
#pragma omp parallel for schedule(dynamic)
    for (int r = 0; r < PROFILES; r++) {
      each[r] = (counts){{{0}}, {0}};
      add_profile(phi_r, kappa, SEED + (uint32_t)r, &each[r]);
    }
    print_kappa(phi_r, kappa, each);
    fprintf(stderr, "phi_r %g, kappa %g done\n", phi_r, kappa);
  }
  free(each);
  return 0;
}
