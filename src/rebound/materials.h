/* Materials and pairs of them.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "asperity_internal.h"

/* A material. */
struct asp_material {
  const char *name;
  const char *title;
  double youngs_modulus; /* Pa */
  double poissons_ratio;
  double density;      /* kg/m^3 */
  double yield_stress; /* Pa; 0: unknown; used for the particle only */
  const char *source;
};

/* Constants of a contact between one particle material and one wall material, computed once. */
struct asp_pair {
  double modulus;        /* composite modulus E_c = 1/((1-nu_p^2)/E_p + (1-nu_w^2)/E_w) */
  double yield_stress;   /* of the particle, >= 0 */
  double surface_energy; /* gamma, energy per area, >= 0; 0 switches adhesion off */
  double friction;       /* mu, >= 0 */
  double wall_density;
  double yield_excess; /* one grain's yield stress over the material's, minus 1 */
  double give;         /* E/E_c of two equal Young's moduli E: (1-nu_p^2) + (1-nu_w^2) */
};

/* Materials from a text file in columns, a row a material, as `asperity materials` prints them:
 * under a line of column names name, youngs_modulus_pa, poissons_ratio, density_kg_m3, and where
 * wanted yield_stress_pa (empty: none); other columns are left out. Columns are separated by
 * commas, semicolons, tabs or blanks; # begins a comment. The message names file and line. */
typedef struct aspi_materials aspi_materials;
aspi_materials *aspi_materials_read(const char *path, asp_error *error);
void aspi_materials_free(aspi_materials *materials);

/* Finds a material by name, in upper or lower case: first among your own (NULL: none), then among
 * the presets. NULL and a message if there is none, or if your own file has the name twice. */
const asp_material *aspi_materials_find(const aspi_materials *own, const char *name,
                                        asp_error *error);
