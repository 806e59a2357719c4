/* Files are read with a decimal point in a program whose locale has a comma; locale.sh sets it.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "asperity_internal.h"
#include "rebound/cor_table.h"
#include "rebound/materials.h"
#include "readers/read.h"
#include "surface/heights.h"

#include <locale.h>
#include <stdlib.h>
#include <unistd.h>

static const char *file_of(const char *text) {
  static char path[] = "/tmp/test_locale.XXXXXX";
  strcpy(strchr(path, '.'), ".XXXXXX");
  int handle = mkstemp(path);
  assert_true(handle >= 0 && write(handle, text, strlen(text)) == (ssize_t)strlen(text));
  close(handle);
  return path;
}

static int set_locale(void **state) {
  (void)state;
  char half[8];
  snprintf(half, sizeof half, setlocale(LC_ALL, "") ? "%g" : "none", 0.5);
  return strcmp(half, "0,5");
}

TEST(profiles) {
  static const char *const files[] = {"x_um,z_um\n0.5,1.5\n1.0,2.5\n1.5,0.5\n",
                                      "x_um;z_um\n0,5;1,5\n1,0;2,5\n1,5;0,5\n",
                                      ("aISO-1.0\nNumPoints = 3\nNumProfiles = 1\nXscale = 0.5e-6\n"
                                       "Zscale = 1.0e-6\n*\n1.5 2.5\n0.5\n")};
  aspi_profile_options options = aspi_profile_options_default();
  options.form = -1;
  for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
    asp_error error;
    const char *path = file_of(files[i]);
    asp_heights *p = aspi_read(NULL, path, false, &options, NULL, &error);
    unlink(path);
    if (!p)
      fail_msg("%s", error.text);
    assert_near(p->step[0], 0.5e-6, 1e-15);
    assert_near(p->z[1], 2.5e-6, 1e-15);
    asp_heights_free(p);
  }
}

TEST(tables_and_materials) {
  double n, t;
  const char *path = file_of("alpha1_deg,cor_n,cor_t\n10.5,0.75,0.25\n80.5,0.75,0.25\n");
  aspi_cor_table *table = aspi_cor_table_read(path, 1, NULL);
  unlink(path);
  assert_non_null(table);
  aspi_cor_table_at(table, 1, 0.5, &n, &t);
  assert_near(n, 0.75, 1e-15);
  assert_near(t, 0.25, 1e-15);
  aspi_cor_table_free(table);
  path = file_of("name,youngs_modulus_pa,poissons_ratio,density_kg_m3\nchalk,1.5e10,0.25,2000.5\n");
  aspi_materials *own = aspi_materials_read(path, NULL);
  unlink(path);
  assert_non_null(own);
  assert_near(asp_material_get(aspi_materials_find(own, "chalk", NULL), "poissons_ratio"), 0.25, 0);
  assert_near(asp_material_get(aspi_materials_find(own, "chalk", NULL), "youngs_modulus"), 1.5e10,
              0);
  aspi_materials_free(own);
}

/* A number in a message is written as the reader of a script writes it. */
TEST(messages) {
  static const char *const all[][2] = {
      {"surface sigma 60.5", "sigma is 60.5; it must be 0.001 to 54"},
      {"rebound bons soften 800.5 0.001 temperature 800", "softening starts at 800.5 K"},
      {"surface rq 5.5um lambda_c 4.25um", "their ratio 1.29412 must"}};
  asp_error error;
  for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
    assert_null(asp_description_parse(all[i][0], NULL, &error));
    assert_says(error.text, all[i][1]);
  }
  const char *path = file_of("alpha1_deg,cor_n,cor_t\n95.5,0.75,0.25\n");
  assert_null(aspi_cor_table_read(path, 1, &error));
  unlink(path);
  assert_says(error.text, "alpha1_deg is 95.5");
  asp_description *d = asp_description_parse("surface rq 0.5 lambda_c 4", NULL, NULL);
  assert_int_equal(asp_description_set(d, "rq", -1.5, &error), ASP_EARG);
  assert_says(error.text, "rq is -1.5");
  const asp_particle largest = {.d_p = 1.25e-5};
  char text[500] = "";
  for (int i = 0; !*text && asp_warning(&(asp_check_input){d, NULL, 0, &largest, {NULL, NULL}, {0}},
                                        i, text, sizeof text);
       i++)
    ;
  assert_says(text, "rq is 0.5 m, 4e+04 times the diameter of the largest particle, 1.25e-05 m");
  asp_description_free(d);
}

/* The program's locale is still its own. */
TEST(nothing_is_left_behind) {
  assert_string_equal(localeconv()->decimal_point, ",");
  assert_near(strtod("0,5", NULL), 0.5, 0);
}

int main(void) {
  return run_listed_tests(set_locale, NULL);
}
