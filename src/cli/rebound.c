/* asperity rebound: what a rebound law does on a smooth wall, without an engine: outcome and CoR_N
 * over particle size and speed, the capture speed over particle size, and the coefficients over the
 * impact angle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/description.h"
#include "cli/plot.h"
#include "rebound/laws.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS_MOST = 2000, CURVES_MOST = 6 };

/* Speeds between which the capture speed is looked for, m/s. */
#define SLOWEST 1e-9
#define FASTEST 1e5

/* Kind of map: its quantity and axes. */
enum { REGIMES, CAPTURE, ANGLES, N_KINDS };

typedef struct map {
  int kind;
  cli_description *walls;
  size_t n_walls;
  bool several_laws;
  cli_list sizes, speeds, angles;
} map;

static const char *law_name(const cli_description *wall) {
  return asp_rebound_name(asp_description_rebound(wall->words));
}

/* The material of the wall, "" where the law takes none. */
static const char *wall_name(const cli_description *wall) {
  return wall->target ? asp_material_name(wall->target) : "";
}

/* Words of a canonical text. */
enum { WORDS_MOST = 200 };
static int split(char *text, char *words[WORDS_MOST]) {
  int count = 0;
  for (char *at = strtok(text, " "); at && count < WORDS_MOST; at = strtok(NULL, " "))
    words[count++] = at;
  return count;
}

/* Words of a description, from a keyword on, that others of the same law and material do not have
 * in that place; "" where there are none. */
static cli_label difference_of(const map *m, size_t wall) {
  cli_label label = {""};
  char *own[WORDS_MOST], *others[WORDS_MOST];
  char *text = cli_copy(m->walls[wall].text);
  int count = split(text, own), first = count, last = 0;
  for (size_t w = 0; w < m->n_walls; w++) {
    const cli_description *other = &m->walls[w];
    if (w == wall || strcmp(law_name(other), law_name(&m->walls[wall])) != 0 ||
        strcmp(wall_name(other), wall_name(&m->walls[wall])) != 0)
      continue;
    char *its = cli_copy(other->text);
    int n = split(its, others), from = 0, end = 0;
    while (from < count && from < n && strcmp(own[from], others[from]) == 0)
      from++;
    while (end < count - from && end < n - from &&
           strcmp(own[count - 1 - end], others[n - 1 - end]) == 0)
      end++;
    free(its);
    first = from < first ? from : first;
    last = count - end > last ? count - end : last;
  }
  while (first > 0 && first < last && !isalpha((unsigned char)*own[first]))
    first--;
  for (int i = first; i < last; i++) {
    size_t used = strlen(label.text);
    snprintf(label.text + used, sizeof label.text - used, "%s%s", used ? " " : "", own[i]);
  }
  free(text);
  return label;
}

static cli_impact impact_at(const cli_description *wall, double d_p, double speed, double degrees) {
  const asp_key key = {(uint32_t)asp_description_get(wall->words, "seed"), 1, 1, 1};
  return cli_impact_at(wall, d_p, speed, degrees, &key);
}

static bool sticks_at(const cli_description *wall, double d_p, double speed, double degrees) {
  return impact_at(wall, d_p, speed, degrees).impact.outcome == ASP_DEPOSIT;
}

/* The speed under which a particle sticks: 0 where it never does, INFINITY where it always does. */
static double capture_speed(const cli_description *wall, double d_p, double degrees) {
  if (!sticks_at(wall, d_p, SLOWEST, degrees))
    return 0;
  if (sticks_at(wall, d_p, FASTEST, degrees))
    return INFINITY;
  double low = log(SLOWEST), high = log(FASTEST);
  for (int i = 0; i < 60; i++) {
    double middle = (low + high) / 2;
    if (sticks_at(wall, d_p, exp(middle), degrees))
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

static void read_wall(map *m, int count, char **words) {
  cli_description wall = cli_description_read(count, words, false);
  cli_description_allow(&wall,
                        "rebound materials friction surface_energy yield_stress deposit seed",
                        "the wall is smooth");
  m->walls[m->n_walls++] = wall;
  m->several_laws = m->several_laws || strcmp(law_name(&wall), law_name(&m->walls[0])) != 0;
}

static void read_walls(map *m, int count, char **words) {
  m->walls = cli_allocate((size_t)count + 1, sizeof *m->walls);
  for (int first = 0, last; first <= count; first = last + 1) {
    for (last = first; last < count && strcmp(words[last], BETWEEN) != 0;)
      last++;
    read_wall(m, last - first, words + first);
  }
}

/* The wall and, where there are several, the law: the first columns. */
static void print_names(FILE *out, const map *m, const cli_description *wall) {
  cli_label label = difference_of(m, (size_t)(wall - m->walls));
  const char *differs = label.text;
  char name[2000];
  snprintf(name, sizeof name, "%s%s%s", wall_name(wall), *differs && *wall_name(wall) ? " " : "",
           differs);
  cli_row(out, "%s,", name);
  if (m->several_laws)
    cli_row(out, "%s,", law_name(wall));
}

static void print_capture(FILE *out, const map *m) {
  fprintf(out,
          "# empty: every speed up to 1e5 m/s sticks; 0: none does\n"
          "wall,%sdp_um,alpha1_deg,capture_speed_m_s\n",
          m->several_laws ? "law," : "");
  for (size_t w = 0; w < m->n_walls; w++)
    for (size_t i = 0; i < m->sizes.count; i++) {
      double d_p = m->sizes.values[i], degrees = m->angles.values[0];
      print_names(out, m, &m->walls[w]);
      cli_row(out, "%.6g,%.6g,%.6g\n", d_p * 1e6, degrees,
              capture_speed(&m->walls[w], d_p, degrees));
    }
}

/* A row per impact; the names of the walls where there may be several. */
static void print_impacts(FILE *out, const map *m) {
  bool named = m->kind == ANGLES;
  fprintf(out, "%s%sdp_um,v1_m_s,alpha1_deg,cor_n,cor_t,outcome\n", named ? "wall," : "",
          m->several_laws ? "law," : "");
  size_t n_speeds = m->speeds.count, n_angles = m->angles.count, n_sizes = m->sizes.count;
  for (size_t k = 0; k < m->n_walls * n_sizes * n_speeds * n_angles; k++) {
    const cli_description *wall = &m->walls[k / (n_sizes * n_speeds * n_angles)];
    double d_p = m->sizes.values[k / (n_speeds * n_angles) % n_sizes];
    double speed = m->speeds.values[k / n_angles % n_speeds],
           degrees = m->angles.values[k % n_angles];
    cli_impact r = impact_at(wall, d_p, speed, degrees);
    if (named)
      print_names(out, m, wall);
    cli_row(out, "%.6g,%.6g,%.6g,%.6g,%.6g,%s\n", d_p * 1e6, speed, degrees, r.cor.cor_n,
            r.cor.cor_t, r.impact.outcome == ASP_DEPOSIT ? "deposit" : "rebound");
  }
}

/* The ranges of a map over sizes and speeds, where none are given. */
#define SIZE_LEAST 0.5e-6
#define SIZE_MOST 200e-6
#define SPEED_LEAST 0.1
#define SPEED_MOST 1000

static void print_list(FILE *out) {
  fputs("law,parameter,unit,default,least,most,text\n", out);
  for (int i = 0; i < asp_rebound_count(); i++) {
    const asp_rebound_law *law = asp_rebound_at(i);
    fprintf(out, "%s,,,,,,\"%s; source: %s\"\n", law->name, law->summary, law->source);
    for (int k = 0; k < law->n_parameters; k++) {
      const asp_parameter *p = &law->parameters[k];
      fprintf(out, "%s,%s,%s,%.10g,%g,%g,\"%s%s%s\"\n", law->name, p->name, p->unit, p->fallback,
              p->least, p->most, p->words ? p->words : "", p->words ? " (0, 1 ...): " : "",
              p->text);
    }
  }
}

/* Exits if the values along an axis of a picture do not rise. */
static void check_rising(const char *option, const cli_list *list) {
  for (size_t i = 1; i < list->count; i++)
    if (!(list->values[i] > list->values[i - 1]))
      cli_bad_usage("--%s has %g behind %g (SI); for --plot its values must rise", option,
                    list->values[i], list->values[i - 1]);
}

/* Reads the ranges of the map, or sets their defaults. */
static void read_ranges(map *m, cli_call *call) {
  bool over_angles = m->kind == ANGLES;
  size_t points = cli_whole(cli_get(call, "points"), 2, POINTS_MOST);
  cli_default(call, "dp", over_angles ? "10um" : NULL);
  cli_default(call, "speed", over_angles ? "100" : NULL);
  cli_default(call, "angles", over_angles ? "0.5:90:0.5" : "90");
  m->sizes = cli_value(call, "dp") ? cli_lengths(cli_get(call, "dp"))
                                   : ratios(SIZE_LEAST, SIZE_MOST, points);
  m->speeds = cli_value(call, "speed") ? cli_speeds(cli_get(call, "speed"), SLOWEST, FASTEST)
                                       : ratios(SPEED_LEAST, SPEED_MOST, points);
  m->angles = cli_impact_angles(call);
  if (cli_value(call, "plot") && !over_angles) {
    check_rising("dp", &m->sizes);
    check_rising("speed", &m->speeds);
  }
  if (!over_angles && m->angles.count != 1)
    cli_bad_usage("--angles is '%s'; --map %s takes one angle", cli_value(call, "angles"),
                  cli_value(call, "map"));
}

static void read_map(map *m, cli_call *call) {
  if (cli_value(call, "speed") && m->kind == CAPTURE)
    cli_bad_usage("--speed is given with --map capture, which looks for the speed");
  read_ranges(m, call);
  read_walls(m, call->n_words, call->words);
  if (m->kind == REGIMES && m->n_walls != 1)
    cli_bad_usage("'" BETWEEN "' is given; --map regimes takes one description");
  for (size_t w = 0; w < m->n_walls; w++)
    cli_description_make(&m->walls[w], m->sizes.least, m->sizes.most);
}

/* The descriptions, as they are given. */
static char *text_of(const map *m) {
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

/* ---- the pictures ---- */

/* Cells overlap the next ones by this factor, so that no seams show. */
#define OVERLAP 1.01

/* The lower edge of cell i around a point of a list of rising values, in equal ratios. */
static double edge_of(const cli_list *list, size_t i) {
  const double *x = list->values;
  size_t n = list->count;
  if (n < 2)
    return x[0] * (i ? 1.1 : 1 / 1.1);
  if (i == 0)
    return x[0] * sqrt(x[0] / x[1]);
  return i == n ? x[n - 1] * sqrt(x[n - 1] / x[n - 2]) : sqrt(x[i - 1] * x[i]);
}

static cli_label particle_of(const map *m) {
  const asp_material *particle = m->walls[0].particle;
  return cli_plot_label(particle ? asp_material_name(particle) : "any material");
}

/* The law in the title; where there are several, each curve has its own. */
static cli_label law_of(const map *m) {
  return cli_plot_label(m->several_laws ? "several laws" : law_name(&m->walls[0]));
}

/* `on hastelloy-x`, the law where there are several, and what differs where both are the same. */
static cli_label name_of(const map *m, size_t wall) {
  const char *on = wall_name(&m->walls[wall]);
  cli_label differs = difference_of(m, wall);
  bool named = m->several_laws || !(*on || *differs.text);
  const char *law = named ? law_name(&m->walls[wall]) : "";
  char text[1800];
  snprintf(text, sizeof text, "%s%s%s%s%s%s", law, named && *on ? " " : "", *on ? "on " : "", on,
           (named || *on) && *differs.text ? ", " : "", differs.text);
  return cli_plot_label(text);
}

/* Begins a curve in the color of its law where no other curve has that law. */
static void begin_curve(cli_plot *picture, const map *m, size_t wall, size_t curve,
                        size_t per_wall) {
  const char *law = law_name(&m->walls[wall]);
  bool alone = per_wall == 1;
  for (size_t w = 0; w < m->n_walls; w++)
    alone = alone && (w == wall || strcmp(law, law_name(&m->walls[w])) != 0);
  if (alone)
    cli_plot_series(picture, CLI_LINE, "law_%s", law);
  else
    cli_plot_series(picture, CLI_LINE, "%zu", curve % CURVES_MOST + 1);
}

/* The rows of a capture curve; a vertical line where sizes that stick at any speed end. */
static void put_capture(cli_plot *picture, const map *m, const cli_description *wall) {
  bool always = false;
  for (size_t i = 0; i < m->sizes.count; i++) {
    double d_p = m->sizes.values[i], speed = capture_speed(wall, d_p, m->angles.values[0]);
    if (isfinite(speed) && speed > 0) {
      if (always)
        cli_plot_row(picture, d_p * 1e6, FASTEST);
      cli_plot_row(picture, d_p * 1e6, speed);
    }
    always = isinf(speed);
  }
}

static cli_plot *plot_regimes(const cli_call *call, const map *m) {
  size_t nx = m->sizes.count, ny = m->speeds.count;
  double degrees = m->angles.values[0];
  cli_plot *picture =
      cli_plot_open(call, 800, 600, "1,1", "%s on %s, %s, α_1 = %g°", particle_of(m).text,
                    cli_plot_label(wall_name(m->walls)).text, law_of(m).text, degrees);
  cli_plot_panel(picture, "diameter d_p / µm", "impact speed v_1 / (m/s)");
  cli_plot_log(picture, "xy");
  cli_plot_axis(picture, 'x', edge_of(&m->sizes, 0) * 1e6, edge_of(&m->sizes, nx) * 1e6);
  cli_plot_axis(picture, 'y', edge_of(&m->speeds, 0), edge_of(&m->speeds, ny));
  fputs("set palette defined (0 '#3b0f70', 0.35 '#b63679', 0.7 '#fb8861', 1 '#fcfdbf')\n"
        "set cbrange [0:1]\nset cblabel 'CoR_N'\n"
        "set object 1 rectangle from graph 0,0 to graph 1,1 fc rgb '#bbbbbb' behind\n",
        cli_plot_stream(picture));
  cli_plot_series(picture, CLI_CELLS, "palette");
  for (size_t i = 0; i < nx; i++)
    for (size_t k = 0; k < ny; k++) {
      cli_impact r = impact_at(m->walls, m->sizes.values[i], m->speeds.values[k], degrees);
      if (r.impact.outcome == ASP_REBOUND)
        cli_plot_row(picture, edge_of(&m->sizes, i) * 1e6,
                     edge_of(&m->sizes, i + 1) * OVERLAP * 1e6, edge_of(&m->speeds, k),
                     edge_of(&m->speeds, k + 1) * OVERLAP, r.cor.cor_n);
    }
  cli_plot_end(picture, "%s", "");
  cli_plot_series(picture, CLI_LINE, "reference");
  put_capture(picture, m, m->walls);
  cli_plot_end(picture, "capture speed");
  cli_plot_series(picture, CLI_MARKS, "deposits");
  cli_plot_end(picture, "deposit");
  return picture;
}

static cli_plot *plot_capture(const cli_call *call, const map *m) {
  double most = 0;
  for (size_t w = 0; w < m->n_walls; w++)
    for (size_t i = 0; i < m->sizes.count; i++) {
      double speed = capture_speed(&m->walls[w], m->sizes.values[i], m->angles.values[0]);
      most = isfinite(speed) ? fmax(most, speed) : most;
    }
  cli_plot *picture =
      cli_plot_open(call, 800, 560, "1,1", "%s, %s, α_1 = %g°: sticks under and left of a curve",
                    particle_of(m).text, law_of(m).text, m->angles.values[0]);
  cli_plot_panel(picture, "diameter d_p / µm", "capture speed / (m/s)");
  cli_plot_log(picture, "xy");
  cli_plot_axis(picture, 'x', m->sizes.values[0] * 1e6,
                m->sizes.values[m->sizes.count - 1] * 1.0001e6);
  cli_plot_axis(picture, 'y', NAN, most > 0 ? 2 * most : 10);
  if (!(most > 0))
    fputs("set label 'no particle sticks' at graph 0.5,0.5 center\n", cli_plot_stream(picture));
  for (size_t w = 0; w < m->n_walls; w++) {
    begin_curve(picture, m, w, w, 1);
    put_capture(picture, m, &m->walls[w]);
    cli_plot_end(picture, "%s", name_of(m, w).text);
  }
  return picture;
}

/* A curve a wall, size and speed, as far as there are styles; one that sticks at every angle has
 * its name only. */
static void plot_curve(cli_plot *picture, const map *m, size_t curve, int t) {
  size_t per_wall = m->sizes.count * m->speeds.count, wall = curve / per_wall, rebounds = 0;
  double d_p = m->sizes.values[curve % per_wall / m->speeds.count],
         speed = m->speeds.values[curve % m->speeds.count];
  begin_curve(picture, m, wall, curve, per_wall);
  for (size_t a = 0; a < m->angles.count; a++) {
    cli_impact r = impact_at(&m->walls[wall], d_p, speed, m->angles.values[a]);
    rebounds += r.impact.outcome == ASP_REBOUND;
    cli_plot_row(picture, m->angles.values[a], cli_impact_ratio(&r, t));
  }
  cli_plot_end(picture, "%s, %.3g µm, %.3g m/s%s", name_of(m, wall).text, d_p * 1e6, speed,
               rebounds ? "" : " (sticks)");
}

static cli_plot *plot_angles(const cli_call *call, const map *m) {
  size_t all = m->n_walls * m->sizes.count * m->speeds.count,
         curves = all < CURVES_MOST ? all : CURVES_MOST;
  char more[64] = "";
  if (curves < all)
    snprintf(more, sizeof more, "; the first %zu of %zu curves", curves, all);
  cli_plot *picture =
      cli_plot_open(call, 1200, 520, "1,2", "%s, %s; nothing is drawn where it sticks%s",
                    particle_of(m).text, law_of(m).text, more);
  for (int t = 0; t < 2; t++) {
    cli_plot_coefficient(picture, t);
    for (size_t c = 0; c < curves; c++)
      plot_curve(picture, m, c, t);
  }
  return picture;
}

/* ---- the command ---- */

static void run(cli_call *call) {
  static void (*const print[N_KINDS])(FILE *, const map *) = {print_impacts, print_capture,
                                                              print_impacts};
  static cli_plot *(*const plot[N_KINDS])(const cli_call *,
                                          const map *) = {plot_regimes, plot_capture, plot_angles};
  map m = {.kind = cli_choice(cli_get(call, "map"))};
  bool list = cli_value(call, "list");
  if (!list)
    read_map(&m, call);
  FILE *out = cli_output_open(call, "output", list ? NULL : text_of(&m));
  if (list)
    print_list(out);
  else
    print[m.kind](out, &m);
  cli_file_close(out);
  if (cli_value(call, "plot") && !list)
    cli_plot_close(plot[m.kind](call, &m));
}

static const cli_option options[] = {
    {"map", "regimes|capture|angles", "axes of the map, see above", "regimes"},
    {"list", NULL, "the laws and their parameters: defaults, ranges, sources", NULL},
    {"dp", "LENGTHS", "diameters: a list [0.5 to 200um in equal ratios; with --map angles 10um]",
     NULL},
    {"speed", "M_PER_S", "speeds: a list [0.1 to 1000 in equal ratios; with --map angles 100]",
     NULL},
    {"angles", "DEGREES", "impact angles: a list [90; with --map angles 0.5:90:0.5]", NULL},
    {"points", "N", "number of values, in equal ratios, where none are given", "121"},
    {.name = NULL}};

static const char detail[] =
    "The wall is smooth.\n"
    "  --map regimes  CoR_N and outcome over diameter and speed, at one angle and wall\n"
    "  --map capture  the speed below which a particle sticks, over the diameter\n"
    "  --map angles   CoR_N and CoR_T over the impact angle\n"
    "capture and angles take several descriptions with the word vs between: materials ard\n"
    "ti-6al-4v vs materials ard hastelloy-x rebound thornton_ning.\n"
    "Without --dp, --speed, --angles a map has its own ranges. The mu of bons is a constant\n"
    "fitted to its form. An example: oblique impacts of 5 mm alumina on glass (Kharaz et\n"
    "al. 2001, Coulomb's mu 0.092). Their CoR_T is 1 - mu (1 + e_n) tan alpha1 within 0.008\n"
    "up to 60 degrees, and has its minimum, 0.596, at 70 degrees. bons with that mu has its\n"
    "minimum, 0.91, at 45 degrees. Use walton for such impacts.\n";

const cli_command cli_rebound = {
    .name = "rebound",
    .summary = "a restitution law on a smooth wall: regimes, capture speed, coefficients",
    .arguments = "DESCRIPTION",
    .detail = detail,
    .examples =
        "  $ asperity rebound materials ard ti-6al-4v vs materials ard hastelloy-x --map capture "
        "--plot capture.png\n"
        "  $ asperity rebound rebound bons vs rebound thornton_ning --map angles --plot laws.png\n",
    .options = options,
    .picture = "draw the map; .png, .svg or .pdf",
    .run = run,
};
