/* asperity spread: the law of the tilt delta_alpha, as samples, as a density, or in numbers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/spread.h"
#include "base/running.h"
#include "cli/walls.h"
#include "impact/wall.h"
#include "surface/size_law.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>

#include <stdlib.h>

enum {
  MODEL,
  ROUGH,
  DP = ROUGH + ROUGH_OPTIONS,
  ANGLE,
  SAMPLES,
  SEED,
  PDF,
  SUMMARY,
  LIST,
  OUTPUT,
  PLOT,
  N
};

/* A wall as a model looks at it. */
typedef struct scene {
  const asp_spread_model *model;
  cli_rough rough; /* of no surface where sigma says all */
  asp_wall *wall;  /* NULL where the model needs no data */
  aspi_view view;
  bool shaped;  /* the law is there as a density, too */
  bool by_size; /* the wall is more than a sigma */
} scene;

static bool draw_face(const scene *s, const aspi_view *view, aspi_stream *stream, double *delta) {
  aspi_path path = {0};
  if (s->wall && s->wall->follow)
    return s->wall->follow(view, stream, &path, delta);
  return aspi_spread_draw(s->model, view, stream, delta);
}

static double draw(const scene *s, const aspi_view *view, uint32_t seed, uint64_t sample) {
  aspi_stream stream = aspi_stream_begin(&(asp_key){seed, asp_key_wall("spread"), sample, 1});
  double delta;
  if (!draw_face(s, view, &stream, &delta))
    cli_fail("model '%s' found no face for alpha1 = %g degrees", s->model->name,
             cli_degrees(view->alpha1));
  return delta;
}

static aspi_view view_of(const cli_rough *rough, double d_p) {
  const asp_surface *surface = rough->surface;
  double part = rough->lay.part;
  double slope = part < 1 || part > 1 ? aspi_surface_slope_along(surface, d_p, part)
                                      : asp_surface_slope(surface, d_p);
  aspi_view view = aspi_view_of(atan(slope), 0);
  view.kappa = asp_surface_kappa(surface, d_p) * part;
  view.phi_r = asp_surface_phi_r(surface) * sqrt(part);
  view.d_p = d_p;
  return view;
}

/* Exits on a bad wall; the view's impact angle is still to come. */
static scene scene_of(const cli_option *options, const asp_spread_model *model) {
  scene s = {.model = model, .shaped = model->density};
  const cli_option *of = &options[ROUGH];
  cli_rough_check(of);
  if (of[ROUGH_SIGMA].value && !model->generate) {
    s.view = aspi_view_of(cli_radians(cli_number(&of[ROUGH_SIGMA], 0, 89)), 0);
    return s;
  }
  double d_p = cli_rough_size(of, &options[DP]);
  s.by_size = !of[ROUGH_SIGMA].value;
  s.rough = cli_rough_read(of, d_p, d_p);
  s.view = view_of(&s.rough, d_p);
  asp_error error;
  s.wall = asp_wall_create(&error);
  if (!s.wall)
    cli_fail("%s", error.text);
  asp_wall_choose(s.wall, "spread", model->name, NULL);
  cli_rough_put(&s.rough, s.wall, d_p, d_p);
  if (asp_wall_prepare(s.wall, &error))
    cli_bad_usage("%s", error.text);
  s.view.data = s.wall->data;
  s.view.has_azimuth = of[ROUGH_LAY].value;
  s.view.azimuth = ASP_PI / 2 - s.rough.lay.direction;
  s.shaped = s.shaped && !s.wall->draws_q; /* that of a map is lines over it */
  return s;
}

static void scene_free(scene *s) {
  asp_wall_free(s->wall);
  cli_rough_free(&s->rough);
}

static void print_list(FILE *out) {
  fputs("model,summary,source\n", out);
  for (int i = 0; i < asp_spread_count(); i++) {
    const asp_spread_model *model = asp_spread_at(i);
    fprintf(out, "%s,\"%s\",\"%s\"\n", model->name, model->summary, model->source);
  }
}

static void print_density(FILE *out, const asp_spread_model *model, const aspi_view *view) {
  fputs("delta_alpha_deg,density_per_deg\n", out);
  for (int i = -900; i <= 900; i++) {
    double density = model->density(view, cli_radians(0.1 * i)) * ASP_PI / 180;
    if (density > 0)
      fprintf(out, "%.1f,%.8g\n", 0.1 * i, density);
  }
}

static void print_summary(FILE *out, const asp_spread_model *model, const aspi_view *view,
                          double *sample, size_t n) {
  aspi_running all = {0, 0, 0};
  for (size_t i = 0; i < n; i++)
    aspi_running_add(&all, sample[i]);
  gsl_sort(sample, 1, n);
  fprintf(out, "%s,%g,%.6g,%.6g,%.6g,%.6g,%.6g\n", model->name, cli_degrees(view->alpha1), all.mean,
          aspi_running_sd(&all), gsl_stats_quantile_from_sorted_data(sample, 1, n, 0.05),
          gsl_stats_quantile_from_sorted_data(sample, 1, n, 0.5),
          gsl_stats_quantile_from_sorted_data(sample, 1, n, 0.95));
}

static void fill(double *sample, size_t n, const scene *s, const aspi_view *view, uint32_t seed) {
  cli_progress progress = cli_progress_begin("sampling", (double)n);
  for (size_t i = 0; i < n; i++) {
    sample[i] = cli_degrees(draw(s, view, seed, i));
    if (i % 65536 == 0)
      cli_progress_show(&progress, (double)i);
  }
  cli_progress_end(&progress);
}

/* How many samples of which seed. */
typedef struct sampling {
  size_t n;
  uint32_t seed;
} sampling;

static void one_angle(FILE *out, const cli_option *options, const scene *s, double angle,
                      const sampling *how) {
  aspi_view view = s->view;
  view.alpha1 = cli_radians(angle);
  if (options[PDF].value) {
    print_density(out, s->model, &view);
    if (!options[PLOT].value)
      return;
  }
  double *sample = cli_allocate(how->n, sizeof *sample);
  fill(sample, how->n, s, &view, how->seed);
  if (options[PLOT].value)
    cli_spread_plot(&options[PLOT], s->model, s->shaped, s->by_size ? s->rough.surface : NULL,
                    &view, sample, how->n);
  if (options[SUMMARY].value)
    print_summary(out, s->model, &view, sample, how->n);
  else if (!options[PDF].value)
    for (size_t i = 0; i < how->n; i++)
      fprintf(out, "%.8g\n", sample[i]);
  free(sample);
}

static void print_law(const cli_option *options, const asp_spread_model *model, int argc,
                      char **argv) {
  cli_list angles = cli_angles(&options[ANGLE]);
  if (angles.count > 1 && (!options[SUMMARY].value || options[PLOT].value))
    cli_bad_usage("--angle is '%s'; more than one angle goes with --summary, without --plot",
                  options[ANGLE].value);
  sampling how = {cli_whole(&options[SAMPLES], 1, 100000000),
                  (uint32_t)cli_whole(&options[SEED], 0, UINT32_MAX)};
  if (options[PDF].value && options[SUMMARY].value)
    cli_bad_usage("--pdf is given with --summary; it must be one of them");
  scene s = scene_of(options, model);
  if (options[PDF].value && !s.shaped)
    cli_bad_usage("--pdf: model '%s' has no density%s", model->name,
                  model->density ? " on a map" : "");
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, &options[SEED]);
  FILE *out = cli_output_stream(output);
  if (options[SUMMARY].value)
    fputs("model,alpha1_deg,mean_deg,sd_deg,p05_deg,p50_deg,p95_deg\n", out);
  else if (!options[PDF].value)
    fputs("delta_alpha_deg\n", out);
  for (size_t i = 0; i < angles.count; i++)
    one_angle(out, options, &s, angles.values[i], &how);
  cli_output_close(output);
  scene_free(&s);
}

static int run(int argc, char **argv) {
  cli_option options[N + 1] = {
      [MODEL] = {"model", "NAME",
                 "spread model; --list shows them [visible; of a measured wall profile]", NULL},
      CLI_ROUGH_OPTIONS(ROUGH),
      [DP] = {"dp", "LENGTH", "the particle's diameter; with --sigma of no account", NULL},
      [ANGLE] = {"angle", "DEGREES", "impact angle, 0 to 90; with --summary a list or a range",
                 "30"},
      [SAMPLES] = {"samples", "N", "how many draws", "10000"},
      [SEED] = {"seed", "N", "seed of the draws", "1"},
      [PDF] = {"pdf", NULL, "print the density instead of samples", NULL},
      [SUMMARY] = {"summary", NULL, "print mean, sd and percentiles of the samples", NULL},
      [LIST] = {"list", NULL, "list the models", NULL},
      [OUTPUT] = {"output", "FILE", "write there instead of to the screen", NULL},
      [PLOT] = {"plot", "FILE", "draw histogram and density; .png, .svg or .pdf", NULL},
  };
  cli_parse(&cli_spread, argc, argv, options, false);
  if (options[LIST].value) {
    cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, &options[SEED]);
    print_list(cli_output_stream(output));
    cli_output_close(output);
    return 0;
  }
  asp_error error;
  const asp_spread_model *model =
      asp_spread_find(cli_rough_model(&options[ROUGH], &options[MODEL]), &error);
  if (!model)
    cli_bad_usage("--model: %s", error.text);
  print_law(options, model, argc, argv);
  return 0;
}

const cli_command cli_spread = {
    .name = "spread",
    .summary = "how the tilt of the face that a particle hits is distributed",
    .detail =
        "Draws delta_alpha for a wall and an impact angle, or prints its density. The wall is\n"
        "--sigma, or --rq, --lambda-c and --dp, as a profile along the flight has it, or a "
        "measured\n"
        "--profile with --dp, or a --map, over which spheres fly in all directions.\n",
    .run = run,
};
