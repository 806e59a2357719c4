/* Rebounds from many independent surfaces in three dimensions, or from the pieces of a measured
 * map: the judge of models on walls that are no grooves.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_JUDGE_H
#define ASP_CLI_JUDGE_H

#include "cli/cli.h"
#include "surface/map.h"

enum { JUDGE_BINS = 180 }; /* of one degree */

/* Angles of specular rebounds: alpha2 from 0 to 180 degrees, the lateral angle asin(v2.b/v2) and
 * the tilt of the first hit from -90 to 90. */
typedef struct judge_angles {
  double n;
  double rebound[JUDGE_BINS], lateral[JUDGE_BINS], tilt[JUDGE_BINS];
  double rebound_sum, lateral_sum, lateral_square; /* degrees */
  double later;                                    /* how many have more than one hit */
} judge_angles;

/* v2 in (t, b, n), of any length. */
void judge_add(judge_angles *angles, const double v2[3], double tilt, int hits);

/* What the surfaces say: of each of them, angles[surface * count + i] at alpha1 number i. There is
 * one fold, or two: the surfaces of each half judge a model of their own. */
typedef struct judge_all {
  size_t surfaces, count, folds;
  judge_angles *angles;
} judge_all;

/* What is to be judged: a wall and a diameter, and how large a judge: so many independent surfaces
 * of points x points (a power of two), or an even number of pieces of a map. */
typedef struct judge_case judge_case;
struct judge_case {
  aspi_gauss wall;
  double d_p;
  size_t surfaces, points;
  /* One of the surfaces, periodic; NULL: a Gaussian one. */
  asp_map *(*make)(const judge_case *subject, const double step[2], size_t points, uint32_t seed);
  const asp_map *map; /* NULL: generated surfaces */
};

/* The half of the map, cut across its longer side, that holds the first pieces or the others; NULL
 * on error. */
asp_map *judge_half(const asp_map *map, size_t half, asp_error *error);

/* The least impact angle, in degrees, that the pieces of a map with those numbers can tell. */
double judge_angle_least(const judge_case *subject, double s_q, double lambda_c);

/* Generates the surfaces, with 20 points a correlation length along either side, rolls the sphere
 * over each, and sends `rays` particles a surface at each of the angles (rad) along x, half of them
 * either way, until they leave. The pieces of a map go on as their mirror images, and the particles
 * fly over them in all directions. Exits on an error. */
judge_all judge_create(const judge_case *subject, const cli_list *angles, size_t rays,
                       uint32_t seed);
void judge_free(judge_all *all);

/* A number with its standard error over the surfaces. */
typedef struct judge_value {
  double value, se;
} judge_value;

/* D_KL(surfaces || model) of one of the histograms (its offset in judge_angles) at alpha1 number
 * i, the mean over the folds, each with its model, by the jackknife over the surfaces, which takes
 * out the bias of finite samples, less that of the model's. */
judge_value judge_divergence(const judge_all *all, size_t i, const judge_angles *models,
                             size_t histogram);

/* The surfaces' mean of one of the sums, per impact. */
judge_value judge_mean(const judge_all *all, size_t i, size_t sum);

#endif
