/* The cheapest model that is good enough, by the cost in the models' records. The divergence of
 * each model's rebounds from the geometry was measured on a grid of walls and angles, in the plane
 * of incidence, against ensembles of profiles that made none of the models (measured.csv, made by
 * tests/sweep/grid.c); that of isotropic tilts is larger. A wall gets the worst of all grid points
 * around it, each with twice its standard error.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "spread/models.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "measured.inc"

enum { ROWS = sizeof rows / sizeof *rows };

/* Standard errors added to a measured divergence. */
#define ERRORS 2

/* An interval with the grid points around it. */
typedef struct span {
  double least, most;
} span;

static double phi_r_of(int i) {
  return rows[i].phi_r;
}

static double kappa_of(int i) {
  return rows[i].kappa;
}

/* A side of the span without grid points is infinite. */
static span widen(double least, double most, int n, double (*value)(int)) {
  span wide = {-INFINITY, INFINITY};
  for (int i = 0; i < n; i++) {
    double v = value(i);
    if (v <= least)
      wide.least = fmax(wide.least, v);
    if (v >= most)
      wide.most = fmin(wide.most, v);
  }
  return wide;
}

static bool within(span s, double value) {
  return value >= s.least && value <= s.most;
}

/* The worst divergence of a model over grid points. */
typedef struct result {
  double worst;
  int points;
} result;

typedef struct query {
  span phi_r, kappa;
  int multiple;
} query;

static result evaluate(const query *q, const char *model) {
  result v = {0, 0};
  for (int i = 0; i < ROWS; i++) {
    const row *r = &rows[i];
    if (r->multiple != q->multiple || !within(q->phi_r, r->phi_r) || !within(q->kappa, r->kappa) ||
        strcmp(r->model, model) != 0)
      continue;
    v.points++;
    for (int k = 0; k < ANGLES; k++)
      v.worst = fmax(v.worst, r->kl[k][0] + ERRORS * r->kl[k][1]);
  }
  return v;
}

/* The wall in the numbers that messages name. */
typedef struct wall {
  double phi_r, kappa[2]; /* least and most */
} wall;

static query query_of(const wall *w, bool multiple) {
  return (query){widen(w->phi_r, w->phi_r, ROWS, phi_r_of),
                 widen(w->kappa[0], w->kappa[1], ROWS, kappa_of), multiple};
}

static const asp_spread_model *choose(const wall *w, const query *q, double tolerance,
                                      double *divergence, asp_error *error) {
  double closest = INFINITY;
  const asp_spread_model *chosen = NULL, *nearest = NULL;
  for (int i = 0; i < asp_spread_count(); i++) {
    const asp_spread_model *model = asp_spread_at(i);
    result v = evaluate(q, model->name);
    if (v.points == 0)
      continue;
    if (v.worst < tolerance && (!chosen || model->cost < chosen->cost))
      *divergence = v.worst, chosen = model;
    if (v.worst < closest)
      closest = v.worst, nearest = model;
  }
  if (!nearest || isinf(q->phi_r.most) || isinf(q->kappa.most)) {
    aspi_fail(error, ASP_ERANGE,
              "phi_r %g with kappa %g to %g is beyond what was measured; name a model instead",
              w->phi_r, w->kappa[0], w->kappa[1]);
    return NULL;
  }
  if (!chosen)
    aspi_fail(error, ASP_ERANGE,
              "tolerance is %g; no model is measured to stay below it on this wall, '%s' comes "
              "closest with %.2g",
              tolerance, nearest->name, closest);
  return chosen;
}

const asp_spread_model *aspi_spread_auto(const asp_surface *surface, double d_least, double d_most,
                                         bool multiple, double tolerance, double *divergence,
                                         char *text, size_t size, asp_error *error) {
  if (aspi_check_positive(error, "tolerance", "", tolerance) ||
      aspi_check_length(error, "least d_p", d_least) ||
      aspi_check_length(error, "largest d_p", d_most) ||
      aspi_check_range(error, "largest d_p", "", d_most, d_least, INFINITY))
    return NULL;
  wall w = {asp_surface_phi_r(surface),
            {asp_surface_kappa(surface, d_least), asp_surface_kappa(surface, d_most)}};
  query q = query_of(&w, multiple);
  const asp_spread_model *chosen = choose(&w, &q, tolerance, divergence, error);
  if (chosen && text)
    snprintf(
        text, size,
        "spread auto takes '%s': the cheapest model whose rebounds stay below D_KL %g for "
        "phi_r %.3g, kappa %.3g to %.3g; measured in the plane of incidence: %.2g at worst, with "
        "twice its standard error; `asperity trade --three-d` measures isotropic tilts",
        chosen->name, tolerance, w.phi_r, w.kappa[0], w.kappa[1], *divergence);
  return chosen;
}
