/* asperity surface: what a particle of a given size finds on a wall, generated or measured.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/cli.h"
#include "cli/surface.h"
#include "description/description.h"
#include "base/units.h"
#include "surface/instrument.h"
#include "surface/rolling.h"
#include "surface/describe.h"
#include "surface/size_law.h"
#include "surface/slopes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* One wall by its profile. */
typedef struct wall_profile {
  asp_heights *profile;
  double r_q, lambda_c;
  const char *name; /* of the measured file, or NULL */
} wall_profile;

/* The row of one particle size on one profile. */
typedef struct slopes_row {
  double d_p, r_q, lambda_c;
  aspi_slopes slopes;
} slopes_row;

enum { POINTS_LEAST = 4096, POINTS_MOST = 1 << 28 };

/* Points per correlation length of a generated profile: fine enough that a particle smaller than
 * the spacing finds the unfiltered slope. */
#define POINTS_PER_LAMBDA 128.0

/* ---- profiles ---- */

/* The profile along the flight; `number` is added to the seed. */
static wall_profile generate_wall(const cli_call *call, const cli_description *wall,
                                  uint32_t number) {
  asp_surface *surface = cli_made(aspi_description_surface(wall->words, &cli_error));
  double r_q = asp_surface_r_q(surface),
         lambda_c = asp_surface_lambda_c(surface) / sqrt(cli_description_shrink(wall, surface));
  asp_surface_free(surface);
  asp_heights *profile = cli_made(aspi_profile_generate(
      r_q, lambda_c, lambda_c / POINTS_PER_LAMBDA,
      cli_whole(cli_get(call, "points"), POINTS_LEAST, POINTS_MOST),
      (uint32_t)asp_description_get(wall->words, "seed") + number, &cli_error));
  return (wall_profile){profile, r_q, lambda_c, NULL};
}

static void save(const cli_call *call, const asp_heights *profile) {
  FILE *out = cli_output_open(call, "save", NULL);
  fputs("x_um,z_um\n", out);
  for (size_t i = 0; i < profile->columns; i++)
    fprintf(out, "%.12g,%.9g\n", (double)i * profile->step[0] * 1e6, profile->z[i] * 1e6);
  cli_file_close(out);
}

/* ---- the slopes ---- */

static double kappa_of(const slopes_row *row) {
  return aspi_kappa(row->d_p, row->r_q / row->lambda_c, row->lambda_c);
}

/* The slopes that discs of every size meet on a profile, in order, on all cores. */
static void measure(const wall_profile *wall, const cli_list *sizes, slopes_row *rows) {
  cli_error.code = ASP_OK;
  size_t finished = 0;
  cli_progress progress = cli_progress_begin("surface", (double)sizes->count);
#pragma omp parallel for schedule(dynamic)
  for (size_t i = 0; i < sizes->count; i++) {
    asp_error own = {.code = ASP_OK};
    rows[i] = (slopes_row){.d_p = sizes->values[i], .r_q = wall->r_q, .lambda_c = wall->lambda_c};
    aspi_profile_describe_slopes(wall->profile, rows[i].d_p, &rows[i].slopes, &own);
#pragma omp critical
    {
      if (own.code)
        cli_error = own;
      cli_progress_show(&progress, (double)++finished);
    }
  }
  cli_must(!cli_error.code);
  cli_progress_end(&progress);
}

/* Sigma of the tilt of a wall of that profile, or of the numbers of a generated one. */
static double tilt_of(const slopes_row *r, bool measured) {
  double kappa = kappa_of(r), of_numbers = sqrt(2) * r->r_q / r->lambda_c * aspi_closed_form(kappa);
  double disc = measured ? r->slopes.slope_rms : of_numbers;
  return aspi_degrees(atan(disc * aspi_sphere_over_disc(kappa)));
}

/* A slope of the profile further than this from sqrt(2) R_q/lambda_c is that of more than one wave.
 */
#define WAVES_APART 0.15

/* Words of walls by numbers that particles of each size meet with the slope of the profile. */
static void print_words(FILE *out, const slopes_row *rows, size_t count,
                        const asp_heights_numbers *n) {
  double ratio = n->s_dq / (sqrt(2) * n->s_q / n->lambda_1);
  if (fabs(ratio - 1) > WAVES_APART)
    fprintf(out,
            "# the rms slope is %.3g times sqrt(2) R_q/lambda_c: the wall has more than one wave, "
            "and no numbers alone will do for all sizes\n",
            ratio);
  for (const slopes_row *r = rows; r < rows + count; r++) {
    double rdq = aspi_r_dq_met(r->r_q, r->d_p, tan(aspi_radians(tilt_of(r, true))));
    if (rdq > 0)
      fprintf(out, "# for particles of %.6g um by numbers: surface rq %.4gum rdq %.4g\n",
              r->d_p * 1e6, r->r_q * 1e6, rdq);
  }
}

static void print_rows(FILE *out, const slopes_row *rows, size_t count, bool measured) {
  fputs("dp_um,rq_um,lambda_c_um,phi_r,kappa,slope_rms,sigma_deg,angle_mean_deg,angle_sd_deg,"
        "angle_kurtosis,kl_normal,tilt_sigma_deg\n",
        out);
  for (const slopes_row *r = rows; r < rows + count; r++)
    fprintf(out, "%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", r->d_p * 1e6,
            r->r_q * 1e6, r->lambda_c * 1e6, r->r_q / r->lambda_c, kappa_of(r), r->slopes.slope_rms,
            aspi_degrees(atan(r->slopes.slope_rms)), aspi_degrees(r->slopes.angle.mean),
            aspi_degrees(r->slopes.angle.sd), r->slopes.angle.kurtosis, r->slopes.kl_normal,
            tilt_of(r, measured));
}

/* ---- the table of the picture: the profile, its closing, the path of the first particle's center,
 * and the tilts that it meets (Altmeppen et al. 2020, figures 3 and 4) ---- */

/* Most points of a profile in the picture. */
enum { DRAWN_MOST = 1 << 16 };

static void plot(const cli_call *call, const wall_profile *wall, double d_p) {
  size_t n = wall->profile->columns, tilts;
  double *slope = cli_allocate(n, sizeof *slope), dx = wall->profile->step[0];
  asp_heights *center = aspi_profile_rolled(wall->profile, d_p, 1, &cli_error);
  asp_heights *closed = center ? aspi_profile_closed(wall->profile, d_p, &cli_error) : NULL;
  if (!closed || aspi_profile_slopes(wall->profile, d_p, slope, &tilts, &cli_error))
    cli_fail("%s", cli_error.text);
  FILE *out = cli_plot_open(call);
  fputs("x_um,z_um,closed_um,center_um,tilt_deg\n", out);
  for (size_t i = 0; i < n && i < DRAWN_MOST; i++)
    cli_row(out, "%.9g,%.6g,%.6g,%.6g,%.6g\n", (double)i * dx * 1e6, wall->profile->z[i] * 1e6,
            closed->z[i] * 1e6, center->z[i] * 1e6, i < tilts ? aspi_degrees(atan(slope[i])) : NAN);
  asp_heights_free(center);
  asp_heights_free(closed);
  free(slope);
  cli_plot_close(call, out, "profile");
}

/* ---- the command ---- */

/* Exits if an option is given that does not apply to the wall at hand. */
static void check_options(const cli_call *call, const char *kind) {
  enum { GENERATED = 1, BY_PROFILE = 2, BY_MAP = 4, MEASURED = BY_PROFILE | BY_MAP };
  static const struct {
    const char *option;
    int own;
  } list[] = {{"points", GENERATED},    {"row", BY_PROFILE},      {"column", BY_PROFILE},
              {"x-column", BY_PROFILE}, {"lambda_s", BY_PROFILE}, {"unit", MEASURED},
              {"step", MEASURED},       {"missing", MEASURED},    {"form", MEASURED},
              {"gaps", MEASURED},       {"spikes", MEASURED}};
  int wall = strcmp(kind, "map") == 0       ? BY_MAP
             : strcmp(kind, "profile") == 0 ? BY_PROFILE
             : strcmp(kind, "rq") == 0      ? GENERATED
                                            : 0;
  if (!wall)
    cli_bad_usage("surface is '%s'; it must be rq R lambda_c L, profile FILE or map FILE", kind);
  for (size_t i = 0; i < sizeof list / sizeof *list; i++)
    if (cli_is_set(call, list[i].option) && !(list[i].own & wall))
      cli_bad_usage("--%s does not apply to 'surface %s'", list[i].option, kind);
  const char *saved = cli_value(call, "save");
  if (saved && strcmp(saved, "-") == 0 && !cli_value(call, "output"))
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

static walls find_walls(const cli_call *call) {
  walls all = {.at = {0, 0}};
  all.r_q = list_at(call->words, call->n_words, "rq", &all.at[0]);
  all.lambda_c = list_at(call->words, call->n_words, "lambda_c", &all.at[1]);
  all.count = all.r_q.count * all.lambda_c.count;
  return all;
}

/* One of them, counted from 0. */
static cli_description wall_of(const walls *all, size_t index, const cli_call *call) {
  const double value[2] = {all->at[0] ? all->r_q.values[index / all->lambda_c.count] : 0,
                           all->at[1] ? all->lambda_c.values[index % all->lambda_c.count] : 0};
  char **own = cli_allocate((size_t)call->n_words + 1, sizeof *own), text[2][40];
  memcpy(own, call->words, (size_t)call->n_words * sizeof *own);
  for (int k = 0; k < 2; k++)
    if (all->at[k]) {
      snprintf(text[k], sizeof text[k], "%.17gm", value[k]);
      own[all->at[k]] = text[k];
    }
  cli_description wall = cli_description_read(call->n_words, own, false);
  bool measured = asp_description_word(wall.words, "file");
  cli_description_allow(&wall, measured ? "surface" : "surface seed",
                        measured ? "a measured wall is read, not drawn"
                                 : "a surface makes no impact");
  cli_description_doubt(&wall, 0, 0);
  return wall;
}

/* A measured profile, or a generated one for each wall: the seed of each is one more than that
 * before. */
static void run_profiles(const cli_call *call, const walls *all, const cli_description *first,
                         const cli_measured *m, const cli_list *sizes) {
  bool measured = m->heights, many = all->count > 1;
  size_t count = all->count * sizes->count;
  if (many && (cli_value(call, "save") || cli_value(call, "plot")))
    cli_bad_usage("--%s is given with a list of walls; it takes one",
                  cli_value(call, "save") ? "save" : "plot");
  slopes_row *rows = cli_allocate(count, sizeof *rows);
  wall_profile wall = {.profile = NULL};
  for (size_t k = 0; k < all->count; k++) {
    cli_description of = k > 0 ? wall_of(all, k, call) : *first;
    asp_heights_free(k > 0 ? wall.profile : NULL);
    if (measured)
      wall = (wall_profile){m->heights, m->numbers.s_q, m->numbers.lambda_1, m->name};
    else
      wall = generate_wall(call, &of, (uint32_t)k);
    measure(&wall, sizes, rows + k * sizes->count);
  }
  FILE *out = cli_output_open(call, "output", many ? NULL : first->text);
  if (measured) {
    cli_surface_describe(out, m);
    print_words(out, rows, count, &m->numbers);
  }
  if (many)
    fprintf(out, "# generated: %s points a wall, lambda_c/%g apart\n", cli_value(call, "points"),
            POINTS_PER_LAMBDA);
  else if (!measured)
    fprintf(out, "# generated: %zu points, %.6g um apart\n", wall.profile->columns,
            wall.profile->step[0] * 1e6);
  print_rows(out, rows, count, measured);
  cli_file_close(out);
  if (cli_value(call, "save") && wall.profile->next)
    cli_bad_usage("--save is given with several profiles; it takes one");
  if (cli_value(call, "save"))
    save(call, wall.profile);
  if (cli_value(call, "plot"))
    plot(call, &wall, rows[0].d_p);
}

static void run(cli_call *call) {
  cli_list sizes = cli_lengths(cli_get(call, "dp"));
  walls all = find_walls(call);
  cli_description first = wall_of(&all, 0, call);
  const char *kind = asp_description_word(first.words, "surface");
  check_options(call, kind);
  bool is_map = strcmp(kind, "map") == 0;
  const char *file = asp_description_word(first.words, "file");
  const cli_measured m =
      file ? cli_surface_read(call, file, is_map, &sizes) : (cli_measured){.name = NULL};
  if (is_map)
    cli_surface_map(call, &first, &m, &sizes);
  else
    run_profiles(call, &all, &first, &m, &sizes);
}

static const cli_option options[] = {
    {"dp", "LENGTHS", "particle diameters: a list", "10um"},
    {"points", "N", "points of the generated profile, lambda_c/128 apart", "524288"},
    {"unit", "U[,U]",
     "unit of the columns of a file that does not state it, or the length that stands for 1", NULL},
    {"row", "N", "row of an SDF, SUR or X3P map, or trace of a text, that is the profile", "1"},
    {"column", "N|NAME", "column with the heights of a text, or of such a map in place of a row",
     NULL},
    {"x-column", "N|NAME", "column with the positions of a text", NULL},
    {"step", "LENGTH[,LENGTH]",
     "between heights without positions, or between columns and rows of a matrix", NULL},
    {"missing", "VALUE", "height that marks a missing one", NULL},
    {"form", "DEGREE", "degree of the polynomial that is subtracted as form: none, or 0 to 9", "1"},
    {"gaps", "refuse|fill", "refuse a file with bad and missing points, or fill them", "refuse"},
    {"spikes", "K", "count points more than K robust sd from their neighbors as bad", NULL},
    {"lambda_s", "LENGTH", "remove shorter waves of a profile (ISO 16610-21)", NULL},
    {"save", "FILE", "write the repaired profile, or map (SDF), there", NULL},
    {.name = NULL}};

static const char detail[] =
    "One row per diameter. The particle rolls over a generated or a measured profile; the\n"
    "row has the slopes of the path of its center (dilation), at equal steps along the\n"
    "wall. kappa = sqrt(3) dp rq / lambda_c^2; angle_kurtosis is the excess (normal: 0);\n"
    "kl_normal is D_KL (natural logarithm) of the normal fit to the angles, in bins of sd/4.\n"
    "sigma is that of a disc on this profile, tilt_sigma that of the tilt of a wall of these\n"
    "words: of a sphere, and of rq and lambda_c.\n"
    "A generated profile is periodic, a measured one is mirrored at its ends. Of several\n"
    "profiles, 'surface profile a.csv,b.csv', the numbers are those of all by their lengths,\n"
    "and the picture is of the first. rq and lambda_c may be lists: 'surface rq 2um,5um\n"
    "lambda_c 40um:120um:40um' has a row per wall and diameter. For a map the output has the\n"
    "parameters of ISO 25178-2, the lay, and the slopes that a sphere meets across the lay\n"
    "and along it. FILE is text, SDF, SUR (Digital Surf) or X3P; other formats of instruments\n"
    "are refused by name, and the free program Gwyddion saves them as text.\n";

const cli_command cli_surface = {
    .name = "surface",
    .summary = "the slopes that particles of a given size meet on a wall",
    .arguments = "DESCRIPTION",
    .detail = detail,
    .examples =
        "  $ asperity surface surface rq 5um lambda_c 40um --dp 5um,55um --plot surface.png\n"
        "  $ asperity surface surface profile raw.csv --gaps fill --form 2 --dp 20um --save "
        "mended.csv\n",
    .options = options,
    .picture = "draw the wall and the first --dp on it; .png, .svg or .pdf",
    .run = run,
};
