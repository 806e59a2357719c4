/* asperity rebound: what a rebound law does on a smooth wall, without an engine: outcome and CoR_N
 * over particle size and speed, the capture speed over particle size, and the coefficients over the
 * impact angle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/rebound.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS_MOST = 2000 };

const char *cli_rebound_law_name(const cli_description *wall) {
  return asp_rebound_name(asp_wall_rebound(wall->wall));
}

const char *cli_rebound_wall_name(const cli_description *wall) {
  return wall->target ? asp_material_name(wall->target) : "";
}

rebound_row cli_rebound_row(const cli_description *wall, double d_p, double speed, double degrees) {
  static const double n[3] = {0, 0, 1};
  double alpha = cli_radians(degrees), v1[3] = {speed * cos(alpha), 0, -speed * sin(alpha)};
  if (degrees >= 90)
    v1[0] = 0;
  asp_particle particle = {.d_p = d_p, .density = wall->density, .pair = wall->pair};
  asp_impact impact;
  asp_key key = {(uint32_t)asp_wall_get(wall->wall, "seed"), 1, 1, 1};
  asp_wall_impact(wall->wall, &particle, v1, n, &key, &impact);
  return (rebound_row){asp_impact_coefficients(v1, n, &impact), impact.outcome == ASP_DEPOSIT};
}

double cli_rebound_capture_speed(const cli_description *wall, double d_p, double degrees) {
  if (!cli_rebound_row(wall, d_p, REBOUND_SLOWEST, degrees).deposit)
    return 0;
  if (cli_rebound_row(wall, d_p, REBOUND_FASTEST, degrees).deposit)
    return INFINITY;
  double low = log(REBOUND_SLOWEST), high = log(REBOUND_FASTEST);
  for (int i = 0; i < 60; i++) {
    double middle = (low + high) / 2;
    if (cli_rebound_row(wall, d_p, exp(middle), degrees).deposit)
      low = middle;
    else
      high = middle;
  }
  return exp(high);
}

/* `count` values between two ends, in equal ratios. */
static cli_list ratios(double from, double to, size_t count) {
  cli_list list = {.values = cli_allocate(count, sizeof *list.values),
                   .count = count,
                   .least = from,
                   .most = to};
  for (size_t i = 0; i < count; i++)
    list.values[i] = from * pow(to / from, (double)i / (double)(count - 1));
  return list;
}

/* The word between the descriptions of walls that are compared. */
#define BETWEEN "vs"

static void read_wall(rebound_map *m, int count, char **words) {
  cli_description wall = cli_description_read(count, words);
  cli_description_allow(&wall,
                        "rebound materials friction surface_energy yield_stress deposit seed",
                        "the wall is smooth");
  m->walls[m->n_walls++] = wall;
  m->several_laws = m->several_laws ||
                    strcmp(cli_rebound_law_name(&wall), cli_rebound_law_name(&m->walls[0])) != 0;
}

static void read_walls(rebound_map *m, int count, char **words) {
  m->walls = cli_allocate((size_t)count + 1, sizeof *m->walls);
  for (int first = 0, last; first <= count; first = last + 1) {
    for (last = first; last < count && strcmp(words[last], BETWEEN) != 0;)
      last++;
    read_wall(m, last - first, words + first);
  }
}

static void print_regimes(FILE *out, const rebound_map *m) {
  fputs("dp_um,v1_m_s,alpha1_deg,cor_n,cor_t,outcome\n", out);
  for (size_t i = 0; i < m->sizes.count; i++)
    for (size_t k = 0; k < m->speeds.count; k++) {
      double degrees = m->angles.values[0];
      rebound_row r = cli_rebound_row(m->walls, m->sizes.values[i], m->speeds.values[k], degrees);
      fprintf(out, "%.6g,%.6g,%.6g,%.6g,", m->sizes.values[i] * 1e6, m->speeds.values[k], degrees,
              r.cor.cor_n);
      if (r.cor.cor_t_defined)
        fprintf(out, "%.6g", r.cor.cor_t);
      fprintf(out, ",%s\n", r.deposit ? "deposit" : "rebound");
    }
}

/* The wall and, where there are several, the law: the first columns. */
static void print_names(FILE *out, const rebound_map *m, const cli_description *wall) {
  cli_print_field(out, cli_rebound_wall_name(wall));
  if (m->several_laws)
    fprintf(out, ",%s", cli_rebound_law_name(wall));
  fputc(',', out);
}

static void print_capture(FILE *out, const rebound_map *m) {
  fprintf(out,
          "# empty: every speed up to 1e5 m/s sticks; 0: none does\n"
          "wall,%sdp_um,alpha1_deg,capture_speed_m_s\n",
          m->several_laws ? "law," : "");
  for (size_t w = 0; w < m->n_walls; w++)
    for (size_t i = 0; i < m->sizes.count; i++) {
      double d_p = m->sizes.values[i], degrees = m->angles.values[0];
      double speed = cli_rebound_capture_speed(&m->walls[w], d_p, degrees);
      print_names(out, m, &m->walls[w]);
      fprintf(out, "%.6g,%.6g,", d_p * 1e6, degrees);
      if (isfinite(speed))
        fprintf(out, "%.6g", speed);
      fputc('\n', out);
    }
}

static void print_angles(FILE *out, const rebound_map *m) {
  fprintf(out, "wall,%sdp_um,v1_m_s,alpha1_deg,cor_n,cor_t,outcome\n",
          m->several_laws ? "law," : "");
  for (size_t w = 0; w < m->n_walls; w++)
    for (size_t i = 0; i < m->sizes.count; i++)
      for (size_t k = 0; k < m->speeds.count; k++)
        for (size_t a = 0; a < m->angles.count; a++) {
          double d_p = m->sizes.values[i], speed = m->speeds.values[k];
          rebound_row r = cli_rebound_row(&m->walls[w], d_p, speed, m->angles.values[a]);
          print_names(out, m, &m->walls[w]);
          fprintf(out, "%.6g,%.6g,%.6g,%.6g,", d_p * 1e6, speed, m->angles.values[a], r.cor.cor_n);
          if (r.cor.cor_t_defined)
            fprintf(out, "%.6g", r.cor.cor_t);
          fprintf(out, ",%s\n", r.deposit ? "deposit" : "rebound");
        }
}

/* The maps by their names, and their rows. */
static const struct {
  const char *name;
  void (*print)(FILE *out, const rebound_map *m);
} kinds[] = {[REBOUND_REGIMES] = {"regimes", print_regimes},
             [REBOUND_CAPTURE] = {"capture", print_capture},
             [REBOUND_ANGLES] = {"angles", print_angles}};
enum { N_KINDS = sizeof kinds / sizeof *kinds };

/* The ranges of a map over sizes and speeds, where none are given. */
#define SIZE_LEAST 0.5e-6
#define SIZE_MOST 200e-6
#define SPEED_LEAST 0.1
#define SPEED_MOST 1000

static rebound_kind kind_of(const cli_option *option) {
  for (int i = 0; i < N_KINDS; i++)
    if (strcmp(kinds[i].name, option->value) == 0)
      return (rebound_kind)i;
  cli_bad_usage("--map is '%s'; it must be regimes, capture or angles", option->value);
}

static void print_list(FILE *out) {
  fputs("law,parameter,unit,default,least,most,text\n", out);
  for (int i = 0; i < asp_rebound_count(); i++) {
    const asp_rebound_law *law = asp_rebound_at(i);
    const char *name = asp_rebound_name(law);
    fprintf(out, "%s,,,,,,\"%s; source: %s\"\n", name, asp_rebound_summary(law),
            asp_rebound_source(law));
    for (int k = 0; k < asp_rebound_parameters(law); k++) {
      const asp_parameter *p = asp_rebound_parameter(law, k);
      const char *words = asp_parameter_words(p);
      fprintf(out, "%s,%s,%s,%.10g,%g,%g,\"%s%s%s\"\n", name, asp_parameter_name(p),
              asp_parameter_unit(p), asp_parameter_default(p), asp_parameter_least(p),
              asp_parameter_most(p), words, *words ? " (0, 1 ...): " : "", asp_parameter_text(p));
    }
  }
}

/* Reads the ranges of the map, or sets their defaults. */
static void read_ranges(rebound_map *m, cli_option *o) {
  bool over_angles = m->kind == REBOUND_ANGLES;
  size_t points = cli_whole(&o[POINTS], 2, POINTS_MOST);
  if (over_angles && !o[DP].value)
    o[DP].value = "10um";
  if (over_angles && !o[SPEED].value)
    o[SPEED].value = "100";
  if (!o[ANGLES].value)
    o[ANGLES].value = over_angles ? "0.5:90:0.5" : "90";
  m->sizes = o[DP].value ? cli_lengths(&o[DP]) : ratios(SIZE_LEAST, SIZE_MOST, points);
  m->speeds = o[SPEED].value ? cli_speeds(&o[SPEED], REBOUND_SLOWEST, REBOUND_FASTEST)
                             : ratios(SPEED_LEAST, SPEED_MOST, points);
  m->angles = cli_angles(&o[ANGLES]);
  if (!(m->angles.least > 0))
    cli_bad_usage("--angles is '%s'; it must be more than 0 and at most 90", o[ANGLES].value);
  if (!over_angles && m->angles.count != 1)
    cli_bad_usage("--angles is '%s'; --map %s takes one angle", o[ANGLES].value,
                  kinds[m->kind].name);
}

static void read_map(rebound_map *m, cli_option *options, int count, char **words) {
  if (options[SPEED].value && m->kind == REBOUND_CAPTURE)
    cli_bad_usage("--speed is given with --map capture, which looks for the speed");
  read_ranges(m, options);
  read_walls(m, count, words);
  if (m->kind == REBOUND_REGIMES && m->n_walls != 1)
    cli_bad_usage("'" BETWEEN "' is given; --map regimes takes one description");
  for (size_t w = 0; w < m->n_walls; w++)
    cli_description_make(&m->walls[w], m->sizes.least, m->sizes.most);
}

static void free_map(rebound_map *m) {
  for (size_t i = 0; i < m->n_walls; i++)
    cli_description_free(&m->walls[i]);
  free(m->walls);
  free(m->sizes.values);
  free(m->speeds.values);
  free(m->angles.values);
}

/* The descriptions, as they are given. */
static char *text_of(const rebound_map *m) {
  size_t size = 1;
  for (size_t w = 0; w < m->n_walls; w++)
    size += strlen(m->walls[w].text) + strlen(" " BETWEEN " ");
  char *text = cli_allocate(size, 1);
  for (size_t w = 0; w < m->n_walls; w++) {
    size_t used = strlen(text);
    snprintf(text + used, size - used, "%s%s", w ? " " BETWEEN " " : "", m->walls[w].text);
  }
  return text;
}

static int run(int argc, char **argv) {
  cli_option options[N + 1] = {
      [MAP] = {"map", "regimes|capture|angles", "what over what", "regimes"},
      [LIST] = {"list", NULL, "the laws and their parameters: defaults, ranges, sources", NULL},
      [DP] = {"dp", "LENGTHS", "diameters: a list [0.5 to 200um in equal ratios; 10um]", NULL},
      [SPEED] = {"speed", "M_PER_S", "speeds: a list [0.1 to 1000 in equal ratios; 100]", NULL},
      [ANGLES] = {"angles", "DEGREES", "impact angles: a list", NULL},
      [POINTS] = {"points", "N", "values in equal ratios where none are given", "121"},
      [OUTPUT] = CLI_OUTPUT_OPTION,
      CLI_PLOT_OPTIONS(PLOT, "draw the map; .png, .svg or .pdf"),
  };
  int words = cli_words(argc, argv);
  cli_parse(&cli_rebound, argc - words, argv + words, options, false);
  rebound_map m = {.kind = kind_of(&options[MAP])};
  if (options[LIST].value) {
    cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, NULL);
    print_list(cli_output_stream(output));
    cli_output_close(output);
    return 0;
  }
  read_map(&m, options, words, argv + 1);
  char *text = text_of(&m);
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, text);
  kinds[m.kind].print(cli_output_stream(output), &m);
  cli_output_close(output);
  free(text);
  if (options[PLOT].value)
    cli_rebound_plot(&options[PLOT], &m);
  free_map(&m);
  return 0;
}

const cli_command cli_rebound = {
    .name = "rebound",
    .summary = "what a rebound law does: regimes, capture speed, coefficients over the angle",
    .arguments = "DESCRIPTION",
    .detail =
        "On a smooth wall.\n"
        "  --map regimes  CoR_N and outcome over diameter and speed, at one angle and wall\n"
        "  --map capture  the speed under which a particle sticks, over the diameter\n"
        "  --map angles   CoR_N and CoR_T over the impact angle\n"
        "capture and angles take several descriptions with the word vs between:\n"
        "materials ard ti-6al-4v vs materials ard hastelloy-x rebound thornton_ning.\n"
        "Without --dp, --speed, --angles a map has its own ranges.\n"
        "The mu of bons is a constant fitted to its form. Oblique impacts of 5 mm alumina on\n"
        "glass (Kharaz et al. 2001, Coulomb's mu 0.092) follow 1 - mu (1 + e_n) tan alpha1 up\n"
        "to 60 degrees within 0.008, with the least CoR_T, 0.596, at 70 degrees; bons with that\n"
        "mu has its least, 0.91, at 45 degrees. walton is the law for such impacts.\n",
    .examples =
        "  $ asperity rebound materials ard ti-6al-4v vs materials ard hastelloy-x --map capture "
        "--plot capture.png\n"
        "  $ asperity rebound rebound bons vs rebound thornton_ning --map angles --plot laws.png\n",
    .run = run,
};
