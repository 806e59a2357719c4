/* The picture of `asperity cor`: impacts, their mean and sd over the impact angle, and the smooth
 * wall at the median diameter.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/running.h"
#include "cli/cor.h"
#include "cli/plot.h"

#include <math.h>

/* An angle with fewer impacts than IMPACTS_LEAST is merged with its neighbors, over at most
 * CELL_MOST degrees. */
#define IMPACTS_LEAST 30
#define CELL_MOST 2.0

enum { DOTS_MOST = 20000 };

/* A list or a log-normal, times a factor, with its unit. */
static cli_label values_of(const cli_list *v, double factor, const char *unit) {
  cli_label label;
  int used = snprintf(label.text, sizeof label.text, "%.3g", v->least * factor);
  if (v->most > v->least)
    used += snprintf(label.text + used, 99, " … %.3g", v->most * factor);
  used += snprintf(label.text + used, 99, " %s", unit);
  if (v->count == 0)
    snprintf(label.text + used, 99, " (log-normal, median %.3g)", v->median * factor);
  return label;
}

static cli_plot *open_picture(const cli_option *option, const cor_scene *s, const cor_row *rows,
                              size_t n) {
  const cli_description *wall = &s->wall;
  size_t deposits = 0;
  char pair[2 * sizeof(cli_label) + 10] = "";
  for (size_t i = 0; i < n; i++)
    deposits += rows[i].impact.outcome == ASP_DEPOSIT;
  if (wall->particle)
    snprintf(pair, sizeof pair, "%s on %s; ",
             cli_plot_label(asp_material_name(wall->particle)).text,
             cli_plot_label(asp_material_name(wall->target)).text);
  return cli_plot_open(
      option, 1200, 520, "1,2",
      "%s%s; %s, %s; v_1 = %s; d_p = %s; %zu impacts, %.1f %% stick and are left out", pair,
      cli_plot_label(asp_rebound_name(asp_wall_rebound(wall->wall))).text,
      cli_plot_wall(wall->wall).text,
      cli_plot_label(asp_spread_name(asp_wall_spread(wall->wall))).text,
      values_of(&s->speeds, 1, "m/s").text, values_of(&s->sizes, 1e6, "µm").text, n,
      100 * (double)deposits / (double)n);
}

/* CoR_N, or CoR_T of t; NAN where there is none. */
static double value_of(const cor_row *r, int t) {
  if (r->impact.outcome == ASP_DEPOSIT || (t && !r->cor.cor_t_defined))
    return NAN;
  return t ? r->cor.cor_t : r->cor.cor_n;
}

static void plot_impacts(cli_plot *picture, int t, const cor_row *rows, size_t n) {
  size_t every = n / DOTS_MOST + 1;
  cli_plot_series(picture, CLI_MARKS, "impacts");
  for (size_t i = 0; i < n; i += every)
    cli_plot_row(picture, rows[i].alpha1, value_of(&rows[i], t));
  if (every > 1)
    cli_plot_end(picture, "impacts, one of %zu", every);
  else
    cli_plot_end(picture, "impacts");
}

/* Mean and sd by angle. */
static void plot_means(cli_plot *picture, int t, const cor_row *rows, size_t n, const char *style) {
  cli_plot_series(picture, CLI_BAND, "%s", style);
  for (size_t i = 0, next; i < n; i = next) {
    aspi_running y = {0, 0, 0}, angle = {0, 0, 0};
    for (next = i; next < n; next++) {
      if (rows[next].alpha1 > rows[i].alpha1 &&
          (next - i >= IMPACTS_LEAST || rows[next].alpha1 >= rows[i].alpha1 + CELL_MOST))
        break;
      if (!isfinite(value_of(&rows[next], t)))
        continue;
      aspi_running_add(&y, value_of(&rows[next], t));
      aspi_running_add(&angle, rows[next].alpha1);
    }
    if (y.n > 1)
      cli_plot_row(picture, angle.mean, y.mean, aspi_running_sd(&y));
  }
  cli_plot_end(picture, "mean ± sd");
}

/* True if impacts at one angle differ at all. */
static bool varies(const cor_row *rows, size_t n) {
  for (size_t i = 1; i < n; i++)
    if (rows[i].alpha1 <= rows[i - 1].alpha1 && rows[i].cor.cor_n != rows[i - 1].cor.cor_n &&
        rows[i].impact.outcome == rows[i - 1].impact.outcome)
      return true;
  return false;
}

/* The first of a list, or the median of a law. */
static cli_list one_of(const cli_list *list, double *value) {
  *value = list->count ? list->values[0] : list->median;
  return (cli_list){.values = value, .count = 1, .least = *value, .most = *value};
}

static void plot_smooth(cli_plot *picture, int t, const cor_scene *smooth) {
  size_t rebounds = 0;
  cli_plot_series(picture, CLI_LINE, "model_none");
  for (int i = 1; i < 180; i++) {
    cor_row r = cli_cor_impact(smooth, 0.5 * i, 0, 1);
    rebounds += r.impact.outcome == ASP_REBOUND;
    cli_plot_row(picture, 0.5 * i, value_of(&r, t));
  }
  cli_plot_end(picture, "smooth wall, %.3g µm, %.3g m/s%s", smooth->sizes.least * 1e6,
               smooth->speeds.least, rebounds ? "" : " (sticks)");
}

void cli_cor_plot(const cli_option *options, const cor_scene *s, const cor_row *rows, size_t n) {
  char style[80];
  double d_p, speed;
  cor_scene smooth = {.wall = cli_description_smooth(&s->wall),
                      .speeds = one_of(&s->speeds, &speed),
                      .sizes = one_of(&s->sizes, &d_p)};
  const asp_wall *wall = s->wall.wall;
  if (asp_wall_surface(wall))
    snprintf(style, sizeof style, "model_%s", asp_spread_name(asp_wall_spread(wall)));
  else
    snprintf(style, sizeof style, "law_%s", asp_rebound_name(asp_wall_rebound(wall)));
  cli_plot *picture = open_picture(&options[PLOT], s, rows, n);
  for (int t = 0; t < 2; t++) {
    cli_plot_coefficient(picture, t);
    plot_impacts(picture, t, rows, n);
    if (varies(rows, n))
      plot_means(picture, t, rows, n, style);
    plot_smooth(picture, t, &smooth);
  }
  cli_plot_close(picture);
  cli_description_free(&smooth.wall);
}
