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

const char *cli_rebound_law_name(const rebound_wall *wall) {
  return asp_rebound_name(asp_wall_rebound(wall->law->wall));
}

rebound_row cli_rebound_row(const rebound_wall *wall, double d_p, double speed, double degrees) {
  static const double n[3] = {0, 0, 1};
  double alpha = cli_radians(degrees), v1[3] = {speed * cos(alpha), 0, -speed * sin(alpha)};
  if (degrees >= 90)
    v1[0] = 0;
  asp_particle particle = {
      d_p, asp_material_get(wall->law->particle, "density"), wall->pair, {0, 0, 0}, NULL};
  asp_impact impact;
  asp_wall_impact(wall->law->wall, &particle, v1, n, &(asp_key){1, 1, 1, 1}, &impact);
  return (rebound_row){asp_impact_coefficients(v1, n, &impact), impact.outcome == ASP_DEPOSIT};
}

double cli_rebound_capture_speed(const rebound_wall *wall, double d_p, double degrees) {
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

/* A list, or from:to in equal ratios. */
static cli_list ratios_of(const cli_option *option, size_t points, bool lengths) {
  const char *colon = strchr(option->value, ':');
  if (!colon || strchr(option->value, ',') || strchr(colon + 1, ':'))
    return lengths ? cli_lengths(option) : cli_numbers(option, REBOUND_SLOWEST, REBOUND_FASTEST);
  char *text = cli_copy(option->value);
  cli_list list = {.values = cli_allocate(points, sizeof *list.values), .count = points};
  text[colon - option->value] = ',';
  cli_option pair = *option;
  pair.value = text;
  cli_list ends =
      lengths ? cli_lengths(&pair) : cli_numbers(&pair, REBOUND_SLOWEST, REBOUND_FASTEST);
  if (!(ends.values[0] < ends.values[1]))
    cli_bad_usage("--%s is '%s'; a range from:to has from < to", option->name, option->value);
  for (size_t i = 0; i < points; i++)
    list.values[i] =
        ends.values[0] * pow(ends.values[1] / ends.values[0], (double)i / (double)(points - 1));
  free(ends.values);
  free(text);
  return list;
}

/* The walls of one law. */
static void read_walls(rebound_map *m, const cli_option *first, const cli_law *law) {
  for (const char *rest = first[LAW_WALL].value; rest; m->n_walls++) {
    const char *comma = strchr(rest, ',');
    rebound_wall *grown = realloc(m->walls, (m->n_walls + 1) * sizeof *grown);
    if (!grown)
      cli_fail("out of memory");
    m->walls = grown;
    rebound_wall *wall = &m->walls[m->n_walls];
    snprintf(wall->name, sizeof wall->name, "%.*s", comma ? (int)(comma - rest) : 60, rest);
    wall->law = law;
    wall->pair = cli_law_pair(first, law, wall->name);
    rest = comma ? comma + 1 : NULL;
  }
}

/* One law of several: of the options that belong to laws it gets those that are its own, and
 * `taken` notes them. */
static void read_law(rebound_map *m, const cli_option *first, const char *name, bool *taken) {
  cli_option own[LAW_OPTIONS + 1];
  memcpy(own, first, sizeof own);
  own[LAW_REBOUND].value = name;
  asp_error error;
  const asp_rebound_law *law = asp_rebound_find(name, &error);
  if (!law)
    cli_bad_usage("--%s: %s", first[LAW_REBOUND].name, error.text);
  for (int i = 0; own[i].name; i++) {
    bool takes = cli_law_takes(own, i, law);
    taken[i] = taken[i] || takes;
    if (!takes && (i == LAW_TABLE || i >= LAW_KEYWORDS))
      own[i].value = NULL;
  }
  m->laws[m->n_laws] = cli_law_read(own);
  read_walls(m, own, &m->laws[m->n_laws++]);
}

static void read_laws(rebound_map *m, const cli_option *first) {
  const char *names = first[LAW_REBOUND].value;
  if (!strchr(names, ',')) {
    m->laws[m->n_laws++] = cli_law_read(first);
    read_walls(m, first, &m->laws[0]);
    return;
  }
  if (first[LAW_SET].value)
    cli_bad_usage("--set is given, and --%s is '%s'; it goes with one law", first[LAW_REBOUND].name,
                  names);
  bool taken[LAW_OPTIONS + 1] = {false};
  for (const char *rest = names; rest;) {
    const char *comma = strchr(rest, ',');
    char name[64];
    snprintf(name, sizeof name, "%.*s", comma ? (int)(comma - rest) : 60, rest);
    if (m->n_laws == REBOUND_LAWS_MOST)
      cli_bad_usage("--%s is '%s'; it must be at most %d laws", first[LAW_REBOUND].name, names,
                    REBOUND_LAWS_MOST);
    read_law(m, first, name, taken);
    rest = comma ? comma + 1 : NULL;
  }
  for (int i = 0; first[i].name; i++)
    if (first[i].value && !taken[i] && (i == LAW_TABLE || i >= LAW_KEYWORDS))
      cli_bad_usage("--%s is given, which none of --rebound %s has", first[i].name, names);
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
static void print_names(FILE *out, const rebound_map *m, const rebound_wall *wall) {
  cli_print_field(out, wall->name);
  if (m->n_laws > 1)
    fprintf(out, ",%s", cli_rebound_law_name(wall));
  fputc(',', out);
}

static void print_capture(FILE *out, const rebound_map *m) {
  fprintf(out,
          "# empty: every speed up to 1e5 m/s sticks; 0: none does\n"
          "wall,%sdp_um,alpha1_deg,capture_speed_m_s\n",
          m->n_laws > 1 ? "law," : "");
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
  fprintf(out, "wall,%sdp_um,v1_m_s,alpha1_deg,cor_n,cor_t,outcome\n", m->n_laws > 1 ? "law," : "");
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

/* A kind of map: its defaults, its rows, its picture. */
typedef struct map_kind {
  const char *name, *sizes, *speeds, *angles;
  void (*print)(FILE *out, const rebound_map *m);
  void (*plot)(cli_plot *picture, const rebound_map *m);
  int width, height;
} map_kind;

static const map_kind kinds[] = {
    {"regimes", "0.5um:200um", "0.1:1000", "90", print_regimes, cli_rebound_plot_regimes, 800, 600},
    {"capture", "0.5um:200um", "100", "90", print_capture, cli_rebound_plot_capture, 800, 560},
    {"angles", "10um", "100", "0.5:90:0.5", print_angles, cli_rebound_plot_angles, 1200, 520},
};
enum { N_KINDS = sizeof kinds / sizeof *kinds };

static const map_kind *kind_of(const cli_option *option) {
  for (int i = 0; i < N_KINDS; i++)
    if (strcmp(kinds[i].name, option->value) == 0)
      return &kinds[i];
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

static void read_map(rebound_map *m, cli_option *options, const map_kind *kind) {
  if (options[SPEED].value && kind->print == print_capture)
    cli_bad_usage("--speed is given with --map capture, which looks for the speed");
  if (!options[DP].value)
    options[DP].value = kind->sizes;
  if (!options[SPEED].value)
    options[SPEED].value = kind->speeds;
  if (!options[ANGLES].value)
    options[ANGLES].value = kind->angles;
  size_t points = cli_whole(&options[POINTS], 2, POINTS_MOST);
  *m = (rebound_map){.walls = NULL};
  read_laws(m, &options[LAW]);
  m->sizes = ratios_of(&options[DP], points, true);
  m->speeds = ratios_of(&options[SPEED], points, false);
  m->angles = cli_angles(&options[ANGLES]);
  for (size_t i = 0; i < m->angles.count; i++)
    if (!(m->angles.values[i] > 0))
      cli_bad_usage("--angles is '%s'; it must be more than 0 and at most 90",
                    options[ANGLES].value);
  if (kind->print != print_angles && m->angles.count != 1)
    cli_bad_usage("--angles is '%s'; --map %s takes one angle", options[ANGLES].value, kind->name);
  if (kind->print == print_regimes && m->n_laws != 1)
    cli_bad_usage("--rebound is '%s'; --map regimes takes one law",
                  options[LAW + LAW_REBOUND].value);
  if (kind->print == print_regimes && m->n_walls != 1)
    cli_bad_usage("--wall is '%s'; --map regimes takes one wall", options[LAW + LAW_WALL].value);
  for (size_t l = 0; l < m->n_laws; l++)
    cli_law_prepare(&m->laws[l]);
}

static void free_map(rebound_map *m) {
  for (size_t l = 0; l < m->n_laws; l++)
    cli_law_free(&m->laws[l]);
  for (size_t i = 0; i < m->n_walls; i++)
    asp_pair_free(m->walls[i].pair);
  free(m->walls);
  free(m->sizes.values);
  free(m->speeds.values);
  free(m->angles.values);
}

static int run(int argc, char **argv) {
  cli_option options[N + 1] = {
      [MAP] = {"map", "regimes|capture|angles", "what over what", "regimes"},
      [LIST] = {"list", NULL, "the laws and their parameters: defaults, ranges, sources", NULL},
      [DP] = {"dp", "LENGTHS", "diameters: a list, or from:to in equal ratios", NULL},
      [SPEED] = {"speed", "M_PER_S", "impact speeds: a list, or from:to in equal ratios", NULL},
      [ANGLES] = {"angles", "DEGREES", "impact angles: a list or from:to:step", NULL},
      [POINTS] = {"points", "N", "of a range in equal ratios", "121"},
      [OUTPUT] = {"output", "FILE", "write there instead of to the screen", NULL},
      [PLOT] = {"plot", "FILE", "draw the map; .png, .svg or .pdf", NULL},
      CLI_LAW_OPTIONS(LAW),
  };
  cli_law_add_keywords(&options[LAW]);
  cli_parse(&cli_rebound, argc, argv, options, false);
  const map_kind *kind = kind_of(&options[MAP]);
  if (options[LIST].value) {
    cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, NULL);
    print_list(cli_output_stream(output));
    cli_output_close(output);
    return 0;
  }
  rebound_map m;
  read_map(&m, options, kind);
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, NULL);
  kind->print(cli_output_stream(output), &m);
  cli_output_close(output);
  if (options[PLOT].value) {
    cli_plot *picture = cli_plot_open(&options[PLOT], kind->width, kind->height);
    kind->plot(picture, &m);
    cli_plot_close(picture);
  }
  free_map(&m);
  return 0;
}

const cli_command cli_rebound = {
    .name = "rebound",
    .summary = "what a rebound law does: regimes, capture speed, coefficients over the angle",
    .detail =
        "On a smooth wall.\n"
        "  --map regimes  CoR_N and outcome over diameter and speed, at one angle and wall\n"
        "  --map capture  the speed under which a particle sticks, over the diameter\n"
        "  --map angles   CoR_N and CoR_T over the impact angle\n"
        "capture and angles take several wall materials and laws: --wall ti-6al-4v,hastelloy-x,\n"
        "--rebound bons,thornton_ning; a law's own options then go to the laws that have them.\n"
        "Without --dp, --speed, --angles a map has its own ranges.\n"
        "The mu of bons is a constant fitted to its form. Oblique impacts of 5 mm alumina on\n"
        "glass (Kharaz et al. 2001, Coulomb's mu 0.092) follow 1 - mu (1 + e_n) tan alpha1 up\n"
        "to 60 degrees within 0.008, with the least CoR_T, 0.596, at 70 degrees; bons with that\n"
        "mu has its least, 0.91, at 45 degrees. --rebound walton is the law for such impacts.\n",
    .run = run,
};
