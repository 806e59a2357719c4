/* Every model on a grid of walls and angles: the measurement from which `spread auto` chooses,
 * src/spread/measured.csv. Half an hour. Geometry has no scale, so that a wall and its particles
 * are two numbers, phi_r and kappa. Corners where the disc is as large as a good part of the
 * profile are left out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/judge.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const double phi_r[] = {0.005, 0.02, 0.04, 0.08, 0.125, 0.2, 0.35, 0.6};
static const double kappa[] = {0.1, 0.5, 1, 2, 4, 8, 16};
static const double angle[] = {1, 2, 4, 7, 12, 20, 35, 60, 85};

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* In lambda_c. */
#define D_P_MOST 40

/* One wall with particles of one size. */
typedef struct cell {
  double phi_r, kappa;
} cell;

static void print_header(FILE *out) {
  fputs("model,collisions,phi_r,kappa", out);
  for (size_t i = 0; i < COUNT(angle); i++)
    fprintf(out, ",kl_%g,se_%g", angle[i], angle[i]);
  fputc('\n', out);
}

static asp_error error;

static void must(asp_code code) {
  if (code)
    fprintf(stderr, "grid: %s\n", error.text), exit(2);
}

static void print_row(FILE *out, const cell *c, const aspi_judge_case *subject,
                      const aspi_judge_walls *walls, const aspi_judge *judge, const char *name,
                      bool multiple) {
  aspi_judge_model model;
  must(aspi_judge_model_create(&model, walls, subject->d_p, name, multiple, &error));
  fprintf(out, "%s,%s,%g,%g", name, multiple ? "multiple" : "single", c->phi_r, c->kappa);
  for (size_t i = 0; i < COUNT(angle); i++) {
    size_t groups;
    aspi_angles *angles = aspi_judge_model_rebounds(subject, &model, angle[i], &groups);
    aspi_estimate d =
        aspi_judge_divergence(judge, i, angles, groups, offsetof(aspi_angles, rebound));
    free(angles);
    fprintf(out, ",%.5f,%.5f", d.value, d.se);
  }
  aspi_judge_model_free(&model);
  fputc('\n', out);
}

/* False where the corner is left out. */
static bool judge_cell(FILE *out, const cell *c, aspi_judge_case subject) {
  subject.wall = (aspi_gauss){c->phi_r, 1, 1, 0};
  subject.d_p = c->kappa / (sqrt(3) * c->phi_r);
  if (subject.d_p > D_P_MOST)
    return false;
  aspi_judge_walls walls;
  aspi_judge judge;
  must(aspi_judge_walls_create(&walls, &subject, &error));
  must(aspi_judge_create(&judge, &subject, &walls, angle, COUNT(angle), &error));
  for (int m = 0; m < asp_spread_count(); m++)
    for (int multiple = 0; multiple < 2; multiple++)
      print_row(out, c, &subject, &walls, &judge, asp_spread_name(asp_spread_at(m)), multiple);
  aspi_judge_free(&judge);
  aspi_judge_walls_free(&walls);
  fflush(out);
  return true;
}

int main(void) {
  static const aspi_judge_case subject = {.rays = 100000, .groups = 16, .seed = 1};
  print_header(stdout);
  for (size_t i = 0; i < COUNT(phi_r) * COUNT(kappa); i++) {
    cell c = {phi_r[i / COUNT(kappa)], kappa[i % COUNT(kappa)]};
    if (judge_cell(stdout, &c, subject))
      fprintf(stderr, "grid: phi_r %g, kappa %g done\n", c.phi_r, c.kappa);
  }
  return 0;
}
