/* The geometry itself, hit by hit: every particle falls on the profile at a place of its own and is
 * followed over it until it leaves. Nothing is modelled but the profile, whose faces are those of
 * the disc nearest in size among the bins. Slow, and exact. */
#include "base/error.h"
#include "spread/models.h"
#include "spread/trace.h"

#include <stdlib.h>

typedef struct tracks {
  aspi_sizes sizes;
  aspi_track *track[]; /* one a bin */
} tracks;

static void release(void *data) {
  tracks *t = data;
  for (int i = 0; i < t->sizes.bins; i++)
    aspi_track_free(t->track[i]);
  free(t);
}

static void *prepare(const asp_profile *profile, const aspi_sizes *sizes, asp_error *error) {
  if (aspi_sizes_check(sizes, error))
    return NULL;
  size_t bins = (size_t)sizes->bins;
  tracks *t = calloc(1, sizeof *t + bins * sizeof *t->track);
  if (!t) {
    aspi_fail(error, ASP_ENOMEM, "out of memory for %d tracks", sizes->bins);
    return NULL;
  }
  t->sizes = *sizes;
  for (int i = 0; i < sizes->bins; i++) {
    t->track[i] = aspi_track_create(profile, aspi_sizes_at(sizes, i), error);
    if (!t->track[i]) {
      release(t);
      return NULL;
    }
  }
  return t;
}

static bool follow(const aspi_view *view, aspi_stream *stream, aspi_path *path, double *delta) {
  const tracks *t = view->data;
  const aspi_track *track = t->track[aspi_sizes_nearest(&t->sizes, view->d_p)];
  if (!path->begun)
    aspi_track_enter(track, aspi_stream_uniform(stream), path);
  return aspi_track_next(track, view->alpha1, path, delta);
}

static bool loop(const aspi_view *view, aspi_stream *stream, double *delta) {
  aspi_path path = {0};
  return follow(view, stream, &path, delta);
}

const asp_spread_model aspi_spread_traced = {
    .name = "traced",
    .summary = "the profile itself, followed hit by hit; slow and exact",
    .source = "geometry",
    .cost = 7,
    .upward = true,
    .loop = loop,
    .prepare = prepare,
    .release = release,
    .follow = follow,
};
