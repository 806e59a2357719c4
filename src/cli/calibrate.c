/* asperity calibrate: fits the constants of a wall and of a law to measured scatter. This file
 * selects the unknowns, combines the measurements, and prints the result. analysis/fit.c does the
 * fit.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/calibrate.h"
#include "base/number.h"
#include "base/units.h"
#include "cli/description.h"
#include "cli/scatter.h"
#include "cli/cli.h"
#include "description/description.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <string.h>

/* The data do not determine unknowns whose estimates are correlated by more than CORRELATED, or
 * whose relative error is above VAGUE. */
#define CORRELATED 0.9
#define VAGUE 1.0

/* ---- unknowns ---- */

/* The value of the materials; NAN: there is none. */
static double default_of(const cli_description *wall, const char *name) {
  asp_pair *pair = wall->particle ? asp_pair_create(wall->particle, wall->target, NULL) : NULL;
  double value = pair ? asp_pair_get(pair, name) : NAN;
  asp_pair_free(pair);
  return value;
}

/* Properties of a number of the description; a law's own numbers go before all others. */
static aspi_unknown unknown_of(const cli_description *wall, const char *name) {
  size_t place;
  const aspi_keyword *k = aspi_number_find(wall->words, name, &place);
  const bool is_surface = k->within && strcmp(k->within, "surface") == 0;
  const bool is_pair = k->within && !*k->within;
  aspi_unknown u = {.name = name,
                    .kind = is_surface ? OF_SURFACE
                            : is_pair  ? OF_PAIR
                                       : OF_LAW,
                    .least = k->least,
                    .most = k->most,
                    .default_value = is_pair ? default_of(wall, name) : k->default_value};
  u.bounded = !k->within && u.most - u.least <= 10;
  char units[120];
  aspi_quantity_units(k->unit, units, sizeof units);
  snprintf(u.unit, sizeof u.unit, "%.*s", (int)strcspn(units, " "), units);
  return u;
}

/* Start of the search: the number's own start, else that of the materials. */
static double start_of(const aspi_calibration *c, const aspi_unknown *u) {
  double value = asp_description_get(c->words, u->name);
  double start = isnan(value) && c->pair ? asp_pair_get(c->pair, u->name) : value;
  double room = u->bounded ? 0.02 * (u->most - u->least) : 0;
  start = fmin(fmax(start, u->least + room), u->bounded ? u->most - room : start);
  if (!(start > 0))
    cli_bad_usage("give a start for %s: fit=VALUE%s%s", u->name, *u->unit ? ", in " : "", u->unit);
  return start;
}

static void read_unknowns(aspi_calibration *c, const cli_description *wall) {
  const asp_description *words = c->words;
  for (int i = 0; i < words->n_fitted; i++) {
    aspi_unknown *u = &c->unknown[c->n_unknown++];
    *u = unknown_of(wall, words->fitted[i]);
    if (u->kind == OF_PAIR && !asp_rebound_needs_pair(asp_description_rebound(c->words)))
      cli_bad_usage("'%s' has no effect on impacts with rebound %s", u->name,
                    asp_rebound_name(asp_description_rebound(c->words)));
    u->start = start_of(c, u);
    u->default_value = u->default_value > 0 ? u->default_value : u->start;
    c->moves = c->moves || u->kind == OF_SURFACE;
  }
  if (c->n_unknown == 0)
    cli_bad_usage("no number of the description is 'fit'; say which to look for, as 'surface sigma "
                  "fit friction fit'");
  if (c->moves && asp_description_needs_sizes(c->words))
    cli_bad_usage("spread is '%s', which is made for one surface; where that is fitted it must be "
                  "a model that takes any, as visible or weibull",
                  asp_description_word(c->words, "spread"));
}

/* ---- the measurements ---- */

/* Warns of coefficients that are left out, as other impacts in their bin have none. */
static void warn_left_out(const aspi_calibration *c, const char *path) {
  static const char *const names[COR_BOTH] = {"cor_n", "cor_t"};
  for (int k = 0; k < COR_BOTH; k++) {
    size_t left = 0;
    for (size_t b = 0; b < c->n_bins && !c->data.means; b++)
      for (size_t i = c->bins[b].first; i < c->bins[b].end; i++)
        left += !c->bins[b].used[MOMENT_X + k] && isfinite(c->data.rows[i].cor[k]);
    if (left > 0)
      cli_warn("%s: %zu values of %s are left out, as other rebounds in their bins have none; a "
               "narrower --bin may part them",
               path, left, names[k]);
  }
}

static void read_data(const cli_call *call, aspi_calibration *c, const char *path) {
  const cli_option *samples = cli_get(call, "samples");
  double width = cli_number(cli_get(call, "bin"), 0.1, 90);
  c->data = cli_scatter_read_data(call, path, NULL);
  if (c->data.has_angle)
    cli_bad_usage("%s: angles of rebounds alone; 'calibrate' needs coefficients or speeds beside "
                  "them",
                  path);
  c->samples = samples->value ? cli_whole(samples, 100, 100000000) : 0;
  asp_code code = aspi_calibration_take_data(c, width, &cli_error);
  if (code == ASP_EARG)
    cli_bad_usage("%s: %s", path, cli_error.text);
  cli_must(!code);
  warn_left_out(c, path);
}

/* ---- the fit ---- */

static aspi_fit find_unknowns(aspi_calibration *c) {
  cli_progress progress = cli_progress_begin("fit", 1);
  aspi_fit f;
  c->progress = cli_progress_show;
  c->progress_context = &progress;
  cli_must(!aspi_calibration_find(c, &f, &cli_error));
  cli_progress_end(&progress);
  return f;
}

/* ---- output ---- */

static double value_of(const aspi_calibration *c, const aspi_fit *f, size_t i) {
  return aspi_unknown_value(&c->unknown[i], f->at[i]);
}

static double error_of(const aspi_calibration *c, const aspi_fit *f, size_t i) {
  return aspi_unknown_slope(&c->unknown[i], f->at[i]) * f->error[i];
}

/* End of an interval; NAN if it is a bound of the search. */
static double interval_end(const aspi_calibration *c, size_t i, double scaled) {
  return isfinite(scaled) ? aspi_unknown_value(&c->unknown[i], scaled) : NAN;
}

/* The bound that the data give for an unknown if they do not exclude an end of the search. */
static bool bound_of(const aspi_calibration *c, const aspi_fit *f, size_t i, char *text,
                     size_t size) {
  const aspi_unknown *u = &c->unknown[i];
  double low = interval_end(c, i, f->low[i]), high = interval_end(c, i, f->high[i]);
  const char *space = *u->unit ? " " : "";
  if (isfinite(low) && isfinite(high))
    return false;
  if (isfinite(high))
    snprintf(text, size, "%s < %.3g%s%s at 95 %%", u->name, high, space, u->unit);
  else if (isfinite(low))
    snprintf(text, size, "%s > %.3g%s%s at 95 %%", u->name, low, space, u->unit);
  else
    snprintf(text, size, "the data do not constrain %s", u->name);
  return true;
}

static void warn_of_doubt(const aspi_calibration *c, const aspi_fit *f) {
  for (size_t i = 0; i < c->n_unknown; i++) {
    char text[120];
    for (size_t k = 0; k < i; k++)
      if (fabs(f->correlation[i][k]) >= CORRELATED)
        cli_warn("the data cannot tell '%s' and '%s' apart (correlation %.3f); fix one of them, or "
                 "measure at other angles, speeds or sizes",
                 c->unknown[k].name, c->unknown[i].name, f->correlation[i][k]);
    double value = value_of(c, f, i), error = error_of(c, f, i);
    const aspi_unknown *u = &c->unknown[i];
    if (bound_of(c, f, i, text, sizeof text))
      cli_warn("%s: the data do not exclude %.3g, where the search ends", text,
               aspi_unknown_value(u, isinf(f->low[i]) ? u->low : u->high));
    else if (!(error < VAGUE * value))
      cli_warn("'%s' is poorly determined: %g, 95 %% interval %g to %g", c->unknown[i].name, value,
               interval_end(c, i, f->low[i]), interval_end(c, i, f->high[i]));
  }
  double p = f->dof > 0 ? gsl_cdf_chisq_Q(f->model_chi2, f->dof) : 1;
  if (c->has_errors && f->dof > 0 && p < 1e-3)
    cli_warn("the model does not describe the data: chi^2/dof is %.3g (p %.2g)%s",
             f->model_chi2 / f->dof, p,
             f->described ? ""
                          : "; the fit is by weights of the data, with standard errors scaled "
                            "by the root of its own chi^2/dof");
  if (!f->converged)
    cli_warn(
        "no convergence: the last step was over 1/4 of the standard errors; try more --samples");
}

/* A value as the table has it, so that the description holds the same. */
static double rounded(double value) {
  char text[32], *end;
  snprintf(text, sizeof text, "%.6g", value);
  return aspi_number(text, &end);
}

/* All of the wall in words, the estimates in place of `fit`; friction and surface energy also where
 * they are the default, which a script may have set otherwise. */
static void print_description(FILE *out, aspi_calibration *c, const aspi_fit *f) {
  static const char *const pair[] = {"friction", "surface_energy"};
  asp_description *words = c->words;
  for (size_t i = 0; i < c->n_unknown; i++)
    asp_description_set(words, c->unknown[i].name, rounded(value_of(c, f, i)), NULL);
  for (int i = 0; i < 2 && asp_rebound_needs_pair(asp_description_rebound(words)); i++)
    if (!asp_description_is_given(words, pair[i]) && (i == 0 || c->sticks))
      asp_description_set(words, pair[i], asp_pair_get(c->pair, pair[i]), NULL);
  fputs("# description, in SI units: ", out);
  cli_print_comment(out, cli_description_text(words));
  fputc('\n', out);
}

static void print_unknown(FILE *out, const aspi_calibration *c, const aspi_fit *f, size_t i) {
  char text[120];
  bool bound = bound_of(c, f, i, text, sizeof text);
  cli_row(out, "%s,%.6g,%.6g,%.6g,%.6g,", c->unknown[i].name, value_of(c, f, i),
          bound ? NAN : error_of(c, f, i), interval_end(c, i, f->low[i]),
          interval_end(c, i, f->high[i]));
  fprintf(out, "%s\n", c->unknown[i].unit);
}

static void print_all(FILE *out, aspi_calibration *c, const aspi_fit *f) {
  double all = 0;
  for (size_t b = 0; b < c->n_bins; b++)
    all += c->bins[b].moments.all;
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
  }
  fprintf(out, "# the best of %zu starts, of which %zu agree\n", f->starts, f->agreed);
  fprintf(out, "# chi^2/dof %.4g: chi^2 %.6g, %.0f degrees of freedom, %zu bins",
          f->dof > 0 ? f->chi2 / f->dof : 0, f->chi2, f->dof, c->n_bins);
  if (c->has_errors)
    fprintf(out, ", %.0f impacts, p %.3g\n", all,
            f->dof > 0 ? gsl_cdf_chisq_Q(f->chi2, f->dof) : 1);
  else
    fputs("; the data do not say how sure their means are, so the standard errors are scaled by "
          "its root\n",
          out);
  print_description(out, c, f);
}

/* ---- the command ---- */

/* Makes the wall, for the data's diameters. */
static void make_wall(aspi_calibration *c, cli_description *wall) {
  double least = INFINITY, most = 0;
  for (size_t i = 0; i < c->data.count; i++) {
    double d_p = isnan(c->data.rows[i].d_p) ? c->d_p : c->data.rows[i].d_p;
    least = fmin(least, d_p);
    most = fmax(most, d_p);
  }
  cli_description_make(wall, least, most);
  c->wall = wall->wall;
}

static void read_noise(aspi_calibration *c, const cli_option *option) {
  double noise[3] = {0, 0, 0};
  size_t count = cli_few(option, 0, 90, 3, noise);
  c->noise[0] = noise[0];
  c->noise[1] = noise[count > 1];
  c->noise_speed = noise[2];
}

static void read_wall(aspi_calibration *c, const cli_call *call,
                      const cli_description *description) {
  asp_description *words = c->words = description->words;
  c->pair = description->pair;
  c->density = description->density;
  c->smooth = strcmp(asp_description_word(words, "surface"), "smooth") == 0 &&
              !(words->choice.scatter > 0) && !(words->choice.lever > 0);
  c->sticks =
      asp_rebound_needs_pair(asp_description_rebound(words)) && words->deposit != ASPI_DEPOSIT_OFF;
  c->seed = (uint32_t)words->seed;
  c->d_p = cli_length(cli_get(call, "dp"));
  c->speed = cli_quantity(cli_get(call, "speed"), "speed", 1e-9, 1e6);
  read_noise(c, cli_get(call, "noise"));
  read_unknowns(c, description);
}

/* The table of the picture: means and standard deviations of both coefficients, measured and
 * fitted, in columns of `asperity compare`. */
static void plot(const cli_call *call, const aspi_calibration *c) {
  FILE *out = cli_plot_open(call);
  fputs("quantity,alpha1_deg,alpha_from_deg,alpha_to_deg,model_mean,model_sd,data_mean,data_sd\n",
        out);
  for (int k = 0; k < COR_BOTH; k++)
    for (size_t b = 0; b < c->n_bins; b++) {
      const aspi_calibration_bin *bin = &c->bins[b];
      double degrees = bin->degrees, mean[COR_BOTH], sd[COR_BOTH];
      double by = k == COR_N ? sin(aspi_radians(degrees)) : cos(aspi_radians(degrees));
      if (!bin->used[MOMENT_X + k])
        continue;
      if (!aspi_calibration_coefficients(c, b, mean, sd))
        cli_fail("out of memory for %zu impacts", c->samples);
      cli_row(out, "%s,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", k == COR_N ? "cor_n" : "cor_t",
              degrees, degrees, degrees, mean[k], sd[k], bin->moments.of[MOMENT_X + k] / by,
              sqrt(bin->moments.of[MOMENT_XX + k]) / by);
    }
  cli_plot_close(call, out, "compare");
}

static void run(cli_call *call) {
  if (call->n_words < 1)
    cli_bad_usage(
        "usage: asperity calibrate DATA WALL... (DATA is a file); see 'asperity calibrate --help'");
  const char *path = call->words[0];
  cli_description wall = cli_description_read(call->n_words - 1, call->words + 1, true);
  aspi_calibration c = {.samples = 0};
  read_wall(&c, call, &wall);
  read_data(call, &c, path);
  make_wall(&c, &wall);
  aspi_fit f = find_unknowns(&c);
  warn_of_doubt(&c, &f);
  FILE *out = cli_output_open(call, "output", NULL);
  print_all(out, &c, &f);
  cli_file_close(out);
  if (cli_value(call, "plot"))
    plot(call, &c);
}

static const cli_option options[] = {
    SCATTER_OPTIONS,
    {"dp", "LENGTH", "diameter, where the data have none", "10um"},
    {"speed", "M_PER_S", "impact speed, where the data have none", "100"},
    {"noise", "DEGREES[,DEGREES[,SHARE]]",
     "sd of the measured impact angles, of the rebound angles [the same], and of the speeds as a "
     "share of them",
     "0"},
    {"bin", "DEGREES",
     "width of the bins of impacts; clusters of angles narrower than it stay whole", "5"},
    {"samples", "N",
     "simulated impacts per bin; by default 10 for each measured one, 2000 to 20000", NULL},
    {.name = NULL}};

static const char detail[] =
    "Fits every number of the wall's description that is `fit`, as in 'surface sigma fit\n"
    "friction fit materials quartz al-2024': sigma, or rq and lambda_c; friction,\n"
    "surface_energy, yield_stress; those of the law. `fit=VALUE` begins the search at VALUE; rq, "
    "lambda_c and numbers\n"
    "whose default is 0 need it. Also scatter, of the yield stress, and lever: beside sigma\n"
    "the sd at steep angles tells them.\n" SCATTER_FORMS "\n"
    "The output has the rows parameter,estimate,standard_error,low_95,high_95,unit; then,\n"
    "as comments, correlations, chi^2 per degree of freedom, and the description with the\n"
    "estimates in it, for a script or another command. A warning names constants that the\n"
    "data cannot separate, and data that the model does not describe. Noise of the\n"
    "measurement looks like roughness: state it by --noise. Sizes count only if the wall is\n"
    "given by rq and lambda_c; sigma is the same for all of them.\n";

const cli_command cli_calibrate = {
    .name = "calibrate",
    .arguments = "DATA DESCRIPTION",
    .summary = "fit the wall's roughness and a law's constants to measured coefficients",
    .detail = detail,
    .examples = "  $ asperity calibrate examples/data/grant_tabakoff_1975.csv surface sigma fit "
                "friction fit materials ard al-2024 --dp 100um --plot fit.png\n",
    .options = options,
    .picture = "draw data and fitted model; .png, .svg or .pdf",
    .run = run,
};
