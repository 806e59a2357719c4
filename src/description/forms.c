/* Keywords whose value is more than a number, a word or a file.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#include "description/words.h"

/* clang-format off */
static const aspi_form forms[] = {
    /* name        read                write                finish               parameter */
    {"surface",    NULL,               NULL,                aspi_surface_finish, NULL},
    {"lambda_c",   aspi_lambda_c_read, aspi_lambda_c_write, NULL,                NULL},
    {"lay",        aspi_lay_read,      aspi_lay_write,      NULL,                NULL},
    {"rdq",        aspi_slope_read,    NULL,                NULL,                NULL},
    {"sdq",        aspi_slope_read,    NULL,                NULL,                NULL},
    {"spread",     aspi_spread_read,   aspi_spread_write,   aspi_spread_finish,  NULL},
    {"rebound",    aspi_law_read,      aspi_law_write,      NULL,                aspi_law_parameter},
    {"erosion",    aspi_law_read,      aspi_law_write,      aspi_erosion_finish, aspi_law_parameter},
    {"viscosity",  NULL,               aspi_curve_write,    NULL,                aspi_curve_take},
    {"soften_modulus", NULL,           aspi_curve_write,    NULL,                aspi_curve_take},
    {"materials",  aspi_names_read,    aspi_names_write,    aspi_names_finish,   NULL},
};
/* clang-format on */

const aspi_form *aspi_form_of(const aspi_keyword *keyword) {
  static const aspi_form plain = {.name = ""};
  for (size_t i = 0; i < sizeof forms / sizeof *forms; i++)
    if (strcmp(forms[i].name, keyword->name) == 0)
      return &forms[i];
  return &plain;
}
