/* Functions shared by the files of `asperity surface`: generated and measured profiles (surface.c),
 * measured maps (surface_map.c), and warnings of both (surface_check.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef ASP_CLI_SURFACE_H
#define ASP_CLI_SURFACE_H

#include "cli/description.h"
#include "readers/read.h"
#include "surface/slopes.h"

/* Warns of the reader's doubts, and of a sampling that is too coarse for the smallest size; exits
 * if the points do not resolve a particle. */
void cli_surface_check(const char *name, const char *what, const aspi_profile_report *report,
                       double spacing, double length, double lambda, const cli_list *sizes);

/* All of `asperity surface` of a map: what it is, and which slopes a sphere of each size finds. */
void cli_surface_map(const cli_call *call, const cli_description *wall,
                     const aspi_profile_options *options, const cli_list *sizes);

#endif
