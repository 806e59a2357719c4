/* asperity trade: speed against accuracy. Every model on one wall, at several impact angles,
 * against an ensemble of such walls, none of which has made a model: what an impact costs, how far
 * the law of the first hit and that of the final rebound are off.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/trade.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Defaults. */
enum { PROFILES_MANY = 16, SURFACES_MANY = 8, POINTS_MANY = 2048 };

/* Length of a piece of a measured profile in lambda_c, unless there would be too few pieces. */
#define PIECE_LENGTH 25.0

static double sd_of(double square, double mean) {
  return sqrt(fmax(0, square - mean * mean));
}

/* Adds the columns of three dimensions to a row. */
static void add_lateral(const aspi_judge *judge, size_t i, const aspi_angles *model, size_t groups,
                        const aspi_angles *sum, trade_row *row) {
  aspi_angle_groups all = aspi_judge_groups(judge, i);
  double own = sum->lateral_sum / sum->n;
  double side = aspi_angles_mean(all, offsetof(aspi_angles, lateral_sum)).value;
  double square = aspi_angles_mean(all, offsetof(aspi_angles, lateral_square)).value;
  row->first_hit =
      aspi_judge_divergence(judge, i, model, groups, offsetof(aspi_angles, tilt)).value;
  row->lateral = aspi_judge_divergence(judge, i, model, groups, offsetof(aspi_angles, lateral));
  row->lateral_mean = (trade_pair){own, side};
  row->lateral_sd = (trade_pair){sd_of(sum->lateral_square / sum->n, own), sd_of(square, side)};
  row->later =
      (trade_pair){sum->later / sum->n, aspi_angles_mean(all, offsetof(aspi_angles, later)).value};
}

/* One row: a model at one angle. */
static trade_row judge_at(const aspi_judge_case *subject, const aspi_judge *judge,
                          const aspi_judge_model *model, double angle, size_t i) {
  size_t groups;
  aspi_angles *angles = aspi_judge_model_rebounds(subject, model, angle, &groups), sum = {0};
  if (!angles)
    cli_fail("out of memory for %zu groups of rebounds", groups);
  for (size_t g = 0; g < groups; g++)
    aspi_angles_merge(&sum, &angles[g]);
  aspi_estimate kl =
      aspi_judge_divergence(judge, i, angles, groups, offsetof(aspi_angles, rebound));
  aspi_estimate mean =
      aspi_angles_mean(aspi_judge_groups(judge, i), offsetof(aspi_angles, rebound_sum));
  trade_row row = {.angle = angle,
                   .cost = aspi_judge_cost(model->on[0], subject->d_p, angle),
                   .rebound = {kl.value, kl.se, sum.rebound_sum / sum.n, mean.value},
                   .space = !judge->first,
                   .reference_se = mean.se};
  if (judge->first)
    row.first_hit = aspi_judge_first_hit(&judge->first[i], model, subject->d_p, angle);
  else
    add_lateral(judge, i, angles, groups, &sum, &row);
  free(angles);
  return row;
}

static void show_progress(void *context, double share) {
  cli_progress_show(context, share);
}

/* All rows, angle by angle. */
static void judge_all(const cli_option *options, const cli_list *angles, aspi_judge_case *subject,
                      trade_row *rows) {
  bool multiple = cli_choice(&options[COLLISIONS], "single", "multiple");
  size_t models = (size_t)asp_spread_count();
  aspi_judge_walls walls;
  aspi_judge judge;
  asp_error error;
  cli_progress progress = cli_progress_begin("ensemble", 1);
  subject->progress = show_progress;
  subject->context = &progress;
  if (aspi_judge_walls_create(&walls, subject, &error) ||
      aspi_judge_create(&judge, subject, &walls, angles->values, angles->count, &error))
    cli_bad_file(NULL, &error);
  cli_progress_end(&progress);
  progress = cli_progress_begin("models", (double)models);
  for (size_t m = 0; m < models; m++) {
    const asp_spread_model *of = asp_spread_at((int)m);
    aspi_judge_model model;
    if (aspi_judge_model_create(&model, &walls, subject->d_p, asp_spread_name(of), multiple,
                                &error))
      cli_bad_file(NULL, &error);
    for (size_t i = 0; i < angles->count; i++) {
      trade_row *row = &rows[i * models + m];
      *row = judge_at(subject, &judge, &model, angles->values[i], i);
      row->model = of;
    }
    aspi_judge_model_free(&model);
    cli_progress_show(&progress, (double)m + 1);
  }
  cli_progress_end(&progress);
  aspi_judge_free(&judge);
  aspi_judge_walls_free(&walls);
}

static void print_row(FILE *out, const trade_row *r) {
  fprintf(out, "%s,%g,%.1f,", asp_spread_name(r->model), r->angle, r->cost);
  if (isfinite(r->first_hit))
    fprintf(out, "%.5f", r->first_hit);
  fprintf(out, ",%.5f,%.5f,%.4f,%.4f", r->rebound.kl, r->rebound.se, r->rebound.mean,
          r->rebound.reference_mean);
  if (r->space)
    fprintf(out, ",%.4f,%.5f,%.5f,%.4f,%.4f,%.4f,%.4f,%.5f,%.5f", r->reference_se, r->lateral.value,
            r->lateral.se, r->lateral_mean.model, r->lateral_mean.judge, r->lateral_sd.model,
            r->lateral_sd.judge, r->later.model, r->later.judge);
  fputc('\n', out);
}

/* In three dimensions model by model, else angle by angle. */
static void print(FILE *out, const trade_row *rows, size_t n) {
  size_t models = (size_t)asp_spread_count(), angles = n / models;
  bool space = rows->space;
  fprintf(out,
          "model,alpha1_deg,ns_per_impact,kl_first_hit,kl_rebound,kl_rebound_se,mean_rebound_deg,"
          "mean_rebound_reference_deg%s\n",
          space ? ",mean_rebound_reference_se_deg,kl_lateral,kl_lateral_se,mean_lateral_deg,"
                  "mean_lateral_reference_deg,sd_lateral_deg,sd_lateral_reference_deg,later_share,"
                  "later_share_reference"
                : "");
  for (size_t i = 0; i < n; i++)
    print_row(out, &rows[space ? i % angles * models + i / angles : i]);
}

/* Takes out the angles that pieces of a measured wall are too short for. */
static void drop_grazing(const cli_option *option, cli_list *angles, double least) {
  size_t kept = 0;
  for (size_t i = 0; i < angles->count; i++)
    if (angles->values[i] >= least)
      angles->values[kept++] = angles->values[i];
  if (kept == 0)
    cli_bad_usage("--%s is '%s'; some must be over %.2g degrees, the least that pieces of this "
                  "wall can judge",
                  option->name, option->value, least);
  if (kept < angles->count)
    cli_warn("--%s: those under %.2g degrees are left out; the pieces of the measured wall are "
             "too short to judge there",
             option->name, least);
  angles->count = kept;
}

/* Number of pieces, an even one; about `usual` of them by default. */
static size_t pieces_of(const cli_option *option, double usual) {
  if (!option->value)
    return (size_t)fmin(fmax(2 * floor(usual / 2), ASPI_JUDGES_LEAST), PROFILES_MANY);
  size_t pieces = cli_whole(option, ASPI_JUDGES_LEAST, ASPI_JUDGES_MOST);
  if (pieces % 2)
    cli_bad_usage("--%s is '%s'; of a measured wall it must be even, half of the pieces in "
                  "each half of it",
                  option->name, option->value);
  return pieces;
}

/* Exits if an option is given that does not apply to this judge. */
static void check_options(const cli_option *o, const asp_wall *wall) {
  const char *kind = asp_wall_word(wall, "surface");
  bool map = strcmp(kind, "map") == 0, solid = map || o[THREE_D].value;
  if (strcmp(kind, "smooth") == 0)
    cli_bad_usage("'surface' is missing; models are judged on a rough wall");
  if (o[THREE_D].value && strcmp(kind, "profile") == 0)
    cli_bad_usage("--three-d is given with 'surface profile'; it goes with a map, or a wall's "
                  "numbers");
  if (map && o[POINTS].value)
    cli_bad_usage("--points is given with 'surface map', which has its own");
  if (solid && o[PROFILES].value)
    cli_bad_usage("--profiles is given with %s, which takes --surfaces",
                  map ? "'surface map'" : "--three-d");
  if (!solid && (o[SURFACES].value || o[POINTS].value))
    cli_bad_usage("--%s is given without --three-d or 'surface map'",
                  o[SURFACES].value ? "surfaces" : "points");
}

static void drop_grazing_of(const cli_option *options, const aspi_judge_case *subject,
                            cli_list *angles) {
  double least;
  asp_error error;
  if (aspi_judge_angle_least(subject, &least, &error))
    cli_bad_file(NULL, &error);
  drop_grazing(&options[ANGLES], angles, least);
}

/* Sets the case in three dimensions; takes out the angles at which it cannot be judged. */
static void set_case_3d(const cli_option *options, const cli_description *wall, cli_list *angles,
                        aspi_judge_case *subject) {
  const asp_surface *surface = asp_wall_surface(wall->wall);
  double vector[3];
  const double *lay = cli_description_lay(wall, vector);
  subject->points = options[POINTS].value ? cli_whole(&options[POINTS], 256, 16384) : POINTS_MANY;
  if (subject->points & (subject->points - 1))
    cli_bad_usage("--points is %zu; it must be a power of two", subject->points);
  subject->wall.lambda_2 = asp_surface_lambda_along(surface);
  subject->wall.axis = lay ? atan2(lay[1], lay[0]) - ASP_PI / 2 : 0;
  subject->map = wall->map;
  subject->groups =
      options[SURFACES].value ? cli_whole(&options[SURFACES], 3, 1000) : SURFACES_MANY;
  if (!wall->map)
    return;
  subject->groups = pieces_of(&options[SURFACES], 0);
  drop_grazing_of(options, subject, angles);
}

/* The same in the plane of incidence. */
static void set_case_2d(const cli_option *options, const cli_description *wall, cli_list *angles,
                        aspi_judge_case *subject) {
  if (asp_wall_lay(wall->wall).kind != ASP_LAY_NONE)
    cli_bad_usage("'lay' is given; a wall with a lay is judged with --three-d");
  subject->groups = options[PROFILES].value
                        ? cli_whole(&options[PROFILES], ASPI_JUDGES_LEAST, ASPI_JUDGES_MOST)
                        : PROFILES_MANY;
  subject->profile = wall->profile;
  if (!wall->profile)
    return;
  double length = (double)asp_profile_points(wall->profile) * asp_profile_spacing(wall->profile);
  subject->groups = pieces_of(&options[PROFILES], length / subject->wall.lambda_1 / PIECE_LENGTH);
  drop_grazing_of(options, subject, angles);
}

static aspi_judge_case case_of(const cli_option *options, const cli_description *wall, double d_p,
                               cli_list *angles) {
  const asp_surface *surface = asp_wall_surface(wall->wall);
  aspi_judge_case subject = {
      .wall = {.r_q = asp_surface_r_q(surface), .lambda_1 = asp_surface_lambda_c(surface)},
      .d_p = d_p,
      .rays = cli_whole(&options[RAYS], 1000, 1000000000),
      .seed = (uint32_t)asp_wall_get(wall->wall, "seed")};
  (options[THREE_D].value || wall->map ? set_case_3d : set_case_2d)(options, wall, angles,
                                                                    &subject);
  return subject;
}

/* A diameter for a wall that is the same for all of them, and the most that the seed may be. */
#define ANY_SIZE 1e-5
#define SEED_MOST 1000000

static cli_description read_wall(const cli_option *options, int count, char **words, double *d_p) {
  cli_description wall = cli_description_read(count, words);
  cli_description_allow(&wall, "surface seed", "every model is judged, by specular rebounds");
  check_options(options, wall.wall);
  bool any = strcmp(asp_wall_word(wall.wall, "surface"), "sigma") == 0 && !options[DP].value;
  *d_p = any ? ANY_SIZE : cli_length(&options[DP]);
  if (asp_wall_get(wall.wall, "seed") > SEED_MOST)
    cli_bad_usage("seed is %.0f; it must be at most %d, as each profile has one of its own",
                  asp_wall_get(wall.wall, "seed"), SEED_MOST);
  cli_description_make(&wall, *d_p, *d_p);
  return wall;
}

static int run(int argc, char **argv) {
  cli_option options[N + 1] = {
      [DP] = {"dp", "LENGTH", "diameter of the particles", NULL},
      [ANGLES] = {"angles", "DEGREES", "impact angles: a list", "2,5,10,20,45,80"},
      [RAYS] = {"rays", "N", "impacts per model and angle", "200000"},
      [PROFILES] = {"profiles", "N",
                    "profiles of 2048 lambda_c that judge [16], or pieces of a measured one", NULL},
      [COLLISIONS] = {"collisions", "single|multiple", "one hit, or as many as it takes",
                      "multiple"},
      [THREE_D] = {"three-d", NULL, "isotropic: judged by surfaces in three dimensions", NULL},
      [SURFACES] = {"surfaces", "N",
                    "of --three-d: independent surfaces that judge [8]; pieces of a map [4]", NULL},
      [POINTS] = {"points", "N", "of --three-d: points along a side, 20 a lambda_c [2048]", NULL},
      [OUTPUT] = CLI_OUTPUT_OPTION,
      CLI_PLOT_OPTIONS(PLOT, "draw cost against divergence; .png, .svg or .pdf"),
  };
  int words = cli_words(argc, argv);
  cli_parse(&cli_trade, argc - words, argv + words, options, false);
  double d_p;
  cli_list angles = cli_angles(&options[ANGLES]);
  cli_description wall = read_wall(options, words, argv + 1, &d_p);
  size_t most = angles.count * (size_t)asp_spread_count();
  trade_row *rows = cli_allocate(most, sizeof *rows);
  aspi_judge_case subject = case_of(options, &wall, d_p, &angles);
  judge_all(options, &angles, &subject, rows);
  most = angles.count * (size_t)asp_spread_count();
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, wall.text);
  print(cli_output_stream(output), rows, most);
  cli_output_close(output);
  if (options[PLOT].value)
    cli_trade_plot(options, &wall, d_p, rows, most);
  free(rows);
  cli_description_free(&wall);
  return 0;
}

const cli_command cli_trade = {
    .name = "trade",
    .summary = "speed against accuracy: every model against the geometry",
    .arguments = "DESCRIPTION",
    .detail =
        "A row per model and impact angle. The reference follows specular particles over an\n"
        "ensemble of generated profiles, hit by hit; no model was made from any of them.\n"
        "kl_first_hit and kl_rebound are in bins of one degree; a bin that the model cannot fill\n"
        "counts as 1e-6, or half an impact. kl_rebound is free of the bias of histograms, and\n"
        "kl_rebound_se is its standard error, by the jackknife over the profiles; more --profiles\n"
        "and --rays make it smaller.\n"
        "Of a measured profile the pieces of one half of it judge what is made of the other half, "
        "and "
        "the\n"
        "other way round: so no model is judged by heights that made it.\n"
        "With --three-d the reference are independent Gaussian surfaces on which a sphere rolls,\n"
        "none of which made a model; every model takes `isotropic`. --rays counts per surface.\n"
        "All D_KL are then sampled, with the standard error over the surfaces (jackknife). Of a "
        "map\n"
        "pieces of one half of the map judge what is made of the other, in all directions.\n",
    .examples = "  $ asperity trade surface rq 5um lambda_c 40um --dp 10um --plot trade.png\n",
    .run = run,
};
