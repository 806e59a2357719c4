/* The geometry itself, hit by hit: every particle falls on the profile at a place of its own and is
 * followed over it until it leaves. Nothing is modelled but the profile, whose faces are those of
 * the disc nearest in size among the bins. Slow, and exact. */
#include "base/error.h"
#include "spread/models.h"
#include "spread/trace.h"

#include <stdlib.h>

typedef struct tracks {
  asp_sizes sizes;
  asp_track *track[]; /* one a bin */
} tracks;

static void release(void *data) {
  tracks *t = data;
  for (int i = 0; i < t->sizes.bins; i++)
    asp_track_free(t->track[i]);
  free(t);
}

static void *prepare(const asp_profile *profile, const asp_sizes *sizes, asp_error *error) {
  if (asp_sizes_check(sizes, error))
    return NULL;
  size_t bins = (size_t)sizes->bins;
  tracks *t = calloc(1, sizeof *t + bins * sizeof *t->track);
  if (!t) {
    asp_fail(error, ASP_ENOMEM, "out of memory for %d tracks", sizes->bins);
    return NULL;
  }
  t->sizes = *sizes;
  for (int i = 0; i < sizes->bins; i++) {
    t->track[i] = asp_track_create(profile, asp_sizes_at(sizes, i), error);
    if (!t->track[i]) {
      release(t);
      return NULL;
    }
  }
  return t;
}

static bool follow(const asp_view *view, asp_stream *stream, asp_path *path, double *delta) {
  const tracks *t = view->data;
  const asp_track *track = t->track[asp_sizes_nearest(&t->sizes, view->d_p)];
  if (!path->begun)
    asp_track_enter(track, asp_stream_uniform(stream), path);
  return asp_track_next(track, view->alpha1, path, delta);
}

static bool loop(const asp_view *view, asp_stream *stream, double *delta) {
  asp_path path = {0};
  return follow(view, stream, &path, delta);
}

const asp_spread_model asp_spread_traced = {
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
