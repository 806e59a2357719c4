/* The picture of `asperity doe`: the paper's figures 10 to 12, and all of it over kappa. The law
 * drawn in is s_eff by the wall's two numbers; the variance of the angles that goes with it is that
 * of atan(slope) for normal slopes of that rms.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/doe.h"

#include <gsl/gsl_cdf.h>
#include <math.h>

enum { QUANTILES = 400, CURVE = 80, CURVES_MOST = 6 };

#define FIGURE_10_D_P 40e-6

static double square(double x) {
  return x * x;
}

static double variance_of(double angle_sd) {
  return square(cli_degrees(angle_sd));
}

/* deg^2; NAN where the size law does not reach. */
static double law_variance(double r_q, double lambda_c, double d_p) {
  asp_surface *surface = asp_surface_create(r_q, lambda_c, NULL);
  double sum = 0;
  if (!surface || asp_surface_check(surface, d_p, NULL))
    sum = NAN;
  for (int i = 0; i < QUANTILES && isfinite(sum); i++) {
    double x = gsl_cdf_ugaussian_Pinv((i + 0.5) / QUANTILES);
    sum += square(atan(x * asp_surface_slope(surface, d_p)));
  }
  asp_surface_free(surface);
  return variance_of(sqrt(sum / QUANTILES));
}

static void put(FILE *out, double x, double y) {
  if (isfinite(y))
    fprintf(out, "%g %g\n", x, y);
}

static const cli_slopes *row_at(const cli_grid *g, size_t wall, size_t size) {
  return &g->rows[wall * g->d_p.count + size];
}

static size_t nearest_size(const cli_grid *g, double d_p) {
  size_t best = 0;
  for (size_t i = 1; i < g->d_p.count; i++)
    if (fabs(g->d_p.values[i] - d_p) < fabs(g->d_p.values[best] - d_p))
      best = i;
  return best;
}

/* Variance over phi_r at one size: a set of points and a curve of the law per lambda_c. */
static void figure_10(FILE *out, const cli_grid *g) {
  size_t size = nearest_size(g, FIGURE_10_D_P), columns = g->lambda_c.count;
  size_t shown = columns < CURVES_MOST ? columns : CURVES_MOST;
  double phi_most = 0;
  for (size_t i = 0; i < g->count; i++)
    phi_most = fmax(phi_most, g->rows[i].r_q / g->rows[i].lambda_c);
  for (size_t k = 0; k < shown; k++) {
    double lambda_c = g->lambda_c.values[k];
    fprintf(out, "$points%zu << EOD\n", k);
    for (size_t r = 0; r < g->r_q.count; r++) {
      const cli_slopes *row = row_at(g, r * columns + k, size);
      put(out, row->r_q / row->lambda_c, variance_of(row->slopes.angle.sd));
    }
    fprintf(out, "EOD\n$law%zu << EOD\n", k);
    for (int i = 1; i <= CURVE; i++) {
      double phi = phi_most * i / CURVE;
      put(out, phi, law_variance(phi * lambda_c, lambda_c, g->d_p.values[size]));
    }
    fputs("EOD\n", out);
  }
  fprintf(out,
          "set title 'Over Φ_R at d_p = %g µm (fig. 10)'\nset xlabel 'Φ_R'\n"
          "set ylabel 'variance of Δα / deg²'\nset key top left\nplot ",
          g->d_p.values[size] * 1e6);
  for (size_t k = 0; k < shown; k++)
    fprintf(out,
            "$law%zu with lines ls %zu lw 1.3 notitle, "
            "$points%zu with points pt 7 ps 0.8 lc rgb word(colours, %zu) title 'λ_c = %g µm'%s",
            k, k + 1, k, k + 1, g->lambda_c.values[k] * 1e6, k + 1 < shown ? ", " : "\n");
}

/* Walls of about 0.05, 0.1, 0.2, 0.4 and the largest phi_r: those the grid has nearest to them. */
static size_t choose_walls(const cli_grid *g, size_t walls[CURVES_MOST]) {
  static const double wanted[] = {10, 0.4, 0.2, 0.1, 0.05};
  size_t count = 0;
  for (size_t w = 0; w < sizeof wanted / sizeof *wanted; w++) {
    size_t best = 0;
    for (size_t k = 1; k < g->count / g->d_p.count; k++) {
      double here = row_at(g, k, 0)->r_q / row_at(g, k, 0)->lambda_c;
      double there = row_at(g, best, 0)->r_q / row_at(g, best, 0)->lambda_c;
      if (fabs(here - wanted[w]) < fabs(there - wanted[w]))
        best = k;
    }
    if (count == 0 || walls[count - 1] != best)
      walls[count++] = best;
  }
  return count;
}

static void put_walls(FILE *out, const cli_grid *g, const size_t *walls, size_t count) {
  for (size_t w = 0; w < count; w++) {
    fprintf(out, "$points%zu << EOD\n", w);
    for (size_t i = 0; i < g->d_p.count; i++) {
      const cli_slopes *row = row_at(g, walls[w], i);
      put(out, row->d_p * 1e6, variance_of(row->slopes.angle.sd));
    }
    fprintf(out, "EOD\n$law%zu << EOD\n", w);
    const cli_slopes *row = row_at(g, walls[w], 0);
    for (size_t i = 0; i < g->d_p.count; i++)
      put(out, g->d_p.values[i] * 1e6, law_variance(row->r_q, row->lambda_c, g->d_p.values[i]));
    fputs("EOD\n", out);
  }
}

static void figure_11(FILE *out, const cli_grid *g) {
  size_t walls[CURVES_MOST], count = choose_walls(g, walls);
  put_walls(out, g, walls, count);
  fputs("set title 'Over d_p (fig. 11)'\nset xlabel 'd_p / µm'\nset logscale y\n"
        "set ylabel 'variance of Δα / deg²'\nset key top right\nplot ",
        out);
  for (size_t w = 0; w < count; w++) {
    const cli_slopes *row = row_at(g, walls[w], 0);
    fprintf(out,
            "$law%zu with lines ls %zu lw 1.3 notitle, $points%zu with points pt 7 ps 0.5 "
            "lc rgb word(colours, %zu) title 'Φ_R = %.3g (R_q = %g, λ_c = %g µm)'%s",
            w, w + 1, w, w + 1, row->r_q / row->lambda_c, row->r_q * 1e6, row->lambda_c * 1e6,
            w + 1 < count ? ", " : "\nunset logscale y\n");
  }
}

/* The least and most phi_r and d_p/lambda_c of a grid. */
typedef struct range {
  double phi[2], size[2];
} range;

static range range_of(const cli_grid *g) {
  range r = {{INFINITY, 0}, {INFINITY, 0}};
  for (size_t i = 0; i < g->count; i++) {
    double phi = g->rows[i].r_q / g->rows[i].lambda_c, size = g->rows[i].d_p / g->rows[i].lambda_c;
    r.phi[0] = fmin(r.phi[0], phi);
    r.phi[1] = fmax(r.phi[1], phi);
    r.size[0] = fmin(r.size[0], size);
    r.size[1] = fmax(r.size[1], size);
  }
  return r;
}

/* Lines of equal variance by the law, over the range of the grid. */
static void put_contours(FILE *out, const range *r) {
  fputs("$map << EOD\n", out);
  for (int i = 0; i <= CURVE; i++) {
    double phi = r->phi[0] * pow(r->phi[1] / r->phi[0], (double)i / CURVE);
    for (int k = 0; k <= CURVE; k++) {
      double size = r->size[0] * pow(r->size[1] / r->size[0], (double)k / CURVE);
      double variance = law_variance(phi, 1, size);
      fprintf(out, isfinite(variance) ? "%g %g %g\n" : "%g %g NaN\n", phi, size, variance);
    }
    fputc('\n', out);
  }
  fputs("EOD\nset contour base\nunset surface\nset cntrparam levels discrete "
        "0.1, 0.3, 1, 3, 10, 30, 100, 200, 400, 700, 1000\nset table $contours\n"
        "splot $map using 1:2:3\nunset table\nunset contour\nset surface\n",
        out);
}

/* Variance over the two numbers that decide it, phi_r and d_p/lambda_c: the law as contours. */
static void figure_12(FILE *out, const cli_grid *g) {
  fputs("$all << EOD\n", out);
  for (size_t i = 0; i < g->count; i++) {
    const cli_slopes *row = &g->rows[i];
    fprintf(out, "%g %g %g\n", row->r_q / row->lambda_c, row->d_p / row->lambda_c,
            variance_of(row->slopes.angle.sd));
  }
  fputs(
      "EOD\nset style textbox opaque noborder margins 1,1\nset title 'Over Φ_R and d_p/λ_c (fig. "
      "12)'\nset xlabel 'Φ_R'\n"
      "set ylabel 'd_p / λ_c'\nset logscale xycb\nset cblabel 'variance of Δα / deg²'\n"
      "set key outside top center horizontal\n"
      "plot $all using 1:2:3 with points pt 7 ps 0.6 palette title 'generated profiles', "
      "$contours using 1:2 with lines lc rgb 'black' lw 1 title 'size law', "
      "$contours using 1:2:(sprintf('%g', $3)) every 1000::25 with labels boxed font ',9' notitle\n"
      "unset logscale xycb\nset key default\nset key font ',10'\n",
      out);
}

/* The wall of the grid with the largest phi_r that the size law reaches. */
static const cli_slopes *roughest(const cli_grid *g) {
  const cli_slopes *best = NULL;
  for (size_t k = 0; k < g->count; k += g->d_p.count) {
    const cli_slopes *row = &g->rows[k];
    if (isfinite(law_variance(row->r_q, row->lambda_c, row->d_p)) &&
        (!best || row->r_q / row->lambda_c > best->r_q / best->lambda_c))
      best = row;
  }
  return best;
}

static void put_law(FILE *out, const cli_slopes *wall) {
  asp_surface *surface = asp_surface_create(wall->r_q, wall->lambda_c, NULL);
  fputs("$law << EOD\n", out);
  for (int i = 0; surface && i <= CURVE; i++) {
    double kappa = 1e-3 * pow(2e4, (double)i / CURVE), d_p = kappa / asp_surface_kappa(surface, 1);
    put(out, kappa, asp_surface_slope(surface, d_p) / asp_surface_slope_rms(surface));
  }
  fputs("EOD\n", out);
  asp_surface_free(surface);
}

static void over_kappa(FILE *out, const cli_grid *g) {
  const cli_slopes *wall = roughest(g);
  fputs("$ratio << EOD\n", out);
  for (size_t i = 0; i < g->count; i++) {
    const cli_slopes *row = &g->rows[i];
    double phi = row->r_q / row->lambda_c;
    fprintf(out, "%g %g %g\n", cli_kappa(row), row->slopes.slope_rms / (sqrt(2) * phi), phi);
  }
  fputs("EOD\n", out);
  if (wall)
    put_law(out, wall);
  fputs("set title 'Every combination over κ (scatter at small κ: the profiles are samples)'\n"
        "set xlabel 'κ = √3 d_p R_q / λ_c²'\nset ylabel 's_{eff} / s'\nset logscale x\n"
        "set xrange [0.001:20]\nset yrange [0:1.1]\nset key bottom left\nset cblabel 'Φ_R'\n"
        "plot $ratio using 1:2:3 with points pt 7 ps 0.3 palette title 'generated profiles', "
        "(1 + 0.92*x**3)**(-1./6) with lines ls 6 title 'closed form, Φ_R ≤ 0.25'",
        out);
  if (wall)
    fprintf(out, ", $law with lines ls 2 dt 2 title 'size law at Φ_R = %.3g'",
            wall->r_q / wall->lambda_c);
  fputc('\n', out);
}

void cli_doe_plot(const cli_option *option, const cli_grid *grid) {
  cli_plot *plot = cli_plot_open(option, 1400, 1050);
  FILE *out = cli_plot_stream(plot);
  fputs("colours = '#1f5fa8 #c8501e #2a8c4a #7a3fa0 #8a6d1b #444444'\n"
        "set palette defined (0 '#1f5fa8', 0.5 '#8a6d1b', 1 '#c8501e')\n",
        out);
  range r = range_of(grid);
  put_contours(out, &r);
  fputs("set multiplot layout 2,2 title 'Slope angles of generated profiles: points; by the size "
        "law of R_q and λ_c: lines'\n",
        out);
  figure_10(out, grid);
  figure_11(out, grid);
  figure_12(out, grid);
  over_kappa(out, grid);
  fputs("unset multiplot\n", out);
  cli_plot_close(plot);
}
