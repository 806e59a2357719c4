/* asperity spread: the law of the tilt delta_alpha, as samples, as a density, or in numbers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/spread.h"
#include "base/running.h"
#include "wall/wall.h"
#include "surface/size_law.h"

#include <gsl/gsl_sort.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { DP, ANGLES, SAMPLES, PDF, SUMMARY, LIST, OUTPUT, PLOT, N = PLOT + PLOT_OPTIONS };

/* A wall as a model looks at it. */
typedef struct scene {
  cli_description wall;
  const asp_spread_model *model;
  aspi_view view;
  bool shaped;  /* the law is there as a density, too */
  bool by_size; /* the wall is more than a sigma */
} scene;

static bool draw_face(const scene *s, const aspi_view *view, aspi_stream *stream, double *delta) {
  aspi_path path = {0};
  if (s->wall.wall->follow)
    return s->wall.wall->follow(view, stream, &path, delta);
  return aspi_spread_draw(s->model, view, stream, delta);
}

static double draw(const scene *s, const aspi_view *view, uint64_t sample) {
  uint32_t seed = (uint32_t)asp_wall_get(s->wall.wall, "seed");
  aspi_stream stream = aspi_stream_begin(&(asp_key){seed, asp_key_wall("spread"), sample, 1});
  double delta;
  if (!draw_face(s, view, &stream, &delta))
    cli_fail("model '%s' found no face for alpha1 = %g degrees", s->model->name,
             cli_degrees(view->alpha1));
  return delta;
}

/* lambda_across^2 over the square of the correlation length along the flight. */
static double part_of(const asp_surface *surface, const double lay[3]) {
  double ratio = asp_surface_lambda_c(surface) / asp_surface_lambda_along(surface);
  return 1 + (ratio * ratio - 1) * lay[0] * lay[0];
}

static aspi_view view_of(const cli_description *wall, double d_p) {
  const asp_surface *surface = asp_wall_surface(wall->wall);
  if (!surface)
    return aspi_view_of(0, 0);
  double vector[3] = {0, 1, 0};
  const double *lay = cli_description_lay(wall, vector);
  double part = lay ? part_of(surface, lay) : 1;
  double slope =
      lay ? aspi_surface_slope_along(surface, d_p, part) : asp_surface_slope(surface, d_p);
  aspi_view view = aspi_view_of(atan(slope), 0);
  view.kappa = asp_surface_kappa(surface, d_p) * part;
  view.phi_r = asp_surface_phi_r(surface) * sqrt(part);
  view.d_p = d_p;
  view.has_azimuth = lay;
  view.azimuth = lay ? ASP_PI / 2 - atan2(lay[1], lay[0]) : 0;
  return view;
}

/* A diameter for a wall that is the same for all of them. */
#define ANY_SIZE 1e-5

/* The view's impact angle is still to come. */
static scene scene_of(const cli_option *dp, int count, char **words) {
  static const char allowed[] = "surface spread seed";
  scene s = {.wall = cli_description_read(count, words)};
  cli_description_allow(&s.wall, allowed, "spread simulates no impact");
  const char *kind = asp_wall_word(s.wall.wall, "surface");
  s.by_size = strcmp(kind, "smooth") != 0 && strcmp(kind, "sigma") != 0;
  double d_p = s.by_size || dp->value ? cli_length(dp) : ANY_SIZE;
  asp_wall_choose(s.wall.wall, "tilt", "plane", NULL);
  cli_description_make(&s.wall, d_p, d_p);
  s.model = asp_wall_spread(s.wall.wall);
  s.view = view_of(&s.wall, d_p);
  s.view.data = s.wall.wall->data;
  s.shaped = s.model->density && !s.wall.wall->draws_q; /* that of a map is lines over it */
  return s;
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

static void fill(double *sample, size_t n, const scene *s, const aspi_view *view) {
  cli_progress progress = cli_progress_begin("sampling", (double)n);
  for (size_t i = 0; i < n; i++) {
    sample[i] = cli_degrees(draw(s, view, i));
    if (i % 65536 == 0)
      cli_progress_show(&progress, (double)i);
  }
  cli_progress_end(&progress);
}

static void one_angle(FILE *out, const cli_option *options, const scene *s, double angle,
                      size_t n) {
  aspi_view view = s->view;
  view.alpha1 = cli_radians(angle);
  if (options[PDF].value) {
    print_density(out, s->model, &view);
    if (!options[PLOT].value)
      return;
  }
  double *sample = cli_allocate(n, sizeof *sample);
  fill(sample, n, s, &view);
  if (options[PLOT].value)
    cli_spread_plot(&options[PLOT], s->model, s->shaped, s->wall.wall, s->by_size, &view, sample,
                    n);
  if (options[SUMMARY].value)
    print_summary(out, s->model, &view, sample, n);
  else if (!options[PDF].value)
    for (size_t i = 0; i < n; i++)
      fprintf(out, "%.8g\n", sample[i]);
  free(sample);
}

static void print_law(const cli_option *options, const scene *s, FILE *out) {
  cli_list angles = cli_angles(&options[ANGLES]);
  size_t n = cli_whole(&options[SAMPLES], 1, 100000000);
  if (options[SUMMARY].value)
    fputs("model,alpha1_deg,mean_deg,sd_deg,p05_deg,p50_deg,p95_deg\n", out);
  else if (!options[PDF].value)
    fputs("delta_alpha_deg\n", out);
  for (size_t i = 0; i < angles.count; i++)
    one_angle(out, options, s, angles.values[i], n);
}

static void check_options(const cli_option *o) {
  if (cli_angles(&o[ANGLES]).count > 1 && (!o[SUMMARY].value || o[PLOT].value))
    cli_bad_usage("--angles is '%s'; more than one angle goes with --summary, without --plot",
                  o[ANGLES].value);
  cli_whole(&o[SAMPLES], 1, 100000000);
  if (o[PDF].value && o[SUMMARY].value)
    cli_bad_usage("--pdf is given with --summary; it must be one of them");
}

static int run(int argc, char **argv) {
  cli_option options[N + 1] = {
      [DP] = {"dp", "LENGTH", "the particle's diameter; with 'surface sigma' of no account", NULL},
      [ANGLES] = {"angles", "DEGREES", "impact angle, 0 to 90; with --summary a list", "30"},
      [SAMPLES] = {"samples", "N", "how many draws", "10000"},
      [PDF] = {"pdf", NULL, "print the density instead of samples", NULL},
      [SUMMARY] = {"summary", NULL, "print mean, sd and percentiles of the samples", NULL},
      [LIST] = {"list", NULL, "list the models", NULL},
      [OUTPUT] = CLI_OUTPUT_OPTION,
      CLI_PLOT_OPTIONS(PLOT, "draw histogram and density; .png, .svg or .pdf"),
  };
  int words = cli_words(argc, argv);
  cli_parse(&cli_spread, argc - words, argv + words, options, false);
  if (options[LIST].value) {
    cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, NULL);
    print_list(cli_output_stream(output));
    cli_output_close(output);
    return 0;
  }
  check_options(options);
  scene s = scene_of(&options[DP], words, argv + 1);
  if (options[PDF].value && !s.shaped)
    cli_bad_usage("--pdf: model '%s' has no density%s", s.model->name,
                  s.model->density ? " on a map" : "");
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, s.wall.text);
  print_law(options, &s, cli_output_stream(output));
  cli_output_close(output);
  cli_description_free(&s.wall);
  return 0;
}

const cli_command cli_spread = {
    .name = "spread",
    .summary = "how the tilt of the face that a particle hits is distributed",
    .arguments = "DESCRIPTION",
    .detail =
        "Draws delta_alpha in the plane of incidence for a wall and an impact angle, or prints\n"
        "its density. Of the description 'surface', 'spread' and 'seed' count: a wall by its\n"
        "numbers is as a profile along the flight has it, over a map spheres fly in all\n"
        "directions.\n",
    .examples = "  $ asperity spread surface sigma 10 --angles 20 --plot spread.png -o spread.csv\n"
                "  $ asperity spread --list\n",
    .run = run,
};
