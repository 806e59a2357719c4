/* Rebound laws and materials from options; see law.h.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/law.h"
#include "base/number.h"
#include "cli/walls.h"
#include "rebound/laws.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

asp_materials *cli_materials_of(const cli_option *option) {
  if (!option->value)
    return NULL;
  asp_error error;
  asp_materials *own = asp_materials_read(option->value, &error);
  if (!own)
    cli_bad_file(option, &error);
  return own;
}

static const asp_material *material_of(const cli_option *option, const asp_materials *own,
                                       const char *name) {
  asp_error error;
  const asp_material *material = asp_materials_find(own, name, &error);
  if (!material)
    cli_bad_usage("--%s: %s", option->name, error.text);
  return material;
}

/* --set a=0.2,c=1 */
static void set_parameters(const cli_option *option, asp_wall *wall) {
  if (!option->value)
    return;
  char *text = cli_copy(option->value);
  asp_error error;
  for (char *item = text, *next; item; item = next) {
    next = strchr(item, ',');
    if (next)
      *next++ = '\0';
    char *equals = strchr(item, '='), *end = NULL;
    if (equals)
      *equals = '\0';
    double value = equals ? aspi_number(equals + 1, &end) : 0;
    const asp_rebound_law *law = asp_wall_rebound(wall);
    int index = equals ? aspi_rebound_parameter_find(law, item, &error) : -1;
    bool word = index >= 0 && *asp_parameter_words(asp_rebound_parameter(law, index));
    if (!equals || (!word && (end == equals + 1 || *end)))
      cli_bad_usage("--%s is '%s'; NAME=VALUE,NAME=VALUE... is expected", option->name,
                    option->value);
    if (index < 0 ||
        (word &&
         asp_parameter_read(asp_rebound_parameter(law, index), equals + 1, &value, &error)) ||
        asp_wall_set(wall, item, value, &error))
      cli_bad_usage("--%s: %s", option->name, error.text);
  }
  free(text);
}

/* Of the parameters that follow a keyword: how many there are, and their names with commas. */
static int parameters_of(const asp_rebound_law *law, const char *keyword, char *names,
                         size_t size) {
  int count = 0;
  *names = '\0';
  for (int i = 0; i < asp_rebound_parameters(law); i++) {
    const asp_parameter *p = asp_rebound_parameter(law, i);
    if (strcmp(asp_parameter_keyword(p), keyword) != 0)
      continue;
    size_t used = strlen(names);
    snprintf(names + used, size - used, "%s%s", count++ ? "," : "", asp_parameter_name(p));
  }
  return count;
}

/* The option of a keyword: contact_area is --contact-area. */
static void add_keyword(cli_option *option, const asp_rebound_law *law, const char *keyword) {
  char names[200], help[300];
  parameters_of(law, keyword, names, sizeof names);
  snprintf(help, sizeof help, "of --rebound %s: %s; see 'asperity rebound --list'",
           asp_rebound_name(law), names);
  char *name = cli_copy(keyword), *argument = cli_copy(names);
  for (char *c = name; *c; c++)
    *c = *c == '_' ? '-' : *c;
  for (char *c = argument; *c; c++)
    *c = (char)toupper((unsigned char)*c);
  *option = (cli_option){name, argument, cli_copy(help), NULL};
}

/* Whether an option is that of a keyword. */
static bool is_of(const cli_option *option, const char *keyword) {
  const char *name = option->name;
  for (; *name && *keyword && (*name == *keyword || (*name == '-' && *keyword == '_')); name++)
    keyword++;
  return !*name && !*keyword;
}

void cli_law_add_keywords(cli_option *first) {
  int count = 0;
  for (int l = 0; l < asp_rebound_count(); l++)
    for (int i = 0; i < asp_rebound_parameters(asp_rebound_at(l)); i++) {
      const asp_rebound_law *law = asp_rebound_at(l);
      const char *keyword = asp_parameter_keyword(asp_rebound_parameter(law, i));
      bool known = !*keyword;
      for (int k = 0; k < count && !known; k++)
        known = is_of(&first[LAW_KEYWORDS + k], keyword);
      if (!known && count < LAW_KEYWORDS_MOST)
        add_keyword(&first[LAW_KEYWORDS + count++], law, keyword);
    }
}

/* Of a keyword with words for its value. */
static void set_word(const cli_option *option, const asp_parameter *p, asp_wall *wall) {
  asp_error error;
  double value;
  if (asp_parameter_read(p, option->value, &value, &error))
    cli_bad_usage("--%s: %s", option->name, error.text);
  asp_wall_set(wall, asp_parameter_name(p), value, NULL);
}

/* The values of a keyword's option: one for each of the law's parameters that follow it. */
static void set_keyword(const cli_option *option, const char *keyword, asp_wall *wall) {
  const asp_rebound_law *law = asp_wall_rebound(wall);
  for (int i = 0; i < asp_rebound_parameters(law); i++) {
    const asp_parameter *p = asp_rebound_parameter(law, i);
    if (strcmp(asp_parameter_keyword(p), keyword) == 0 && *asp_parameter_words(p)) {
      set_word(option, p, wall);
      return;
    }
  }
  char names[200];
  int count = parameters_of(law, keyword, names, sizeof names);
  cli_list values = cli_numbers(option, -INFINITY, INFINITY);
  if (values.count != (size_t)count)
    cli_bad_usage("--%s is '%s'; it must be %d numbers: %s", option->name, option->value, count,
                  names);
  for (int i = 0, k = 0; i < asp_rebound_parameters(law); i++) {
    const asp_parameter *p = asp_rebound_parameter(law, i);
    asp_error error;
    if (strcmp(asp_parameter_keyword(p), keyword) == 0 &&
        asp_wall_set(wall, asp_parameter_name(p), values.values[k++], &error))
      cli_bad_usage("--%s: %s", option->name, error.text);
  }
  free(values.values);
}

/* The law's keyword that an option stands for; NULL where it has none such. */
static const char *keyword_of(const cli_option *option, const asp_rebound_law *law) {
  for (int i = 0; i < asp_rebound_parameters(law); i++) {
    const char *keyword = asp_parameter_keyword(asp_rebound_parameter(law, i));
    if (is_of(option, keyword))
      return keyword;
  }
  return NULL;
}

bool cli_law_takes(const cli_option *first, int place, const asp_rebound_law *law) {
  return place == LAW_TABLE ? asp_rebound_needs_table(law)
                            : place >= LAW_KEYWORDS && keyword_of(&first[place], law) != NULL;
}

static void set_keywords(const cli_option *first, asp_wall *wall) {
  const asp_rebound_law *law = asp_wall_rebound(wall);
  for (const cli_option *o = &first[LAW_KEYWORDS]; o->name; o++) {
    const char *keyword = keyword_of(o, law);
    if (o->value && !keyword)
      cli_bad_usage("--%s is given, but --rebound is '%s', which has no such parameter", o->name,
                    asp_rebound_name(law));
    if (o->value)
      set_keyword(o, keyword, wall);
  }
}

/* --remove U_TAU,GAS_DENSITY[,MEAN_FREE_PATH[,WORK]] */
static void set_removal(const cli_option *option, asp_wall *wall) {
  static const char *const names[] = {"remove_u_tau", "remove_gas_density", "remove_mean_free_path",
                                      "remove_work"};
  if (!option->value)
    return;
  asp_error error;
  cli_list values = cli_numbers(option, 0, INFINITY);
  if (values.count < 2 || values.count > 4)
    cli_bad_usage("--%s is '%s'; it must be %s", option->name, option->value, option->argument);
  for (size_t i = 0; i < values.count; i++)
    if (asp_wall_set(wall, names[i], values.values[i], &error))
      cli_bad_usage("--%s: %s", option->name, error.text);
  free(values.values);
}

static asp_cor_table *table_of(const cli_option *first, const asp_rebound_law *law) {
  const cli_option *option = &first[LAW_TABLE];
  bool needed = asp_rebound_needs_table(law);
  if (!needed && option->value)
    cli_bad_usage("--%s is given, but --rebound is '%s'", option->name, asp_rebound_name(law));
  if (!needed)
    return NULL;
  if (!option->value)
    cli_bad_usage("--rebound table needs --table FILE (%s)", option->help);
  asp_error error;
  asp_cor_table *table = asp_cor_table_read(option->value, 1, &error);
  if (!table)
    cli_bad_file(option, &error);
  return table;
}

cli_law cli_law_read(const cli_option *first) {
  asp_error error;
  cli_law law = {.wall = asp_wall_create(&error)};
  if (!law.wall)
    cli_fail("%s", error.text);
  if (asp_wall_choose(law.wall, "rebound", first[LAW_REBOUND].value, &error))
    cli_bad_usage("--rebound: %s", error.text);
  /* A law that has its own coefficient of friction; others take the pair's. */
  if (!isnan(asp_wall_get(law.wall, "mu")))
    asp_wall_set(law.wall, "mu", cli_number(&first[LAW_MU], 0, 1e3), NULL);
  set_parameters(&first[LAW_SET], law.wall);
  set_removal(&first[LAW_REMOVE], law.wall);
  set_keywords(first, law.wall);
  asp_wall_set(law.wall, "deposit", cli_switch(&first[LAW_ADHESION]), NULL);
  asp_wall_set(law.wall, "scatter_twice", first[LAW_SCATTER_TWICE].value != NULL, NULL);
  law.table = table_of(first, asp_wall_rebound(law.wall));
  asp_wall_set_table(law.wall, law.table);
  law.own = cli_materials_of(&first[LAW_MATERIALS]);
  law.particle = material_of(&first[LAW_PARTICLE], law.own, first[LAW_PARTICLE].value);
  return law;
}

void cli_law_prepare(cli_law *law) {
  asp_error error;
  if (asp_wall_prepare(law->wall, &error))
    cli_bad_usage("%s", error.text);
}

void cli_law_free(cli_law *law) {
  asp_wall_free(law->wall);
  asp_materials_free(law->own);
  asp_cor_table_free(law->table);
}

asp_pair *cli_law_pair(const cli_option *first, const cli_law *law, const char *wall) {
  const asp_material *p = law->particle, *w = material_of(&first[LAW_WALL], law->own, wall);
  asp_error error;
  asp_pair *pair = asp_pair_create(p, w, &error);
  if (!pair)
    cli_bad_usage("%s", error.text);
  asp_pair_set(pair, "surface_energy", cli_number(&first[LAW_GAMMA], 0, 1e9), NULL);
  asp_pair_set(pair, "friction", cli_number(&first[LAW_MU], 0, 1e3), NULL);
  if (first[LAW_YIELD].value)
    asp_pair_set(pair, "yield_stress", cli_number(&first[LAW_YIELD], 0, 1e15), NULL);
  else if (asp_rebound_needs_pair(asp_wall_rebound(law->wall)) &&
           !(asp_wall_get(law->wall, "yield_rate") > 0) &&
           !(asp_pair_get(pair, "yield_stress") > 0))
    cli_bad_usage("--particle is '%s', which has no yield stress; give --yield or --yield-rate",
                  asp_material_name(p));
  return pair;
}

void cli_law_warn_double(const cli_law *law) {
  const asp_rebound_law *rebound = asp_wall_rebound(law->wall);
  if (asp_rebound_measured(rebound))
    cli_warn("rebound law '%s' was measured, and holds the roughness of the measured wall already; "
             "this rough wall counts it a second time",
             asp_rebound_name(rebound));
}
