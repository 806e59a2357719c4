/* The slopes of a Gaussian wall, each weighted by the width that its face shows to a particle at
 * alpha1, which includes shadow and flux. With x = p/s_eff and a = tan(alpha1)/s_eff the density is
 * phi(x) (x + a) / Z over x > -a, Z = phi(a) + a Phi(a): in computer graphics the distribution of
 * visible normals of a Beckmann surface. It neglects the correlation of height and slope at a hit,
 * so that it has too many later hits at grazing incidence (choosing.md). The same distribution
 * serves a particle that flies up after an earlier hit (a < 0).
 *
 * The integral from the end of the support is a series where its closed form would be a difference
 * of nearly equal numbers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/gauss.h"
#include "spread/invert.h"
#include "spread/models.h"

#include <gsl/gsl_cdf.h>

/* Beyond this a the distribution is normal to 1e-10 in u. */
#define A_MOST 1e10

/* Steeper upward flights meet practically nothing; they get the limit, a gamma distribution of
 * a (x + a). */
#define A_LEAST (-1e8)

typedef struct variate {
  double a;
  double z;       /* the norm; over phi(a) where a < 0 */
  double density; /* phi(a) */
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

static variate variate_at(const aspi_view *view) {
  double a = tan(view->alpha1) / view->slope;
  a = fmin(fmax(a, A_LEAST), A_MOST);
  double density = aspi_gauss_density(a);
  double z = a < 0 ? mills_gap(-a) : density + a * aspi_gauss_below(a);
  return (variate){a, z, density};
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

static aspi_point down_at(const void *of, double x) {
  const variate *w = of;
  double a = w->a, y = x + a, phi = aspi_gauss_density(x);
  aspi_point p = {.density = phi * y / w->z};
  p.above = (phi + a * aspi_gauss_below(-x)) / w->z;
  if (y * (1 + a) < 0.5)
    p.below = w->density * near_end(a, y) / w->z;
  else
    p.below = fmax(0, (a * (aspi_gauss_below(x) - aspi_gauss_below(-a)) + w->density - phi) / w->z);
  return p;
}

/* For a < 0, counted from the end of the support: y = x + a. */
static aspi_point up_at(const void *of, double y) {
  const variate *w = of;
  double t = -w->a, x = y + t, decay = exp(-y * (t + 0.5 * y));
  aspi_point p = {.density = decay * y / w->z};
  p.above = decay * (y + t * mills_gap(x)) / x / w->z;
  p.below = y * (1 + t) < 0.5 ? near_end(w->a, y) / w->z : 1 - p.above;
  return p;
}

static aspi_point at(const variate *w, double x) {
  return w->a < 0 ? up_at(w, x + w->a) : down_at(w, x);
}

/* The start is exact at the end of the support, and far from it for a large a. */
static double down_quantile(const variate *w, double u) {
  double far = gsl_cdf_ugaussian_Pinv(u), most = sqrt(-2 * log1p(-u)) + 1;
  double end = w->density > 1e-300 ? sqrt(2 * u * w->z / w->density) : INFINITY;
  return aspi_invert(down_at, w, -w->a, most, fmax(far, fmin(end, 1) - w->a), u);
}

/* The start lies between the distributions for a = 0 (Rayleigh) and large negative a (gamma). */
static double up_quantile(const variate *w, double u) {
  double r2 = -2 * log1p(-u), t = -w->a, length = 1 / (sqrt(t * t + r2) + t);
  return t + aspi_invert(up_at, w, 0, (r2 + 16) * length, r2 * length * (1 + t / (1 + t)), u);
}

static double density(const aspi_view *view, double delta) {
  variate w = variate_at(view);
  double p = tan(delta), y = p / view->slope + w.a;
  if (!(y > 0) || delta >= ASP_DELTA_MOST)
    return 0;
  return at(&w, p / view->slope).density * (1 + p * p) / view->slope;
}

static double distribution(const aspi_view *view, double delta) {
  variate w = variate_at(view);
  double x = tan(delta) / view->slope;
  if (delta <= -ASP_DELTA_MOST || !(x > -w.a))
    return 0;
  return delta >= ASP_DELTA_MOST ? 1 : at(&w, x).below;
}

static double quantile(const aspi_view *view, double u) {
  if (view->sigma < ASP_SIGMA_ZERO)
    return 0;
  variate w = variate_at(view);
  double x = w.a < 0 ? up_quantile(&w, u) : down_quantile(&w, u);
  return fmax(atan(x * view->slope), -view->alpha1);
}

const asp_spread_model aspi_spread_visible = {
    .name = "visible",
    .summary = "slopes of a Gaussian wall as the particle sees them: with shadow and flux",
    .source =
        "derived for this project; Heitz & d'Eon 2014 (visible normals), the same distribution",
    .cost = 6,
    .upward = true,
    .density = density,
    .distribution = distribution,
    .quantile = quantile,
};
