/* asperity trade: speed against accuracy. Every model on one wall, at several impact angles,
 * against the geometry of that very wall: what an impact costs, how far the law of the first hit
 * and that of the final rebound are off. */
#include "cli/grid.h"
#include "cli/measure.h"
#include "cli/walls.h"

#include <math.h>
#include <stdlib.h>

enum { RQ, LAMBDA_C, DP, ANGLES, RAYS, SEED, COLLISIONS, GRID, OUTPUT, PLOT, N };

typedef struct row {
  const asp_spread_model *model;
  double angle, cost, first_hit, rebound, mean, reference_mean;
} row;

/* The rows of one angle. */
static void judge(const measure_case *subject, double angle, size_t rays, uint32_t seed,
                  bool multiple, row *rows) {
  double alpha1 = cli_radians(angle);
  asp_wall *traced = measure_wall(subject, "traced", true);
  measure_angles reference = measure_rebounds(traced, subject->d_p, alpha1, rays, seed);
  asp_wall_free(traced);
  for (int i = 0; i < asp_spread_count(); i++) {
    const asp_spread_model *model = asp_spread_at(i);
    asp_wall *wall = measure_wall(subject, asp_spread_name(model), multiple);
    measure_angles angles = measure_rebounds(wall, subject->d_p, alpha1, rays, seed + 1);
    rows[i] = (row){.model = model,
                    .angle = angle,
                    .cost = measure_cost(wall, subject->d_p, alpha1),
                    .first_hit = measure_first_hit(subject, wall, alpha1),
                    .rebound = measure_divergence(&reference, &angles),
                    .mean = angles.mean,
                    .reference_mean = reference.mean};
    asp_wall_free(wall);
  }
}

static void print_row(FILE *out, const row *r) {
  fprintf(out, "%s,%g,%.1f,", asp_spread_name(r->model), r->angle, r->cost);
  if (isfinite(r->first_hit))
    fprintf(out, "%.5f", r->first_hit);
  fprintf(out, ",%.5f,%.4f,%.4f\n", r->rebound, r->mean, r->reference_mean);
}

/* A model over all angles: its mean cost, and its worst divergence. */
typedef struct point {
  const asp_spread_model *model;
  double cost, worst;
} point;

static int by_cost(const void *a, const void *b) {
  const point *x = a, *y = b;
  return (x->cost > y->cost) - (x->cost < y->cost);
}

static void summarise(const row *rows, size_t n, point *points) {
  size_t models = (size_t)asp_spread_count();
  for (size_t m = 0; m < models; m++) {
    points[m] = (point){.model = rows[m].model};
    for (size_t i = m; i < n; i += models) {
      points[m].cost += rows[i].cost * (double)models / (double)n;
      points[m].worst = fmax(points[m].worst, rows[i].rebound);
    }
  }
  qsort(points, models, sizeof *points, by_cost);
}

/* Divergences below what the rays can tell are drawn at that. */
#define NOISE 1e-4

/* Gnuplot's point types that can be told apart when they lie on each other. */
static const int marks[] = {7, 5, 9, 11, 13, 6, 4, 8, 10, 12};

static void plot(const cli_option *options, const row *rows, size_t n) {
  size_t models = (size_t)asp_spread_count();
  point *points = malloc(models * sizeof *points);
  if (!points)
    cli_fail("out of memory");
  summarise(rows, n, points);
  cli_plot *picture = cli_plot_open(&options[PLOT], 900, 560);
  FILE *gp = cli_plot_stream(picture);
  fprintf(gp,
          "set title 'Wall r_q %s, {/Symbol l}_c %s; particles %s; {/Symbol a}_1 %s degrees'\n"
          "set xlabel 'time per impact / ns (mean over the angles)'\nset logscale xy\n"
          "set ylabel 'D_{KL} of the rebound angle against the geometry (worst angle)'\n"
          "set format y '%%g'\nset yrange [%g:*]\nset offsets graph 0.05, graph 0.05, 0, 0\n"
          "set xtics (20,50,100,200,500,1000,2000,5000)\n"
          "set key outside right center reverse Left samplen 1\n$points << EOD\n",
          cli_plot_label(picture, options[RQ].value).text,
          cli_plot_label(picture, options[LAMBDA_C].value).text,
          cli_plot_label(picture, options[DP].value).text,
          cli_plot_label(picture, options[ANGLES].value).text, 0.5 * NOISE);
  for (size_t i = 0; i < models; i++)
    fprintf(gp, "%g %g\n", points[i].cost, fmax(points[i].worst, NOISE));
  fputs("EOD\n$front << EOD\n", gp);
  double best = INFINITY;
  for (size_t i = 0; i < models; i++)
    if (fmax(points[i].worst, NOISE) < best) {
      best = fmax(points[i].worst, NOISE);
      fprintf(gp, "%g %g\n", points[i].cost, best);
    }
  fputs("EOD\nplot $front with steps lc rgb '#999999' lw 2 dt 2 title 'Pareto front'", gp);
  for (size_t i = 0; i < models; i++)
    fprintf(gp, ", $points every ::%zu::%zu with points ls %zu pt %d ps 1.6 title '%s'", i, i,
            i % 6 + 1, marks[i % (sizeof marks / sizeof *marks)],
            cli_plot_label(picture, asp_spread_name(points[i].model)).text);
  fputc('\n', gp);
  cli_plot_close(picture);
  free(points);
}

/* All rows, angle by angle. */
static void measure(const cli_option *options, const cli_list *angles, size_t rays, uint32_t seed,
                    row *rows) {
  bool multiple = cli_is_multiple(&options[COLLISIONS]);
  measure_case subject = measure_case_create(
      cli_length(&options[RQ]), cli_length(&options[LAMBDA_C]), cli_length(&options[DP]), seed);
  cli_progress progress = cli_progress_begin("measuring", (double)angles->count);
  for (size_t i = 0; i < angles->count; i++) {
    judge(&subject, angles->values[i], rays, seed, multiple, rows + i * (size_t)asp_spread_count());
    cli_progress_show(&progress, (double)(i + 1));
  }
  cli_progress_end(&progress);
  measure_case_free(&subject);
}

static void print(FILE *out, const row *rows, size_t n) {
  fputs("model,alpha1_deg,ns_per_impact,kl_first_hit,kl_rebound,mean_rebound_deg,"
        "mean_rebound_reference_deg\n",
        out);
  for (size_t i = 0; i < n; i++)
    print_row(out, &rows[i]);
}

static int run(int argc, char **argv) {
  cli_option options[N + 1] = {
      [RQ] = {"rq", "LENGTH", "rms height of the wall", NULL},
      [LAMBDA_C] = {"lambda-c", "LENGTH", "correlation length: autocorrelation 1/e", NULL},
      [DP] = {"dp", "LENGTH", "diameter of the particles", NULL},
      [ANGLES] = {"angles", "DEGREES", "impact angles: a list or from:to:step", "2,5,10,20,45,80"},
      [RAYS] = {"rays", "N", "impacts per model and angle", "200000"},
      [SEED] = {"seed", "N", "seed of the profile and the draws", "1"},
      [COLLISIONS] = {"collisions", "single|multiple", "one hit, or as many as it takes",
                      "multiple"},
      [GRID] = {"grid", NULL, "measure the grid of walls from which `auto` chooses; minutes", NULL},
      [OUTPUT] = {"output", "FILE", "write there instead of to the screen", NULL},
      [PLOT] = {"plot", "FILE", "draw cost against divergence; .png, .svg or .pdf", NULL},
  };
  cli_parse(&cli_trade, argc, argv, options, false);
  size_t rays = cli_whole(&options[RAYS], 1000, 1000000000);
  uint32_t seed = (uint32_t)cli_whole(&options[SEED], 0, UINT32_MAX - 1);
  if (options[GRID].value) {
    cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, &options[SEED]);
    cli_grid(cli_output_stream(output), rays, seed);
    cli_output_close(output);
    return 0;
  }
  cli_list angles = cli_angles(&options[ANGLES]);
  size_t n = angles.count * (size_t)asp_spread_count();
  row *rows = malloc(n * sizeof *rows);
  if (!rows)
    cli_fail("out of memory");
  measure(options, &angles, rays, seed, rows);
  cli_output *output = cli_output_open(options[OUTPUT].value, argc, argv, &options[SEED]);
  print(cli_output_stream(output), rows, n);
  cli_output_close(output);
  if (options[PLOT].value)
    plot(options, rows, n);
  free(rows);
  return 0;
}

const cli_command cli_trade = {
    .name = "trade",
    .summary = "speed against accuracy: every model against the geometry",
    .detail =
        "A row per model and impact angle. The reference follows specular particles over a\n"
        "generated profile, hit by hit; models get the slope of that very profile. kl_first_hit\n"
        "is exact (bins of one degree, a bin that the model cannot fill counts as 1e-6),\n"
        "kl_rebound is sampled and free of bias; it tells nothing below about 30/rays.\n",
    .run = run,
};
