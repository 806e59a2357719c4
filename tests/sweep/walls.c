/* Walls whose heights are not Gaussian (a plateau with valleys, deposits, dents), measured as maps
 * and as profiles: flights over one map against independent ones, in three
 * dimensions; and those of a profile against independent profiles, followed hit by hit. `walls` is
 * the test; `walls 4096 8` judges with maps of 4096 x 4096 points, 200 correlation lengths squared,
 * 8 of them, and `walls 4096 8 55` with particles of 55 um instead of 10.
 *
 * Prints a row per wall and impact angle, and fails where a divergence is above its bound.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "judge_3d.h"
#include "wall/wall.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define DEGREE (ASP_PI / 180)
#define R_Q 5.0 /* um */

enum { GAUSS, PLATEAU, DEPOSITS, DENTED, WALLS };
static const char *const names[WALLS] = {"gauss", "plateau", "deposits", "dented"};
static const double lambda_c[WALLS] = {39, 46, 46, 50}; /* of the Gaussian map at the beginning */

/* Caps over the wall (sign 1) or craters in it (-1) with rims, of radius `least` to `most`, `apart`
 * from each other on the average. */
typedef struct caps {
  double apart, least, most, sign, rim;
} caps;

static double uniform(uint32_t *state) {
  *state = *state * 1664525u + 1013904223u;
  return (*state >> 8) / 16777216.;
}

static void add_cap(asp_heights *m, double x, double y, double r, const caps *c) {
  long columns = (long)m->columns, rows = (long)m->rows;
  long last_row = (long)floor((y + 1.6 * r) / m->step[1]);
  long last_column = (long)floor((x + 1.6 * r) / m->step[0]);
  for (long j = (long)floor((y - 1.6 * r) / m->step[1]); j <= last_row; j++)
    for (long i = (long)floor((x - 1.6 * r) / m->step[0]); i <= last_column; i++) {
      double d = hypot((double)i * m->step[0] - x, (double)j * m->step[1] - y) / r;
      double body = d < 1 ? pow(1 - d * d, 1.5) : 0, edge = exp(-20 * (d - 1.15) * (d - 1.15));
      m->z[(j + rows) % rows * columns + (i + columns) % columns] +=
          (0.35 * r * (c->sign * body + c->rim * edge));
    }
}

static void add_caps(asp_heights *m, const caps *c, uint32_t seed) {
  double width = (double)m->columns * m->step[0], height = (double)m->rows * m->step[1];
  uint32_t state = seed * 77777u + 5;
  for (int k = 0; k < width * height / (c->apart * c->apart); k++) {
    double x = uniform(&state) * width, y = uniform(&state) * height;
    add_cap(m, x, y, c->least + (c->most - c->least) * uniform(&state), c);
  }
}

static int kind;
static double skewness;

/* Heights of a plateau with valleys, of a Gaussian wall's. */
static double plateau(double height) {
  return -log1p(exp(0.6 - 1.4 * height / 5));
}

static void fail(const asp_error *error) {
  fprintf(stderr, "walls: %s\n", error->text);
  exit(2);
}

static asp_heights *make_wall(const surfaces *subject, const double step[2], size_t points,
                              uint32_t seed) {
  (void)subject;
  asp_error error;
  gauss_wall gauss = {kind == GAUSS || kind == PLATEAU ? 5 : 3, lambda_c[kind], lambda_c[kind], 0};
  asp_heights *m = gauss_map_create(&gauss, step, points, points, seed, &error);
  if (!m)
    fail(&error);
  size_t n = points * points;
  if (kind == PLATEAU)
    for (size_t i = 0; i < n; i++)
      m->z[i] = plateau(m->z[i]);
  if (kind == DEPOSITS)
    add_caps(m, &(caps){62, 10, 26, 1, 0}, seed);
  if (kind == DENTED)
    add_caps(m, &(caps){55, 12, 26, -1, 0.5}, seed);
  double mean = 0, square = 0, cube = 0;
  for (size_t i = 0; i < n; i++)
    mean += m->z[i] / (double)n;
  for (size_t i = 0; i < n; i++) {
    double z = m->z[i] - mean;
    square += z * z / (double)n;
    cube += z * z * z / (double)n;
  }
  skewness = cube / pow(square, 1.5);
  for (size_t i = 0; i < n; i++)
    m->z[i] = ((m->z[i] - mean) * R_Q / sqrt(square));
  return m;
}

/* A wall of particles of one size; profile and map may be NULL. */
static asp_wall *wall_of(const asp_surface *surface, const asp_heights *profile,
                         const asp_heights *map, const char *model, double d_p) {
  asp_error error;
  aspi_wall_choice choice = aspi_wall_choice_smooth();
  aspi_wall_choose_law(&choice, asp_rebound_find("constant", NULL));
  choice.surface = surface;
  choice.heights = map ? map : profile;
  choice.spread = asp_spread_find(model, NULL);
  choice.sizes = (aspi_sizes){d_p, d_p, 1};
  choice.multiple = true;
  choice.deposit = false;
  asp_wall *wall = aspi_wall_create(&choice, &error);
  if (!wall)
    fail(&error);
  return wall;
}

static aspi_angles fly(const asp_wall *wall, double d_p, double alpha1, size_t n) {
  aspi_angles all = {0};
  const double a = alpha1 * DEGREE, v1[3] = {cos(a), 0, -sin(a)}, up[3] = {0, 0, 1};
  for (size_t i = 0; i < n; i++) {
    asp_particle particle = {.d_p = d_p, .density = 1};
    asp_impact impact;
    asp_wall_impact(wall, &particle, v1, up, &(asp_key){1, 1, i, 1, 0}, &impact);
    aspi_angles_add(&all, impact.v2, impact.delta_alpha, impact.hits);
  }
  return all;
}

static int failures;

/* A row; of the later hits, how far their share is off. */
static void tell(const char *what, double alpha1, const aspi_judge *all, size_t i,
                 const aspi_angles *m, bool lateral) {
  aspi_mean_error first = aspi_judge_divergence(all, i, m, 1, offsetof(aspi_angles, tilt));
  aspi_mean_error rebound = aspi_judge_divergence(all, i, m, 1, offsetof(aspi_angles, rebound));
  aspi_mean_error side = aspi_judge_divergence(all, i, m, 1, offsetof(aspi_angles, lateral));
  aspi_mean_error mean =
      aspi_angles_mean(aspi_judge_groups(all, i), offsetof(aspi_angles, rebound_sum));
  aspi_mean_error later = aspi_angles_mean(aspi_judge_groups(all, i), offsetof(aspi_angles, later));
  printf("%s,%s,%.2f,%g,%.5f,%.5f,%.5f,%.5f,%.3f,%.3f,%.3f,%.5f,%.5f\n", names[kind], what,
         skewness, alpha1, first.value, rebound.value, rebound.se, lateral ? side.value : 0,
         mean.value, mean.se, m->rebound_sum / m->n, later.value, m->later / m->n);
  fflush(stdout);
  bool good =
      rebound.value - 2 * rebound.se < 0.01 && (!lateral || side.value - 2 * side.se < 0.01);
  if (!lateral)
    good = good && fabs(m->later / m->n / later.value - 1) < 0.2 + 3 * later.se / later.value;
  failures += !good;
}

enum { RAYS = 100000, FLOWN = 400000 };

static const double angles[] = {2, 5, 20};

static void judge_map(size_t points, size_t count, double d_p) {
  asp_error error;
  surfaces subject = {.wall = {R_Q, 39, 39, 0},
                      .d_p = d_p,
                      .groups = count,
                      .rays = RAYS,
                      .seed = 500,
                      .points = points,
                      .make = make_wall};
  aspi_judge all;
  if (judge_in_space(&all, &subject, angles, 3, &error))
    fail(&error);
  const double step[2] = {39 / 20., 39 / 20.};
  asp_heights *periodic = make_wall(&subject, step, points, 7);
  asp_heights *map =
      asp_heights_create(periodic->z, points, points, step[0], step[1], false, &error);
  asp_surface *surface = asp_surface_create(R_Q, 39, &error);
  asp_wall *wall = wall_of(surface, NULL, map, "traced", d_p);
  for (size_t i = 0; i < 3; i++) {
    aspi_angles m = fly(wall, d_p, angles[i], FLOWN);
    tell("map", angles[i], &all, i, &m, true);
  }
  asp_wall_free(wall);
  asp_surface_free(surface);
  asp_heights_free(map);
  asp_heights_free(periodic);
  aspi_judge_free(&all);
}

/* A long profile of a wall whose heights come from Gaussian ones point by point. */
static asp_heights *profile_of(size_t points, uint32_t seed) {
  double spacing = 39 / 20., square = 0, mean = 0;
  size_t n = 80 * points;
  asp_heights *gauss = aspi_profile_generate(5, lambda_c[kind], spacing, n, seed, NULL);
  double *z = malloc(n * sizeof *z);
  for (size_t i = 0; i < n; i++) {
    z[i] = kind == PLATEAU ? plateau(gauss->z[i]) : gauss->z[i];
    mean += z[i] / (double)n;
  }
  for (size_t i = 0; i < n; i++)
    square += (z[i] - mean) * (z[i] - mean) / (double)n;
  for (size_t i = 0; i < n; i++)
    z[i] = (z[i] - mean) * R_Q / sqrt(square);
  asp_heights *profile = asp_heights_create(z, n, 1, spacing, spacing, false, NULL);
  free(z);
  asp_heights_free(gauss);
  return profile;
}

/* Flights over a profile against those over independent profiles, each a realization of its own. */
static void judge_profile(size_t points, size_t count, double d_p) {
  aspi_judge all = {count, 3, calloc(3 * count, sizeof(aspi_angles)), NULL};
  asp_heights *own = profile_of(points, 7);
  asp_surface *surface = asp_surface_create_profile(own, d_p, d_p, 1, NULL);
  asp_wall *wall = wall_of(surface, own, NULL, "traced", d_p);
  for (size_t k = 0; k < count; k++) {
    asp_heights *other = profile_of(points, 500 + (uint32_t)k);
    asp_wall *judge = wall_of(surface, other, NULL, "traced", d_p);
    for (size_t i = 0; i < 3; i++)
      all.angles[3 * k + i] = fly(judge, d_p, angles[i], RAYS);
    asp_wall_free(judge);
    asp_heights_free(other);
  }
  for (size_t i = 0; i < 3; i++) {
    aspi_angles m = fly(wall, d_p, angles[i], FLOWN);
    tell("profile", angles[i], &all, i, &m, false);
  }
  asp_wall_free(wall);
  asp_surface_free(surface);
  asp_heights_free(own);
  aspi_judge_free(&all);
}

int main(int argc, char **argv) {
  size_t points = argc > 1 ? strtoul(argv[1], NULL, 10) : 1024;
  size_t count = argc > 2 ? strtoul(argv[2], NULL, 10) : 3;
  double d_p = argc > 3 ? strtod(argv[3], NULL) : 10;
  puts("wall,law,skewness,alpha1_deg,kl_first_hit,kl_rebound,kl_rebound_se,kl_lateral,"
       "mean_reference_deg,mean_reference_se_deg,mean_deg,later_reference,later");
  for (kind = 0; kind < WALLS; kind++) {
    if (argc == 1 && kind != PLATEAU)
      continue;
    judge_map(points, count, d_p);
    if (kind == GAUSS || kind == PLATEAU)
      judge_profile(points, count, d_p);
  }
  if (failures)
    printf("%d rows are beyond their bounds\n", failures);
  return failures > 0;
}
