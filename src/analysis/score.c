/* One score of a model against measurements; see score.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/score.h"

#include <gsl/gsl_randist.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>

/* What is compared in a bin: means of all quantities, and the sd of both coefficients. */
enum { TERMS = ASPI_QUANTITIES + COR_BOTH };

bool aspi_score_begin(aspi_score *score) {
  *score = (aspi_score){.rng = gsl_rng_alloc(gsl_rng_mt19937)};
  if (score->rng)
    gsl_rng_set(score->rng, 1);
  return score->rng;
}

/* The standard error of the difference of two sd. One law has one kurtosis, which few impacts tell
 * badly: that of both together counts. */
static double sd_error_of(const aspi_sample *m, const aspi_sample *d) {
  const aspi_sample *both[] = {m, d};
  double n = 0, sum = 0;
  for (int i = 0; i < 2; i++)
    if (both[i]->sd > 0) {
      double relative = both[i]->sd_se / both[i]->sd;
      n += both[i]->size;
      sum += both[i]->size * both[i]->size * relative * relative;
    }
  return sqrt(sum / n * (m->sd * m->sd / m->size + d->sd * d->sd / d->size));
}

/* Equal shares of deposits have the error of both together (Pearson's chi-square). */
static double share_error_of(const aspi_sample *m, const aspi_sample *d) {
  double share = (m->mean * m->size + d->mean * d->size) / (m->size + d->size);
  return sqrt(share * (1 - share) * (1 / m->size + 1 / d->size));
}

/* The standard error of a difference; a model without scatter has none of its own. */
static double error_of(const aspi_side *model, const aspi_side *data, int term) {
  int k = term < ASPI_QUANTITIES ? term : term - ASPI_QUANTITIES;
  const aspi_sample *m = &model->of[k], *d = &data->of[k];
  if (term == ASPI_DEPOSITS)
    return share_error_of(m, d);
  if (data->impacts && d->size < ASPI_SCORED_LEAST)
    return NAN;
  if (term != k)
    return sd_error_of(m, d);
  return hypot(d->mean_se, isfinite(m->mean_se) ? m->mean_se : 0);
}

static double value_of(const aspi_side *side, int term) {
  return term < ASPI_QUANTITIES ? side->of[term].mean : side->of[term - ASPI_QUANTITIES].sd;
}

/* The difference in its standard errors; NAN where it is none of the score's terms. */
static double deviation(const aspi_side *model, const aspi_side *data, int term, double error) {
  double z = (value_of(model, term) - value_of(data, term)) / error;
  return isfinite(z) ? z : NAN;
}

static void add(aspi_score *score, int replicate, double z, double noise) {
  score->cross[replicate] += z * noise;
  score->noise[replicate] += noise * noise;
}

void aspi_score_add_means(aspi_score *score, const aspi_side *model, const aspi_side *data) {
  for (int k = 0; k < COR_BOTH; k++) {
    double z = deviation(model, data, k, error_of(model, data, k));
    if (isnan(z))
      continue;
    score->terms++;
    score->square += z * z;
    for (int r = 0; r < ASPI_REPLICATES; r++)
      add(score, r, z, gsl_ran_ugaussian(score->rng));
  }
}

/* As many impacts as count in full, drawn by their weights: how far their means and sd are from
 * those of the side. */
static void resample(const aspi_side *side, const gsl_ran_discrete_t *by_weight, gsl_rng *rng,
                     double off[TERMS]) {
  double n[ASPI_QUANTITIES] = {0}, sum[ASPI_QUANTITIES] = {0}, squares[ASPI_QUANTITIES] = {0};
  for (size_t i = (size_t)(side->of[ASPI_DEPOSITS].size + 0.5); i > 0; i--) {
    const aspi_impact *drawn = &side->impacts[gsl_ran_discrete(rng, by_weight)];
    for (int k = 0; k < ASPI_QUANTITIES; k++) {
      double u = drawn->of[k] - side->of[k].mean;
      if (isnan(u))
        continue;
      n[k]++;
      sum[k] += u;
      squares[k] += u * u;
    }
  }
  for (int k = 0; k < ASPI_QUANTITIES; k++) {
    off[k] = sum[k] / n[k];
    if (k < COR_BOTH)
      off[ASPI_QUANTITIES + k] =
          sqrt(fmax(0, squares[k] - sum[k] * sum[k] / n[k]) / (n[k] - 1)) - side->of[k].sd;
  }
}

static gsl_ran_discrete_t *weights_of(const aspi_side *side) {
  double *weights = malloc(side->count * sizeof *weights);
  for (size_t i = 0; weights && i < side->count; i++)
    weights[i] = side->impacts[i].weight;
  gsl_ran_discrete_t *table = weights ? gsl_ran_discrete_preproc(side->count, weights) : NULL;
  free(weights);
  return table;
}

bool aspi_score_add_impacts(aspi_score *score, const aspi_side *model, const aspi_side *data) {
  double z[TERMS], error[TERMS];
  size_t terms = 0;
  for (int t = 0; t < TERMS; t++) {
    z[t] = deviation(model, data, t, error[t] = error_of(model, data, t));
    terms += isfinite(z[t]);
    score->square += isfinite(z[t]) ? z[t] * z[t] : 0;
  }
  score->terms += terms;
  if (terms == 0)
    return true;
  gsl_ran_discrete_t *tables[2] = {weights_of(model), weights_of(data)};
  bool fine = tables[0] && tables[1];
  for (int r = 0; r < ASPI_REPLICATES && fine; r++) {
    double off[2][TERMS];
    resample(model, tables[0], score->rng, off[0]);
    resample(data, tables[1], score->rng, off[1]);
    for (int t = 0; t < TERMS; t++) {
      double noise = (off[0][t] - off[1][t]) / error[t];
      if (isfinite(z[t]) && isfinite(noise))
        add(score, r, z[t], noise);
    }
  }
  for (int k = 0; k < 2; k++)
    if (tables[k])
      gsl_ran_discrete_free(tables[k]);
  return fine;
}

aspi_estimate aspi_score_end(aspi_score *score) {
  double n = (double)score->terms, value = score->square / n, replicate[ASPI_REPLICATES];
  double part = value > 1 ? sqrt((value - 1) / value) : 0;
  for (int r = 0; r < ASPI_REPLICATES; r++)
    replicate[r] = (2 * part * score->cross[r] + score->noise[r]) / n;
  gsl_rng_free(score->rng);
  return (aspi_estimate){value, gsl_stats_sd(replicate, 1, ASPI_REPLICATES)};
}
