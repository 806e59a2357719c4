/* asperity trade: speed against accuracy. Compares every model on one wall, at several impact
 * angles, with an independent ensemble of such walls: cost per impact, and errors of the first hit
 * and of the final rebound.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/judge.h"
#include "cli/description.h"
#include "description/description.h"
#include "cli/cli.h"
#include "spread/models.h"
#include "surface/size_law.h"

#include <stdlib.h>
#include <string.h>

enum { MODELS_MOST = 32 };

/* A model at one impact angle; degrees. */
typedef struct judged {
  const asp_spread_model *model;
  double angle, cost, first_hit;
  struct {
    double kl, se, mean, reference_mean;
  } rebound;
} judged;

/* One row: a model at one angle. */
static judged judge_at(const aspi_judge_case *subject, const aspi_judge *judge,
                       const asp_wall *model, double angle, size_t i) {
  size_t groups = subject->groups;
  aspi_angles *angles = aspi_judge_model_rebounds(subject, model, angle);
  if (!angles)
    cli_fail("out of memory for %zu groups of rebounds", groups);
  aspi_mean_error kl =
      aspi_judge_divergence(judge, i, angles, groups, offsetof(aspi_angles, rebound));
  size_t sum = offsetof(aspi_angles, rebound_sum);
  double mean = aspi_angles_mean((aspi_angle_groups){angles, groups, 1}, sum).value,
         reference = aspi_angles_mean(aspi_judge_groups(judge, i), sum).value;
  free(angles);
  return (judged){.angle = angle,
                  .cost = aspi_judge_cost(model, subject->d_p, angle),
                  .first_hit = aspi_judge_first_hit(&judge->first[i], model, subject->d_p, angle),
                  .rebound = {kl.value, kl.se, mean, reference}};
}

/* The models to judge; on a measured wall without those for Gaussian walls only. */
static size_t list_models(const aspi_judge_case *subject, const asp_spread_model **models) {
  size_t n = 0;
  for (int m = 0; m < asp_spread_count(); m++)
    if (!subject->profile || asp_spread_at(m) != &aspi_spread_profile)
      models[n++] = asp_spread_at(m);
  return n;
}

/* All rows, angle by angle. */
static void judge_all(const cli_list *angles, aspi_judge_case *subject, const asp_spread_model **of,
                      size_t models, judged *rows) {
  aspi_judge judge;
  cli_progress progress = cli_progress_begin("ensemble", 1);
  subject->progress = cli_progress_show;
  subject->context = &progress;
  cli_must(!aspi_judge_create(&judge, subject, angles->values, angles->count, &cli_error));
  cli_progress_end(&progress);
  progress = cli_progress_begin("models", (double)models);
  for (size_t m = 0; m < models; m++) {
    asp_wall *model = cli_made(aspi_judge_wall(subject, asp_spread_name(of[m]), &cli_error));
    for (size_t i = 0; i < angles->count; i++) {
      judged *row = &rows[i * models + m];
      *row = judge_at(subject, &judge, model, angles->values[i], i);
      row->model = of[m];
    }
    asp_wall_free(model);
    cli_progress_show(&progress, (double)m + 1);
  }
  cli_progress_end(&progress);
  aspi_judge_free(&judge);
}

static void print(FILE *out, const judged *rows, size_t n) {
  fputs("model,alpha1_deg,ns_per_impact,kl_first_hit,kl_rebound,kl_rebound_se,mean_rebound_deg,"
        "mean_rebound_reference_deg\n",
        out);
  for (const judged *r = rows; r < rows + n; r++)
    cli_row(out, "%s,%g,%.1f,%.5f,%.5f,%.5f,%.4f,%.4f\n", asp_spread_name(r->model), r->angle,
            r->cost, r->first_hit, r->rebound.kl, r->rebound.se, r->rebound.mean,
            r->rebound.reference_mean);
}

/* Exits if no ensemble of profiles represents the wall. */
static void check_wall(const asp_description *words) {
  const char *kind = asp_description_word(words, "surface");
  if (strcmp(kind, "smooth") == 0)
    cli_bad_usage("trade needs a rough wall; 'surface smooth' has no tilts to compare");
  if (strcmp(kind, "map") == 0 || asp_description_lay(words).kind != ASP_LAY_NONE)
    cli_bad_usage("'%s' is given; models are judged in the plane of incidence, on a profile or by "
                  "a wall's numbers without a lay",
                  strcmp(kind, "map") == 0 ? "surface map" : "lay");
}

static aspi_judge_case case_of(const cli_call *call, const cli_description *wall, double d_p) {
  const asp_surface *surface = asp_wall_surface(wall->wall);
  asp_heights *profile;
  asp_error doubt;
  cli_must(!aspi_heights_read(wall->words, &profile, &doubt, &cli_error));
  if (profile && cli_is_set(call, "ensemble"))
    cli_bad_usage("--ensemble has no effect on a measured profile, which is the reference itself");
  double r_q, lambda_c;
  aspi_surface_gaussian(surface, d_p, &r_q, &lambda_c);
  return (aspi_judge_case){
      .r_q = r_q,
      .lambda_c = lambda_c,
      .d_p = d_p,
      .groups = cli_whole(cli_get(call, "ensemble"), ASPI_JUDGES_LEAST, ASPI_JUDGES_MOST),
      .rays = cli_whole(cli_get(call, "rays"), 1000, 1000000000),
      .seed = (uint32_t)asp_description_get(wall->words, "seed"),
      .profile = profile};
}

/* A diameter for a wall that is the same for all of them, and the most that the seed may be. */
#define ANY_SIZE 1e-5
#define SEED_MOST 1000000

static cli_description read_wall(const cli_call *call, double *d_p) {
  cli_description wall = cli_description_read(call->n_words, call->words, false);
  cli_description_allow(&wall, "surface seed", "every model is judged, by specular rebounds");
  check_wall(wall.words);
  bool any =
      strcmp(asp_description_word(wall.words, "surface"), "sigma") == 0 && !cli_value(call, "dp");
  *d_p = any ? ANY_SIZE : cli_length(cli_get(call, "dp"));
  if (asp_description_get(wall.words, "seed") > SEED_MOST)
    cli_bad_usage("seed is %.0f; it must be at most %d, as each profile has one of its own",
                  asp_description_get(wall.words, "seed"), SEED_MOST);
  cli_description_make(&wall, *d_p, *d_p);
  return wall;
}

static void run(cli_call *call) {
  double d_p;
  cli_list angles = cli_angles(cli_get(call, "angles"));
  cli_description wall = read_wall(call, &d_p);
  aspi_judge_case subject = case_of(call, &wall, d_p);
  const asp_spread_model *of[MODELS_MOST];
  size_t models = list_models(&subject, of), n = angles.count * models;
  judged *rows = cli_allocate(n, sizeof *rows);
  judge_all(&angles, &subject, of, models, rows);
  FILE *out = cli_table_open(call, wall.text);
  print(out, rows, n);
  cli_table_close(call, out, "trade");
}

static const cli_option options[] = {
    {"dp", "LENGTH", "diameter of the particles", NULL},
    {"angles", "DEGREES", "impact angles: a list", "2,5,10,20,45,80"},
    {"rays", "N", "impacts per model and angle", "200000"},
    {"ensemble", "N", "profiles of 2048 lambda_c in the reference", "16"},
    {.name = NULL}};

static const char detail[] =
    "A row per model and impact angle. The reference follows specular particles over an\n"
    "ensemble of generated profiles, hit by hit; no model was made from any of them.\n"
    "kl_first_hit and kl_rebound are D_KL of the first tilt and of the rebound angle, in\n"
    "bins of one degree. A bin that the model cannot fill counts as 1e-6, or half an\n"
    "impact. kl_rebound is free of the bias of histograms. kl_rebound_se is its standard\n"
    "error, by the jackknife over the profiles; more --rays and a larger --ensemble make it\n"
    "smaller.\n"
    "On a measured profile the reference is the flight over it, as `traced` has it; how much\n"
    "its length leaves uncertain is what 'asperity surface' says.\n";

const cli_command cli_trade = {
    .name = "trade",
    .summary = "speed against accuracy: every model against the geometry",
    .arguments = "DESCRIPTION",
    .detail = detail,
    .examples = "  $ asperity trade surface rq 5um lambda_c 40um --dp 10um --plot trade.png\n",
    .options = options,
    .picture = "draw cost against divergence; .png, .svg or .pdf",
    .run = run,
};
