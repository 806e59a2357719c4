/* First hits on a Gaussian wall, the model `profile`: a table over a = tan(alpha1)/s_eff, kappa and
 * phi_r from an ensemble of profiles (tests/tables/make_first_hits.c). Needs no set-up.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "spread/models.h"

#include <math.h>

/* The nodes of the table: a/(1 + a) and log2(1 + 8 kappa) at equal steps, and the share below a
 * slope as Phi(z) with z at equal steps. */
enum {
  ASP_ENSEMBLE_AS = 33,
  ASP_ENSEMBLE_KAPPAS = 15,
  ASP_ENSEMBLE_ZS = 33,
  ASP_ENSEMBLE_PHIS = 4
};

/* Below the first one slopes are small, and the first hits depend on a and kappa only. */
static const double aspi_ensemble_phi_r[ASP_ENSEMBLE_PHIS] = {0.125, 0.35, 0.65, 1};

/* The last node is normal impact. */
static inline double aspi_ensemble_a(int node) {
  double part = node / (ASP_ENSEMBLE_AS - 1.);
  return part < 1 ? part / (1 - part) : 1e6;
}

static inline double aspi_ensemble_kappa(int node) {
  return (exp2(0.5 * node) - 1) / 8;
}

static inline double aspi_ensemble_z(int node) {
  return 0.25 * (node - (ASP_ENSEMBLE_ZS - 1) / 2);
}
