/* Rebound laws and materials from options; see law.h. */
#include "cli/law.h"
#include "base/number.h"
#include "cli/walls.h"

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
static void set_parameters(const cli_option *option, asp_wall_spec *spec) {
  if (!option->value)
    return;
  char *text = strdup(option->value);
  if (!text)
    cli_fail("out of memory");
  asp_error error;
  for (char *item = text, *next; item; item = next) {
    next = strchr(item, ',');
    if (next)
      *next++ = '\0';
    char *equals = strchr(item, '='), *end = NULL;
    if (equals)
      *equals = '\0';
    double value = equals ? asp_number(equals + 1, &end) : 0;
    if (!equals || end == equals + 1 || *end)
      cli_bad_usage("--%s is '%s'; NAME=VALUE,NAME=VALUE... is expected", option->name,
                    option->value);
    if (asp_wall_spec_set(spec, item, value, &error))
      cli_bad_usage("--%s: %s", option->name, error.text);
  }
  free(text);
}

static asp_cor_table *table_of(const cli_option *first, const asp_wall_spec *spec) {
  const cli_option *option = &first[LAW_TABLE];
  bool needed = asp_rebound_find(spec->rebound, NULL)->needs_table;
  if (!needed && option->value)
    cli_bad_usage("--%s is given, but --rebound is '%s'", option->name, spec->rebound);
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
  cli_law law = {.spec = asp_wall_spec_default()};
  asp_error error;
  if (asp_wall_spec_rebound(&law.spec, first[LAW_REBOUND].value, &error))
    cli_bad_usage("--rebound: %s", error.text);
  set_parameters(&first[LAW_SET], &law.spec);
  if (first[LAW_YIELD_RATE].value &&
      asp_wall_spec_set(&law.spec, "yield_rate", cli_number(&first[LAW_YIELD_RATE], 0, 1e15),
                        &error))
    cli_bad_usage("--yield-rate: %s", error.text);
  law.spec.deposit = cli_switch(&first[LAW_ADHESION]);
  law.spec.scatter_twice = first[LAW_SCATTER_TWICE].value;
  law.spec.table = law.table = table_of(first, &law.spec);
  law.own = cli_materials_of(&first[LAW_MATERIALS]);
  law.particle = material_of(&first[LAW_PARTICLE], law.own, first[LAW_PARTICLE].value);
  return law;
}

void cli_law_free(cli_law *law) {
  asp_materials_free(law->own);
  asp_cor_table_free(law->table);
}

asp_pair cli_law_pair(const cli_option *first, const cli_law *law, const char *wall) {
  const asp_material *p = law->particle, *w = material_of(&first[LAW_WALL], law->own, wall);
  const asp_rebound_law *rebound = asp_rebound_find(law->spec.rebound, NULL);
  double yield = first[LAW_YIELD].value ? cli_number(&first[LAW_YIELD], 0, 1e15) : p->yield_stress;
  asp_error error;
  asp_pair pair;
  if (asp_pair_create(p->youngs_modulus, p->poissons_ratio, w->youngs_modulus, w->poissons_ratio,
                      yield, cli_number(&first[LAW_GAMMA], 0, 1e9),
                      cli_number(&first[LAW_MU], 0, 1e3), &pair, &error))
    cli_bad_usage("%s", error.text);
  int rate = asp_rebound_parameter(rebound, "yield_rate", NULL);
  bool wanted = rate >= 0 && !(law->spec.parameters[rate] > 0) && !first[LAW_YIELD].value;
  if (wanted && !(p->yield_stress > 0))
    cli_bad_usage("--particle is '%s', which has no yield stress; give --yield or --yield-rate",
                  p->name);
  return pair;
}

void cli_law_warn_double(const cli_law *law) {
  if (asp_rebound_find(law->spec.rebound, NULL)->measured)
    cli_warn("rebound law '%s' was measured, and holds the roughness of the measured wall already; "
             "this rough wall counts it a second time",
             law->spec.rebound);
}
