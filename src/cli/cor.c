/* asperity cor: the scatter of the coefficients of restitution that a wall gives (the paper's
 * figures 13 and 14), without an engine: impacts one by one on the mean wall z = 0.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cor.h"
#include "base/ledger_columns.h"
#include "base/stream.h"
#include "cli/walls.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* m/s */
#define SPEED_LEAST 1e-9
#define SPEED_MOST 1e6

static void take_list(cor_values *v, cli_list list) {
  v->list = list;
  v->least = INFINITY;
  for (size_t i = 0; i < list.count; i++) {
    v->least = fmin(v->least, list.values[i]);
    v->most = fmax(v->most, list.values[i]);
  }
}

typedef double (*reader)(const cli_option *option, const char *text);

/* min:max:median of a log-normal. */
static void take_log_normal(cor_values *v, const cli_option *option, const char *value,
                            reader read) {
  char *text = cli_copy(value);
  char *second = strchr(text, ':'), *third = second ? strchr(second + 1, ':') : NULL;
  if (!third || strchr(third + 1, ':'))
    cli_bad_usage("--%s is '%s'; a log-normal is min:max:median", option->name, option->value);
  *second = *third = '\0';
  v->least = read(option, text);
  v->most = read(option, second + 1);
  v->median = read(option, third + 1);
  if (!(v->least < v->median && v->median < v->most))
    cli_bad_usage("--%s is '%s'; a log-normal min:max:median has min < median < max", option->name,
                  option->value);
  free(text);
}

static double read_speed(const cli_option *option, const char *text) {
  cli_option one = {option->name, option->argument, option->help, text};
  return cli_number(&one, SPEED_LEAST, SPEED_MOST);
}

static void read_sizes(const cli_option *option, cor_values *v) {
  if (strchr(option->value, ':') && !strchr(option->value, ','))
    take_log_normal(v, option, option->value, cli_length_of);
  else
    take_list(v, cli_lengths(option));
}

static void read_speeds(const cli_option *option, cor_values *v) {
  static const char word[] = "lognormal:";
  if (strncmp(option->value, word, sizeof word - 1) == 0)
    take_log_normal(v, option, option->value + sizeof word - 1, read_speed);
  else
    take_list(v, cli_numbers(option, SPEED_LEAST, SPEED_MOST));
}

/* The value of a sample; of a list they come in turn. */
static double value_of(const cor_values *v, size_t sample, aspi_stream *stream) {
  if (v->list.count)
    return v->list.values[sample % v->list.count];
  for (;;) {
    double d = v->median * exp(log(v->most / v->least) / 5 * aspi_stream_normal(stream));
    if (d >= v->least && d <= v->most)
      return d;
  }
}

void cli_cor_read_wall(const cli_option *options, cor_scene *s) {
  const char *model = cli_rough_model(&options[ROUGH], &options[MODEL]);
  s->law = cli_law_read(&options[LAW]);
  s->pair = cli_law_pair(&options[LAW], &s->law, options[LAW + LAW_WALL].value);
  asp_wall *wall = s->law.wall;
  cli_rough_choose(wall, &options[TILT], &options[COLLISIONS], model);
  if (strcmp(model, "none") != 0) {
    s->rough = cli_rough_read(&options[ROUGH], s->sizes.least, s->sizes.most);
    cli_rough_put(&s->rough, wall, s->sizes.least, s->sizes.most);
  }
  cli_law_prepare(&s->law);
  if (s->rough.surface)
    cli_law_warn_double(&s->law);
}

void cli_cor_free_wall(cor_scene *s) {
  cli_law_free(&s->law);
  asp_pair_free(s->pair);
  cli_rough_free(&s->rough);
}

cor_row cli_cor_impact(const cor_scene *s, double angle, size_t sample, uint64_t tag,
                       uint32_t seed) {
  static const double n[3] = {0, 0, 1};
  asp_key key = {seed, asp_key_wall("cor"), tag, 0};
  aspi_stream stream = aspi_stream_begin(&key);
  size_t sizes = s->sizes.list.count ? s->sizes.list.count : 1;
  cor_row r = {.d_p = value_of(&s->sizes, sample, &stream), .alpha1 = angle};
  double alpha1 = cli_radians(angle), speed = value_of(&s->speeds, sample / sizes, &stream);
  double v1[3] = {speed * cos(alpha1), 0, -speed * sin(alpha1)};
  if (angle >= 90)
    v1[0] = 0;
  asp_particle particle = {.d_p = r.d_p,
                           .density = asp_material_get(s->law.particle, "density"),
                           .pair = s->pair,
                           .lay = s->rough.lay.vector};
  key.impact = 1;
  asp_wall_impact(s->law.wall, &particle, v1, n, &key, &r.impact);
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

static void make_rows(const cor_scene *s, const cli_list *angles, size_t samples, uint32_t seed,
                      cor_row *rows) {
  cli_progress progress = cli_progress_begin("impacts", (double)(angles->count * samples));
  for (size_t a = 0; a < angles->count; a++)
    for (size_t i = 0; i < samples; i++) {
      size_t tag = a * samples + i;
      rows[tag] = cli_cor_impact(s, angles->values[a], i, tag, seed);
      if (tag % 65536 == 0)
        cli_progress_show(&progress, (double)tag);
    }
  cli_progress_end(&progress);
}

static int run(int argc, char **argv) {
  cli_option options[N + 1] = {
      CLI_ROUGH_OPTIONS(ROUGH),
      [DP] = {"dp", "SIZES", "diameter, list, or min:max:median of a log-normal", "10um"},
      [SPEED] = {"speed", "SPEEDS", "in m/s: a list or from:to:step, or lognormal:min:max:median",
                 "100"},
      [ANGLES] = {"angles", "DEGREES", "impact angles: a list or from:to:step", "1:90:1"},
      [MODEL] = {"model", "NAME",
                 "spread model; none is the smooth wall [visible; of a measured wall profile]",
                 NULL},
      [SAMPLES] = {"samples", "N", "impacts per angle", "100"},
      [SEED] = {"seed", "N", "seed of the draws", "1"},
      [TILT] = {"tilt", "plane|isotropic", "tilt in the plane of incidence, or all around",
                "isotropic"},
      [COLLISIONS] = {"collisions", "single|multiple", "one hit, or as many as it takes",
                      "multiple"},
      [COLUMNS] = {"columns", "own|ledger", "of the rows: own, or those of a wall's ledger", "own"},
      [OUTPUT] = {"output", "FILE", "write there instead of to the screen", NULL},
      [PLOT] = {"plot", "FILE", "draw the scatter; .png, .svg or .pdf", NULL},
      CLI_LAW_OPTIONS(LAW),
  };
  cli_law_add_keywords(&options[LAW]);
  cli_parse(&cli_cor, argc, argv, options, false);
  bool as_ledger = cli_choice(&options[COLUMNS], "own", "ledger");
  cor_scene s = {0};
  read_sizes(&options[DP], &s.sizes);
  read_speeds(&options[SPEED], &s.speeds);
  cli_cor_read_wall(options, &s);
  cli_list angles = cli_angles(&options[ANGLES]);
  for (size_t i = 0; i < angles.count; i++)
    if (!(angles.values[i] > 0))
      cli_bad_usage("--angles is '%s'; it must be more than 0 and at most 90",
                    options[ANGLES].value);
  size_t samples = cli_whole(&options[SAMPLES], 1, 100000000), n = angles.count * samples;
  uint32_t seed = (uint32_t)cli_whole(&options[SEED], 0, UINT32_MAX);
  cor_row *rows = cli_allocate(n, sizeof *rows);
  make_rows(&s, &angles, samples, seed, rows);
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, &options[SEED]);
  print_all(cli_output_stream(output), rows, n, as_ledger);
  cli_output_close(output);
  if (options[PLOT].value)
    cli_cor_plot(options, &s, rows, n);
  free(rows);
  cli_cor_free_wall(&s);
  return 0;
}

const cli_command cli_cor = {
    .name = "cor",
    .summary = "the scatter of the coefficients of restitution on a rough wall",
    .detail =
        "One row an impact; its outcome is rebound or deposit. cor_v_plane and cor_alpha_plane "
        "are\n"
        "v2/v1 and alpha2/alpha1 of the velocity in the plane of incidence, as one camera from "
        "the\n"
        "side sees it (alpha2 from 0 to 180 degrees), like cor_n and cor_t; cor_v_space and\n"
        "cor_alpha_space are those of the velocity in space (0 to 90). With --columns ledger the "
        "rows are as\n"
        "in a wall's ledger in `units si` (outcome 0 or 1), for what reads those. Sizes as\n"
        "min:max:median are a log-normal whose ln has the standard deviation ln(max/min)/5, "
        "cut at\n"
        "both ends. An empty cor_t is undefined (normal impact).\n",
    .run = run,
};
