/* The measurement from which `auto` chooses; see grid.c.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_GRID_H
#define ASP_CLI_GRID_H

#include "cli/measure.h"

/* Writes the whole grid as CSV, with the subject's rays, profiles and seed; its wall does not
 * count. Half an hour. */
void cli_grid(FILE *out, const measure_case *subject);

#endif
