/* Equilibrium: elastic particles that reach a rough wall in all directions alike leave it in all
 * directions alike. That holds for any real wall, because elastic reflection can be reversed. A
 * spread model without this property heats one direction of a granular gas and cools another.
 * equilibrium [long]
 *
 * In space, sin^2 of the impact angle is uniform over 0 ... 1, and that of the rebound must be; in
 * the plane (dimension 2), the cosine is uniform over -1 ... 1, and must be. Printed is the largest
 * distance of the distribution that comes out from the uniform one (Kolmogorov's), of which
 * sampling alone makes up to 0.87/sqrt(impacts). The short run checks the models that have the
 * property, and that the paper's choice does not; the long one prints the table of README.md.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "asperity_internal.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Diameter of a particle that meets every slope, over lambda_c. */
#define SMALL 1e-3

static int in_order(const void *a, const void *b) {
  double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

/* Kolmogorov's distance from the uniform distribution over 0 ... 1. */
static double distance(double *x, size_t n) {
  double worst = 0;
  qsort(x, n, sizeof *x, in_order);
  for (size_t i = 0; i < n; i++)
    worst = fmax(worst, fmax(x[i] - (double)i / (double)n, (double)(i + 1) / (double)n - x[i]));
  return worst;
}

/* What is uniform over 0 ... 1 for the real wall, of n rebounds by a spread model, as "visible
 * isotropic collisions multiple", on a Gaussian wall whose rms slope has this angle in degrees, in
 * space or in the plane. */
static double *rebounds(const char *spread, bool plane, double sigma, double d_p, size_t n) {
  char text[200];
  asp_error error;
  double lambda_c = 1, r_q = tan(sigma * ASP_PI / 180) * lambda_c / sqrt(2);
  snprintf(text, sizeof text, "surface rq %.12g lambda_c %g spread %s rebound constant 1 1 %s", r_q,
           lambda_c, spread, "deposit off");
  asp_wall *wall = asp_wall_from_text(text, d_p, d_p, &error);
  if (!wall) {
    fprintf(stderr, "%s: %s\n", text, error.text);
    exit(1);
  }
  double *out = malloc(n * sizeof *out), normal[3] = {0, 0, 1};
  asp_particle particle = {.d_p = d_p, .density = 1};
  for (size_t i = 0; i < n; i++) {
    /* One number per stratum: the angles that come in add no noise. */
    double u = ((double)i + 0.5) / (double)n;
    double along = plane ? 2 * u - 1 : sqrt(1 - u);
    double v1[3] = {along, 0, -sqrt(1 - along * along)};
    asp_impact impact;
    asp_wall_impact(wall, &particle, v1, normal, &(asp_key){1, 1, i + 1, 1, 0}, &impact);
    const double *v2 = impact.v2;
    out[i] = plane ? 0.5 * (1 + v2[0]) : v2[2] * v2[2];
  }
  asp_wall_free(wall);
  return out;
}

static double deviation(const char *spread, bool plane, double sigma, size_t n) {
  double *out = rebounds(spread, plane, sigma, SMALL, n), worst = distance(out, n);
  free(out);
  return worst;
}

/* How many rebounds have sin^2 of the angle below 0.001, over the cosine law. */
static double grazing(const double *out, size_t n) {
  double count = 0;
  for (size_t i = 0; i < n; i++)
    count += out[i] < 0.001;
  return count / (0.001 * (double)n);
}

static const char *const models[] = {"normal",    "rejection", "truncated", "weibull",
                                     "effective", "visible",   "profile",   "traced"};
static const struct {
  const char *words;
  bool plane;
} forms[] = {{"isotropic collisions multiple", false}, {"isotropic collisions single", false},
             {"plane collisions multiple", false},     {"plane collisions single", false},
             {"plane collisions multiple", true},      {"plane collisions single", true}};

static void print_table(void) {
  enum { IMPACTS = 1000000 };
  printf("%-46s %8s %8s\n", "", "10 deg", "20 deg");
  for (size_t m = 0; m < sizeof models / sizeof *models; m++)
    for (size_t f = 0; f < sizeof forms / sizeof *forms; f++) {
      char spread[80];
      snprintf(spread, sizeof spread, "%s %s", models[m], forms[f].words);
      printf("%-46s %8.4f", spread, deviation(spread, forms[f].plane, 10, IMPACTS));
      printf(" %8.4f  in %s\n", deviation(spread, forms[f].plane, 20, IMPACTS),
             forms[f].plane ? "the plane" : "space");
      fflush(stdout);
    }
}

/* Particles that are large against the wall's features, on a wall with R_q/lambda_c phi_r. */
static void print_large(void) {
  enum { IMPACTS = 1000000 };
  static const struct {
    double phi_r, d_p;
  } walls[] = {{0.5, SMALL}, {0.25, 0.462}, {0.5, 0.231}, {0.25, 2.31}};
  puts("traced isotropic: phi_r, kappa, off the cosine law, grazing over the cosine law");
  for (size_t k = 0; k < sizeof walls / sizeof *walls; k++) {
    double phi_r = walls[k].phi_r, sigma = atan(sqrt(2) * phi_r) * 180 / ASP_PI;
    double *out = rebounds("traced isotropic", false, sigma, walls[k].d_p, IMPACTS);
    printf("%g %.2f %.4f", phi_r, sqrt(3) * walls[k].d_p * phi_r, distance(out, IMPACTS));
    printf(" %.2f\n", grazing(out, IMPACTS));
    free(out);
  }
}

static int failures;

static void check(const char *what, double sigma, double found, double least, double most) {
  bool good = found >= least && found <= most;
  printf("%s%s at %g degrees: %.4f, expected %g to %g\n", good ? "" : "FAILED: ", what, sigma,
         found, least, most);
  failures += !good;
}

static void expect(const char *spread, bool plane, double sigma, double least, double most) {
  check(spread, sigma, deviation(spread, plane, sigma, 100000), least, most);
}

int main(int argc, char **argv) {
  if (argc > 1 && strcmp(argv[1], "long") == 0) {
    print_table();
    print_large();
    return 0;
  }
  expect("visible isotropic collisions multiple", false, 10, 0, 0.006);
  expect("visible isotropic collisions multiple", false, 20, 0, 0.006);
  expect("profile isotropic collisions multiple", false, 20, 0, 0.008);
  expect("traced isotropic", false, 20, 0, 0.008);
  expect("traced isotropic", false, 35.264, 0, 0.008); /* phi_r 0.5 */
  expect("effective isotropic collisions multiple", false, 10, 0, 0.006);
  expect("traced plane collisions multiple", true, 20, 0, 0.006);
  expect("visible plane collisions multiple", true, 20, 0, 0.006);
  expect("profile plane collisions multiple", true, 20, 0, 0.006);
  expect("truncated isotropic collisions multiple", false, 20, 0.07, 0.09);
  expect("weibull plane collisions single", false, 20, 0.05, 0.2);
  enum { IMPACTS = 400000 };
  double *out = rebounds("traced isotropic", false, 35.264, SMALL, IMPACTS);
  check("traced isotropic, grazing", 35.264, grazing(out, IMPACTS), 0.8, 1.25);
  free(out);
  return failures > 0;
}
