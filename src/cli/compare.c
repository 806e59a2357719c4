/* asperity compare: impacts of a model or a simulation against measured coefficients of
 * restitution; options, tables and warnings. analysis/compare.c does the statistics.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/compare.h"
#include "cli/cli.h"
#include "cli/scatter.h"

#include <math.h>

static const char *const names[ASPI_QUANTITIES] = {"cor_n", "cor_t", "alpha2_deg", "deposits"};

/* Width of bins in degrees, for impacts that were not measured repeatedly at the same places. The
 * tolerances for matching model impacts to a measurement: degrees, relative speed, relative size.
 */
#define WIDTH "10"
#define FAR "2,0.1,0.1"

/* With more places than this, impacts alone were not measured again and again. */
enum { PLACES_MOST = 1 << 14 };

static void print_side(FILE *out, const aspi_sample *s, double n, bool has_sd) {
  cli_row(out, "%.6g,%.6g,%.6g,%.6g,%.6g,", n, s->mean, s->mean_se, has_sd ? s->sd : NAN,
          has_sd ? s->sd_se : NAN);
}

static void print_bin(FILE *out, const aspi_comparison *c, const aspi_compare_bin *b, int k) {
  const aspi_sample *m = &b->model.of[k], *d = &b->data.of[k];
  cli_row(out, "%s,%.6g,%g,%g,%.6g,%.6g,", names[k], b->degrees, b->from, b->to, b->v1,
          b->d_p * 1e6);
  print_side(out, m, (double)m->count, k < ASPI_COMPARED);
  double n = c->data.means ? c->data.rows[b->first].n : c->names[1] ? (double)d->count : NAN;
  print_side(out, d, n, k < ASPI_COMPARED);
  fputs(",\n", out);
}

static const char note[] =
    "# note: deposits have no coefficients and are left out of their means; their shares are "
    "compared\n"
    "# where the data tell outcomes. Coefficients and constants that were fitted to measurements "
    "hold the\n"
    "# roughness of the measured wall already; with a rough wall they count it twice.\n";

static void print_all(FILE *out, const aspi_comparison *c) {
  fputs(note, out);
  fprintf(out, "# %.0f rebounds, %.0f deposits\n", c->impacts.impacts - c->impacts.deposits,
          c->impacts.deposits);
  fputs("quantity,alpha1_deg,alpha_from_deg,alpha_to_deg,v1_m_s,dp_um,model_n,model_mean,"
        "model_mean_se,model_sd,model_sd_se,data_n,data_mean,data_mean_se,data_sd,data_sd_se,"
        "score,score_se\n",
        out);
  for (int k = 0; k < (c->data.has_outcome ? ASPI_QUANTITIES : ASPI_COMPARED); k++)
    for (size_t i = 0; i < c->count && (k != REBOUND_ANGLE || c->data.has_angle); i++)
      print_bin(out, c, &c->bins[i], k);
  if (c->names[1])
    cli_row(out, "score,,,,,,,,,,,,,,,,%.6g,%.6g\n", c->score.value, c->score.se);
}

/* Warns of bins without model impacts or without data; fails if no bin has both. */
static void check_bins(const aspi_comparison *c) {
  size_t both = 0;
  for (int k = 0; k < ASPI_COMPARED; k++) {
    size_t no_model = 0, with_data = 0;
    for (size_t i = 0; i < c->count; i++) {
      bool data = isfinite(c->bins[i].data.of[k].mean);
      with_data += data;
      no_model += data && c->bins[i].model.of[k].count == 0;
    }
    if (no_model > 0)
      cli_warn("%s: %zu of %zu bins with data are empty of impacts near them (see --near)",
               names[k], no_model, with_data);
    both += with_data - no_model;
  }
  if (both == 0)
    cli_bad_usage("no bin has both impacts and data; the angles%s%s do not overlap",
                  c->data.has_speed ? ", speeds" : "", c->data.has_size ? ", sizes" : "");
}

/* Reports why there is no score. */
static void warn_no_score(const aspi_comparison *c) {
  if (isfinite(c->score.value))
    return;
  if (c->data.means)
    cli_warn(
        "%s: there is no score, as no mean has a standard error: columns cor_n_se, or cor_n_sd "
        "(with n) give it, for cor_t alike",
        c->names[1]);
  else
    cli_warn(
        "%s: there is no score, as no bin has %d impacts with a scatter: a wider --bin may help",
        c->names[1], ASPI_SCORED_LEAST);
}

/* Impacts without a speed or a size match any. */
static void warn_unknown(const aspi_comparison *c) {
  static const char text[] = "%s: no %s of impacts in it; those of the data are not looked at";
  if (c->data.has_speed && !c->impacts.has_speed)
    cli_warn(text, c->names[0], "speeds");
  if (c->data.has_size && !c->impacts.has_size)
    cli_warn(text, c->names[0], "sizes");
}

static void table_impacts(aspi_comparison *c, cli_call *call, double width, bool given) {
  static const char *const of_data[] = {"near", "columns", "from"};
  for (int i = 0; i < 3; i++)
    if (cli_is_set(call, of_data[i]))
      cli_bad_usage("--%s has no effect without DATA", of_data[i]);
  const aspi_grouping grouping = {.width = width, .places = given ? 0 : PLACES_MOST};
  c->impacts = cli_scatter_read_impacts(c->names[0], NULL, &grouping);
  c->data = c->impacts;
  c->data.has_outcome = true;
  cli_must(!aspi_compare_make_bins(c, width, given, &cli_error));
  cli_must(!aspi_compare_fill(c, NULL, &cli_error));
}

static void compare_with(aspi_comparison *c, cli_call *call, double width, bool given) {
  static const aspi_grouping places = {.width = 0};
  aspi_grouping grouping;
  double far[3] = {0, 0.1, 0.1}; /* degrees, and shares of speed and size */
  cli_few(cli_get(call, "near"), 0, 90, 3, far);
  const aspi_compare_reach reach = {far[0], far[1], far[2]};
  c->data = cli_scatter_read_data(call, c->names[1], &places);
  cli_must(!aspi_compare_grouping(&c->data, &reach, &grouping, &cli_error));
  c->impacts = cli_scatter_read_impacts(c->names[0], &c->data, &grouping);
  warn_unknown(c);
  cli_must(!aspi_compare_make_bins(c, width, given, &cli_error));
  cli_must(!aspi_compare_fill(c, &reach, &cli_error));
  aspi_compare_grouping_free(&grouping);
  check_bins(c);
  warn_no_score(c);
}

static void run(cli_call *call) {
  bool alone = call->n_words == 1;
  if (call->n_words != 2 && !alone)
    cli_bad_usage("compare: IMPACTS or IMPACTS and DATA are expected, one file or two; see "
                  "'asperity compare --help'");
  aspi_comparison c = {.names = {call->words[0], alone ? NULL : call->words[1]}};
  bool given = cli_value(call, "bin");
  cli_default(call, "bin", WIDTH);
  (alone ? table_impacts : compare_with)(&c, call, cli_number(cli_get(call, "bin"), 0.1, 90),
                                         given);
  FILE *out = cli_table_open(call, NULL);
  print_all(out, &c);
  cli_table_close(call, out, "compare");
}

static const cli_option options[] = {{"bin", "DEGREES",
                                      "width of the bins of single impacts; by default a bin for "
                                      "each place that was measured often, else " WIDTH
                                      "; clusters of angles narrower than it stay whole",
                                      NULL},
                                     {"near", "DEGREES[,SPEED[,SIZE]]",
                                      "a place without simulated impacts takes those within this "
                                      "distance: degrees, shares of speed and size",
                                      FAR},
                                     SCATTER_OPTIONS,
                                     {.name = NULL}};

static const char detail[] =
    "IMPACTS is the output of 'asperity cor' or the ledger of a wall. Alone, they "
    "are tabled and drawn for each place (an impact\n"
    "angle, or an interval of angles): model_n and model_mean of the rows 'deposits' are the\n"
    "number of impacts and the share that sticks.\n" SCATTER_FORMS "\n"
    "A place in the data is an angle, with a speed and a size where the data have them. At\n"
    "each, the output has of both sides the mean and standard deviation of both\n"
    "coefficients, the share of deposits if the data have outcomes, all with standard\n"
    "errors. The last row is the score: the mean square of all differences, each divided by\n"
    "its standard error (reduced chi-square), with the score's own standard error. For the\n"
    "true model it is 1 on average. If the data are means, only the means count: by\n"
    "cor_n_se, or cor_n_sd and n; where n is missing, by cor_n_sd itself.\n";

const cli_command cli_compare = {
    .name = "compare",
    .arguments = "IMPACTS [DATA]",
    .summary = "impacts of a model or a simulation, alone or against measured coefficients",
    .detail = detail,
    .examples =
        "  $ asperity compare cor.csv examples/data/grant_tabakoff_1975.csv --plot compare.png\n"
        "  $ asperity compare impacts.csv\n",
    .options = options,
    .picture = "draw the comparison; .png, .svg or .pdf",
    .takes_files = true,
    .run = run,
};
