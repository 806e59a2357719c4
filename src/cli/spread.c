/* asperity spread: the law of the tilt delta_alpha, as samples, as a density, or in numbers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/description.h"
#include "cli/cli.h"
#include "description/description.h"
#include "surface/size_law.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SAMPLES_MOST = 100000000 };

/* Inputs of one spread model for one wall. */
typedef struct scene {
  cli_description wall;
  const asp_spread_model *model;
  aspi_spread_input input;
  bool by_size; /* the wall is more than a sigma */
} scene;

static double draw(const scene *s, const aspi_spread_input *input, uint64_t sample) {
  aspi_stream stream = aspi_stream_begin(
      &(asp_key){asp_wall_seed(s->wall.wall), asp_key_wall("spread"), sample, 1, 0});
  double delta;
  if (!aspi_spread_draw(s->model, input, &stream, &delta))
    cli_fail("model '%s' found no face for alpha1 = %g degrees", s->model->name,
             aspi_degrees(input->alpha1));
  return delta;
}

static aspi_spread_input input_of(const cli_description *wall, double d_p) {
  const asp_surface *surface = asp_wall_surface(wall->wall);
  if (!surface)
    return aspi_spread_input_of(0, 0);
  const double *lay = wall->wall->has_lay ? wall->wall->lay : NULL;
  double part = cli_description_shrink(wall, surface);
  double slope =
      lay ? aspi_surface_slope_along(surface, d_p, part) : asp_surface_slope(surface, d_p);
  aspi_spread_input input = aspi_spread_input_of(atan(slope), 0);
  input.kappa = asp_surface_kappa(surface, d_p) * part;
  input.phi_r = asp_surface_phi_r(surface) * sqrt(part);
  input.d_p = d_p;
  input.has_azimuth = lay;
  input.azimuth = lay ? ASP_PI / 2 - atan2(lay[1], lay[0]) : 0;
  return input;
}

/* A diameter for a wall that is the same for all of them. */
#define ANY_SIZE 1e-5

/* The input's impact angle is still to come. */
static scene scene_of(const cli_call *call) {
  const cli_option *dp = cli_get(call, "dp");
  scene s = {.wall = cli_description_read(call->n_words, call->words, false)};
  cli_description_allow(&s.wall, "surface spread seed", "spread simulates no impact");
  const char *kind = asp_description_word(s.wall.words, "surface");
  s.by_size = strcmp(kind, "smooth") != 0 && strcmp(kind, "sigma") != 0;
  double d_p = s.by_size || dp->value ? cli_length(dp) : ANY_SIZE;
  s.wall.words->choice.isotropic = false;
  cli_description_make(&s.wall, d_p, d_p);
  s.model = asp_wall_spread(s.wall.wall);
  s.input = input_of(&s.wall, d_p);
  s.input.data = s.wall.wall->data;
  return s;
}

static void print_density(FILE *out, const asp_spread_model *model,
                          const aspi_spread_input *input) {
  fputs("delta_alpha_deg,density_per_deg\n", out);
  for (int i = -900; i <= 900; i++) {
    double density = model->density(input, aspi_radians(0.1 * i)) * ASP_PI / 180;
    if (density > 0)
      fprintf(out, "%.1f,%.8g\n", 0.1 * i, density);
  }
}

static void print_summary(FILE *out, const asp_spread_model *model, const aspi_spread_input *input,
                          double *sample, size_t n) {
  const double mean = gsl_stats_mean(sample, 1, n), sd = n > 1 ? gsl_stats_sd(sample, 1, n) : 0;
  gsl_sort(sample, 1, n);
  fprintf(out, "%s,%g,%.6g,%.6g,%.6g,%.6g,%.6g\n", model->name, aspi_degrees(input->alpha1), mean,
          sd, gsl_stats_quantile_from_sorted_data(sample, 1, n, 0.05),
          gsl_stats_quantile_from_sorted_data(sample, 1, n, 0.5),
          gsl_stats_quantile_from_sorted_data(sample, 1, n, 0.95));
}

static void draw_sample(double *sample, size_t n, const scene *s, const aspi_spread_input *input) {
  cli_progress progress = cli_progress_begin("sampling", (double)n);
  for (size_t i = 0; i < n; i++) {
    sample[i] = aspi_degrees(draw(s, input, i));
    if (i % 65536 == 0)
      cli_progress_show(&progress, (double)i);
  }
  cli_progress_end(&progress);
}

static void one_angle(FILE *out, const cli_call *call, const scene *s, double angle, size_t n) {
  aspi_spread_input input = s->input;
  input.alpha1 = aspi_radians(angle);
  if (cli_value(call, "pdf")) {
    print_density(out, s->model, &input);
    return;
  }
  double *sample = cli_allocate(n, sizeof *sample);
  draw_sample(sample, n, s, &input);
  if (cli_value(call, "summary"))
    print_summary(out, s->model, &input, sample, n);
  for (size_t i = 0; i < n && !cli_value(call, "summary"); i++)
    fprintf(out, "%.8g\n", sample[i]);
  free(sample);
}

static void run(cli_call *call) {
  cli_list angles = cli_angles(cli_get(call, "angles"));
  bool pdf = cli_value(call, "pdf"), summary = cli_value(call, "summary");
  if (angles.count > 1 && !summary)
    cli_bad_usage("--angles is '%s'; more than one angle goes with --summary",
                  cli_value(call, "angles"));
  if (summary && cli_value(call, "plot"))
    cli_bad_usage("--plot is given with --summary; it draws samples, or the density of --pdf");
  size_t n = cli_whole(cli_get(call, "samples"), 1, SAMPLES_MOST);
  if (pdf && summary)
    cli_bad_usage("--pdf is given with --summary; it must be one of them");
  scene s = scene_of(call);
  if (pdf && !s.model->density)
    cli_bad_usage("--pdf: model '%s' has no density", s.model->name);
  cli_description_doubt_angles(&s.wall, &angles);
  FILE *out = cli_table_open(call, s.wall.text);
  if (summary)
    fputs("model,alpha1_deg,mean_deg,sd_deg,p05_deg,p50_deg,p95_deg\n", out);
  else if (!pdf)
    fputs("delta_alpha_deg\n", out);
  for (size_t i = 0; i < angles.count; i++)
    one_angle(out, call, &s, angles.values[i], n);
  cli_table_close(call, out, "spread");
}

static const cli_option options[] = {
    {"dp", "LENGTH", "diameter of the particle; no effect with 'surface sigma'", NULL},
    {"angles", "DEGREES", "impact angle, 0 to 90; with --summary a list", "30"},
    {"samples", "N", "number of draws", "10000"},
    {"pdf", NULL, "print the density instead of samples", NULL},
    {"summary", NULL, "print mean, sd and percentiles of the samples", NULL},
    {.name = NULL}};

const cli_command cli_spread = {
    .name = "spread",
    .summary = "the distribution of the tilt of the face that a particle hits",
    .arguments = "DESCRIPTION",
    .detail =
        "Draws delta_alpha in the plane of incidence for a wall and an impact angle, or prints\n"
        "its density. Only 'surface', 'spread' and 'seed' of the description count. A wall\n"
        "given by numbers is a profile along the flight. Over a map, spheres fly in all\n"
        "directions.\n",
    .examples =
        "  $ asperity spread surface sigma 10 --angles 20 --plot spread.png -o spread.csv\n",
    .options = options,
    .picture = "draw a histogram of the samples, or the density; .png, .svg or .pdf",
    .run = run,
};
