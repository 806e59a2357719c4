/* Walls that a test chooses part by part, by the names of models, laws and parameters.
 *
 * SPDX-License-Identifier: GPL-3.0-or-later */
#pragma once

#include "check.h"
#include "wall/wall.h"

/* A smooth wall with this law and its defaults. */
static inline aspi_wall_choice choice_of(const char *law) {
  aspi_wall_choice choice = aspi_wall_choice_smooth();
  const asp_rebound_law *found = asp_rebound_find(law, NULL);
  assert_non_null(found);
  aspi_wall_choose_law(&choice, found);
  return choice;
}

/* Sets a parameter of the law; false if it has none of that name. */
static inline bool set_parameter(aspi_wall_choice *choice, const char *name, double value) {
  int index = aspi_rebound_parameter_find(choice->law, name);
  if (index >= 0)
    choice->parameters[index] = value;
  return index >= 0;
}

static inline asp_wall *wall_of(const aspi_wall_choice *choice) {
  asp_wall *wall = aspi_wall_create(choice, NULL);
  assert_non_null(wall);
  return wall;
}
