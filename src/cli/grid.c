/* asperity trade --grid: every model on a grid of walls and angles, the measurement from which
 * `auto` chooses. Geometry has no scale, so that a wall and its particles are two numbers, phi_r
 * and kappa. Corners where the disc is as large as a good part of the profile are left out. */
#include "cli/grid.h"
#include "cli/measure.h"

#include <math.h>

static const double phi_r[] = {0.005, 0.02, 0.04, 0.08, 0.125, 0.2, 0.35, 0.6};
static const double kappa[] = {0.1, 0.5, 1, 2, 4, 8, 16};
static const double angle[] = {1, 2, 4, 7, 12, 20, 35, 60, 85};

#define COUNT(array) (sizeof(array) / sizeof *(array))

/* In lambda_c. */
#define D_P_MOST 40

/* One wall with particles of one size, and what the geometry says of it. */
typedef struct cell {
  double phi_r, kappa;
  measure_case subject;
  measure_angles reference[COUNT(angle)];
  size_t rays;
  uint32_t seed;
} cell;

static void print_header(FILE *out) {
  fputs("model,collisions,phi_r,kappa", out);
  for (size_t i = 0; i < COUNT(angle); i++)
    fprintf(out, ",kl_%g", angle[i]);
  fputc('\n', out);
}

static void print_row(FILE *out, const cell *c, const char *model, bool multiple) {
  asp_wall *wall = measure_wall(&c->subject, model, multiple);
  double divergence[COUNT(angle)];
  for (size_t i = 0; i < COUNT(angle); i++) {
    double alpha1 = cli_radians(angle[i]);
    measure_angles rebounds = measure_rebounds(wall, c->subject.d_p, alpha1, c->rays, c->seed + 1);
    divergence[i] = measure_divergence(&c->reference[i], &rebounds);
  }
  asp_wall_free(wall);
  fprintf(out, "%s,%s,%g,%g", model, multiple ? "multiple" : "single", c->phi_r, c->kappa);
  for (size_t i = 0; i < COUNT(angle); i++)
    fprintf(out, ",%.4f", divergence[i]);
  fputc('\n', out);
}

static void fill_reference(cell *c) {
  asp_wall *traced = measure_wall(&c->subject, "traced", true);
  for (size_t i = 0; i < COUNT(angle); i++)
    c->reference[i] =
        measure_rebounds(traced, c->subject.d_p, cli_radians(angle[i]), c->rays, c->seed);
  asp_wall_free(traced);
}

void cli_grid(FILE *out, size_t rays, uint32_t seed) {
  print_header(out);
  cli_progress progress = cli_progress_begin("measuring", COUNT(phi_r) * COUNT(kappa));
  for (size_t i = 0; i < COUNT(phi_r) * COUNT(kappa); i++) {
    cell c = {phi_r[i / COUNT(kappa)], kappa[i % COUNT(kappa)], .rays = rays, .seed = seed};
    double d_p = c.kappa / (sqrt(3) * c.phi_r);
    if (d_p > D_P_MOST)
      continue;
    c.subject = measure_case_create(c.phi_r, 1, d_p, seed);
    fill_reference(&c);
    for (int m = 0; m < asp_spread_count(); m++) {
      print_row(out, &c, asp_spread_name(asp_spread_at(m)), false);
      print_row(out, &c, asp_spread_name(asp_spread_at(m)), true);
    }
    measure_case_free(&c.subject);
    cli_progress_show(&progress, (double)(i + 1));
  }
  cli_progress_end(&progress);
}
