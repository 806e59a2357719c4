/* The picture of `asperity surface`: the paper's figures 3 to 5 for one wall and one particle.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/surface.h"
#include "surface/closing.h"
#include "surface/slopes.h"

#include <math.h>
#include <stdlib.h>

enum { GRID = 2000 };

typedef struct angles {
  double *values; /* degrees */
  size_t count;
  aspi_moments moments;
} angles;

aspi_contact cli_contact(const cli_wall *wall) {
  return wall->name ? ASP_CONTACT_ROLLED : ASP_CONTACT_DILATION;
}

static angles angles_of(const cli_wall *wall, const asp_profile *profile, double d_p) {
  angles a = {.values = cli_allocate(asp_profile_points(profile), sizeof(double))};
  asp_error error;
  if (aspi_profile_slopes(profile, d_p, cli_contact(wall), a.values, &a.count, &error))
    cli_fail("%s", error.text);
  for (size_t i = 0; i < a.count; i++)
    a.values[i] = cli_degrees(atan(a.values[i]));
  a.moments = aspi_moments_of(a.values, a.count);
  return a;
}

/* Densities over one range: five sd about zero, but no less than what is measured. */
static aspi_density *density_of(const angles *a, const angles *range) {
  double most = 5 * range->moments.sd;
  for (size_t i = 0; i < range->count; i++)
    most = fmax(most, fabs(range->values[i]));
  asp_error error;
  aspi_density *density = aspi_density_create(a->values, a->count, -most, most, GRID, &error);
  if (!density)
    cli_fail("%s", error.text);
  return density;
}

double cli_generated_kl(const cli_wall *wall, double d_p) {
  angles measured = angles_of(wall, wall->profile, d_p);
  angles generated = angles_of(wall, wall->generated, d_p);
  aspi_density *p = density_of(&measured, &measured), *q = density_of(&generated, &measured);
  double kl = aspi_density_kl(p, q);
  aspi_density_free(p);
  aspi_density_free(q);
  free(measured.values);
  free(generated.values);
  return kl;
}

/* The part of the profile that is shown to scale, three times as wide as it is high, about the
 * valley that the particle bridges at the greatest height. */
typedef struct window {
  size_t first, last, middle;
  double lo, hi;
} window;

static window window_of(const asp_profile *profile, const double *centre, const double *closed,
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
    w.hi = centre[w.middle] + d_p / 2;
    for (size_t i = w.first; i <= w.last; i++) {
      w.lo = fmin(w.lo, z[i]);
      w.hi = fmax(w.hi, centre[i]);
    }
    width = fmax(width, 3 * (w.hi - w.lo));
  }
  return w;
}

static void put_profile(FILE *out, const asp_profile *profile, const double *centre,
                        const double *closed, const window *w) {
  const double *z = asp_profile_heights(profile);
  double spacing = asp_profile_spacing(profile);
  fputs("$profile << EOD\n", out);
  for (size_t i = w->first; i <= w->last; i += 1 + (w->last - w->first) / 4000)
    fprintf(out, "%.8g %.8g %.8g %.8g\n", (double)(i - w->first) * spacing * 1e6, z[i] * 1e6,
            closed[i] * 1e6, centre[i] * 1e6);
  fputs("EOD\n", out);
}

/* Profile, closing, the path of the centre, and the particle, all to one scale. */
static void figure_3(FILE *out, const cli_wall *wall, double d_p) {
  size_t points = asp_profile_points(wall->profile);
  double *centre = cli_allocate(points, sizeof *centre),
         *closed = cli_allocate(points, sizeof *closed);
  asp_error error;
  if (aspi_profile_dilate(wall->profile, d_p, centre, &error) ||
      aspi_profile_close(wall->profile, d_p, closed, &error))
    cli_fail("%s", error.text);
  window w = window_of(wall->profile, centre, closed, d_p);
  double spacing = asp_profile_spacing(wall->profile), margin = 0.05 * (w.hi - w.lo);
  put_profile(out, wall->profile, centre, closed, &w);
  fprintf(out,
          "set title 'Profile, closing and particle where it bridges the most, d_p = %g µm, to "
          "scale (fig. 3)'\n"
          "set xlabel 'x / µm'\nset ylabel 'z / µm'\nset size ratio -1\n"
          "set object 1 circle at %g,%g size %g front fs empty border lc rgb '#009e73' lw 2\n"
          "set key outside right center\n"
          "plot [0:%g] [%g:%g] $profile using 1:3 with lines ls 1 lw 4 title 'closing', "
          "$profile using 1:2 with lines ls 6 lw 1 title 'profile', "
          "$profile using 1:4 with lines ls 2 lw 1 dt 2 title 'path of the centre', "
          "NaN with lines ls 3 dt 1 title 'particle'\n"
          "unset object 1\nset size noratio\nset key default\nset key font ',10'\n",
          d_p * 1e6, (double)(w.middle - w.first) * spacing * 1e6, centre[w.middle] * 1e6,
          d_p / 2 * 1e6, (double)(w.last - w.first) * spacing * 1e6, (w.lo - margin) * 1e6,
          (w.hi + margin) * 1e6);
  free(centre);
  free(closed);
}

static double peak_of(const aspi_density *density) {
  double most = 0;
  for (size_t i = 0; i < aspi_density_points(density); i++)
    most = fmax(most, aspi_density_at(density, i, NULL));
  return most;
}

static void put_density(FILE *out, const char *name, const aspi_density *density) {
  fprintf(out, "$%s << EOD\n", name);
  for (size_t i = 0; i < aspi_density_points(density); i++) {
    double x, y = aspi_density_at(density, i, &x);
    fprintf(out, "%g %g\n", x, y);
  }
  fputs("EOD\n", out);
}

static void figure_4(cli_plot *plot, const cli_wall *wall, const cli_slopes *row) {
  FILE *out = cli_plot_stream(plot);
  angles a = angles_of(wall, wall->profile, row->d_p);
  aspi_density *density = density_of(&a, &a);
  double reach = fmin(4.5 * a.moments.sd, 90);
  put_density(out, "density", density);
  cli_plot_set_range(plot, 0, 1.3 * peak_of(density));
  fprintf(out,
          "set title 'Angles: mean %.2f°, sd %.2f°, D_{KL} of the normal fit %.4f (fig. 4)'\n"
          "set xlabel 'Δα / °'\nset ylabel 'density / (1/°)'\nset xrange [%g:%g]\n"
          "set samples 500\n"
          "plot $density with lines ls 1 title 'kernel density, bandwidth %.2g°', "
          "exp(-(x - %g)**2/(2*%g**2))/(%g*sqrt(2*pi)) with lines ls 2 dt 2 title 'normal fit'\n",
          a.moments.mean, a.moments.sd, row->slopes.kl_normal, -reach, reach,
          aspi_density_bandwidth(density), a.moments.mean, a.moments.sd, a.moments.sd);
  aspi_density_free(density);
  free(a.values);
}

static void figure_5(cli_plot *plot, const cli_wall *wall, double d_p) {
  FILE *out = cli_plot_stream(plot);
  angles measured = angles_of(wall, wall->profile, d_p);
  angles generated = angles_of(wall, wall->generated, d_p);
  aspi_density *p = density_of(&measured, &measured), *q = density_of(&generated, &measured);
  put_density(out, "measured", p);
  put_density(out, "generated", q);
  cli_plot_set_range(plot, 0, 1.3 * fmax(peak_of(p), peak_of(q)));
  fprintf(out,
          "set title 'Measured against generated, D_{KL} %.4f (fig. 5)'\n"
          "plot $measured with lines ls 1 title 'measured, sd %.2f°', "
          "$generated with lines ls 2 dt 2 title 'generated, of the same R_q and λ_c, sd %.2f°'\n",
          aspi_density_kl(p, q), measured.moments.sd, generated.moments.sd);
  aspi_density_free(p);
  aspi_density_free(q);
  free(measured.values);
  free(generated.values);
}

void cli_surface_plot(const cli_option *option, const cli_wall *wall, const cli_slopes *row) {
  cli_plot *plot = cli_plot_open(option, 1200, 900);
  FILE *out = cli_plot_stream(plot);
  if (cli_plot_title(plot))
    fprintf(out, "set multiplot title '%s'\n", cli_plot_title(plot));
  else
    fprintf(out, "set multiplot title '%s%s: R_q = %.3g µm, λ_c = %.3g µm, Φ_R = %.3g, κ = %.3g'\n",
            wall->name ? "Measured wall " : "Generated wall",
            wall->name ? cli_plot_label(plot, wall->name).text : "", wall->r_q * 1e6,
            wall->lambda_c * 1e6, wall->r_q / wall->lambda_c, cli_kappa(row));
  fputs("set size 1, 0.47\nset origin 0, 0.48\n", out);
  figure_3(out, wall, row->d_p);
  fprintf(out, "set size %g, 0.48\nset origin 0, 0\n", wall->generated ? 0.5 : 1);
  figure_4(plot, wall, row);
  if (wall->generated) {
    fputs("set origin 0.5, 0\n", out);
    figure_5(plot, wall, row->d_p);
  }
  fputs("unset multiplot\n", out);
  cli_plot_close(plot);
}
