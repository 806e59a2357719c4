/* The picture of `asperity surface` for one wall and one particle: the whole profile, the part
 * where the particle bridges the most, and a histogram of its angles (Altmeppen et al. 2020,
 * figures 3 and 4).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/plot.h"
#include "cli/surface.h"
#include "surface/closing.h"
#include "surface/slopes.h"

#include <math.h>
#include <stdlib.h>

typedef struct angles {
  double *values; /* degrees */
  size_t count;
  aspi_moments moments;
} angles;

aspi_contact cli_contact(const cli_wall *wall) {
  return wall->name ? ASP_CONTACT_ROLLED : ASP_CONTACT_DILATION;
}

static angles angles_of(const cli_wall *wall, double d_p) {
  angles a = {.values = cli_allocate(asp_profile_points(wall->profile), sizeof(double))};
  asp_error error;
  if (aspi_profile_slopes(wall->profile, d_p, cli_contact(wall), a.values, &a.count, &error))
    cli_fail("%s", error.text);
  for (size_t i = 0; i < a.count; i++)
    a.values[i] = cli_degrees(atan(a.values[i]));
  a.moments = aspi_moments_of(a.values, a.count);
  return a;
}

/* The part of the profile that is shown to scale, three times as wide as it is high, about the
 * valley that the particle bridges at the greatest height. */
typedef struct window {
  size_t first, last, middle;
  double lo, hi;
} window;

static window window_of(const asp_profile *profile, const double *center, const double *closed,
                        double d_p) {
  size_t points = asp_profile_points(profile);
  const double *z = asp_profile_heights(profile);
  double spacing = asp_profile_spacing(profile), width = 4 * d_p;
  window w = {.middle = points / 2};
  size_t margin = (size_t)fmin((double)points / 4, width / 2 / spacing);
  for (size_t i = margin; i + margin < points; i++)
    if (closed[i] - z[i] > closed[w.middle] - z[w.middle])
      w.middle = i;
  for (int round = 0; round < 4; round++) {
    size_t half = (size_t)fmin((double)points, width / 2 / spacing + 1);
    w.first = w.middle > half ? w.middle - half : 0;
    w.last = w.middle + half < points ? w.middle + half : points - 1;
    w.lo = z[w.middle];
    w.hi = center[w.middle] + d_p / 2;
    for (size_t i = w.first; i <= w.last; i++) {
      w.lo = fmin(w.lo, z[i]);
      w.hi = fmax(w.hi, center[i]);
    }
    width = fmax(width, 3 * (w.hi - w.lo));
  }
  return w;
}

/* Draws the whole profile: the least and the greatest height of each of many parts. */
static void plot_all(cli_plot *plot, const asp_profile *profile) {
  enum { PARTS = 1500 };
  size_t points = asp_profile_points(profile), step = points / PARTS + 1;
  const double *z = asp_profile_heights(profile);
  cli_plot_panel(plot, "x / mm", "z / µm");
  cli_plot_place(plot, 0, 0.72, 1, 0.24);
  cli_plot_caption(plot, "whole profile, heights stretched");
  cli_plot_scale(plot, false);
  double length = asp_profile_spacing(profile) * (double)points * 1e3;
  cli_plot_axis(plot, 'x', 0, length);
  cli_plot_series(plot, CLI_LINE, "reference lw 0.7");
  for (size_t i = 0; i < points; i += step) {
    double x = asp_profile_spacing(profile) * (double)i * 1e3, low = z[i], high = z[i];
    for (size_t k = i; k < i + step && k < points; k++) {
      low = fmin(low, z[k]);
      high = fmax(high, z[k]);
    }
    cli_plot_row(plot, x, low * 1e6);
    if (step > 1)
      cli_plot_row(plot, x, high * 1e6);
  }
  cli_plot_end(plot, "%s", "");
}

static void plot_heights(cli_plot *plot, const char *style, const char *name, const double *z,
                         const window *w, double spacing) {
  cli_plot_series(plot, CLI_LINE, "%s", style);
  for (size_t i = w->first; i <= w->last; i += 1 + (w->last - w->first) / 4000)
    cli_plot_row(plot, (double)(i - w->first) * spacing * 1e6, z[i] * 1e6);
  cli_plot_end(plot, "%s", name);
}

/* Profile, closing, the path of the center, and the particle, all to one scale. */
static void plot_bridge(cli_plot *plot, const cli_wall *wall, double d_p) {
  size_t points = asp_profile_points(wall->profile);
  double *center = cli_allocate(points, sizeof *center),
         *closed = cli_allocate(points, sizeof *closed);
  asp_error error;
  if (aspi_profile_dilate(wall->profile, d_p, center, &error) ||
      aspi_profile_close(wall->profile, d_p, closed, &error))
    cli_fail("%s", error.text);
  window w = window_of(wall->profile, center, closed, d_p);
  double spacing = asp_profile_spacing(wall->profile), margin = 0.05 * (w.hi - w.lo);
  cli_plot_panel(plot, "x / µm", "z / µm");
  cli_plot_place(plot, 0, 0.38, 1, 0.34);
  cli_plot_caption(plot, "where a particle of %g µm bridges the most, to scale", d_p * 1e6);
  cli_plot_scale(plot, true);
  cli_plot_axis(plot, 'x', 0, (double)(w.last - w.first) * spacing * 1e6);
  cli_plot_axis(plot, 'y', (w.lo - margin) * 1e6, (w.hi + margin) * 1e6);
  fprintf(cli_plot_stream(plot),
          "set object 1 circle at %g,%g size %g front fs empty border lc rgb '#009e73' lw 2\n",
          (double)(w.middle - w.first) * spacing * 1e6, center[w.middle] * 1e6, d_p / 2 * 1e6);
  plot_heights(plot, "1 lw 4", "closing", closed, &w, spacing);
  plot_heights(plot, "reference", "profile", asp_profile_heights(wall->profile), &w, spacing);
  plot_heights(plot, "2 lw 1", "path of the center", center, &w, spacing);
  cli_plot_series(plot, CLI_LINE, "3 dt 1");
  cli_plot_end(plot, "particle");
  free(center);
  free(closed);
}

static void plot_angles(cli_plot *plot, const angles *a, double kl_normal) {
  double mean = a->moments.mean, sd = a->moments.sd, reach = fmin(4.5 * sd, 90);
  double share[ASPI_HISTOGRAM], width = ASPI_HISTOGRAM_BIN * sd;
  aspi_histogram(a->values, a->count, mean, sd, share);
  cli_plot_panel(plot, "Δα / degrees", "density / (1/degree)");
  cli_plot_place(plot, 0, 0, 1, 0.37);
  cli_plot_axis(plot, 'x', -reach, reach);
  cli_plot_axis(plot, 'y', 0, NAN);
  cli_plot_caption(plot, "angles: mean %.2f°, sd %.2f°; normal fit: D_{KL} %.4f", mean, sd,
                   kl_normal);
  cli_plot_series(plot, CLI_HISTO, "1");
  for (int i = 0; i < ASPI_HISTOGRAM; i++)
    cli_plot_row(plot, mean + (i + 0.5 - ASPI_HISTOGRAM / 2) * width, share[i] / width);
  cli_plot_end(plot, "angles, in bins of %.2g°", width);
  cli_plot_series(plot, CLI_LINE, "2");
  for (int i = -200; i <= 200; i++) {
    double x = reach * i / 200, t = (x - mean) / sd;
    cli_plot_row(plot, x, exp(-t * t / 2) / (sd * sqrt(2 * ASP_PI)));
  }
  cli_plot_end(plot, "normal fit");
}

double cli_kappa(const cli_slopes *row) {
  return sqrt(3) * row->d_p * row->r_q / (row->lambda_c * row->lambda_c);
}

void cli_surface_plot(const cli_call *call, const cli_wall *wall, const cli_slopes *row) {
  cli_plot *plot = cli_plot_open(
      call, 1200, 1100, NULL, "%s%s: R_q = %.3g µm, λ_c = %.3g µm, Φ_R = %.3g, κ = %s",
      wall->name ? "Measured wall " : "Generated wall",
      wall->name ? cli_plot_file(wall->name).text : "", wall->r_q * 1e6, wall->lambda_c * 1e6,
      wall->r_q / wall->lambda_c, cli_plot_number(cli_kappa(row)).text);
  angles all = angles_of(wall, row->d_p);
  plot_all(plot, wall->profile);
  plot_bridge(plot, wall, row->d_p);
  plot_angles(plot, &all, row->slopes.kl_normal);
  free(all.values);
  cli_plot_close(plot);
}
