/* asperity surface: what a particle of a given size finds on a wall, generated or measured.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/surface.h"
#include "base/units.h"
#include "cli/description.h"
#include "cli/surface_map.h"
#include "surface/describe.h"
#include "readers/read.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS_LEAST = 4096, POINTS_MOST = 1 << 28, TWIN_POINTS = 1 << 19 };

enum {
  DP,
  POINTS,
  UNIT,
  READ,
  FORM,
  GAPS,
  SPIKES,
  FILTER,
  LEVEL,
  SAVE,
  OUTPUT,
  PLOT,
  N_OPTIONS = PLOT + PLOT_OPTIONS
};

static const cli_option table[N_OPTIONS + 1] = {
    [DP] = {"dp", "LENGTHS", "particle diameters: a list", "10um"},
    [POINTS] = {"points", "N", "points of the generated profile, lambda_c/128 apart", "524288"},
    [UNIT] = {"unit", "U[,U]", "unit of a file's columns, where it states none", NULL},
    [READ] = {"read", "WORDS",
              "what is in a file: row N of an SDF map, column N (of it, or of a text's heights), "
              "x_column and z_column N or NAME, missing VALUE, spacing resample or refuse, step "
              "LENGTH[,LENGTH] between heights without "
              "positions, or a matrix's columns and rows",
              NULL},
    [FORM] = {"form", "DEGREE", "polynomial taken out as form: none, or 0 to 9", "1"},
    [GAPS] = {"gaps", "refuse|fill", "what to do about bad and missing points", "refuse"},
    [SPIKES] = {"spikes", "K", "points over K robust sd off their neighbors are bad, too", NULL},
    [FILTER] = {"filter", "WORDS",
                "tip LENGTH (radius of the stylus, whose dilation is undone), lambda_s LENGTH and "
                "cutoff LENGTH (shorter and longer waves are taken out, ISO 16610-21), robust (the "
                "cut-off by ISO 16610-31)",
                NULL},
    [LEVEL] = {"level", "1/e|0.2", "autocorrelation at lambda_c of a measured profile", "1/e"},
    [SAVE] = {"save", "FILE", "write the profile there, or the map (SDF), as mended", NULL},
    [OUTPUT] = CLI_OUTPUT_OPTION,
    CLI_PLOT_OPTIONS(PLOT, "draw the first --dp, of a map two, into a .png, .svg or .pdf"),
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

static void take_steps(const cli_option *value, aspi_profile_options *read) {
  cli_list steps = cli_lengths(value);
  if (steps.count > 2)
    cli_bad_usage("--%s is '%s'; it must be one length, or two", value->name, value->value);
  read->step[0] = steps.values[0];
  read->step[1] = steps.values[steps.count - 1];
  free(steps.values);
}

static bool take_layout(const char *word, const cli_option *value, aspi_profile_options *read) {
  if (strcmp(word, "row") == 0)
    read->row = (int)cli_whole(value, 1, 1000000);
  else if (strcmp(word, "column") == 0)
    read->column = (int)cli_whole(value, 1, 1000000);
  else if (strcmp(word, "x_column") == 0)
    read->x_column = value->value;
  else if (strcmp(word, "z_column") == 0)
    read->z_column = value->value;
  else if (strcmp(word, "spacing") == 0)
    read->resample = !cli_choice(value, "resample", "refuse");
  else if (strcmp(word, "missing") == 0) {
    read->has_missing = true;
    read->missing = cli_number(value, -INFINITY, INFINITY);
  } else if (strcmp(word, "step") == 0)
    take_steps(value, read);
  else
    return false;
  return true;
}

static bool take_filter(const char *word, const cli_option *value, aspi_profile_options *read) {
  if (strcmp(word, "tip") == 0)
    read->filters.tip = cli_length(value);
  else if (strcmp(word, "lambda_s") == 0)
    read->filters.lambda_s = cli_length(value);
  else if (strcmp(word, "cutoff") == 0)
    read->filters.cutoff = cli_length(value);
  else
    return false;
  return true;
}

/* Words and their values, with blanks between; the text lives as long as the command. */
static void take_words(const cli_option *option, aspi_profile_options *read,
                       bool (*take)(const char *word, const cli_option *value,
                                    aspi_profile_options *read)) {
  if (!option->value)
    return;
  char *text = cli_copy(option->value), name[80];
  for (char *word = strtok(text, " "); word; word = strtok(NULL, " ")) {
    if (take == take_filter && strcmp(word, "robust") == 0) {
      read->filters.robust = true;
      continue;
    }
    snprintf(name, sizeof name, "%s %.40s", option->name, word);
    const cli_option value = {name, "VALUE", option->help, strtok(NULL, " ")};
    if (!value.value || !take(word, &value, read))
      cli_bad_usage("--%s is '%s'; '%s' is unknown or without a value; there are: %s", option->name,
                    option->value, word, option->help);
  }
}

static aspi_profile_options read_options(const cli_option *o) {
  aspi_profile_options read = aspi_profile_options_default();
  if (o[UNIT].value)
    read_unit(&o[UNIT], &read);
  read.form = strcmp(o[FORM].value, "none") == 0 ? -1 : (int)cli_whole(&o[FORM], 0, ASP_FORM_MAX);
  read.fill = cli_choice(&o[GAPS], "refuse", "fill");
  if (o[SPIKES].value)
    read.spikes = cli_number(&o[SPIKES], 1, 1e6);
  take_words(&o[READ], &read, take_layout);
  take_words(&o[FILTER], &read, take_filter);
  if (read.filters.robust && !(read.filters.cutoff > 0))
    cli_bad_usage("--filter is '%s'; robust goes with cutoff", o[FILTER].value);
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

/* Report and description of a measured profile. */
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

/* Warns of the reader's doubts, and of a sampling that is too coarse for the smallest size; exits
 * if the points do not resolve a particle. */
static void check(const char *name, const char *what, const aspi_profile_report *report,
                  double spacing, double length, double lambda, const cli_list *sizes) {
  double least = INFINITY;
  for (size_t i = 0; i < sizes->count; i++)
    least = fmin(least, sizes->values[i]);
  if (least < spacing)
    cli_bad_usage("--dp is %gum; the %s's points are %gum apart and do not resolve it", least * 1e6,
                  what, spacing * 1e6);
  if (*report->warnings)
    cli_warn("%s: %s", name, report->warnings);
  asp_error doubt;
  if (asp_sampling_check(least, spacing, length, lambda, &doubt))
    cli_warn("%s: %s", name, doubt.text);
}

static uint32_t seed_of(const cli_description *d) {
  return (uint32_t)asp_wall_get(d->wall, "seed");
}

static cli_wall read_wall(const cli_option *o, const cli_description *wall, source *from) {
  const char *file = asp_wall_word(wall->wall, "file");
  aspi_profile_options how = read_options(o);
  double level = cli_choice(&o[LEVEL], "1/e", "0.2") ? ASP_LEVEL_S_AL : ASP_LEVEL_1_E;
  asp_error error;
  asp_profile *profile = aspi_profile_read(NULL, file, &how, &from->report, &error);
  if (!profile)
    cli_bad_file(NULL, &error);
  if (aspi_profile_describe(profile, level, &from->description, &error) ||
      aspi_description_check(&from->description, 1, &error))
    cli_bad_usage("%s: %s", file, error.text);
  const aspi_description *d = &from->description;
  return (cli_wall){profile, generate_like(d, seed_of(wall)), d->r_q, d->lambda_c, file};
}

/* The profile along the flight; `more` is added to the seed. */
static cli_wall generate_wall(const cli_option *o, const cli_description *wall, uint32_t more) {
  const asp_surface *surface = asp_wall_surface(wall->wall);
  double vector[3], ratio = asp_surface_lambda_c(surface) / asp_surface_lambda_along(surface);
  const double *lay = cli_description_lay(wall, vector);
  double part = lay ? 1 + (ratio * ratio - 1) * lay[0] * lay[0] : 1;
  double r_q = asp_surface_r_q(surface), lambda_c = asp_surface_lambda_c(surface) / sqrt(part);
  asp_error error;
  asp_profile *profile = asp_profile_create(r_q, lambda_c, lambda_c / CLI_POINTS_PER_LAMBDA,
                                            cli_whole(&o[POINTS], POINTS_LEAST, POINTS_MOST),
                                            seed_of(wall) + more, &error);
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

static void print_notes(FILE *out, const cli_wall *wall, const cli_slopes *rows, size_t count) {
  if (!wall->name)
    fprintf(out, "# generated: %zu points, %.6g um apart\n", asp_profile_points(wall->profile),
            asp_profile_spacing(wall->profile) * 1e6);
  for (size_t i = 0; wall->generated && i < count; i++)
    fprintf(out, "# d_p %.6g um: D_KL(measured||generated) %.4f\n", rows[i].d_p * 1e6,
            cli_generated_kl(wall, rows[i].d_p));
}

static void print_rows(FILE *out, const cli_slopes *rows, size_t count) {
  for (size_t i = 0; i < count; i++) {
    cli_slopes_print(out, &rows[i]);
    fputc('\n', out);
  }
}

/* Exits if an option is given that does not apply to the wall at hand. */
static void check_options(const cli_option *o, const char *kind) {
  enum { GENERATED = 1, BY_PROFILE = 2, BY_MAP = 4, MEASURED = BY_PROFILE | BY_MAP };
  static const struct {
    int option, own;
  } list[] = {{POINTS, GENERATED}, {FILTER, BY_PROFILE}, {LEVEL, BY_PROFILE}, {UNIT, MEASURED},
              {FORM, MEASURED},    {GAPS, MEASURED},     {SPIKES, MEASURED},  {READ, MEASURED}};
  int wall = strcmp(kind, "map") == 0       ? BY_MAP
             : strcmp(kind, "profile") == 0 ? BY_PROFILE
             : strcmp(kind, "rq") == 0      ? GENERATED
                                            : 0;
  if (!wall)
    cli_bad_usage("surface is '%s'; it must be rq R lambda_c L, profile FILE or map FILE", kind);
  for (size_t i = 0; i < sizeof list / sizeof *list; i++)
    if (o[list[i].option].value != table[list[i].option].value && !(list[i].own & wall))
      cli_bad_usage("--%s does not apply to 'surface %s'", o[list[i].option].name, kind);
  if (o[SAVE].value && strcmp(o[SAVE].value, "-") == 0 && !o[OUTPUT].value)
    cli_bad_usage("--save is '-', standard output, where the slopes go; say where else (-o FILE)");
}

/* The walls that lists of rq and lambda_c make, rq slowest. */
typedef struct walls {
  cli_list r_q, lambda_c;
  int at[2]; /* the words that hold them; 0: a single wall */
  size_t count;
} walls;

static cli_list list_at(char **words, int count, const char *name, int *at) {
  for (int i = 0; i + 1 < count; i++)
    if (strcmp(words[i], name) == 0 && strpbrk(words[i + 1], ",:")) {
      const cli_option option = {name, "LENGTHS", name, words[i + 1]};
      *at = i + 1;
      return cli_lengths(&option);
    }
  return (cli_list){.count = 1};
}

static walls find_walls(int count, char **words) {
  walls all = {.at = {0, 0}};
  all.r_q = list_at(words, count, "rq", &all.at[0]);
  all.lambda_c = list_at(words, count, "lambda_c", &all.at[1]);
  all.count = all.r_q.count * all.lambda_c.count;
  return all;
}

/* One of them, counted from 0. */
static cli_description wall_of(const walls *all, size_t index, int count, char **words) {
  const double value[2] = {all->at[0] ? all->r_q.values[index / all->lambda_c.count] : 0,
                           all->at[1] ? all->lambda_c.values[index % all->lambda_c.count] : 0};
  char **own = cli_allocate((size_t)count + 1, sizeof *own), text[2][40];
  for (int i = 0; i < count; i++)
    own[i] = words[i];
  for (int k = 0; k < 2; k++)
    if (all->at[k]) {
      snprintf(text[k], sizeof text[k], "%.17gm", value[k]);
      own[all->at[k]] = text[k];
    }
  cli_description wall = cli_description_read(count, own);
  cli_description_allow(&wall, "surface seed", "a surface makes no impact");
  free(own);
  return wall;
}

/* Everything of a map. */
static void run_map(const cli_option *o, const cli_description *wall, const cli_list *sizes,
                    int argc, char **argv) {
  const char *file = asp_wall_word(wall->wall, "file");
  aspi_profile_options options = read_options(o);
  cli_map map = cli_map_read(file, &options);
  const double *step = map.map->step;
  double sides[2] = {(double)map.map->columns * step[0], (double)map.map->rows * step[1]};
  check(file, "map", &map.report, fmax(step[0], step[1]), fmin(sides[0], sides[1]),
        map.description.lambda_2, sizes);
  cli_map_slopes *rows = cli_allocate(sizes->count, sizeof *rows);
  cli_map_slopes_measure(&map, sizes, rows);
  cli_output *output = cli_output_open(o[OUTPUT].value, argc, argv, wall->text);
  cli_map_print(cli_output_stream(output), &map, rows, sizes->count);
  cli_output_close(output);
  if (o[SAVE].value)
    cli_map_save(&o[SAVE], &map);
  if (o[PLOT].value)
    cli_map_plot(&o[PLOT], &map, rows, sizes->count);
  free(rows);
  cli_map_free(&map);
}

/* A measured profile, or a generated one. */
static void run_profile(const cli_option *o, const cli_description *d, const cli_list *sizes,
                        int argc, char **argv) {
  bool measured = asp_wall_word(d->wall, "file") != NULL;
  source from;
  cli_wall wall = measured ? read_wall(o, d, &from) : generate_wall(o, d, 0);
  if (measured)
    check(wall.name, "profile", &from.report, from.description.spacing, from.description.length,
          from.description.lambda_c, sizes);
  cli_slopes *rows = measure(&wall, sizes);
  cli_output *output = cli_output_open(o[OUTPUT].value, argc, argv, d->text);
  FILE *out = cli_output_stream(output);
  if (measured)
    tell(out, &wall, &from, o[LEVEL].value);
  print_notes(out, &wall, rows, sizes->count);
  fputs(CLI_SLOPES_HEADER "\n", out);
  print_rows(out, rows, sizes->count);
  cli_output_close(output);
  if (o[SAVE].value)
    save(&o[SAVE], argc, argv, wall.profile);
  if (o[PLOT].value)
    cli_surface_plot(&o[PLOT], &wall, &rows[0]);
  asp_profile_free(wall.generated);
  asp_profile_free(wall.profile);
  free(rows);
}

/* Many walls, each by a profile of its own: the seed of each is one more than that before. */
static void run_walls(const cli_option *o, const walls *all, const cli_list *sizes, int argc,
                      char **argv) {
  int words = cli_words(argc, argv);
  if (o[SAVE].value || o[PLOT].value)
    cli_bad_usage("--%s is given with a list of walls; it takes one",
                  o[SAVE].value ? "save" : "plot");
  cli_slopes *rows = cli_allocate(all->count * sizes->count, sizeof *rows);
  for (size_t k = 0; k < all->count; k++) {
    cli_description d = wall_of(all, k, words, argv + 1);
    cli_wall wall = generate_wall(o, &d, (uint32_t)k);
    cli_slopes *own = measure(&wall, sizes);
    memcpy(rows + k * sizes->count, own, sizes->count * sizeof *own);
    free(own);
    asp_profile_free(wall.profile);
    cli_description_free(&d);
  }
  cli_output *output = cli_output_open(o[OUTPUT].value, argc, argv, NULL);
  fprintf(cli_output_stream(output), "# generated: %s points a wall, lambda_c/%g apart\n",
          o[POINTS].value, CLI_POINTS_PER_LAMBDA);
  fputs(CLI_SLOPES_HEADER "\n", cli_output_stream(output));
  print_rows(cli_output_stream(output), rows, all->count * sizes->count);
  cli_output_close(output);
  free(rows);
}

static int run(int argc, char **argv) {
  cli_option options[N_OPTIONS + 1];
  memcpy(options, table, sizeof options);
  int words = cli_words(argc, argv);
  cli_parse(&cli_surface, argc - words, argv + words, options, false);
  cli_list sizes = cli_lengths(&options[DP]);
  walls all = find_walls(words, argv + 1);
  cli_description first = wall_of(&all, 0, words, argv + 1);
  const char *kind = asp_wall_word(first.wall, "surface");
  check_options(options, kind);
  if (all.count > 1)
    run_walls(options, &all, &sizes, argc, argv);
  else if (strcmp(kind, "map") == 0)
    run_map(options, &first, &sizes, argc, argv);
  else
    run_profile(options, &first, &sizes, argc, argv);
  cli_description_free(&first);
  return 0;
}

const cli_command cli_surface = {
    .name = "surface",
    .summary = "which slopes a particle of a given size finds on a wall",
    .arguments = "DESCRIPTION",
    .detail =
        "A row per diameter, measured on a generated or a measured profile: the slopes of the "
        "path\n"
        "of the particle's center (dilation) under a uniform center. kappa = sqrt(3) dp rq /\n"
        "lambda_c^2; angle_kurtosis is the excess (normal: 0); kl_normal is D_KL (natural "
        "logarithm)\n"
        "of the normal fit to the kernel density of the angles, bandwidth sd (4/(3 "
        "points))^(1/5).\n"
        "A generated profile is periodic, a measured one is mirrored at its ends. A measured one "
        "is\n"
        "compared with a generated one of the same R_q and lambda_c. rq and lambda_c may be "
        "lists:\n"
        "'surface rq 2um,5um lambda_c 40um:120um:40um' has a row per wall and diameter. Of a map, "
        "the parameters of\n"
        "ISO 25178-2, the lay, and the contact slopes of a sphere across the lay and along it. "
        "For\n"
        "an instrument's own format that is refused: the free program Gwyddion saves it as SDF.\n",
    .examples =
        "  $ asperity surface surface rq 5um lambda_c 40um --dp 5um,55um --plot surface.png\n"
        "  $ asperity surface surface profile raw.csv --gaps fill --form 2 --dp 20um --save "
        "mended.csv\n",
    .run = run,
};
