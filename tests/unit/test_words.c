/* No word of a wall's text is without effect: each of them, put into a text or given another value,
 * changes an impact, what takes a deposit away, the length of a face or the random numbers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "description/description.h"

#include <stdlib.h>

static char sought[80];
static bool found;

static void compare(char *row[]) {
  found |= strcmp(row[0], sought) == 0;
}

static bool has_row(const char *within, const char *name) {
  snprintf(sought, sizeof sought, "%s%s%s", within, *within ? " " : "", name);
  found = false;
  each_row("words.txt", "every_word", compare);
  if (!found)
    print_error("'%s' has no row\n", sought);
  return found;
}

TEST(every_word_has_a_row) {
  bool all = true;
  for (const aspi_keyword *k = aspi_keywords; k->name; k++)
    all &= has_row(k->within, k->name);
  for (int i = 0; i < asp_rebound_count(); i++)
    for (int p = 0; p < asp_rebound_at(i)->n_parameters; p++)
      all &= has_row(asp_rebound_at(i)->name, asp_rebound_at(i)->parameters[p].name);
  for (int i = 0; i < aspi_erosion_count(); i++)
    for (int p = 0; p < aspi_erosion_at(i)->n_parameters; p++)
      all &= has_row(aspi_erosion_at(i)->name, aspi_erosion_at(i)->parameters[p].name);
  assert_true(all);
}

/* What a wall does: a program that knows its text alone sees no more of it. */
static double deeds(const char *text) {
  enum { TAGS = 60 };
  asp_error error;
  asp_wall *wall = asp_wall_from_text(text, 10e-6, 40e-6, &error);
  if (!wall)
    fail_msg("%s: %s", text, error.text);
  const double n[3] = {0, 0, 1}, along[3] = {1, 0, 0};
  double sum = 0;
  for (uint32_t tag = 1; tag <= TAGS; tag++) {
    const double angle = 1.5 * tag * ASP_PI / 180, speed = tag % 2 ? 20 : 0.5;
    const double v1[3] = {speed * cos(angle), 0.3 * speed * cos(angle), -speed * sin(angle)};
    asp_particle grain = {.d_p = 20e-6, .density = 2650, .omega = {0, 1000, 0}};
    asp_key key = {asp_wall_seed(wall), 5, tag, 1, 0};
    asp_impact impact;
    assert_int_equal(asp_wall_impact(wall, &grain, v1, n, &key, &impact), ASP_OK);
    for (int i = 0; i < 3; i++)
      sum += tag * (impact.v2[i] + 1e-5 * impact.omega[i]);
    sum += 1e6 * impact.eroded + asp_wall_removal(wall, &grain, &key).rate;
    sum += 1e6 * asp_wall_face_length(wall, &grain, along, n);
    sum += key.seed;
  }
  asp_wall_free(wall);
  return sum;
}

static void acts(char *row[]) {
  if (!(fabs(deeds(row[1]) - deeds(row[2])) > 1e-9))
    fail_msg("'%s' changes nothing: %s", row[0], row[1]);
}

TEST(every_word_acts) {
  each_row("words.txt", "every_word", acts);
}

#define ROUGH "materials quartz 304-ss surface rq 3um lambda_c 30um 90um lay "

/* What the command cannot know either: with an angle, the lay counts from x toward y. */
TEST(a_lay_is_that_of_the_particle) {
  const double n[3] = {0, 0, 1}, v1[3] = {3, 0, -1}, lay[3] = {cos(0.5), sin(0.5), 0};
  asp_wall *by_angle = asp_wall_from_text(ROUGH "28.6478897565412", 0, 0, NULL),
           *by_particle = asp_wall_from_text(ROUGH "0 1 0", 0, 0, NULL);
  asp_particle grain = {.d_p = 20e-6, .density = 2650}, laid = grain;
  laid.lay = lay;
  for (uint32_t tag = 1; tag < 50; tag++) {
    const asp_key key = {1, 1, tag, 1, 0};
    asp_impact a, b;
    asp_wall_impact(by_angle, &grain, v1, n, &key, &a);
    asp_wall_impact(by_particle, &laid, v1, n, &key, &b);
    for (int i = 0; i < 3; i++)
      assert_near(a.v2[i], b.v2[i], 1e-9);
  }
  asp_wall_free(by_angle);
  asp_wall_free(by_particle);
}

static void write_file(const char *name, const char *heading, int columns, int rows_of) {
  FILE *file = fopen(name, "w");
  assert_non_null(file);
  fputs(heading, file);
  for (int j = 0; j < rows_of; j++)
    for (int i = 0; i < columns; i++) {
      double z = sin(0.35 * i) + sin(0.8 * i + 1) + cos(0.45 * j) + sin(0.9 * j);
      if (rows_of > 1)
        fprintf(file, "%.6f%c", z, i + 1 < columns ? ' ' : '\n');
      else
        fprintf(file, "%d,%.6f\n", i, z);
    }
  fclose(file);
}

static int write_files(void **state) {
  (void)state;
  write_file("words.csv", "x_um,z_um\n", 3000, 1);
  write_file("words.txt", "# Width: 200 um\n# Height: 200 um\n# Value units: um\n", 200, 200);
  FILE *file = fopen("words_materials.csv", "w");
  fputs("name,title,youngs_modulus_pa,poissons_ratio,density_kg_m3,yield_stress_pa,source\n"
        "quartz,\"soft quartz\",5e9,0.2,2650,1e8,\"mine\"\n",
        file);
  return fclose(file);
}

int main(void) {
  return run_listed_tests(write_files, NULL);
}
