/* The tables of a map: of lines over it at equal angles from the axis across its lay, for spheres
 * of several sizes. A particle draws one of the two directions and one of the two sizes around its
 * own, the nearer one more often. Nothing here is Gaussian: the ellipse of the map's
 * autocorrelation only gives the lay, the number of directions, and the spacing of the lines.
 *
 * A particle in straight flight stays in a vertical plane, so its first hit, its escape and its
 * next hit in the same direction depend only on the line under it. Lines of one azimuth, joined end
 * to end, make a long line with the statistics of the map.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "spread/map_table.h"
#include "base/error.h"
#include "surface/describe.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- lines at one azimuth ---- */

/* The golden section: its multiples modulo 1 spread evenly, for any number of them. */
#define GOLDEN 0.6180339887498949

/* Clips the straight line through (x, y) to the map: t from [0] to [1]. False: it passes by. */
static bool clip(const asp_map *map, double x, double y, double ex, double ey, double t[2]) {
  const double at[2] = {x, y}, way[2] = {ex, ey};
  const double side[2] = {(double)(map->columns - 1) * map->step[0],
                          (double)(map->rows - 1) * map->step[1]};
  t[0] = -INFINITY;
  t[1] = INFINITY;
  for (int k = 0; k < 2; k++) {
    if (!(fabs(way[k]) > 1e-12)) {
      if (at[k] < 0 || at[k] > side[k])
        return false;
      continue;
    }
    double a = -at[k] / way[k], b = (side[k] - at[k]) / way[k];
    t[0] = fmax(t[0], fmin(a, b));
    t[1] = fmin(t[1], fmax(a, b));
  }
  return t[1] > t[0];
}

/* Points of the lines so far. */
typedef struct joined {
  float *z, *p, *q;
  size_t count, room;
} joined;

/* Points at both ends that are searched for the best place to join two lines. */
enum { JOINT = 64 };

/* Cuts the end of the last line and the beginning of the one at `first` where they agree best in
 * height and slope, over their rms values, so that a flight from one to the other meets no step. */
static void join(joined *c, size_t first, const double rms[2]) {
  size_t ahead = c->count - first < JOINT ? c->count - first : JOINT, end = first, begin = first;
  size_t behind = first < JOINT ? first : JOINT;
  double least = INFINITY;
  for (size_t i = first - behind + 1; i < first; i++)
    for (size_t k = first; k < first + ahead; k++) {
      double dz = (c->z[k] - c->z[i]) / rms[0], dp = (c->p[k] - c->p[i]) / rms[1];
      if (dz * dz + dp * dp < least) {
        least = dz * dz + dp * dp;
        end = i;
        begin = k;
      }
    }
  size_t kept = c->count - begin;
  memmove(c->z + end, c->z + begin, kept * sizeof *c->z);
  memmove(c->p + end, c->p + begin, kept * sizeof *c->p);
  memmove(c->q + end, c->q + begin, kept * sizeof *c->q);
  c->count = end + kept;
}

/* Fills one line after the other, until the room is full. */
static void lay(const aspi_ball *ball, const asp_map *map, double azimuth, double step,
                double apart, const double rms[2], joined *c) {
  double ex = cos(azimuth), ey = sin(azimuth);
  double width = (double)(map->columns - 1) * map->step[0];
  double height = (double)(map->rows - 1) * map->step[1];
  double half = 0.5 * (fabs(ey) * width + fabs(ex) * height);
  size_t lines = (size_t)ceil(2 * half / apart);
  for (size_t k = 0; k < lines; k++) {
    /* Offset from the middle, each line within its own strip of the width. */
    double part = fmod(GOLDEN * (double)(k + 1), 1);
    double off = -half + apart * ((double)k + part), t[2];
    double x = 0.5 * width - off * ey, y = 0.5 * height + off * ex;
    if (!clip(map, x, y, ex, ey, t))
      continue;
    size_t first = c->count;
    aspi_ball_search search = aspi_ball_begin(ball);
    for (double s = t[0]; s < t[1] && c->count < c->room; s += step) {
      aspi_touch touch = aspi_ball_at(&search, x + s * ex, y + s * ey);
      c->z[c->count] = (float)touch.height;
      c->p[c->count] = (float)(ex * touch.p + ey * touch.q);
      c->q[c->count++] = (float)(ex * touch.q - ey * touch.p);
    }
    if (first > 0 && c->count > first)
      join(c, first, rms);
  }
}

/* Turns the slopes across the line, for a flight the other way. */
static void turn(float *q, size_t n) {
  for (size_t i = 0; i < (n + 1) / 2; i++) {
    float keep = q[i];
    q[i] = -q[n - 1 - i];
    q[n - 1 - i] = -keep;
  }
}

asp_code aspi_map_line_tables(const aspi_ball *ball, const asp_map *map, double azimuth,
                              double step, size_t points, const double rms[2],
                              aspi_line_table *tables[2], asp_error *error) {
  double area = (double)(map->columns - 1) * map->step[0] * (double)(map->rows - 1) * map->step[1];
  double apart = area / (step * (double)points);
  joined c = {.room = points + points / 4};
  c.z = malloc(c.room * sizeof *c.z);
  c.p = malloc(c.room * sizeof *c.p);
  c.q = malloc(c.room * sizeof *c.q);
  asp_code code = ASP_OK;
  tables[0] = tables[1] = NULL;
  if (!c.z || !c.p || !c.q)
    code = aspi_fail(error, ASP_ENOMEM, "out of memory for lines of %zu points over a map", points);
  if (!code)
    lay(ball, map, azimuth, step, apart, rms, &c);
  for (int way = 0; way < 2 && !code; way++) {
    aspi_line line;
    code = aspi_line_create(&line, c.count, step, error);
    if (code)
      break;
    aspi_line_set(&line, c.z, c.p, way ? -1 : 1);
    if (way)
      turn(c.q, c.count);
    tables[way] = aspi_line_table_create(&line, c.q, error);
    code = tables[way] ? ASP_OK : ASP_ENOMEM;
    aspi_line_free(&line);
  }
  if (code) {
    aspi_line_table_free(tables[0]);
    tables[0] = NULL;
  }
  free(c.z);
  free(c.p);
  free(c.q);
  return code;
}

/* ---- all of them ---- */

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
static double lambda_at(const asp_map_numbers *d, double angle) {
  return 1 / hypot(cos(angle) / d->lambda_1, sin(angle) / d->lambda_2);
}

static asp_code fill(aspi_map_table *tables, int size, const asp_map *map, const asp_map_numbers *d,
                     asp_error *error) {
  aspi_ball *ball = aspi_ball_create(map, aspi_sizes_at(&tables->sizes, size), error);
  if (!ball)
    return error->code;
  const double rms[2] = {d->s_q, d->s_dq / sqrt(2)}; /* slopes along one direction */
  int half = tables->directions / 2;
  asp_code code = ASP_OK;
  for (int k = 0; k < half && !code; k++) {
    double angle = ASP_PI * k / half;
    double step = fmax(lambda_at(d, angle) / PER_LAMBDA, fmin(map->step[0], map->step[1]));
    aspi_line_table *both[2];
    code = aspi_map_line_tables(ball, map, d->lay - ASP_PI / 2 + angle, step, POINTS / (size_t)half,
                                rms, both, error);
    tables->table[size * tables->directions + k] = both[0];
    tables->table[size * tables->directions + k + half] = both[1];
  }
  aspi_ball_free(ball);
  return code;
}

aspi_map_table *aspi_map_table_create(const asp_map *map, const aspi_sizes *sizes,
                                      asp_error *error) {
  asp_map_numbers d;
  asp_error own;
  error = error ? error : &own;
  if (aspi_sizes_check(sizes, error) || asp_map_describe(map, &d, error))
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
