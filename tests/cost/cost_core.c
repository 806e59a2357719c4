/* Costs of the core: a contact with each kind of wall, a draw of each model, a disc that rolls over
 * a profile, a description.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "count.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "analysis/compare.h"
#include "gauss_map.h"
#include "spread/models.h"
#include "surface/heights.h"
#include "surface/rolling.h"
#include "surface/slopes.h"

enum { CONTACTS = 2000, CONTACTS_OF_MODEL = 400, DRAWS = 1000, PARSES = 20, POINTS = 100000 };

static const double R_Q = 10e-6, LAMBDA_C = 100e-6, D_P = 20e-6;
static const char ROUGH[] = "surface rq 10um lambda_c 100um materials quartz hastelloy-x";

static void check(bool is_right, const asp_error *error) {
  if (is_right)
    return;
  fprintf(stderr, "cost_core: %s\n", error->text);
  exit(1);
}

/* Impact angles between 0 and 90 degrees, in no order. */
static double angle(int i) {
  return ((i * 389) % 1024 + 0.5) / 1024 * ASP_PI / 2;
}

/* ---- a contact ---- */

static void contacts(const asp_wall *wall, int count) {
  const asp_particle grain = {.d_p = D_P, .density = 2650};
  const double n[3] = {0, 0, 1};
  for (int i = 0; i < count; i++) {
    const double v[3] = {100 * cos(angle(i)), 0, -100 * sin(angle(i))};
    asp_impact impact;
    count_on();
    asp_wall_impact(wall, &grain, v, n, &(asp_key){1, 1, (uint64_t)i, 1, 0}, &impact);
    count_off();
  }
}

/* heights: of a measured wall, or NULL. */
static void count_contacts(const char *what, const char *text, const asp_heights *heights,
                           int count) {
  asp_error error;
  asp_description *words = asp_description_parse(text, NULL, &error);
  check(words && (!heights || !asp_description_set_heights(words, heights, &error)), &error);
  asp_wall *wall = asp_wall_create(words, D_P, D_P, &error);
  check(wall, &error);
  count_begin();
  contacts(wall, count);
  count_end(what, count);
  asp_wall_free(wall);
  asp_description_free(words);
}

/* The columns of choosing.md: each model at walls of three ratios of heights to correlation length.
 */
static void count_models(void) {
  static const double ratio[] = {0.04, 0.125, 0.6};
  for (int k = 0; k < 3; k++)
    for (int i = 1; i < asp_spread_count(); i++) { /* behind `none` */
      char what[40], text[100];
      const char *name = asp_spread_at(i)->name;
      snprintf(what, sizeof what, "contact, %s, %g", name, ratio[k]);
      snprintf(text, sizeof text, "surface rq %gum lambda_c 100um spread %s rebound constant 1 1",
               100 * ratio[k], name);
      count_contacts(what, text, NULL, CONTACTS_OF_MODEL);
    }
}

/* ---- a draw ---- */

static void count_draws(const asp_spread_model *model, const aspi_height_field *of) {
  asp_error error;
  const aspi_sizes sizes = {D_P, D_P, 1};
  void *data = model->prepare ? model->prepare(of, &sizes, &error) : NULL;
  check(data || !model->prepare, &error);
  aspi_spread_input input = aspi_spread_input_of(atan(asp_surface_slope(of->surface, D_P)), 0);
  input.d_p = D_P;
  input.kappa = asp_surface_kappa(of->surface, D_P);
  input.data = data;
  count_begin();
  for (int i = 0; i < DRAWS; i++) {
    input.alpha1 = angle(i);
    double delta;
    count_on();
    aspi_stream stream = aspi_stream_begin(&(asp_key){1, 1, (uint64_t)i, 1, 0});
    aspi_spread_draw(model, &input, &stream, &delta);
    count_off();
  }
  char what[40];
  snprintf(what, sizeof what, "draw, %s", model->name);
  count_end(what, DRAWS);
  if (model->release)
    model->release(data);
}

/* ---- a disc, a description ---- */

static void count_disc(const char *what, const asp_heights *wall, double d_p) {
  asp_error error;
  count_begin();
  count_on();
  asp_heights *path = aspi_profile_rolled(wall, d_p, 1, &error);
  count_off();
  count_end(what, POINTS);
  check(path, &error);
  asp_heights_free(path);
}

static void count_profile(void) {
  asp_error error;
  asp_heights *wall = aspi_profile_generate(10, 100, 1, POINTS, 1, &error);
  check(wall, &error);
  count_disc("disc over 1e5 points, a point", wall, 200);
  static double noise[POINTS];
  aspi_stream stream = aspi_stream_begin(&(asp_key){.seed = 1});
  for (int i = 0; i < POINTS; i++)
    noise[i] = aspi_stream_uniform(&stream);
  asp_heights *noisy = asp_heights_create(noise, POINTS, 1, 1, 1, true, &error);
  check(noisy, &error);
  count_disc("wide disc over noise, a point", noisy, 20000);
  asp_heights_free(noisy);
  aspi_slopes slopes;
  count_begin();
  count_on();
  asp_code code = aspi_profile_describe_slopes(wall, 200, &slopes, &error);
  count_off();
  count_end("slopes of 1e5 points, a point", POINTS);
  check(!code, &error);
  asp_heights_free(wall);
}

static void count_parses(void) {
  asp_error error;
  count_begin();
  for (int i = 0; i < PARSES; i++) {
    count_on();
    asp_description *words = asp_description_parse(ROUGH, NULL, &error);
    count_off();
    check(words, &error);
    asp_description_free(words);
  }
  count_end("description, parsed", PARSES);
}

/* ---- two files of impacts ---- */

/* As a ledger of a curved wall: no two impacts are alike. */
static aspi_scatter impacts_of(uint32_t seed, size_t count) {
  aspi_scatter s = {.rows = calloc(count, sizeof *s.rows), .count = count, .has_outcome = true};
  aspi_stream stream = aspi_stream_begin(&(asp_key){seed, 1, 1, 1, 0});
  for (size_t i = 0; i < count && s.rows; i++) {
    aspi_scatter_row *row = &s.rows[i];
    *row = (aspi_scatter_row){.degrees = 5 + 40 * ((double)i + 0.5) / (double)count,
                              .v1 = 50 + 50 * aspi_stream_uniform(&stream),
                              .d_p = D_P,
                              .rows = 1};
    row->least = row->most = row->degrees;
    row->cor[COR_N] = aspi_stream_uniform(&stream);
    row->cor[COR_T] = aspi_stream_uniform(&stream);
    row->cor[REBOUND_ANGLE] = NAN;
  }
  return s;
}

static void count_compared(const char *what, size_t rows) {
  const aspi_compare_reach far = {1, 0.1, 0.1};
  aspi_comparison c = {.impacts = impacts_of(1, rows), .data = impacts_of(2, rows)};
  asp_error error;
  aspi_grouping grouping;
  check(c.impacts.rows && c.data.rows, &error);
  count_begin();
  count_on();
  asp_code code = aspi_compare_grouping(&c.data, &far, &grouping, &error);
  c.impacts.grouping = &grouping;
  for (size_t i = 0; i < rows && !code; i++)
    aspi_scatter_key(&c.impacts, &c.impacts.rows[i]);
  if (!code && !(code = aspi_compare_make_bins(&c, 5, false, &error)))
    code = aspi_compare_fill(&c, &far, &error);
  count_off();
  count_end(what, (double)rows);
  check(!code, &error);
  aspi_compare_grouping_free(&grouping);
  free(c.bins);
  free(c.impacts.rows);
  free(c.data.rows);
}

int main(void) {
  asp_error error;
  const gauss_wall gauss = {R_Q, LAMBDA_C, LAMBDA_C, 0};
  const double step[2] = {LAMBDA_C / 10, LAMBDA_C / 10};
  asp_surface *surface = asp_surface_create(R_Q, LAMBDA_C, &error);
  check(surface, &error);
  asp_heights *profile = aspi_profile_generate(R_Q, LAMBDA_C, LAMBDA_C / 20, 4096, 1, &error);
  check(profile, &error);
  asp_heights *map = gauss_map_create(&gauss, step, 128, 128, 1, &error);
  check(map, &error);

  count_contacts("contact, smooth", "materials quartz hastelloy-x", NULL, CONTACTS);
  count_contacts("contact, rough", ROUGH, NULL, CONTACTS);
  count_contacts("contact, as in the paper",
                 "surface rq 10um lambda_c 100um spread weibull plane collisions single materials "
                 "quartz hastelloy-x",
                 NULL, CONTACTS);
  count_contacts("contact, measured profile", "surface profile wall materials quartz hastelloy-x",
                 profile, CONTACTS);
  count_contacts("contact, map", "surface map wall materials quartz hastelloy-x", map, CONTACTS);
  count_contacts("contact, none", "rebound constant 1 1", NULL, CONTACTS_OF_MODEL);
  count_models();
  for (int i = 1; i < asp_spread_count(); i++) /* behind `none` */
    count_draws(asp_spread_at(i), &(aspi_height_field){surface, NULL, false});
  count_profile();
  count_parses();
  count_compared("two files of 2500 impacts, a row", 2500);
  count_compared("two files of 20000 impacts, a row", 20000);

  asp_heights_free(map);
  asp_heights_free(profile);
  asp_surface_free(surface);
  return 0;
}
