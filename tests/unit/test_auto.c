/* The choice of a model: the cheapest that is good enough, with its reason; and what it refuses.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "spread/models.h"

#include <stdio.h>
#include <stdlib.h>

typedef struct choice {
  const asp_spread_model *model;
  double divergence;
  char text[400];
} choice;

static asp_code choose(double r_q, double tolerance, choice *made, asp_error *error) {
  asp_surface *surface = asp_surface_create(r_q, 40, NULL);
  made->model = aspi_spread_auto(surface, 5, 15, true, tolerance, &made->divergence, made->text,
                                 sizeof made->text, error);
  asp_surface_free(surface);
  return made->model ? ASP_OK : error->code;
}

/* Below the tolerance, and the looser the tolerance, the cheaper: a model that is good enough for a
 * tighter one is for this one too. */
static void choices_keep_the_tolerance(void **state) {
  (void)state;
  choice made;
  asp_error error = {ASP_OK, ""};
  int chosen = 0, cheaper = 0;
  for (double r_q = 0.1; r_q < 20; r_q *= 1.5) {
    int last = 0;
    for (double tolerance = 20; tolerance > 0.002; tolerance /= 2)
      if (choose(r_q, tolerance, &made, &error) == ASP_OK) {
        assert_true(made.divergence < tolerance);
        assert_non_null(strstr(made.text, made.model->name));
        assert_non_null(strstr(made.text, "cheapest"));
        assert_non_null(strstr(made.text, "in the plane of incidence"));
        assert_true(made.model->cost >= last);
        cheaper += chosen > 0 && made.model->cost > last;
        last = made.model->cost;
        chosen++;
      } else {
        assert_int_equal(error.code, ASP_ERANGE);
      }
  }
  assert_true(chosen > 50 && cheaper > 10);
  assert_int_equal(choose(5, 20, &made, &error), ASP_OK);
  assert_string_equal(made.model->name, "none");
}

/* The divergence that counts is a measured one and twice its standard error. */
static void choices_count_the_standard_error(void **state) {
  (void)state;
  choice made;
  char line[400];
  int found = 0;
  assert_int_equal(choose(5, 0.5, &made, NULL), ASP_OK);
  FILE *table = fopen(getenv("ASPERITY_TEST_TABLE"), "r");
  assert_non_null(table);
  while (fgets(line, sizeof line, table)) {
    char *at = strchr(line, ',');
    if (!at || strncmp(line, made.model->name, (size_t)(at - line)) != 0)
      continue;
    double values[20]; /* phi_r, kappa; of each angle the divergence and its error */
    at = strchr(at + 1, ',');
    for (int k = 0; k < 20; k++)
      values[k] = strtod(at + 1, &at);
    for (int k = 2; k < 20; k += 2) {
      assert_true(values[k + 1] > 0);
      found += fabs((values[k] + 2 * values[k + 1]) / made.divergence - 1) < 1e-6;
    }
  }
  fclose(table);
  assert_true(found > 0);
}

static void hopeless_tolerances_name_the_closest(void **state) {
  (void)state;
  choice made;
  asp_error error;
  assert_int_equal(choose(5, 1e-9, &made, &error), ASP_ERANGE);
  assert_non_null(strstr(error.text, "comes closest"));
  assert_non_null(strstr(error.text, "1e-09"));
}

static void bad_arguments_are_named(void **state) {
  (void)state;
  static const double bad[] = {0, -1, NAN, INFINITY};
  choice made;
  asp_error error;
  for (int i = 0; i < 4; i++) {
    assert_int_equal(choose(5, bad[i], &made, &error), ASP_EARG);
    assert_non_null(strstr(error.text, "tolerance"));
  }
  assert_int_equal(choose(36, 0.1, &made, &error), ASP_ERANGE);
  assert_non_null(strstr(error.text, "beyond what was measured"));
}

/* The order of cost has each model in one place. */
static void costs_are_an_order(void **state) {
  (void)state;
  int count = asp_spread_count();
  for (int cost = 0; cost < count; cost++) {
    int there = 0;
    for (int i = 0; i < count; i++)
      there += asp_spread_at(i)->cost == cost;
    assert_int_equal(there, 1);
  }
  assert_int_equal(asp_spread_find("none", NULL)->cost, 0);
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(choices_keep_the_tolerance),
      cmocka_unit_test(choices_count_the_standard_error),
      cmocka_unit_test(costs_are_an_order),
      cmocka_unit_test(hopeless_tolerances_name_the_closest),
      cmocka_unit_test(bad_arguments_are_named),
  };
  return cmocka_run_group_tests(tests, NULL, NULL);
}
