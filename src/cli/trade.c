/* asperity trade: speed against accuracy. Every model on one wall, at several impact angles,
 * against an ensemble of such walls, none of which has made a model: what an impact costs, how far
 * the law of the first hit and that of the final rebound are off.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/trade.h"
#include "cli/grid.h"
#include "cli/measure.h"
#include "cli/trade_3d.h"
#include "cli/walls.h"

#include <math.h>
#include <stdlib.h>

/* The rows of one model, one an angle, asp_spread_count() apart. */
static void judge(const measure_case *subject, const asp_surface *surface,
                  const asp_spread_model *model, const measure_reference *references,
                  const cli_list *angles, bool multiple, trade_row *rows) {
  asp_wall *wall = measure_wall(subject, surface, asp_spread_name(model), multiple);
  for (size_t i = 0; i < angles->count; i++)
    rows[i * (size_t)asp_spread_count()] =
        (trade_row){.model = model,
                    .angle = angles->values[i],
                    .cost = measure_cost(wall, subject->d_p, references[i].alpha1),
                    .first_hit = measure_first_hit(subject, &references[i], wall),
                    .rebound = measure_compare(subject, &references[i], wall)};
  asp_wall_free(wall);
}

static void print_row(FILE *out, const trade_row *r) {
  fprintf(out, "%s,%g,%.1f,", asp_spread_name(r->model), r->angle, r->cost);
  if (isfinite(r->first_hit))
    fprintf(out, "%.5f", r->first_hit);
  fprintf(out, ",%.5f,%.5f,%.4f,%.4f\n", r->rebound.kl, r->rebound.se, r->rebound.mean,
          r->rebound.reference_mean);
}

/* All rows, angle by angle. */
static void measure(const cli_option *options, const cli_list *angles, const measure_case *subject,
                    trade_row *rows) {
  bool multiple = cli_is_multiple(&options[COLLISIONS]);
  asp_surface *surface = measure_surface(subject);
  cli_check_size(surface, subject->d_p);
  measure_reference *references = measure_references(subject, angles->values, angles->count);
  cli_progress progress = cli_progress_begin("models", asp_spread_count());
  for (int m = 0; m < asp_spread_count(); m++) {
    judge(subject, surface, asp_spread_at(m), references, angles, multiple, rows + m);
    cli_progress_show(&progress, m + 1);
  }
  cli_progress_end(&progress);
  measure_references_free(references, angles->count);
  asp_surface_free(surface);
}

static void print(FILE *out, const trade_row *rows, size_t n) {
  fputs("model,alpha1_deg,ns_per_impact,kl_first_hit,kl_rebound,kl_rebound_se,mean_rebound_deg,"
        "mean_rebound_reference_deg\n",
        out);
  for (size_t i = 0; i < n; i++)
    print_row(out, &rows[i]);
}

/* The rows of --three-d. */
static void judge_3d(FILE *out, const cli_option *options, const cli_list *angles, size_t rays,
                     uint32_t seed) {
  cli_lay lay = cli_lay_of(&options[LAMBDA_C], &options[LAY]);
  judge_case subject = {
      {cli_length(&options[RQ]), lay.lambda[0], lay.lambda[1], lay.direction - ASP_PI / 2},
      cli_length(&options[DP]),
      cli_whole(&options[SURFACES], 3, 1000),
      cli_whole(&options[POINTS], 256, 16384),
      NULL};
  cli_trade_3d(out, &subject, angles, rays, cli_is_multiple(&options[COLLISIONS]), seed);
}

static int run(int argc, char **argv) {
  cli_option options[N + 1] = {
      [RQ] = {"rq", "LENGTH", "rms height of the wall", NULL},
      [LAMBDA_C] = {"lambda-c", "LENGTHS", CLI_LAMBDA_HELP, NULL},
      [LAY] = CLI_LAY_OPTION,
      [DP] = {"dp", "LENGTH", "diameter of the particles", NULL},
      [ANGLES] = {"angles", "DEGREES", "impact angles: a list or from:to:step", "2,5,10,20,45,80"},
      [RAYS] = {"rays", "N", "impacts per model and angle", "200000"},
      [PROFILES] = {"profiles", "N", "profiles of 2048 lambda_c in the ensemble that judges", "16"},
      [SEED] = {"seed", "N", "seed of the ensemble and the draws", "1"},
      [COLLISIONS] = {"collisions", "single|multiple", "one hit, or as many as it takes",
                      "multiple"},
      [GRID] = {"grid", NULL, "measure the grid of walls from which `auto` chooses; an hour", NULL},
      [THREE_D] = {"three-d", NULL, "isotropic: judged by surfaces in three dimensions", NULL},
      [SURFACES] = {"surfaces", "N", "of --three-d: independent surfaces that judge", "8"},
      [POINTS] = {"points", "N", "of --three-d: points along a side, 20 a lambda_c", "2048"},
      [OUTPUT] = {"output", "FILE", "write there instead of to the screen", NULL},
      [PLOT] = {"plot", "FILE", "draw cost against divergence; .png, .svg or .pdf", NULL},
  };
  cli_parse(&cli_trade, argc, argv, options, false);
  measure_case subject = {
      .rays = cli_whole(&options[RAYS], 1000, 1000000000),
      .profiles = (int)cli_whole(&options[PROFILES], MEASURE_PROFILES_LEAST, MEASURE_PROFILES_MOST),
      .seed = (uint32_t)cli_whole(&options[SEED], 0, 1000000)};
  if (options[GRID].value) {
    cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, &options[SEED]);
    cli_grid(cli_output_stream(output), &subject);
    cli_output_close(output);
    return 0;
  }
  cli_list angles = cli_angles(&options[ANGLES]);
  if (options[THREE_D].value) {
    unsigned long points = cli_whole(&options[POINTS], 256, 16384);
    if (points & (points - 1))
      cli_bad_usage("--points is %lu; it must be a power of two", points);
    cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, &options[SEED]);
    judge_3d(cli_output_stream(output), options, &angles, subject.rays, subject.seed);
    cli_output_close(output);
    return 0;
  }
  size_t n = angles.count * (size_t)asp_spread_count();
  trade_row *rows = malloc(n * sizeof *rows);
  if (!rows)
    cli_fail("out of memory");
  subject.r_q = cli_length(&options[RQ]);
  cli_lay lay = cli_lay_of(&options[LAMBDA_C], &options[LAY]);
  if (lay.lambda[0] < lay.lambda[1] || lay.lambda[0] > lay.lambda[1])
    cli_bad_usage("--lambda-c is '%s'; a wall with a lay is judged with --three-d",
                  options[LAMBDA_C].value);
  subject.lambda_c = lay.lambda[0];
  subject.d_p = cli_length(&options[DP]);
  measure(options, &angles, &subject, rows);
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, &options[SEED]);
  print(cli_output_stream(output), rows, n);
  cli_output_close(output);
  if (options[PLOT].value)
    cli_trade_plot(options, rows, n);
  free(rows);
  return 0;
}

const cli_command cli_trade = {
    .name = "trade",
    .summary = "speed against accuracy: every model against the geometry",
    .detail =
        "A row per model and impact angle. The reference follows specular particles over an\n"
        "ensemble of generated profiles, hit by hit; no model was made from any of them.\n"
        "kl_first_hit and kl_rebound are in bins of one degree; a bin that the model cannot fill\n"
        "counts as 1e-6, or half an impact. kl_rebound is free of the bias of histograms, and\n"
        "kl_rebound_se is its standard error, by the jackknife over the profiles; more --profiles\n"
        "and --rays make it smaller.\n"
        "With --three-d the reference are independent Gaussian surfaces on which a sphere rolls,\n"
        "none of which made a model; every model takes `isotropic`. --rays counts per surface.\n"
        "All D_KL are then sampled, with the standard error over the surfaces (jackknife).\n",
    .run = run,
};
