/* The list of erosion laws, and the eroded mass of one hit.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "erosion/laws.h"
#include "base/error.h"
#include "base/units.h"

#define ADDRESS(name) &aspi_erosion_##name,
static const aspi_erosion_law *const laws[] = {ASPI_EROSION_LAWS(ADDRESS)};

int aspi_erosion_count(void) {
  return (int)(sizeof laws / sizeof *laws);
}

const aspi_erosion_law *aspi_erosion_at(int index) {
  return laws[index];
}

const aspi_erosion_law *aspi_erosion_find(const char *name, asp_error *error) {
  int index = aspi_find_name("erosion law", name, aspi_erosion_count(), laws, error);
  return index < 0 ? NULL : laws[index];
}

void aspi_erosion_take(aspi_erosion *erosion, const aspi_erosion_law *law, const asp_units *units) {
  *erosion = (aspi_erosion){.law = law,
                            .meter = aspi_quantity_factor("length", units),
                            .meter_per_second = aspi_quantity_factor("speed", units),
                            .density_unit = aspi_quantity_factor("density", units)};
  for (int i = 0; i < law->n_parameters; i++)
    erosion->given[i] =
        law->parameters[i].default_value * aspi_quantity_factor(law->parameters[i].unit, units);
}

double aspi_erosion_ratio(const aspi_erosion *erosion, double wall_density, double v, double sine,
                          double cosine, double d_p) {
  const aspi_erosion_law *law = erosion->law;
  double rate =
      law->rate(erosion->si, v / erosion->meter_per_second, sine, cosine, d_p / erosion->meter);
  double density = erosion->density > 0 ? erosion->density : wall_density;
  return law->is_volume ? rate * density / erosion->density_unit : rate;
}
