/* No word of a wall's text is without effect: each of them, put into a text or given another value,
 * changes an impact, what takes a deposit away, the length of a face or the random numbers.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "description/description.h"

#include <stdlib.h>

#define PAIR " materials quartz 304-ss"
#define ROUGH "surface rq 3um lambda_c 30um"
#define STICKY " materials quartz 304-ss deposit freeze"
#define FLOW STICKY " remove u_tau 1 gas_density 1.2 gas_viscosity 1.5e-5"
#define WORN ROUGH " rebound constant 0.8 0.9 erosion "
#define HOT "rebound bons temperature 1200"
#define HOTTER "rebound bons temperature 1400"
#define OKA WORN "oka 1.8GPa density 2700"

/* A word by what it is within, and its name; a text with it, and one without or with another value.
 */
static const struct {
  const char *word, *with, *without;
} rows[] = {
    {" surface", "surface sigma 5" PAIR, PAIR},
    {"surface smooth", "surface smooth" PAIR, "surface sigma 5" PAIR},
    {"surface sigma", "surface sigma 5" PAIR, "surface sigma 6" PAIR},
    {"surface rq", ROUGH PAIR, "surface rq 2um lambda_c 30um" PAIR},
    {"surface ra", "surface ra 3um lambda_c 30um" PAIR, "surface ra 2um lambda_c 30um" PAIR},
    {"surface sq", "surface sq 3um lambda_c 30um" PAIR, "surface sq 2um lambda_c 30um" PAIR},
    {"surface lambda_c", ROUGH PAIR, "surface rq 3um lambda_c 31um" PAIR},
    {"surface lambda_c", "surface sigma 5 lambda_c 50um" PAIR, "surface sigma 5" PAIR},
    {"surface rdq", "surface rq 3um rdq 0.1" PAIR, "surface rq 3um rdq 0.2" PAIR},
    {"surface rsm", "surface rq 3um rsm 100um sampling 0.8mm" PAIR,
     "surface rq 3um rsm 120um sampling 0.8mm" PAIR},
    {"surface sampling", "surface rq 3um rsm 100um sampling 0.8mm" PAIR,
     "surface rq 3um rsm 100um sampling 0.25mm" PAIR},
    {"surface sdq", "surface sq 3um sdq 0.1" PAIR, "surface sq 3um sdq 0.2" PAIR},
    {"surface sal", "surface sq 3um sal 30um" PAIR, "surface sq 3um sal 20um" PAIR},
    {"surface profile", "surface profile words.csv" PAIR, PAIR},
    {"surface map", "surface map words.txt" PAIR, PAIR},
    {"surface dp_bins", "surface profile words.csv dp_bins 3" PAIR,
     "surface profile words.csv" PAIR},
    {"surface lay", ROUGH " 90um lay 1 0 0" PAIR, ROUGH " 90um lay 0 1 0" PAIR},
    {"surface lay", ROUGH " 90um lay 1 2 0" PAIR, ROUGH " 90um lay -1 2 0" PAIR},
    {"surface lay", ROUGH " 90um lay 30" PAIR, ROUGH " 90um lay 60" PAIR},
    {"surface lay", ROUGH " 90um lay axial" PAIR, ROUGH " 90um lay circumferential" PAIR},
    {" spread", ROUGH " spread weibull" PAIR, ROUGH PAIR},
    {"spread plane", ROUGH " spread visible plane" PAIR, ROUGH PAIR},
    {"spread isotropic", ROUGH " spread visible isotropic" PAIR,
     ROUGH " spread visible plane" PAIR},
    {"spread collisions", ROUGH " spread weibull collisions single" PAIR,
     ROUGH " spread weibull collisions multiple" PAIR},
    {" rebound", "rebound constant 0.5 0.5", "rebound walton 0.5 0.1 0"},
    {"rebound scatter", "rebound bons yield_rate 1e7 scatter 0.2" PAIR,
     "rebound bons yield_rate 1e7" PAIR},
    {" materials", "materials quartz 304-ss", "materials quartz al-2024"},
    {"materials file", "materials quartz 304-ss file words_materials.csv",
     "materials quartz 304-ss"},
    {" friction", "friction 0.1" PAIR, PAIR},
    {" surface_energy", "surface_energy 0.1" PAIR, PAIR},
    {" adhesion", "adhesion 0.1" PAIR, PAIR},
    {"adhesion adhesion_spread", "adhesion 0.1 adhesion_spread 2" PAIR, "adhesion 0.1" PAIR},
    {" yield_stress", "yield_stress 1e8" PAIR, PAIR},
    {"yield_stress scatter", "yield_stress 1e8 scatter 0.3" PAIR, "yield_stress 1e8" PAIR},
    {" deposit", "deposit off" PAIR, PAIR},
    {"deposit remove", FLOW, STICKY},
    {"remove u_tau", STICKY " remove u_tau 2 gas_density 1.2 gas_viscosity 1.5e-5", FLOW},
    {"remove gas_density", STICKY " remove u_tau 1 gas_density 2 gas_viscosity 1.5e-5", FLOW},
    {"remove gas_viscosity", STICKY " remove u_tau 1 gas_density 1.2 gas_viscosity 2e-5", FLOW},
    {" grain", "grain lever 0.1" PAIR, PAIR},
    {"grain sphere", "grain sphere" PAIR, "grain lever 0.1" PAIR},
    {"grain lever", "grain lever 0.1" PAIR, "grain lever 0.2" PAIR},
    {" erosion", WORN "dnv density 7800", ROUGH " rebound constant 0.8 0.9"},
    {"erosion density", OKA, WORN "oka 1.8GPa density 7800"},
    {"erosion face", OKA " face tilted", OKA},
    {" seed", "seed 2" PAIR, "seed 1" PAIR},
    {"bons yield_rate", "rebound bons yield_rate 1e7" PAIR, PAIR},
    {"bons a", "rebound bons contact_area 0.2 0.1 0.5" PAIR,
     "rebound bons contact_area 0.1 0.1 0.5" PAIR},
    {"bons b", "rebound bons contact_area 0.1 0.2 0.5" PAIR,
     "rebound bons contact_area 0.1 0.1 0.5" PAIR},
    {"bons c", "rebound bons contact_area 0.1 0.1 1" PAIR,
     "rebound bons contact_area 0.1 0.1 0.5" PAIR},
    {"rebound temperature", "rebound bons temperature 1200" PAIR, PAIR},
    {"rebound soften_modulus", HOT " soften_modulus exp 100GPa 1e-3 wall_temperature 1000" PAIR,
     HOT PAIR},
    {"soften_modulus wall_temperature",
     HOT " soften_modulus exp 100GPa 1e-3 wall_temperature 900" PAIR,
     HOT " soften_modulus exp 100GPa 1e-3 wall_temperature 1000" PAIR},
    {"deposit viscosity", HOTTER PAIR " deposit freeze viscosity critical 1e4 vft -4.5 9000 500",
     HOTTER PAIR},
    {"viscosity critical", HOTTER PAIR " deposit freeze viscosity critical 1e4 vft -4.5 9000 500",
     HOTTER PAIR " deposit freeze viscosity critical 1e5 vft -4.5 9000 500"},
    {"bons soften_from", "rebound bons temperature 1200 soften 1100 0.001" PAIR,
     "rebound bons temperature 1200 soften 1000 0.001" PAIR},
    {"bons soften_rate", "rebound bons temperature 1200 soften 1000 0.002" PAIR,
     "rebound bons temperature 1200 soften 1000 0.001" PAIR},
    {"bons spin", "rebound bons spin on" PAIR, PAIR},
    {"thornton_ning pressure_ratio", "rebound thornton_ning pressure_ratio 2" PAIR,
     "rebound thornton_ning" PAIR},
    {"walton e", "rebound walton 0.8 0.3 0", "rebound walton 0.9 0.3 0"},
    {"walton mu", "rebound walton 0.9 0.1 0", "rebound walton 0.9 0.3 0"},
    {"walton beta0", "rebound walton 0.9 0.3 0.5", "rebound walton 0.9 0.3 0"},
    {"walton compliance", "rebound walton 0.9 0.3 0.5 compliance 0.4",
     "rebound walton 0.9 0.3 0.5 compliance 1"},
    {"constant cor_n", "rebound constant 0.5 0.5", "rebound constant 0.6 0.5"},
    {"constant cor_t", "rebound constant 0.5 0.5", "rebound constant 0.5 0.6"},
    {"grant_tabakoff scatter", "rebound grant_tabakoff scatter 0.5", "rebound grant_tabakoff"},
    {"dnv k", WORN "dnv k 3e-9 density 7800", WORN "dnv density 7800"},
    {"dnv n", WORN "dnv n 2 density 7800", WORN "dnv density 7800"},
    {"ecrc brinell", WORN "ecrc 200 density 7800", WORN "ecrc 120 density 7800"},
    {"ecrc grains", WORN "ecrc 120 grains round density 7800", WORN "ecrc 120 density 7800"},
    {"ecrc c", WORN "ecrc 120 c 1e-7 density 7800", WORN "ecrc 120 density 7800"},
    {"ecrc n", WORN "ecrc 120 n 2 density 7800", WORN "ecrc 120 density 7800"},
    {"finnie flow_stress", WORN "finnie 1GPa density 7800", WORN "finnie 2GPa density 7800"},
    {"finnie psi", WORN "finnie 1GPa psi 3 density 7800", WORN "finnie 1GPa density 7800"},
    {"finnie k", WORN "finnie 1GPa k 3 density 7800", WORN "finnie 1GPa density 7800"},
    {"finnie share", WORN "finnie 1GPa share 0.1 density 7800", WORN "finnie 1GPa density 7800"},
    {"oka hardness", OKA, WORN "oka 2.8GPa density 2700"},
    {"oka particles", WORN "oka 1.8GPa particles glass density 2700", OKA},
    {"oka wall", WORN "oka 1.8GPa wall aluminum density 2700", OKA},
    {"oka a", WORN "oka 1.8GPa a_b 2 0.5 density 2700", WORN "oka 1.8GPa a_b 3 0.5 density 2700"},
    {"oka b", WORN "oka 1.8GPa a_b 2 0.5 density 2700", WORN "oka 1.8GPa a_b 2 0.7 density 2700"},
    {"oka k", WORN "oka 1.8GPa k 50 density 2700", OKA},
    {"oka k1", WORN "oka 1.8GPa k1 -0.2 density 2700", OKA},
    {"oka k2", WORN "oka 1.8GPa k2 2 density 2700", OKA},
    {"oka k3", WORN "oka 1.8GPa k3 0.5 density 2700", OKA},
    {"oka speed", WORN "oka 1.8GPa speed 50 density 2700", OKA},
    {"oka diameter", WORN "oka 1.8GPa diameter 100um density 2700", OKA},
    {"oka n1", WORN "oka 1.8GPa n1 1 density 2700", OKA},
    {"oka n2", WORN "oka 1.8GPa n2 1 density 2700", OKA},
};
enum { ROWS = sizeof rows / sizeof *rows };

static bool has_row(const char *within, const char *name) {
  char word[80];
  snprintf(word, sizeof word, "%s %s", within, name);
  for (int i = 0; i < ROWS; i++)
    if (strcmp(rows[i].word, word) == 0)
      return true;
  print_error("'%s' has no row\n", word);
  return false;
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

TEST(every_word_acts) {
  int idle = 0;
  for (int i = 0; i < ROWS; i++)
    if (!(fabs(deeds(rows[i].with) - deeds(rows[i].without)) > 1e-9)) {
      print_error("'%s' changes nothing: %s\n", rows[i].word, rows[i].with);
      idle++;
    }
  assert_int_equal(idle, 0);
}

/* What the command cannot know either: with an angle, the lay counts from x toward y. */
TEST(a_lay_is_that_of_the_particle) {
  const double n[3] = {0, 0, 1}, v1[3] = {3, 0, -1}, lay[3] = {cos(0.5), sin(0.5), 0};
  asp_wall *by_angle = asp_wall_from_text(ROUGH " 90um lay 28.6478897565412" PAIR, 0, 0, NULL),
           *by_particle = asp_wall_from_text(ROUGH " 90um lay 0 1 0" PAIR, 0, 0, NULL);
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
