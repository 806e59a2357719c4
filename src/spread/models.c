/* The list of spread models, and what every model has in common.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "spread/models.h"

#include <math.h>

#define ASP_SPREAD_ADDRESS(name) &aspi_spread_##name,
static const asp_spread_model *const models[] = {ASP_SPREAD_MODELS(ASP_SPREAD_ADDRESS)};
#undef ASP_SPREAD_ADDRESS

int asp_spread_count(void) {
  return (int)(sizeof models / sizeof *models);
}

const asp_spread_model *asp_spread_at(int index) {
  return index >= 0 && index < asp_spread_count() ? models[index] : NULL;
}

const asp_spread_model *asp_spread_find(const char *name, asp_error *error) {
  int index = aspi_find_name("spread model", name, asp_spread_count(), models, error);
  return index < 0 ? NULL : models[index];
}

const char *asp_spread_name(const asp_spread_model *model) {
  return model->name;
}

aspi_spread_input aspi_spread_input_of(double sigma, double alpha1) {
  return (aspi_spread_input){
      .slope = tan(sigma), .sigma = sigma, .alpha1 = alpha1, .phi_r = tan(sigma) / sqrt(2)};
}

bool aspi_spread_draw(const asp_spread_model *model, const aspi_spread_input *input,
                      aspi_stream *stream, double *delta) {
  aspi_path path = {0};
  if (!model->quantile)
    return model->follow(input, stream, &path, delta);
  *delta = model->quantile(input, aspi_stream_uniform(stream));
  return true;
}
