/* UNU.RAN's side of bench_spread.c; built where the library is.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "peers.h"

#include <unuran.h>

typedef struct law {
  const asp_spread_model *model;
  aspi_spread_input input;
} law;

static double density(double delta, const UNUR_DISTR *distribution) {
  const law *l = unur_distr_get_extobj(distribution);
  return l->model->density(&l->input, delta);
}

/* The density is asked for during the set-up only. */
bench_pinv *bench_pinv_create(const asp_spread_model *model, const aspi_spread_input *input) {
  law l = {model, *input};
  UNUR_DISTR *distribution = unur_distr_cont_new();
  unur_distr_set_extobj(distribution, &l);
  unur_distr_cont_set_pdf(distribution, density);
  unur_distr_cont_set_domain(distribution, -input->alpha1, ASP_PI / 2);
  unur_distr_cont_set_center(distribution, 0.1 * input->sigma);
  bench_pinv *pinv = unur_init(unur_pinv_new(distribution)); /* frees what pinv_new made */
  unur_distr_free(distribution);
  return pinv;
}

void bench_pinv_free(bench_pinv *pinv) {
  unur_free(pinv);
}

double bench_pinv_quantile(const bench_pinv *pinv, double u) {
  return unur_pinv_eval_approxinvcdf(pinv, u);
}
