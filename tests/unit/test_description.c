/* The description of a wall: what its words mean, that its canonical text means the same, what is
 * refused and how, and which constants are doubted.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "check.h"
#include "description/description.h"
#include "surface/heights.h"

#include <stdlib.h>

static const asp_units si = {"SI", 1, 1, 1, {0}}, micro = {"'units micro'", 1e6, 1e15, 1e6, {0}},
                       lj = {"'units lj'; units must be si", 0, 0, 0, {0}};

static asp_description *parse(const char *text, const asp_units *units) {
  asp_error error = {.code = ASP_OK};
  asp_description *d = asp_description_parse(text, units, &error);
  if (!d)
    fail_msg("%s\n%s", text, error.text);
  return d;
}

/* Text: canonical one. */
static void check_text(char *row[]) {
  char is[1000];
  asp_description *wall = parse(row[0], &si);
  assert_int_equal(asp_description_text(wall, is, sizeof is), strlen(row[1]));
  assert_string_equal(is, row[1]);
  asp_description_free(wall);
}

TEST(canonical_texts) {
  CHECK_ROWS("descriptions.txt", check_text);
}

/* Words: rq and lambda_c that they become. */
static void check_instrument(char *row[]) {
  char words[100], text[300], *end;
  snprintf(words, sizeof words, "surface %s", row[0]);
  asp_description *d = parse(words, &si);
  asp_description_text(d, text, sizeof text);
  assert_memory_equal(text, "surface rq ", 11);
  double r_q = strtod(text + 11, &end), lambda_c = atof(row[2]);
  assert_memory_equal(end, " lambda_c ", 10);
  assert_near(r_q, atof(row[1]), 1e-12 * r_q);
  assert_near(strtod(end + 10, NULL), lambda_c, 1e-5 * lambda_c);
  asp_description_free(d);
}

/* What instruments print becomes rq and lambda_c, by closed forms; R_Sm by its table. */
TEST(instruments_are_understood) {
  CHECK_ROWS("descriptions.txt", check_instrument);
  asp_description *d = parse("surface ra 4 rdq 0.2", &micro);
  assert_near(asp_description_get(d, "rq"), 5.013256549262001, 1e-12);
  asp_description_free(d);
}

/* A text that does not fit is cut, and its length returned. */
TEST(short_room) {
  char text[12];
  asp_description *wall = parse("", &si);
  size_t length = asp_description_text(wall, NULL, 0);
  assert_int_equal(length, strlen("surface smooth rebound bons deposit freeze seed 1"));
  assert_int_equal(asp_description_text(wall, text, sizeof text), length);
  assert_string_equal(text, "surface smo");
  asp_description_free(wall);
}

/* ---- random descriptions ---- */

static double uniform(void) {
  return rand() / (RAND_MAX + 1.0);
}

static int whole(int below) {
  return (int)(uniform() * below);
}

static void add(char *text, const char *format, ...) {
  va_list args;
  va_start(args, format);
  vsnprintf(text + strlen(text), 1500 - strlen(text), format, args);
  va_end(args);
}

/* Any number within a range, and now and then its ends. */
static double within(double least, double most) {
  double to = most < 1e6 ? most : least + 1e6;
  return whole(8) == 0 ? least : least + (to - least) * uniform() * uniform();
}

static void add_surface(char *text, bool *rough, bool *measured) {
  int kind = whole(6);
  *rough = kind > 0;
  *measured = kind > 3;
  add(text, " surface ");
  if (kind == 0)
    add(text, "smooth");
  else if (kind == 1)
    add(text, "sigma %.17g", within(0.001, 54));
  else if (kind == 2 && whole(2))
    add(text, whole(2) ? "ra %.17gum rdq %.17gdeg" : "sq %.17gum sdq %.17gdeg", 1e-3 + uniform(),
        1 + 30 * uniform());
  else if (kind == 2)
    add(text, "rq %.17gum lambda_c %.3gmm", 1e-3 + uniform(), 0.01 + uniform());
  else if (kind == 3)
    add(text, "rq %.17g lambda_c 1 %.17g lay %s", 1e-3 + 0.2 * uniform(), 1 + uniform(),
        whole(2) ? "circumferential" : "-33.3deg");
  else if (kind == 4)
    add(text, "profile %s", whole(2) ? "a.csv" : "\"in a 'folder'/\"\"a\"\".csv\"");
  else
    add(text, "map \"x y.sdf\" lay %.17g %.17g 0", uniform(), 1 + uniform());
}

static const asp_rebound_law *add_law(char *text) {
  const asp_rebound_law *law;
  do
    law = asp_rebound_at(whole(asp_rebound_count()));
  while (law->needs_table); /* it would need a file */
  add(text, " rebound %s", asp_rebound_name(law));
  const char *last = "";
  bool on = true;
  for (int i = 0; i < law->n_parameters; i++) {
    const aspi_keyword *p = &law->parameters[i];
    const char *keyword = aspi_keyword_word(p);
    if (strcmp(keyword, last) != 0) {
      on = whole(2);
      if (on)
        add(text, " %s", keyword);
    }
    last = keyword;
    if (p->values && on)
      add(text, whole(2) ? " on" : " off");
    else if (on) /* hot enough to be soft */
      add(text, " %.17g", within(p->least, strcmp(p->name, "soften_from") == 0 ? 2000 : p->most));
  }
  const bool softens = asp_rebound_needs_pair(law) && whole(2);
  if (softens)
    add(text, " soften_modulus exp %.17gPa %.17g wall_temperature %.17g", 1e20 * (1 + uniform()),
        uniform(), 500 + uniform());
  if ((softens || law->softening) && whole(2))
    add(text, " temperature %.17g", 2000 + uniform());
  return law;
}

static void add_rest(char *text, const asp_rebound_law *law, bool by_rate) {
  bool off = whole(3) == 0, pair = asp_rebound_needs_pair(law);
  if (pair && whole(2))
    add(text, " materials quartz %s", whole(2) ? "steel" : "304-ss");
  if (aspi_rebound_parameter_find(law, "mu") < 0 && whole(2)) /* not a law with one of its own */
    add(text, " friction %.17g", uniform());
  if (pair && !off && whole(2))
    add(text, " surface_energy %.17g", uniform());
  if (pair && !by_rate && whole(2))
    add(text, " yield_stress %.17gMPa", 1000 * uniform());
  const bool freezes = !off && whole(2);
  add(text, " deposit %s", off ? "off" : freezes ? "freeze" : "delete");
  if (!off && whole(2))
    add(text, " viscosity critical %.17g watt 60 20 %.17g 8 4", 1 + uniform(), 8 * uniform() + 4);
  if (pair && freezes && whole(2))
    add(text, " remove gas_density %.17g gas_viscosity 1 u_tau %.17g", 0.1 + uniform(),
        0.1 + uniform());
  if (whole(2))
    add(text, " seed %d", rand());
}

static void random_text(char *text) {
  bool rough, measured;
  *text = '\0';
  add_surface(text, &rough, &measured);
  if (rough && whole(2)) {
    const char *model = asp_spread_name(asp_spread_at(1 + whole(asp_spread_count() - 1)));
    add(text, " spread %s", measured && strcmp(model, "profile") == 0 ? "traced" : model);
    add(text, "%s%s", whole(2) ? " plane" : "", whole(2) ? " collisions single" : "");
  }
  const asp_rebound_law *law = add_law(text);
  add_rest(text, law, strstr(text, "yield_rate"));
}

static void check_same(const asp_description *x, const asp_description *y) {
  const aspi_wall_choice *a = &x->choice, *b = &y->choice;
  assert_ptr_equal(a->spread, b->spread);
  assert_ptr_equal(a->law, b->law);
  assert_int_equal(a->isotropic, b->isotropic);
  assert_int_equal(a->multiple, b->multiple);
  assert_int_equal(a->deposit, b->deposit);
  assert_memory_equal(a->parameters, b->parameters, sizeof a->parameters);
  assert_memory_equal(&a->flow, &b->flow, sizeof a->flow);
  assert_ptr_equal(a->heat.viscosity.form, b->heat.viscosity.form);
  assert_memory_equal(a->heat.viscosity.parameters, b->heat.viscosity.parameters,
                      5 * sizeof(double));
  assert_memory_equal(a->heat.modulus.parameters, b->heat.modulus.parameters, 5 * sizeof(double));
  assert_memory_equal(&a->heat.critical, &b->heat.critical, 3 * sizeof(double));
  assert_int_equal(x->kind, y->kind);
  assert_int_equal(x->lay, y->lay);
  assert_memory_equal(&x->friction, &y->friction, 3 * sizeof x->friction);
  assert_memory_equal(&x->sigma, &y->sigma, sizeof x->sigma); /* these may be NaN */
  assert_memory_equal(&x->r_q, &y->r_q, 3 * sizeof x->r_q);
  assert_true(fabs(x->seed - y->seed) <= 0);
  asp_lay lay_x = asp_description_lay(x), lay_y = asp_description_lay(y);
  assert_memory_equal(lay_x.vector, lay_y.vector, sizeof lay_x.vector);
  assert_true(fabs(lay_x.angle - lay_y.angle) <= 0);
  assert_int_equal(x->n_materials, y->n_materials);
  for (int i = 0; i < x->n_materials; i++)
    assert_string_equal(x->names[i], y->names[i]);
  assert_true(!x->file == !y->file && (!x->file || strcmp(x->file, y->file) == 0));
}

TEST(texts_go_round) {
  char text[1500], first[1500], second[1500];
  srand(1);
  for (int i = 0; i < 3000; i++) {
    const asp_units *units = i % 2 ? &si : &micro;
    random_text(text);
    asp_description *a = parse(text, units);
    assert_true(asp_description_text(a, first, sizeof first) < sizeof first);
    asp_description *b = parse(first, units);
    asp_description_text(b, second, sizeof second);
    assert_string_equal(first, second);
    check_same(a, b);
    asp_description_free(a);
    asp_description_free(b);
  }
}

/* ---- what is refused ---- */

/* Text: two things that the message says. */
static void check_refused(asp_description *wall, const asp_error *error, char *row[]) {
  if (wall)
    fail_msg("%s: accepted", row[0]);
  assert_int_not_equal(error->code, ASP_OK);
  assert_says(error->text, row[1]);
  assert_says(error->text, row[2]);
}

static void refuses(char *row[]) {
  asp_error error = {.code = ASP_OK};
  check_refused(asp_description_parse(row[0], &si, &error), &error, row);
}

TEST(slips_are_named) {
  CHECK_ROWS("descriptions.txt", refuses);
}

TEST(misplaced_words_are_sent_home) {
  CHECK_ROWS("descriptions.txt", refuses);
}

/* Each names the thing, its value and what it must be. */
TEST(heat_is_refused) {
  CHECK_ROWS("descriptions.txt", refuses);
}

TEST(words_are_given_once) {
  CHECK_ROWS("descriptions.txt", refuses);
}

TEST(bad_values_are_named) {
  CHECK_ROWS("descriptions.txt", refuses);
}

TEST(what_has_no_effect_is_refused) {
  CHECK_ROWS("descriptions.txt", refuses);
}

/* ---- units ---- */

/* A unit of its own, and the caller's: the same wall; what is in SI alone needs units. */
TEST(units_are_converted) {
  asp_description *a =
      parse("surface rq 5um lambda_c 40um yield_stress 200MPa surface_energy 0.8J/m2 "
            "materials quartz steel deposit freeze remove u_tau 2m/s gas_density 1kg/m3 "
            "gas_viscosity 15mm2/s",
            &micro);
  assert_near(a->r_q, 5, 0);
  assert_near(a->yield_stress, 2e5, 1e-9);
  assert_near(a->surface_energy, 800, 1e-12);
  assert_near(asp_description_get(a, "u_tau"), 2, 0);
  assert_near(asp_description_get(a, "gas_density"), 1e-3, 1e-18);
  assert_near(asp_description_get(a, "gas_viscosity"), 15, 1e-12);
  assert_near(asp_material_get(asp_description_material(a, 0), "youngs_modulus"), 70e6, 1e-6);
  asp_description_free(a);
  a = parse("surface rq 15.6um lambda_c 0.12mm", NULL);
  assert_near(a->r_q, 15.6e-6, 0); /* to the last bit */
  assert_near(a->lambda_c, 120e-6, 0);
  asp_description_free(a);
  asp_error error;
  assert_null(asp_description_parse("surface rq 5um lambda_c 1", &lj, &error));
  assert_says(error.text, "'units lj'");
  assert_null(asp_description_parse("materials quartz steel", &lj, &error));
  assert_says(error.text, "'units lj'; units must be si");
  a = parse("surface rq 0.5 lambda_c 4 rebound constant 1 1", &lj);
  asp_description_free(a);
}

/* A caller's own words end a list of materials, and are left to him. */
TEST(own_words_are_left) {
  static const char *const words[] = {"materials", "quartz", "steel", "ledger", "10"},
                           *const slip[] = {"leger", "10"};
  asp_error error;
  int taken;
  asp_description *wall = parse("", &si);
  assert_int_equal(asp_description_read(wall, 5, words, "ledger map", &taken, &error), ASP_OK);
  assert_int_equal(taken, 3);
  assert_int_equal(asp_description_read(wall, 2, words + 3, "ledger map", &taken, &error), ASP_OK);
  assert_int_equal(taken, 0);
  assert_int_equal(asp_description_read(wall, 2, slip, "ledger map", &taken, &error), ASP_ENAME);
  assert_says(error.text, "did you mean 'ledger'?");
  asp_description_free(wall);
}

/* ---- what is made of it ---- */

/* sigma is that of any particle, and so is the tilt. */
TEST(sigma_knows_no_size) {
  asp_description *description = parse("surface sigma 8 rebound constant 1 1", &micro);
  asp_wall *wall = asp_wall_create(description, 0, 0, NULL);
  assert_non_null(wall);
  for (double d = 1e-3; d < 1e5; d *= 10)
    assert_near(atan(asp_surface_slope(asp_wall_surface(wall), d)), 8 * ASP_PI / 180, 1e-12);
  asp_wall_free(wall);
  asp_description_free(description);
}

/* Defaults of a pair: those of the library are those of the fix. */
TEST(pairs_have_defaults) {
  asp_description *wall = parse("materials quartz hastelloy-x", &micro);
  const asp_material *p = asp_description_material(wall, 0), *w = asp_description_material(wall, 1);
  asp_pair *pair = asp_description_pair(wall, p, w, NULL);
  assert_near(asp_pair_get(pair, "surface_energy"), 800, 1e-12);
  assert_near(asp_pair_get(pair, "friction"), 0.3, 0);
  assert_near(asp_pair_get(pair, "yield_stress"), 2e5, 1e-9);
  asp_pair_free(pair);
  asp_description_free(wall);
  pair = asp_pair_create(aspi_materials_find(NULL, "quartz", NULL),
                         aspi_materials_find(NULL, "steel", NULL), NULL);
  assert_near(asp_pair_get(pair, "surface_energy"), ASP_SURFACE_ENERGY, 0);
  asp_pair_free(pair);
  wall = parse("materials quartz steel friction 0.4 surface_energy 0.1 yield_stress 1e8", &si);
  pair = asp_description_pair(wall, asp_description_material(wall, 0),
                              asp_description_material(wall, 1), NULL);
  assert_near(asp_pair_get(pair, "surface_energy"), 0.1, 0);
  assert_near(asp_pair_get(pair, "friction"), 0.4, 0);
  assert_near(asp_pair_get(pair, "yield_stress"), 1e8, 0);
  asp_pair_free(pair);
  asp_description_free(wall);
}

/* All doubts in one text, a line each. */
static void ask(char text[1500], const asp_check_input *input) {
  char one[480];
  *text = '\0';
  for (int i = 0; asp_warning(input, i, one, sizeof one); i++)
    if (*one)
      add(text, "%s\n", one);
}

/* Description, diameter (m), density and modulus (GPa) of quartz on steel, and what is said; '-'
 * before what is not. */
static void check_doubts(char *row[]) {
  asp_description *wall = parse(row[0], &si);
  const double modulus = atof(row[3]) * 1e9;
  char text[1500];
  asp_material *p = asp_material_create("sand", NULL), *w = asp_material_create("iron", NULL);
  asp_material_set(p, "youngs_modulus", modulus, NULL);
  asp_material_set(w, "youngs_modulus", modulus, NULL);
  asp_material_set(p, "density", 2650, NULL);
  asp_material_set(p, "yield_stress", 200e6, NULL);
  asp_pair *pair = asp_description_pair(wall, p, w, NULL);
  asp_particle particle = {.d_p = atof(row[1]), .density = atof(row[2]), .pair = pair};
  ask(text, &(asp_check_input){wall, NULL, 0, &particle, {p, w}, {0}});
  const char *says = row[4] + (*row[4] == '-');
  if (!*says)
    assert_string_equal(text, "");
  else if (says == row[4])
    assert_says(text, says);
  else if (strstr(text, says))
    fail_msg("%s: %s", row[0], text);
  assert_ptr_equal(strchr(text, '\n'), strrchr(text, '\n')); /* not two lines */
  asp_pair_free(pair);
  asp_material_free(p);
  asp_material_free(w);
  asp_description_free(wall);
}

TEST(odd_constants_are_doubted) {
  CHECK_ROWS("descriptions.txt", check_doubts);
}

/* A number that is not set is none, until it is. */
TEST(unset_is_no_number) {
  static const char *const names[] = {"lever",    "dp_bins",        "density",  "u_tau",
                                      "adhesion", "gas_viscosity",  "lambda_c", "rq",
                                      "friction", "adhesion_spread"};
  asp_description *d = parse("surface sigma 10", &si);
  for (size_t i = 0; i < sizeof names / sizeof *names; i++)
    assert_true(isnan(asp_description_get(d, names[i])));
  assert_near(asp_description_get(d, "sigma"), 10, 0);
  assert_near(asp_description_get(d, "seed"), 1, 0);
  assert_near(asp_description_get(d, "soften_from"), 1000, 0); /* a default of the law */
  assert_int_equal(asp_description_set(d, "friction", 0, NULL), ASP_OK);
  assert_near(asp_description_get(d, "friction"), 0, 0);
  asp_description_free(d);
  d = parse("seed 0 grain lever 0.1", &si);
  assert_near(asp_description_get(d, "seed"), 0, 0);
  assert_near(asp_description_get(d, "lever"), 0.1, 0);
  asp_description_free(d);
}

/* What needs no material: numbers that are probably in another unit. */
TEST(odd_numbers_are_doubted) {
  static const char *const all[][3] = {
      /* the doubt without a diameter, and with one */
      {"surface rq 5 lambda_c 40", "rq is 5, which is 5 m", "rq is 5 m, 5e+05 times the diameter"},
      {"erosion oka 1.8 density 7800", "hardness is 1.8, which is 1.8 Pa", "hardness is 1.8"},
      {"erosion oka 1.8MPa density 7800",
       "hardness is 1.8e+06, which is 1.8e+06 Pa; is it one in GPa?", "hardness"},
      {"erosion finnie 200 density 7800", "flow_stress is 200, which is 200 Pa", "flow_stress"},
      {"surface rq 5um rsm 264um", "may be 3.609e-05 m to 5.157e-05 m", "may be 3.609e-05 m"}};
  char text[1500];
  for (size_t i = 0; i < 2 * sizeof all / sizeof *all; i++) {
    const asp_particle particle = {.d_p = i % 2 ? 10e-6 : 0};
    asp_description *d = parse(all[i / 2][0], &si);
    ask(text, &(asp_check_input){d, NULL, 0, &particle, {NULL, NULL}, {0}});
    if (!strstr(text, all[i / 2][1 + i % 2]) || strchr(text, '\n') != strrchr(text, '\n'))
      fail_msg("%s: %s", all[i / 2][0], text);
    asp_description_free(d);
  }
  const asp_particle particle = {.d_p = 10e-6};
  asp_description *d =
      parse("surface rq 5um lambda_c 40um friction 0.5 erosion oka 1.8GPa density 7800", &si);
  ask(text, &(asp_check_input){d, NULL, 0, &particle, {NULL, NULL}, {0}});
  assert_string_equal(text, "");
  asp_description_free(d);
}

/* ---- numbers that are unknown ---- */

/* A description whose numbers may be unknown; NULL and a message where it is refused. */
static asp_description *parse_fit(const char *text, asp_error *error) {
  char copy[500];
  const char *words[50];
  int count = 0, taken;
  asp_description *wall = parse("", &si);
  wall->fittable = true;
  snprintf(copy, sizeof copy, "%s", text);
  for (char *word = strtok(copy, " "); word; word = strtok(NULL, " "))
    words[count++] = word;
  asp_code code = ASP_OK;
  for (int next = 0; next < count && !code; next += taken)
    code = asp_description_read(wall, count - next, words + next, "", &taken, error);
  if (!code && !asp_description_check(wall, error))
    return wall;
  asp_description_free(wall);
  return NULL;
}

static void check_fit(char *row[]) {
  char is[1000];
  asp_error error = {.code = ASP_OK};
  asp_description *wall = parse_fit(row[0], &error);
  if (!wall)
    fail_msg("%s: %s", row[0], error.text);
  asp_description_text(wall, is, sizeof is);
  assert_string_equal(is, row[1]);
  asp_description_free(wall);
}

static void refuses_fit(char *row[]) {
  asp_error error = {.code = ASP_OK};
  check_refused(parse_fit(row[0], &error), &error, row);
}

TEST(numbers_may_be_unknown) {
  each_row("descriptions.txt", "known_numbers", refuses);
  each_row("descriptions.txt", "unknown_numbers", check_fit);
  each_row("descriptions.txt", "bad_unknown_numbers", refuses_fit);
}

/* What is set is known, and the surface and its text follow. */
TEST(unknown_numbers_are_set) {
  char is[1000];
  asp_error error;
  asp_description *wall = parse_fit("surface sigma fit rebound walton fit 0.1 0 seed 7", &error);
  assert_non_null(wall);
  assert_int_equal(wall->n_fitted, 2);
  assert_int_equal(asp_description_set(wall, "sigma", 12, &error), ASP_OK);
  assert_int_equal(asp_description_set(wall, "e", 0.75, &error), ASP_OK);
  assert_int_equal(asp_description_check(wall, &error), ASP_OK);
  assert_int_equal(wall->n_fitted, 0);
  asp_wall *made = asp_wall_create(wall, 0, 0, &error);
  assert_near(asp_surface_slope(asp_wall_surface(made), 1e-5), tan(12 * ASP_PI / 180), 1e-9);
  asp_wall_free(made);
  asp_description_text(wall, is, sizeof is);
  assert_string_equal(is, "surface sigma 12 spread visible isotropic collisions multiple rebound "
                          "walton 0.75 0.1 0 deposit freeze seed 7");
  assert_int_not_equal(asp_description_set(wall, "sigma", 60, &error), ASP_OK);
  assert_says(error.text, "0.001 to 54");
  assert_int_equal(asp_description_set(wall, "rq", 1e-6, &error), ASP_ENAME);
  asp_description_free(wall);
  wall = parse("rebound constant 1 1 grain lever 0.1", &si);
  assert_int_equal(asp_description_set(wall, "lever", 3, &error), ASP_EARG);
  assert_says(error.text, "lever is 3; it must be 0 to 0.5");
  asp_description_free(wall);
}

/* A measured wall says where its points are too few for a sphere. */
TEST(coarse_files_are_doubted) {
  asp_error error;
  asp_heights *profile = aspi_profile_generate(1e-6, 20e-6, 1e-6, 4096, 1, NULL);
  static const double z[16] = {0};
  asp_heights *map = asp_heights_create(z, 4, 4, 1e-6, 1e-6, false, NULL);
  asp_description *d =
      asp_description_parse("surface profile fine.csv materials quartz steel", NULL, NULL);
  assert_int_equal(asp_description_set_heights(d, map, &error), ASP_EARG);
  asp_heights_free(map);
  assert_int_equal(asp_description_set_heights(d, profile, NULL), ASP_OK);
  asp_wall *wall = asp_wall_create(d, 5e-6, 20e-6, NULL);
  const asp_particle largest = {.d_p = 20e-6};
  char text[1500];
  ask(text, &(asp_check_input){d, wall, 20e-6, &largest, {NULL, NULL}, {0}});
  assert_string_equal(text, "");
  ask(text, &(asp_check_input){d, wall, 5e-6, &largest, {NULL, NULL}, {0}});
  assert_ptr_equal(strstr(text, "surface profile fine.csv: "), text);
  ask(text, &(asp_check_input){d, NULL, 5e-6, &largest, {NULL, NULL}, {0}}); /* it is the wall's */
  assert_string_equal(text, "");
  asp_wall_free(wall);
  asp_description_free(d);
  asp_heights_free(profile);
}

/* A wall whose file cannot be read gives the code of its error. */
TEST(files_that_fail_have_their_code) {
  const char *const files[] = {"missing.csv", "words.csv"};
  const asp_code codes[] = {ASP_EFILE, ASP_EDATA};
  FILE *stream = fopen(files[1], "w");
  fputs("no heights\nare here\n", stream);
  fclose(stream);
  for (int k = 0; k < 2; k++) {
    char text[80];
    asp_error error;
    snprintf(text, sizeof text, "surface profile %s materials quartz steel", files[k]);
    assert_null(asp_wall_from_text(text, 5e-6, 20e-6, &error));
    assert_int_equal(error.code, codes[k]);
  }
  remove(files[1]);
}

/* The log's lines: of the surface, and of the speeds at which particles yield and stick. */
TEST(walls_are_reported) {
  asp_description *d = parse("surface rq 5um lambda_c 40um 90um lay 1 0 0 materials quartz 304-ss "
                             "rebound bons temperature 1200",
                             NULL);
  asp_wall *wall = asp_wall_create(d, 0, 0, NULL);
  asp_particle largest = {.d_p = 20e-6, .density = 2650};
  asp_check_input input = {.words = d, .wall = wall, .d_least = 10e-6, .largest = &largest};
  char text[1000], some[10];
  size_t length = asp_wall_report(&input, text, sizeof text);
  assert_int_equal(length, strlen(text));
  assert_int_equal(asp_wall_report(&input, some, sizeof some), length);
  assert_memory_equal(some, text, sizeof some - 1);
  assert_says(text, "\n  R_q 5e-06, lambda_c 4e-05, Phi_R 0.125, sigma 10.02 deg before");
  assert_says(text, ", lambda_c along the lay 9e-05, spread visible isotropic, collis");
  assert_says(text, "\n  d_p 1e-05: tilt of sigma ");
  assert_says(text, "\n  d_p 2e-05: tilt of sigma ");
  assert_says(text, "1200 K the yield stress is 0.775 of that when cold");
  largest.pair = asp_wall_pair(wall);
  double capture, yields;
  asp_wall_report(&input, text, sizeof text);
  assert_int_equal(sscanf(text, " yields above %lf along the normal, d_p 1e-05 sticks below %lf",
                          &yields, &capture),
                   2);
  double modulus = asp_pair_get(largest.pair, "modulus"),
         stress = asp_pair_get(largest.pair, "yield_stress");
  assert_near(yields / (0.775 * stress / sqrt(2650 * modulus)), 1, 1e-3);
  for (int i = 0; i < 2; i++) { /* just above it, and below */
    asp_particle grain = {.d_p = 10e-6, .density = 2650};
    asp_impact impact;
    const double n[3] = {0, 0, 1}, v1[3] = {0, 0, -capture * (i ? 0.99 : 1.01)};
    asp_wall_impact_mean(wall, &grain, v1, n, &(asp_key){1, 1, 1, 1, 0}, &impact);
    assert_int_equal(impact.outcome, i ? ASP_DEPOSIT : ASP_REBOUND);
  }
  asp_wall_free(wall);
  asp_description_free(d);
}
