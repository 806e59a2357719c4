/* Functions shared by the files of `asperity surface`: generated and measured profiles (surface.c),
 * how a file is read (surface_file.c), and measured maps (surface_map.c).
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "cli/description.h"
#include "readers/read.h"
#include "surface/heights.h"

/* A measured wall, in meters: what was done to it, and its numbers. */
typedef struct cli_measured {
  asp_heights *heights;
  aspi_profile_report report;
  asp_heights_numbers numbers;
  const char *name; /* of its file */
} cli_measured;

/* Reads and describes a file. Warns of the reader's doubts, and of a sampling that is too coarse
 * for the smallest size; exits if the points do not resolve a particle. */
cli_measured cli_surface_read(const cli_call *call, const char *file, bool is_map,
                              const cli_list *sizes);
/* Prints how a profile was read, and its numbers, as comments. */
void cli_surface_describe(FILE *out, const cli_measured *profile);

/* All of `asperity surface` of a map: its numbers, and the slopes that a sphere of each size finds
 * on it. */
void cli_surface_map(const cli_call *call, const cli_description *wall, const cli_measured *m,
                     const cli_list *sizes);
