/* The list of spread models, and what every model has in common. */
#include "error.h"
#include "spread/draw.h"
#include "spread/models.h"

#include <math.h>
#include <string.h>

#define ASP_SPREAD_ADDRESS(name) &asp_spread_##name,
static const asp_spread_model *const models[] = {ASP_SPREAD_MODELS(ASP_SPREAD_ADDRESS)};
#undef ASP_SPREAD_ADDRESS

int asp_spread_count(void) {
  return (int)(sizeof models / sizeof *models);
}

const asp_spread_model *asp_spread_at(int index) {
  return models[index];
}

static const char *name_at(int index) {
  return models[index]->name;
}

const asp_spread_model *asp_spread_find(const char *name, asp_error *error) {
  for (int i = 0; name && i < asp_spread_count(); i++)
    if (strcmp(models[i]->name, name) == 0)
      return models[i];
  asp_fail_name(error, "spread model", name, asp_spread_count(), name_at);
  return NULL;
}

asp_view asp_view_create(double sigma, double alpha1) {
  return (asp_view){tan(sigma), sigma, alpha1, 0, NULL};
}

bool asp_spread_draw(const asp_spread_model *model, const asp_view *view, asp_stream *stream,
                     double *delta) {
  return asp_draw(model, view, stream, delta);
}

static void fill(double *array, size_t n, double value) {
  for (size_t i = 0; i < n; i++)
    array[i] = value;
}

void asp_spread_quantile_n(const asp_spread_model *model, const asp_view *view, size_t n,
                           const double *alpha1, const double *u, double *delta) {
  double slope[ASP_BATCH], sigma[ASP_BATCH], d_p[ASP_BATCH];
  size_t block = n < ASP_BATCH ? n : ASP_BATCH;
  fill(slope, block, view->slope);
  fill(sigma, block, view->sigma);
  fill(d_p, block, view->d_p);
  for (size_t i = 0; i < n; i += ASP_BATCH) {
    asp_views views = {slope, sigma, alpha1 + i, d_p, view->data};
    asp_views_quantile(model, &views, n - i < ASP_BATCH ? n - i : ASP_BATCH, u + i, delta + i);
  }
}

void asp_views_quantile(const asp_spread_model *model, const asp_views *views, size_t n,
                        const double *u, double *delta) {
  if (model->quantile_n) {
    model->quantile_n(views, n, u, delta);
    return;
  }
  for (size_t i = 0; i < n; i++)
    delta[i] = asp_views_quantile_at(model, views, i, u[i]);
}
