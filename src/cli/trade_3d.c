/* asperity trade --three-d: every model, isotropic, against surfaces in three dimensions, none of
 * which made a model.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/trade_3d.h"
#include "cli/measure.h"

#include <math.h>
#include <stdlib.h>

static const double up[3] = {0, 0, 1};

static void add_all(judge_angles *to, const judge_angles *from) {
  for (int i = 0; i < JUDGE_BINS; i++) {
    to->rebound[i] += from->rebound[i];
    to->lateral[i] += from->lateral[i];
    to->tilt[i] += from->tilt[i];
  }
  to->n += from->n;
  to->rebound_sum += from->rebound_sum;
  to->lateral_sum += from->lateral_sum;
  to->lateral_square += from->lateral_square;
  to->later += from->later;
}

static judge_angles rebounds(const asp_wall *wall, double d_p, const double lay[3], double alpha1,
                             size_t n, uint32_t seed) {
  judge_angles all = {0};
  const double v1[3] = {cos(alpha1), 0, -sin(alpha1)};
#pragma omp parallel
  {
    judge_angles mine = {0};
#pragma omp for schedule(static)
    for (size_t i = 0; i < n; i++) {
      asp_particle particle = {.d_p = d_p, .density = 1, .lay = lay};
      asp_impact impact;
      asp_wall_impact(wall, &particle, v1, up, &(asp_key){seed, 1, i, 1}, &impact);
      judge_add(&mine, impact.v2, impact.delta_alpha, impact.hits);
    }
#pragma omp critical
    add_all(&all, &mine);
  }
  return all;
}

static double sd_of(double square, double mean) {
  return sqrt(fmax(0, square - mean * mean));
}

/* One row: a model at one angle. */
static void print_row(FILE *out, const char *model, double angle, double cost, const judge_all *all,
                      size_t i, const judge_angles *m) {
  judge_value tilt = judge_divergence(all, i, m, offsetof(judge_angles, tilt));
  judge_value rebound = judge_divergence(all, i, m, offsetof(judge_angles, rebound));
  judge_value lateral = judge_divergence(all, i, m, offsetof(judge_angles, lateral));
  judge_value mean = judge_mean(all, i, offsetof(judge_angles, rebound_sum));
  judge_value side = judge_mean(all, i, offsetof(judge_angles, lateral_sum));
  double square = judge_mean(all, i, offsetof(judge_angles, lateral_square)).value;
  double later = judge_mean(all, i, offsetof(judge_angles, later)).value;
  double own = m->lateral_sum / m->n;
  fprintf(out, "%s,%g,%.1f,%.5f,%.5f,%.5f,%.4f,%.4f,%.4f,%.5f,%.5f,%.4f,%.4f,%.4f,%.4f,%.5f,%.5f\n",
          model, angle, cost, tilt.value, rebound.value, rebound.se, m->rebound_sum / m->n,
          mean.value, mean.se, lateral.value, lateral.se, own, side.value,
          sd_of(m->lateral_square / m->n, own), sd_of(square, side.value), m->later / m->n, later);
}

void cli_trade_3d(FILE *out, const judge_case *subject, const cli_list *angles, size_t rays,
                  bool multiple, uint32_t seed) {
  double d_p = subject->d_p;
  asp_error error;
  cli_list alpha1 = {malloc(angles->count * sizeof(double)), angles->count};
  if (!alpha1.values)
    cli_fail("out of memory");
  for (size_t i = 0; i < alpha1.count; i++)
    alpha1.values[i] = cli_radians(angles->values[i]);
  const aspi_gauss *numbers = &subject->wall;
  const double lay[3] = {-sin(numbers->axis), cos(numbers->axis), 0};
  asp_surface *surface =
      asp_surface_create_lay(numbers->r_q, numbers->lambda_1, numbers->lambda_2, &error);
  if (!surface)
    cli_bad_usage("%s", error.text);
  judge_all all = judge_create(subject, &alpha1, rays, seed);
  fputs("model,alpha1_deg,ns_per_impact,kl_first_hit,kl_rebound,kl_rebound_se,mean_rebound_deg,"
        "mean_rebound_reference_deg,mean_rebound_reference_se_deg,kl_lateral,kl_lateral_se,"
        "mean_lateral_deg,mean_lateral_reference_deg,sd_lateral_deg,sd_lateral_reference_deg,"
        "later_share,later_share_reference\n",
        out);
  for (int k = 0; k < asp_spread_count(); k++) {
    const char *model = asp_spread_name(asp_spread_at(k));
    measure_specular_wall of = {.surface = surface, .isotropic = true};
    asp_wall *wall = measure_specular(&of, d_p, model, multiple);
    for (size_t i = 0; i < alpha1.count; i++) {
      judge_angles m =
          rebounds(wall, d_p, lay, alpha1.values[i], rays * subject->surfaces, seed + 1);
      print_row(out, model, angles->values[i], measure_cost(wall, d_p, alpha1.values[i]), &all, i,
                &m);
    }
    asp_wall_free(wall);
  }
  judge_free(&all);
  asp_surface_free(surface);
  free(alpha1.values);
}
