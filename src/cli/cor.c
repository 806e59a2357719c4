/* asperity cor: the scatter of the coefficients of restitution that a wall gives (the paper's
 * figures 13 and 14), without an engine: impacts one by one on the mean wall z = 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cor.h"
#include "base/ledger_columns.h"
#include "base/running.h"
#include "base/stream.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* m/s */
#define SPEED_LEAST 1e-9
#define SPEED_MOST 1e6

/* The value of a sample; of a list they come in turn. */
static double value_of(const cli_list *v, size_t sample, aspi_stream *stream) {
  if (v->count)
    return v->values[sample % v->count];
  for (;;) {
    double d = v->median * exp(log(v->most / v->least) / 5 * aspi_stream_normal(stream));
    if (d >= v->least && d <= v->most)
      return d;
  }
}

cor_row cli_cor_impact(const cor_scene *s, double angle, size_t sample, uint64_t tag) {
  static const double n[3] = {0, 0, 1};
  const cli_description *wall = &s->wall;
  asp_key key = {(uint32_t)asp_wall_get(wall->wall, "seed"), asp_key_wall("cor"), tag, 0};
  aspi_stream stream = aspi_stream_begin(&key);
  size_t sizes = s->sizes.count ? s->sizes.count : 1;
  double lay[3];
  cor_row r = {.d_p = value_of(&s->sizes, sample, &stream), .alpha1 = angle};
  double alpha1 = cli_radians(angle), speed = value_of(&s->speeds, sample / sizes, &stream);
  double v1[3] = {speed * cos(alpha1), 0, -speed * sin(alpha1)};
  if (angle >= 90)
    v1[0] = 0;
  asp_particle particle = {.d_p = r.d_p,
                           .density = wall->density,
                           .pair = wall->pair,
                           .lay = cli_description_lay(wall, lay)};
  key.impact = 1;
  asp_wall_impact(wall->wall, &particle, v1, n, &key, &r.impact);
  r.cor = asp_impact_coefficients(v1, n, &r.impact);
  return r;
}

static void print_row(FILE *out, const cor_row *r) {
  fprintf(out, "%.6g,%.6g,%.6g,%.6g,%d,%.6g,%.6g,%.6g,", r->d_p * 1e6, r->cor.v1, r->alpha1,
          cli_degrees(r->impact.delta_alpha), r->impact.hits, r->cor.cor_v, r->cor.cor_alpha,
          r->cor.cor_n);
  if (r->cor.cor_t_defined)
    fprintf(out, "%.6g", r->cor.cor_t);
  fprintf(out, ",%s,%.6g,%.6g\n", r->impact.outcome == ASP_DEPOSIT ? "deposit" : "rebound",
          r->cor.cor_v_space, r->cor.cor_alpha_space);
}

#define PRINT_NAME(ID, name, type, text) fputs(LEDGER_##ID ? "," name : name, out);

/* The impact as a wall's ledger has it in `units si`: before a primitive wall, at no time or place.
 */
static void print_ledger_row(FILE *out, const cor_row *r, size_t tag) {
  double of[LEDGER_N_COLUMNS] = {[LEDGER_TAG] = (double)tag,
                                 [LEDGER_IMPACT] = 1,
                                 [LEDGER_D_P] = r->d_p,
                                 [LEDGER_V1] = r->cor.v1,
                                 [LEDGER_ALPHA1] = cli_degrees(r->cor.alpha1),
                                 [LEDGER_DELTA_ALPHA] = cli_degrees(r->impact.delta_alpha),
                                 [LEDGER_TILT_OUT] = cli_degrees(r->impact.tilt_out),
                                 [LEDGER_HITS] = r->impact.hits,
                                 [LEDGER_V2] = r->cor.v2,
                                 [LEDGER_ALPHA2] = cli_degrees(r->cor.alpha2),
                                 [LEDGER_COR_N] = r->cor.cor_n,
                                 [LEDGER_COR_T] = r->cor.cor_t,
                                 [LEDGER_OUTCOME] = r->impact.outcome == ASP_DEPOSIT};
  for (int i = 0; i < LEDGER_N_COLUMNS; i++) {
    if (i != LEDGER_COR_T || r->cor.cor_t_defined)
      fprintf(out, "%.10g", of[i]);
    fputc(i + 1 < LEDGER_N_COLUMNS ? ',' : '\n', out);
  }
}

static void print_all(FILE *out, const cor_row *rows, size_t n, bool as_ledger) {
  if (as_ledger) {
    LEDGER_COLUMNS(PRINT_NAME)
    fputc('\n', out);
  } else {
    fputs("dp_um,v1_m_s,alpha1_deg,delta_alpha_deg,hits,cor_v_plane,cor_alpha_plane,cor_n,cor_t,"
          "outcome,cor_v_space,cor_alpha_space\n",
          out);
  }
  for (size_t i = 0; i < n; i++)
    if (as_ledger)
      print_ledger_row(out, &rows[i], i + 1);
    else
      print_row(out, &rows[i]);
}

/* Mean and sd, empty where there are none. */
static void print_moments(FILE *out, const aspi_running *r) {
  if (r->n > 0)
    fprintf(out, "%.6g", r->mean);
  fputc(',', out);
  if (r->n > 1)
    fprintf(out, "%.6g", aspi_running_sd(r));
}

/* Per angle: what sticks, and mean and sd of what rebounds. */
static void print_summary(FILE *out, const cli_list *angles, const size_t *counts,
                          const cor_row *rows, bool erodes) {
  fprintf(out, "alpha1_deg,impacts,capture_share,n,cor_n_mean,cor_n_sd,cor_t_mean,cor_t_sd%s\n",
          erodes ? ",eroded_mean,eroded_sd" : "");
  for (size_t a = 0; a < angles->count; rows += counts[a++]) {
    aspi_running cor_n = {0, 0, 0}, cor_t = {0, 0, 0}, eroded = {0, 0, 0};
    for (size_t i = 0; i < counts[a]; i++) {
      aspi_running_add(&eroded, rows[i].impact.eroded);
      if (rows[i].impact.outcome == ASP_DEPOSIT)
        continue;
      aspi_running_add(&cor_n, rows[i].cor.cor_n);
      if (rows[i].cor.cor_t_defined)
        aspi_running_add(&cor_t, rows[i].cor.cor_t);
    }
    fprintf(out, "%.6g,%zu,%.6g,%.0f,", angles->values[a], counts[a],
            1 - cor_n.n / (double)counts[a], cor_n.n);
    print_moments(out, &cor_n);
    fputc(',', out);
    print_moments(out, &cor_t);
    if (erodes) {
      fputc(',', out);
      print_moments(out, &eroded);
    }
    fputc('\n', out);
  }
}

/* Number of impacts at each angle: equal, or by flux: particles that fly in all of these directions
 * alike hit in proportion to sin alpha1. */
static size_t count_impacts(const cli_list *angles, size_t samples, bool by_flux, size_t *counts) {
  double sines = 0;
  size_t all = 0;
  for (size_t a = 0; a < angles->count; a++)
    sines += sin(cli_radians(angles->values[a]));
  for (size_t a = 0; a < angles->count; a++) {
    double share = sin(cli_radians(angles->values[a])) / sines * (double)angles->count;
    counts[a] = by_flux ? (size_t)fmax(1, round((double)samples * share)) : samples;
    all += counts[a];
  }
  return all;
}

static void make_rows(const cor_scene *s, const cli_list *angles, const size_t *counts,
                      size_t total, cor_row *rows) {
  cli_progress progress = cli_progress_begin("impacts", (double)total);
  size_t tag = 0;
  for (size_t a = 0; a < angles->count; a++)
    for (size_t i = 0; i < counts[a]; i++, tag++) {
      rows[tag] = cli_cor_impact(s, angles->values[a], i, tag);
      if (tag % 65536 == 0)
        cli_progress_show(&progress, (double)tag);
    }
  cli_progress_end(&progress);
}

static cli_list read_angles(const cli_option *option) {
  cli_list angles = cli_angles(option);
  if (!(angles.least > 0))
    cli_bad_usage("--angles is '%s'; it must be more than 0 and at most 90", option->value);
  return angles;
}

static int run(int argc, char **argv) {
  cli_option options[N + 1] = {
      [DP] = {"dp", "SIZES", "diameters: a list, or lognormal:min:max:median", "10um"},
      [SPEED] = {"speed", "SPEEDS", "in m/s: a list, or lognormal:min:max:median", "100"},
      [ANGLES] = {"angles", "DEGREES", "impact angles: a list", "1:90:1"},
      [SAMPLES] = {"samples", "N", "impacts per angle", "100"},
      [FLUX] = {"flux", NULL, "impacts in proportion to sin alpha1, --samples on the mean", NULL},
      [SUMMARY] = {"summary", NULL, "per angle mean, sd and capture share, no impacts", NULL},
      [COLUMNS] = {"columns", "own|ledger", "of the rows: own, or those of a wall's ledger", "own"},
      [OUTPUT] = CLI_OUTPUT_OPTION,
      CLI_PLOT_OPTIONS(PLOT, "draw the scatter; .png, .svg or .pdf"),
  };
  int words = cli_words(argc, argv);
  cli_parse(&cli_cor, argc - words, argv + words, options, false);
  bool as_ledger = cli_choice(&options[COLUMNS], "own", "ledger");
  if (as_ledger && options[SUMMARY].value)
    cli_bad_usage("--columns ledger is given with --summary, which has columns of its own");
  cor_scene s = {.wall = cli_description_read(words, argv + 1),
                 .sizes = cli_values(&options[DP], "length", 0, INFINITY),
                 .speeds = cli_values(&options[SPEED], "speed", SPEED_LEAST, SPEED_MOST)};
  cli_list angles = read_angles(&options[ANGLES]);
  size_t samples = cli_whole(&options[SAMPLES], 1, 100000000);
  cli_description_make(&s.wall, s.sizes.least, s.sizes.most);
  size_t *counts = cli_allocate(angles.count, sizeof *counts);
  size_t n = count_impacts(&angles, samples, options[FLUX].value, counts);
  cor_row *rows = cli_allocate(n, sizeof *rows);
  make_rows(&s, &angles, counts, n, rows);
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, s.wall.text);
  if (options[SUMMARY].value)
    print_summary(cli_output_stream(output), &angles, counts, rows,
                  asp_wall_is_given(s.wall.wall, "erosion"));
  else
    print_all(cli_output_stream(output), rows, n, as_ledger);
  cli_output_close(output);
  if (options[PLOT].value)
    cli_cor_plot(options, &s, rows, n);
  free(rows);
  free(counts);
  cli_description_free(&s.wall);
  return 0;
}

const cli_command cli_cor = {
    .name = "cor",
    .summary = "the scatter of the coefficients of restitution on a rough wall",
    .arguments = "DESCRIPTION",
    .detail =
        "One row an impact; its outcome is rebound or deposit. cor_v_plane and cor_alpha_plane\n"
        "are v2/v1 and alpha2/alpha1 of the velocity in the plane of incidence, as one camera\n"
        "from the side sees it (alpha2 from 0 to 180 degrees), like cor_n and cor_t; cor_v_space\n"
        "and cor_alpha_space are those of the velocity in space (0 to 90). An empty cor_t is\n"
        "undefined (normal impact). With --columns ledger the rows are as in a wall's ledger in\n"
        "`units si` (outcome 0 or 1), for what reads those. --summary has a row per angle: the\n"
        "number of impacts, the share that sticks, and of the n others mean and sd; with "
        "`erosion`\n"
        "also eroded_mean and eroded_sd of all impacts: mass that is worn off the wall per mass "
        "of\n"
        "particles.\n"
        "A log-normal law has the standard deviation ln(max/min)/5 of its ln, and is cut at\n"
        "both ends. Particles fly along x over the wall z = 0.\n",
    .examples = "  $ asperity cor surface rq 15.6um lambda_c 120um --dp lognormal:1um:100um:10um "
                "--plot cor.png -o cor.csv\n"
                "  $ asperity cor surface profile blade.csv --dp 20um --angles 5:85:5 --summary\n",
    .run = run,
};
