/* The picture of `asperity cor`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/running.h"
#include "cli/cor.h"

#include <string.h>
#include <math.h>

enum { CELLS = 45 };

/* A list or a log-normal, times a factor, with its unit. */
static void print_values(FILE *gp, const cor_values *v, double factor, const char *unit) {
  if (v->list.count == 1)
    fprintf(gp, "%.3g %s; ", v->least * factor, unit);
  else if (v->list.count > 1)
    fprintf(gp, "%.3g … %.3g %s; ", v->least * factor, v->most * factor, unit);
  else
    fprintf(gp, "log-normal, %.3g … %.3g %s, median %.3g; ", v->least * factor, v->most * factor,
            unit, v->median * factor);
}

/* The wall in the title. */
static void print_wall(FILE *gp, const cli_plot *picture, const cli_option *options,
                       const cor_scene *s) {
  if (!s->rough.surface)
    return;
  if (options[ROUGH + ROUGH_SIGMA].value)
    fprintf(gp, "{/Symbol s} = %s°, ",
            cli_plot_label(picture, options[ROUGH + ROUGH_SIGMA].value).text);
  else
    fprintf(gp, "R_q = %.3g µm, {/Symbol l}_c = %.3g µm, {/Symbol F}_R = %.3g, ",
            asp_surface_r_q(s->rough.surface) * 1e6, asp_surface_lambda_c(s->rough.surface) * 1e6,
            asp_surface_phi_r(s->rough.surface));
  fprintf(gp, "%s; ", cli_plot_label(picture, asp_spread_name(asp_wall_spread(s->law.wall))).text);
}

/* What the axes cut off, over a panel. */
static void print_outside(FILE *gp, size_t outside, size_t n, size_t means) {
  if (outside == 0)
    fputs("unset title\n", gp);
  else if (means == 0)
    fprintf(gp, "set title '{/=9 %.1f %% of the impacts lie outside}'\n",
            100 * (double)outside / (double)n);
  else
    fprintf(gp, "set title '{/=9 %.1f %% of the impacts and %zu of the means lie outside}'\n",
            100 * (double)outside / (double)n, means);
}

/* The scatter, its running mean and sd over 2 degrees, and the smooth wall at the median diameter.
 */
void cli_cor_plot(const cli_option *options, const cor_scene *s, const cor_row *rows, size_t n) {
  static const char *const names[] = {"CoR_N", "CoR_T"};
  static const double bottom[] = {0, -1}, top[] = {3, 2};
  cli_plot *picture = cli_plot_open(&options[PLOT], 1200, 520);
  FILE *gp = cli_plot_stream(picture);
  double d_p = s->sizes.list.count ? s->sizes.list.values[0] : s->sizes.median;
  double speed = s->speeds.list.count ? s->speeds.list.values[0] : s->speeds.median;
  cor_scene smooth = {.speeds = {.list = {&speed, 1}, .least = speed, .most = speed},
                      .sizes = {.list = {&d_p, 1}, .least = d_p, .most = d_p}};
  cli_option none[N + 1];
  memcpy(none, options, sizeof none);
  none[MODEL].value = "none";
  cli_cor_read_wall(none, &smooth);
  size_t every = n / 20000 + 1, deposits = 0;
  for (size_t i = 0; i < n; i++)
    deposits += rows[i].impact.outcome == ASP_DEPOSIT;
  char thinned[40] = "";
  if (every > 1)
    snprintf(thinned, sizeof thinned, ", one of %zu", every);
  fprintf(gp, "set multiplot layout 1,2 title '{/=10 %s on %s, %s; ",
          cli_plot_label(picture, asp_material_name(s->law.particle)).text,
          cli_plot_label(picture, options[LAW + LAW_WALL].value).text,
          cli_plot_label(picture, asp_rebound_name(asp_wall_rebound(s->law.wall))).text);
  print_wall(gp, picture, options, s);
  fputs("v_1 = ", gp);
  print_values(gp, &s->speeds, 1, "m/s");
  fputs("d_p = ", gp);
  print_values(gp, &s->sizes, 1e6, "µm");
  fprintf(gp, "%zu impacts, %.1f %% stick and are left out}'\n", n,
          100 * (double)deposits / (double)n);
  fputs("set xrange [0:90]\nset xtics 15\n"
        "set xlabel 'impact angle {/Symbol a}_1 / degrees'\n",
        gp);
  for (int t = 0; t < 2; t++) {
    aspi_running cells[CELLS] = {{0, 0, 0}}, angles[CELLS] = {{0, 0, 0}};
    size_t outside = 0, means = 0;
    bool rebounds = false, every_one_sticks = true;
    fprintf(gp, "$scatter%d << EOD\n", t);
    for (size_t i = 0; i < n; i++) {
      if (rows[i].impact.outcome == ASP_DEPOSIT || (t && !rows[i].cor.cor_t_defined))
        continue;
      double y = t ? rows[i].cor.cor_t : rows[i].cor.cor_n;
      int cell = (int)(rows[i].alpha1 / 90 * CELLS);
      cell = cell < CELLS ? cell : CELLS - 1;
      aspi_running_add(&cells[cell], y);
      aspi_running_add(&angles[cell], rows[i].alpha1);
      every_one_sticks = false;
      outside += y < bottom[t] || y > top[t];
      if (i % every == 0)
        fprintf(gp, "%g %g\n", rows[i].alpha1, y);
    }
    fprintf(gp, "EOD\n$mean%d << EOD\n", t);
    for (int i = 0; i < CELLS; i++) {
      if (cells[i].n > 1)
        fprintf(gp, "%g %g %g\n", angles[i].mean, cells[i].mean, aspi_running_sd(&cells[i]));
      means += cells[i].n > 1 && (cells[i].mean < bottom[t] || cells[i].mean > top[t]);
    }
    fprintf(gp, "EOD\n$smooth%d << EOD\n", t);
    for (int i = 1; i < 180; i++) {
      cor_row r = cli_cor_impact(&smooth, 0.5 * i, 0, 1, 1);
      rebounds = rebounds || r.impact.outcome == ASP_REBOUND;
      if (r.impact.outcome == ASP_REBOUND)
        fprintf(gp, "%g %g\n", 0.5 * i, t ? r.cor.cor_t : r.cor.cor_n);
    }
    fprintf(gp, "EOD\nset ylabel '%s'\nset yrange [%g:%g]\nset key %s opaque\n", names[t],
            bottom[t], top[t], t ? "bottom left" : "top right");
    print_outside(gp, outside, n, means);
    if (every_one_sticks)
      fputs("plot NaN notitle, ", gp);
    else
      fprintf(
          gp,
          "plot $scatter%d with points pt 7 ps 0.2 lc rgb '#9fc5dd' title 'impacts%s', "
          "$mean%d using 1:2:3 with yerrorbars pt 7 ps 0.5 lc rgb '#0072b2' title 'mean ± sd', ",
          t, thinned, t);
    if (rebounds)
      fprintf(gp, "$smooth%d with lines ls 2 dt 1", t);
    else
      fputs("keyentry with lines ls 2 dt 1", gp);
    fprintf(gp, " title 'smooth wall, %.3g µm, %.3g m/s%s'\n", d_p * 1e6, speed,
            rebounds ? "" : " (sticks)");
  }
  fputs("unset multiplot\n", gp);
  cli_cor_free_wall(&smooth);
  cli_plot_close(picture);
}
