/* The words of a command line that describe a wall; see description.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/description.h"
#include "base/text.h"
#include "base/units.h"
#include "description/words.h"
#include "spread/flight.h"
#include "wall/wall.h"

#include <math.h>
#include <string.h>

/* Refuses `rq 15`, which would be 15 m, and `oka 1.8`, which would be 1.8 Pa. */
static void check_units(int count, char **words) {
  static const char lengths[] = "rq ra sq lambda_c rsm sampling sal";
  static const char stresses[] = "yield_stress finnie oka";
  for (int i = 0; i + 1 < count; i++) {
    const char *value = strncmp(words[i + 1], "fit=", 4) == 0 ? words[i + 1] + 4 : words[i + 1];
    if (aspi_words_in_list(words[i], lengths))
      cli_check_unit(words[i], value, "length");
    else if (aspi_words_in_list(words[i], stresses))
      cli_check_unit(words[i], value, "stress");
  }
}

/* A command computes no flow. */
static void check_removal(const asp_description *d) {
  if (asp_description_is_given(d, "remove") && !asp_description_is_given(d, "u_tau"))
    cli_bad_usage("behind 'remove', 'u_tau U' is expected");
}

static void read_words(asp_description *d, int count, char **words) {
  const char *const *all = (const char *const *)words;
  for (int next = 0, taken; next < count; next += taken)
    cli_must(!asp_description_read(d, count - next, all + next, "", &taken, &cli_error));
  cli_must(!asp_description_check(d, &cli_error));
}

char *cli_description_text(const asp_description *words) {
  size_t size = asp_description_text(words, NULL, 0) + 1;
  char *text = cli_allocate(size, 1);
  asp_description_text(words, text, size);
  return text;
}

static void read_materials(cli_description *d) {
  static char *default_words[] = {"materials", "ard", "hastelloy-x"};
  int count = asp_description_materials(d->words);
  if (count == 0 && asp_rebound_needs_pair(asp_description_rebound(d->words))) {
    if (d->words->fittable)
      cli_bad_usage(
          "'materials' is missing: a fit needs those of the measured particles and wall, as "
          "'materials quartz al-2024'");
    read_words(d->words, 3, default_words);
    d->has_default_materials = true;
    count = 2;
  }
  d->density = asp_material_get(aspi_materials_find(NULL, default_words[1], NULL), "density");
  if (count == 0)
    return;
  cli_must(!asp_description_check_pair(d->words, &cli_error));
  d->particle = asp_description_material(d->words, 0);
  d->target = asp_description_material(d->words, 1);
  d->density = asp_material_get(d->particle, "density");
  d->pair = cli_made(asp_description_pair(d->words, d->particle, d->target, &cli_error));
}

cli_description cli_description_read(int count, char **words, bool fittable) {
  cli_description d = {.words = cli_made(asp_description_parse("", NULL, &cli_error))};
  asp_description_expect_pairs(d.words); /* its own, or none as for samples of tilts */
  d.words->fittable = fittable;
  check_units(count, words);
  read_words(d.words, count, words);
  check_removal(d.words);
  read_materials(&d);
  d.text = cli_description_text(d.words);
  return d;
}

/* The words `materials PARTICLE WALL` of a ledger's heading; NULL: it does not have two. */
static char *ledger_materials(const char *heading) {
  char *line = cli_copy(*heading == '#' ? heading : ""), *text = NULL;
  line[strcspn(line, "\n")] = '\0';
  for (char *at = line; (at = strstr(at, " materials ")) != NULL;) /* the last: not the command */
    text = ++at;
  if (!text)
    return NULL;
  text[asp_description_clause(text)] = '\0';
  asp_description *words = asp_description_parse(text, NULL, NULL);
  int count = words ? asp_description_materials(words) : 0;
  asp_description_free(words);
  return count == 2 ? text : NULL;
}

int cli_ledger_words(const char *heading, int count, char ***words) {
  char *text = ledger_materials(heading), *word;
  for (int i = 0; i < count; i++)
    if (strcmp((*words)[i], "materials") == 0)
      return count;
  char **all = cli_allocate((size_t)count + (text ? strlen(text) : 0), sizeof *all);
  memcpy(all, *words, (size_t)count * sizeof *all);
  while (text && (word = aspi_text_field(&text, ' ')) != NULL)
    all[count++] = word;
  *words = all;
  return count;
}

void cli_ledger_densities(const char *heading, double *particle, double *wall) {
  const char *text = ledger_materials(heading);
  asp_description *words = text ? asp_description_parse(text, NULL, NULL) : NULL;
  if (!words)
    return;
  *particle = isnan(*particle) ? asp_material_get(asp_description_material(words, 0), "density")
                               : *particle;
  *wall = asp_material_get(asp_description_material(words, 1), "density");
  asp_description_free(words);
}

void cli_description_allow(cli_description *d, const char *allowed, const char *why) {
  d->has_no_impact = !aspi_words_in_list("rebound", allowed);
  for (const aspi_keyword *k = aspi_keywords; k->name; k++) {
    bool is_own = strcmp(k->name, "materials") != 0 || !d->has_default_materials;
    if (!*k->within && is_own && asp_description_is_given(d->words, k->name) &&
        !aspi_words_in_list(k->name, allowed))
      cli_bad_usage("'%s' has no effect: %s; what counts is: %s", k->name, why, allowed);
  }
}

void cli_description_doubt(const cli_description *d, double d_least, double d_most) {
  const bool hits = !d->has_no_impact;
  const asp_particle largest = {
      .d_p = d_most, .density = d->density, .pair = hits ? d->pair : NULL};
  const asp_check_input input = {.words = d->words,
                                 .wall = d->wall,
                                 .d_least = d_least,
                                 .largest = &largest,
                                 .material = {hits ? d->particle : NULL, hits ? d->target : NULL}};
  char doubt[500];
  for (int i = 0; asp_warning(&input, i, doubt, sizeof doubt); i++)
    if (*doubt)
      cli_warn("%s", doubt);
}

void cli_description_make(cli_description *d, double d_least, double d_most) {
  cli_must(!asp_description_check_heat(d->words, d->has_own_heat, &cli_error));
  d->wall = cli_made(asp_wall_create(d->words, d_least, d_most, &cli_error));
  const asp_surface *surface = asp_wall_surface(d->wall);
  if (surface && asp_surface_check(surface, d_most, &cli_error))
    cli_bad_usage("--dp: %s", cli_error.text);
  cli_description_doubt(d, d_least, d_most);
}

void cli_description_doubt_angles(const cli_description *d, const cli_list *angles) {
  const asp_spread_model *spread = asp_wall_spread(d->wall);
  if (d->words->kind != ASPI_PROFILE || !spread || !spread->follow)
    return;
  double least = angles->values[0], r_q = asp_surface_r_q(asp_wall_surface(d->wall));
  for (size_t i = 1; i < angles->count; i++)
    least = fmin(least, angles->values[i]);
  double lowest = aspi_degrees(atan(aspi_fall_least(r_q, 2 * d->wall->heights.length)));
  if (least < lowest)
    cli_warn("--angles: %g degrees is so low that a particle would fall by less than 16 R_q over "
             "the profile and its mirror image, and meet few peaks; below %.3g degrees it is "
             "steepened to that",
             least, lowest);
}

double cli_description_shrink(const cli_description *d, const asp_surface *surface) {
  const aspi_wall_choice choice = aspi_description_choice(d->words);
  double ratio = asp_surface_lambda_c(surface) / asp_surface_lambda_along(surface);
  return choice.has_lay ? 1 + (ratio * ratio - 1) * choice.lay[0] * choice.lay[0] : 1;
}

cli_impact cli_impact_at(const cli_description *d, double d_p, double speed, double kelvin,
                         double degrees, const asp_key *key) {
  static const double n[3] = {0, 0, 1};
  double alpha = aspi_radians(degrees);
  double v1[3] = {degrees < 90 ? speed * cos(alpha) : 0, 0, -speed * sin(alpha)};
  asp_particle particle = {
      .d_p = d_p, .density = d->density, .pair = d->pair, .temperature = kelvin};
  cli_impact i;
  asp_wall_impact(d->wall, &particle, v1, n, key, &i.impact);
  i.cor = asp_impact_coefficients(v1, n, &i.impact);
  return i;
}
