/* The slopes of a Gaussian wall, each weighted by the width that its face shows to a particle at
 * alpha1, which includes shadow and flux. With x = p/s_eff and a = tan(alpha1)/s_eff the density is
 * phi(x) (x + a) / Z over x > -a, Z = phi(a) + a Phi(a): in computer graphics the distribution of
 * visible normals of a Beckmann surface. It neglects the correlation of height and slope at a hit,
 * so that it has too many later hits at grazing incidence (choosing.md). It also serves a
 * particle that flies up after an earlier hit (a < 0).
 *
 * Near the end of the support the distribution is a series: its closed form is a difference of
 * nearly equal numbers there. The quantile is a step of the root search (invert.h) from a table.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/gauss.h"
#include "spread/invert.h"
#include "spread/models.h"
#include "spread/visible_table.inc"

#include <gsl/gsl_cdf.h>

/* Above this no u < 1 has its quantile. */
#define X_MOST 10

/* Beyond this a no face is in the shadow, to 1e-23. */
#define A_FREE 10

/* Beyond this a the distribution is normal to 1e-10 in u. */
#define A_MOST 1e10

/* Steeper upward flights meet practically nothing; they get the limit, a gamma distribution of
 * a (x + a). */
#define A_LEAST (-1e8)

typedef struct variate {
  double a;
  double z;       /* the norm; over phi(a) where a < 0 */
  double density; /* phi(a), where a > 0 */
  double shadow;  /* Phi(-a), too */
} variate;

/* 1 - t M(t) for t > 0, M = Q/phi: the norm for a = -t over phi(t), about 1/t^2 for large t. There
 * by the asymptotic series 1/t^2 - 3/t^4 + 15/t^6 - ... */
static double mills_gap(double t) {
  if (t < 12)
    return 1 - t * aspi_gauss_below(-t) / aspi_gauss_density(t);
  double square = t * t, term = 1 / square, sum = 0;
  for (int k = 3; k < 29; k += 2) {
    sum += term;
    term *= -k / square;
  }
  return sum;
}

static variate variate_at(const aspi_spread_input *input) {
  variate w = {.a = tan(input->alpha1) / input->slope};
  if (w.a < 0) {
    w.a = fmax(w.a, A_LEAST);
    w.z = mills_gap(-w.a);
  } else if (w.a < A_FREE) {
    w.density = aspi_gauss_density(w.a);
    w.shadow = aspi_gauss_below(-w.a);
    w.z = w.density + w.a * (1 - w.shadow);
  } else {
    w.a = w.z = fmin(w.a, A_MOST);
  }
  return w;
}

/* The integral of t exp(a t - t^2/2) from 0 to a small y, by its series. */
static double near_end(double a, double y) {
  double previous = 0, c = 1, power = y * y, sum = 0;
  for (int n = 0; n < 24; n++) {
    sum += c * power / (n + 2);
    double next = (a * c - previous) / (n + 1);
    previous = c;
    c = next;
    power *= y;
  }
  return sum;
}

/* The derivatives of the logarithm of phi(x) y. */
static void set_rise(aspi_node *p, double x, double y) {
  double rise = 1 / y;
  p->log_rise[0] = rise - x;
  p->log_rise[1] = -1 - rise * rise;
  p->log_rise[2] = 2 * rise * rise * rise;
}

static aspi_node down_at(const void *of, double x, bool upper) {
  const variate *w = of;
  double a = w->a, y = x + a, phi = aspi_gauss_density(x), share;
  if (upper)
    share = phi + a * aspi_gauss_below(-x);
  else if (y * (1 + a) < 0.5)
    share = w->density * near_end(a, y);
  else
    share = a * (aspi_gauss_below(x) - w->shadow) + w->density - phi;
  aspi_node p = {.share = share / w->z, .density = phi * y / w->z};
  set_rise(&p, x, y);
  return p;
}

/* For a < 0, counted from the end of the support: y = x + a. */
static aspi_node up_at(const void *of, double y, bool upper) {
  const variate *w = of;
  double t = -w->a, x = y + t, decay = exp(-y * (t + 0.5 * y));
  bool near = y * (1 + t) < 0.5;
  aspi_node p = {.density = decay * y / w->z};
  p.share = (near ? near_end(w->a, y) : decay * (y + t * mills_gap(x)) / x) / w->z;
  if (near == upper)
    p.share = 1 - p.share;
  set_rise(&p, x, y);
  return p;
}

static aspi_node at(const variate *w, double x) {
  return w->a < 0 ? up_at(w, x + w->a, false) : down_at(w, x, false);
}

/* Weights of the cubic through four nodes around a place; returns the first of them. */
static int cubic(double place, int nodes, double weight[4]) {
  int before = (int)place - 1, last = nodes - 4;
  int first = before < 0 ? 0 : before < last ? before : last;
  double a = place - first, b = a - 1, c = a - 2, d = a - 3;
  double ab = a * b, cd = c * d;
  weight[0] = -1. / 6 * (b * cd);
  weight[1] = 0.5 * (a * cd);
  weight[2] = -0.5 * (ab * d);
  weight[3] = 1. / 6 * (ab * c);
  return first;
}

/* The quantile, within a few thousandths. */
static double tabled(double a, double logit) {
  double of_u[4], of_a[4], sum = 0;
  int at_u = cubic(0.5 * (VISIBLE_US - 1) * (1 + logit / VISIBLE_LOGIT_MOST), VISIBLE_US, of_u);
  int at_a = cubic((VISIBLE_AS - 1) * (a / (a + VISIBLE_A_MIDDLE)), VISIBLE_AS, of_a);
  for (int i = 0; i < 4; i++) {
    const double *x = &visible_table[at_a + i][at_u];
    sum += of_a[i] * (of_u[0] * x[0] + of_u[1] * x[1] + of_u[2] * x[2] + of_u[3] * x[3]);
  }
  return sum;
}

/* In the tails the start is exact at the end of the support, and far from it for a large a. */
static double down_quantile(const variate *w, double u) {
  double guess, logit = log(u / (1 - u));
  if (fabs(logit) < VISIBLE_LOGIT_MOST) {
    guess = tabled(w->a, logit);
  } else {
    double end = w->density > 1e-300 ? sqrt(2 * u * w->z / w->density) : INFINITY;
    guess = fmax(gsl_cdf_ugaussian_Pinv(u), fmin(end, 1) - w->a);
  }
  return aspi_invert(down_at, w, -w->a, X_MOST, guess, u);
}

/* The start lies between the distributions for a = 0 (Rayleigh) and large negative a (gamma). */
static double up_quantile(const variate *w, double u) {
  double r2 = -2 * log1p(-u), t = -w->a, length = 1 / (sqrt(t * t + r2) + t);
  return t + aspi_invert(up_at, w, 0, (r2 + 16) * length, r2 * length * (1 + t / (1 + t)), u);
}

static double density(const aspi_spread_input *input, double delta) {
  variate w = variate_at(input);
  double p = tan(delta), y = p / input->slope + w.a;
  if (!(y > 0) || delta >= ASP_DELTA_MOST)
    return 0;
  return at(&w, p / input->slope).density * (1 + p * p) / input->slope;
}

static double distribution(const aspi_spread_input *input, double delta) {
  variate w = variate_at(input);
  double x = tan(delta) / input->slope;
  if (delta <= -ASP_DELTA_MOST || !(x > -w.a))
    return 0;
  return delta >= ASP_DELTA_MOST ? 1 : fmax(0, at(&w, x).share);
}

static double quantile(const aspi_spread_input *input, double u) {
  if (input->sigma < ASP_SIGMA_ZERO)
    return 0;
  variate w = variate_at(input);
  double x = w.a < 0 ? up_quantile(&w, u) : down_quantile(&w, u);
  double delta = atan(x * input->slope);
  return delta > -input->alpha1 ? delta : -input->alpha1;
}

const asp_spread_model aspi_spread_visible = {
    .name = "visible",
    .summary = "slopes of a Gaussian wall as the particle sees them: with shadow and flux",
    .source =
        "derived for this project; Heitz & d'Eon 2014 (visible normals), the same distribution",
    .covers_rising = true,
    .density = density,
    .distribution = distribution,
    .quantile = quantile,
};
