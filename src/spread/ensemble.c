/* First hits on a Gaussian wall, from the table of an ensemble (first_hits.csv, made by
 * tests/tables/make_first_hits.c): x = slope/s_eff where the share below is Phi(z), over z, a =
 * tan(alpha1)/s_eff, kappa and phi_r. Interpolation is by a cubic through four nodes in z (Catmull
 * & Rom 1974), which is monotone here, and linear in a/(1 + a), log2(1 + 8 kappa) and phi_r. Below
 * the first node x + a falls exponentially with z; above the last one x is linear in z, as for a
 * normal distribution. Particles that fly up follow `visible`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/ensemble.h"
#include "spread/gauss.h"

#include <gsl/gsl_cdf.h>

#include "first_hits.inc"

_Static_assert(sizeof slope / sizeof *slope ==
                   ASP_ENSEMBLE_PHIS * ASP_ENSEMBLE_KAPPAS * ASP_ENSEMBLE_AS * ASP_ENSEMBLE_ZS,
               "first_hits.csv does not have the nodes of ensemble.h");

/* Larger a are normal impact. */
#define A_MOST 1e6

/* Quantiles of one input: a weighted mean over the nodes around it in a, kappa and phi_r. */
typedef struct variate {
  int corners; /* 4 where phi_r is that of a node, else 8 */
  const float *corner[8];
  double weight[8], a;
} variate;

static double node(const variate *w, int i) {
  double sum = 0;
  for (int k = 0; k < w->corners; k++)
    sum += w->weight[k] * w->corner[k][i];
  return sum;
}

/* The node below a place; the next one is a node, too. */
static int step_of(double at, int nodes) {
  return (int)fmin(at, nodes - 2);
}

/* The node below a phi_r, and the part of the step to the next; clamped at the ends. */
static int phi_below(double phi_r, double *part) {
  const double *nodes = aspi_ensemble_phi_r;
  int last = ASP_ENSEMBLE_PHIS - 1, i = 0;
  while (i < last && phi_r >= nodes[i + 1])
    i++;
  *part = i < last ? fmax(0, (phi_r - nodes[i]) / (nodes[i + 1] - nodes[i])) : 0;
  return i;
}

static variate variate_at(const aspi_spread_input *input) {
  variate w = {.a = fmin(tan(input->alpha1) / input->slope, A_MOST)};
  double at_a = (ASP_ENSEMBLE_AS - 1) * (w.a / (1 + w.a));
  double at_kappa = fmin(2 * log2(1 + 8 * input->kappa), ASP_ENSEMBLE_KAPPAS - 1);
  int a = step_of(at_a, ASP_ENSEMBLE_AS), kappa = step_of(at_kappa, ASP_ENSEMBLE_KAPPAS);
  double part_a = at_a - a, part_kappa = at_kappa - kappa, part_phi;
  int phi = phi_below(input->phi_r, &part_phi);
  w.corners = part_phi > 0 ? 8 : 4;
  for (int k = 0; k < w.corners; k++) {
    int row = (phi + k / 4) * ASP_ENSEMBLE_KAPPAS + kappa + k / 2 % 2;
    w.corner[k] = slope + (row * ASP_ENSEMBLE_AS + a + k % 2) * ASP_ENSEMBLE_ZS;
    w.weight[k] = (k / 4 ? part_phi : 1 - part_phi) * (k / 2 % 2 ? part_kappa : 1 - part_kappa) *
                  (k % 2 ? part_a : 1 - part_a);
  }
  return w;
}

/* A cubic piece from y[1] to y[2], with the tangents of its neighbors' chords; *rise: per z. */
static double cubic(const double y[4], double part, double *rise) {
  double b = 0.5 * (y[2] - y[0]), end = 0.5 * (y[3] - y[1]), chord = y[2] - y[1];
  double c = 3 * chord - 2 * b - end, d = b + end - 2 * chord;
  *rise = (b + part * (2 * c + part * 3 * d)) * 4;
  return y[1] + part * (b + part * (c + part * d));
}

/* x at z, and dx/dz. */
static double slope_at(const variate *w, double z, double *rise) {
  enum { LAST = ASP_ENSEMBLE_ZS - 1 };
  double at = 4 * z + LAST / 2;
  if (at < 0) {
    double first = node(w, 0), above = first + w->a;
    double slant = (node(w, 1) - first) * 4 / above, fall = expm1(slant * (z - aspi_ensemble_z(0)));
    *rise = slant * above * (1 + fall);
    return first + above * fall;
  }
  if (at >= LAST) {
    double last = node(w, LAST);
    *rise = (last - node(w, LAST - 1)) * 4;
    return last + *rise * (z - aspi_ensemble_z(LAST));
  }
  int i = (int)at;
  double y[4];
  for (int k = 0; k < 4; k++)
    y[k] = i + k > 0 && i + k <= LAST + 1 ? node(w, i + k - 1) : 0;
  if (i == 0)
    y[0] = 2 * y[1] - y[2];
  if (i == LAST - 1)
    y[3] = 2 * y[2] - y[1];
  return cubic(y, at - i, rise);
}

static double quantile(const aspi_spread_input *input, double u) {
  if (input->alpha1 < 0)
    return aspi_spread_visible.quantile(input, u);
  if (input->sigma < ASP_SIGMA_ZERO)
    return 0;
  variate w = variate_at(input);
  double rise, x = slope_at(&w, gsl_cdf_ugaussian_Pinv(u), &rise);
  return fmax(atan(x * input->slope), -input->alpha1);
}

/* The z at which the quantile is x. */
static double z_of(const variate *w, double x) {
  double low = -40, high = 40, rise;
  for (int i = 0; i < 60; i++) {
    double middle = 0.5 * (low + high);
    *(slope_at(w, middle, &rise) < x ? &low : &high) = middle;
  }
  return 0.5 * (low + high);
}

static double distribution(const aspi_spread_input *input, double delta) {
  if (input->alpha1 < 0)
    return aspi_spread_visible.distribution(input, delta);
  if (delta <= -input->alpha1 || delta <= -ASP_DELTA_MOST)
    return 0;
  if (delta >= ASP_DELTA_MOST)
    return 1;
  variate w = variate_at(input);
  return aspi_gauss_below(z_of(&w, tan(delta) / input->slope));
}

static double density(const aspi_spread_input *input, double delta) {
  if (input->alpha1 < 0)
    return aspi_spread_visible.density(input, delta);
  if (delta <= -input->alpha1 || fabs(delta) >= ASP_DELTA_MOST)
    return 0;
  variate w = variate_at(input);
  double p = tan(delta), rise, z = z_of(&w, p / input->slope);
  slope_at(&w, z, &rise);
  return rise > 0 ? aspi_gauss_density(z) / rise * (1 + p * p) / input->slope : 0;
}

const asp_spread_model aspi_spread_profile = {
    .name = "profile",
    .summary = "first hits from a table of generated Gaussian walls",
    .source = "geometry, derived for this project",
    .geometry = true,
    .covers_rising = true,
    .density = density,
    .distribution = distribution,
    .quantile = quantile,
};
