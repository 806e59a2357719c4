/* Rows of slopes, measured on all cores; see slopes.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/slopes.h"

#include <math.h>

double cli_kappa(const cli_slopes *row) {
  return sqrt(3) * row->d_p * row->r_q / (row->lambda_c * row->lambda_c);
}

void cli_slopes_print(FILE *out, const cli_slopes *row) {
  const aspi_slopes *s = &row->slopes;
  fprintf(out, "%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g", row->d_p * 1e6,
          row->r_q * 1e6, row->lambda_c * 1e6, row->r_q / row->lambda_c, cli_kappa(row),
          s->slope_rms, cli_degrees(atan(s->slope_rms)), cli_degrees(s->angle.mean),
          cli_degrees(s->angle.sd), s->angle.kurtosis, s->kl_normal);
}

void cli_slopes_measure(const asp_profile *profile, aspi_contact contact, double r_q,
                        double lambda_c, const cli_list *sizes, cli_progress *progress, double done,
                        cli_slopes *rows) {
  asp_error error = {ASP_OK, ""};
  size_t finished = 0;
#pragma omp parallel for schedule(dynamic)
  for (size_t i = 0; i < sizes->count; i++) {
    asp_error own = {ASP_OK, ""};
    rows[i] = (cli_slopes){.d_p = sizes->values[i], .r_q = r_q, .lambda_c = lambda_c};
    aspi_profile_describe_slopes(profile, rows[i].d_p, contact, &rows[i].slopes, &own);
#pragma omp critical
    {
      if (own.code)
        error = own;
      cli_progress_show(progress, done + (double)++finished);
    }
  }
  if (error.code)
    cli_bad_file(NULL, &error);
}
