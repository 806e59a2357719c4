/* Impacts near a place (angle, speed, size): a k-d tree, so that two files of n impacts each are
 * compared in a time of n log n.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "analysis/impacts.h"

/* Tolerances for matching model impacts to a measurement: degrees, relative speed, relative size.
 */
typedef struct aspi_compare_reach {
  double degrees, speed, size;
} aspi_compare_reach;

/* A row of impacts, and the weight of each of them. */
typedef struct aspi_weighted {
  const aspi_scatter_row *row;
  double weight;
} aspi_weighted;

typedef struct aspi_near aspi_near;

/* An index of rows, which must outlive it; `far` is a typical reach. NULL: out of memory. */
aspi_near *aspi_near_create(const aspi_scatter *impacts, const aspi_compare_reach *far);
void aspi_near_free(aspi_near *near);

/* Finds the impacts within reach of a place; an unknown speed or size is near any. Returns how many
 * there are. */
double aspi_near_find(aspi_near *near, const aspi_scatter_row *at, const aspi_compare_reach *reach);

/* Adds to the weight of each row that was found last. */
void aspi_near_weigh(aspi_near *near, double each);

/* Takes the rows that have a weight into `taken`, which has a place for each row, and sets all
 * weights to 0; returns how many. */
size_t aspi_near_take(aspi_near *near, aspi_weighted *taken);
