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
  SIGMA,
  RQ,
  LAMBDA_C,
  LAY,
  DP,
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

static aspi_stream stream_of(const cli_option *options, uint64_t sample) {
  uint32_t seed = (uint32_t)cli_whole(&options[SEED], 0, UINT32_MAX);
  return aspi_stream_begin(&(asp_key){seed, asp_key_wall("spread"), sample, 1});
}

static double draw(const asp_spread_model *model, const aspi_view *view, const cli_option *options,
                   uint64_t sample) {
  aspi_stream stream = stream_of(options, sample);
  double delta;
  if (!aspi_spread_draw(model, view, &stream, &delta))
    cli_fail("model '%s' found no face for alpha1 = %g degrees", model->name,
             cli_degrees(view->alpha1));
  return delta;
}

/* What the model makes of a profile of the wall; lives as long as the command. */
static const void *data_of(const char *model, const asp_surface *surface, double d_p) {
  asp_error error;
  asp_wall *wall = asp_wall_create(&error);
  if (!wall)
    cli_fail("%s", error.text);
  asp_wall_choose(wall, "spread", model, NULL);
  asp_wall_set(wall, "d_p_least", d_p, NULL);
  asp_wall_set(wall, "d_p_most", d_p, NULL);
  asp_wall_set_surface(wall, surface);
  if (asp_wall_prepare(wall, &error))
    cli_bad_usage("%s", error.text);
  return wall->data;
}

/* The wall as the model looks at it; alpha1 is still to come. */
static aspi_view view_of(const cli_option *options, const asp_spread_model *model) {
  if (options[SIGMA].value && !model->generate)
    return aspi_view_of(cli_radians(cli_number(&options[SIGMA], 0, 89)), 0);
  if (!options[RQ].value || !options[LAMBDA_C].value || !options[DP].value)
    cli_bad_usage("spread: give %s--rq, --lambda-c and --dp%s",
                  model->generate ? "" : "--sigma, or ",
                  model->generate ? "; the model looks at a profile" : "");
  cli_lay lay = cli_lay_of(&options[LAMBDA_C], &options[LAY]);
  asp_surface *surface = cli_surface_of(&options[RQ], &lay);
  double d_p = cli_length(&options[DP]);
  cli_check_size(surface, d_p);
  double slope = lay.part < 1 || lay.part > 1 ? aspi_surface_slope_along(surface, d_p, lay.part)
                                              : asp_surface_slope(surface, d_p);
  aspi_view view = aspi_view_of(atan(slope), 0);
  view.kappa = asp_surface_kappa(surface, d_p) * lay.part;
  view.d_p = d_p;
  if (model->generate)
    view.data = data_of(model->name, surface, d_p);
  return view;
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

static void fill(double *sample, size_t n, const asp_spread_model *model, const aspi_view *view,
                 const cli_option *options) {
  cli_progress progress = cli_progress_begin("sampling", (double)n);
  for (size_t i = 0; i < n; i++) {
    sample[i] = cli_degrees(draw(model, view, options, i));
    if (i % 65536 == 0)
      cli_progress_show(&progress, (double)i);
  }
  cli_progress_end(&progress);
}

static void one_angle(FILE *out, const cli_option *options, const asp_spread_model *model,
                      aspi_view view, double angle, size_t n) {
  view.alpha1 = cli_radians(angle);
  if (options[PDF].value) {
    print_density(out, model, &view);
    if (!options[PLOT].value)
      return;
  }
  double *sample = malloc(n * sizeof *sample);
  if (!sample)
    cli_fail("out of memory for %zu samples", n);
  fill(sample, n, model, &view, options);
  if (options[PLOT].value)
    cli_spread_plot(&options[PLOT], model, &view, sample, n);
  if (options[SUMMARY].value)
    print_summary(out, model, &view, sample, n);
  else if (!options[PDF].value)
    for (size_t i = 0; i < n; i++)
      fprintf(out, "%.8g\n", sample[i]);
  free(sample);
}

static int run(int argc, char **argv) {
  cli_option options[N + 1] = {
      [MODEL] = {"model", "NAME", "spread model; --list shows them", "visible"},
      [SIGMA] = {"sigma", "DEGREES", "the wall as sigma = atan(s_eff) ...", NULL},
      [RQ] = {"rq", "LENGTH", "... or by its rms height,", NULL},
      [LAMBDA_C] = {"lambda-c", "LENGTHS", "its correlation length; with a lay two: across,along",
                    NULL},
      [LAY] = CLI_LAY_OPTION,
      [DP] = {"dp", "LENGTH", "and the particle's diameter", NULL},
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
  asp_error error;
  const asp_spread_model *model = asp_spread_find(options[MODEL].value, &error);
  if (!model)
    cli_bad_usage("--model: %s", error.text);
  cli_list angles = cli_angles(&options[ANGLE]);
  if (angles.count > 1 && (!options[SUMMARY].value || options[PLOT].value))
    cli_bad_usage("--angle is '%s'; more than one angle goes with --summary, without --plot",
                  options[ANGLE].value);
  if (options[PDF].value && !model->density)
    cli_bad_usage("--pdf: model '%s' has no density", model->name);
  size_t samples = cli_whole(&options[SAMPLES], 1, 100000000);
  aspi_view view = {0};
  if (!options[LIST].value)
    view = view_of(options, model);
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, &options[SEED]);
  FILE *out = cli_output_stream(output);
  if (options[LIST].value) {
    print_list(out);
  } else {
    if (options[SUMMARY].value)
      fputs("model,alpha1_deg,mean_deg,sd_deg,p05_deg,p50_deg,p95_deg\n", out);
    else if (!options[PDF].value)
      fputs("delta_alpha_deg\n", out);
    for (size_t i = 0; i < angles.count; i++)
      one_angle(out, options, model, view, angles.values[i], samples);
  }
  cli_output_close(output);
  return 0;
}

const cli_command cli_spread = {
    .name = "spread",
    .summary = "how the tilt of the face that a particle hits is distributed",
    .detail =
        "Draws delta_alpha for a wall and an impact angle, or prints its density. The wall is\n"
        "--sigma, or --rq, --lambda-c and --dp, as a profile along the flight has it.\n",
    .run = run,
};
