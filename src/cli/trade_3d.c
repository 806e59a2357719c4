/* asperity trade --three-d: every model, isotropic, against surfaces in three dimensions, none of
 * which made a model; of a map against one half of the map, made of the other.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/trade_3d.h"

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

/* What the models are made of: one wall, or the half of a map for each fold. */
typedef struct made_of {
  size_t folds;
  asp_surface *surface[2];
  asp_map *map[2];
  const double *lay; /* NULL: particles fly in all directions over it */
} made_of;

static made_of made_of_case(const judge_case *subject, const double lay[3]) {
  const aspi_gauss *numbers = &subject->wall;
  asp_error error;
  made_of made = {.folds = subject->map ? 2 : 1, .lay = subject->map ? NULL : lay};
  for (size_t fold = 0; fold < made.folds; fold++) {
    if (subject->map)
      made.map[fold] = judge_half(subject->map, 1 - fold, &error);
    if (made.map[fold])
      made.surface[fold] = asp_surface_create_map(made.map[fold], false, &error);
    else if (!subject->map)
      made.surface[fold] =
          asp_surface_create_lay(numbers->r_q, numbers->lambda_1, numbers->lambda_2, &error);
    if (!made.surface[fold])
      cli_bad_usage("%s%s", subject->map ? "surface map: half of it: " : "", error.text);
  }
  return made;
}

static void made_of_free(made_of *made) {
  for (size_t fold = 0; fold < made->folds; fold++) {
    asp_surface_free(made->surface[fold]);
    asp_map_free(made->map[fold]);
  }
}

/* One row: a model at one angle; m, one for each fold. */
static void print_row(FILE *out, const judge_all *all, size_t i, const judge_angles *folds,
                      trade_row *row) {
  judge_angles m = {0};
  for (size_t fold = 0; fold < all->folds; fold++)
    add_all(&m, &folds[fold]);
  judge_value tilt = judge_divergence(all, i, folds, offsetof(judge_angles, tilt));
  judge_value rebound = judge_divergence(all, i, folds, offsetof(judge_angles, rebound));
  judge_value lateral = judge_divergence(all, i, folds, offsetof(judge_angles, lateral));
  judge_value mean = judge_mean(all, i, offsetof(judge_angles, rebound_sum));
  judge_value side = judge_mean(all, i, offsetof(judge_angles, lateral_sum));
  double square = judge_mean(all, i, offsetof(judge_angles, lateral_square)).value;
  double later = judge_mean(all, i, offsetof(judge_angles, later)).value;
  double own = m.lateral_sum / m.n;
  row->first_hit = tilt.value;
  row->rebound = (measure_divergence){rebound.value, rebound.se, m.rebound_sum / m.n, mean.value};
  fprintf(out, "%s,%g,%.1f,%.5f,%.5f,%.5f,%.4f,%.4f,%.4f,%.5f,%.5f,%.4f,%.4f,%.4f,%.4f,%.5f,%.5f\n",
          asp_spread_name(row->model), row->angle, row->cost, tilt.value, rebound.value, rebound.se,
          m.rebound_sum / m.n, mean.value, mean.se, lateral.value, lateral.se, own, side.value,
          sd_of(m.lateral_square / m.n, own), sd_of(square, side.value), m.later / m.n, later);
}

/* The rows of one model. */
static void judge_model(FILE *out, const judge_case *subject, const made_of *of,
                        const judge_all *all, const cli_list *angles, size_t rays, bool multiple,
                        uint32_t seed, trade_row *rows) {
  double d_p = subject->d_p;
  asp_wall *wall[2] = {NULL, NULL};
  for (size_t fold = 0; fold < of->folds; fold++) {
    measure_specular_wall made = {
        .surface = of->surface[fold], .map = of->map[fold], .isotropic = true};
    wall[fold] = measure_specular(&made, d_p, asp_spread_name(rows->model), multiple);
  }
  for (size_t i = 0; i < angles->count; i++) {
    trade_row *row = &rows[i * (size_t)asp_spread_count()];
    double alpha1 = cli_radians(angles->values[i]);
    judge_angles m[2];
    for (size_t fold = 0; fold < of->folds; fold++)
      m[fold] = rebounds(wall[fold], d_p, of->lay, alpha1, rays * subject->surfaces / of->folds,
                         seed + 1);
    *row = (trade_row){.model = rows->model,
                       .angle = angles->values[i],
                       .cost = measure_cost(wall[0], d_p, alpha1)};
    print_row(out, all, i, m, row);
  }
  for (size_t fold = 0; fold < of->folds; fold++)
    asp_wall_free(wall[fold]);
}

void cli_trade_3d(FILE *out, const judge_case *subject, const cli_list *angles, size_t rays,
                  bool multiple, uint32_t seed, trade_row *rows) {
  cli_list alpha1 = {.values = cli_allocate(angles->count, sizeof(double)), .count = angles->count};
  for (size_t i = 0; i < alpha1.count; i++)
    alpha1.values[i] = cli_radians(angles->values[i]);
  const double lay[3] = {-sin(subject->wall.axis), cos(subject->wall.axis), 0};
  made_of of = made_of_case(subject, lay);
  judge_all all = judge_create(subject, &alpha1, rays, seed);
  fputs("model,alpha1_deg,ns_per_impact,kl_first_hit,kl_rebound,kl_rebound_se,mean_rebound_deg,"
        "mean_rebound_reference_deg,mean_rebound_reference_se_deg,kl_lateral,kl_lateral_se,"
        "mean_lateral_deg,mean_lateral_reference_deg,sd_lateral_deg,sd_lateral_reference_deg,"
        "later_share,later_share_reference\n",
        out);
  for (int k = 0; k < asp_spread_count(); k++) {
    rows[k].model = asp_spread_at(k);
    judge_model(out, subject, &of, &all, angles, rays, multiple, seed, rows + k);
  }
  judge_free(&all);
  made_of_free(&of);
  free(alpha1.values);
}
