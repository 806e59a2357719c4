/* asperity sensitivity: derivatives of a run's results by the roughness of its wall, and the
 * results on another wall, from its ledger. Repeats each impact from its key and computes the
 * likelihood ratios of its draws on other walls.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/sensitivity.h"
#include "cli/description.h"
#include "cli/scatter.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define STEP 1e-3           /* relative, of a derivative */
#define SAME 1e-6           /* relative error of a velocity: rows have ten digits */
#define ALONG 1e-6          /* degrees; particles that rest at the wall hit it below this angle */
#define STAYS_MOST 0.01     /* of the impacts */
#define EFFECTIVE_LEAST 100 /* particles */
#define STEEPER 1.2 /* slopes of the wall of --to: errors of errors are large from here on */
#define CLASS 10    /* degrees, of impact angles */

enum { PARAMETERS = ASPI_OTHER - ASPI_DERIVATIVE, WALLS_MOST = 2 * PARAMETERS + 1 };

typedef struct study {
  const char *path;
  cli_description own;
  uint32_t wall_key;
  const char *names[PARAMETERS]; /* rq and lambda_c, or sigma */
  size_t n_names, n_walls;       /* walls: each parameter a step up and down; that of --to */
  const asp_wall *walls[WALLS_MOST];
  bool has_other, has_erosion, has_mass; /* mass of a single particle, not of a parcel */
  aspi_drawn *drawn;
  size_t n, grains, staying;
  double effective, steeper; /* for the wall of --to: sample size, ratio of slopes */
} study;

/* ---- walls ---- */

static void add_wall(study *s, const asp_description *words) {
  s->walls[s->n_walls++] = cli_made(asp_wall_create(words, 0, 0, &cli_error));
}

/* The run's wall with another surface. */
static void add_other(study *s, const char *surface) {
  const char *rest = s->own.text + asp_description_clause(s->own.text);
  char *text = cli_allocate(strlen(surface) + strlen(rest) + 2, 1);
  sprintf(text, "%s %s", surface, rest);
  asp_description *words = asp_description_parse(text, NULL, &cli_error);
  if (!words)
    cli_bad_usage("--to is '%s', behind which '%s' stays: %s", surface, rest, cli_error.text);
  asp_description_expect_pairs(words); /* the run's */
  if (asp_description_needs_sizes(words))
    cli_bad_usage("--to is '%s'; it must be given by rq and lambda_c, or by sigma", surface);
  add_wall(s, words);
  s->has_other = true;
}

static void make_walls(study *s, const char *to) {
  static const char *const names[] = {"rq", "lambda_c", "sigma"};
  asp_description *words = s->own.words;
  const char *spread = asp_description_word(words, "spread");
  if (strcmp(spread, "traced") == 0)
    cli_bad_usage("spread is '%s', whose draws have no density, and so no likelihood ratios; it "
                  "must be a model that has one, as visible",
                  spread);
  cli_description_make(&s->own, 0, 0);
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    double value = asp_description_get(words, names[i]);
    if (!(value > 0))
      continue;
    s->names[s->n_names++] = names[i];
    for (int sign = 1; sign >= -1; sign -= 2) {
      asp_description_set(words, names[i], value * exp(sign * STEP), NULL);
      add_wall(s, words);
    }
    asp_description_set(words, names[i], value, NULL);
  }
  if (s->n_names == 0)
    cli_bad_usage("surface is '%s'; it must be given by rq and lambda_c, or by sigma",
                  asp_description_word(words, "surface"));
  if (to)
    add_other(s, to);
}

/* ---- impacts ---- */

/* The wall's name is part of the random key: --name, or the ID of the fix in the heading. */
static void take_heading(study *s, const char *name, const char *heading) {
  static const char before[] = "; fix ", behind[] = " wall/rebound";
  const char *fix = strstr(heading, before), *end = fix ? strstr(fix, behind) : NULL;
  char *own = end ? cli_copy(fix + strlen(before)) : NULL;
  if (own)
    own[strlen(own) - strlen(end)] = '\0';
  if (!own && !name)
    cli_bad_usage(
        "%s: its first line has no 'fix ID wall/rebound'; it must be the ledger that a fix wrote "
        "with 'columns full', or, with --name as 'kinematicCloud:.*', that of a cloud of OpenFOAM",
        s->path);
  s->has_mass = own != NULL;
  s->has_erosion = strstr(heading, " erosion ");
  s->wall_key = asp_key_wall(name ? name : own);
  free(own);
}

/* Repeats the impact of a row and takes the ratios of its draws. */
static void weigh(study *s, size_t line, const double fields[], aspi_drawn *d) {
  asp_impact is;
  double weights[WALLS_MOST], *self = d->self;
  asp_particle particle = {.d_p = fields[D_P],
                           .density = s->has_mass ? fields[MASS] / ASP_SPHERE_VOLUME(fields[D_P])
                                                  : s->own.density,
                           .pair = s->own.pair,
                           .temperature = fields[KELVIN] > 0 ? fields[KELVIN] : 0};
  memcpy(particle.omega, fields + SPIN, sizeof particle.omega);
  asp_key key = {asp_wall_seed(s->own.wall), s->wall_key, (uint64_t)fields[TAG],
                 (uint32_t)fields[IMPACT], 0};
  cli_must(!asp_wall_weights(s->own.wall, 1, &particle, fields + BEFORE, fields + NORMAL, &key,
                             s->n_walls, s->walls, &is, weights, &cli_error));
  const double *v = fields + AFTER;
  double off = hypot(hypot(is.v2[0] - v[0], is.v2[1] - v[1]), is.v2[2] - v[2]);
  if (!(off <= SAME * fields[V1]) || is.hits != (int)fields[HITS])
    cli_bad_usage(
        "%s:%zu: impact %u of particle %.0f left with (%.6g, %.6g, %.6g) m/s after %.0f hits; with "
        "this description it leaves with (%.6g, %.6g, %.6g) after %d: description, constants and "
        "seed must be those of the run",
        s->path, line, key.impact, fields[TAG], v[0], v[1], v[2], fields[HITS], is.v2[0], is.v2[1],
        is.v2[2], is.hits);
  for (size_t i = 0; i < s->n_names; i++)
    self[ASPI_DERIVATIVE + i] = log(weights[2 * i] / weights[2 * i + 1]) / (2 * STEP);
  if (!s->has_other)
    return;
  self[ASPI_OTHER] = weights[s->n_walls - 1];
  s->steeper = fmax(s->steeper, asp_wall_steeper(s->own.wall, s->walls[s->n_walls - 1], &particle,
                                                 fields + NORMAL));
}

static void add_row(study *s, size_t line, const double fields[]) {
  if (fields[BODY] > 0)
    cli_bad_usage("%s:%zu: particle %.0f is part of body %.0f; it must be a single sphere, since "
                  "ledgers do not contain inertia",
                  s->path, line, fields[TAG], fields[BODY]);
  s->drawn = cli_grow(s->drawn, s->n, sizeof *s->drawn);
  bool stuck = fields[OUTCOME] > 0, stays = !(fields[ALPHA1] > ALONG);
  asp_impact is = {.outcome = stuck ? ASP_DEPOSIT : ASP_REBOUND};
  memcpy(is.v2, fields + AFTER, sizeof is.v2);
  asp_coefficients cor = asp_impact_coefficients(fields + BEFORE, fields + NORMAL, &is);
  aspi_drawn *d = &s->drawn[s->n++];
  *d = (aspi_drawn){.tag = fields[TAG],
                    .row = (double)s->n,
                    .self = {[ASPI_RUN] = 1, [ASPI_OTHER] = 1},
                    .result = {stuck, stuck ? fields[MASS] : 0, fields[ERODED],
                               stays ? NAN : cor.cor_n, stays ? NAN : cor.cor_t},
                    .mesh = (int)fields[MESH],
                    .triangle = (int)fields[TRIANGLE],
                    .alpha1 = fields[ALPHA1]};
  /* A resting particle draws with another key; one that is still on its last face hits the mean
   * wall and draws nothing. */
  s->staying += stays;
  if (!stays && (fabs(fields[DELTA_ALPHA]) > 0 || fabs(fields[TILT_OUT]) > 0))
    weigh(s, line, fields, d);
}

static void read_ledger(study *s, const char *name) {
  static const int needed[] = {ALPHA1, V1, D_P, OUTCOME, MESH, TRIANGLE};
  double fields[SCATTER_COLUMNS];
  cli_scatter ledger = cli_scatter_open(s->path, PLACE);
  take_heading(s, name, ledger.table->header);
  ledger.column_of[POINT] = ledger.column_of[POINT + COR_T] =
      -1; /* unbounded at grazing incidence: computed from v */
  for (size_t i = 0; i < sizeof needed / sizeof *needed; i++)
    cli_scatter_need(&ledger, needed[i], "");
  for (int c = MASS; c < PLACE; c++)
    cli_scatter_need(&ledger, c, "; a ledger has it with 'columns full'");
  while (cli_scatter_row(&ledger, fields))
    add_row(s, ledger.table->text.line, fields);
  s->grains = aspi_drawn_order(s->drawn, s->n, &s->effective);
  if ((double)s->staying > STAYS_MOST * (double)s->n)
    cli_fail("%s: %zu of %zu impacts are of particles that rest at the wall, whose draws cannot be "
             "repeated; at most %g %% may be",
             s->path, s->staying, s->n, 100 * STAYS_MOST);
  if (!(s->effective >= EFFECTIVE_LEAST))
    cli_fail("%s: the effective sample size of its %zu particles is %.1f%s; it must be at least %d",
             s->path, s->grains, s->effective, s->has_other ? " for the wall of --to" : "",
             EFFECTIVE_LEAST);
  if (s->steeper > STEEPER)
    cli_warn("the wall of --to is %.3g times as steep as that of the run; from %g times on, rare "
             "paths count much, and the standard errors are too small",
             s->steeper, STEEPER);
}

/* ---- results ---- */

/* Groups of impacts, and the results of each. */
static const struct {
  const char *names[ASPI_RESULTS];
} levels[] = {{{"stuck_share", "deposited_mass_kg", "eroded_mass_kg"}},
              {{NULL, "deposited_mass_kg", "eroded_mass_kg"}},
              {{NULL, "deposited_mass_kg", "eroded_mass_kg"}},
              {{NULL, NULL, NULL, "cor_n", "cor_t"}}};
enum { IN_ALL, BY_MESH, BY_TRIANGLE, BY_ANGLE, LEVELS };

static double place_of(const aspi_drawn *d, int level) {
  return level == IN_ALL     ? 0
         : level == BY_MESH  ? d->mesh
         : level == BY_ANGLE ? floor(fmin(d->alpha1, 89) / CLASS)
                             : 2147483648.0 * d->mesh + d->triangle;
}

static void print_parts(FILE *out, const study *s, const aspi_derivative *found, double share) {
  for (int k = 0; k < ASPI_PARTS; k++)
    if (k < ASPI_DERIVATIVE + (int)s->n_names || (k == ASPI_OTHER && s->has_other))
      cli_row(out, ",%.6g,%.3g", found[k].value / share, found[k].se / share);
  fputc('\n', out);
}

static void print_place(FILE *out, const study *s, int level, const aspi_drawn *at, size_t n) {
  for (int result = 0; result < ASPI_RESULTS; result++) {
    aspi_derivative found[ASPI_PARTS];
    double share = result == ASPI_STUCK ? (double)s->grains : 1;
    if (!levels[level].names[result] || (result == ASPI_ERODED && !s->has_erosion))
      continue;
    aspi_sensitivity(at, n, result, s->grains, found);
    fprintf(out, "%s,", levels[level].names[result]);
    fprintf(out, level == BY_MESH || level == BY_TRIANGLE ? "%d," : "all,", at->mesh);
    fprintf(out, level == BY_TRIANGLE ? "%d," : "all,", at->triangle);
    fprintf(out, level == BY_ANGLE ? "%g" : "", CLASS * (at->place + 0.5));
    print_parts(out, s, found, share);
  }
}

static void print_all(FILE *out, const study *s) {
  fputs("result,mesh,triangle,alpha1_deg,value,value_se", out);
  for (size_t i = 0; i < s->n_names; i++)
    fprintf(out, ",d_%s,d_%s_se", s->names[i], s->names[i]);
  fputs(s->has_other ? ",to,to_se\n" : "\n", out);
  fputs("particles,all,all,", out);
  print_parts(
      out, s,
      (aspi_derivative[]){{(double)s->grains, NAN}, {NAN, NAN}, {NAN, NAN}, {s->effective, NAN}},
      1);
  for (int level = 0; level < LEVELS; level++) {
    for (size_t i = 0; i < s->n; i++)
      s->drawn[i].place = place_of(&s->drawn[i], level);
    aspi_drawn_place(s->drawn, s->n);
    for (size_t first = 0, end; first < s->n; first = end) {
      for (end = first; end < s->n && !(s->drawn[end].place > s->drawn[first].place); end++)
        ;
      print_place(out, s, level, &s->drawn[first], end - first);
    }
  }
}

static void run(cli_call *call) {
  if (call->n_words < 2)
    cli_bad_usage("sensitivity: LEDGER and the words of its wall are expected; see 'asperity "
                  "sensitivity --help'");
  study s = {.path = call->words[0]};
  s.own = cli_description_read(call->n_words - 1, call->words + 1, false);
  s.own.has_own_heat = !asp_description_is_given(s.own.words, "temperature"); /* the ledger's */
  make_walls(&s, cli_value(call, "to"));
  read_ledger(&s, cli_value(call, "name"));
  FILE *out = cli_output_open(call, "output", s.own.text);
  print_all(out, &s);
  cli_file_close(out);
}

static const cli_option options[] = {
    {"to", "SURFACE",
     "also print the results on another surface, as 'surface rq 6um lambda_c 40um'", NULL},
    {"name", "NAME", "name of the wall; default: the ID of the fix, from the ledger", NULL},
    {.name = NULL}};

static const char detail[] =
    "LEDGER is a fix's ledger file with 'columns full'; WALL is the description of its wall as in\n"
    "the script, with materials. The surface must be given by rq and lambda_c, or by sigma. The\n"
    "command repeats each impact from its random key and computes how likely its draws are on "
    "walls\n"
    "of other roughness. So one run shows how its results depend on roughness, with standard "
    "errors\n"
    "over particles: the share of particles that stick (of those that hit), the deposited and the\n"
    "eroded mass in total, per mesh and per triangle, and mean coefficients per 10 degrees of "
    "impact\n"
    "angle. d_rq is the derivative by ln rq: 10 % more rq adds 0.1 d_rq. The row 'particles' has\n"
    "their number, and in column 'to' the effective sample size, which must be at least 100.\n"
    "Likelihood ratios reweight the paths of the run; they do not add paths that no particle "
    "took:\n"
    "the wall of --to may be up to 1.4 times as steep, and there is a warning from 1.2 times on.\n";

const cli_command cli_sensitivity = {
    .name = "sensitivity",
    .arguments = "LEDGER WALL",
    .summary = "how a run's results depend on the wall's roughness, from its ledger",
    .detail = detail,
    .examples =
        "  $ asperity sensitivity impacts.csv surface rq 5um lambda_c 40um materials quartz "
        "304-ss\n",
    .options = options,
    .run = run,
};
