/* asperity surface: what a particle of a given size finds on a wall, generated or measured.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/surface.h"
#include "base/units.h"
#include "cli/walls.h"
#include "cli/surface_map.h"
#include "surface/describe.h"
#include "surface/read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS_LEAST = 4096, POINTS_MOST = 1 << 28, TWIN_POINTS = 1 << 19 };

enum {
  RQ,
  LAMBDA_C,
  LAY,
  DP,
  SEED,
  POINTS,
  PROFILE,
  MAP,
  STEP,
  UNIT,
  FORM,
  GAPS,
  SPACING,
  SPIKES,
  ROW,
  COLUMN,
  X_COLUMN,
  Z_COLUMN,
  MISSING,
  TIP,
  LAMBDA_S,
  CUTOFF,
  ROBUST,
  LEVEL,
  SAVE,
  OUTPUT,
  PLOT,
  N_OPTIONS
};

static const cli_option table[N_OPTIONS + 1] = {
    [RQ] = {"rq", "LENGTH", "rms height of a generated wall", NULL},
    [LAMBDA_C] = {"lambda-c", "LENGTHS", CLI_LAMBDA_HELP, NULL},
    [LAY] = CLI_LAY_OPTION,
    [DP] = {"dp", "LENGTHS", "particle diameters: a list or from:to:step", "10um"},
    [SEED] = {"seed", "N",
              "of the generated profile, or of the one that a measured one is compared with", "1"},
    [POINTS] = {"points", "N", "points of the generated profile, lambda_c/128 apart", "524288"},
    [PROFILE] = {"profile", "FILE", "a measured profile instead: text in columns, or SDF", NULL},
    [MAP] = {"map", "FILE", "a measured map: SDF, a matrix of heights, or x, y, z in columns",
             NULL},
    [STEP] = {"step", "LENGTH[,LENGTH]",
              "between heights without positions; between a matrix's columns, and its rows", NULL},
    [UNIT] = {"unit", "U[,U]", "unit of its columns, where the file states none", NULL},
    [FORM] = {"form", "DEGREE", "polynomial taken out as form: none, or 0 to 9", "1"},
    [GAPS] = {"gaps", "refuse|fill", "what to do about bad and missing points", "refuse"},
    [SPACING] = {"spacing", "resample|refuse", "what to do about unequal spacing", "resample"},
    [SPIKES] = {"spikes", "K", "points over K robust sd off their neighbours are bad, too", NULL},
    [ROW] = {"row", "N", "row of an SDF map", "1"},
    [COLUMN] = {"column", "N", "column of an SDF map; column of heights in a text", NULL},
    [X_COLUMN] = {"x-column", "N|NAME", "of positions in a text, by number or by its header", NULL},
    [Z_COLUMN] = {"z-column", "N|NAME", "of heights", NULL},
    [MISSING] = {"missing", "VALUE", "a height that stands for a missing one, as -9999", NULL},
    [TIP] = {"tip", "LENGTH", "radius of the stylus, whose dilation is undone by erosion", NULL},
    [LAMBDA_S] = {"lambda-s", "LENGTH", "shorter waves are taken out (Gaussian, ISO 16610-21)",
                  NULL},
    [CUTOFF] = {"cutoff", "LENGTH", "longer waves are taken out, after the form", NULL},
    [ROBUST] = {"robust", NULL, "the cut-off by the robust filter of ISO 16610-31", NULL},
    [LEVEL] = {"level", "1/e|0.2", "autocorrelation at lambda_c of a measured profile", "1/e"},
    [SAVE] =
        {"save", "FILE",
         "write the profile there, or the map (SDF), as mended; for --profile and --map elsewhere",
         NULL},
    [OUTPUT] = {"output", "FILE", "write there instead of to the screen", NULL},
    [PLOT] = {"plot", "FILE", "draw the first --dp, of a map two, into a .png, .svg or .pdf", NULL},
};

static void read_unit(const cli_option *option, aspi_profile_options *read) {
  const char *second = strchr(option->value, ',');
  size_t length = second ? (size_t)(second - option->value) : strlen(option->value);
  second = second ? second + 1 : option->value;
  read->unit_x = aspi_unit_metres(option->value, length);
  read->unit_z = aspi_unit_metres(second, second == option->value ? length : strlen(second));
  if (!(read->unit_x > 0 && read->unit_z > 0))
    cli_bad_usage(
        "--%s is '%s'; units of length are m cm mm um nm in mil, one, or two for positions and "
        "heights",
        option->name, option->value);
}

static aspi_profile_options read_options(const cli_option *o) {
  aspi_profile_options read = aspi_profile_options_default();
  if (o[UNIT].value)
    read_unit(&o[UNIT], &read);
  read.form = strcmp(o[FORM].value, "none") == 0 ? -1 : (int)cli_whole(&o[FORM], 0, ASP_FORM_MAX);
  read.fill = cli_choice(&o[GAPS], "refuse", "fill");
  read.resample = !cli_choice(&o[SPACING], "resample", "refuse");
  if (o[SPIKES].value)
    read.spikes = cli_number(&o[SPIKES], 1, 1e6);
  read.row = (int)cli_whole(&o[ROW], 1, 1000000);
  if (o[COLUMN].value)
    read.column = (int)cli_whole(&o[COLUMN], 1, 1000000);
  read.x_column = o[X_COLUMN].value;
  read.z_column = o[Z_COLUMN].value;
  if (o[MISSING].value) {
    read.has_missing = true;
    read.missing = cli_number(&o[MISSING], -INFINITY, INFINITY);
  }
  if (o[TIP].value)
    read.filters.tip = cli_length(&o[TIP]);
  if (o[LAMBDA_S].value)
    read.filters.lambda_s = cli_length(&o[LAMBDA_S]);
  if (o[CUTOFF].value)
    read.filters.cutoff = cli_length(&o[CUTOFF]);
  else if (o[ROBUST].value)
    cli_bad_usage("--robust goes with --cutoff");
  read.filters.robust = o[ROBUST].value != NULL;
  return read;
}

/* A profile with the same lambda_c by the same level and the same spacing, at least as long; its
 * seed is made another, so that a generated profile that was saved is not compared with itself. */
static asp_profile *generate_like(const aspi_description *d, uint32_t seed) {
  size_t points = d->points > TWIN_POINTS ? d->points : TWIN_POINTS;
  asp_error error;
  asp_profile *generated = asp_profile_create(d->r_q, d->lambda_1_e, d->spacing, points,
                                              seed ^ asp_key_wall("twin"), &error);
  if (!generated)
    fprintf(stderr, "asperity: no profile is generated to compare with: %s\n", error.text);
  return generated;
}

/* What is known of a measured profile. */
typedef struct source {
  aspi_profile_report report;
  aspi_description description;
} source;

static void tell(FILE *out, const cli_wall *wall, const source *from, const char *level) {
  const aspi_description *d = &from->description;
  fputs("# profile ", out);
  cli_print_comment(out, wall->name);
  fprintf(out, ": %s\n", from->report.text);
  fprintf(out,
          "# length %.6g um, spacing %.6g um, %zu points; R_q %.6g um, R_a %.6g um, lambda_c (%s "
          "lag) %.6g um, phi_r %.4g, rms slope %.4g\n",
          d->length * 1e6, d->spacing * 1e6, d->points, d->r_q * 1e6, d->r_a * 1e6, level,
          d->lambda_c * 1e6, d->phi_r, d->slope_rms);
  fprintf(out,
          "# %.4g lambda_c long: one such profile leaves the mean tilt at 2 deg uncertain by about "
          "%.2g %% of sigma\n",
          d->length / d->lambda_c, 100 * ASP_LENGTH_ERROR(d->length / d->lambda_c));
}

/* What the reader doubts, and what the sampling of a wall leaves open for the least of the sizes;
 * exits where its points do not resolve one. */
static void check(const char *name, const char *what, const aspi_profile_report *report,
                  double spacing, double length, double lambda, const cli_list *sizes) {
  double least = INFINITY;
  for (size_t i = 0; i < sizes->count; i++)
    least = fmin(least, sizes->values[i]);
  if (least < spacing)
    cli_fail("--dp is %gum; the %s's points are %gum apart and do not resolve it", least * 1e6,
             what, spacing * 1e6);
  if (*report->doubts)
    cli_warn("%s: %s", name, report->doubts);
  asp_error doubt;
  if (asp_sampling_check(least, spacing, length, lambda, &doubt))
    cli_warn("%s: %s", name, doubt.text);
}

static cli_wall read_wall(const cli_option *o, source *from) {
  aspi_profile_options read = read_options(o);
  if (o[STEP].value)
    read.step = cli_length(&o[STEP]);
  double level = cli_choice(&o[LEVEL], "1/e", "0.2") ? ASP_LEVEL_S_AL : ASP_LEVEL_1_E;
  uint32_t seed = (uint32_t)cli_whole(&o[SEED], 0, UINT32_MAX);
  asp_error error;
  asp_profile *profile = aspi_profile_read(o[PROFILE].value, &read, &from->report, &error);
  if (!profile)
    cli_fail("%s", error.text);
  if (aspi_profile_describe(profile, level, &from->description, &error))
    cli_fail("%s: %s", o[PROFILE].value, error.text);
  if (aspi_description_check(&from->description, 1, &error))
    cli_fail("%s: %s", o[PROFILE].value, error.text);
  const aspi_description *d = &from->description;
  return (cli_wall){profile, generate_like(d, seed), d->r_q, d->lambda_c, o[PROFILE].value};
}

static cli_wall generate_wall(const cli_option *o) {
  cli_lay lay = cli_lay_of(&o[LAMBDA_C], &o[LAY]);
  double r_q = cli_length(&o[RQ]), lambda_c = lay.lambda[0] / sqrt(lay.part);
  size_t points = cli_whole(&o[POINTS], POINTS_LEAST, POINTS_MOST);
  asp_error error;
  asp_profile *profile = asp_profile_create(r_q, lambda_c, lambda_c / CLI_POINTS_PER_LAMBDA, points,
                                            (uint32_t)cli_whole(&o[SEED], 0, UINT32_MAX), &error);
  if (!profile)
    cli_bad_usage("%s", error.text);
  return (cli_wall){profile, NULL, r_q, lambda_c, NULL};
}

static void save(const cli_option *option, int argc, char **argv, const asp_profile *profile) {
  cli_output *output = cli_output_open(option->value, argc, argv, NULL);
  FILE *out = cli_output_stream(output);
  fputs("x_um,z_um\n", out);
  for (size_t i = 0; i < asp_profile_points(profile); i++)
    fprintf(out, "%.12g,%.9g\n", (double)i * asp_profile_spacing(profile) * 1e6,
            asp_profile_heights(profile)[i] * 1e6);
  cli_output_close(output);
}

static cli_slopes *measure(const cli_wall *wall, const cli_list *sizes) {
  cli_slopes *rows = cli_allocate(sizes->count, sizeof *rows);
  cli_progress progress = cli_progress_begin("surface", (double)sizes->count);
  cli_slopes_measure(wall->profile, cli_contact(wall), wall->r_q, wall->lambda_c, sizes, &progress,
                     0, rows);
  cli_progress_end(&progress);
  return rows;
}

static void print_all(FILE *out, const cli_wall *wall, const cli_slopes *rows, size_t count) {
  if (!wall->name)
    fprintf(out, "# generated: %zu points, %.6g um apart\n", asp_profile_points(wall->profile),
            asp_profile_spacing(wall->profile) * 1e6);
  for (size_t i = 0; wall->generated && i < count; i++)
    fprintf(out, "# d_p %.6g um: D_KL(measured||generated) %.4f\n", rows[i].d_p * 1e6,
            cli_generated_kl(wall, rows[i].d_p));
  fputs(CLI_SLOPES_HEADER "\n", out);
  for (size_t i = 0; i < count; i++) {
    cli_slopes_print(out, &rows[i]);
    fputc('\n', out);
  }
}

/* Exits where an option is given that says nothing of the wall at hand: `own` of a generated one,
 * of one by its profile, of one by its map. */
static void check_options(const cli_option *o) {
  enum { GENERATED = 1, BY_PROFILE = 2, BY_MAP = 4, MEASURED = BY_PROFILE | BY_MAP };
  static const struct {
    int option, own;
  } list[] = {{RQ, GENERATED},       {LAMBDA_C, GENERATED},  {POINTS, GENERATED},
              {PROFILE, BY_PROFILE}, {SPACING, BY_PROFILE},  {ROW, BY_PROFILE},
              {COLUMN, BY_PROFILE},  {X_COLUMN, BY_PROFILE}, {Z_COLUMN, BY_PROFILE},
              {TIP, BY_PROFILE},     {LAMBDA_S, BY_PROFILE}, {CUTOFF, BY_PROFILE},
              {ROBUST, BY_PROFILE},  {MISSING, MEASURED},    {LEVEL, BY_PROFILE},
              {UNIT, MEASURED},      {FORM, MEASURED},       {GAPS, MEASURED},
              {SPIKES, MEASURED},    {STEP, MEASURED},       {SEED, GENERATED | BY_PROFILE}};
  int wall = o[MAP].value ? BY_MAP : o[PROFILE].value ? BY_PROFILE : GENERATED;
  for (size_t i = 0; i < sizeof list / sizeof *list; i++)
    if (o[list[i].option].value != table[list[i].option].value && !(list[i].own & wall))
      cli_bad_usage("--%s is given with %s, of which it says nothing", o[list[i].option].name,
                    wall == BY_MAP       ? "--map"
                    : wall == BY_PROFILE ? "--profile"
                                         : "a generated wall (no --profile or --map)");
}

/* Everything with --map. */
static void run_map(const cli_option *o, const cli_list *sizes, int argc, char **argv) {
  aspi_profile_options read = read_options(o);
  aspi_map_options options = {&read, {0, 0}};
  if (o[STEP].value) {
    cli_list steps = cli_lengths(&o[STEP]);
    if (steps.count > 2)
      cli_bad_usage("--step is '%s'; it must be one length, or two", o[STEP].value);
    options.step[0] = steps.values[0];
    options.step[1] = steps.values[steps.count - 1];
  }
  cli_map map = cli_map_read(&o[MAP], &options);
  const double *step = map.map->step;
  double sides[2] = {(double)map.map->columns * step[0], (double)map.map->rows * step[1]};
  check(o[MAP].value, "map", &map.report, fmax(step[0], step[1]), fmin(sides[0], sides[1]),
        map.description.lambda_2, sizes);
  cli_map_slopes *rows = cli_allocate(sizes->count, sizeof *rows);
  cli_map_slopes_measure(&map, sizes, rows);
  cli_output *output = cli_output_open(o[OUTPUT].value, argc, argv, NULL);
  cli_map_print(cli_output_stream(output), &map, rows, sizes->count);
  cli_output_close(output);
  if (o[SAVE].value)
    cli_map_save(&o[SAVE], &map);
  if (o[PLOT].value)
    cli_map_plot(&o[PLOT], &map, rows, sizes->count);
  free(rows);
  cli_map_free(&map);
}

static int run(int argc, char **argv) {
  cli_option options[N_OPTIONS + 1];
  memcpy(options, table, sizeof options);
  cli_parse(&cli_surface, argc, argv, options, false);
  check_options(options);
  if (options[SAVE].value && strcmp(options[SAVE].value, "-") == 0 && !options[OUTPUT].value)
    cli_bad_usage("--save is '-', standard output, where the slopes go; say where else (-o FILE)");
  cli_list sizes = cli_lengths(&options[DP]);
  if (options[MAP].value) {
    run_map(options, &sizes, argc, argv);
    return 0;
  }
  bool measured = options[PROFILE].value != NULL;
  source from;
  cli_wall wall = measured ? read_wall(options, &from) : generate_wall(options);
  if (measured)
    check(wall.name, "profile", &from.report, from.description.spacing, from.description.length,
          from.description.lambda_c, &sizes);
  cli_slopes *rows = measure(&wall, &sizes);
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, NULL);
  if (measured)
    tell(cli_output_stream(output), &wall, &from, options[LEVEL].value);
  print_all(cli_output_stream(output), &wall, rows, sizes.count);
  cli_output_close(output);
  if (options[SAVE].value)
    save(&options[SAVE], argc, argv, wall.profile);
  if (options[PLOT].value)
    cli_surface_plot(&options[PLOT], &wall, &rows[0]);
  asp_profile_free(wall.generated);
  asp_profile_free(wall.profile);
  free(rows);
  return 0;
}

const cli_command cli_surface = {
    .name = "surface",
    .summary = "which slopes a particle of a given size finds on a wall",
    .detail =
        "A row per diameter, measured on a generated or a measured profile: the slopes of the "
        "path\n"
        "of the particle's centre (dilation) under a uniform centre. kappa = sqrt(3) dp rq /\n"
        "lambda_c^2; angle_kurtosis is the excess (normal: 0); kl_normal is D_KL (natural "
        "logarithm)\n"
        "of the normal fit to the kernel density of the angles, bandwidth sd (4/(3 "
        "points))^(1/5).\n"
        "A generated profile is periodic, a measured one is mirrored at its ends. A measured one "
        "is\n"
        "compared with a generated one of the same R_q and lambda_c. Of a map, the parameters of\n"
        "ISO 25178-2, the lay, and the contact slopes of a sphere across the lay and along it. "
        "For\n"
        "an instrument's own format that is refused: the free program Gwyddion saves it as SDF.\n",
    .run = run,
};
