/* asperity calibrate: the constants of a wall and of a law from measured scatter: which are looked
 * for, where the measurements are put together, and what is told of the result. analysis/fit.c
 * finds them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/calibrate.h"
#include "rebound/laws.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Simulated impacts for each measured one, where --samples does not say. */
enum { TIMES = 10, SAMPLES_LEAST = 2000, SAMPLES_MOST = 20000 };

/* Unknowns whose estimates hang together by more than this, or that are known worse than this share
 * of their value, cannot be told from the data. */
#define CORRELATED 0.95
#define VAGUE 1.0

/* Bounds of the search for an unknown without bounds of its own, as logarithms of shares of where
 * it begins; and on the logistic scale of one with bounds. */
#define LOG_DOWN 6.9
#define LOG_UP 3.4
#define LOGISTIC 6.0

/* What is taken for the error of a mean of which nothing is known, before the fit tells. */
#define ERROR_UNKNOWN 0.01

/* And for the number of impacts where only their scatter is known: that of means and that of
 * standard deviations then count alike. */
#define IMPACTS_UNKNOWN 20

/* Degrees, where the search for sigma begins. */
#define SIGMA_START 5

/* ---- what is looked for -----------------------------------------------------------------------
 */

static const struct {
  const char *word, *name, *unit;
  int kind;
  double least, most;
} walls[] = {
    {"sigma", "sigma", "deg", OF_SIGMA, 0.01, 50},
    {"rq", "rq", "um", OF_RQ, 0, INFINITY},
    {"lambda_c", "lambda_c", "um", OF_LAMBDA_C, 0, INFINITY},
    {"friction", "friction", "", OF_PAIR, 0, 1e3},
    {"mu", "friction", "", OF_PAIR, 0, 1e3},
    {"yield_stress", "yield_stress", "Pa", OF_PAIR, 0, 1e15},
    {"surface_energy", "surface_energy", "J/m^2", OF_PAIR, 0, 1e9},
    {"gamma", "surface_energy", "J/m^2", OF_PAIR, 0, 1e9},
};
enum { N_WALLS = sizeof walls / sizeof *walls };

static double start_of(const calibration *c, const calibrate_unknown *u) {
  switch (u->kind) {
  case OF_SIGMA:
    return c->sigma;
  case OF_RQ:
    return c->r_q * 1e6;
  case OF_LAMBDA_C:
    return c->lambda_c * 1e6;
  case OF_PAIR:
    return asp_pair_get(c->pair, u->name);
  default:
    return asp_wall_get(c->law.wall, u->name);
  }
}

/* Whether the wall can have such an unknown; a law's own parameter goes before the pair's number of
 * that name. */
static bool find_unknown(const calibration *c, const char *word, calibrate_unknown *u) {
  const asp_rebound_law *law = asp_wall_rebound(c->law.wall);
  for (int i = 0; i < asp_rebound_parameters(law); i++) {
    const asp_parameter *p = asp_rebound_parameter(law, i);
    if (strcmp(asp_parameter_name(p), word) != 0 || *asp_parameter_words(p))
      continue;
    *u = (calibrate_unknown){.unit = asp_parameter_unit(p),
                             .kind = OF_LAW,
                             .least = asp_parameter_least(p),
                             .most = asp_parameter_most(p)};
    snprintf(u->name, sizeof u->name, "%s", word);
    u->bounded = u->most - u->least <= 10;
    return true;
  }
  for (int i = 0; i < N_WALLS; i++) {
    bool pair = walls[i].kind == OF_PAIR;
    if (strcmp(walls[i].word, word) != 0 || (pair && !asp_rebound_needs_pair(law)))
      continue;
    *u = (calibrate_unknown){.unit = walls[i].unit,
                             .kind = walls[i].kind,
                             .least = walls[i].least,
                             .most = walls[i].most};
    snprintf(u->name, sizeof u->name, "%s", walls[i].name);
    return true;
  }
  return false;
}

static void fail_unknown(const calibration *c, const char *word) {
  const asp_rebound_law *law = asp_wall_rebound(c->law.wall);
  char list[300] = "sigma, or rq and lambda_c";
  if (asp_rebound_needs_pair(law))
    strcat(list, ", yield_stress surface_energy friction");
  for (int i = 0; i < asp_rebound_parameters(law); i++) {
    size_t used = strlen(list);
    snprintf(list + used, sizeof list - used, "%s%s", i ? " " : ", ",
             asp_parameter_name(asp_rebound_parameter(law, i)));
  }
  cli_bad_usage("--fit: '%s' is unknown to a wall with rebound law '%s'; there are: %s", word,
                asp_rebound_name(law), list);
}

static void read_unknowns(calibration *c) {
  const cli_option *option = &c->options[FIT];
  if (!option->value)
    cli_bad_usage("--fit is missing; it names what to look for, as --fit sigma,friction");
  char *text = cli_copy(option->value);
  for (char *word = strtok(text, ","); word; word = strtok(NULL, ",")) {
    if (c->n_unknown == FIT_UNKNOWNS_MOST)
      cli_bad_usage("--fit is '%s'; it must be at most %d names", option->value, FIT_UNKNOWNS_MOST);
    calibrate_unknown *u = &c->unknown[c->n_unknown++];
    if (!find_unknown(c, word, u))
      fail_unknown(c, word);
    bool by_sigma = c->sigma >= 0, given = cli_rough_measured(&c->options[ROUGH]);
    if (u->kind <= OF_LAMBDA_C && given)
      cli_bad_usage("--fit: '%s' is given by the measured wall; name constants of the law",
                    u->name);
    if (u->kind <= OF_LAMBDA_C && (c->smooth || (u->kind == OF_SIGMA) != by_sigma))
      cli_bad_usage("--fit: '%s' goes with %s", u->name,
                    u->kind == OF_SIGMA ? "a rough wall (--model) that is not given by --rq"
                                        : "a rough wall given by --rq and --lambda-c");
    for (size_t k = 0; k + 1 < c->n_unknown; k++)
      if (strcmp(c->unknown[k].name, u->name) == 0)
        cli_bad_usage("--fit is '%s'; '%s' is there twice", option->value, u->name);
    double room = u->bounded ? 0.02 * (u->most - u->least) : 0;
    u->start = fmin(fmax(start_of(c, u), u->least + room), u->bounded ? u->most - room : 1e300);
    if (!(u->start > 0))
      cli_bad_usage("--fit: the value of '%s' that the search begins with is %g; it must be more "
                    "than 0",
                    u->name, u->start);
  }
  free(text);
}

/* ---- the measurements -------------------------------------------------------------------------
 */

/* A row of means; sd and n where they are known. */
static void take_means(calibration *c, size_t b) {
  const measured_row *row = &c->data.rows[c->bins[b].first];
  aspi_group *g = &c->groups[b];
  double alpha = cli_radians(row->degrees), by[COR_BOTH] = {sin(alpha), cos(alpha)};
  bool scatter = row->sd[COR_N] > 0 || row->sd[COR_T] > 0, counted = row->n > 0;
  g->n = counted ? row->n : scatter && !c->smooth ? IMPACTS_UNKNOWN : 1;
  for (int k = 0; k < COR_BOTH && !(row->n > 0); k++)
    if (row->se[k] > 0 && row->sd[k] > 0 && (counted = true))
      g->n = fmax(1, row->sd[k] * row->sd[k] / (row->se[k] * row->se[k]));
  for (int k = 0; k < COR_BOTH; k++) {
    g->used[MOMENT_X + k] = isfinite(row->cor[k]) && (k == COR_N || row->degrees < 90);
    g->used[MOMENT_XX + k] = g->used[MOMENT_X + k] && row->sd[k] > 0 && !c->smooth;
    g->mean[k] = row->cor[k] * by[k];
    g->sd[k] = (row->sd[k] > 0 ? row->sd[k] : 0) * by[k];
    g->se[k] = (row->se[k] > 0 ? row->se[k] : NAN) * by[k];
    if (!(row->sd[k] > 0) && !(row->se[k] > 0))
      g->se[k] = ERROR_UNKNOWN * by[k];
    c->known = c->known && (counted || row->se[k] > 0 || !g->used[MOMENT_X + k]);
    g->by_data = g->by_data || (g->used[MOMENT_X + k] && g->n <= 1);
  }
}

static void read_data(calibration *c, const char *path) {
  const cli_option *bin = &c->options[BIN];
  double width = cli_number(bin, 0.1, 90);
  c->data = measured_read(path, &c->options[MEASURED]);
  measured_need_view(path, &c->data, !c->smooth && strcmp(c->options[TILT].value, "plane") != 0);
  c->known = true;
  c->bins = cli_allocate(c->data.count, sizeof *c->bins);
  for (size_t i = 0; i < c->data.count; i++) {
    double degrees = c->data.rows[i].degrees;
    calibrate_bin *last = c->n_bins ? &c->bins[c->n_bins - 1] : NULL;
    bool joins = last && !c->data.means &&
                 floor(fmin(degrees, 90 - 1e-6) / width + 1e-9) <=
                     floor(fmin(c->data.rows[last->first].degrees, 90 - 1e-6) / width + 1e-9);
    if (!joins)
      c->bins[c->n_bins++] = (calibrate_bin){.first = i};
    c->bins[c->n_bins - 1].end = i + 1;
  }
  c->groups = cli_allocate(c->n_bins, sizeof *c->groups);
  double most = 0;
  size_t n_moments = 0;
  for (size_t b = 0; b < c->n_bins; b++) {
    calibrate_bin *on = &c->bins[b];
    for (size_t i = on->first; i < on->end; i++)
      on->degrees += c->data.rows[i].degrees / (double)(on->end - on->first);
    if (c->data.means)
      take_means(c, b);
    else
      calibrate_take_impacts(c, b);
    for (int k = 0; k < MOMENTS; k++)
      n_moments += c->groups[b].used[k];
    most = fmax(most, c->groups[b].n);
  }
  size_t wanted = (size_t)fmin(fmax(TIMES * most, SAMPLES_LEAST), SAMPLES_MOST);
  c->samples = c->options[SAMPLES].value ? cli_whole(&c->options[SAMPLES], 100, 100000000) : wanted;
  if (n_moments < c->n_unknown)
    cli_fail("%s: it has %zu moments for %zu unknowns; --fit must name fewer", path, n_moments,
             c->n_unknown);
}

/* ---- the fit ----------------------------------------------------------------------------------
 */

static void show_progress(void *context, double share) {
  calibration *c = context;
  cli_progress_show(&c->progress, share);
}

static aspi_fit find_unknowns(calibration *c) {
  aspi_fit_problem p = {.context = c,
                        .set = calibrate_set,
                        .draw = calibrate_draw,
                        .groups = c->groups,
                        .n_groups = c->n_bins,
                        .n_unknowns = c->n_unknown,
                        .samples = c->samples,
                        .huber = c->huber,
                        .scatters =
                            !c->smooth || c->noise[0] > 0 || c->noise[1] > 0 || c->noise_speed > 0,
                        .known = c->known,
                        .progress = show_progress};
  for (size_t j = 0; j < c->n_unknown; j++) {
    const calibrate_unknown *u = &c->unknown[j];
    double start = calibrate_scaled(u, u->start);
    p.low[j] = u->bounded ? -LOGISTIC : fmax(start - LOG_DOWN, log(u->least));
    p.high[j] = u->bounded ? LOGISTIC : fmin(start + LOG_UP, log(u->most));
    p.start[j] = fmin(fmax(start, p.low[j]), p.high[j]);
  }
  aspi_fit f;
  c->progress = cli_progress_begin("fit", 1);
  if (!aspi_fit_run(&p, &f))
    cli_fail("no wall or law has moments like those of the data, or there is no memory; see the "
             "values that the search begins with");
  cli_progress_end(&c->progress);
  return f;
}

/* ---- output -----------------------------------------------------------------------------------
 */

static double value_of(const calibration *c, const aspi_fit *f, size_t i) {
  return calibrate_value(&c->unknown[i], f->at[i]);
}

static double error_of(const calibration *c, const aspi_fit *f, size_t i) {
  return calibrate_slope(&c->unknown[i], f->at[i]) * f->error[i];
}

/* The ends of an interval, NAN where there is none but a bound. */
static double end_of(const calibration *c, size_t i, double scaled) {
  return isfinite(scaled) ? calibrate_value(&c->unknown[i], scaled) : NAN;
}

/* What the data say of an unknown whose minimum is at a bound, or so near that they cannot tell. */
static bool bound_of(const calibration *c, const aspi_fit *f, size_t i, char *text, size_t size) {
  const calibrate_unknown *u = &c->unknown[i];
  double low = end_of(c, i, f->low[i]), high = end_of(c, i, f->high[i]);
  const char *space = *u->unit ? " " : "";
  if (isfinite(low) && isfinite(high))
    return false;
  if (isfinite(high))
    snprintf(text, size, "%s < %.3g%s%s at 95 %%", u->name, high, space, u->unit);
  else if (isfinite(low))
    snprintf(text, size, "%s > %.3g%s%s at 95 %%", u->name, low, space, u->unit);
  else
    snprintf(text, size, "the data say nothing of %s", u->name);
  return true;
}

static void warn_of_doubt(const calibration *c, const aspi_fit *f) {
  for (size_t i = 0; i < c->n_unknown; i++) {
    char text[120];
    for (size_t k = 0; k < i; k++)
      if (fabs(f->correlation[i][k]) >= CORRELATED)
        cli_warn("the data cannot tell '%s' and '%s' apart (correlation %.3f); fix one of them, or "
                 "measure at other angles, speeds or sizes",
                 c->unknown[k].name, c->unknown[i].name, f->correlation[i][k]);
    double value = value_of(c, f, i), error = error_of(c, f, i);
    if (bound_of(c, f, i, text, sizeof text))
      cli_warn("%s: the minimum is at a bound, or too near to tell", text);
    else if (!(error < VAGUE * value))
      cli_warn("the data say little of '%s': %g, from %g to %g at 95 %%", c->unknown[i].name, value,
               end_of(c, i, f->low[i]), end_of(c, i, f->high[i]));
  }
  double p = f->dof > 0 ? gsl_cdf_chisq_Q(f->chi2, f->dof) : 1;
  if (c->known && f->dof > 0 && p < 1e-3)
    cli_warn("the model does not describe the data: chi^2/dof is %.3g (p %.2g)%s", f->chi2 / f->dof,
             p, f->described ? "" : "; the standard errors are scaled by its root");
  if (!f->converged)
    cli_warn("weights and values have not settled; --samples with more may help");
  if (f->interval[0] == BY_BOOTSTRAP)
    cli_warn("impacts are too few for intervals by standard errors; these are from synthetic data "
             "sets that were fitted anew");
}

/* The wall and the law as a script of an engine says them. */
static void print_surface(FILE *out, const calibration *c) {
  const cli_option *o = &c->options[ROUGH];
  if (c->rough.profile || c->rough.map) {
    fputs(c->rough.map ? "surface map " : "surface profile ", out);
    cli_print_comment(out, c->rough.map ? o[ROUGH_MAP].value : o[ROUGH_PROFILE].value);
  } else {
    fprintf(out, "surface rq %.6g lambda_c %.6g", asp_surface_r_q(c->rough.surface),
            asp_surface_lambda_c(c->rough.surface));
    if (c->stretch < 1 || c->stretch > 1)
      fprintf(out, " %.6g", asp_surface_lambda_along(c->rough.surface));
  }
  if (o[ROUGH_LAY].value || c->stretch < 1 || c->stretch > 1)
    fputs(" lay X Y Z", out);
  fprintf(out, " spread %s %s collisions %s", asp_spread_name(asp_wall_spread(c->law.wall)),
          c->options[TILT].value, c->options[COLLISIONS].value);
}

static void print_script(FILE *out, const calibration *c) {
  const asp_rebound_law *law = asp_wall_rebound(c->law.wall);
  fputs("# script: fix wall all wall/rebound ... ", out);
  if (c->smooth)
    fputs("surface smooth", out);
  else
    print_surface(out, c);
  fprintf(out, " rebound %s", asp_rebound_name(law));
  const char *last = "";
  for (int i = 0; i < asp_rebound_parameters(law); i++) {
    const asp_parameter *p = asp_rebound_parameter(law, i);
    const char *keyword = asp_parameter_keyword(p);
    double value = asp_wall_get(c->law.wall, asp_parameter_name(p));
    bool wanted = !*keyword; /* a keyword is said where one of its numbers is not the default */
    for (int k = 0; k < asp_rebound_parameters(law) && !wanted; k++) {
      const asp_parameter *other = asp_rebound_parameter(law, k);
      wanted = strcmp(asp_parameter_keyword(other), keyword) == 0 &&
               fabs(asp_wall_get(c->law.wall, asp_parameter_name(other)) -
                    asp_parameter_default(other)) > 0;
    }
    if (!wanted)
      continue;
    if (*keyword && strcmp(keyword, last) != 0)
      fprintf(out, " %s", keyword);
    if (*asp_parameter_words(p))
      fputs(value > 0 ? " on" : " off", out);
    else
      fprintf(out, " %.6g", value);
    last = keyword;
  }
  fputc('\n', out);
  if (asp_rebound_needs_pair(law))
    fprintf(out,
            "# script: yieldStress of the particle %.6g, surfaceEnergy %.6g, coefficientFriction "
            "%.6g (fix property/global, SI)\n",
            asp_pair_get(c->pair, "yield_stress"), asp_pair_get(c->pair, "surface_energy"),
            asp_pair_get(c->pair, "friction"));
  if (c->sigma >= 0 && !c->smooth)
    fprintf(out,
            "# sigma is what the particles meet: any rq and lambda_c with rq/lambda_c = %.6g that "
            "are large against them do\n",
            asp_surface_phi_r(c->rough.surface));
}

static void print_number(FILE *out, double value) {
  if (isfinite(value))
    fprintf(out, ",%.6g", value);
  else
    fputc(',', out);
}

static void print_unknown(FILE *out, const calibration *c, const aspi_fit *f, size_t i) {
  char text[120];
  bool bound = bound_of(c, f, i, text, sizeof text);
  fprintf(out, "%s,%.6g", c->unknown[i].name, value_of(c, f, i));
  print_number(out, bound ? NAN : error_of(c, f, i));
  print_number(out, end_of(c, i, f->low[i]));
  print_number(out, end_of(c, i, f->high[i]));
  fprintf(out, ",%s\n", c->unknown[i].unit);
}

static void print_all(FILE *out, const calibration *c, const aspi_fit *f) {
  static const char *const ways[] = {"", "the rise of chi^2", "synthetic data sets fitted anew"};
  double all = 0;
  for (size_t b = 0; b < c->n_bins; b++)
    all += c->groups[b].n;
  fputs("parameter,estimate,standard_error,low_95,high_95,unit\n", out);
  for (size_t i = 0; i < c->n_unknown; i++)
    print_unknown(out, c, f, i);
  for (size_t i = 0; i < c->n_unknown; i++) {
    char text[120];
    for (size_t k = 0; k < i; k++)
      fprintf(out, "# correlation of %s and %s: %.3f\n", c->unknown[k].name, c->unknown[i].name,
              f->correlation[i][k]);
    if (bound_of(c, f, i, text, sizeof text))
      fprintf(out, "# %s\n", text);
    if (f->interval[i] != BY_ERROR)
      fprintf(out, "# interval of %s by %s\n", c->unknown[i].name, ways[f->interval[i]]);
  }
  fprintf(out, "# the best of %zu starts, of which %zu agree\n", f->starts, f->agreed);
  fprintf(out, "# chi^2/dof %.4g: chi^2 %.6g, %.0f degrees of freedom, %zu bins",
          f->dof > 0 ? f->chi2 / f->dof : 0, f->chi2, f->dof, c->n_bins);
  if (c->known)
    fprintf(out, ", %.0f impacts, p %.3g\n", all,
            f->dof > 0 ? gsl_cdf_chisq_Q(f->chi2, f->dof) : 1);
  else
    fputs("; the data do not say how sure their means are, so the standard errors are scaled by "
          "its root\n",
          out);
  print_script(out, c);
}

/* ---- the command ------------------------------------------------------------------------------
 */

/* The wall's numbers, which may be unknown; a measured wall is read when the sizes are known. */
static void read_rough(calibration *c) {
  const cli_option *o = &c->options[ROUGH];
  cli_rough_check(o);
  c->stretch = 1;
  c->sigma = cli_rough_measured(o) ? -1 : SIGMA_START;
  c->rough.lay.vector[0] = 1;
  if (o[ROUGH_SIGMA].value)
    c->sigma = cli_number(&o[ROUGH_SIGMA], 0.01, 50);
  if (!o[ROUGH_RQ].value && !o[ROUGH_LAMBDA_C].value)
    return;
  if (!o[ROUGH_RQ].value || !o[ROUGH_LAMBDA_C].value)
    cli_bad_usage("--rq and --lambda-c go together; one that is fitted is where the search begins");
  c->sigma = -1;
  c->r_q = cli_length(&o[ROUGH_RQ]);
  c->rough.lay = cli_lay_of(&o[ROUGH_LAMBDA_C], &o[ROUGH_LAY]);
  c->lambda_c = c->rough.lay.lambda[0];
  c->stretch = c->rough.lay.lambda[1] / c->lambda_c;
}

/* Reads a measured wall, for the data's diameters, and makes its law, once. */
static void read_measured_wall(calibration *c) {
  const cli_option *o = &c->options[ROUGH];
  if (c->smooth || !cli_rough_measured(o))
    return;
  double least = INFINITY, most = 0;
  for (size_t i = 0; i < c->data.count; i++) {
    double d_p = isnan(c->data.rows[i].d_p) ? c->d_p : c->data.rows[i].d_p;
    least = fmin(least, d_p);
    most = fmax(most, d_p);
  }
  c->rough = cli_rough_read(o, least, most);
  cli_rough_put(&c->rough, c->law.wall, least, most);
  cli_law_prepare(&c->law);
}

static void read_wall(calibration *c) {
  const cli_option *options = c->options;
  const char *model = cli_rough_model(&options[ROUGH], &options[MODEL]);
  c->law = cli_law_read(&options[LAW]);
  c->pair = cli_law_pair(&options[LAW], &c->law, options[LAW + LAW_WALL].value);
  asp_wall *wall = c->law.wall;
  cli_rough_choose(wall, &options[TILT], &options[COLLISIONS], model);
  if (!cli_rough_measured(&options[ROUGH]) && asp_spread_needs_profile(asp_wall_spread(wall)))
    cli_bad_usage("--model is '%s', which is made for one wall; it must be one that takes any "
                  "sigma, as visible or weibull",
                  model);
  c->smooth = strcmp(model, "none") == 0;
  c->sticks = asp_rebound_needs_pair(asp_wall_rebound(wall)) && asp_wall_get(wall, "deposit") > 0;
  read_rough(c);
  c->d_p = cli_length(&options[DP]);
  c->speed = cli_number(&options[SPEED], 1e-9, 1e6);
  cli_list noise = cli_numbers(&options[NOISE], 0, 90);
  if (noise.count < 1 || noise.count > 3)
    cli_bad_usage("--noise is '%s'; it must be %s", options[NOISE].value, options[NOISE].argument);
  c->noise[0] = noise.values[0];
  c->noise[1] = noise.values[noise.count > 1];
  c->noise_speed = noise.count > 2 ? noise.values[2] : 0;
  free(noise.values);
  c->huber = options[HUBER].value ? cli_number(&options[HUBER], 1, 100) : INFINITY;
  c->seed = (uint32_t)cli_whole(&options[SEED], 0, UINT32_MAX);
}

static int run(int argc, char **argv) {
  cli_option options[N + 1] = {
      [FIT] = {"fit", "NAME,...", "what to look for: sigma, or rq, lambda_c; constants of the law",
               NULL},
      CLI_ROUGH_OPTIONS(ROUGH),
      [MODEL] = {"model", "NAME",
                 "spread model; none is the smooth wall [visible; of a measured wall profile]",
                 NULL},
      [TILT] = {"tilt", "plane|isotropic", "tilt in the plane of incidence, or all around",
                "isotropic"},
      [COLLISIONS] = {"collisions", "single|multiple", "one hit, or as many as it takes",
                      "multiple"},
      [DP] = {"dp", "LENGTH", "diameter, where the data have none", "10um"},
      [SPEED] = {"speed", "M_PER_S", "impact speed, where the data have none", "100"},
      [NOISE] = {"noise", "DEGREES[,DEGREES[,SHARE]]",
                 "sd of the measured impact angles, of the rebound angles [the same], and of the "
                 "speeds as a share of them",
                 "0"},
      [HUBER] = {"huber", "WIDTHS",
                 "against outliers: rebounds farther out than this many robust standard deviations "
                 "count as so far; 2 is usual",
                 NULL},
      MEASURED_OPTIONS(MEASURED),
      [BIN] = {"bin", "DEGREES", "width of the bins that impacts are put into", "5"},
      [SAMPLES] = {"samples", "N", "simulated impacts a bin; 10 for a measured one, 2000 to 20000",
                   NULL},
      [SEED] = {"seed", "N", "seed of the draws", "1"},
      [OUTPUT] = {"output", "FILE", "write there instead of to the screen", NULL},
      [PLOT] = {"plot", "FILE", "draw data and fitted model; .png, .svg or .pdf", NULL},
      CLI_LAW_OPTIONS(LAW),
  };
  cli_law_add_keywords(&options[LAW]);
  int first = cli_parse(&cli_calibrate, argc, argv, options, true);
  if (argc - first != 1)
    cli_bad_usage("calibrate: DATA is expected, one file; see 'asperity calibrate --help'");
  calibration c = {.options = options};
  read_wall(&c);
  read_unknowns(&c);
  read_data(&c, argv[first]);
  read_measured_wall(&c);
  aspi_fit f = find_unknowns(&c);
  warn_of_doubt(&c, &f);
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, NULL);
  print_all(cli_output_stream(output), &c, &f);
  cli_output_close(output);
  if (options[PLOT].value) {
    char title[300] = "";
    for (size_t i = 0; i < c.n_unknown; i++) {
      size_t used = strlen(title);
      snprintf(title + used, sizeof title - used, "%s%s %.4g ± %.2g %s", i ? ",  " : "",
               c.unknown[i].name, value_of(&c, &f, i), error_of(&c, &f, i), c.unknown[i].unit);
    }
    cli_calibrate_plot(&options[PLOT], &c, argv[first], title);
  }
  cli_law_free(&c.law);
  asp_pair_free(c.pair);
  cli_rough_free(&c.rough);
  measured_free(&c.data);
  for (size_t b = 0; b < c.n_bins; b++)
    free(c.groups[b].impacts.xy);
  free(c.groups);
  free(c.bins);
  return 0;
}

const cli_command cli_calibrate = {
    .name = "calibrate",
    .arguments = "DATA",
    .summary = "the wall's roughness and a law's constants from measured scatter",
    .detail =
        "asperity calibrate DATA --fit NAMES: what is not fitted, and where the search begins, is\n"
        "said by the other options (friction by --mu, yield_stress by --yield, surface_energy by\n"
        "--gamma, a law's own numbers by --set). Without a wall it begins with --sigma 5; a\n"
        "measured --profile or --map stays as it is.\n" MEASURED_FORMS
        "\nRows parameter,estimate,standard_error,unit; then, as comments, correlations, chi^2 "
        "per\n"
        "degree of freedom, and the line for a script. A warning tells where the data cannot tell\n"
        "two constants apart, and where the model does not describe them. Noise of the "
        "measurement\n"
        "looks like roughness: state it by --noise. Sizes count only where the wall is given by\n"
        "--rq and --lambda-c; sigma is the same for all of them.\n",
    .run = run,
};
