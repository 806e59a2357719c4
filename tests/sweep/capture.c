/* The share of particles that stick to a rough wall, by its models and by geometry: spheres that
 * are followed over generated surfaces from hit to hit, each by the rebound law.
 *
 * `capture R_Q LAMBDA_C D_P SPEED ANGLE [SURFACES [SAMPLES [SHAPE]]]`, in um, m/s and degrees, of
 * quartz on Ti-6Al-4V: a row for the geometry, for a map of the wall, for profiles of it of 1000
 * and 100 LAMBDA_C, and for each model. SHAPE: gauss, or one that is made of Gaussian heights by a
 * function: skewed, which has high peaks, or plateau, which has deep valleys; these have no row for
 * models, which take Gaussian heights.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "asperity_internal.h"
#include "base/running.h"
#include "judge_3d.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define LAW "rebound bons materials quartz ti-6al-4v"
static const double DENSITY = 2650;
enum { POINTS = 1024, RAYS = 8 * POINTS };

static void must(bool good, const asp_error *error) {
  if (good)
    return;
  fprintf(stderr, "capture: %s\n", error->text);
  exit(2);
}

static asp_wall *wall_of(const char *text, double d_p) {
  asp_error error;
  asp_wall *wall = asp_wall_from_text(text, d_p, d_p, &error);
  must(wall, &error);
  return wall;
}

static void tell(const char *what, double share, double error) {
  printf("%s,%.5f,%.5f\n", what, share, error);
  fflush(stdout);
}

static void shoot(const char *what, const asp_wall *wall, double d_p, double speed, double angle,
                  int samples) {
  const asp_particle particle = {.d_p = d_p, .density = DENSITY};
  const double v[3] = {speed * cos(angle), 0, -speed * sin(angle)}, n[3] = {0, 0, 1};
  double count = 0;
  for (int i = 0; i < samples; i++) {
    asp_impact impact;
    asp_wall_impact(wall, &particle, v, n, &(asp_key){1, 1, (uint64_t)i, 1, 0}, &impact);
    count += impact.outcome == ASP_DEPOSIT;
  }
  tell(what, count / samples, sqrt(count * (1 - count / samples)) / samples);
}

/* Heights of this shape from Gaussian ones. */
static const char *shape = "gauss";

static asp_heights *shaped(asp_heights *heights, double r_q) {
  for (size_t i = 0; heights && i < heights->columns * heights->rows; i++) {
    double *z = &heights->z[i];
    if (strcmp(shape, "skewed") == 0)
      *z = 1.6 * r_q * exp(0.5 * *z / r_q);
    else if (strcmp(shape, "plateau") == 0)
      *z = -1.3 * r_q * log1p(exp(0.6 - 1.4 * *z / r_q));
  }
  return heights;
}

static asp_heights *make(const surfaces *of, const double step[2], size_t points, uint32_t seed) {
  return shaped(gauss_map_create(&of->wall, step, points, points, seed, NULL), of->wall.r_q);
}

/* Shots at the wall of a measured map or profile, which it frees. */
static void shoot_measured(const char *what, asp_heights *heights, double d_p, double speed,
                           double angle, int samples) {
  asp_error error = {0};
  must(heights, &error);
  heights->periodic = false;
  asp_description *words = asp_description_parse(
      heights->rows > 1 ? "surface map generated " LAW : "surface profile generated " LAW, NULL,
      &error);
  must(words && !asp_description_set_heights(words, heights, &error), &error);
  asp_wall *wall = asp_wall_create(words, d_p, d_p, &error);
  must(wall, &error);
  shoot(what, wall, d_p, speed, angle, samples);
  asp_wall_free(wall);
  asp_description_free(words);
  asp_heights_free(heights);
}

int main(int argc, char **argv) {
  if (argc < 6)
    return fputs("usage: capture R_Q LAMBDA_C D_P SPEED ANGLE [SURFACES [SAMPLES [SHAPE]]]\n",
                 stderr),
           2;
  double r_q = 1e-6 * atof(argv[1]), lambda_c = 1e-6 * atof(argv[2]), d_p = 1e-6 * atof(argv[3]);
  double speed = atof(argv[4]), degrees = atof(argv[5]), angle = degrees * ASP_PI / 180;
  int groups = argc > 6 ? atoi(argv[6]) : 8, samples = argc > 7 ? atoi(argv[7]) : 100000;
  shape = argc > 8 ? argv[8] : shape;
  asp_wall *law = wall_of("surface smooth " LAW, d_p);
  surfaces subject = {.wall = {r_q, lambda_c, lambda_c, 0},
                      .d_p = d_p,
                      .groups = (size_t)groups,
                      .rays = 2 * RAYS,
                      .points = POINTS,
                      .seed = 1,
                      .law = law,
                      .density = DENSITY,
                      .speed = speed,
                      .make = make};
  aspi_judge judge;
  asp_error error;
  must(!judge_in_space(&judge, &subject, &degrees, 1, &error), &error);
  aspi_running stuck = {0, 0, 0};
  for (int g = 0; g < groups; g++)
    aspi_running_add(&stuck, 1 - judge.angles[g].n / (2 * RAYS));
  puts("model,share_that_sticks,standard_error");
  tell("geometry", stuck.mean, aspi_running_sd(&stuck) / sqrt(groups));
  const double step[2] = {lambda_c / 20, lambda_c / 20};
  shoot_measured("a map of it", make(&subject, step, POINTS, 1000), d_p, speed, angle, samples);
  for (size_t n = 1000; n >= 100; n /= 10) {
    char what[60];
    snprintf(what, sizeof what, "a profile of %zu lambda_c", n);
    shoot_measured(
        what, shaped(aspi_profile_generate(r_q, lambda_c, lambda_c / 32, 32 * n, 1, NULL), r_q),
        d_p, speed, angle, samples);
  }
  static const char *const models[] = {"visible isotropic", "profile isotropic", "traced isotropic",
                                       "visible plane",     "profile plane",     "traced plane"};
  for (size_t m = 0; strcmp(shape, "gauss") == 0 && m < sizeof models / sizeof *models; m++) {
    char text[200];
    snprintf(text, sizeof text, "surface rq %.17g lambda_c %.17g spread %s " LAW, r_q, lambda_c,
             models[m]);
    asp_wall *wall = wall_of(text, d_p);
    shoot(models[m], wall, d_p, speed, angle, samples);
    asp_wall_free(wall);
  }
  aspi_judge_free(&judge);
  asp_wall_free(law);
}
