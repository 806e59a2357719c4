/* The geometry itself, hit by hit: every particle falls on the dilated wall at a random place and
 * is followed over it until it leaves (flight.h). Exact for the heights of a measured profile or
 * map and the diameters that it is prepared for; a particle in between uses one of the two
 * neighboring diameters, the nearer one more often.
 *
 * A Gaussian wall gets a generated profile with the rms slope of the ensemble, and its negative;
 * half of the particles fly over each of them backwards. This represents the ensemble better than
 * one flight over a profile eight times as long.
 *
 * In space a profile is one cut of a wall that is alike in all directions: after a hit the flight
 * continues at another place of that cut (places.h), and the path of a disc is scaled to that of a
 * sphere.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "spread/flight.h"
#include "spread/models.h"
#include "spread/places.h"
#include "surface/rolling.h"
#include "surface/size_law.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* A generated profile: 8192 lambda_c. Particles that skip along its valleys meet its facets: with
 * 32 points a lambda_c a fifth more of fast ones stick. */
enum { PER_LAMBDA = 64, POINTS = 1 << 19 };
#define SEED 1

/* Most points of a field over a map, and points per correlation length. */
enum { MAP_POINTS = 1 << 18, MAP_PER_LAMBDA = 64 };

/* A dilated wall, and the index of its places where flights move. */
typedef struct relief {
  aspi_field field;
  aspi_row_places places;
} relief;

typedef struct fields {
  aspi_sizes sizes;
  bool is_map;
  double lay; /* of a map: direction from x to y */
  bool moves; /* in space over a profile: flights that turn continue elsewhere (places.h) */
  bool generated;
  int fields; /* of a size: of a map 1, of each profile, or of the generated one and its negative */
  relief wall[]; /* of each size, one after the other */
} fields;

static void release(void *data) {
  fields *t = data;
  for (int i = 0; i < t->sizes.bins * t->fields; i++) {
    aspi_field_free(&t->wall[i].field);
    aspi_row_places_free(&t->wall[i].places);
  }
  free(t);
}

/* All points of a small map; every second, third ... point of a larger one; only the middle of an
 * even larger one. */
static aspi_grid grid_of(const asp_heights *map, const asp_surface *surface) {
  const size_t side[2] = {map->columns, map->rows};
  aspi_grid g = {.stride = 1};
  if (map->rows == 1) /* a profile is used as a whole */
    return g;
  double step = aspi_heights_extent(map).spacing, lambda = asp_surface_lambda_c(surface);
  while (side[0] / g.stride * (side[1] / g.stride) > MAP_POINTS &&
         (double)(g.stride + 1) * step <= lambda / MAP_PER_LAMBDA)
    g.stride++;
  double points = (double)(side[0] / g.stride) * (double)(side[1] / g.stride);
  for (int a = 0; a < 2; a++) {
    g.count[a] = (size_t)((double)(side[a] / g.stride) * fmin(1, sqrt(MAP_POINTS / points)));
    g.first[a] = (side[a] - g.count[a] * g.stride) / 2;
  }
  return g;
}

/* The field of a wall for one size; `made`: a generated profile, which is smooth, or NULL. */
static asp_code fill(aspi_field *field, const aspi_height_field *of, const asp_heights *made,
                     double d_p, int number, asp_error *error) {
  if (of->heights) {
    const asp_heights *one = of->heights;
    while (number-- > 0)
      one = one->next;
    const aspi_grid grid = grid_of(one, of->surface);
    return aspi_field_create(field, one, d_p, &grid, error);
  }
  asp_heights *path = aspi_profile_rolled(made, d_p, 1, error);
  asp_code code = path ? aspi_field_create(field, path, 0, NULL, error) : error->code;
  asp_heights_free(path);
  return code;
}

/* The same for flights in space: the path of a disc is steeper than that of a sphere. */
static asp_code fill_one(fields *t, const aspi_height_field *of, const asp_heights *made,
                         int number, int bin, asp_error *error) {
  relief *wall = &t->wall[t->fields * bin + number];
  double d_p = aspi_sizes_at(&t->sizes, bin);
  asp_code code = fill(&wall->field, of, made, d_p, number, error);
  if (code || !t->moves)
    return code;
  double ratio = aspi_sphere_over_disc(asp_surface_kappa(of->surface, d_p));
  if (ratio < 1)
    aspi_field_scale(&wall->field, ratio);
  return aspi_row_places_create(&wall->places, &wall->field, error);
}

/* The fields of all sizes over a map or a profile, or over a generated one (0) or its negative (1).
 */
static asp_code fill_all(fields *t, const aspi_height_field *of, int number, asp_error *error) {
  asp_heights *made = NULL;
  if (!of->heights) {
    double r_q, lambda_c;
    aspi_surface_gaussian(of->surface, t->sizes.most, &r_q, &lambda_c);
    made = aspi_profile_generate_scaled(r_q, lambda_c, lambda_c / PER_LAMBDA, POINTS, SEED,
                                        number ? -1 : 1, error);
    if (!made)
      return error->code;
  }
  asp_code code = ASP_OK;
  for (int i = 0; i < t->sizes.bins && !code; i++)
    code = fill_one(t, of, made, number, i, error);
  asp_heights_free(made);
  return code;
}

static void *prepare(const aspi_height_field *of, const aspi_sizes *sizes, asp_error *error) {
  bool generated = !of->heights, is_map = !generated && of->heights->rows > 1;
  asp_heights_numbers d = {0};
  if (aspi_sizes_check(sizes, error) || (is_map && asp_heights_describe(of->heights, &d, error)))
    return NULL;
  int number = generated ? 2 : 0, bins = sizes->bins;
  for (const asp_heights *one = of->heights; one; one = one->next)
    number++;
  if (generated && asp_surface_kappa(of->surface, sizes->most) < ASPI_KAPPA_NO_FILTER)
    bins = 1; /* all sizes meet the same slopes */
  fields *t = calloc(1, sizeof *t + (size_t)(bins * number) * sizeof *t->wall);
  if (!t)
    return aspi_fail_null(error, ASP_ENOMEM, "out of memory for %d dilated walls", bins * number);
  *t = (fields){{sizes->least, sizes->most, bins}, is_map,    d.lay,
                of->in_space && !is_map,           generated, number};
  for (int i = 0; i < number; i++)
    if (fill_all(t, of, i, error)) {
      release(t);
      return NULL;
    }
  return t;
}

/* One of several profiles, by their lengths; *u: the share of all, becomes that of this one. */
static int choose(const relief *wall, int count, double *u) {
  double all = 0;
  int i = 0;
  for (int k = 0; k < count; k++)
    all += aspi_field_length(&wall[k].field, 0);
  for (*u *= all; i + 1 < count && *u >= aspi_field_length(&wall[i].field, 0); i++)
    *u -= aspi_field_length(&wall[i].field, 0);
  *u = fmin(*u / aspi_field_length(&wall[i].field, 0), 1 - DBL_EPSILON);
  return i;
}

/* Puts the particle over the wall; over generated profiles, in either direction. */
static void enter(const fields *t, const aspi_spread_input *input, aspi_stream *stream,
                  aspi_path *path) {
  double u = aspi_stream_uniform(stream), v = 0;
  path->begun = true;
  path->field = t->fields * aspi_sizes_draw(&t->sizes, input->d_p, stream);
  if (t->is_map) {
    v = aspi_stream_uniform(stream);
    path->azimuth = input->has_azimuth ? t->lay - ASP_PI / 2 + input->azimuth
                                       : 2 * ASP_PI * aspi_stream_uniform(stream);
  } else if (t->generated) {
    int way = (int)(4 * u);
    u = 4 * u - way;
    path->field += way % 2;
    path->back = way / 2;
  } else if (t->fields > 1)
    path->field += choose(&t->wall[path->field], t->fields, &u);
  path->spot = aspi_field_enter(&t->wall[path->field].field, u, v);
}

/* Moves to a place whose slope is the last face's slope along the new flight; returns by how much
 * its slope is too small. */
static double move(const relief *wall, aspi_stream *stream, aspi_path *path) {
  double x = cos(path->turn), slope = path->p * x + path->q * sin(path->turn);
  bool alike = aspi_stream_uniform(stream) < x * x;
  return aspi_row_places_move(&wall->places, &wall->field, slope, alike, &path->spot, &path->back);
}

static bool trace_hit(const aspi_spread_input *input, aspi_stream *stream, aspi_path *path,
                      double *delta) {
  const fields *t = input->data;
  double shear =
      0; /* added to all slopes, so that the particle leaves the new face at the same angle */
  if (!path->begun)
    enter(t, input, stream, path);
  else if (t->moves)
    shear = move(&t->wall[path->field], stream, path);
  else
    path->azimuth += path->turn;
  const aspi_field *field = &t->wall[path->field].field;
  double x = t->is_map ? cos(path->azimuth) : path->back ? -1 : 1;
  double y = t->is_map ? sin(path->azimuth) : 0, along = cos(input->alpha1),
         fall = sin(input->alpha1);
  if (!path->spot.lies)
    fall = fmax(fall, field->fall_least * along);
  double gradient[2];
  const double way[3] = {along * x, along * y, -fall - shear * along};
  if (!aspi_field_next(field, way, &path->spot, gradient))
    return false;
  path->p = gradient[0] * x + gradient[1] * y + shear;
  *delta = atan(path->p);
  path->q = gradient[1] * x - gradient[0] * y;
  return true;
}

static const aspi_field *field_of(const void *data, int bin, int part) {
  const fields *t = data;
  return part < t->fields ? &t->wall[t->fields * bin + part].field : NULL;
}

const asp_spread_model aspi_spread_traced = {
    .name = "traced",
    .summary = "the particle followed over the heights of the wall, hit by hit",
    .source = "geometry",
    .geometry = true,
    .covers_rising = true,
    .prepare = prepare,
    .release = release,
    .follow = trace_hit,
    .field = field_of,
};
