/* Grant & Tabakoff 1975: sand on aluminum 2024, mean coefficients and their standard deviations as
 * polynomials in the impact angle beta (rad) at the face that is hit:
 *
 *   e_n  = 0.993 - 1.76 beta + 1.56 beta^2 - 0.49 beta^3
 *   e_t  = 0.988 - 1.66 beta + 2.11 beta^2 - 0.67 beta^3
 *   sd_n = 2.15 beta - 5.02 beta^2 + 4.05 beta^3 - 1.085 beta^4
 *   sd_t = -0.0005 + 0.62 beta - 0.535 beta^2 + 0.089 beta^3
 *
 * All from one secondary source; a negative sd is taken as 0. The scatter is drawn from a
 * log-normal law with that mean and sd: the source does not say which law it is, and a normal one
 * would throw particles into the wall (e_n < 0). It is the scatter of a real wall, roughness
 * included. The law depends on neither speed nor material, and nothing sticks.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "rebound/laws.h"

#include <math.h>

enum { SCATTER, N_PARAMETERS };

static const aspi_keyword parameters[N_PARAMETERS] = {
    [SCATTER] = {"scatter", "", 0, 0, 1,
                 "share of the measured standard deviation that is drawn: 0 the means, 1 all of it "
                 "(polynomials from one secondary source; log-normal law assumed)"},
};

static double mean_n(double b) {
  return 0.993 + b * (-1.76 + b * (1.56 - b * 0.49));
}

static double mean_t(double b) {
  return 0.988 + b * (-1.66 + b * (2.11 - b * 0.67));
}

static double sd_n(double b) {
  return fmax(0, b * (2.15 + b * (-5.02 + b * (4.05 - b * 1.085))));
}

static double sd_t(double b) {
  return fmax(0, -0.0005 + b * (0.62 + b * (-0.535 + b * 0.089)));
}

/* A log-normal number with that mean (> 0) and sd, from a standard normal one. */
static double log_normal(double mean, double sd, double normal) {
  double ratio = sd / mean, s2 = log1p(ratio * ratio);
  return mean * exp(sqrt(s2) * normal - 0.5 * s2);
}

static aspi_bounce rebound(const double *p, const aspi_hit *hit) {
  double beta = atan2(hit->v_n1, hit->v_t1), e_n = mean_n(beta), e_t = mean_t(beta);
  if (p[SCATTER] > 0) {
    e_n = log_normal(e_n, p[SCATTER] * sd_n(beta), aspi_stream_normal(hit->stream));
    e_t = log_normal(e_t, p[SCATTER] * sd_t(beta), aspi_stream_normal(hit->stream));
  }
  return aspi_bounce_capped(hit, e_n, e_t);
}

static bool scatters(const double *p) {
  return p[SCATTER] > 0;
}

const asp_rebound_law aspi_rebound_grant_tabakoff = {
    .name = "grant_tabakoff",
    .summary = "measured means over impact angle, sand on aluminum 2024, with or without scatter",
    .source = "Grant & Tabakoff 1975 (by one secondary source, original not seen)",
    .measured = true,
    .n_parameters = N_PARAMETERS,
    .parameters = parameters,
    .rebound = rebound,
    .scatters = scatters,
};
