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
    print_error("%s\n%s\n", text, error.text);
  assert_non_null(d);
  return d;
}

static void check_text(const char *text, const char *canonical) {
  char is[1000];
  asp_description *wall = parse(text, &si);
  assert_int_equal(asp_description_text(wall, is, sizeof is), strlen(canonical));
  assert_string_equal(is, canonical);
  asp_description_free(wall);
}

TEST(canonical_texts) {
  check_text("", "surface smooth rebound bons deposit freeze seed 1");
  check_text("surface rq 15.6um lambda_c 120um rebound bons friction 0.4 materials quartz "
             "hastelloy-x",
             "surface rq 1.56e-05 lambda_c 0.00012 spread visible isotropic collisions multiple "
             "rebound bons materials quartz hastelloy-x friction 0.4 deposit freeze seed 1");
  check_text("rebound constant 0.5 0.25 deposit off surface sigma 8deg spread weibull plane "
             "collisions single seed 4294967295",
             "surface sigma 8 spread weibull plane collisions single rebound constant 0.5 0.25 "
             "deposit off seed 4294967295");
  check_text("surface rq 1e-06 lambda_c 1e-05 5e-05 lay axial spread traced",
             "surface rq 1e-06 lambda_c 1e-05 5e-05 lay axial spread traced isotropic "
             "collisions multiple rebound bons deposit freeze seed 1");
  check_text("surface profile 'my blade.csv' dp_bins 4 rebound bons soften 500C 0.001/K yield_rate "
             "3MPa/(m/s) temperature 800 spin on",
             "surface profile \"my blade.csv\" dp_bins 4 spread traced isotropic collisions "
             "multiple rebound bons yield_rate 3000000 soften 773.15 0.001 spin on temperature 800 "
             "deposit freeze seed 1");
  check_text("surface profile \"it's\" materials quartz steel",
             "surface profile \"it's\" spread traced isotropic collisions multiple rebound bons "
             "materials quartz steel deposit freeze seed 1");
  check_text("surface map 'a\nb' materials quartz steel",
             "surface map \"a\nb\" spread traced isotropic collisions multiple rebound bons "
             "materials quartz steel deposit freeze seed 1");
  check_text("surface map \"it's 5\"\" long\" materials quartz steel",
             "surface map \"it's 5\"\" long\" spread traced isotropic collisions multiple rebound "
             "bons materials quartz steel deposit freeze seed 1");
  check_text("yield_stress 200kPa erosion finnie 500kPa density 2000",
             "surface smooth rebound bons yield_stress 200000Pa deposit freeze erosion finnie "
             "500000Pa density 2000 face mean seed 1");
  check_text(
      "surface map m.sdf lay 3 0 4 deposit freeze remove gas_density 1.2 gas_viscosity 1.5e-5 "
      "u_tau 2.5 yield_stress "
      "150MPa",
      "surface map m.sdf lay 3 0 4 spread traced isotropic collisions multiple rebound bons "
      "yield_stress 150000000 deposit freeze remove u_tau 2.5 gas_density 1.2 gas_viscosity "
      "1.5e-05 seed 1");
  check_text("deposit freeze remove gas_density 1.2 gas_viscosity 0.5 adhesion 0.01",
             "surface smooth rebound bons adhesion 0.01 deposit freeze remove gas_density 1.2 "
             "gas_viscosity 0.5 seed 1");
  check_text("adhesion 0.02 adhesion_spread 3 yield_stress 2e8 scatter 0.3",
             "surface smooth rebound bons adhesion 0.02 adhesion_spread 3 yield_stress 200000000 "
             "scatter 0.3 deposit freeze seed 1");
  check_text("rebound bons temperature 1200 yield_rate 3e6 scatter 0.25 seed 2",
             "surface smooth rebound bons yield_rate 3000000 scatter 0.25 temperature 1200 deposit "
             "freeze seed 2");
  check_text("rebound thornton_ning temperature 900C soften_modulus wall_temperature 1100 exp "
             "3e20Pa 0.02365/K deposit delete viscosity critical 1e5P vft -4.5 9000 500",
             "surface smooth rebound thornton_ning temperature 1173.15 soften_modulus exp 3e+20 "
             "0.02365 wall_temperature 1100 deposit delete viscosity vft -4.5 9000 500 critical "
             "10000 seed 1");
}

/* What instruments print becomes rq and lambda_c, by closed forms; R_Sm by its table. */
TEST(instruments_are_understood) {
  static const struct {
    const char *text;
    double r_q, lambda_c;
  } all[] = {{"rq 5um rdq 0.2", 5e-6, 35.35533905932738e-6},
             {"ra 4um rdq 10deg", 5.013256549262001e-6, 40.2083412030074e-6},
             {"ra 4um lambda_c 40um", 5.013256549262001e-6, 40e-6},
             {"sq 5um lambda_c 40um", 5e-6, 40e-6},
             {"sq 5um sdq 0.25", 5e-6, 40e-6},
             {"sq 5um sal 50um", 5e-6, 39.41241e-6},
             {"rq 5um rsm 0.26400mm sampling 0.8mm", 5e-6, 40.3306e-6},
             {"rq 5um rsm 264um", 5e-6, 43.139e-6}};
  for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
    char words[100], text[300], *end;
    snprintf(words, sizeof words, "surface %s", all[i].text);
    asp_description *d = parse(words, &si);
    asp_description_text(d, text, sizeof text);
    assert_memory_equal(text, "surface rq ", 11);
    double r_q = strtod(text + 11, &end);
    assert_memory_equal(end, " lambda_c ", 10);
    assert_near(r_q, all[i].r_q, 1e-12 * r_q);
    assert_near(strtod(end + 10, NULL), all[i].lambda_c, 1e-5 * all[i].lambda_c);
    asp_description_free(d);
  }
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

static void refuses(const char *text, const char *first, const char *second) {
  asp_error error = {.code = ASP_OK};
  asp_description *wall = asp_description_parse(text, &si, &error);
  if (wall || !strstr(error.text, first) || !strstr(error.text, second))
    print_error("%s: %s\n", text, wall ? "accepted" : error.text);
  assert_null(wall);
  assert_int_not_equal(error.code, ASP_OK);
  assert_non_null(strstr(error.text, first));
  assert_non_null(strstr(error.text, second));
}

TEST(slips_are_named) {
  refuses("surfaces smooth", "'surfaces'", "did you mean 'surface'?");
  refuses("seed 1 fricton 0.3", "'fricton'", "did you mean 'friction'?");
  refuses("surface rq 1 lambda_c 10 spread wiebull", "'wiebull'", "did you mean 'weibull'?");
  refuses("rebound bonds", "'bonds'", "did you mean 'bons'?");
  refuses("rebound bons yeild_rate 3", "'yeild_rate'", "did you mean 'yield_rate'?");
  refuses("rebound walton 0.9 0.3 0 complience 0.7", "'complience'", "did you mean 'compliance'?");
  refuses("surface profile f dpbins 3", "'dpbins'", "did you mean 'dp_bins'?");
  refuses("materials quartz hasteloy-x", "'hasteloy-x'", "did you mean 'hastelloy-x'?");
  refuses("materials quartz 304-ss surfac rq 5e-6", "'surfac'", "did you mean 'surface'?");
  refuses("materials quartz 304-ss fil own.csv", "'fil'", "did you mean 'file'?");
  refuses("materials sand steel", "material 'sand' is unknown; there are: ard", "");
  refuses("materials quartz steel ledger 100 file x", "material 'ledger' is unknown", "steel");
  refuses("materials quartz steel fricton 0.4", "'fricton'", "did you mean 'friction'?");
  refuses("materials quartz 0.4", "'0.4' is unknown", "friction");
}

TEST(misplaced_words_are_sent_home) {
  refuses("sigma 5", "'sigma' belongs behind 'surface'", "surface sigma ANGLE");
  refuses("surface sigma 5 collisions single", "'collisions' belongs behind 'spread'",
          "spread MODEL collisions");
  refuses("surface rq 5um lamda_c 40um", "'lamda_c' is unknown; did you mean 'lambda_c'?", "");
  refuses("deposit freeze remove gas_densty 1.2", "did you mean 'gas_density'?", "");
  refuses("friction 0.3 u_tau 2", "'u_tau' belongs behind 'remove'", "");
  refuses("surface smooth map 100", "'map' has no place here behind 'surface'", "surface map FILE");
  refuses("materials quartz steel collisions multiple", "'collisions' belongs behind 'spread'", "");
  refuses("oka 1.8GPa", "'oka' belongs behind 'erosion': erosion oka", "");
  refuses("rebound bons walton", "rebound takes one law; 'walton' follows 'bons'", "");
  refuses("spread visible traced", "spread takes one model; 'traced' follows 'visible'", "");
  refuses("temperature 1200", "'temperature' belongs behind 'rebound'", "");
  refuses("rebound walton 0.9 0.3 0 spin on", "'spin' belongs to 'rebound bons'", "");
  refuses("rebound walton 0.9 0.3 0 friction 1 compliance 1", "belongs to 'rebound walton'", "");
  refuses("materials quartz steel particles sic", "'particles' belongs to 'erosion oka'", "");
}

/* Each names the thing, its value and what it must be. */
TEST(heat_is_refused) {
  refuses("deposit off viscosity critical 1e4 vft -4 5000 300", "'viscosity' has no effect",
          "deposit off");
  refuses("deposit freeze viscosity critical 0 vft -4 5000 300", "critical is 0", "> 0");
  refuses("deposit freeze viscosity vft -4 5000 300", "behind 'viscosity'", "critical MU");
  refuses("deposit freeze viscosity critical 1e4", "'viscosity' lacks its curve", "vft A B C");
  refuses("deposit freeze viscosity critical 1e4 exp 3e20 0.02", "'exp'", "");
  refuses("deposit freeze viscosity critical 1e4 vft -4 5000 300 watt 60 20 8 8 4",
          "'vft' and 'watt'", "one");
  refuses("deposit freeze viscosity critical 1e4 watt 50 20 5 5 5", "are 85 %", "100");
  refuses("deposit freeze viscosity critical 1e4 watt 60 20 8 8 -4", "mgo is -4", "0 to 100");
  refuses("rebound bons temperature 300 deposit freeze viscosity critical 1e4 vft -4 5000 300",
          "the viscosity is asked for at 300 K", "more than 300 K");
  refuses("rebound bons temperature 150C deposit freeze viscosity critical 1e4 watt 60 20 8 8 4",
          "the viscosity is asked for at 423.15 K", "more than 423.15 K");
  refuses("rebound bons soften_modulus exp 3e20 0.02365", "behind 'soften_modulus'",
          "wall_temperature T");
  refuses("rebound walton 0.9 0.3 0 soften_modulus exp 3e20 0.02365 wall_temperature 900",
          "'soften_modulus' has no effect", "walton");
  refuses("rebound walton 0.9 0.3 0 temperature 1300", "'temperature' has no effect", "viscosity");
}

TEST(words_are_given_once) {
  refuses("surface sigma 5 spread visible plane isotropic", "'plane' and 'isotropic'", "one");
  refuses("surface sigma 5 spread visible plane plane", "'plane' is given twice", "");
  refuses("surface sigma 5 spread visible collisions single collisions multiple",
          "'collisions' is given twice", "");
  refuses("surface profile f dp_bins 3 dp_bins 4", "'dp_bins' is given twice", "");
  refuses("rebound bons yield_rate 1 yield_rate 2", "'yield_rate' is given twice", "");
  refuses("erosion dnv density 7800 face mean face tilted", "'face' is given twice", "");
  refuses("erosion dnv k 1 k 2 density 7800", "'k' is given twice", "");
  refuses("deposit freeze remove u_tau 1 u_tau 2 gas_density 1", "'u_tau' is given twice", "");
}

TEST(bad_values_are_named) {
  refuses("surface ra 3.2um rdq 10", "a slope of 84 degrees", "say 10deg?");
  refuses("surface sq 5um sal 1um", "at most 1", "");
  refuses("surface rz 30um", "surface is 'rz'", "ra R");
  refuses("surface rq 5um sdq 0.2", "rdq S, rsm L", "");
  refuses("surface sq 5um rsm 0.3mm", "sdq S, sal L", "");
  refuses("surface ra 5um", "'surface ra R' needs a length", "rdq");
  refuses("surface rq 5um", "'surface rq R' needs a length", "src/wall/from_a_drawing.md");
  refuses("surface rq 5um rdq -0.2", "rdq is -0.2", "> 0");
  refuses("surface rq 5um rdq 10um", "rdq is '10um'", "deg rad");
  refuses("surface rq 5um rsm 26um sampling 0.8mm", "rsm is 0.0325 of the sampling length", "rdq");
  refuses("surface rq 40um lambda_c 5um", "their ratio 8 must be at most 1", "");
  refuses("surface rq -5um lambda_c 5um", "rq is -5um", "> 0");
  refuses("rebound constant 0.5 1.5", "cor_t is 1.5", "0 to 1");
  refuses("surface", "surface", "needs a value");
  refuses("surface bumpy", "'bumpy'", "smooth | sigma ANGLE");
  refuses("surface rq 1e-5", "lambda_c L", "");
  refuses("surface rq fine lambda_c 1", "rq is 'fine'", "m cm mm um nm");
  refuses("surface rq 5parsec lambda_c 1", "rq is '5parsec'", "m cm mm um nm");
  refuses("surface rq 0 lambda_c 1", "rq is 0", "> 0");
  refuses("surface rq 1 lambda_c nan", "lambda_c is", "> 0");
  refuses("surface rq 3 lambda_c 1", "r_q is 3 and lambda_c 1: their ratio 3 must be at most 1",
          "");
  refuses("surface sigma 60", "sigma is 60", "0.001 to 54");
  refuses("surface rq 1 lambda_c 10 lay 1 0 0", "'lay' needs two", "");
  refuses("surface sigma 10 lay 3", "'lay' needs two correlation lengths", "lambda_c L L_along");
  refuses("surface rq 1 lambda_c 10 dp_bins 3 lay 3", "'lay' needs two", "");
  refuses("surface profile FILE lay axial", "'lay' needs two", "a map");
  refuses("surface rq 1 lambda_c 10 20", "'lay' and its direction", "");
  refuses("surface rq 1 lambda_c 10 20 lay 0 0 0", "lay is 0 0 0", "> 0");
  refuses("surface rq 1 lambda_c 10 20 lay 1 2 up", "lay is 'up'", "number");
  refuses("surface rq 1 lambda_c 10 20 lay diagonal", "lay is 'diagonal'", "axial");
  refuses("surface rq 1 lambda_c 10 20 lay 500", "lay is 500", "-180 to 180");
  refuses("surface profile -", "'-'", "name of a file");
  refuses("rebound table -", "'-'", "name of a file");
  refuses("surface profile f dp_bins 0", "dp_bins is 0", "1 to 256");
  refuses("surface rq 1 lambda_c 10 spread weibull collisions many", "'many'", "single | multiple");
  refuses("rebound constant 1.5 1", "cor_n is 1.5", "0 to 1");
  refuses("rebound constant 1", "cor_t", "needs a value");
  refuses("rebound bons contact_area 1 1", "'c' needs a value", "");
  refuses("rebound bons contact_area 1 1 11", "c is 11", "0 to 10");
  refuses("rebound bons scatter 1", "'scatter' belongs behind 'yield_stress'", "scatter S");
  refuses("yield_stress 2e8 scatter 0", "scatter is 0", "0 to 2");
  refuses("grain cube", "grain is 'cube'", "sphere | lever S");
  refuses("grain lever 0", "lever is 0", "0 to 0.5");
  refuses("rebound walton 0.9 0.2 0.4 grain lever 0.03", "BETA0 0", "");
  refuses("rebound bons spin fast", "spin is 'fast'", "off | on");
  refuses("rebound bons temperature 500F", "'500F'", "K C");
  refuses("rebound table nowhere.csv", "nowhere.csv", "No such file");
  refuses("materials quartz steel file nowhere.csv", "nowhere.csv", "No such file");
  refuses("friction -1", "friction is -1", ">= 0");
  refuses("surface_energy nan", "surface_energy is", ">= 0");
  refuses("yield_stress 200bar", "'200bar'", "Pa kPa MPa GPa");
  refuses("deposit stick", "'stick'", "freeze | delete | off");
  refuses("deposit freeze remove u_tau 1", "gas_density", "expected");
  refuses("seed 1.5", "seed is 1.5", "whole number from 0 to 4294967295");
  refuses("surface smooth surface smooth", "'surface'", "twice");
  refuses("surface profile 'a", "quote", "no end");
}

TEST(what_has_no_effect_is_refused) {
  refuses("surface profile p.csv spread profile", "spread is 'profile'", "'spread traced'");
  refuses("rebound walton 0.9 0.3 0 surface_energy 1", "'surface_energy' has no effect", "walton");
  refuses("rebound walton 0.9 0.3 0 yield_stress 1", "'yield_stress' has no effect", "walton");
  refuses("rebound walton 0.9 0.3 0 yield_stress 1 scatter 0.3", "'yield_stress' has no effect",
          "walton");
  refuses("rebound bons yield_rate 0 scatter 0.3", "'scatter' has no effect", "yield_rate 0");
  refuses("rebound walton 0.9 0.3 0 adhesion 0.1", "'adhesion' has no effect", "walton");
  refuses("adhesion 0.1 deposit off", "'adhesion' has no effect", "deposit off");
  refuses("rebound walton 0.9 0.3 0 friction 0.3", "'friction' has no effect", "MU");
  refuses("materials quartz steel rebound constant 1 1", "'materials' has no effect", "constant");
  refuses("yield_stress 1e8 rebound bons yield_rate 3e6", "'yield_stress' has no effect",
          "yield_rate");
  refuses("rebound bons temperature 600", "'temperature' has no effect at 600 K",
          "starts at 1000 K");
  refuses("rebound bons soften 800 0.001 temperature 800", "'temperature' has no effect", "800 K");
  refuses("deposit off remove u_tau 1 gas_density 1 gas_viscosity 1", "'remove' has no effect",
          "deposit off");
  refuses("deposit delete remove u_tau 1 gas_density 1 gas_viscosity 1", "'remove' has no effect",
          "deposit delete");
  refuses("rebound constant 1 1 deposit freeze remove u_tau 1 gas_density 1 gas_viscosity 1",
          "'remove' has no effect", "no materials");
  refuses("surface_energy 1 deposit off", "'surface_energy' has no effect", "deposit off");
  refuses("spread weibull", "'spread' has no effect", "surface smooth");
  refuses("spread none surface sigma 8", "'none' is unknown", "visible");
  refuses("surface rq 1 lambda_c 10 dp_bins 4", "'dp_bins' has no effect", "spread visible");
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
  assert_non_null(strstr(error.text, "'units lj'"));
  assert_null(asp_description_parse("materials quartz steel", &lj, &error));
  assert_non_null(strstr(error.text, "'units lj'; units must be si"));
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
  assert_non_null(strstr(error.text, "did you mean 'ledger'?"));
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

/* Those of quartz on steel with these changes. */
static void doubts(char text[1500], const char *description, double d_p, double density,
                   double modulus) {
  asp_description *wall = parse(description, &si);
  asp_material *p = asp_material_create("sand", NULL), *w = asp_material_create("iron", NULL);
  asp_material_set(p, "youngs_modulus", modulus, NULL);
  asp_material_set(w, "youngs_modulus", modulus, NULL);
  asp_material_set(p, "density", 2650, NULL);
  asp_material_set(p, "yield_stress", 200e6, NULL);
  asp_pair *pair = asp_description_pair(wall, p, w, NULL);
  asp_particle particle = {.d_p = d_p, .density = density, .pair = pair};
  ask(text, &(asp_check_input){wall, NULL, 0, &particle, {p, w}, {0}});
  asp_pair_free(pair);
  asp_material_free(p);
  asp_material_free(w);
  asp_description_free(wall);
}

TEST(odd_constants_are_doubted) {
  char text[1500];
  doubts(text, "", 20e-6, 2650, 70e9);
  assert_string_equal(text, "");
  doubts(text, "", 20e-6, 2750, 70e9);
  assert_non_null(strstr(text, "3.77 % off that of material 'sand', 2650 kg/m3"));
  assert_null(strchr(strchr(text, '\n') + 1, '\n'));
  doubts(text, "", 20e-6, 2650, 5e6);
  assert_non_null(strstr(text, "so that nothing yields"));
  doubts(text, "", 20e-6, 2650, 70); /* GPa */
  assert_non_null(strstr(text, "so that nothing yields"));
  doubts(text, "surface_energy 50", 20e-6, 2650, 70e9);
  assert_non_null(strstr(text, "particles up to 2e-05 m always stick"));
  doubts(text, "deposit off", 1e-9, 2650, 70e9);
  assert_string_equal(text, "");
#define FLOW "deposit freeze remove u_tau 1 gas_density 1.2 gas_viscosity 1.5e-5 "
  doubts(text, FLOW, 5e-6, 2650, 70e9);
  assert_string_equal(text, "");
  doubts(text, FLOW, 69e-6, 2650, 70e9);
  assert_non_null(strstr(text, "takes away more than half of the particles of diameter 6.9e-05"));
  doubts(text, FLOW, 71e-6, 2650, 70e9);
  assert_non_null(strstr(text, "takes away at once what particles of diameter 7.1e-05 m leave"));
  doubts(text, FLOW "adhesion 0.5", 71e-6, 2650, 70e9);
  assert_string_equal(text, "");
#define SIZES "is for particles of"
  static const struct {
    const char *words;
    double d_p;
    const char *says;
  } sizes[] = {
      {"", 200e-6 * (1 + 1e-12), NULL},
      {"", 0.5e-6, NULL},
      {"", 2e-3,
       "the adhesion of 'bons' is for particles of 0.5 to 200 um; it freezes larger "
       "grains to the wall: say 'rebound walton E MU 0 deposit off'"},
      {"surface_energy 0.01 yield_stress 1GPa", 0.4e-6,
       "for smaller ones say 'rebound thornton_ning'"},
      {"rebound thornton_ning", 0.4e-6, NULL},
      {"rebound thornton_ning", 2e-3, "of 'thornton_ning' is for particles of 0 to 200 um"},
      {"surface_energy 0", 2e-3, NULL},
      {"deposit off", 2e-3, NULL}};
  for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
    doubts(text, sizes[i].words, sizes[i].d_p, 2650, 70e9);
    if (sizes[i].says ? !strstr(text, sizes[i].says) : strstr(text, SIZES) != NULL)
      fail_msg("%s: %s", sizes[i].words, text);
  }
  doubts(text, "surface rq 5 lambda_c 40", 20e-6, 2650, 70e9);
  assert_non_null(strstr(text, "rq is 5"));
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

static void check_fit(const char *text, const char *canonical) {
  char is[1000];
  asp_error error = {.code = ASP_OK};
  asp_description *wall = parse_fit(text, &error);
  if (!wall)
    print_error("%s: %s\n", text, error.text);
  assert_non_null(wall);
  asp_description_text(wall, is, sizeof is);
  assert_string_equal(is, canonical);
  asp_description_free(wall);
}

TEST(numbers_may_be_unknown) {
  refuses("surface sigma fit", "sigma is 'fit'", "must be a number");
  refuses("friction fit=0.2", "friction is 'fit=0.2'", "must be a number");
  check_fit("surface sigma fit friction fit yield_stress fit=200MPa",
            "surface sigma fit=5 spread visible isotropic collisions multiple rebound bons "
            "friction fit yield_stress fit=200000000 deposit freeze seed 1");
  check_fit(
      "surface rq fit=4e-06 lambda_c fit=4e-05 8e-05 lay axial rebound bons contact_area 0.1 fit "
      "fit=0.6",
      "surface rq fit=4e-06 lambda_c fit=4e-05 8e-05 lay axial spread visible isotropic "
      "collisions multiple rebound bons contact_area 0.1 fit=0.14285714285714285 fit=0.6 "
      "deposit freeze seed 1");
  check_fit("rebound bons yield_rate fit", "surface smooth rebound bons yield_rate fit=0 deposit "
                                           "freeze seed 1");
  static const struct {
    const char *text, *first, *second;
  } bad[] = {{"surface rq fit lambda_c 40um", "'rq fit=VALUE'", "m cm mm um nm"},
             {"surface rq fit=4lb lambda_c 40um", "rq is '4lb'", "m cm mm um nm"},
             {"surface sigma fit=60", "sigma is 60", "0.001 to 54"},
             {"rebound walton fit=1.5 0.1 0", "e is 1.5", "0 to 1"},
             {"rebound bons spin fit", "spin is 'fit'", "off | on"},
             {"seed fit", "seed is 'fit'", "number"},
             {"rebound walton fit fit 0 friction fit", "'friction' has no effect", "walton"}};
  for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
    asp_error error = {.code = ASP_OK};
    assert_null(parse_fit(bad[i].text, &error));
    if (!strstr(error.text, bad[i].first) || !strstr(error.text, bad[i].second))
      print_error("%s: %s\n", bad[i].text, error.text);
    assert_non_null(strstr(error.text, bad[i].first));
    assert_non_null(strstr(error.text, bad[i].second));
  }
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
  assert_non_null(strstr(error.text, "0.001 to 54"));
  assert_int_equal(asp_description_set(wall, "rq", 1e-6, &error), ASP_ENAME);
  asp_description_free(wall);
  wall = parse("rebound constant 1 1 grain lever 0.1", &si);
  assert_int_equal(asp_description_set(wall, "lever", 3, &error), ASP_EARG);
  assert_non_null(strstr(error.text, "lever is 3; it must be 0 to 0.5"));
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
  assert_non_null(
      strstr(text, "\n  R_q 5e-06, lambda_c 4e-05, Phi_R 0.125, sigma 10.02 deg before"));
  assert_non_null(strstr(text, ", lambda_c along the lay 9e-05, spread visible isotropic, collis"));
  assert_non_null(strstr(text, "\n  d_p 1e-05: tilt of sigma "));
  assert_non_null(strstr(text, "\n  d_p 2e-05: tilt of sigma "));
  assert_non_null(strstr(text, "1200 K the yield stress is 0.775 of that when cold"));
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
