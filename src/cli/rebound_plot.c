/* The pictures of `asperity rebound`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/rebound.h"

#include <math.h>

enum { CURVES_MOST = 6 };

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

/* Corners of cells, each with the value of the cell above and right of it. */
static void plot_cells(FILE *gp, const rebound_map *m) {
  size_t nx = m->sizes.count, ny = m->speeds.count;
  fputs("$map << EOD\n", gp);
  for (size_t i = 0; i <= nx; i++, fputc('\n', gp))
    for (size_t k = 0; k <= ny; k++) {
      rebound_row r = cli_rebound_row(m->walls, m->sizes.values[i < nx ? i : nx - 1],
                                      m->speeds.values[k < ny ? k : ny - 1], m->angles.values[0]);
      fprintf(gp, "%g %g ", edge_of(&m->sizes, i) * 1e6, edge_of(&m->speeds, k));
      fprintf(gp, r.deposit ? "NaN\n" : "%g\n", r.cor.cor_n);
    }
  fputs("EOD\n", gp);
}

static cli_label particle_of(const cli_plot *picture, const rebound_map *m) {
  const asp_material *particle = m->walls[0].particle;
  return cli_plot_label(picture, particle ? asp_material_name(particle) : "any material");
}

/* The law in the title; where there are several, each curve has its own. */
static cli_label law_of(const cli_plot *picture, const rebound_map *m) {
  return cli_plot_label(picture,
                        m->several_laws ? "several laws" : cli_rebound_law_name(&m->walls[0]));
}

/* `on hastelloy-x`, and the law where there are several. */
static cli_label name_of(const cli_plot *picture, const rebound_map *m, size_t wall) {
  const char *on = cli_rebound_wall_name(&m->walls[wall]);
  bool named = m->several_laws || !*on;
  char text[160];
  snprintf(text, sizeof text, "%s%s%s%s", named ? cli_rebound_law_name(&m->walls[wall]) : "",
           named && *on ? " " : "", *on ? "on " : "", on);
  return cli_plot_label(picture, text);
}

/* The user's title, or one of the particle's material, the law, and more. */
static void put_title(cli_plot *picture, const rebound_map *m, const char *set, const char *more) {
  FILE *gp = cli_plot_stream(picture);
  if (cli_plot_title(picture))
    fprintf(gp, "%s '%s'", set, cli_plot_title(picture));
  else
    fprintf(gp, "%s '%s%s'", set, particle_of(picture, m).text, more);
}

/* The curve, and where a particle sticks at any speed a line up to its end. */
static double plot_capture_curve(FILE *gp, const rebound_map *m, const cli_description *wall) {
  double most = 0;
  bool always = false;
  for (size_t i = 0; i < m->sizes.count; i++) {
    double d_p = m->sizes.values[i],
           speed = cli_rebound_capture_speed(wall, d_p, m->angles.values[0]);
    if (isfinite(speed) && speed > 0) {
      if (always)
        fprintf(gp, "%g %g 0\n", d_p * 1e6, REBOUND_FASTEST);
      fprintf(gp, "%g %g 0\n", d_p * 1e6, speed);
      most = fmax(most, speed);
    }
    always = isinf(speed);
  }
  return most;
}

/* A label in place of a title, which gnuplot 5.4 leaves out of a map where it holds a backslash. */
void cli_rebound_plot_regimes(cli_plot *picture, const rebound_map *m) {
  FILE *gp = cli_plot_stream(picture);
  size_t nx = m->sizes.count, ny = m->speeds.count;
  plot_cells(gp, m);
  fputs("$capture << EOD\n", gp);
  bool sticks = plot_capture_curve(gp, m, m->walls) > 0;
  char title[1400];
  snprintf(title, sizeof title, " on %s, %s, α_1 = %g°",
           cli_plot_label(picture, cli_rebound_wall_name(m->walls)).text, law_of(picture, m).text,
           m->angles.values[0]);
  fputs("EOD\n", gp);
  put_title(picture, m, "set label", title);
  fputs(" at screen 0.47,0.96 center\n", gp);
  cli_plot_set_range(picture, edge_of(&m->speeds, 0), edge_of(&m->speeds, ny));
  fprintf(gp,
          "set view map\nset pm3d map corners2color c1\n"
          "set palette defined (0 '#3b0f70', 0.35 '#b63679', 0.7 '#fb8861', 1 '#fcfdbf')\n"
          "set cbrange [0:1]\nset cblabel 'CoR_N'\nset log xy\nset border 15 front\n"
          "set xrange [%g:%g]\n"
          "set xlabel 'diameter d_p / µm'\nset ylabel 'impact speed v_1 / (m/s)'\n"
          "set object 1 rectangle from graph 0,0 to graph 1,1 fc rgb '#bbbbbb' behind\n"
          "set key bottom left opaque\nset lmargin screen 0.12\nset rmargin screen 0.82\n"
          "set tmargin screen 0.92\nset bmargin screen 0.12\n"
          "splot $map using 1:2:(0):3 with pm3d notitle, %s"
          "NaN with points pt 5 ps 2 lc rgb '#bbbbbb' title 'deposit'\n",
          edge_of(&m->sizes, 0) * 1e6, edge_of(&m->sizes, nx) * 1e6,
          sticks ? "$capture using 1:2:3 with lines lc rgb '#000000' lw 2 title 'capture speed', "
                 : "");
}

void cli_rebound_plot_capture(cli_plot *picture, const rebound_map *m) {
  FILE *gp = cli_plot_stream(picture);
  double most = 0;
  for (size_t w = 0; w < m->n_walls; w++) {
    fprintf(gp, "$capture%zu << EOD\n", w);
    most = fmax(most, plot_capture_curve(gp, m, &m->walls[w]));
    fputs("EOD\n", gp);
  }
  if (!(most > 0))
    fputs("set label 'no particle sticks' at graph 0.5,0.5 center\n", gp);
  char title[800];
  snprintf(title, sizeof title, ", %s, α_1 = %g°: sticks under and left of a curve",
           law_of(picture, m).text, m->angles.values[0]);
  put_title(picture, m, "set title", title);
  fputc('\n', gp);
  cli_plot_set_range(picture, most > 0 ? NAN : 1, most > 0 ? 5 * most : 10);
  fprintf(gp,
          "set log xy\nset xrange [%g:%g]\nset xlabel 'diameter d_p / µm'\n"
          "set ylabel 'capture speed / (m/s)'\nset key top right opaque\nplot ",
          m->sizes.values[0] * 1e6, m->sizes.values[m->sizes.count - 1] * 1e6);
  for (size_t w = 0; w < m->n_walls; w++)
    fprintf(gp, "%s$capture%zu with lines ls %zu title '%s'", w ? ", " : "", w, w % CURVES_MOST + 1,
            name_of(picture, m, w).text);
  fputs(", NaN notitle\n", gp);
}

/* One curve a wall, size and speed, as far as there are styles; one that sticks at every angle has
 * its name only. */
void cli_rebound_plot_angles(cli_plot *picture, const rebound_map *m) {
  FILE *gp = cli_plot_stream(picture);
  size_t per_wall = m->sizes.count * m->speeds.count, all = m->n_walls * per_wall;
  size_t curves = all < CURVES_MOST ? all : CURVES_MOST;
  bool rebounds[CURVES_MOST] = {false}, any = false;
  for (size_t c = 0; c < curves; c++) {
    fprintf(gp, "$curve%zu << EOD\n", c);
    for (size_t a = 0; a < m->angles.count; a++) {
      rebound_row r =
          cli_rebound_row(&m->walls[c / per_wall], m->sizes.values[c % per_wall / m->speeds.count],
                          m->speeds.values[c % m->speeds.count], m->angles.values[a]);
      rebounds[c] = rebounds[c] || !r.deposit;
      any = any || !r.deposit;
      fprintf(gp,
              r.deposit             ? "\n"
              : r.cor.cor_t_defined ? "%g %g %g\n"
                                    : "%g %g NaN\n",
              m->angles.values[a], r.cor.cor_n, r.cor.cor_t);
    }
    fputs("EOD\n", gp);
  }
  char more[64] = "", title[800];
  if (curves < all)
    snprintf(more, sizeof more, "; the first %zu of %zu curves", curves, all);
  snprintf(title, sizeof title, ", %s; nothing is drawn where it sticks%s", law_of(picture, m).text,
           more);
  put_title(picture, m, "set multiplot layout 1,2 title", title);
  double range[2] = {NAN, 1};
  cli_plot_range(picture, range);
  if (any && isnan(range[0]))
    fputs("\nset yrange [*<0:1<*]\n", gp);
  else
    fprintf(gp, "\nset yrange [%g:%g]\n", isnan(range[0]) ? 0 : range[0], range[1]);
  fputs("set xrange [0:90]\nset xtics 15\n"
        "set key below maxrows 3\nset xlabel 'impact angle α_1 / degrees'\n",
        gp);
  for (int t = 0; t < 2; t++) {
    fprintf(gp, "set ylabel 'CoR_%c'\nplot ", t ? 'T' : 'N');
    for (size_t c = 0; c < curves; c++) {
      if (rebounds[c])
        fprintf(gp, "%s$curve%zu using 1:%d with lines", c ? ", " : "", c, t ? 3 : 2);
      else
        fprintf(gp, "%skeyentry with lines", c ? ", " : "");
      fprintf(gp, " ls %zu title '%s, %.3g µm, %.3g m/s%s'", c + 1,
              name_of(picture, m, c / per_wall).text,
              m->sizes.values[c % per_wall / m->speeds.count] * 1e6,
              m->speeds.values[c % m->speeds.count], rebounds[c] ? "" : " (sticks)");
    }
    fputs(", NaN notitle\n", gp);
  }
  fputs("unset multiplot\n", gp);
}
