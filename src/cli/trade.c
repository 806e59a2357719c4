/* asperity trade: speed against accuracy. Every model on one wall, at several impact angles,
 * against the geometry of that very wall: what an impact costs, how far the law of the first hit
 * and that of the final rebound are off. */
#include "cli/trade.h"
#include "cli/grid.h"
#include "cli/measure.h"
#include "cli/trade_3d.h"
#include "cli/walls.h"

#include <math.h>
#include <stdlib.h>

/* The rows of one angle. */
static void judge(const measure_case *subject, double angle, size_t rays, uint32_t seed,
                  bool multiple, trade_row *rows) {
  double alpha1 = cli_radians(angle);
  asp_wall *traced = measure_wall(subject, "traced", true);
  measure_angles reference = measure_rebounds(traced, subject->d_p, alpha1, rays, seed);
  asp_wall_free(traced);
  for (int i = 0; i < asp_spread_count(); i++) {
    const asp_spread_model *model = asp_spread_at(i);
    asp_wall *wall = measure_wall(subject, asp_spread_name(model), multiple);
    measure_angles angles = measure_rebounds(wall, subject->d_p, alpha1, rays, seed + 1);
    rows[i] = (trade_row){.model = model,
                          .angle = angle,
                          .cost = measure_cost(wall, subject->d_p, alpha1),
                          .first_hit = measure_first_hit(subject, wall, alpha1),
                          .rebound = measure_divergence(&reference, &angles),
                          .mean = angles.mean,
                          .reference_mean = reference.mean};
    asp_wall_free(wall);
  }
}

static void print_row(FILE *out, const trade_row *r) {
  fprintf(out, "%s,%g,%.1f,", asp_spread_name(r->model), r->angle, r->cost);
  if (isfinite(r->first_hit))
    fprintf(out, "%.5f", r->first_hit);
  fprintf(out, ",%.5f,%.4f,%.4f\n", r->rebound, r->mean, r->reference_mean);
}

/* All rows, angle by angle. */
static void measure(const cli_option *options, const cli_list *angles, size_t rays, uint32_t seed,
                    trade_row *rows) {
  bool multiple = cli_is_multiple(&options[COLLISIONS]);
  measure_case subject = measure_case_create(
      cli_length(&options[RQ]), cli_length(&options[LAMBDA_C]), cli_length(&options[DP]), seed);
  cli_progress progress = cli_progress_begin("measuring", (double)angles->count);
  for (size_t i = 0; i < angles->count; i++) {
    judge(&subject, angles->values[i], rays, seed, multiple, rows + i * (size_t)asp_spread_count());
    cli_progress_show(&progress, (double)(i + 1));
  }
  cli_progress_end(&progress);
  measure_case_free(&subject);
}

static void print(FILE *out, const trade_row *rows, size_t n) {
  fputs("model,alpha1_deg,ns_per_impact,kl_first_hit,kl_rebound,mean_rebound_deg,"
        "mean_rebound_reference_deg\n",
        out);
  for (size_t i = 0; i < n; i++)
    print_row(out, &rows[i]);
}

/* The rows of --three-d. */
static void judge_3d(FILE *out, const cli_option *options, const cli_list *angles, size_t rays,
                     uint32_t seed) {
  double lambda_c = cli_length(&options[LAMBDA_C]);
  judge_case subject = {{cli_length(&options[RQ]), lambda_c, lambda_c, 0},
                        cli_length(&options[DP]),
                        cli_whole(&options[SURFACES], 3, 1000),
                        cli_whole(&options[POINTS], 256, 16384)};
  cli_trade_3d(out, &subject, angles, rays, cli_is_multiple(&options[COLLISIONS]), seed);
}

static int run(int argc, char **argv) {
  cli_option options[N + 1] = {
      [RQ] = {"rq", "LENGTH", "rms height of the wall", NULL},
      [LAMBDA_C] = {"lambda-c", "LENGTH", "correlation length: autocorrelation 1/e", NULL},
      [DP] = {"dp", "LENGTH", "diameter of the particles", NULL},
      [ANGLES] = {"angles", "DEGREES", "impact angles: a list or from:to:step", "2,5,10,20,45,80"},
      [RAYS] = {"rays", "N", "impacts per model and angle", "200000"},
      [SEED] = {"seed", "N", "seed of the profile and the draws", "1"},
      [COLLISIONS] = {"collisions", "single|multiple", "one hit, or as many as it takes",
                      "multiple"},
      [GRID] = {"grid", NULL, "measure the grid of walls from which `auto` chooses; minutes", NULL},
      [THREE_D] = {"three-d", NULL, "isotropic: judged by surfaces in three dimensions", NULL},
      [SURFACES] = {"surfaces", "N", "of --three-d: independent surfaces that judge", "8"},
      [POINTS] = {"points", "N", "of --three-d: points along a side, 20 a lambda_c", "2048"},
      [OUTPUT] = {"output", "FILE", "write there instead of to the screen", NULL},
      [PLOT] = {"plot", "FILE", "draw cost against divergence; .png, .svg or .pdf", NULL},
  };
  cli_parse(&cli_trade, argc, argv, options, false);
  size_t rays = cli_whole(&options[RAYS], 1000, 1000000000);
  uint32_t seed = (uint32_t)cli_whole(&options[SEED], 0, UINT32_MAX - 1);
  if (options[GRID].value) {
    cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, &options[SEED]);
    cli_grid(cli_output_stream(output), rays, seed);
    cli_output_close(output);
    return 0;
  }
  cli_list angles = cli_angles(&options[ANGLES]);
  if (options[THREE_D].value) {
    unsigned long points = cli_whole(&options[POINTS], 256, 16384);
    if (points & (points - 1))
      cli_bad_usage("--points is %lu; it must be a power of two", points);
    cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, &options[SEED]);
    judge_3d(cli_output_stream(output), options, &angles, rays, seed);
    cli_output_close(output);
    return 0;
  }
  size_t n = angles.count * (size_t)asp_spread_count();
  trade_row *rows = malloc(n * sizeof *rows);
  if (!rows)
    cli_fail("out of memory");
  measure(options, &angles, rays, seed, rows);
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
        "A row per model and impact angle. The reference follows specular particles over a\n"
        "generated profile, hit by hit; models get the slope of that very profile. kl_first_hit\n"
        "is exact (bins of one degree, a bin that the model cannot fill counts as 1e-6),\n"
        "kl_rebound is sampled and free of bias; it tells nothing below about 30/rays.\n"
        "With --three-d the reference are independent Gaussian surfaces on which a sphere rolls,\n"
        "none of which made a model; every model takes `isotropic`. --rays counts per surface.\n"
        "All D_KL are then sampled, with the standard error over the surfaces (jackknife).\n",
    .run = run,
};
