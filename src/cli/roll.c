/* asperity roll: what a sphere does that stays on a wall. It rolls down a rough slope, by the
 * wall's model and over generated walls by geometry alone.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "analysis/roll.h"
#include "base/running.h"
#include "cli/description.h"
#include "cli/plot.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Each generated wall carries one sphere per slope, and STARTS that lie on it. */
enum { STARTS = 4 };

/* Standard gravity, m/s^2 (CGPM 1901). */
#define GRAVITY 9.80665

typedef struct scene {
  cli_description wall;
  cli_list angles; /* of the slopes, degrees */
  aspi_slope slope;
  size_t spheres;
  double step, duration; /* in sqrt(lambda_c/g) */
  bool in_space;
} scene;

/* How spheres move on one slope. */
typedef struct motion {
  aspi_running speed;
  double stopped, started; /* shares */
} motion;

/* One slope: the reference and the model. */
typedef struct row {
  double angle;
  motion reference, model;
} row;

static aspi_slope slope_at(const scene *s, double degrees) {
  aspi_slope slope = s->slope;
  slope.angle = cli_radians(degrees);
  return slope;
}

static void add_motion(motion *m, const scene *s, aspi_roll roll) {
  if (roll.stopped)
    m->stopped += 1 / (double)s->spheres;
  else
    aspi_running_add(&m->speed, roll.speed);
}

/* The share of all spheres that these make which start below a slope. */
static double started(const scene *s, const double start[STARTS], double degrees) {
  int count = 0;
  for (int k = 0; k < STARTS; k++)
    count += start[k] < tan(cli_radians(degrees));
  return count / (double)(STARTS * s->spheres);
}

/* A place on wall `number`; they lie apart from each other. */
static double place_of(const scene *s, size_t number, double lambdas) {
  return s->slope.lambda_c * (lambdas + 3.7 * (double)number);
}

/* All motions over one generated wall, added to the rows. */
static asp_code roll_over(const scene *s, uint32_t number, row *rows, asp_error *error) {
  const asp_surface *surface = asp_wall_surface(s->wall.wall);
  double d_p = s->slope.particle.d_p, r_q = asp_surface_r_q(surface);
  double s_eff = asp_surface_slope(surface, d_p), start[STARTS];
  aspi_roll *rolls = cli_allocate(s->angles.count, sizeof *rolls);
  aspi_ground ground;
  uint32_t seed = (uint32_t)asp_description_get(s->wall.words, "seed") + number;
  asp_code code =
      aspi_ground_create(&ground, r_q, s->slope.lambda_c, d_p, s->in_space, seed, error);
  for (size_t i = 0; i < s->angles.count && !code; i++) {
    aspi_slope slope = slope_at(s, s->angles.values[i]);
    rolls[i] = aspi_ground_roll(&ground, &slope, place_of(s, i, 0), 0, s->duration);
  }
  for (size_t k = 0; k < STARTS && !code; k++)
    start[k] = aspi_ground_start(&ground, &s->slope, place_of(s, k, 20), place_of(s, k, 5), s_eff);
  aspi_ground_free(&ground);
#pragma omp critical
  for (size_t i = 0; i < s->angles.count && !code; i++) {
    add_motion(&rows[i].reference, s, rolls[i]);
    rows[i].reference.started += started(s, start, rows[i].angle);
  }
  free(rolls);
  return code;
}

/* All motions of one sphere by the model. */
static void roll_model(const scene *s, uint64_t tag, row *rows) {
  static const double along[3] = {1, 0, 0}, up[3] = {0, 0, 1};
  uint32_t seed = (uint32_t)asp_description_get(s->wall.words, "seed");
  double start[STARTS];
  for (uint32_t k = 0; k < STARTS; k++)
    start[k] =
        asp_wall_valley(s->wall.wall, &s->slope.particle, along, up, &(asp_key){seed, 3, tag, k})
            .start;
  for (size_t i = 0; i < s->angles.count; i++) {
    aspi_slope slope = slope_at(s, rows[i].angle);
    aspi_roll roll = aspi_slope_roll(&slope, s->step, s->duration, tag);
#pragma omp critical
    {
      add_motion(&rows[i].model, s, roll);
      rows[i].model.started += started(s, start, rows[i].angle);
    }
  }
}

static void roll_all(const scene *s, row *rows) {
  cli_progress progress = cli_progress_begin("spheres", (double)s->spheres);
  asp_error worst = {ASP_OK, ""};
  size_t done = 0;
  for (size_t i = 0; i < s->angles.count; i++)
    rows[i] = (row){.angle = s->angles.values[i]};
#pragma omp parallel for schedule(dynamic)
  for (size_t k = 0; k < s->spheres; k++) {
    asp_error own = {ASP_OK, ""};
    asp_code code = roll_over(s, (uint32_t)k, rows, &own);
    roll_model(s, k + 1, rows);
#pragma omp critical
    {
      if (code)
        worst = own;
      cli_progress_show(&progress, (double)++done);
    }
  }
  cli_progress_end(&progress);
  cli_must(!worst.code, &worst);
}

/* ---- output ---- */

static double speed_of(const motion *m) {
  return m->speed.n > 0 ? m->speed.mean : NAN;
}

static double error_of(const motion *m) {
  return m->speed.n > 1 ? aspi_running_sd(&m->speed) / sqrt(m->speed.n) : NAN;
}

static void print(FILE *out, const row *rows, size_t n) {
  fputs("slope_deg,speed_reference_m_s,speed_reference_se,speed_model_m_s,speed_model_se,"
        "stopped_reference,stopped_model,started_reference,started_model\n",
        out);
  for (size_t i = 0; i < n; i++) {
    const motion *a = &rows[i].reference, *b = &rows[i].model;
    cli_row(out, "%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", rows[i].angle, speed_of(a),
            error_of(a), speed_of(b), error_of(b), a->stopped, b->stopped, a->started, b->started);
  }
}

static void plot_shares(cli_plot *picture, const row *rows, size_t n, bool of_starts) {
  static const char *const names[] = {"geometry", "model"};
  static const char *const styles[] = {"reference", "model_visible"};
  cli_plot_panel(picture, "slope / °",
                 of_starts ? "share that starts from rest" : "share that stops");
  cli_plot_scale(picture, false);
  cli_plot_axis(picture, 'y', 0, 1);
  for (int k = 0; k < 2; k++) {
    cli_plot_series(picture, CLI_LINE, "%s", styles[k]);
    for (size_t i = 0; i < n; i++) {
      const motion *m = k ? &rows[i].model : &rows[i].reference;
      cli_plot_row(picture, rows[i].angle, of_starts ? m->started : m->stopped);
    }
    cli_plot_end(picture, "%s", names[k]);
  }
}

static void plot(const cli_call *call, const scene *s, const row *rows, size_t n) {
  cli_plot *picture =
      cli_plot_open(call, 1500, 480, "1,3", "%s; d_p = %.3g µm; steps of %.3g µs; %zu spheres",
                    cli_plot_wall(s->wall.words, s->wall.wall).text, s->slope.particle.d_p * 1e6,
                    s->step * aspi_slope_time(&s->slope) * 1e6, s->spheres);
  cli_plot_panel(picture, "slope / °", "speed / (m/s), ± s.e.");
  cli_plot_axis(picture, 'y', 0, NAN);
  for (int k = 0; k < 2; k++) {
    cli_plot_series(picture, CLI_ERRORS, "%s", k ? "model_visible" : "reference");
    for (size_t i = 0; i < n; i++) {
      const motion *m = k ? &rows[i].model : &rows[i].reference;
      cli_plot_row(picture, rows[i].angle, speed_of(m), error_of(m));
    }
    cli_plot_end(picture, k ? "model" : "geometry");
  }
  plot_shares(picture, rows, n, false);
  plot_shares(picture, rows, n, true);
  cli_plot_close(picture);
}

/* ---- the command ---- */

static scene read_scene(const cli_call *call) {
  scene s = {.wall = cli_description_read(call->n_words, call->words, false),
             .angles = cli_numbers(cli_get(call, "slopes"), 0, 60),
             .spheres = cli_whole(cli_get(call, "spheres"), 2, 10000),
             .step = cli_number(cli_get(call, "step"), 1e-4, 1),
             .duration = cli_number(cli_get(call, "duration"), 10, 1e5)};
  double d_p = cli_length(cli_get(call, "dp"));
  const char *surface = asp_description_word(s.wall.words, "surface");
  const char *law = asp_rebound_name(asp_description_rebound(s.wall.words));
  bool has_lay = asp_description_lay(s.wall.words).kind != ASP_LAY_NONE;
  if (strcmp(surface, "rq") != 0 || has_lay)
    cli_bad_usage("'surface' is '%s'%s; spheres roll on 'surface rq R lambda_c L' without a lay",
                  surface, has_lay ? " with a lay" : "");
  if (asp_description_is_given(s.wall.words, "grain"))
    cli_bad_usage("'grain' has no effect: what rolls is a sphere");
  if (strcmp(law, "walton") != 0)
    cli_bad_usage("'rebound' is '%s'; a sphere that rolls takes 'rebound walton'", law);
  cli_description_make(&s.wall, d_p, d_p);
  s.in_space = strcmp(asp_description_word(s.wall.words, "tilt"), "isotropic") == 0;
  s.slope = (aspi_slope){.wall = s.wall.wall,
                         .particle = {.d_p = d_p, .density = s.wall.density},
                         .friction = asp_description_get(s.wall.words, "mu"),
                         .lambda_c = asp_surface_lambda_c(asp_wall_surface(s.wall.wall)),
                         .gravity = GRAVITY};
  return s;
}

static void run(cli_call *call) {
  scene s = read_scene(call);
  size_t n = s.angles.count;
  row *rows = cli_allocate(n, sizeof *rows);
  roll_all(&s, rows);
  FILE *out = cli_output_open(call, "output", s.wall.text);
  print(out, rows, n);
  cli_file_close(out);
  if (cli_value(call, "plot"))
    plot(call, &s, rows, n);
}

static const cli_option options[] = {
    {"dp", "LENGTH", "diameter of the spheres", NULL},
    {"slopes", "DEGREES", "slopes of the wall: a list", "1,2,3,4,5,6,8,10,12,15,20"},
    {"spheres", "N", "spheres per slope, each on a wall of its own", "16"},
    {"duration", "N", "time of the motion, in sqrt(lambda_c/g)", "300"},
    {"step", "N", "time step of the model, in sqrt(lambda_c/g)", "0.05"},
    {.name = NULL}};

static const char detail[] =
    "A row per slope. A sphere begins to roll down a rough slope. The reference follows it\n"
    "over generated walls by geometry alone: a profile for `plane`, a surface for\n"
    "`isotropic`. The model meets the mean wall as in an engine. speed is the mean along\n"
    "the slope in the last half of the motion, of spheres that have not stopped, with the\n"
    "standard error over the spheres; stopped is the share of the others. started is the\n"
    "share of spheres at rest that have rolled away before the slope, rising slowly, gets so\n"
    "steep. --step tells whether a time step is short enough.\n";

const cli_command cli_roll = {
    .name = "roll",
    .summary = "a sphere that rolls down a rough slope, by the model and by geometry",
    .arguments = "DESCRIPTION",
    .detail = detail,
    .examples =
        "  $ asperity roll surface rq 15um lambda_c 100um spread visible plane rebound walton "
        "0.5 0.3 0 --dp 400um --plot roll.png\n",
    .options = options,
    .picture = "draw speed and shares over the slope; .png, .svg or .pdf",
    .run = run,
};
