/* Materials and pairs of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_REBOUND_MATERIALS_H
#define ASP_REBOUND_MATERIALS_H

#include "asperity.h"

/* A material. */
struct asp_material {
  const char *name;
  const char *title;
  double youngs_modulus; /* Pa */
  double poissons_ratio;
  double density;      /* kg/m^3 */
  double yield_stress; /* Pa; 0 where no value is given: it counts for the particle only */
  const char *source;
};

/* Constants of a contact between one particle material and one wall material, computed once. */
struct asp_pair {
  double modulus;        /* composite modulus E_c = 1/((1-nu_p^2)/E_p + (1-nu_w^2)/E_w) */
  double yield_stress;   /* of the particle, >= 0 */
  double surface_energy; /* gamma, energy per area, >= 0; 0 switches adhesion off */
  double friction;       /* mu, >= 0 */
  double wall_density;
};

/* The preset of that name. */
const asp_material *aspi_material_find(const char *name, asp_error *error);

#endif
