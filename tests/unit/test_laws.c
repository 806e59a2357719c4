/* The laws that come from measurements: Grant & Tabakoff's means and scatter, tables of a user's
 * coefficients; and a user's own materials.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "choice.h"

#include <stdlib.h>
#include <unistd.h>

/* A file with that text; its name is kept until the next one. */
static const char *file_of(const char *text) {
  static char path[64];
  snprintf(path, sizeof path, "/tmp/asperity-test-XXXXXX");
  int handle = mkstemp(path);
  assert_true(handle >= 0);
  assert_int_equal(write(handle, text, strlen(text)), (int)strlen(text));
  close(handle);
  return path;
}

static aspi_bounce bounce_of(const char *name, const double *parameters,
                             const aspi_cor_table *table, double degrees, double speed,
                             aspi_stream *stream) {
  const asp_rebound_law *law = asp_rebound_find(name, NULL);
  double alpha = degrees * M_PI / 180;
  aspi_hit hit = {.v_n1 = speed * sin(alpha),
                  .v_t1 = speed * cos(alpha),
                  .d_p = 1e-4,
                  .density = 2650,
                  .table = table,
                  .stream = stream};
  return law->rebound(parameters, &hit);
}

/* The polynomials, worked out by hand at 30 and 60 degrees. */
TEST(grant_tabakoff_means) {
  static const double table[][3] = {{30, 0.428811, 0.601118}, {60, 0.297957, 0.794111}};
  static const double none[ASP_PARAMETERS_MAX];
  for (int i = 0; i < 2; i++) {
    double alpha = table[i][0] * M_PI / 180;
    aspi_bounce b = bounce_of("grant_tabakoff", none, NULL, table[i][0], 100, NULL);
    assert_near(b.v_n2 / (100 * sin(alpha)), table[i][1], 1e-6);
    assert_near(b.v_t2 / (100 * cos(alpha)), table[i][2], 1e-6);
  }
}

/* Its own scatter has the measured means and standard deviations, here at 60 degrees. */
TEST(grant_tabakoff_scatter) {
  enum { N = 40000 };
  static const double all[ASP_PARAMETERS_MAX] = {1};
  double b = M_PI / 3, mean = 0, square = 0;
  double sd = 2.15 * b - 5.02 * b * b + 4.05 * b * b * b - 1.085 * b * b * b * b;
  for (uint64_t i = 1; i <= N; i++) {
    aspi_stream stream = aspi_stream_begin(&(asp_key){1, 1, i, 1, 0});
    double e_n = bounce_of("grant_tabakoff", all, NULL, 60, 1, &stream).v_n2 / sin(b), step;
    assert_true(e_n > 0);
    step = e_n - mean;
    mean += step / (double)i;
    square += step * (e_n - mean);
  }
  assert_near(mean, 0.297957, 5 * sd / sqrt(N));
  assert_near(sqrt(square / N), sd, 0.03 * sd);
}

/* A measured scatter holds roughness: with a rough surface it is refused, its means are not. */
TEST(scatter_is_not_counted_twice) {
  asp_error error;
  static const char *const allowed[] = {
      "surface rq 5um lambda_c 40um spread weibull rebound grant_tabakoff",
      "rebound grant_tabakoff scatter 1"};
  for (int i = 0; i < 2; i++) {
    asp_wall *wall = asp_wall_from_text(allowed[i], 0, 0, &error);
    assert_non_null(wall);
    asp_wall_free(wall);
  }
  assert_null(asp_wall_from_text(
      "surface rq 5um lambda_c 40um spread weibull rebound grant_tabakoff scatter 1", 0, 0,
      &error));
  assert_int_equal(error.code, ASP_EARG);
  assert_says(error.text, "twice");
}

static const aspi_cor_point points[] = {
    {100, 1.2, 0.3, 0.7}, {10, 0.2, 0.9, 0.8},  {10, 0.6, 0.6, 0.75},
    {10, 1.2, 0.5, 0.75}, {100, 0.2, 0.8, 0.7}, {100, 0.6, 0.4, 0.6},
};
enum { N_POINTS = sizeof points / sizeof *points };

TEST(table_meets_its_points) {
  aspi_cor_table *table = aspi_cor_table_create(points, N_POINTS, NULL);
  assert_non_null(table);
  double n, t;
  for (int i = 0; i < N_POINTS; i++) {
    aspi_cor_table_at(table, points[i].speed, points[i].alpha1, &n, &t);
    assert_near(n, points[i].cor_n, 1e-15);
    assert_near(t, points[i].cor_t, 1e-15);
  }
  aspi_cor_table_at(table, 55, 0.6, &n, &t);
  assert_near(n, 0.5, 1e-15);
  aspi_cor_table_at(table, 1, 0, &n, &t);
  assert_near(n, 0.9, 1e-15);
  aspi_cor_table_at(table, 1e5, M_PI_2, &n, &t);
  assert_near(n, 0.3, 1e-15);
  aspi_cor_table_free(table);
}

/* Between points of falling cor_n it falls, at every speed; and the rebound has no more energy. */
TEST(table_is_monotone) {
  aspi_cor_table *table = aspi_cor_table_create(points, N_POINTS, NULL);
  for (double speed = 5; speed < 200; speed += 3) {
    double last = 2, n, t;
    for (double alpha = 0; alpha < M_PI_2; alpha += 1e-3) {
      aspi_cor_table_at(table, speed, alpha, &n, &t);
      assert_true(n <= last && n >= 0.3);
      last = n;
      aspi_bounce b = bounce_of("table", NULL, table, alpha * 180 / M_PI, speed, NULL);
      assert_true(hypot(b.v_n2, b.v_t2) <= speed * (1 + 1e-15));
    }
  }
  aspi_cor_table_free(table);
}

/* Angles and speeds that nearly coincide: coefficients that are numbers, or an error. */
TEST(close_points_are_numbers_or_refused) {
  static const double apart[] = {5e-324, 1e-310, 1e-300, 1e-100, 1e-10, 2e-9, 1e-6};
  asp_error error;
  for (size_t i = 0; i < sizeof apart / sizeof *apart; i++) {
    aspi_cor_point close[] = {
        {0, 0, 0.9, 0.9},        {0, apart[i], 0.1, 0.5},        {0, 1, 0.5, 0.2},
        {apart[i], 0, 0.2, 0.3}, {apart[i], apart[i], 0.9, 0.2}, {apart[i], 1, 0.5, 0.9}};
    aspi_cor_table *table = aspi_cor_table_create(close, 6, &error);
    assert_int_equal(table != NULL, apart[i] > 1e-9);
    if (!table)
      assert_says(error.text, "degrees apart");
    for (int k = 0; table && k < 1000; k++) {
      double n, t, speed = k % 3 * 0.5 * apart[i], alpha1 = k % 2 ? k * 2e-3 : k * apart[i] / 500;
      aspi_cor_table_at(table, speed, alpha1, &n, &t);
      assert_true(fabs(n - 0.5) <= 0.4 + 1e-12 && fabs(t - 0.55) <= 0.35 + 1e-12);
    }
    aspi_cor_table_free(table);
  }
}

TEST(table_law_looks_up) {
  aspi_cor_table *table = aspi_cor_table_create(points, N_POINTS, NULL);
  aspi_wall_choice choice = choice_of("table");
  choice.table = table;
  asp_wall *wall = wall_of(&choice);
  aspi_cor_table_free(table); /* the wall has a copy */
  asp_particle grain = {.d_p = 1e-4, .density = 2650, .pair = NULL};
  double v1[3] = {10 * cos(0.6), 0, -10 * sin(0.6)}, n[3] = {0, 0, 1};
  asp_impact impact;
  asp_wall_impact(wall, &grain, v1, n, &(asp_key){1, 1, 1, 1, 0}, &impact);
  assert_near(impact.v2[2], 6 * sin(0.6), 1e-14);
  assert_near(impact.v2[0], 7.5 * cos(0.6), 1e-14);
  asp_wall_free(wall);
}

/* Says what is wrong with the file of a row, and removes it. */
static void check_refused(const char *path, const asp_error *error, char *row[]) {
  for (int i = 1; i < 3; i++)
    assert_says(error->text, row[i]);
  assert_says(error->text, path);
  unlink(path);
}

static void refuses_table(char *row[]) {
  asp_error error = {0};
  const char *path = file_of(row[0]);
  assert_null(aspi_cor_table_read(path, 1, &error));
  check_refused(path, &error, row);
}

static void refuses_materials(char *row[]) {
  asp_error error = {0};
  const char *path = file_of(row[0]);
  assert_null(aspi_materials_read(path, &error));
  check_refused(path, &error, row);
}

static void check_table(char *row[]) {
  asp_error error = {0};
  const char *path = file_of(row[0]);
  aspi_cor_table *table = aspi_cor_table_read(path, 1, &error);
  unlink(path);
  assert_string_equal(error.text, "");
  assert_non_null(table);
  double n, t;
  aspi_cor_table_at(table, 5, M_PI / 4, &n, &t);
  assert_near(n, 0.6, 1e-12);
  assert_near(t, 0.75, 1e-12);
  aspi_cor_table_free(table);
}

TEST(tables_are_read) {
  CHECK_ROWS("tables.txt", check_table);
}

TEST(bad_tables_are_named) {
  CHECK_ROWS("tables.txt", refuses_table);
}

TEST(own_materials) {
  asp_error error = {0};
  const char *path =
      file_of("# our own\n"
              "name,title,youngs_modulus_pa,poissons_ratio,density_kg_m3,yield_stress_pa,source\n"
              "fly-ash,\"Fly ash, plant \"\"B\"\"\",5e10,0.2,2100,1.5e8,\"Smith 1999, table 2\"\n"
              "twin,,7.2e10,0.17,2650,,\nTwin,,7e10,0.17,2650,,\nquartz,,7.2e10,0.17,2650,,\n");
  aspi_materials *own = aspi_materials_read(path, &error);
  assert_string_equal(error.text, "");
  assert_non_null(own);
  unlink(path);
  const asp_material *ash = aspi_materials_find(own, "fly-ash", NULL);
  assert_near(ash->youngs_modulus, 5e10, 0);
  assert_near(ash->yield_stress, 1.5e8, 0);
  assert_near(aspi_materials_find(own, "quartz", NULL)->youngs_modulus, 7.2e10, 0);
  assert_near(aspi_materials_find(own, "quartz", NULL)->yield_stress, 0, 0);
  assert_ptr_equal(aspi_materials_find(own, "al-2024", NULL),
                   aspi_materials_find(NULL, "al-2024", NULL));
  assert_ptr_equal(aspi_materials_find(NULL, "ard", NULL), aspi_materials_find(NULL, "ard", NULL));
  assert_null(aspi_materials_find(own, "twin", &error));
  assert_says(error.text, "'twin' is there twice");
  assert_null(aspi_materials_find(own, "chalk", &error));
  assert_says(error.text, "fly-ash");
  assert_says(error.text, "hastelloy-x");
  aspi_materials_free(own);
}

TEST(bad_materials_are_named) {
  CHECK_ROWS("tables.txt", refuses_materials);
  asp_error error;
  assert_null(aspi_materials_read("/nowhere/materials.csv", &error));
  assert_int_equal(error.code, ASP_EFILE);
}
