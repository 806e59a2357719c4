/* The pictures of `asperity rebound`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/plot.h"
#include "cli/rebound.h"

#include <math.h>
#include <string.h>

enum { CURVES_MOST = 6 };

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

static cli_label particle_of(const rebound_map *m) {
  const asp_material *particle = m->walls[0].particle;
  return cli_plot_label(particle ? asp_material_name(particle) : "any material");
}

/* The law in the title; where there are several, each curve has its own. */
static cli_label law_of(const rebound_map *m) {
  return cli_plot_label(m->several_laws ? "several laws" : cli_rebound_law_name(&m->walls[0]));
}

/* `on hastelloy-x`, and the law where there are several. */
static cli_label name_of(const rebound_map *m, size_t wall) {
  const char *on = cli_rebound_wall_name(&m->walls[wall]);
  bool named = m->several_laws || !*on;
  char text[160];
  snprintf(text, sizeof text, "%s%s%s%s", named ? cli_rebound_law_name(&m->walls[wall]) : "",
           named && *on ? " " : "", *on ? "on " : "", on);
  return cli_plot_label(text);
}

/* Begins a curve in the color of its law where no other curve has that law. */
static void begin_curve(cli_plot *picture, const rebound_map *m, size_t wall, size_t curve,
                        size_t per_wall) {
  const char *law = cli_rebound_law_name(&m->walls[wall]);
  bool alone = per_wall == 1;
  for (size_t w = 0; w < m->n_walls; w++)
    alone = alone && (w == wall || strcmp(law, cli_rebound_law_name(&m->walls[w])) != 0);
  if (alone)
    cli_plot_series(picture, CLI_LINE, "law_%s", law);
  else
    cli_plot_series(picture, CLI_LINE, "%zu", curve % CURVES_MOST + 1);
}

/* The rows of a capture curve; a vertical line where sizes that stick at any speed end. */
static void put_capture(cli_plot *picture, const rebound_map *m, const cli_description *wall) {
  bool always = false;
  for (size_t i = 0; i < m->sizes.count; i++) {
    double d_p = m->sizes.values[i],
           speed = cli_rebound_capture_speed(wall, d_p, m->angles.values[0]);
    if (isfinite(speed) && speed > 0) {
      if (always)
        cli_plot_row(picture, d_p * 1e6, REBOUND_FASTEST);
      cli_plot_row(picture, d_p * 1e6, speed);
    }
    always = isinf(speed);
  }
}

static cli_plot *plot_regimes(const cli_option *option, const rebound_map *m) {
  size_t nx = m->sizes.count, ny = m->speeds.count;
  double degrees = m->angles.values[0];
  cli_plot *picture =
      cli_plot_open(option, 800, 600, "1,1", "%s on %s, %s, α_1 = %g°", particle_of(m).text,
                    cli_plot_label(cli_rebound_wall_name(m->walls)).text, law_of(m).text, degrees);
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
      rebound_row r = cli_rebound_row(m->walls, m->sizes.values[i], m->speeds.values[k], degrees);
      if (!r.deposit)
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

static cli_plot *plot_capture(const cli_option *option, const rebound_map *m) {
  double most = 0;
  for (size_t w = 0; w < m->n_walls; w++)
    for (size_t i = 0; i < m->sizes.count; i++) {
      double speed =
          cli_rebound_capture_speed(&m->walls[w], m->sizes.values[i], m->angles.values[0]);
      most = isfinite(speed) ? fmax(most, speed) : most;
    }
  cli_plot *picture =
      cli_plot_open(option, 800, 560, "1,1", "%s, %s, α_1 = %g°: sticks under and left of a curve",
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
static void plot_curve(cli_plot *picture, const rebound_map *m, size_t curve, int t) {
  size_t per_wall = m->sizes.count * m->speeds.count, wall = curve / per_wall, rebounds = 0;
  double d_p = m->sizes.values[curve % per_wall / m->speeds.count],
         speed = m->speeds.values[curve % m->speeds.count];
  begin_curve(picture, m, wall, curve, per_wall);
  for (size_t a = 0; a < m->angles.count; a++) {
    rebound_row r = cli_rebound_row(&m->walls[wall], d_p, speed, m->angles.values[a]);
    bool none = r.deposit || (t && !r.cor.cor_t_defined);
    rebounds += !r.deposit;
    cli_plot_row(picture, m->angles.values[a], none ? NAN : t ? r.cor.cor_t : r.cor.cor_n);
  }
  cli_plot_end(picture, "%s, %.3g µm, %.3g m/s%s", name_of(m, wall).text, d_p * 1e6, speed,
               rebounds ? "" : " (sticks)");
}

static cli_plot *plot_angles(const cli_option *option, const rebound_map *m) {
  size_t all = m->n_walls * m->sizes.count * m->speeds.count,
         curves = all < CURVES_MOST ? all : CURVES_MOST;
  char more[64] = "";
  if (curves < all)
    snprintf(more, sizeof more, "; the first %zu of %zu curves", curves, all);
  cli_plot *picture =
      cli_plot_open(option, 1200, 520, "1,2", "%s, %s; nothing is drawn where it sticks%s",
                    particle_of(m).text, law_of(m).text, more);
  for (int t = 0; t < 2; t++) {
    cli_plot_coefficient(picture, t);
    for (size_t c = 0; c < curves; c++)
      plot_curve(picture, m, c, t);
  }
  return picture;
}

void cli_rebound_plot(const cli_option *option, const rebound_map *m) {
  cli_plot *(*const draw[])(const cli_option *,
                            const rebound_map *) = {[REBOUND_REGIMES] = plot_regimes,
                                                    [REBOUND_CAPTURE] = plot_capture,
                                                    [REBOUND_ANGLES] = plot_angles};
  cli_plot_close(draw[m->kind](option, m));
}
