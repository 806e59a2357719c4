/* The picture of `asperity cor`.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/running.h"
#include "cli/cor.h"

#include <string.h>
#include <math.h>

enum { CELLS = 45 };

/* A list or a log-normal, times a factor, with its unit. */
static void print_values(FILE *gp, const cli_list *v, double factor, const char *unit) {
  if (v->count == 1)
    fprintf(gp, "%.3g %s; ", v->least * factor, unit);
  else if (v->count > 1)
    fprintf(gp, "%.3g … %.3g %s; ", v->least * factor, v->most * factor, unit);
  else
    fprintf(gp, "log-normal, %.3g … %.3g %s, median %.3g; ", v->least * factor, v->most * factor,
            unit, v->median * factor);
}

/* The wall in the title. */
static void print_wall(FILE *gp, const cli_plot *picture, const asp_wall *wall) {
  const asp_surface *surface = asp_wall_surface(wall);
  if (!surface)
    return;
  if (strcmp(asp_wall_word(wall, "surface"), "sigma") == 0)
    fprintf(gp, "σ = %.4g°, ", cli_degrees(atan(asp_surface_slope_rms(surface))));
  else
    fprintf(gp, "R_q = %.3g µm, λ_c = %.3g µm, Φ_R = %.3g, ", asp_surface_r_q(surface) * 1e6,
            asp_surface_lambda_c(surface) * 1e6, asp_surface_phi_r(surface));
  fprintf(gp, "%s; ", cli_plot_label(picture, asp_spread_name(asp_wall_spread(wall))).text);
}

/* A panel: CoR_N over the impact angle, or CoR_T. */
typedef struct panel {
  int t;                                    /* 1: CoR_T */
  double range[2];                          /* of the axis */
  size_t drawn, outside;                    /* impacts; those that the axes cut off */
  size_t means, means_outside;              /* of cells of 2 degrees */
  bool rebounds;                            /* the smooth wall somewhere */
  aspi_running cells[CELLS], angles[CELLS]; /* of the impacts */
} panel;

static bool is_outside(const panel *p, double y) {
  return y < p->range[0] || y > p->range[1];
}

static void print_impacts(FILE *gp, panel *p, const cor_row *rows, size_t n, size_t every) {
  fprintf(gp, "$scatter%d << EOD\n", p->t);
  for (size_t i = 0; i < n; i++) {
    if (rows[i].impact.outcome == ASP_DEPOSIT || (p->t && !rows[i].cor.cor_t_defined))
      continue;
    double y = p->t ? rows[i].cor.cor_t : rows[i].cor.cor_n;
    int cell = (int)(rows[i].alpha1 / 90 * CELLS);
    cell = cell < CELLS ? cell : CELLS - 1;
    aspi_running_add(&p->cells[cell], y);
    aspi_running_add(&p->angles[cell], rows[i].alpha1);
    p->outside += is_outside(p, y);
    if (p->drawn++ % every == 0)
      fprintf(gp, "%g %g\n", rows[i].alpha1, y);
  }
  fputs("EOD\n", gp);
}

static void print_means(FILE *gp, panel *p) {
  fprintf(gp, "$mean%d << EOD\n", p->t);
  for (int i = 0; i < CELLS; i++) {
    const aspi_running *c = &p->cells[i];
    if (c->n < 2)
      continue;
    fprintf(gp, "%g %g %g\n", p->angles[i].mean, c->mean, aspi_running_sd(c));
    p->means++;
    p->means_outside += is_outside(p, c->mean);
  }
  fputs("EOD\n", gp);
}

static void print_smooth(FILE *gp, panel *p, const cor_scene *smooth) {
  fprintf(gp, "$smooth%d << EOD\n", p->t);
  for (int i = 1; i < 180; i++) {
    cor_row r = cli_cor_impact(smooth, 0.5 * i, 0, 1);
    if (r.impact.outcome != ASP_REBOUND)
      continue;
    p->rebounds = true;
    fprintf(gp, "%g %g\n", 0.5 * i, p->t ? r.cor.cor_t : r.cor.cor_n);
  }
  fputs("EOD\n", gp);
}

/* What the axes cut off, over a panel. */
static void print_outside(FILE *gp, const panel *p, size_t n) {
  fputs("unset title\n", gp);
  if (p->outside > 0)
    fprintf(gp, "set title '{/=9 %.1f %% of the impacts", 100 * (double)p->outside / (double)n);
  if (p->outside > 0 && p->means_outside > 0)
    fprintf(gp, " and %zu of the means", p->means_outside);
  if (p->outside > 0)
    fputs(" lie outside}'\n", gp);
}

/* One of `every` impacts is drawn; the smooth wall is met by one size at one speed. */
static void plot_panel(cli_plot *picture, int t, const cor_row *rows, size_t n, size_t every,
                       const cor_scene *smooth) {
  FILE *gp = cli_plot_stream(picture);
  panel p = {.t = t, .range = {t ? -1 : 0, t ? 2 : 3}};
  cli_plot_range(picture, p.range);
  print_impacts(gp, &p, rows, n, every);
  print_means(gp, &p);
  print_smooth(gp, &p, smooth);
  fprintf(gp, "set ylabel 'CoR_%c'\nset yrange [%g:%g]\nset key %s opaque\n", t ? 'T' : 'N',
          p.range[0], p.range[1], t ? "bottom left" : "top right");
  print_outside(gp, &p, n);
  fputs("plot NaN notitle", gp);
  if (p.drawn > 0)
    fprintf(gp, ", $scatter%d with points pt 7 ps 0.2 lc rgb '#9fc5dd' title 'impacts", t);
  if (p.drawn > 0 && every > 1)
    fprintf(gp, ", one of %zu", every);
  if (p.drawn > 0)
    fputc('\'', gp);
  if (p.means > 0)
    fprintf(gp,
            ", $mean%d using 1:2:3 with yerrorbars pt 7 ps 0.5 lc rgb '#0072b2' title "
            "'mean ± sd'",
            t);
  if (p.rebounds)
    fprintf(gp, ", $smooth%d with lines ls 2 dt 1", t);
  else
    fputs(", keyentry with lines ls 2 dt 1", gp);
  fprintf(gp, " title 'smooth wall, %.3g µm, %.3g m/s%s'\n", smooth->sizes.least * 1e6,
          smooth->speeds.least, p.rebounds ? "" : " (sticks)");
}

static void print_title(FILE *gp, const cli_plot *picture, const cor_scene *s, const cor_row *rows,
                        size_t n) {
  const cli_description *wall = &s->wall;
  size_t deposits = 0;
  if (cli_plot_title(picture)) {
    fprintf(gp, "set multiplot layout 1,2 title '%s'\n", cli_plot_title(picture));
    return;
  }
  for (size_t i = 0; i < n; i++)
    deposits += rows[i].impact.outcome == ASP_DEPOSIT;
  fputs("set multiplot layout 1,2 title '{/=10 ", gp);
  if (wall->particle) {
    fprintf(gp, "%s on ", cli_plot_label(picture, asp_material_name(wall->particle)).text);
    fprintf(gp, "%s, ", cli_plot_label(picture, asp_material_name(wall->target)).text);
  }
  fprintf(gp, "%s; ", cli_plot_label(picture, asp_rebound_name(asp_wall_rebound(wall->wall))).text);
  print_wall(gp, picture, wall->wall);
  fputs("v_1 = ", gp);
  print_values(gp, &s->speeds, 1, "m/s");
  fputs("d_p = ", gp);
  print_values(gp, &s->sizes, 1e6, "µm");
  fprintf(gp, "%zu impacts, %.1f %% stick and are left out}'\n", n,
          100 * (double)deposits / (double)n);
}

/* The first of a list, or the median of a law. */
static cli_list one_of(const cli_list *list, double *value) {
  *value = list->count ? list->values[0] : list->median;
  return (cli_list){.values = value, .count = 1, .least = *value, .most = *value};
}

/* The scatter, its running mean and sd over 2 degrees, and the smooth wall at the median diameter.
 */
void cli_cor_plot(const cli_option *options, const cor_scene *s, const cor_row *rows, size_t n) {
  cli_plot *picture = cli_plot_open(&options[PLOT], 1200, 520);
  FILE *gp = cli_plot_stream(picture);
  double d_p, speed;
  cor_scene smooth = {.wall = cli_description_smooth(&s->wall),
                      .speeds = one_of(&s->speeds, &speed),
                      .sizes = one_of(&s->sizes, &d_p)};
  print_title(gp, picture, s, rows, n);
  fputs("set xrange [0:90]\nset xtics 15\n"
        "set xlabel 'impact angle α_1 / degrees'\n",
        gp);
  for (int t = 0; t < 2; t++)
    plot_panel(picture, t, rows, n, n / 20000 + 1, &smooth);
  fputs("unset multiplot\n", gp);
  cli_description_free(&smooth.wall);
  cli_plot_close(picture);
}
