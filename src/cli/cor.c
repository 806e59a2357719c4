/* asperity cor: the scatter of the coefficients of restitution that a wall gives (the paper's
 * figures 13 and 14), without an engine: impacts one by one on the mean wall z = 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/ledger_columns.h"
#include "base/running.h"
#include "base/stream.h"
#include "cli/description.h"
#include "cli/cli.h"
#include "description/description.h"

#include <math.h>
#include <stdlib.h>
#include <unistd.h>

/* m/s */
#define SPEED_LEAST 1e-9
#define SPEED_MOST 1e6

/* The grid of --capture, in m and m/s. */
enum { CAPTURE_POINTS = 61 };
#define CAPTURE_SIZES 0.5e-6, 200e-6
#define CAPTURE_SPEEDS 0.1, 1000

typedef struct scene {
  cli_description wall;
  cli_list speeds, sizes; /* of a log-normal law ln has the sd ln(most/least)/5 */
  cli_list heats;         /* temperatures, K; without --temperature one 0: by the description */
} scene;

typedef struct row {
  double d_p, alpha1, kelvin;
  cli_impact of;
} row;

/* Impacts that are drawn at once. */
enum { BLOCK = 1 << 16 };

/* The value of a sample; values of a list are taken in turn. */
static double sample_of(const cli_list *v, size_t sample, aspi_stream *stream) {
  if (v->count)
    return v->values[sample % v->count];
  for (;;) {
    double d = v->median * exp(log(v->most / v->least) / 5 * aspi_stream_normal(stream));
    if (d >= v->least && d <= v->most)
      return d;
  }
}

static size_t count_of(const cli_list *v) {
  return v->count ? v->count : 1;
}

/* Combinations of the sizes, speeds and temperatures of lists. */
static size_t count_groups(const scene *s) {
  return count_of(&s->sizes) * count_of(&s->speeds) * count_of(&s->heats);
}

/* One impact at an angle in degrees. */
static row impact_at(const scene *s, double angle, size_t sample, uint64_t tag) {
  asp_key key = {asp_wall_seed(s->wall.wall), asp_key_wall("cor"), tag, 0, 0};
  aspi_stream stream = aspi_stream_begin(&key);
  size_t sizes = count_of(&s->sizes), speeds = count_of(&s->speeds);
  row r = {.d_p = sample_of(&s->sizes, sample, &stream), .alpha1 = angle};
  double speed = sample_of(&s->speeds, sample / sizes, &stream);
  r.kelvin = sample_of(&s->heats, sample / sizes / speeds, &stream);
  key.impact = 1;
  r.of = cli_impact_at(&s->wall, r.d_p, speed, r.kelvin, angle, &key);
  return r;
}

static void print_row(FILE *out, const row *r) {
  const asp_impact *i = &r->of.impact;
  const asp_coefficients *c = &r->of.cor;
  cli_row(out, "%.6g,%.6g,%.6g,%.6g,%d,%.6g,%.6g,%.6g,%.6g,%s,%.6g,%.6g", r->d_p * 1e6, c->v1,
          r->alpha1, aspi_degrees(i->delta_alpha), i->hits, c->cor_v, c->cor_alpha, c->cor_n,
          c->cor_t, i->outcome == ASP_DEPOSIT ? "deposit" : "rebound", c->cor_v_space,
          c->cor_alpha_space);
  fprintf(out, r->kelvin > 0 ? ",%.6g\n" : "\n", r->kelvin);
}

#define PRINT_NAME(ID, name, type, text) fputs(LEDGER_##ID ? "," name : name, out);

/* The impact as a wall's ledger has it in `units si`: before a primitive wall, at no time or place.
 */
static void print_ledger_row(FILE *out, const row *r, size_t tag) {
  double of[LEDGER_N_COLUMNS] = {[LEDGER_TAG] = (double)tag,
                                 [LEDGER_IMPACT] = 1,
                                 [LEDGER_D_P] = r->d_p,
                                 [LEDGER_V1] = r->of.cor.v1,
                                 [LEDGER_ALPHA1] = aspi_degrees(r->of.cor.alpha1),
                                 [LEDGER_DELTA_ALPHA] = aspi_degrees(r->of.impact.delta_alpha),
                                 [LEDGER_TILT_OUT] = aspi_degrees(r->of.impact.tilt_out),
                                 [LEDGER_HITS] = r->of.impact.hits,
                                 [LEDGER_V2] = r->of.cor.v2,
                                 [LEDGER_ALPHA2] = aspi_degrees(r->of.cor.alpha2),
                                 [LEDGER_COR_N] = r->of.cor.cor_n,
                                 [LEDGER_COR_T] = r->of.cor.cor_t,
                                 [LEDGER_OUTCOME] = r->of.impact.outcome == ASP_DEPOSIT};
  for (int i = 0; i < LEDGER_N_COLUMNS; i++) {
    cli_print_number(out, of[i], 10);
    fputc(i + 1 < LEDGER_N_COLUMNS ? ',' : '\n', out);
  }
}

static void print_header(FILE *out, bool as_ledger, bool has_heats) {
  if (as_ledger) {
    LEDGER_COLUMNS(PRINT_NAME)
    fputc('\n', out);
  } else {
    fprintf(out,
            "dp_um,v1_m_s,alpha1_deg,delta_alpha_deg,hits,cor_v_plane,cor_alpha_plane,cor_n,cor_t,"
            "outcome,cor_v_space,cor_alpha_space%s\n",
            has_heats ? ",temperature_k" : "");
  }
}

/* ---- the summary ---- */

/* Sums over the impacts of one angle, size and speed. */
typedef struct sums {
  size_t impacts, deposits;
  aspi_running cor_n, cor_t, eroded;
} sums;

static void add_to_sums(sums *to, const row *r) {
  to->impacts++;
  aspi_running_add(&to->eroded, r->of.impact.eroded);
  to->deposits += r->of.impact.outcome == ASP_DEPOSIT;
  if (isfinite(r->of.cor.cor_n))
    aspi_running_add(&to->cor_n, r->of.cor.cor_n);
  if (isfinite(r->of.cor.cor_t))
    aspi_running_add(&to->cor_t, r->of.cor.cor_t);
}

/* Mean and sd; empty if there are none. */
static void print_moments(FILE *out, const aspi_running *r) {
  cli_row(out, ",%.6g,%.6g", r->n > 0 ? r->mean : NAN, r->n > 1 ? aspi_running_sd(r) : NAN);
}

/* A value of a list that has one for each group, empty for a log-normal law. */
static double value_of_group(const cli_list *list, size_t index, double factor) {
  return list->count ? list->values[index % list->count] * factor : NAN;
}

/* Per angle, temperature, speed and size: share of deposits; mean and sd of rebounds. */
static void print_summary(FILE *out, const scene *s, const cli_list *angles, const sums *of,
                          bool erodes) {
  size_t groups = count_groups(s), sizes = count_of(&s->sizes), speeds = count_of(&s->speeds);
  fprintf(out,
          "dp_um,v1_m_s,alpha1_deg,impacts,capture_share,n,cor_n_mean,cor_n_sd,cor_t_mean,"
          "cor_t_sd%s%s\n",
          erodes ? ",eroded_mean,eroded_sd" : "", s->wall.has_own_heat ? ",temperature_k" : "");
  for (size_t i = 0; i < angles->count * groups; i++) {
    const sums *one = &of[i];
    cli_row(out, "%.6g,%.6g,%.6g,%zu,%.6g,%zu", value_of_group(&s->sizes, i % groups, 1e6),
            value_of_group(&s->speeds, i % groups / sizes, 1), angles->values[i / groups],
            one->impacts, (double)one->deposits / (double)one->impacts,
            one->impacts - one->deposits);
    print_moments(out, &one->cor_n);
    print_moments(out, &one->cor_t);
    if (erodes)
      print_moments(out, &one->eroded);
    double kelvin = value_of_group(&s->heats, i % groups / sizes / speeds, 1);
    fprintf(out, kelvin > 0 ? ",%.6g\n" : "\n", kelvin);
  }
}

/* ---- the command ---- */

/* Destinations of an impact: rows, sums; NULL: not wanted. */
typedef struct sink {
  FILE *rows;
  bool as_ledger;
  sums *sums;
  cli_progress progress;
} sink;

/* Draws the impacts at one angle, on all cores: each has random numbers of its own. `tag` is the
 * number of the first one. */
static void draw_angle(const scene *s, double angle, size_t count, size_t tag, row *rows, sink *to,
                       sums *of) {
  size_t groups = count_groups(s);
  for (size_t first = 0; first < count; first += BLOCK) {
    size_t n = count - first < BLOCK ? count - first : BLOCK;
#pragma omp parallel for
    for (size_t i = 0; i < n; i++)
      rows[i] = impact_at(s, angle, first + i, tag + first + i);
    for (size_t i = 0; i < n; i++)
      if (of)
        add_to_sums(&of[(first + i) % groups], &rows[i]);
      else if (to->as_ledger)
        print_ledger_row(to->rows, &rows[i], tag + first + i + 1);
      else
        print_row(to->rows, &rows[i]);
    cli_progress_show(&to->progress, (double)(tag + first));
  }
}

static void draw(const scene *s, const cli_list *angles, size_t samples, sink *to) {
  to->progress.shown = INFINITY; /* no bar among rows on the screen */
  if (to->rows != stdout || !isatty(STDOUT_FILENO))
    to->progress = cli_progress_begin("impacts", (double)(samples * angles->count));
  row *rows = cli_allocate(BLOCK, sizeof *rows);
  for (size_t a = 0; a < angles->count; a++)
    draw_angle(s, angles->values[a], samples, a * samples, rows, to,
               to->sums ? to->sums + a * count_groups(s) : NULL);
  free(rows);
  cli_progress_end(&to->progress);
}

/* Values between two ends, in equal ratios. */
static cli_list ratios(double from, double to) {
  cli_list list = {.values = cli_allocate(CAPTURE_POINTS, sizeof *list.values),
                   .count = CAPTURE_POINTS,
                   .least = from,
                   .most = to};
  for (int i = 0; i < CAPTURE_POINTS; i++)
    list.values[i] = fmin(from * pow(to / from, i / (CAPTURE_POINTS - 1.)), to);
  return list;
}

/* Exits if the grid of --capture is not a rising list. */
static void check_grid(const char *option, const cli_list *list) {
  if (list->count == 0)
    cli_bad_usage("--%s is a log-normal law; --capture takes a list", option);
  for (size_t i = 1; i < list->count; i++)
    if (!(list->values[i] > list->values[i - 1]))
      cli_bad_usage("--%s has %g behind %g (SI); for --capture its values must rise", option,
                    list->values[i], list->values[i - 1]);
}

/* The sizes, speeds and temperatures, or their defaults. */
static scene read_scene(cli_call *call, bool capture) {
  static double none[] = {0};
  scene s = {.wall = cli_description_read(call->n_words, call->words, false),
             .heats = {.values = none, .count = 1}};
  s.wall.has_own_heat = cli_value(call, "temperature");
  if (s.wall.has_own_heat)
    s.heats = cli_values(cli_get(call, "temperature"), "K", 1, 1e5);
  if (s.wall.has_own_heat && (capture || s.heats.count == 0))
    cli_bad_usage(capture ? "--temperature is given with --capture; say 'temperature T' behind "
                            "'rebound LAW' instead"
                          : "--temperature takes a list");
  cli_default(call, "dp", capture ? NULL : "10um");
  cli_default(call, "speed", capture ? NULL : "100");
  cli_default(call, "angles", capture ? "90" : "1:90:1");
  s.sizes = cli_value(call, "dp") ? cli_values(cli_get(call, "dp"), "length", 0, INFINITY)
                                  : ratios(CAPTURE_SIZES);
  s.speeds = cli_value(call, "speed")
                 ? cli_values(cli_get(call, "speed"), "speed", SPEED_LEAST, SPEED_MOST)
                 : ratios(CAPTURE_SPEEDS);
  if (capture) {
    check_grid("dp", &s.sizes);
    check_grid("speed", &s.speeds);
  }
  return s;
}

static void run(cli_call *call) {
  bool as_ledger = cli_choice(cli_get(call, "columns")), capture = cli_value(call, "capture");
  bool summary = cli_value(call, "summary") || capture;
  if (as_ledger && summary)
    cli_bad_usage("--columns ledger is given with --%s, which has columns of its own",
                  capture ? "capture" : "summary");
  scene s = read_scene(call, capture);
  cli_list angles = cli_impact_angles(call);
  if (capture && angles.count != 1)
    cli_bad_usage("--angles is '%s'; --capture takes one angle", cli_value(call, "angles"));
  size_t samples = cli_whole(cli_get(call, "samples"), 1, 100000000) * count_groups(&s);
  cli_description_make(&s.wall, s.sizes.least, s.sizes.most);
  cli_description_doubt_angles(&s.wall, &angles);
  for (size_t i = 0; i < s.heats.count; i++)
    if (asp_wall_sticking(s.wall.wall, s.heats.values[i], NULL, &cli_error))
      cli_bad_usage("--temperature: %s", cli_error.text);
  FILE *out = cli_table_open(call, s.wall.text);
  sink to = {.rows = summary ? NULL : out, .as_ledger = as_ledger};
  if (summary)
    to.sums = cli_allocate(angles.count * count_groups(&s), sizeof *to.sums);
  else
    print_header(out, as_ledger, s.wall.has_own_heat);
  draw(&s, &angles, samples, &to);
  if (summary)
    print_summary(out, &s, &angles, to.sums, asp_description_is_given(s.wall.words, "erosion"));
  cli_table_close(call, out, capture ? "capture" : summary ? "summary" : "cor");
}

static const cli_option options[] = {
    {"dp", "SIZES", "diameters: a list, or lognormal:min:max:median [10um]", NULL},
    {"speed", "SPEEDS", "in m/s: a list, or lognormal:min:max:median [100]", NULL},
    {"temperature", "KELVIN", "of the particles: a list [by the description]", NULL},
    {"angles", "DEGREES", "impact angles: a list [1:90:1]", NULL},
    {"samples", "N", "impacts per angle, size, speed and temperature", "100"},
    {"summary", NULL,
     "mean, sd and capture share per angle, size, speed and temperature instead of impacts", NULL},
    {"capture", NULL, "the share that sticks, over diameter and speed at one angle", NULL},
    {"columns", "own|ledger", "columns of the rows: the command's own, or those of a wall's ledger",
     "own"},
    {.name = NULL}};

static const char detail[] =
    "One row per impact; its outcome is rebound or deposit. Particles fly along x over the\n"
    "wall z = 0. cor_n, cor_t, cor_v_plane (v2/v1) and cor_alpha_plane (alpha2/alpha1)\n"
    "refer to the velocity in the plane of incidence, as a camera from the side sees it\n"
    "(alpha2 from 0 to 180 degrees); cor_v_space and cor_alpha_space refer to the velocity\n"
    "in space (alpha2 from 0 to 90). At normal impact cor_t is undefined and empty,\n"
    "and so are cor_n and cor_alpha of a particle that slides.\n"
    "--temperature adds a last column, temperature_k.\n"
    "--summary has one row per angle, size and speed instead: the number of impacts, the\n"
    "share that sticks, and mean and sd of the coefficients of the n that rebound; with\n"
    "`erosion` also mean and sd of the mass worn off the wall per mass of particles, over\n"
    "all impacts. --capture has these rows for diameters from 0.5 to 200 um and speeds from\n"
    "0.1 to 1000 m/s at one angle (90 degrees); its picture shows the share that sticks.\n"
    "--columns ledger writes the columns of a wall's ledger in `units si`\n"
    "(outcome 0 or 1). lognormal:min:max:median is a log-normal distribution cut at min and\n"
    "max; its logarithm has the standard deviation ln(max/min)/5.\n";

const cli_command cli_cor = {
    .name = "cor",
    .summary = "the scatter of the coefficients of restitution on a rough wall",
    .arguments = "DESCRIPTION",
    .detail = detail,
    .examples = "  $ asperity cor surface rq 15.6um lambda_c 120um --dp lognormal:1um:100um:10um "
                "--plot cor.png -o cor.csv\n"
                "  $ asperity cor surface profile blade.csv --dp 20um --angles 5:85:5 --summary\n"
                "  $ asperity cor surface rq 5um lambda_c 40um materials ard ti-6al-4v --capture "
                "--plot capture.png\n",
    .options = options,
    .picture = "draw the scatter, or the share that sticks; .png, .svg or .pdf",
    .run = run,
};
