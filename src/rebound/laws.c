/* The list of rebound laws, and how their parameters are found by name.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "asperity_internal.h"
#include "base/error.h"
#include "rebound/laws.h"

#include <string.h>

#define ASP_REBOUND_ADDRESS(name) &aspi_rebound_##name,
static const asp_rebound_law *const laws[] = {ASP_REBOUND_LAWS(ASP_REBOUND_ADDRESS)};
#undef ASP_REBOUND_ADDRESS

int asp_rebound_count(void) {
  return (int)(sizeof laws / sizeof *laws);
}

const asp_rebound_law *asp_rebound_at(int index) {
  return index >= 0 && index < asp_rebound_count() ? laws[index] : NULL;
}

const asp_rebound_law *asp_rebound_find(const char *name, asp_error *error) {
  int index = aspi_find_name("rebound law", name, asp_rebound_count(), laws, error);
  return index < 0 ? NULL : laws[index];
}

const char *asp_rebound_name(const asp_rebound_law *law) {
  return law->name;
}

bool asp_rebound_needs_pair(const asp_rebound_law *law) {
  return law->needs_pair;
}

int aspi_rebound_parameter_find(const asp_rebound_law *law, const char *name) {
  for (int i = 0; i < law->n_parameters; i++)
    if (strcmp(law->parameters[i].name, name) == 0)
      return i;
  return -1;
}

asp_code aspi_rebound_check_bodies(const asp_rebound_law *law, const double *parameters,
                                   asp_error *error) {
  if (!law->is_compliant || !law->is_compliant(parameters))
    return ASP_OK;
  return aspi_fail(error, ASP_EARG,
                   "rebound law '%s' acts on bodies and eccentric grains with BETA0 0 and without "
                   "'compliance' only: their contact is rigid along the face",
                   law->name);
}
