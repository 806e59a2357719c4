/* The geometry itself, hit by hit: every particle falls on the profile at a random place and is
 * followed over it until it leaves. Faces are those of the disc nearest in size among the bins.
 * Slow, and exact for its profile.
 *
 * A Gaussian wall without a profile gets a generated one with the rms slope of the ensemble, and
 * its negative; half of the particles fly over each of them backwards. This represents the ensemble
 * better than one flight over a profile eight times as long.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/error.h"
#include "spread/models.h"
#include "spread/trace.h"
#include "surface/closing.h"
#include "surface/profile.h"

#include <math.h>
#include <stdlib.h>

/* A generated profile: 16 384 lambda_c. */
enum { PER_LAMBDA = 32, POINTS = 1 << 19 };
#define SEED 1

/* Below this kappa all sizes are of one bin. */
#define KAPPA_NO_FILTER 0.08

typedef struct tracks {
  aspi_sizes sizes;
  int profiles;        /* 1, or 2: the generated one and its negative */
  aspi_track *track[]; /* a bin's, for each profile */
} tracks;

static void release(void *data) {
  tracks *t = data;
  for (int i = 0; i < t->sizes.bins * t->profiles; i++)
    aspi_track_free(t->track[i]);
  free(t);
}

/* Room for the tracks, still empty. */
static tracks *allot(int profiles, const aspi_sizes *sizes, asp_error *error) {
  if (aspi_sizes_check(sizes, error))
    return NULL;
  size_t count = (size_t)(sizes->bins * profiles);
  tracks *t = calloc(1, sizeof *t + count * sizeof *t->track);
  if (!t) {
    aspi_fail(error, ASP_ENOMEM, "out of memory for %d tracks", (int)count);
    return NULL;
  }
  t->sizes = *sizes;
  t->profiles = profiles;
  return t;
}

static void *prepare(const asp_profile *profile, const aspi_sizes *sizes, asp_error *error) {
  tracks *t = allot(1, sizes, error);
  for (int i = 0; t && i < sizes->bins; i++) {
    t->track[i] = aspi_track_create(profile, aspi_sizes_at(sizes, i), error);
    if (!t->track[i]) {
      release(t);
      return NULL;
    }
  }
  return t;
}

/* The track of a disc on one of the generated profiles, which are smooth. */
static aspi_track *rolled(const asp_profile *profile, double d_p, asp_error *error) {
  asp_profile *path = aspi_profile_rolled(profile, d_p, 1, error);
  aspi_track *track = path ? aspi_track_create(path, 0, error) : NULL;
  asp_profile_free(path);
  return track;
}

/* Makes the tracks of the generated profile (sign 1), or of its negative (-1). */
static bool fill(tracks *t, const asp_surface *surface, int sign, asp_error *error) {
  double lambda_c = asp_surface_lambda_c(surface);
  asp_profile *profile = aspi_profile_create_scaled(
      asp_surface_r_q(surface), lambda_c, lambda_c / PER_LAMBDA, POINTS, SEED, sign, error);
  bool made = profile;
  for (int i = 0; made && i < t->sizes.bins; i++) {
    aspi_track **track = &t->track[2 * i + (sign < 0)];
    *track = rolled(profile, aspi_sizes_at(&t->sizes, i), error);
    made = *track;
  }
  asp_profile_free(profile);
  return made;
}

static void *generate(const asp_surface *surface, const aspi_sizes *sizes, asp_error *error) {
  tracks *t = allot(2, sizes, error);
  if (t && asp_surface_kappa(surface, sizes->most) < KAPPA_NO_FILTER)
    t->sizes.bins = 1;
  if (t && fill(t, surface, 1, error) && fill(t, surface, -1, error))
    return t;
  if (t)
    release(t);
  return NULL;
}

/* Puts the particle before one of the profiles; over generated ones, from either side. */
static void enter(const aspi_track *const track[], int profiles, double u, aspi_path *path) {
  int ways = profiles > 1 ? 2 * profiles : 1, way = (int)(ways * u);
  aspi_track_enter(track[way % profiles], fmax(ways * u - way, 0x1p-53), path);
  path->back = way / profiles;
  path->profile = way % profiles;
}

static bool follow(const aspi_view *view, aspi_stream *stream, aspi_path *path, double *delta) {
  const tracks *t = view->data;
  const aspi_track *const *track =
      (const aspi_track *const *)t->track + aspi_sizes_nearest(&t->sizes, view->d_p) * t->profiles;
  if (!path->begun)
    enter(track, t->profiles, aspi_stream_uniform(stream), path);
  return aspi_track_next(track[path->profile], view->alpha1, path, delta);
}

static bool loop(const aspi_view *view, aspi_stream *stream, double *delta) {
  aspi_path path = {0};
  return follow(view, stream, &path, delta);
}

const asp_spread_model aspi_spread_traced = {
    .name = "traced",
    .summary = "the particle followed over a profile, hit by hit: the reference",
    .source = "geometry",
    .geometry = true,
    .upward = true,
    .loop = loop,
    .prepare = prepare,
    .generate = generate,
    .release = release,
    .follow = follow,
};
