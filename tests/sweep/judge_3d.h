/* The judge in three dimensions: rebounds from independent surfaces, for the divergences of
 * analysis/judge.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "analysis/judge.h"
#include "gauss_map.h"
#include "spread/flight.h"
#include "surface/heights.h"

/* The surfaces, of `points` x `points` points, 20 a correlation length, and the rays over each. */
typedef struct surfaces surfaces;
struct surfaces {
  gauss_wall wall;
  double d_p;
  size_t groups, rays, points; /* points: a power of two */
  uint32_t seed;
  /* A smooth wall with the law of each hit, for particles of this density and speed; those that
   * stick do not count as rebounds. NULL: hits are specular. */
  const asp_wall *law;
  double density, speed;
  /* Makes one, periodic; NULL: a Gaussian one. */
  asp_heights *(*make)(const surfaces *subject, const double step[2], size_t points, uint32_t seed);
};

/* A sphere is rolled over each surface; the particles fly along x, half of them either way, until
 * they leave. The judge has no first hits. */
asp_code judge_in_space(aspi_judge *judge, const surfaces *subject, const double *degrees,
                        size_t count, asp_error *error);

/* A line over a wall, along which a particle flies toward larger x: face i is straight, has the
 * slope[i] of the contact at point i, and ends at (end_x, end_z)[i], between the points i and
 * i + 1. */
typedef struct line {
  size_t n;
  double step;
  double *slope, *end_x, *end_z;
} line;

asp_code line_create(line *made, size_t n, double step, asp_error *error);
void line_free(line *made);

/* The share of a beam that first hits each face, into weight[n], sum 1: what the face adds to the
 * running maximum of g = z + x fall, in the second of two periods. */
void line_first_hits(const line *over, double fall, double *weight);

/* Sets a line of field->columns points to a row of a field with gradients, for flights along x (way
 * 1) or against it (-1). The faces have the slopes of the contacts, not of the differences between
 * points: two neighbors' tangents cross in between, on a smooth piece in the middle and at a kink
 * where the kink is. */
void line_over_row(line *over, const aspi_field *field, size_t row, int way);

/* A place on a line. */
typedef struct line_spot {
  size_t face;
  double x, z;
} line_spot;

/* Points of first hit for the given places in the beam: shares of a period from 0 to 1,
 * ascending. */
void line_hits(const line *over, double fall, const double *share, size_t count, line_spot *spots);
