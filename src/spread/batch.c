/* Quantiles of many contacts at once: the straight code of weibull.h, visible.h and profile_table.h
 * in vector loops. What the straight code does not cover is done again, one by one. */
#include "simd.h"
#include "spread/models.h"
#include "spread/profile_table.h"
#include "spread/visible.h"
#include "spread/weibull.h"

/* The laws of n contacts, and of how many and which ones the cut takes more than the last bit. */
typedef struct weibulls {
  double b[ASP_BATCH], k[ASP_BATCH], lambda[ASP_BATCH], lost[ASP_BATCH];
  size_t n_cut, cut[ASP_BATCH]; /* cut: 1 or 0 */
} weibulls;

static inline void find_laws(const double *sigma, const double *alpha1, size_t n, weibulls *w) {
  size_t n_cut = 0;
#pragma omp simd reduction(+ : n_cut)
  for (size_t i = 0; i < n; i++) {
    asp_weibull_law law = asp_weibull_at(sigma[i], alpha1[i]);
    w->b[i] = law.b;
    w->k[i] = law.k;
    w->lambda[i] = law.lambda;
    w->lost[i] = 0;
    w->cut[i] = asp_weibull_uncut(sigma[i], alpha1[i]) ? 0 : 1;
    n_cut += w->cut[i];
  }
  w->n_cut = n_cut;
}

/* What the cut takes, side by side for the contacts where it does. One function a loop: in a chain
 * of them each waits for the one before. */
static inline void find_lost(size_t n, weibulls *w) {
  size_t at[ASP_BATCH], n_cut = w->n_cut;
  double k[ASP_BATCH], x[ASP_BATCH];
  for (size_t i = 0, j = 0; i < n; i++) {
    at[j] = i;
    j += w->cut[i];
  }
  for (size_t j = 0; j < n_cut; j++) {
    size_t i = at[j];
    k[j] = w->k[i];
    x[j] = (ASP_DELTA_MOST - w->b[i]) / w->lambda[i];
  }
#pragma omp simd
  for (size_t j = 0; j < n_cut; j++)
    x[j] = k[j] * log(x[j]);
#pragma omp simd
  for (size_t j = 0; j < n_cut; j++)
    x[j] = exp(x[j]);
#pragma omp simd
  for (size_t j = 0; j < n_cut; j++)
    x[j] = exp(-x[j]);
  for (size_t j = 0; j < n_cut; j++)
    w->lost[at[j]] = x[j];
}

/* Smaller sigmas than ASP_SIGMA_ZERO would overflow alpha1/sigma; there the tilt is 0. */
ASP_EACH_MACHINE
void asp_weibull_quantile_n(const asp_views *views, size_t n, const double *u, double *delta) {
  double x[ASP_BATCH];
  weibulls w;
  find_laws(views->sigma, views->alpha1, n, &w);
  if (w.n_cut > 0)
    find_lost(n, &w);
#pragma omp simd
  for (size_t i = 0; i < n; i++)
    x[i] = asp_minus_log_cut(u[i], w.lost[i]);
#pragma omp simd
  for (size_t i = 0; i < n; i++)
    x[i] = log(x[i]) / w.k[i];
#pragma omp simd
  for (size_t i = 0; i < n; i++) {
    double d = w.b[i] + w.lambda[i] * exp(x[i]);
    d = d < ASP_DELTA_MOST ? d : ASP_DELTA_MOST;
    delta[i] = views->sigma[i] < ASP_SIGMA_ZERO ? 0 : d;
  }
}

static inline bool is_quick(double sigma, double alpha1, double u) {
  return (sigma >= ASP_SIGMA_ZERO) & asp_visible_is_quick(alpha1, u);
}

/* False where there are some that are not quick; their deltas mean nothing. */
ASP_EACH_MACHINE
static bool visible_n(const asp_views *views, size_t n, const double *u, double *delta) {
  const double *slope = views->slope, *sigma = views->sigma, *alpha1 = views->alpha1;
  double t[ASP_BATCH], s[ASP_BATCH], p[ASP_BATCH], cell[ASP_BATCH], most = 0, slow = 0;
#pragma omp simd reduction(+ : slow)
  for (size_t i = 0; i < n; i++) {
    bool quick = is_quick(sigma[i], alpha1[i], u[i]);
    asp_visible_place at = asp_visible_find(asp_turn_by(alpha1[i]), slope[i], u[i]);
    cell[i] = quick ? at.cell : 0;
    t[i] = at.t;
    s[i] = at.s;
    slow += quick ? 0 : 1;
  }
#pragma omp simd reduction(max : most)
  for (size_t i = 0; i < n; i++) {
    p[i] = asp_visible_at(cell[i], t[i], s[i]) * slope[i];
    most = most > fabs(p[i]) ? most : fabs(p[i]);
  }
  if (most <= ASP_TAN_PI_8)
#pragma omp simd
    for (size_t i = 0; i < n; i++)
      delta[i] = p[i] + asp_arc_less(p[i]);
  else
#pragma omp simd
    for (size_t i = 0; i < n; i++)
      delta[i] = asp_angle(p[i], 1);
  return !(slow > 0);
}

void asp_visible_quantile_n(const asp_views *views, size_t n, const double *u, double *delta) {
  if (visible_n(views, n, u, delta))
    return;
  for (size_t i = 0; i < n; i++)
    if (!is_quick(views->sigma[i], views->alpha1[i], u[i]))
      delta[i] = asp_views_quantile_at(&asp_spread_visible, views, i, u[i]);
}

/* The size of each contact among those of the table; false where all are of the first one's. */
static inline bool find_sizes(const asp_profile_table *t, const double *d_p, size_t n, int *step,
                              double *share) {
  size_t others = 0;
#pragma omp simd reduction(+ : others)
  for (size_t i = 0; i < n; i++)
    others += (d_p[i] < d_p[0]) | (d_p[i] > d_p[0]);
  for (size_t i = 0; i < (others > 0 ? n : 1); i++) {
    asp_profile_place place = asp_profile_size(t, d_p[i]);
    step[i] = place.step;
    share[i] = place.share;
  }
  return others > 0;
}

/* `several`: sizes, of which each contact has its own; else the first is everyone's. Returns how
 * many particles fly up, for which another law holds. */
static inline size_t find_tilts(const asp_views *views, size_t n, const double *u, bool several,
                                const int *step, const double *size, double *delta) {
  const asp_profile_table *t = views->data;
  const float *table = t->delta;
  const double *alpha1 = views->alpha1;
  double part[ASP_BATCH], angle[ASP_BATCH];
  int at[ASP_BATCH], next = t->next;
  size_t up = 0;
#pragma omp simd reduction(+ : up)
  for (size_t i = 0; i < n; i++) {
    asp_profile_place along = asp_profile_angle_n(t, alpha1[i] > 0 ? alpha1[i] : 0);
    asp_profile_place node = asp_profile_u(u[i]);
    at[i] = step[several ? i : 0] * ASP_PROFILE_SIZE + node.step * ASP_PROFILE_ANGLES + along.step;
    part[i] = node.share;
    angle[i] = along.share;
    up += alpha1[i] < 0;
  }
#pragma omp simd
  for (size_t i = 0; i < n; i++) {
    double d = asp_profile_delta(table, at[i], next, size[several ? i : 0], part[i], angle[i]);
    delta[i] = d > -alpha1[i] ? d : -alpha1[i];
  }
  return up;
}

ASP_EACH_MACHINE
static size_t profile_n(const asp_views *views, size_t n, const double *u, double *delta) {
  int step[ASP_BATCH];
  double size[ASP_BATCH];
  if (find_sizes(views->data, views->d_p, n, step, size))
    return find_tilts(views, n, u, true, step, size, delta);
  return find_tilts(views, n, u, false, step, size, delta);
}

void asp_profile_quantile_n(const asp_views *views, size_t n, const double *u, double *delta) {
  if (profile_n(views, n, u, delta) == 0)
    return;
  for (size_t i = 0; i < n; i++)
    if (views->alpha1[i] < 0)
      delta[i] = asp_views_quantile_at(&asp_spread_profile, views, i, u[i]);
}
