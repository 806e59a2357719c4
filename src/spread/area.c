/* The laws of a map: of lines over it at equal angles around the axis across its lay, for spheres
 * of a row of sizes. A particle draws from those of the two directions and the two sizes that it is
 * between, from the nearer one more often. Nothing here is Gaussian; the ellipse of the map's
 * autocorrelation only says where its lay is, how many directions there must be, and how fine the
 * lines.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/area.h"
#include "base/error.h"
#include "spread/courses.h"
#include "surface/map_describe.h"

#include <math.h>
#include <stdlib.h>

/* Directions around the circle, even: of a wall with hardly a lay, and of any other. */
enum { DIRECTIONS_FEW = 8, DIRECTIONS_MANY = 36, POINTS = 400000 };
#define STRETCH_FEW 1.5

/* Points of a line to a correlation length. */
#define PER_LAMBDA 16.0

struct aspi_area {
  aspi_sizes sizes;
  int directions;
  aspi_law *law[]; /* by size and direction */
};

void aspi_area_free(aspi_area *area) {
  if (!area)
    return;
  for (int i = 0; i < area->sizes.bins * area->directions; i++)
    aspi_law_free(area->law[i]);
  free(area);
}

/* The 1/e lag along a direction, that far from the axis across the lay. */
static double lambda_at(const aspi_map_description *d, double angle) {
  return 1 / hypot(cos(angle) / d->lambda_1, sin(angle) / d->lambda_2);
}

static asp_code fill(aspi_area *area, int size, const asp_map *map, const aspi_map_description *d,
                     asp_error *error) {
  aspi_ball *ball = aspi_ball_create(map, aspi_sizes_at(&area->sizes, size), error);
  if (!ball)
    return error->code;
  int half = area->directions / 2;
  asp_code code = ASP_OK;
  for (int k = 0; k < half && !code; k++) {
    double angle = ASP_PI * k / half;
    double step = fmax(lambda_at(d, angle) / PER_LAMBDA, fmin(map->step[0], map->step[1]));
    aspi_law *both[2];
    code = aspi_courses_laws(ball, map, d->lay - ASP_PI / 2 + angle, step, POINTS / (size_t)half,
                             both, error);
    area->law[size * area->directions + k] = both[0];
    area->law[size * area->directions + k + half] = both[1];
  }
  aspi_ball_free(ball);
  return code;
}

aspi_area *aspi_area_create(const asp_map *map, const aspi_sizes *sizes, asp_error *error) {
  aspi_map_description d;
  asp_error own;
  error = error ? error : &own;
  if (aspi_sizes_check(sizes, error) || aspi_map_describe(map, &d, error))
    return NULL;
  int directions = d.lambda_2 < STRETCH_FEW * d.lambda_1 ? DIRECTIONS_FEW : DIRECTIONS_MANY;
  aspi_area *area =
      calloc(1, sizeof *area + (size_t)(sizes->bins * directions) * sizeof *area->law);
  if (!area) {
    aspi_fail(error, ASP_ENOMEM, "out of memory for the laws of a map");
    return NULL;
  }
  area->sizes = *sizes;
  area->directions = directions;
  for (int i = 0; i < sizes->bins; i++)
    if (fill(area, i, map, &d, error)) {
      aspi_area_free(area);
      return NULL;
    }
  return area;
}

/* One of two neighbours, the nearer one more often. */
static int nearer(double place, aspi_stream *stream) {
  double below = floor(place);
  return (int)below + (aspi_stream_uniform(stream) < place - below);
}

static int size_of(const aspi_sizes *sizes, double d_p, aspi_stream *stream) {
  double span = log(sizes->most / sizes->least);
  if (sizes->bins < 2 || !(span > 0))
    return 0;
  double part = fmin(fmax(log(d_p / sizes->least) / span, 0), 1);
  int size = nearer(part * (sizes->bins - 1), stream);
  return size < sizes->bins ? size : sizes->bins - 1;
}

static const aspi_law *law_of(const aspi_area *area, int size, double azimuth,
                              aspi_stream *stream) {
  int n = area->directions, k = nearer(azimuth / (2 * ASP_PI) * n, stream) % n;
  return area->law[size * n + (k < 0 ? k + n : k)];
}

/* The first face of a particle that comes in. Without a lay in the wall, it flies over the map in
 * any direction. */
static void first(const aspi_area *area, const aspi_view *view, aspi_stream *stream,
                  aspi_path *path) {
  path->size = size_of(&area->sizes, view->d_p, stream);
  path->azimuth = view->has_azimuth ? view->azimuth : 2 * ASP_PI * aspi_stream_uniform(stream);
  path->came = view->alpha1;
  const aspi_law *law = law_of(area, path->size, path->azimuth, stream);
  path->kind = aspi_law_first(law, view->alpha1, stream, &path->p, &path->q);
}

bool aspi_area_follow(const aspi_area *area, const aspi_view *view, aspi_stream *stream,
                      aspi_path *path, double *delta) {
  if (!path->begun) {
    path->begun = true;
    first(area, view, stream, path);
  } else {
    /* How far the flight has turned on the face, and the face's slope along it. */
    double turn = path->turn, azimuth = path->azimuth + turn, rise = tan(-view->alpha1);
    double slope = path->p * cos(turn) + path->q * sin(turn);
    bool back = cos(turn) < 0;
    if (view->alpha1 < 0 &&
        aspi_law_leaves(law_of(area, path->size, back ? azimuth + ASP_PI : azimuth, stream),
                        &path->kind, back ? -slope : slope, rise, back, stream))
      return false;
    path->kind = aspi_law_next(law_of(area, path->size, azimuth, stream), path->came, -view->alpha1,
                               stream, &path->p, &path->q);
    path->azimuth = azimuth;
    path->came = fmax(path->came, view->alpha1);
  }
  *delta = atan(path->p);
  return true;
}
