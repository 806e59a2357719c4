/* Models against the geometry; see measure.h. */
#include "cli/measure.h"
#include "impact/wall.h"

#include <math.h>
#include <stdlib.h>

/* The profile that judges: 4096 lambda_c at 128 points each. Much coarser, a disc of many lambda_c
 * rolls over single points, and its slopes come in steps that a degree's bin can see. */
#define RESOLUTION 128
#define POINTS 524288

/* Probability of a bin that a model leaves empty, in a comparison without sampling. */
#define LEAST_SHARE 1e-6

measure_case measure_case_create(double r_q, double lambda_c, double d_p, uint32_t seed) {
  asp_error error;
  measure_case b = {.d_p = d_p};
  b.profile = asp_profile_create(r_q, lambda_c, lambda_c / RESOLUTION, POINTS, seed, &error);
  if (b.profile)
    b.surface = asp_surface_create_profile(b.profile, d_p, d_p, 1, &error);
  if (b.surface)
    b.track = aspi_track_create(b.profile, d_p, &error);
  if (!b.track)
    cli_fail("%s", error.text);
  return b;
}

void measure_case_free(measure_case *subject) {
  aspi_track_free(subject->track);
  asp_surface_free(subject->surface);
  asp_profile_free(subject->profile);
}

asp_wall *measure_wall(const measure_case *subject, const char *model, bool multiple) {
  asp_error error;
  asp_wall *wall = asp_wall_create(&error);
  if (!wall)
    cli_fail("%s", error.text);
  asp_wall_choose(wall, "rebound", "constant", NULL);
  asp_wall_choose(wall, "spread", model, NULL);
  asp_wall_choose(wall, "collisions", multiple ? "multiple" : "single", NULL);
  asp_wall_set(wall, "deposit", 0, NULL);
  asp_wall_set(wall, "d_p_least", subject->d_p, NULL);
  asp_wall_set(wall, "d_p_most", subject->d_p, NULL);
  asp_wall_set_surface(wall, subject->surface);
  asp_wall_set_profile(wall, subject->profile);
  if (asp_wall_prepare(wall, &error))
    cli_bad_usage("%s", error.text);
  return wall;
}

static const double up[3] = {0, 0, 1};

static void hit(const asp_wall *wall, double d_p, const double v1[3], uint32_t seed, uint64_t tag,
                asp_impact *impact) {
  asp_particle particle = {d_p, 1, NULL, {0, 0, 0}};
  asp_wall_impact(wall, &particle, v1, up, &(asp_key){seed, 1, tag, 1}, impact);
}

measure_angles measure_rebounds(const asp_wall *wall, double d_p, double alpha1, size_t n,
                                uint32_t seed) {
  measure_angles all = {.n = (double)n};
  double v1[3] = {cos(alpha1), 0, -sin(alpha1)};
#pragma omp parallel
  {
    measure_angles mine = {.n = 0};
#pragma omp for schedule(static)
    for (size_t i = 0; i < n; i++) {
      asp_impact impact;
      hit(wall, d_p, v1, seed, i, &impact);
      double angle = cli_degrees(asp_impact_coefficients(v1, up, &impact).alpha2);
      int bin = (int)angle;
      mine.count[bin < MEASURE_BINS ? bin : MEASURE_BINS - 1]++;
      mine.mean += angle / (double)n;
      mine.later += (impact.hits > 1) / (double)n;
    }
#pragma omp critical
    {
      for (int i = 0; i < MEASURE_BINS; i++)
        all.count[i] += mine.count[i];
      all.mean += mine.mean;
      all.later += mine.later;
    }
  }
  return all;
}

double measure_cost(const asp_wall *wall, double d_p, double alpha1) {
  enum { RUNS = 12, IMPACTS = 2000 };
  double least = INFINITY, v1[3] = {cos(alpha1), 0, -sin(alpha1)};
  for (int run = 0; run < RUNS; run++) {
    double begun = cli_seconds();
    asp_impact impact;
    for (uint64_t i = 0; i < IMPACTS; i++)
      hit(wall, d_p, v1, 77, i, &impact);
    least = fmin(least, cli_seconds() - begun);
  }
  return 1e9 * least / IMPACTS;
}

double measure_divergence(const measure_angles *reference, const measure_angles *other) {
  double sum = 0, bins = 0;
  for (int i = 0; i < MEASURE_BINS; i++) {
    double p = reference->count[i] / reference->n;
    if (!(p > 0))
      continue;
    sum += p * log(p * other->n / fmax(other->count[i], 0.5));
    bins++;
  }
  return sum - (bins - 1) / 2 * (1 / reference->n + 1 / other->n);
}

/* The shares of the track's first hits in bins of one degree, from -90 to 90. */
static void exact_shares(const aspi_track *track, double alpha1, double *share) {
  size_t n = aspi_track_faces(track);
  double *weight = malloc(n * sizeof *weight);
  if (!weight)
    cli_fail("out of memory");
  aspi_track_first_hit(track, alpha1, weight);
  for (int i = 0; i < MEASURE_BINS; i++)
    share[i] = 0;
  for (size_t i = 0; i < n; i++)
    if (weight[i] > 0)
      share[(int)floor(cli_degrees(atan(aspi_track_face_slope(track, i)))) + 90] += weight[i];
  free(weight);
}

double measure_first_hit(const measure_case *subject, const asp_wall *wall, double alpha1) {
  const asp_spread_model *model = wall->spread;
  if (!model->distribution)
    return NAN;
  double slope = aspi_track_slope_rms(subject->track), share[MEASURE_BINS], sum = 0;
  aspi_view view = {slope, atan(slope), alpha1, subject->d_p, wall->data};
  exact_shares(subject->track, alpha1, share);
  for (int i = 0; i < MEASURE_BINS; i++) {
    if (!(share[i] > 0))
      continue;
    double low = cli_radians(i - 90), high = cli_radians(i - 89);
    double p = model->distribution(&view, high) - model->distribution(&view, low);
    sum += share[i] * log(share[i] / fmax(p, LEAST_SHARE));
  }
  return sum;
}
