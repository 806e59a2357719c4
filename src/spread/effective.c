/* The effective distribution (eq. 4): the normal distribution times the flux onto the face,
 * sin(alpha1 + delta)/sin(alpha1), cut at delta = -alpha1, where it would turn negative. It extends
 * below -alpha1/2, where a specular rebound goes into the wall: the contact draws again, or the
 * particle hits once more.
 *
 * In x = delta/sigma, the integral of phi(t) sin(alpha1 + sigma t) over a tail is a series in the
 * tail's moments, fast and without cancellation for every sigma. For a particle that flies up
 * (alpha1 < 0) the whole support is far tail. There, and close to the end of the support, a
 * quadrature with scaled weights is used.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/gauss.h"
#include "spread/invert.h"
#include "spread/models.h"

#include <gsl/gsl_integration.h>

enum { TERMS = 60 };

/* The normal density underflows from here on. */
#define FAR 38.6

/* Closer than this share of the support to its end, the difference of tails loses digits. */
#define NEAR_END 0.05

typedef struct variate {
  double alpha, sigma;
  double lo, hi; /* support in x */
  double mass;   /* before normalization; for alpha < 0 over phi(lo) */
} variate;

/* The integral of phi(t) sin(alpha + sigma t) from x >= 0 to infinity: the Taylor series of the
 * sine, term by term, with J_k the integral of t^k phi(t), J_k = x^(k-1) phi(x) + (k-1) J_(k-2). */
static double tail(double alpha, double sigma, double x) {
  if (x > FAR)
    return 0;
  double phi = aspi_gauss_density(x), even = aspi_gauss_below(-x), odd = phi;
  double s = sin(alpha), c = cos(alpha), sum = s * even, factor = 1, power = 1;
  for (int k = 1; k < TERMS; k++) {
    double j = k % 2 ? odd : even;
    if (k > 1) {
      power *= x;
      j = power * phi + (k - 1) * j;
    }
    *(k % 2 ? &odd : &even) = j;
    factor *= sigma / k;
    double term = factor * j * (k % 2 ? c : s);
    sum += k % 4 < 2 ? term : -term;
    if (fabs(factor * j) < 1e-18 * fabs(sum) && k > 2)
      break;
  }
  return sum;
}

/* The integral between two points: a difference of tails on one side of the middle, and otherwise
 * the whole, exp(-sigma^2/2) sin(alpha), less both tails. */
static double between(const variate *w, double from, double to) {
  if (from >= 0)
    return tail(w->alpha, w->sigma, from) - tail(w->alpha, w->sigma, to);
  if (to <= 0)
    return tail(w->alpha, -w->sigma, -to) - tail(w->alpha, -w->sigma, -from);
  return exp(-0.5 * w->sigma * w->sigma) * sin(w->alpha) - tail(w->alpha, w->sigma, to) -
         tail(w->alpha, -w->sigma, -from);
}

static double integrand(double t, void *of) {
  const variate *w = of;
  double y = t - w->lo;
  return exp(-y * (w->lo + 0.5 * y)) * sin(w->sigma * y);
}

/* The integral of the density over phi(lo) between two points. */
static double quadrature(const variate *w, double from, double to) {
  variate copy = *w;
  gsl_function f = {integrand, &copy};
  double result, error, absolute, deviation;
  gsl_integration_qk41(&f, from, to, &result, &error, &absolute, &deviation);
  return result;
}

static variate variate_at(const aspi_spread_input *input) {
  double sigma = input->sigma, lo = -input->alpha1 / sigma, hi = ASP_DELTA_MOST / sigma;
  variate w = {input->alpha1, sigma, lo, hi, 0};
  if (input->alpha1 < 0) {
    w.hi = fmin(hi, lo + 76 / (sqrt(lo * lo + 76) + lo));
    w.mass = quadrature(&w, lo, w.hi);
  } else {
    w.mass = between(&w, lo, hi);
  }
  return w;
}

static aspi_node at(const void *of, double x, bool upper) {
  const variate *w = of;
  double y = x - w->lo, angle = w->sigma * y, sine = sin(angle), turn = w->sigma / sine,
         cosine = cos(angle);
  aspi_node p = {
      .log_rise = {turn * cosine - x, -1 - turn * turn, 2 * turn * turn * turn * cosine}};
  if (w->alpha < 0) {
    p.share = upper ? quadrature(w, x, w->hi) : quadrature(w, w->lo, x);
    p.density = exp(-y * (w->lo + 0.5 * y)) * sine;
  } else {
    bool near = y * (1 - w->lo) < NEAR_END, above = !near && x >= 0;
    p.share = near    ? aspi_gauss_density(w->lo) * quadrature(w, w->lo, x)
              : above ? between(w, x, w->hi)
                      : between(w, w->lo, x);
    if (above != upper)
      p.share = w->mass - p.share;
    p.density = aspi_gauss_density(x) * sine;
  }
  p.share /= w->mass;
  p.density /= w->mass;
  return p;
}

static double density(const aspi_spread_input *input, double delta) {
  variate w = variate_at(input);
  double x = delta / w.sigma;
  return x > w.lo && x < w.hi ? at(&w, x, false).density / w.sigma : 0;
}

static double distribution(const aspi_spread_input *input, double delta) {
  variate w = variate_at(input);
  double x = delta / w.sigma;
  if (!(x > w.lo))
    return 0;
  return x < w.hi ? at(&w, x, false).share : 1;
}

/* Starts from the quantile of `visible`, which is the limit for small sigma. */
static double quantile(const aspi_spread_input *input, double u) {
  if (input->sigma < ASP_SIGMA_ZERO)
    return 0;
  variate w = variate_at(input);
  double guess = aspi_spread_visible.quantile(input, u) / w.sigma;
  double x = aspi_invert(at, &w, fmax(w.lo, -FAR), fmin(w.hi, fmax(w.lo, 0) + FAR), guess, u);
  return fmin(fmax(x * w.sigma, -input->alpha1), ASP_DELTA_MOST);
}

const asp_spread_model aspi_spread_effective = {
    .name = "effective",
    .summary = "normal distribution, weighted by the width that a face shows to the particle",
    .source = "Sommerfeld & Huber 1999; Altmeppen et al. 2020, eq. 4",
    .covers_rising = true,
    .density = density,
    .distribution = distribution,
    .quantile = quantile,
};
