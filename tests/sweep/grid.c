/* Every model on a grid of walls and angles: the measurement from which `spread auto` chooses,
 * src/spread/measured.csv. Half an hour. Geometry has no scale, so that a wall and its particles
 * are two numbers, phi_r and kappa. Corners where the disc is as large as a good part of the
 * profile are left out.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/measure.h"

#include <math.h>

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

static void print_row(FILE *out, const cell *c, const measure_case *subject,
                      const measure_wall *wall, const measure_reference *references,
                      const char *name, bool multiple) {
  measure_model model = measure_model_create(subject, wall, name, multiple);
  fprintf(out, "%s,%s,%g,%g", name, multiple ? "multiple" : "single", c->phi_r, c->kappa);
  for (size_t i = 0; i < COUNT(angle); i++) {
    measure_divergence d = measure_compare(subject, &references[i], &model);
    fprintf(out, ",%.5f,%.5f", d.kl, d.se);
  }
  measure_model_free(&model);
  fputc('\n', out);
}

/* False where the corner is left out. */
static bool measure_cell(FILE *out, const cell *c, measure_case subject) {
  subject.lambda_c = 1;
  subject.r_q = c->phi_r;
  subject.d_p = c->kappa / (sqrt(3) * c->phi_r);
  if (subject.d_p > D_P_MOST)
    return false;
  measure_wall wall = measure_wall_create(&subject);
  measure_reference *references = measure_references(&subject, &wall, angle, COUNT(angle));
  for (int m = 0; m < asp_spread_count(); m++)
    for (int multiple = 0; multiple < 2; multiple++)
      print_row(out, c, &subject, &wall, references, asp_spread_name(asp_spread_at(m)), multiple);
  measure_references_free(references, COUNT(angle));
  measure_wall_free(&wall);
  fflush(out);
  return true;
}

int main(void) {
  static const measure_case subject = {.rays = 100000, .profiles = 16, .seed = 1};
  print_header(stdout);
  for (size_t i = 0; i < COUNT(phi_r) * COUNT(kappa); i++) {
    cell c = {phi_r[i / COUNT(kappa)], kappa[i % COUNT(kappa)]};
    if (measure_cell(stdout, &c, subject))
      fprintf(stderr, "grid: phi_r %g, kappa %g done\n", c.phi_r, c.kappa);
  }
  return 0;
}
