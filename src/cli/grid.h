/* The measurement from which `auto` chooses; see grid.c. */
#ifndef ASP_CLI_GRID_H
#define ASP_CLI_GRID_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

/* Writes the whole grid as CSV. Minutes. */
void cli_grid(FILE *out, size_t rays, uint32_t seed);

#endif
