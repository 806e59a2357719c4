/* asperity cor: the scatter of the coefficients of restitution that a wall gives (the paper's
 * figures 13 and 14), without an engine: impacts one by one on the mean wall z = 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/ledger_columns.h"
#include "base/running.h"
#include "base/stream.h"
#include "cli/description.h"
#include "cli/plot.h"

#include <math.h>
#include <string.h>

/* m/s */
#define SPEED_LEAST 1e-9
#define SPEED_MOST 1e6

typedef struct scene {
  cli_description wall;
  cli_list speeds, sizes; /* of a log-normal law ln has the sd ln(most/least)/5 */
} scene;

typedef struct row {
  double d_p, alpha1;
  cli_impact of;
} row;

/* The value of a sample; of a list they come in turn. */
static double sample_of(const cli_list *v, size_t sample, aspi_stream *stream) {
  if (v->count)
    return v->values[sample % v->count];
  for (;;) {
    double d = v->median * exp(log(v->most / v->least) / 5 * aspi_stream_normal(stream));
    if (d >= v->least && d <= v->most)
      return d;
  }
}

/* One impact at an angle in degrees. */
static row impact_at(const scene *s, double angle, size_t sample, uint64_t tag) {
  asp_key key = {(uint32_t)asp_wall_get(s->wall.wall, "seed"), asp_key_wall("cor"), tag, 0};
  aspi_stream stream = aspi_stream_begin(&key);
  size_t sizes = s->sizes.count ? s->sizes.count : 1;
  row r = {.d_p = sample_of(&s->sizes, sample, &stream), .alpha1 = angle};
  double speed = sample_of(&s->speeds, sample / sizes, &stream);
  key.impact = 1;
  r.of = cli_impact_at(&s->wall, r.d_p, speed, angle, &key);
  return r;
}

static void print_row(FILE *out, const row *r) {
  cli_row(out, "%.6g,%.6g,%.6g,%.6g,%d,%.6g,%.6g,%.6g,%.6g,%s,%.6g,%.6g\n", r->d_p * 1e6,
          r->of.cor.v1, r->alpha1, cli_degrees(r->of.impact.delta_alpha), r->of.impact.hits,
          r->of.cor.cor_v, r->of.cor.cor_alpha, r->of.cor.cor_n, r->of.cor.cor_t,
          r->of.impact.outcome == ASP_DEPOSIT ? "deposit" : "rebound", r->of.cor.cor_v_space,
          r->of.cor.cor_alpha_space);
}

#define PRINT_NAME(ID, name, type, text) fputs(LEDGER_##ID ? "," name : name, out);

/* The impact as a wall's ledger has it in `units si`: before a primitive wall, at no time or place.
 */
static void print_ledger_row(FILE *out, const row *r, size_t tag) {
  double of[LEDGER_N_COLUMNS] = {[LEDGER_TAG] = (double)tag,
                                 [LEDGER_IMPACT] = 1,
                                 [LEDGER_D_P] = r->d_p,
                                 [LEDGER_V1] = r->of.cor.v1,
                                 [LEDGER_ALPHA1] = cli_degrees(r->of.cor.alpha1),
                                 [LEDGER_DELTA_ALPHA] = cli_degrees(r->of.impact.delta_alpha),
                                 [LEDGER_TILT_OUT] = cli_degrees(r->of.impact.tilt_out),
                                 [LEDGER_HITS] = r->of.impact.hits,
                                 [LEDGER_V2] = r->of.cor.v2,
                                 [LEDGER_ALPHA2] = cli_degrees(r->of.cor.alpha2),
                                 [LEDGER_COR_N] = r->of.cor.cor_n,
                                 [LEDGER_COR_T] = r->of.cor.cor_t,
                                 [LEDGER_OUTCOME] = r->of.impact.outcome == ASP_DEPOSIT};
  for (int i = 0; i < LEDGER_N_COLUMNS; i++) {
    if (isfinite(of[i]))
      fprintf(out, "%.10g", of[i]);
    fputc(i + 1 < LEDGER_N_COLUMNS ? ',' : '\n', out);
  }
}

static void print_all(FILE *out, const row *rows, size_t n, bool as_ledger) {
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
  cli_row(out, ",%.6g,%.6g", r->n > 0 ? r->mean : NAN, r->n > 1 ? aspi_running_sd(r) : NAN);
}

/* Per angle: what sticks, and mean and sd of what rebounds. */
static void print_summary(FILE *out, const cli_list *angles, const size_t *counts, const row *rows,
                          bool erodes) {
  fprintf(out, "alpha1_deg,impacts,capture_share,n,cor_n_mean,cor_n_sd,cor_t_mean,cor_t_sd%s\n",
          erodes ? ",eroded_mean,eroded_sd" : "");
  for (size_t a = 0; a < angles->count; rows += counts[a++]) {
    aspi_running cor_n = {0, 0, 0}, cor_t = {0, 0, 0}, eroded = {0, 0, 0};
    for (size_t i = 0; i < counts[a]; i++) {
      aspi_running_add(&eroded, rows[i].of.impact.eroded);
      if (rows[i].of.impact.outcome == ASP_DEPOSIT)
        continue;
      aspi_running_add(&cor_n, rows[i].of.cor.cor_n);
      if (isfinite(rows[i].of.cor.cor_t))
        aspi_running_add(&cor_t, rows[i].of.cor.cor_t);
    }
    cli_row(out, "%.6g,%zu,%.6g,%.0f", angles->values[a], counts[a],
            1 - cor_n.n / (double)counts[a], cor_n.n);
    print_moments(out, &cor_n);
    print_moments(out, &cor_t);
    if (erodes)
      print_moments(out, &eroded);
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

static void make_rows(const scene *s, const cli_list *angles, const size_t *counts, size_t total,
                      row *rows) {
  cli_progress progress = cli_progress_begin("impacts", (double)total);
  size_t tag = 0;
  for (size_t a = 0; a < angles->count; a++)
    for (size_t i = 0; i < counts[a]; i++, tag++) {
      rows[tag] = impact_at(s, angles->values[a], i, tag);
      if (tag % 65536 == 0)
        cli_progress_show(&progress, (double)tag);
    }
  cli_progress_end(&progress);
}

/* ---- the picture ---- */

/* An angle with fewer impacts than IMPACTS_LEAST is merged with its neighbors, over at most
 * CELL_MOST degrees. */
#define IMPACTS_LEAST 30
#define CELL_MOST 2.0

enum { DOTS_MOST = 20000 };

/* A list or a log-normal, times a factor, with its unit. */
static cli_label values_of(const cli_list *v, double factor, const char *unit) {
  cli_label label;
  int used = snprintf(label.text, sizeof label.text, "%.3g", v->least * factor);
  if (v->most > v->least)
    used += snprintf(label.text + used, 99, " … %.3g", v->most * factor);
  used += snprintf(label.text + used, 99, " %s", unit);
  if (v->count == 0)
    snprintf(label.text + used, 99, " (log-normal, median %.3g)", v->median * factor);
  return label;
}

static cli_plot *open_picture(const cli_call *call, const scene *s, const row *rows, size_t n) {
  const cli_description *wall = &s->wall;
  size_t deposits = 0;
  char pair[2 * sizeof(cli_label) + 10] = "";
  for (size_t i = 0; i < n; i++)
    deposits += rows[i].of.impact.outcome == ASP_DEPOSIT;
  if (wall->particle)
    snprintf(pair, sizeof pair, "%s on %s; ",
             cli_plot_label(asp_material_name(wall->particle)).text,
             cli_plot_label(asp_material_name(wall->target)).text);
  return cli_plot_open(
      call, 1200, 520, "1,2",
      "%s%s; %s, %s; v_1 = %s; d_p = %s; %zu impacts, %.1f %% stick and are left out", pair,
      cli_plot_label(asp_rebound_name(asp_wall_rebound(wall->wall))).text,
      cli_plot_wall(wall->wall).text,
      cli_plot_label(asp_spread_name(asp_wall_spread(wall->wall))).text,
      values_of(&s->speeds, 1, "m/s").text, values_of(&s->sizes, 1e6, "µm").text, n,
      100 * (double)deposits / (double)n);
}

static void plot_impacts(cli_plot *picture, int t, const row *rows, size_t n) {
  size_t every = n / DOTS_MOST + 1;
  cli_plot_series(picture, CLI_MARKS, "impacts");
  for (size_t i = 0; i < n; i += every)
    cli_plot_row(picture, rows[i].alpha1, cli_impact_ratio(&rows[i].of, t));
  if (every > 1)
    cli_plot_end(picture, "impacts, one of %zu", every);
  else
    cli_plot_end(picture, "impacts");
}

/* Mean and sd by angle. */
static void plot_means(cli_plot *picture, int t, const row *rows, size_t n, const char *style) {
  cli_plot_series(picture, CLI_BAND, "%s", style);
  for (size_t i = 0, next; i < n; i = next) {
    aspi_running y = {0, 0, 0}, angle = {0, 0, 0};
    for (next = i; next < n; next++) {
      if (rows[next].alpha1 > rows[i].alpha1 &&
          (next - i >= IMPACTS_LEAST || rows[next].alpha1 >= rows[i].alpha1 + CELL_MOST))
        break;
      if (!isfinite(cli_impact_ratio(&rows[next].of, t)))
        continue;
      aspi_running_add(&y, cli_impact_ratio(&rows[next].of, t));
      aspi_running_add(&angle, rows[next].alpha1);
    }
    if (y.n > 1)
      cli_plot_row(picture, angle.mean, y.mean, aspi_running_sd(&y));
  }
  cli_plot_end(picture, "mean ± sd");
}

/* True if impacts at one angle differ at all. */
static bool varies(const row *rows, size_t n) {
  for (size_t i = 1; i < n; i++)
    if (rows[i].alpha1 <= rows[i - 1].alpha1 && rows[i].of.cor.cor_n != rows[i - 1].of.cor.cor_n &&
        rows[i].of.impact.outcome == rows[i - 1].of.impact.outcome)
      return true;
  return false;
}

/* The smooth wall at the first of the speeds and sizes, or the median of their law. */
static void plot_smooth(cli_plot *picture, int t, const scene *s) {
  double speed = s->speeds.count ? s->speeds.values[0] : s->speeds.median,
         d_p = s->sizes.count ? s->sizes.values[0] : s->sizes.median;
  const scene one = {.wall = s->wall,
                     .speeds = {.values = &speed, .count = 1},
                     .sizes = {.values = &d_p, .count = 1}};
  size_t rebounds = 0;
  cli_plot_series(picture, CLI_LINE, "model_none");
  for (int i = 1; i < 180; i++) {
    row r = impact_at(&one, 0.5 * i, 0, 1);
    rebounds += r.of.impact.outcome == ASP_REBOUND;
    cli_plot_row(picture, 0.5 * i, cli_impact_ratio(&r.of, t));
  }
  cli_plot_end(picture, "smooth wall, %.3g µm, %.3g m/s%s", d_p * 1e6, speed,
               rebounds ? "" : " (sticks)");
}

/* Impacts, their mean and sd over the impact angle, and the smooth wall. */
static void plot(const cli_call *call, const scene *s, const row *rows, size_t n) {
  asp_wall *wall = s->wall.wall;
  asp_error error;
  char style[80];
  if (asp_wall_surface(wall))
    snprintf(style, sizeof style, "model_%s", asp_spread_name(asp_wall_spread(wall)));
  else
    snprintf(style, sizeof style, "law_%s", asp_rebound_name(asp_wall_rebound(wall)));
  cli_plot *picture = open_picture(call, s, rows, n);
  asp_wall_set_surface(wall, NULL);
  cli_must(!asp_wall_prepare(wall, &error), &error);
  for (int t = 0; t < 2; t++) {
    cli_plot_coefficient(picture, t);
    plot_impacts(picture, t, rows, n);
    if (varies(rows, n))
      plot_means(picture, t, rows, n, style);
    plot_smooth(picture, t, s);
  }
  cli_plot_close(picture);
}

/* ---- the command ---- */

static void run(cli_call *call) {
  bool as_ledger = cli_choice(cli_get(call, "columns"));
  bool summary = cli_value(call, "summary");
  if (as_ledger && summary)
    cli_bad_usage("--columns ledger is given with --summary, which has columns of its own");
  scene s = {.wall = cli_description_read(call->n_words, call->words, false),
             .sizes = cli_values(cli_get(call, "dp"), "length", 0, INFINITY),
             .speeds = cli_values(cli_get(call, "speed"), "speed", SPEED_LEAST, SPEED_MOST)};
  cli_list angles = cli_impact_angles(call);
  size_t samples = cli_whole(cli_get(call, "samples"), 1, 100000000);
  cli_description_make(&s.wall, s.sizes.least, s.sizes.most);
  size_t *counts = cli_allocate(angles.count, sizeof *counts);
  size_t n = count_impacts(&angles, samples, cli_value(call, "flux"), counts);
  row *rows = cli_allocate(n, sizeof *rows);
  make_rows(&s, &angles, counts, n, rows);
  FILE *out = cli_output_open(call, "output", s.wall.text);
  if (summary)
    print_summary(out, &angles, counts, rows, asp_wall_is_given(s.wall.wall, "erosion"));
  else
    print_all(out, rows, n, as_ledger);
  cli_file_close(out);
  if (cli_value(call, "plot"))
    plot(call, &s, rows, n);
}

static const cli_option options[] = {
    {"dp", "SIZES", "diameters: a list, or lognormal:min:max:median", "10um"},
    {"speed", "SPEEDS", "in m/s: a list, or lognormal:min:max:median", "100"},
    {"angles", "DEGREES", "impact angles: a list", "1:90:1"},
    {"samples", "N", "impacts per angle", "100"},
    {"flux", NULL, "impacts in proportion to sin alpha1, on average --samples per angle", NULL},
    {"summary", NULL, "mean, sd and capture share per angle instead of impacts", NULL},
    {"columns", "own|ledger", "columns of the rows: the command's own, or those of a wall's ledger",
     "own"},
    {.name = NULL}};

static const char detail[] =
    "One row per impact; its outcome is rebound or deposit. cor_n, cor_t, cor_v_plane\n"
    "(v2/v1) and cor_alpha_plane (alpha2/alpha1) are those of the velocity in the plane of\n"
    "incidence, as a camera from the side sees it (alpha2 from 0 to 180 degrees).\n"
    "cor_v_space and cor_alpha_space are those of the velocity in space (alpha2 from 0 to\n"
    "90). At normal impact cor_t is undefined and empty. --columns ledger writes the rows\n"
    "of a wall's ledger in `units si` (outcome 0 or 1), for programs that read ledgers.\n"
    "--summary has a row per angle: the number of impacts, the share that sticks, and mean\n"
    "and sd of the n others; with `erosion` also eroded_mean and eroded_sd over all\n"
    "impacts, in mass worn off the wall per mass of particles. lognormal:min:max:median is\n"
    "a log-normal distribution whose logarithm has the standard deviation ln(max/min)/5,\n"
    "cut at both ends. Particles fly along x over the wall z = 0.\n";

const cli_command cli_cor = {
    .name = "cor",
    .summary = "the scatter of the coefficients of restitution on a rough wall",
    .arguments = "DESCRIPTION",
    .detail = detail,
    .examples = "  $ asperity cor surface rq 15.6um lambda_c 120um --dp lognormal:1um:100um:10um "
                "--plot cor.png -o cor.csv\n"
                "  $ asperity cor surface profile blade.csv --dp 20um --angles 5:85:5 --summary\n",
    .options = options,
    .picture = "draw the scatter; .png, .svg or .pdf",
    .run = run,
};
