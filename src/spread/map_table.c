/* The tables of a map: of lines over it at equal angles from the axis across its lay, for spheres
 * of several sizes. A particle draws one of the two directions and one of the two sizes around its
 * own, the nearer one more often. Nothing here is Gaussian: the ellipse of the map's
 * autocorrelation only gives the lay, the number of directions, and the spacing of the lines.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/map_table.h"
#include "base/error.h"
#include "spread/map_lines.h"
#include "surface/describe.h"

#include <math.h>
#include <stdlib.h>

/* Directions around the circle, an even number: of a wall nearly without a lay, and of others. */
enum { DIRECTIONS_FEW = 8, DIRECTIONS_MANY = 36, POINTS = 400000 };
#define STRETCH_FEW 1.5

/* Points of a line per correlation length. */
#define PER_LAMBDA 16.0

struct aspi_map_table {
  aspi_sizes sizes;
  int directions;
  aspi_line_table *table[]; /* by size and direction */
};

void aspi_map_table_free(aspi_map_table *tables) {
  if (!tables)
    return;
  for (int i = 0; i < tables->sizes.bins * tables->directions; i++)
    aspi_line_table_free(tables->table[i]);
  free(tables);
}

/* The 1/e lag along a direction at this angle from the axis across the lay. */
static double lambda_at(const aspi_map_description *d, double angle) {
  return 1 / hypot(cos(angle) / d->lambda_1, sin(angle) / d->lambda_2);
}

static asp_code fill(aspi_map_table *tables, int size, const asp_map *map,
                     const aspi_map_description *d, asp_error *error) {
  aspi_ball *ball = aspi_ball_create(map, aspi_sizes_at(&tables->sizes, size), error);
  if (!ball)
    return error->code;
  int half = tables->directions / 2;
  asp_code code = ASP_OK;
  for (int k = 0; k < half && !code; k++) {
    double angle = ASP_PI * k / half;
    double step = fmax(lambda_at(d, angle) / PER_LAMBDA, fmin(map->step[0], map->step[1]));
    aspi_line_table *both[2];
    code = aspi_map_line_tables(ball, map, d->lay - ASP_PI / 2 + angle, step, POINTS / (size_t)half,
                                both, error);
    tables->table[size * tables->directions + k] = both[0];
    tables->table[size * tables->directions + k + half] = both[1];
  }
  aspi_ball_free(ball);
  return code;
}

aspi_map_table *aspi_map_table_create(const asp_map *map, const aspi_sizes *sizes,
                                      asp_error *error) {
  aspi_map_description d;
  asp_error own;
  error = error ? error : &own;
  if (aspi_sizes_check(sizes, error) || aspi_map_describe(map, &d, error))
    return NULL;
  int directions = d.lambda_2 < STRETCH_FEW * d.lambda_1 ? DIRECTIONS_FEW : DIRECTIONS_MANY;
  aspi_map_table *tables =
      calloc(1, sizeof *tables + (size_t)(sizes->bins * directions) * sizeof *tables->table);
  if (!tables) {
    aspi_fail(error, ASP_ENOMEM, "out of memory for the tables of a map");
    return NULL;
  }
  tables->sizes = *sizes;
  tables->directions = directions;
  for (int i = 0; i < sizes->bins; i++)
    if (fill(tables, i, map, &d, error)) {
      aspi_map_table_free(tables);
      return NULL;
    }
  return tables;
}

/* One of the two nodes around a place, the nearer one more often. */
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

static const aspi_line_table *table_of(const aspi_map_table *tables, int size, double azimuth,
                                       aspi_stream *stream) {
  int n = tables->directions, k = nearer(azimuth / (2 * ASP_PI) * n, stream) % n;
  return tables->table[size * n + (k < 0 ? k + n : k)];
}

/* The first face. On a wall without a lay the particle flies over the map in a random direction. */
static void first(const aspi_map_table *tables, const aspi_view *view, aspi_stream *stream,
                  aspi_path *path) {
  path->size = size_of(&tables->sizes, view->d_p, stream);
  path->azimuth = view->has_azimuth ? view->azimuth : 2 * ASP_PI * aspi_stream_uniform(stream);
  path->alpha_in = view->alpha1;
  const aspi_line_table *table = table_of(tables, path->size, path->azimuth, stream);
  path->face_class = aspi_line_table_first(table, view->alpha1, stream, &path->p, &path->q);
}

bool aspi_map_table_follow(const aspi_map_table *tables, const aspi_view *view, aspi_stream *stream,
                           aspi_path *path, double *delta) {
  if (!path->begun) {
    path->begun = true;
    first(tables, view, stream, path);
  } else {
    /* The turn of the flight at the face, and the face's slope along the new flight. */
    double turn = path->turn, azimuth = path->azimuth + turn, rise = tan(-view->alpha1);
    double slope = path->p * cos(turn) + path->q * sin(turn);
    bool back = cos(turn) < 0;
    if (view->alpha1 < 0 &&
        aspi_line_table_escapes(
            table_of(tables, path->size, back ? azimuth + ASP_PI : azimuth, stream),
            path->face_class, back ? -slope : slope, rise, back, stream))
      return false;
    path->face_class =
        aspi_line_table_next(table_of(tables, path->size, azimuth, stream), path->alpha_in,
                             -view->alpha1, stream, &path->p, &path->q);
    path->azimuth = azimuth;
    path->alpha_in = fmax(path->alpha_in, view->alpha1);
  }
  *delta = atan(path->p);
  return true;
}
