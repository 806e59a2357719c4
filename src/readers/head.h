/* Units, steps and counts in the header of a measured file in text.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "base/table.h"

typedef enum aspi_head_key {
  ASPI_HEAD_WIDTH,
  ASPI_HEAD_HEIGHT,
  ASPI_HEAD_SPACING,
  ASPI_HEAD_Y_SPACING,
  ASPI_HEAD_UNIT,
  ASPI_HEAD_FACTOR, /* meters per unit of the heights */
  ASPI_HEAD_COUNT,
  ASPI_HEAD_ROWS
} aspi_head_key;

/* A length in m: a number and its unit, a number alone in `unit`, or a unit alone. 0: none. */
double aspi_head_length(const aspi_table *table, aspi_head_key key, double unit);

/* A number of rows; 0: none. */
size_t aspi_head_count(const aspi_table *table, aspi_head_key key);

/* Steps and the unit of heights in m of formats that say them their own way, else left as they are:
 * Wyko ASCII (heights in waves, or nm where the second number of its first line is 1; pixels in
 * mm), and Surfer's DSAA, which has the ranges of x and y, in `unit`. */
void aspi_head_known(const aspi_table *table, double unit, double step[2], double *height);
