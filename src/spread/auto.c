/* The cheapest model that is good enough, in the fixed order of the models' records. How far each
 * model's rebounds are from the geometry was measured on a grid of walls and angles (measured.csv,
 * made by `asperity trade --grid`); a wall takes the worst of all grid points around it. */
#include "base/error.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { ANGLES_MAX = 16 };

typedef struct row {
  const char *model;
  int multiple;
  double phi_r, kappa;
  float kl[ANGLES_MAX]; /* D_KL of the rebound angle, by impact angle */
} row;

#include "measured.inc"

enum { ROWS = sizeof rows / sizeof *rows, ANGLES = sizeof angle / sizeof *angle };

/* Divergences below this are noise of the measurement. */
#define NOISE 2e-4

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

static double angle_of(int i) {
  return angle[i];
}

/* Where the grid has nothing on one side, that side of the span is infinite. */
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

/* What the grid says about one model on a wall. */
typedef struct result {
  double worst;
  int points;
} result;

typedef struct query {
  span phi_r, kappa, angle;
  int multiple;
} query;

static result evaluate(const query *q, const char *model) {
  result v = {NOISE, 0};
  for (int i = 0; i < ROWS; i++) {
    const row *r = &rows[i];
    if (r->multiple != q->multiple || !within(q->phi_r, r->phi_r) || !within(q->kappa, r->kappa) ||
        strcmp(r->model, model) != 0)
      continue;
    v.points++;
    for (int k = 0; k < ANGLES; k++)
      if (within(q->angle, angle[k]))
        v.worst = fmax(v.worst, r->kl[k]);
  }
  return v;
}

static asp_code check(const asp_sizes *sizes, double alpha_least, double alpha_most,
                      double tolerance, asp_error *error) {
  asp_code code;
  if ((code = asp_check_positive(error, "tolerance", "", tolerance)) ||
      (code = asp_check_length(error, "least d_p", sizes->least)) ||
      (code = asp_check_length(error, "largest d_p", sizes->most)) ||
      (code = asp_check_range(error, "largest d_p", "", sizes->most, sizes->least, INFINITY)) ||
      (code = asp_check_range(error, "least alpha1", "rad", alpha_least, 0, ASP_PI / 2)))
    return code;
  return asp_check_range(error, "largest alpha1", "rad", alpha_most, alpha_least, ASP_PI / 2);
}

/* The same in the numbers that messages name. */
typedef struct wall {
  double phi_r, kappa[2], angle[2]; /* least and most; degrees */
} wall;

static query query_of(const wall *w, asp_collisions collisions) {
  return (query){
      widen(w->phi_r, w->phi_r, ROWS, phi_r_of), widen(w->kappa[0], w->kappa[1], ROWS, kappa_of),
      widen(w->angle[0], w->angle[1], ANGLES, angle_of), collisions != ASP_COLLISIONS_SINGLE};
}

static asp_code choose(const wall *w, const query *q, double tolerance, asp_choice *choice,
                       asp_error *error) {
  result best = {INFINITY, 0}, closest = best;
  const asp_spread_model *chosen = NULL, *nearest = NULL;
  for (int i = 0; i < asp_spread_count(); i++) {
    const asp_spread_model *model = asp_spread_at(i);
    result v = evaluate(q, model->name);
    if (v.points == 0)
      continue;
    if (v.worst < tolerance && (!chosen || model->cost < chosen->cost))
      best = v, chosen = model;
    if (v.worst < closest.worst)
      closest = v, nearest = model;
  }
  if (!nearest || isinf(q->phi_r.most) || isinf(q->kappa.most))
    return asp_fail(error, ASP_ERANGE,
                    "spread auto: phi_r %g with kappa %g to %g is beyond what was measured; name "
                    "a model instead",
                    w->phi_r, w->kappa[0], w->kappa[1]);
  if (!chosen)
    return asp_fail(error, ASP_ERANGE,
                    "tolerance is %g; no model is measured to stay below it on this wall, '%s' "
                    "comes closest with %.2g",
                    tolerance, nearest->name, closest.worst);
  *choice = (asp_choice){.model = chosen, .divergence = best.worst};
  snprintf(choice->text, sizeof choice->text,
           "spread auto takes '%s': the cheapest model whose rebounds stay below D_KL %g "
           "for phi_r %.3g, kappa %.3g to %.3g, alpha1 %.3g to %.3g degrees; measured: %.2g at "
           "worst",
           chosen->name, tolerance, w->phi_r, w->kappa[0], w->kappa[1], w->angle[0], w->angle[1],
           best.worst);
  return ASP_OK;
}

asp_code asp_spread_auto(const asp_surface *surface, const asp_sizes *sizes, double alpha_least,
                         double alpha_most, asp_collisions collisions, double tolerance,
                         asp_choice *choice, asp_error *error) {
  asp_code code = check(sizes, alpha_least, alpha_most, tolerance, error);
  if (code)
    return code;
  wall w = {asp_surface_phi_r(surface),
            {asp_surface_kappa(surface, sizes->least), asp_surface_kappa(surface, sizes->most)},
            {alpha_least * 180 / ASP_PI, alpha_most * 180 / ASP_PI}};
  query q = query_of(&w, collisions);
  return choose(&w, &q, tolerance, choice, error);
}
